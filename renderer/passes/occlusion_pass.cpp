#include "renderer/passes/occlusion_pass.h"

#include <algorithm>

namespace glint {

void OcclusionPass::draw(Frame& frame, const FrameTargets::Visibility& visibility) {
  const glm::ivec2 size = (frame.size() + 1) / 2;
  if (size != size_) {
    size_ = size;
    for (Half* half : {&noisy_, &smooth_}) {
      half->texture = gl::createTexture2D(GL_RG32F, size.x, size.y);
      glTextureParameteri(half->texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTextureParameteri(half->texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      const GLuint color = half->texture.id();
      half->framebuffer = gl::createFramebuffer(std::span(&color, 1));
    }
  }
  const gl::Program& seek = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/occlusion.frag", {}, {}});
  const gl::Program& smooth = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/occlusion_filter.frag", {}, {}});
  const gl::Program& spread = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/occlusion_filter.frag", {"WHOLE"}, {}});
  // Over the samples of a picture each pixel of four has its turn.
  const GLint offset[2] = {frame.sample & 1, (frame.sample >> 1 ^ frame.sample) & 1};
  const auto begin = [&](const gl::Program& program, const ReadyView& r) {
    frame.setScreen(program, r);
    const float given = frame.settings.occlusionRadius, radius = given > 0 ? given : 0.5f * r.casters.radius();
    program.set("radius", std::max(radius, 1e-6f));
    glProgramUniform2iv(program.id(), program.location("halfOffset"), 1, offset);
  };
  for (const ReadyView& r : frame.views) {
    frame.uploads.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
    const glm::ivec4 v = r.view.rectangle;
    const Tile half{v.x / 2, v.y / 2, (v.x + v.z + 1) / 2, (v.y + v.w + 1) / 2, 0, 0, 0, 0};
    for (const auto& [program, into, from] : {std::tuple{&seek, &noisy_, GLuint{0}}, {&smooth, &smooth_, noisy_.texture.id()}}) {
      frame.beginSurfaces(into->framebuffer.id());
      glDisable(GL_STENCIL_TEST);   // which these have none of
      glViewport(0, 0, size.x, size.y);
      frame.targets.bindGbuffer();
      if (from) glBindTextureUnit(16, from);
      begin(*program, r);
      frame.rectangles.draw(*program, size, half);
    }
    frame.beginSurfaces(visibility.layers[0].id());
    frame.targets.bindGbuffer();
    glBindTextureUnit(16, smooth_.texture.id());
    begin(spread, r);
    frame.drawSurfaces(spread, r);
  }
}

}  // namespace glint
