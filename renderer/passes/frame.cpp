#include "renderer/passes/frame.h"

#include <algorithm>

namespace glint {

std::vector<std::string> Frame::outputDefines() const {
  return output == Output::Radiance ? std::vector<std::string>{"SCENE_REFERRED"} : displayDefines();
}

std::vector<std::string> Frame::displayDefines() const { return {fmt::format("TONEMAP {}", static_cast<int>(settings.tonemap))}; }

void Frame::beginRectangles() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, targets.width(), targets.height());
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glStencilMask(0);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  if (output == Output::Picture) {
    glDisable(GL_BLEND);
    glEnable(GL_FRAMEBUFFER_SRGB);
  } else {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDisable(GL_FRAMEBUFFER_SRGB);
  }
}

void Frame::beginSurfaces(GLuint into) const {
  beginRectangles();
  glBindFramebuffer(GL_FRAMEBUFFER, into);
  glDisable(GL_BLEND);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glStencilFunc(GL_NOTEQUAL, 0, 0xff);
}

void Frame::drawSurfaces(const gl::Program& program, const ReadyView& view) const {
  const glm::ivec4 r = view.view.rectangle;
  rectangles.draw(program, size(), Tile{r.x, r.y, r.x + r.z, r.y + r.w, 0, 0, 0, 0});
}

void Frame::setScreen(const gl::Program& program, const ReadyView& view) const {
  const glm::ivec4 r = view.view.rectangle;
  const GLint corners[4] = {r.x, r.y, r.x + r.z, r.y + r.w};
  glProgramUniform4iv(program.id(), program.location("viewRectangle"), 1, corners);
  program.set("sampleNumber", static_cast<float>(sample));
}

void Frame::drawGroup(const gl::Program& program, const ReadyView& view, int group) const {
  const LightGroup& g = view.groups[static_cast<size_t>(group)];
  glStencilFunc(GL_EQUAL, group + 1, 0xff);
  rectangles.draw(program, size(), uploads.id(), g.tiles, g.tileCount);
}

void Frame::drawRectangle(const gl::Program& program, const ReadyView& view, int group) const {
  glStencilFunc(GL_EQUAL, group + 1, 0xff);
  drawSurfaces(program, view);
}

void Frame::report(const Diagnostic& problem) {
  if (std::find(problems.begin(), problems.end(), problem) == problems.end()) problems.push_back(problem);
}

}  // namespace glint
