#include "renderer/model_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "materials/base/hash.h"
#include "renderer/disk_cache.h"
#include "renderer/model_tables.h"
#include "renderer/shader_assembler.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

using std::numbers::pi;

constexpr uint64_t kCacheVersion = 1;
constexpr size_t kPolar = ModelSampler::kPolar, kAround = ModelSampler::kAround, kCells = kPolar * kAround,
                 kViews = size_t{ModelSampler::kRoughnesses} * ModelSampler::kCosines;
// As shaders/passes/model_sampler.comp.
constexpr double kSmallest = 2e-4;
// The part of the table that is spread evenly, so that no direction is left out, and the least part by the cosine, which
// bounds what a single sample can weigh.
constexpr double kEven = 0.02, kLeastCosine = 0.05;

// Polar angles of half vectors at one azimuth: theta = kSmallest (e^(k u) - 1) up to the one whose light is at the horizon.
double growth(const glm::dvec3& view, double cosPhi) {
  const double end = 0.25 * pi + 0.5 * std::atan2(view.x * cosPhi, view.z);
  return std::log1p(end / kSmallest);
}

// Per steradian of light, of a half vector at that angle that is drawn evenly in u and azimuth.
double evenDensity(double theta, double k, double VoH) {
  return 1 / (2 * pi * std::max(std::sin(theta), 1e-12) * (theta + kSmallest) * k * 4 * std::max(VoH, 1e-9));
}

// Where a value stands between the nodes of a table.
struct Between {
  size_t below;
  double share;  // of the one above
};
Between between(const std::vector<double>& nodes, double x) {
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x);
  const size_t i = static_cast<size_t>(above - nodes.begin()) - 1;
  return {i, std::clamp((x - nodes[i]) / (nodes[i + 1] - nodes[i]), 0.0, 1.0)};
}

double luminance(const glm::dvec3& c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

Result<std::vector<glm::vec2>> cellsOf(const ModelSetting& setting, bool diskCache) {
  constexpr int kGroup = 64;
  const ShadingModel& model = *setting.shader->model;
  auto program = gl::buildProgram(model.file.string(), {{GL_COMPUTE_SHADER, assembleShader({"shaders/passes/model_sampler.comp", {}, {{"model", setting.shader->glsl}}})}});
  if (!program) return modelErrors(model, program.diagnostics()[0].what);
  ModelTables tables(diskCache);
  if (Diagnostics faults = tables.apply(setting, *program); !faults.empty()) return faults;
  std::vector<glm::vec2> views;
  for (const double roughness : tableRoughnesses(ModelSampler::kRoughnesses))
    for (const double cosine : tableCosines(ModelSampler::kCosines)) views.emplace_back(roughness, std::max(cosine, 1e-4));
  std::vector<glm::vec2> cells(kViews * kCells);
  const gl::Buffer in = gl::createBuffer(std::as_bytes(std::span(views))), out = gl::createBuffer(std::as_bytes(std::span(cells)));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.id());
  program->use();
  glDispatchCompute(static_cast<GLuint>((cells.size() + kGroup - 1) / kGroup), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(cells.size() * sizeof(glm::vec2)), cells.data());
  return cells;
}

uint64_t keyOf(const ModelSetting& setting) {
  uint64_t h = kCacheVersion;
  for (const char* file : {"shaders/passes/model_sampler.comp", "shaders/common/shading.glsl"})
    h = hashText(shipped::read(file).value_or(""), h);
  return setting.key() ^ h;
}

}  // namespace

Result<ModelSampler> ModelSampler::of(const ModelSetting& setting, bool diskCache) {
  const uint64_t key = keyOf(setting);
  std::vector<glm::vec2> cells(kViews * kCells);
  const auto stored = diskCache ? readCache("sampler", key) : std::nullopt;
  if (stored && stored->size() == cells.size() * sizeof(glm::vec2)) {
    std::memcpy(static_cast<void*>(cells.data()), stored->data(), stored->size());
  } else {
    auto made = cellsOf(setting, diskCache);
    if (!made) return made.diagnostics();
    cells = std::move(*made);
    if (diskCache) writeCache("sampler", key, std::string(reinterpret_cast<const char*>(cells.data()), cells.size() * sizeof(glm::vec2)));
  }
  const std::vector<double> roughnesses = tableRoughnesses(kRoughnesses), cosines = tableCosines(kCosines);
  ModelSampler sampler;
  sampler.lobes_.resize(kViews);
  bool any = false;
  for (size_t v = 0; v < kViews; ++v) {
    Lobe& lobe = sampler.lobes_[v];
    lobe.share.fill(1.f / kCells);
    double black = 0, white = 0;
    bool sound = true;
    for (size_t i = 0; i < kCells; ++i) {
      const glm::vec2 cell = cells[v * kCells + i];
      sound &= cell.x >= 0 && cell.y >= 0;
      black += static_cast<double>(cell.x);
      white += static_cast<double>(cell.y);
    }
    const double sum = black + white;
    if (!sound || !(sum < 1e6)) {
      if (sampler.fault_.empty())
        sampler.fault_ = fmt::format("f is {} at roughness {:.3g}, NoV {:.3g}", sum < 1e6 ? "negative" : "not finite",
                                     roughnesses[v / kCosines], cosines[v % kCosines]);
      continue;
    }
    if (sum < 1e-9) continue;
    any = true;
    lobe.black = static_cast<float>(black);
    lobe.white = static_cast<float>(white);
    for (size_t i = 0; i < kCells; ++i)
      lobe.share[i] = static_cast<float>((1 - kEven) * static_cast<double>(cells[v * kCells + i].x + cells[v * kCells + i].y) / sum + kEven / kCells);
  }
  if (!any && sampler.fault_.empty()) sampler.fault_ = "the specular part is 0 everywhere";
  return sampler;
}

