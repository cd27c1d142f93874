#include "renderer/passes/reference_pass.h"

#include <algorithm>

namespace glint {
namespace {

// Samples of all pixels of a draw together, and of one pixel: a few tenths of a second where the processor draws.
constexpr int64_t kSamplesAtOnce = 1 << 20;
constexpr int kMostAtOnce = 256;

}  // namespace

void ReferencePass::draw(Frame& frame, LightLists& lists, int first, int count) {
  done_ = all_ = 0;
  for (const ReadyView& r : frame.views) all_ += static_cast<double>(std::count_if(r.groups.begin(), r.groups.end(), [](const LightGroup& g) { return g.tileCount > 0; }));
  for (const ReadyView& r : frame.views)
    for (size_t g = 0; g < r.groups.size(); ++g) {
      if (r.groups[g].tileCount == 0) continue;
      const Diagnostics faults = r.groups[g].broken ? Diagnostics{} : drawGroup(frame, lists, r, g, first, count);
      for (const Diagnostic& fault : faults) frame.report(fault);
      if (r.groups[g].broken || !faults.empty()) background_.drawBroken(frame, r, static_cast<int>(g));
      ++done_;
    }
}

Diagnostics ReferencePass::drawGroup(Frame& frame, LightLists& lists, const ReadyView& r, size_t index, int first, int count) {
  const LightGroup& group = r.groups[index];
  const ShadingModel& model = *group.setting.shader->model;
  const bool furnace = frame.isFurnace();
  const EnvironmentPtr& environment = r.view.scene->environment;
  std::vector<std::string> defines = frame.outputDefines();
  if (!furnace && !r.view.points.empty()) defines.push_back("POINT_LIGHTS");
  if (!furnace && !r.view.placed.empty()) defines.push_back("PLACED_LIGHTS");
  if (!furnace && frame.optional.emissive) defines.push_back("EMISSIVE");
  if (furnace) defines.push_back("FURNACE");
  else if (environment) defines.push_back("ENVIRONMENT");
  if (environment && !furnace && frame.settings.splitSum) defines.push_back("SPLIT_SUM");
  if (frame.optional.parameters) defines.push_back("READS_PARAMETERS");
  if (group.compensate) defines.push_back("COMPENSATE");
  const auto found = programs_.get(Rectangles::vertexShader(), {"shaders/passes/reference.frag", defines, {{"model", group.setting.shader->glsl}}});
  if (!found) return modelErrors(model, found.diagnostics()[0].what);
  const gl::Program& program = **found;
  const Diagnostics faults = lighting_.tables().apply(group.setting, program);
  GLINT_CHECK(faults.empty(), "a sound shader has tables");
  const auto widths = lighting_.widths(group.setting);
  if (!widths) return modelErrors(model, widths.diagnostics()[0].what);
  (*widths)->apply(program);
  const EnvironmentSampler* sampler = nullptr;
  if (furnace) program.set("environmentScale", 1.0f);
  if (environment && !furnace) {
    // The view's intensity is that of the maps.
    program.set("environmentScale", lighting_.maps(environment).scale);
    sampler = environments_.find(environment->hash);
    if (!sampler) sampler = &environments_.put(environment->hash, EnvironmentSampler(environment->pixels));
  }
  // Building tables changed the state.
  frame.beginRectangles();
  lists.bind(frame, r, group);
  if (sampler) sampler->bind();

  // Where a sample of every pixel would be too much, the rows are drawn in bands.
  const glm::ivec4 area = r.view.rectangle;
  const int64_t each = static_cast<int64_t>(1 + r.view.placed.size()) * area.z;
  const int rows = static_cast<int>(std::clamp<int64_t>(kSamplesAtOnce / each, 1, area.w));
  const int atOnce = static_cast<int>(std::clamp<int64_t>(kSamplesAtOnce / (each * rows), 1, kMostAtOnce));
  const bool sampled = environment || furnace || !r.view.placed.empty();
  glEnable(GL_SCISSOR_TEST);
  for (int sample = 0; sample < count;) {
    // All the same to lights without a surface.
    const int samples = sampled ? std::min(atOnce, count - sample) : count;
    program.set("firstSample", first + sample);
    program.set("sampleCount", samples);
    program.set("share", static_cast<float>(samples) / static_cast<float>(count));
    sample += samples;
    for (int y = 0; y < area.w; y += rows) {
      glScissor(area.x, area.y + y, area.z, std::min(rows, area.w - y));
      frame.drawGroup(program, r, static_cast<int>(index));
      glFinish();
      if (progress_) progress_("reference of " + model.title, std::min(1.0, (done_ + (sample - samples * (1 - double(y + rows) / area.w)) / count) / all_));
    }
  }
  glDisable(GL_SCISSOR_TEST);
  return {};
}

}  // namespace glint
