#include "renderer/frame_targets.h"

namespace glint {
namespace {

// Attachments that a frame does not have still need a name in the framebuffer's list.
gl::Framebuffer gbufferOf(std::initializer_list<GLuint> textures, GLuint depth) {
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

void FrameTargets::resize(int width, int height, bool emissive, bool parameters) {
  if (width == width_ && height == height_ && emissive == emissive_ && parameters == parameters_) return;
  if (width != width_ || height != height_) {
    baseColor_ = nearestTexture(GL_RGBA16F, width, height);
    normal_ = nearestTexture(GL_RGBA16_SNORM, width, height);
    material_ = nearestTexture(GL_RGBA16, width, height);
    depth_ = nearestTexture(GL_DEPTH24_STENCIL8, width, height);
    emissiveTexture_ = {};
    parametersTexture_ = {};
    accumulation_ = {};
    accumulationTexture_ = {};
    ++sizes_;
  }
  width_ = width;
  height_ = height;
  emissive_ = emissive;
  parameters_ = parameters;
  if (emissive && !emissiveTexture_) emissiveTexture_ = nearestTexture(GL_R11F_G11F_B10F, width, height);
  if (parameters && !parametersTexture_) parametersTexture_ = nearestTexture(GL_RGBA16F, width, height);
  if (parameters)
    gbuffer_ = gbufferOf({baseColor_.id(), normal_.id(), material_.id(), emissive ? emissiveTexture_.id() : 0,
                          parametersTexture_.id()}, depth_.id());
  else if (emissive)
    gbuffer_ = gbufferOf({baseColor_.id(), normal_.id(), material_.id(), emissiveTexture_.id()}, depth_.id());
  else
    gbuffer_ = gbufferOf({baseColor_.id(), normal_.id(), material_.id()}, depth_.id());
}

void FrameTargets::bindGbuffer() const {
  const GLuint textures[] = {baseColor_.id(), normal_.id(), material_.id(), emissive_ ? emissiveTexture_.id() : 0,
                             parameters_ ? parametersTexture_.id() : 0, depth_.id()};
  glBindTextures(0, 6, textures);
  for (GLuint unit = 0; unit < 8; ++unit) glBindSampler(unit, 0);
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

GLuint FrameTargets::accumulation() {
  if (!accumulation_) {
    accumulationTexture_ = nearestTexture(GL_RGBA32F, width_, height_);
    const GLuint color = accumulationTexture_.id();
    accumulation_ = gl::createFramebuffer(std::span(&color, 1), depth_.id());
  }
  return accumulation_.id();
}

}  // namespace glint