DirectionSampler ModelSampler::at(const glm::dvec3& view, double roughness, const glm::dvec3& F0, const glm::dvec3& diffuseColor) const {
  static const std::vector<double> roughnesses = tableRoughnesses(kRoughnesses), cosines = tableCosines(kCosines);
  DirectionSampler made;
  const double sine = std::hypot(view.x, view.y);
  if (sine > 1e-12) made.turn_ = glm::dvec2(view.x, view.y) / sine;
  made.view_ = {sine, 0, std::max(view.z, 1e-9)};
  const Between r = between(roughnesses, roughness), c = between(cosines, view.z);
  std::array<std::pair<const Lobe*, double>, 4> parts;
  double specular = 0;
  for (size_t i = 0; i < 4; ++i) {
    const Lobe& lobe = lobes_[(r.below + i / 2) * kCosines + c.below + i % 2];
    const double weight = (i / 2 ? r.share : 1 - r.share) * (i % 2 ? c.share : 1 - c.share);
    parts[i] = {&lobe, weight};
    specular += weight * std::lerp(static_cast<double>(lobe.black), static_cast<double>(lobe.white), std::clamp(luminance(F0), 0.0, 1.0));
  }
  const double diffuse = std::max(luminance(diffuseColor), 0.0);
  if (specular <= 0) return made;
  made.tabulated_ = std::min(specular / (specular + diffuse), 1 - kLeastCosine);
  made.cumulated_.resize(kCells);
  double sum = 0;
  for (size_t i = 0; i < kCells; ++i) {
    for (const auto& [lobe, weight] : parts) sum += weight * static_cast<double>(lobe->share[i]);
    made.cumulated_[i] = sum;
  }
  for (double& x : made.cumulated_) x /= sum;
  return made;
}

SampledDirection DirectionSampler::sample(double u1, double u2) const {
  glm::dvec3 l;
  if (u1 < tabulated_) {
    u1 /= tabulated_;
    const size_t cell = std::min(static_cast<size_t>(std::upper_bound(cumulated_.begin(), cumulated_.end(), u1) - cumulated_.begin()), kCells - 1);
    const double begin = cell ? cumulated_[cell - 1] : 0.0;
    const double u = (static_cast<double>(cell % kPolar) + std::clamp((u1 - begin) / (cumulated_[cell] - begin), 0.0, 1 - 1e-12)) / kPolar;
    const double phi = (static_cast<double>(cell / kPolar) + u2) * (2 * pi / kAround);
    const double theta = kSmallest * std::expm1(growth(view_, std::cos(phi)) * u);
    const glm::dvec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    l = 2 * glm::dot(view_, h) * h - view_;
    l.z = std::max(l.z, 1e-9);
    l = glm::normalize(l);
  } else {
    u1 = std::clamp((u1 - tabulated_) / (1 - tabulated_), 0.0, 1 - 1e-12);
    l = {std::sqrt(u1) * std::cos(2 * pi * u2), std::sqrt(u1) * std::sin(2 * pi * u2), std::sqrt(1 - u1)};
  }
  const glm::dvec3 turned(turn_.x * l.x - turn_.y * l.y, turn_.y * l.x + turn_.x * l.y, l.z);
  return {turned, pdf(turned)};
}

double DirectionSampler::pdf(const glm::dvec3& light) const {
  if (light.z <= 0) return 0;
  const double cosine = light.z / pi;
  if (cumulated_.empty()) return cosine;
  return tabulated_ * halfVectorPdf({turn_.x * light.x + turn_.y * light.y, turn_.x * light.y - turn_.y * light.x, light.z}) + (1 - tabulated_) * cosine;
}

double DirectionSampler::halfVectorPdf(const glm::dvec3& light) const {
  const glm::dvec3 sum = light + view_;
  const double length = glm::length(sum), across = std::hypot(sum.x, sum.y);
  if (length < 1e-9) return 0;
  const double theta = std::atan2(across, sum.z);
  const double cosPhi = across > 0 ? sum.x / across : 1.0;
  double phi = std::atan2(sum.y, sum.x);
  if (phi < 0) phi += 2 * pi;
  const double k = growth(view_, cosPhi), u = std::log1p(theta / kSmallest) / k;
  const size_t row = std::min(static_cast<size_t>(u * kPolar), kPolar - 1), column = std::min(static_cast<size_t>(phi * kAround / (2 * pi)), kAround - 1);
  const size_t cell = column * kPolar + row;
  const double share = cumulated_[cell] - (cell ? cumulated_[cell - 1] : 0.0);
  return share * kCells * evenDensity(theta, k, 0.5 * length);
}

}  // namespace glint
