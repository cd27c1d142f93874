// The specular light of an environment: its average under a model's lobe, for each roughness and direction.
#include <bit>
#include <cmath>
#include <numbers>

#include "materials/base/hash.h"
#include "renderer/disk_cache.h"
#include "renderer/environment_lighting.h"
#include "renderer/environment_spots.h"
#include "renderer/lobe.h"

namespace glint {
namespace {

constexpr int kMostSamples = 4096;   // of shaders/passes/prefilter.frag

// As that shader's.
struct SpotBlock {
  glm::vec4 directions[SpotsOfEnvironment::kMost], irradiances[SpotsOfEnvironment::kMost];
};

// Of a level with `size` texels a side: no higher than a lobe as wide as one of them, which a narrower one would step over.
gl::Texture densityTexture(const std::vector<float>& kernel, int size) {
  std::vector<float> density = lobeDensity(kernel);
  for (float& d : density) d = std::min(d, static_cast<float>(6 * size * size / (4 * std::numbers::pi)));
  gl::Texture texture = gl::createTexture2D(GL_R32F, static_cast<int>(density.size()), 1);
  glTextureSubImage2D(texture.id(), 0, 0, 0, static_cast<int>(density.size()), 1, GL_RED, GL_FLOAT, density.data());
  return texture;
}

// On disk lie the levels from 1 on; level 0 is the environment, which is at hand.
size_t levelBytes(int level) {
  const auto size = static_cast<size_t>(EnvironmentLighting::kSize >> level);
  return size * size * 6 * 8;
}
size_t storedBytes() {
  size_t total = 0;
  for (int level = 1; level < EnvironmentLighting::kLevels; ++level) total += levelBytes(level);
  return total;
}

std::string levelsOf(const gl::Texture& cube) {
  std::string bytes(storedBytes(), '\0');
  size_t offset = 0;
  for (int level = 1; level < EnvironmentLighting::kLevels; ++level) {
    glGetTextureImage(cube.id(), level, GL_RGBA, GL_HALF_FLOAT, static_cast<GLsizei>(levelBytes(level)), bytes.data() + offset);
    offset += levelBytes(level);
  }
  return bytes;
}

}  // namespace

glm::vec3 cubeDirection(int face, glm::vec2 p) {
  const glm::vec2 q = 2.0f * p - 1.0f;
  switch (face) {
    case 0: return {1, -q.y, -q.x};
    case 1: return {-1, -q.y, q.x};
    case 2: return {q.x, 1, q.y};
    case 3: return {q.x, -1, -q.y};
    case 4: return {q.x, -q.y, 1};
    default: return {-q.x, -q.y, -1};
  }
}

const EnvironmentLighting::Rest& EnvironmentLighting::rest(const EnvironmentPtr& environment, Spots which) {
  constexpr SpotSizes kSmall{0.12, 0.0045}, kLarge{0.25, 0.026};
  const uint64_t key = environment->hash ^ static_cast<uint64_t>(which);
  if (const Rest* found = rests_.find(key)) return *found;
  SpotsOfEnvironment found;
  if (which != Spots::None) found = takeOutSpots(environment->pixels, which == Spots::Small ? kSmall : kLarge);
  const EnvironmentMaps& source = maps(environment);
  Rest rest;
  rest.spotCount = static_cast<int>(found.spots.size());
  SpotBlock block{};
  for (size_t i = 0; i < found.spots.size(); ++i) {
    block.directions[i] = glm::vec4(found.spots[i].direction, 0);
    block.irradiances[i] = glm::vec4(found.spots[i].irradiance, 0);
  }
  rest.spots = gl::createBuffer(std::as_bytes(std::span(&block, 1)));
  if (!found.spots.empty()) {
    // No sample stands for less than these texels.
    rest.size = std::min(source.size, which == Spots::Small ? 512 : 128);
    rest.cube = drawCube(found.rest, rest.size, source.scale, environment->name);
  }
  return rests_.put(key, std::move(rest));
}

Result<gl::Texture> EnvironmentLighting::prefilter(const EnvironmentPtr& environment, const ModelSetting& setting,
                                                   const std::array<int, kLevels>& samples, Lobe which) {
  const auto rows = lobe(setting, which);
  if (!rows) return rows.diagnostics();
  const EnvironmentMaps& source = maps(environment);
  gl::Texture cube = gl::createTextureCube(GL_RGBA16F, kSize, kLevels);
  gl::Framebuffer framebuffer = gl::createFramebuffer({});
  const GLenum buffer = GL_COLOR_ATTACHMENT0;
  glNamedFramebufferDrawBuffers(framebuffer.id(), 1, &buffer);
  const gl::Program& program = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/prefilter.frag", {}, {}});
  program.set("scale", source.scale);
  double done = 0, all = 0;
  for (int level = 0; level < kLevels; ++level) all += samples[static_cast<size_t>(level)] * (kSize >> level) * (kSize >> level);
  for (int level = 0; level < kLevels; ++level) {
    const int size = kSize >> level;
    const int count = samples[static_cast<size_t>(level)];
    GLINT_CHECK(count >= 1 && count <= kMostSamples, "{} samples", count);
    const std::vector<float>& kernel = (*rows)[static_cast<size_t>(level)];
    // Spots stand closer together than the lobe is wide.
    const double width = 2 * medianSlope(kernel);
    const Rest& dim = rest(environment, level == 0 || width < 0.02 ? Spots::None : width < 0.12 ? Spots::Small : Spots::Large);
    glBindBufferBase(GL_UNIFORM_BUFFER, 5, dim.spots.id());
    // Level 0 is the mirror: the environment itself at this size.
    std::vector<glm::vec4> directions =
        level == 0 ? std::vector<glm::vec4>{glm::vec4(0, 0, 1, std::max(0.0, std::log2(double(source.size) / kSize)))}
                   : lobeSamples(kernel, count, dim.cube ? dim.size : source.size);
    const int drawn = static_cast<int>(directions.size());
    glBindTextureUnit(6, dim.cube ? dim.cube.id() : source.cube.id());
    program.set("spotCount", dim.spotCount);
    const gl::Texture density = dim.spotCount > 0 ? densityTexture(kernel, size) : gl::Texture();
    glBindTextureUnit(7, density ? density.id() : 0);
    // The block's whole size: binding less than the shader declares is undefined.
    directions.resize(kMostSamples);
    const gl::Buffer block = gl::createBuffer(std::as_bytes(std::span(directions)));
    glBindBufferBase(GL_UNIFORM_BUFFER, 4, block.id());
    program.set("sampleCount", drawn);
    program.set("size", static_cast<float>(size));
    for (int face = 0; face < 6; ++face) {
      glNamedFramebufferTextureLayer(framebuffer.id(), GL_COLOR_ATTACHMENT0, cube.id(), level, face);
      program.set("face", face);
      rectangles_.drawWhole(program, framebuffer.id(), {size, size});
      if (progress_) glFinish();
      done += count * size * size / 6.0;
      if (progress_) progress_("lighting of " + setting.shader->model->title + " by " + environment->name, std::min(1.0, done / all));
    }
  }
  return cube;
}

gl::Texture EnvironmentLighting::storedCube(const EnvironmentPtr& environment, uint64_t key) {
  const auto stored = diskCache_ ? readCache("prefiltered", key) : std::nullopt;
  if (!stored || stored->size() != storedBytes()) return {};
  const EnvironmentMaps& source = maps(environment);
  if (source.size < kSize) return {};
  gl::Texture cube = gl::createTextureCube(GL_RGBA16F, kSize, kLevels);
  size_t offset = 0;
  for (int level = 1; level < kLevels; ++level) {
    glTextureSubImage3D(cube.id(), level, 0, 0, 0, kSize >> level, kSize >> level, 6, GL_RGBA, GL_HALF_FLOAT, stored->data() + offset);
    offset += levelBytes(level);
  }
  const int sourceLevel = std::max(0, static_cast<int>(std::bit_width(static_cast<unsigned>(source.size / kSize))) - 1);
  glCopyImageSubData(source.cube.id(), GL_TEXTURE_CUBE_MAP, sourceLevel, 0, 0, 0, cube.id(), GL_TEXTURE_CUBE_MAP, 0, 0, 0, 0, kSize, kSize, 6);
  return cube;
}

Result<GLuint> EnvironmentLighting::prefiltered(const EnvironmentPtr& environment, const ModelSetting& setting, Lobe which, TableQuality quality) {
  constexpr int kOwnLobeSamples = 256, kCoarser = 8;
  const uint64_t modelKey = keyOf(setting, which);
  uint64_t key = hashBytes(&modelKey, 8, environment->hash);
  if (const gl::Texture* found = prefiltered_.find(key)) return found->id();
  if (gl::Texture cube = storedCube(environment, key)) return prefiltered_.put(key, std::move(cube)).id();

  const bool coarse = quality == TableQuality::Coarse;
  if (coarse) {
    coarse_.push_back({environment, setting, which});
    key ^= kCoarseKey;
    if (const gl::Texture* found = prefiltered_.find(key)) return found->id();
  }
  std::array<int, kLevels> samples;
  for (int level = 0; level < kLevels; ++level) {
    int& count = samples[static_cast<size_t>(level)];
    count = setting.shader->model->reads("roughness") ? levelSamples(level) : level == kOwnLobeLevel ? kOwnLobeSamples : 1;
    if (coarse) count = std::max(1, count / kCoarser);
  }
  auto cube = prefilter(environment, setting, samples, which);
  if (!cube) return cube.diagnostics();
  // What is wrong is not kept, so that it is said whenever it is drawn.
  if (!coarse && diskCache_ && invalid(setting).lobe == 0) writeCache("prefiltered", key, levelsOf(*cube));
  return prefiltered_.put(key, std::move(*cube)).id();
}

}  // namespace glint
