#include "renderer/rectangles.h"

namespace glint {

Rectangles::Rectangles() : array_(gl::createVertexArray()) {
  const Tile none{};
  one_ = gl::createBuffer(std::as_bytes(std::span(&none, 1)));
  for (GLuint i = 0; i < 2; ++i) {
    glEnableVertexArrayAttrib(array_.id(), i);
    glVertexArrayAttribIFormat(array_.id(), i, 4, GL_INT, i == 0 ? 0 : 16);
    glVertexArrayAttribBinding(array_.id(), i, 0);
  }
  glVertexArrayBindingDivisor(array_.id(), 0, 1);
}

void Rectangles::draw(const gl::Program& program, glm::ivec2 targetSize, GLuint buffer, size_t offset, size_t count) const {
  program.set2("targetSize", static_cast<float>(targetSize.x), static_cast<float>(targetSize.y));
  program.use();
  glBindVertexArray(array_.id());
  glVertexArrayVertexBuffer(array_.id(), 0, buffer, static_cast<GLintptr>(offset), sizeof(Tile));
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

void Rectangles::draw(const gl::Program& program, glm::ivec2 targetSize, const Tile& tile) const {
  glNamedBufferSubData(one_.id(), 0, sizeof tile, &tile);
  draw(program, targetSize, one_.id(), 0, 1);
}

void Rectangles::drawWhole(const gl::Program& program, GLuint framebuffer, glm::ivec2 size) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size.x, size.y);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_FRAMEBUFFER_SRGB);
  draw(program, size, Tile{0, 0, size.x, size.y, 0, 0, 0, 0});
}

}  // namespace glint
