// Draws rectangles of pixels: all of a target, a view of it, or the tiles of a light list.
#pragma once

#include <glm/glm.hpp>

#include "renderer/gl/objects.h"
#include "renderer/light_tiles.h"
#include "renderer/shader_assembler.h"

namespace glint {

class Rectangles {
 public:
  Rectangles();

  // The vertex shader of programs drawn so.
  static ShaderText vertexShader() { return {"shaders/passes/tiles.vert", {}, {}}; }

  // Into the bound framebuffer of `targetSize` pixels, in the state that stands: `count` tiles that lie in `buffer` from
  // byte `offset` on, or one tile.
  void draw(const gl::Program&, glm::ivec2 targetSize, GLuint buffer, size_t offset, size_t count) const;
  void draw(const gl::Program&, glm::ivec2 targetSize, const Tile&) const;
  // Every pixel of a framebuffer, without depth, stencil, blending and sRGB.
  void drawWhole(const gl::Program&, GLuint framebuffer, glm::ivec2 size) const;

 private:
  gl::VertexArray array_;
  gl::Buffer one_;
};

}  // namespace glint
