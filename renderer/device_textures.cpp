#include "renderer/device_textures.h"

#include <cmath>
#include <tuple>

#include "renderer/normal_variance.h"

namespace glint {
namespace {

std::vector<uint8_t> fourChannels(const Image8& image) {
  std::vector<uint8_t> out(static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 4);
  const size_t channels = static_cast<size_t>(image.channels);
  for (size_t i = 0; i < out.size() / 4; ++i) {
    const uint8_t* p = &image.data[i * channels];
    const bool gray = channels < 3;
    out[4 * i] = p[0];
    out[4 * i + 1] = gray ? p[0] : p[1];
    out[4 * i + 2] = gray ? p[0] : p[2];
    out[4 * i + 3] = channels == 4 ? p[3] : channels == 2 ? p[1] : 255;
  }
  return out;
}

// Leaves the colours of every level as they are.
void setAlpha(const gl::Texture& texture, const std::vector<Pixels<uint8_t>>& levels) {
  for (size_t i = 0; i < levels.size(); ++i) {
    const Pixels<uint8_t>& alpha = levels[i];
    std::vector<uint8_t> texels(alpha.data.size() * 4);
    const GLint level = static_cast<GLint>(i);
    glGetTextureImage(texture.id(), level, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(texels.size()), texels.data());
    for (size_t t = 0; t < alpha.data.size(); ++t) texels[4 * t + 3] = alpha.data[t];
    glTextureSubImage2D(texture.id(), level, 0, 0, alpha.width, alpha.height, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
}

GLenum wrapMode(Wrap wrap) {
  return wrap == Wrap::Repeat ? GL_REPEAT : wrap == Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_MIRRORED_REPEAT;
}

}  // namespace

GLuint DeviceTextures::texture(const Image8Ptr& image, ColorSpace space, bool variance) {
  if (!image || image->empty()) {
    if (!white_) {
      white_ = gl::createTexture2D(GL_RGBA8, 1, 1, 1);
      const uint8_t texel[4] = {255, 255, 255, 255};
      glTextureSubImage2D(white_.id(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    }
    return white_.id();
  }
  const auto key = std::make_tuple(image.get(), space, variance);
  auto found = textures_.find(key);
  if (found != textures_.end() && found->second.source.lock() != image) {
    textures_.erase(found);
    found = textures_.end();
  }
  if (found == textures_.end()) {
    gl::Texture made = gl::createTexture2D(space == ColorSpace::sRGB ? GL_SRGB8_ALPHA8 : GL_RGBA8, image->width, image->height, 0);
    glTextureSubImage2D(made.id(), 0, 0, 0, image->width, image->height, GL_RGBA, GL_UNSIGNED_BYTE, fourChannels(*image).data());
    glGenerateTextureMipmap(made.id());
    if (variance) setAlpha(made, encodedNormalVariance(*image));
    found = textures_.emplace(key, Entry{image, std::move(made)}).first;
  }
  return found->second.texture.id();
}

GLuint DeviceTextures::sampler(Filter filter, Wrap s, Wrap t, float bias) {
  const auto key = std::make_tuple(filter, s, t, bias);
  auto found = samplers_.find(key);
  if (found == samplers_.end()) {
    const bool linear = filter == Filter::Linear;
    found = samplers_
                .emplace(key, gl::createSampler(linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST,
                                                linear ? GL_LINEAR : GL_NEAREST, wrapMode(s), wrapMode(t)))
                .first;
    glSamplerParameterf(found->second.id(), GL_TEXTURE_LOD_BIAS, bias);
  }
  return found->second.id();
}

void DeviceTextures::bind(GLuint unit, const Image8Ptr& image, const TextureSlot& slot, float normalShare) {
  const bool variance = slot.normals && normalShare > 0;
  glBindTextureUnit(unit, texture(image, slot.colorSpace, variance));
  // A level is a quarter of the pixels of the one before.
  glBindSampler(unit, sampler(slot.filter, slot.wrapS, slot.wrapT, variance ? 0.5f * std::log2(normalShare) : 0.0f));
}

void DeviceTextures::forgetUnused() {
  std::erase_if(textures_, [](const auto& item) { return item.second.source.expired(); });
}

}  // namespace glint
