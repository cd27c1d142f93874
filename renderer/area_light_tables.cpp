#include "renderer/area_light_tables.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "materials/base/hash.h"
#include "renderer/cosine_fit.h"
#include "renderer/disk_cache.h"
#include "renderer/parallel.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr int kRings = 32, kAround = 24, kHalfVectors = kRings * kAround;
constexpr int kViews = AreaLightTables::kViews, kRows = AreaLightTables::kRoughnesses, kCells = kViews * kRows;
constexpr uint64_t kCacheVersion = 2;

// A direction of light of shaders/passes/area_light_samples.frag, by the numbers of its half vector and its view; nothing when
// it is below the horizon.
std::optional<LobeSample> sampleOf(int halfVector, int cell, bool readsRoughness) {
  const double x = static_cast<double>(cell % kViews) / (kViews - 1), roughness = static_cast<double>(cell / kViews) / (kRows - 1);
  const double NoV = std::max(1 - x * x, 1e-3), step = 0.5 * std::numbers::pi / kRings;
  const double psi = (halfVector % kRings + 0.5) * step, phi = (halfVector / kRings + 0.5) * std::numbers::pi / kAround;
  const double width = readsRoughness ? std::max(roughness * roughness, 5e-4) : 0.2, t = width * std::tan(psi);
  const double cosTheta = 1 / std::sqrt(1 + t * t), sinTheta = t * cosTheta, cosPsi = std::cos(psi);
  const glm::dvec3 H(sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta), V(std::sqrt(1 - NoV * NoV), 0, NoV);
  const double VoH = glm::dot(V, H), measure = sinTheta * width * cosTheta * cosTheta / (cosPsi * cosPsi) * step * 2 * std::numbers::pi / kAround;
  const glm::dvec3 L = 2 * VoH * H - V;
  if (VoH <= 0 || L.z <= 0) return std::nullopt;
  return LobeSample{L, 4 * VoH * measure, 0};
}

uint64_t recipe() {
  static const uint64_t hash = [] {
    uint64_t h = kCacheVersion;
    for (const char* file : {"shaders/passes/area_light_samples.frag", "shaders/common/shading.glsl"}) h = hashText(shipped::read(file).value_or(""), h);
    return h;
  }();
  return hash;
}

}  // namespace

Result<std::vector<glm::vec4>> AreaLightTables::make(const ModelSetting& setting, Lobe lobe) {
  const auto found = programs_.get(Rectangles::vertexShader(), {"shaders/passes/area_light_samples.frag", definesOf(lobe), {{"model", setting.shader->glsl}}});
  if (!found) return found.diagnostics();
  const gl::Program& program = **found;
  if (Diagnostics faults = tables_.apply(setting, program); !faults.empty()) return faults;
  glProgramUniform2i(program.id(), program.location("halfVectors"), kRings, kAround);
  glProgramUniform2i(program.id(), program.location("views"), kViews, kRows);
  gl::Texture targets[2];
  GLuint colors[2];
  std::vector<glm::vec4> at[2];
  for (size_t i = 0; i < 2; ++i) {
    targets[i] = gl::createTexture2D(GL_RGBA32F, kHalfVectors, kCells);
    colors[i] = targets[i].id();
  }
  const gl::Framebuffer framebuffer = gl::createFramebuffer(colors);
  rectangles_.drawWhole(program, framebuffer.id(), {kHalfVectors, kCells});
  for (size_t i = 0; i < 2; ++i) {
    at[i].resize(size_t{kHalfVectors} * kCells);
    glGetTextureImage(colors[i], 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(at[i].size() * sizeof(glm::vec4)), at[i].data());
  }

  std::vector<glm::vec4> layers(3 * size_t{kCells});
  const bool readsRoughness = lobe == Lobe::Coat || setting.shader->model->reads("roughness");
  parallelFor(kRows, [&](size_t row) {
    CosineFit fit;
    for (size_t cell = row * kViews; cell < (row + 1) * kViews; ++cell) {
      std::vector<LobeSample> samples;
      glm::dvec3 at1(0), at004(0);
      for (int i = 0; i < kHalfVectors; ++i) {
        const glm::vec4 a = at[0][cell * kHalfVectors + size_t(i)], b = at[1][cell * kHalfVectors + size_t(i)];
        if (!(std::abs(a.x) + std::abs(a.y) + std::abs(a.z) + std::abs(a.w) + std::abs(b.x) + std::abs(b.y) + std::abs(b.z) < 1e30f)) continue;
        auto sample = sampleOf(i, int(cell), readsRoughness);
        if (!sample) continue;
        sample->sent = std::max(a.w, 0.0f) / sample->solidAngle;
        samples.push_back(*sample);
        at1 += glm::dvec3(a);
        at004 += glm::dvec3(b);
      }
      const CosineFit before = fit;
      fit = fitCosine(samples, &before);
      const glm::dmat3 inverse = glm::inverse(fit.matrix) * fit.matrix[1][1];
      layers[cell] = glm::vec4(inverse[0][0], inverse[2][0], inverse[0][2], inverse[2][2]);
      const glm::dvec3 scale = (at1 - at004) / 0.96;
      layers[kCells + cell] = fit.known ? glm::vec4(scale / fit.above, 0) : glm::vec4(0);
      layers[2 * size_t{kCells} + cell] = fit.known ? glm::vec4((at004 - 0.04 * scale) / fit.above, 0) : glm::vec4(0);
    }
  });
  return layers;
}

Result<GLuint> AreaLightTables::of(const ModelSetting& setting) {
  const uint64_t key = setting.key() ^ recipe();
  if (const gl::Texture* found = kept_.find(key)) return found->id();
  const size_t count = setting.shader->model->definesCoat ? 6 : 3, bytes = count * kCells * sizeof(glm::vec4);
  std::vector<glm::vec4> layers;
  if (const auto stored = diskCache_ ? readCache("area-lights", key) : std::nullopt; stored && stored->size() == bytes) {
    layers.resize(count * kCells);
    std::memcpy(static_cast<void*>(layers.data()), stored->data(), bytes);
  } else {
    for (const Lobe lobe : {Lobe::Base, Lobe::Coat}) {
      if (lobe == Lobe::Coat && !setting.shader->model->definesCoat) continue;
      auto made = make(setting, lobe);
      if (!made) return made.diagnostics();
      layers.insert(layers.end(), made->begin(), made->end());
    }
    if (diskCache_) writeCache("area-lights", key, std::string(reinterpret_cast<const char*>(layers.data()), bytes));
  }
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
  gl::Texture texture(id);
  glTextureStorage3D(id, 1, GL_RGBA32F, kViews, kRows, static_cast<GLsizei>(count));
  glTextureSubImage3D(id, 0, 0, 0, 0, kViews, kRows, static_cast<GLsizei>(count), GL_RGBA, GL_FLOAT, layers.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTextureParameteri(id, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTextureParameteri(id, wrap, GL_CLAMP_TO_EDGE);
  return kept_.put(key, std::move(texture)).id();
}

}  // namespace glint
