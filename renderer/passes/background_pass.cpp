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

void BackgroundPass::draw(const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  for (const ReadyView& r : frame.views) {
    const EnvironmentPtr& environment = r.view.scene->environment;
    const bool sky = settings.view == "lit" && environment &&
                     (settings.background == Background::Environment || settings.background == Background::Blur);
    glm::vec4 color(0, 0, 0, 1);
    if (frame.isFurnace()) color = glm::vec4(glm::vec3(frame.furnaceGround), 1);
    else if (settings.view == "lit" && settings.background == Background::Color) color = glm::vec4(settings.backgroundColor, 1);
    float level = 0;
    if (sky) {
      // Building maps changes the state.
      const EnvironmentMaps& maps = lighting_.maps(environment);
      color.a = 0;
      if (settings.background == Background::Blur) level = std::max(0.0f, std::log2(static_cast<float>(maps.size)) - 4.0f);
      glBindTextureUnit(6, maps.cube.id());
    }
    frame.beginRectangles();
    fill(frame, r, -1, color, level);
  }
}

void BackgroundPass::drawBroken(const Frame& frame, const ReadyView& view, int group) {
  frame.beginRectangles();
  fill(frame, view, group, {1, 0, 0.5f, 1});
}

void BackgroundPass::fill(const Frame& frame, const ReadyView& view, int group, glm::vec4 color, float level) {
  const gl::Program& program = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/background.frag", frame.outputDefines(), {}});
  if (color.a > 0) glBindTextureUnit(6, lighting_.uniformCube(0));
  program.set4("background", &color.x);
  program.set("level", level);
  frame.uploads.bind(GL_UNIFORM_BUFFER, 0, view.viewBlock, sizeof(ViewBlock));
  frame.drawRectangle(program, view, group);
}

}  // namespace glint
