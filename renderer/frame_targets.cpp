#include "renderer/frame_targets.h"

namespace glint {
namespace {

// Attachments that a frame does not have still need a name in the framebuffer's list.
gl::Framebuffer gbufferOf(const std::vector<GLuint>& textures, GLuint depth) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  std::vector<GLenum> buffers;
  GLenum attachment = GL_COLOR_ATTACHMENT0;
  for (GLuint texture : textures) {
    if (texture) glNamedFramebufferTexture(id, attachment, texture, 0);
    buffers.push_back(texture ? attachment : GL_NONE);
    ++attachment;
  }
  glNamedFramebufferTexture(id, GL_DEPTH_STENCIL_ATTACHMENT, depth, 0);
  glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
  return gl::Framebuffer(id);
}

gl::Texture nearestTexture(GLenum format, int width, int height) {
  gl::Texture texture = gl::createTexture2D(format, width, height);
  glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

}  // namespace

void FrameTargets::resize(int width, int height, OptionalAttachments optional) {
  if (width == width_ && height == height_ && optional == optional_) return;
  if (width != width_ || height != height_) {
    baseColor_ = nearestTexture(GL_RGBA16F, width, height);
    normal_ = nearestTexture(GL_RGBA16_SNORM, width, height);
    material_ = nearestTexture(GL_RGBA16, width, height);
    depth_ = nearestTexture(GL_DEPTH24_STENCIL8, width, height);
    emissiveTexture_ = {};
    parametersTexture_ = {};
    tangentTexture_ = {};
    accumulations_ = {};
    ++sizes_;
  }
  width_ = width;
  height_ = height;
  optional_ = optional;
  const auto make = [&](bool wanted, gl::Texture& texture, GLenum format) {
    if (wanted && !texture) texture = nearestTexture(format, width, height);
    return wanted ? texture.id() : 0;
  };
  std::vector<GLuint> textures = {baseColor_.id(), normal_.id(), material_.id(),
                                  make(optional.emissive, emissiveTexture_, GL_R11F_G11F_B10F),
                                  make(optional.parameters, parametersTexture_, GL_RGBA16F),
                                  make(optional.tangent, tangentTexture_, GL_R16_SNORM)};
  while (textures.back() == 0) textures.pop_back();
  gbuffer_ = gbufferOf(textures, depth_.id());
}

void FrameTargets::bindGbuffer() const {
  const GLuint textures[] = {baseColor_.id(), normal_.id(), material_.id(), optional_.emissive ? emissiveTexture_.id() : 0,
                             optional_.parameters ? parametersTexture_.id() : 0, depth_.id()};
  glBindTextures(0, 6, textures);
  if (optional_.tangent) glBindTextureUnit(9, tangentTexture_.id());
  glBindSamplers(0, 16, nullptr);
}

FrameTargets::Picture& FrameTargets::nextPicture() {
  picture_ = 1 - picture_;
  Picture& picture = pictures_[picture_];
  if (picture.made != sizes_) {
    picture.made = sizes_;
    picture.texture = nearestTexture(GL_SRGB8_ALPHA8, width_, height_);
    GLuint view = 0;
    glGenTextures(1, &view);
    glTextureView(view, GL_TEXTURE_2D, picture.texture.id(), GL_RGBA8, 0, 1, 0, 1);
    picture.raw = gl::Texture(view);
    glTextureParameteri(view, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(view, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(view, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(view, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    const GLuint color = picture.texture.id();
    picture.framebuffer = gl::createFramebuffer(std::span(&color, 1), depth_.id());
  }
  return picture;
}

const FrameTargets::Visibility& FrameTargets::visibility(int layers) {
  Visibility& v = visibility_;
  if (visibilitySizes_ == sizes_ && static_cast<int>(v.layers.size()) >= layers) return v;
  visibilitySizes_ = sizes_;
  ++v.made;
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
  v.texture = gl::Texture(id);
  glTextureStorage3D(id, 1, GL_R16, width_, height_, layers);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  v.layers.clear();
  for (int layer = 0; layer < layers; ++layer) {
    GLuint framebuffer = 0;
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTextureLayer(framebuffer, GL_COLOR_ATTACHMENT0, id, 0, layer);
    glNamedFramebufferTexture(framebuffer, GL_DEPTH_STENCIL_ATTACHMENT, depth_.id(), 0);
    v.layers.emplace_back(framebuffer);
  }
  return v;
}

GLuint FrameTargets::accumulation(size_t which) {
  Accumulation& wanted = accumulations_[which];
  if (!wanted.framebuffer) {
    wanted.texture = nearestTexture(GL_RGBA32F, width_, height_);
    const GLuint color = wanted.texture.id();
    wanted.framebuffer = gl::createFramebuffer(std::span(&color, 1), depth_.id());
  }
  return wanted.framebuffer.id();
}

}  // namespace glint
