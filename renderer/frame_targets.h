// The textures that a frame is drawn into.
#pragma once

#include <array>
#include <vector>

#include "renderer/gl/objects.h"

namespace glint {

// Attachments that only some frames need.
struct OptionalAttachments {
  bool emissive = false, parameters = false, tangent = false;
  bool operator==(const OptionalAttachments&) const = default;
};

// The G-buffer (shaders/common/gbuffer.glsl has the table) and what light is gathered in. Textures grow with the
// picture and are kept.
class FrameTargets {
 public:
  // Makes everything fit a picture of this size with these attachments.
  void resize(int width, int height, OptionalAttachments);

  GLuint gbuffer() const { return gbuffer_.id(); }
  void bindGbuffer() const;      // as textures, at the units of shaders/common/gbuffer_read.glsl

  // Pictures, shown in turn: SRGB8_ALPHA8 with the frame's depth and stencil attached. `raw` is the same texels as
  // RGBA8, for whoever shows the texture without decoding it. One lasts until the second next call, also when the
  // size changes in between.
  struct Picture {
    gl::Texture texture, raw;
    gl::Framebuffer framebuffer;
    unsigned made = 0;           // sizes_ when it was
  };
  Picture& nextPicture();

  // R16, an array: for each pixel how open it is to its surroundings (layer 0), and how much arrives of each light with a
  // shadow, by its number. Unset where they are anew, which `made` counts.
  struct Visibility {
    gl::Texture texture;
    std::vector<gl::Framebuffer> layers;   // with the frame's depth and stencil
    unsigned made = 0;
  };
  const Visibility& visibility(int layers);

  // RGBA32F, for averages and scene-referred pictures; made when first asked for. There are three, as an error has two
  // averages of its reference.
  static constexpr size_t kAccumulations = 3;
  GLuint accumulation(size_t which = 0);
  GLuint accumulationTexture(size_t which = 0) const { return accumulations_[which].texture.id(); }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_ = 0, height_ = 0;
  OptionalAttachments optional_;
  gl::Texture baseColor_, normal_, material_, emissiveTexture_, parametersTexture_, tangentTexture_, depth_;
  gl::Framebuffer gbuffer_;
  struct Accumulation {
    gl::Texture texture;
    gl::Framebuffer framebuffer;
  };
  std::array<Accumulation, kAccumulations> accumulations_;
  std::array<Picture, 2> pictures_;
  Visibility visibility_;
  unsigned visibilitySizes_ = 0;   // sizes_ when it was made
  size_t picture_ = 0;
  unsigned sizes_ = 0;           // how often the size changed
};

}  // namespace glint
