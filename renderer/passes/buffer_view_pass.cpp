#include "renderer/passes/buffer_view_pass.h"

#include <array>
#include <cmath>

namespace glint {
namespace {

float linearOf(float srgb) { return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f); }

}  // namespace

void BufferViewPass::draw(const Frame& frame, LightLists& lists) {
  frame.beginRectangles();
  std::vector<std::string> defines = frame.outputDefines();
  if (frame.optional.emissive) defines.push_back("EMISSIVE");
  if (frame.optional.parameters) defines.push_back("READS_PARAMETERS");
  const gl::Program& program = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/buffer_view.frag", defines, {}});
  for (const ReadyView& r : frame.views) {
    std::array<glm::vec4, 256> colors{};
    for (size_t g = 0; g < r.groups.size(); ++g) {
      const auto& c = r.groups[g].setting.shader->model->color;
      colors[g] = glm::vec4(linearOf(c[0]), linearOf(c[1]), linearOf(c[2]), 1);
    }
    program.set4("groupColors", &colors[0].x, 256);
    program.set("mode", bufferViewIndex(frame.settings.view));
    for (size_t g = 0; g < r.groups.size(); ++g) {
      lists.bind(frame, r, r.groups[g]);
      frame.drawGroup(program, r, static_cast<int>(g));
    }
  }
}

}  // namespace glint
