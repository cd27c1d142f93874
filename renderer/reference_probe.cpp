#include "renderer/reference_probe.h"

#include <cmath>

#include "materials/model_mix.h"
#include "renderer/prepared_view.h"

namespace glint {
namespace {

// More than one tile of software renderers, so that every core has a part.
constexpr int kAcross = 128, kDown = 64;

std::vector<float> drawn(const Rectangles& rectangles, const gl::Program& program, int width, int height) {
  const gl::Texture target = gl::createTexture2D(GL_RGBA32F, width, height);
  const GLuint color = target.id();
  const gl::Framebuffer framebuffer = gl::createFramebuffer(std::span(&color, 1));
  program.set("pixelsAcross", width);
  rectangles.drawWhole(program, framebuffer.id(), {width, height});
  std::vector<float> values(static_cast<size_t>(width * height) * 4);
  glGetTextureImage(color, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(values.size() * 4), values.data());
  return values;
}

}  // namespace

Result<const gl::Program*> ReferenceProbe::program(const ModelSetting& setting, const char* what, const Point& point) {
  const ShadingModel& model = *setting.shader->model;
  std::vector<std::string> defines = {what};
  if (model.compensate) defines.push_back("COMPENSATE");
  // Tables of pictures are of their alpha.
  else if (!model.smithOfOwnD) defines.push_back("OWN_ALPHA");
  const auto found = programs_.get(Rectangles::vertexShader(), {"shaders/passes/reference_probe.frag", defines, {{"model", setting.shader->glsl}}});
  if (!found) return modelErrors(model, found.diagnostics()[0].what);
  const gl::Program& program = **found;
  const auto widths = lighting_.widths(setting);
  if (!widths) return widths.diagnostics();
  (*widths)->apply(program);
  if (Diagnostics faults = lighting_.tables().apply(setting, program); !faults.empty()) return faults;
  const glm::vec3 normal(point.normal), view(point.view);
  program.set3("normal", &normal.x);
  program.set3("viewer", &view.x);
  program.set3("reflectance", &point.F0.x);
  program.set("roughness", static_cast<float>(point.roughness));
  return &program;
}

void ReferenceProbe::setLight(const gl::Program& program, const Light& light) {
  const PlacedBlock block = placedBlock(light);
  static_assert(sizeof block == kPlacedTexels * 16);
  program.set("lightKind", static_cast<int>(light.kind));
  program.set4("placed", &block.position.x, kPlacedTexels);
}

Result<glm::dvec3> ReferenceProbe::mean(const gl::Program& program, int samples) {
  program.set("sampleCount", samples / (kAcross * kDown));
  const std::vector<float> values = drawn(rectangles_, program, kAcross, kDown);
  glm::dvec3 sum(0);
  for (size_t i = 0; i < values.size(); i += 4) {
    if (!(values[i + 3] > 0.5f)) return error("the reference", "a value of the model is not finite", "");
    sum += glm::dvec3(values[i], values[i + 1], values[i + 2]);
  }
  return sum / double(kAcross * kDown);
}

Result<glm::dvec3> ReferenceProbe::light(const ModelSetting& setting, const Light& light, const Point& point) {
  const auto made = program(setting, "PLACED_LIGHTS", point);
  if (!made) return made.diagnostics();
  setLight(**made, light);
  return mean(**made, kLightSamples);
}

Result<double> ReferenceProbe::irradiance(const Light& light, const Point& point) {
  const auto model = mixModel("GGX*Implicit*None");
  GLINT_CHECK(model.ok(), "shipped terms");
  Point wide = point;
  wide.roughness = 1;
  const auto made = program(modelSetting(*model), "IRRADIANCE", wide);
  if (!made) return made.diagnostics();
  setLight(**made, light);
  const auto value = mean(**made, kLightSamples);
  if (!value) return value.diagnostics();
  return value->x;
}

Result<glm::dvec3> ReferenceProbe::environment(const ModelSetting& setting, const EnvironmentSampler* sampler, const Point& point) {
  const auto made = program(setting, sampler ? "ENVIRONMENT" : "FURNACE", point);
  if (!made) return made.diagnostics();
  if (sampler) sampler->bind();
  return mean(**made, kEnvironmentSamples);
}

Result<std::array<glm::dvec3, ReferenceProbe::kApproximations>> ReferenceProbe::approximations(const ModelSetting& setting, const Light& light,
                                                                                               const Point& point) {
  const auto made = program(setting, "APPROXIMATIONS", point);
  if (!made) return made.diagnostics();
  setLight(**made, light);
  const std::vector<float> values = drawn(rectangles_, **made, kApproximations, 1);
  std::array<glm::dvec3, kApproximations> all;
  for (size_t i = 0; i < all.size(); ++i) all[i] = glm::dvec3(values[4 * i], values[4 * i + 1], values[4 * i + 2]);
  return all;
}

}  // namespace glint
