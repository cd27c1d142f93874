#include "renderer/passes/background_pass.h"

#include <algorithm>
#include <cmath>

namespace glint {

bool BackgroundPass::isBlack(const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  if (frame.isFurnace()) return false;
  if (settings.view != "lit" || settings.background == Background::None) return true;
  if (settings.background == Background::Color) return settings.backgroundColor == glm::vec3(0);
  return std::none_of(frame.views.begin(), frame.views.end(), [](const ReadyView& r) { return r.view.scene->environment != nullptr; });
}

BackgroundPass::Backdrop BackgroundPass::backdrop(const Frame& frame, const ReadyView& r) {
  const RenderSettings& settings = frame.settings;
  const EnvironmentPtr& environment = r.view.scene->environment;
  const bool sky = settings.view == "lit" && environment &&
                   (settings.background == Background::Environment || settings.background == Background::Blur);
  Backdrop backdrop;
  if (frame.isFurnace()) backdrop.color = glm::vec4(glm::vec3(frame.furnaceGround), 1);
  else if (settings.view == "lit" && settings.background == Background::Color) backdrop.color = glm::vec4(settings.backgroundColor, 1);
  if (sky) {
    const EnvironmentMaps& maps = lighting_.maps(environment);
    backdrop.color.a = 0;
    if (settings.background == Background::Blur) backdrop.level = std::max(0.0f, std::log2(static_cast<float>(maps.size)) - 4.0f);
    backdrop.cube = maps.cube.id();
  } else {
    backdrop.cube = lighting_.uniformCube(0);
  }
  return backdrop;
}

void BackgroundPass::Backdrop::bind(const gl::Program& program) const {
  glBindTextureUnit(17, cube);
  program.set4("background", &color.x);
  program.set("backgroundLevel", level);
}

void BackgroundPass::draw(const Frame& frame) {
  for (const ReadyView& r : frame.views) {
    const Backdrop behind = backdrop(frame, r);
    frame.beginRectangles();
    fill(frame, r, -1, behind);
  }
}

void BackgroundPass::drawBroken(const Frame& frame, const ReadyView& view, int group) {
  const Backdrop magenta{{1, 0, 0.5f, 1}, 0, lighting_.uniformCube(0)};
  frame.beginRectangles();
  fill(frame, view, group, magenta);
}

void BackgroundPass::fill(const Frame& frame, const ReadyView& view, int group, const Backdrop& backdrop) {
  const gl::Program& program = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/background.frag", frame.outputDefines(), {}});
  backdrop.bind(program);
  frame.uploads.bind(GL_UNIFORM_BUFFER, 0, view.viewBlock, sizeof(ViewBlock));
  frame.drawRectangle(program, view, group);
}

}  // namespace glint
