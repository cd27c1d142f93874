#include "renderer/area_light_tables.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "materials/base/hash.h"
#include "renderer/disk_cache.h"
#include "renderer/parallel.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr int kRings = 32, kAround = 24, kHalfVectors = kRings * kAround;
constexpr int kViews = AreaLightTables::kViews, kRows = AreaLightTables::kRoughnesses, kCells = kViews * kRows;
constexpr uint64_t kCacheVersion = 1;

// A direction of light of shaders/passes/area_light_samples.frag, by the numbers of its half vector and its view.
glm::dvec3 sampleOf(int halfVector, int cell, bool readsRoughness, double& NoV) {
  const double x = static_cast<double>(cell % kViews) / (kViews - 1), roughness = static_cast<double>(cell / kViews) / (kRows - 1);
  NoV = std::max(1 - x * x, 1e-3);
  const double psi = (halfVector % kRings + 0.5) * 0.5 * std::numbers::pi / kRings;
  const double phi = (halfVector / kRings + 0.5) * std::numbers::pi / kAround;
  const double width = readsRoughness ? std::max(roughness * roughness, 5e-4) : 0.2, t = width * std::tan(psi);
  const double cosTheta = 1 / std::sqrt(1 + t * t), sinTheta = t * cosTheta;
  const glm::dvec3 H(sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta), V(std::sqrt(1 - NoV * NoV), 0, NoV);
  return 2 * glm::dot(V, H) * H - V;
}

// Of values with weights: where that share of all lies below.
double quantile(const std::vector<std::pair<double, double>>& sorted, double share) {
  double all = 0, below = 0;
  for (const auto& [value, weight] : sorted) all += weight;
  for (const auto& [value, weight] : sorted) {
    below += weight;
    if (below >= share * all) return value;
  }
  return sorted.empty() ? 0 : sorted.back().first;
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

CosineFit fitCosine(const std::vector<glm::dvec3>& directions, const std::vector<double>& weights) {
  GLINT_CHECK(directions.size() == weights.size(), "{} directions, {} weights", directions.size(), weights.size());
  glm::dvec3 sum(0);
  for (size_t i = 0; i < weights.size(); ++i) sum += weights[i] * glm::dvec3(directions[i].x, 0, directions[i].z);
  if (!(glm::length(sum) > 0) || !std::isfinite(glm::length(sum))) return {};
  const glm::dvec3 Z = glm::normalize(sum), X(Z.z, 0, -Z.x);
  // On the plane at distance 1 along the lobe.
  constexpr double kFar = 1e9;
  std::vector<std::pair<double, double>> x, y;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    const double along = glm::dot(directions[i], Z), across = glm::dot(directions[i], X);
    const bool before = along > 1e-6;
    x.emplace_back(before ? across / along : std::copysign(kFar, across), weights[i]);
    y.emplace_back(before ? std::abs(directions[i].y) / along : kFar, weights[i]);
  }
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  // There a cosine lobe has its quartiles at 0 and one over the root of 3, each way.
  const double quartile = 1 / std::sqrt(3.0);
  constexpr double kNarrowest = 1e-5, kWidest = 1e3;
  const double shift = std::clamp(quantile(x, 0.5), -kWidest, kWidest);
  const double wideX = std::clamp((quantile(x, 0.75) - quantile(x, 0.25)) / (2 * quartile), kNarrowest, kWidest);
  const double wideY = std::clamp(quantile(y, 0.5) / quartile, kNarrowest, kWidest);
  return {glm::dmat3(X * wideX, glm::dvec3(0, wideY, 0), Z + X * shift), true};
}

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
  parallelFor(kCells, [&](size_t cell) {
    std::vector<glm::dvec3> directions;
    std::vector<double> weights;
    glm::dvec3 at1(0), at004(0);
    for (int i = 0; i < kHalfVectors; ++i) {
      const glm::vec4 a = at[0][cell * kHalfVectors + size_t(i)], b = at[1][cell * kHalfVectors + size_t(i)];
      if (!(std::abs(a.x) + std::abs(a.y) + std::abs(a.z) + std::abs(a.w) + std::abs(b.x) + std::abs(b.y) + std::abs(b.z) < 1e30f)) continue;
      double NoV = 0;
      directions.push_back(sampleOf(i, int(cell), readsRoughness, NoV));
      weights.push_back(std::max(a.w, 0.0f));
      at1 += glm::dvec3(a);
      at004 += glm::dvec3(b);
    }
    const CosineFit fit = fitCosine(directions, weights);
    const glm::dmat3 inverse = glm::inverse(fit.matrix) / glm::inverse(fit.matrix)[1][1];
    layers[cell] = glm::vec4(inverse[0][0], inverse[2][0], inverse[0][2], inverse[2][2]);
    const glm::dvec3 scale = (at1 - at004) / 0.96;
    layers[kCells + cell] = fit.known ? glm::vec4(scale, 0) : glm::vec4(0);
    layers[2 * size_t{kCells} + cell] = fit.known ? glm::vec4(at004 - 0.04 * scale, 0) : glm::vec4(0);
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
