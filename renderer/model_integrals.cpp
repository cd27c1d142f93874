#include "renderer/model_integrals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/base/check.h"
#include "renderer/quadrature.h"
#include "renderer/shader_assembler.h"

namespace glint {
namespace {

using std::numbers::pi;

constexpr int kGroup = 64;
constexpr size_t kQueriesAtOnce = 256;
constexpr double kSmallest = 2e-4;   // as shaders/passes/model_integrals.comp

double largest(const glm::vec4& v) { return std::max({v.r, v.g, v.b}); }

// As that shader's.
struct DeviceQuery {
  glm::vec4 roughnessNoVLightAzimuth, slots, F0Aspect, diffuseAuthored, baseColorMetallic, specular;
};

}  // namespace

struct ModelIntegrals::Sums {
  glm::vec4 specular, specularBlack, white, diffuse, scattered;
};

// Half vectors at theta = kSmallest (e^(k u) - 1), as dense for every width of a lobe; lights at sin^2(theta) = u. Around
// the normal by quarters from the view's plane, where grazing views have their edges.
struct ModelIntegrals::Nodes {
  std::vector<glm::vec4> polar, around;                       // see shaders/passes/model_integrals.comp
  std::vector<double> specular, distribution, diffuse;        // weights of the polar nodes
};

ModelIntegrals::Nodes ModelIntegrals::makeNodes(int polar, int quarter) {
  const double k = std::log1p(0.5 * pi / kSmallest);
  Nodes nodes;
  for (const QuadratureNode& node : gaussLegendre(polar)) {
    const double theta = kSmallest * std::expm1(k * node.x);
    nodes.polar.emplace_back(node.x, std::sin(theta), std::cos(theta), std::sqrt(1 - node.x));
    nodes.specular.push_back(2 * pi * node.weight);
    nodes.distribution.push_back(2 * pi * std::sin(theta) * (theta + kSmallest) * k * node.weight);
    nodes.diffuse.push_back(pi * node.weight);
  }
  // Close together across the view's plane, where all changes within a grazing view's cosine.
  for (const double side : {0.5 * pi, 1.5 * pi})
    for (const double away : {-0.5 * pi, 0.5 * pi})
      for (const QuadratureNode& node : gaussLegendre(quarter)) {
        const double phi = side + away * node.x * node.x * node.x;
        nodes.around.emplace_back(std::cos(phi), std::sin(phi), 0.75 * node.x * node.x * node.weight, 0);
      }
  return nodes;
}

Result<ModelIntegrals> ModelIntegrals::of(const ShadingModel& model, const IntegralOptions& options) {
  return of(modelSetting(model), options);
}

Result<ModelIntegrals> ModelIntegrals::of(const ModelSetting& setting, const IntegralOptions& options) {
  std::vector<std::string> defines;
  if (options.compensate.value_or(setting.shader->model->compensate)) defines.push_back("COMPENSATE");
  if (options.specularOnly) defines.push_back("SPECULAR_ONLY");
  const ShadingModel& model = *setting.shader->model;
  auto program = gl::buildProgram(
      model.file.string(), {{GL_COMPUTE_SHADER, assembleShader({"shaders/passes/model_integrals.comp", defines, {{"model", setting.shader->glsl}}})}});
  if (!program) return modelErrors(model, program.diagnostics()[0].what);
  ModelIntegrals integrals;
  integrals.setting_ = setting;
  integrals.options_ = options;
  integrals.tables_ = std::make_unique<ModelTables>();
  integrals.program_ = std::move(*program);
  if (Diagnostics faults = integrals.tables_->apply(setting, integrals.program_); !faults.empty()) return faults;
  return integrals;
}

void ModelIntegrals::set(const std::string& name, const Value& value) { setting_.set(name, value); }

std::vector<ModelIntegrals::Sums> ModelIntegrals::sums(std::span<const IntegralQuery> queries, std::span<const float> aspects,
                                                       std::span<const glm::vec4> polarNodes, std::span<const glm::vec4> aroundNodes) const {
  const std::array<float, 4>& slots = setting_.slots;
  const Diagnostics faults = tables_->apply(setting_, program_);
  GLINT_CHECK(faults.empty(), "{}", faults[0].text());
  const gl::Buffer polar = gl::createBuffer(std::as_bytes(polarNodes)), around = gl::createBuffer(std::as_bytes(aroundNodes));
  std::vector<Sums> sums(queries.size() * polarNodes.size());
  program_.use();
  for (size_t begin = 0; begin < queries.size(); begin += kQueriesAtOnce) {
    const auto batch = queries.subspan(begin, std::min(kQueriesAtOnce, queries.size() - begin));
    std::vector<DeviceQuery> packed;
    for (size_t i = 0; i < batch.size(); ++i) {
      const IntegralQuery& q = batch[i];
      packed.push_back({{q.roughness, q.NoV, q.analyticLight ? 1.f : 0.f, q.azimuth},
                        {slots[0], slots[1], slots[2], slots[3]},
                        {q.F0, aspects[begin + i]},
                        {q.diffuseColor, !q.authored ? 0.f : q.authored->plainNonmetal ? 2.f : 1.f},
                        q.authored ? glm::vec4(q.authored->baseColor, q.authored->metallic) : glm::vec4(0),
                        q.authored ? glm::vec4(q.authored->specular, 0, 0, 0) : glm::vec4(0)});
    }
    const auto part = std::span(sums).subspan(begin * polarNodes.size(), batch.size() * polarNodes.size());
    const gl::Buffer in = gl::createBuffer(std::as_bytes(std::span(packed))), out = gl::createBuffer(std::as_bytes(part));
    program_.set("count", static_cast<int>(part.size()));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, polar.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, around.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, out.id());
    glDispatchCompute(static_cast<GLuint>((part.size() + kGroup - 1) / kGroup), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(part.size_bytes()), part.data());
  }
  return sums;
}

std::vector<float> ModelIntegrals::aspects(std::span<const float> roughnesses) const {
  std::vector<float> aspects(roughnesses.size(), 1.f);
  if (!setting_.shader->model->usesTangent) return aspects;
  // A little off the normal, where a view has an azimuth.
  std::vector<IntegralQuery> queries;
  for (const float roughness : roughnesses) queries.push_back({.roughness = roughness, .NoV = 0.99995f});
  for (const float roughness : {0.5f, 0.35f, 0.2f, 0.1f}) queries.push_back({.roughness = roughness, .NoV = 0.99995f});
  // Half vectors up to where light at the horizon is lost in its cosine.
  constexpr int kSlopes = 48;
  constexpr double kNarrowest = 2e-4, kWidest = 0.74;
  const double k = std::log1p(0.25 * pi / kSmallest);
  std::vector<glm::vec4> polar;
  std::vector<double> thetas, slopes;
  for (int i = 0; i < kSlopes; ++i) {
    thetas.push_back(kNarrowest * std::pow(kWidest / kNarrowest, static_cast<double>(i) / (kSlopes - 1)));
    slopes.push_back(std::tan(thetas.back()));
    polar.emplace_back(std::log1p(thetas.back() / kSmallest) / k, 0, 0, 0);
  }
  // f NoL cos^4: of facets the distribution of slopes, which falls alike along both axes.
  std::vector<double> f[2];
  for (const int axis : {0, 1}) {
    const glm::vec4 around[] = {axis == 0 ? glm::vec4(1, 0, 1, 0) : glm::vec4(0, 1, 1, 0)};
    const std::vector<Sums> along = sums(queries, std::vector<float>(queries.size(), 1.f), polar, around);
    for (size_t i = 0; i < along.size(); ++i) {
      const double theta = thetas[i % kSlopes];
      f[axis].push_back(largest(along[i].white) / (std::sin(theta) * (theta + kSmallest)) * std::pow(std::cos(theta), 3));
    }
  }
  // The slope at which it has fallen to a part of its peak.
  const auto width = [&](const double* values, double part) {
    size_t i = 1;
    while (i + 1 < kSlopes && values[i] > part * values[0]) ++i;
    const double share = (values[i - 1] - part * values[0]) / (values[i - 1] - values[i]);
    return slopes[i - 1] * std::pow(slopes[i] / slopes[i - 1], std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 1.0);
  };
  constexpr double kMost = 50, kNarrow = 0.3;
  std::vector<double> ratios, widest;
  for (size_t q = 0; q < queries.size(); ++q) {
    const double *along = &f[0][q * kSlopes], *across = &f[1][q * kSlopes];
    // To a half, or where one of the two does not come down so far, to where that one does.
    const double part = std::max({0.5, along[kSlopes - 1] / along[0], across[kSlopes - 1] / across[0]});
    const double x = part < 1 ? width(along, part) : 1, y = part < 1 ? width(across, part) : 1;
    ratios.push_back(std::isfinite(y / x) ? std::clamp(y / x, 1 / kMost, kMost) : 1);
    widest.push_back(part < 1 ? std::max(x, y) : 1);
  }
  // Wide lobes are cut off by the horizon and bent by masking: they are taken to be as long as narrow ones of the model.
  for (size_t q = 0; q < aspects.size(); ++q) {
    size_t from = q;
    for (size_t other = aspects.size(); from == q && !(widest[q] < kNarrow) && other < queries.size(); ++other)
      if (widest[other] < kNarrow) from = other;
    aspects[q] = static_cast<float>(ratios[from]);
  }
  return aspects;
}

std::vector<ModelIntegral> ModelIntegrals::evaluate(std::span<const IntegralQuery> queries) const {
  const Nodes nodes = makeNodes(options_.polar, options_.quarter);
  std::vector<float> roughnesses;
  for (const IntegralQuery& q : queries) roughnesses.push_back(q.roughness);
  std::sort(roughnesses.begin(), roughnesses.end());
  roughnesses.erase(std::unique(roughnesses.begin(), roughnesses.end()), roughnesses.end());
  const std::vector<float> ofRoughness = aspects(roughnesses);
  std::vector<float> ofQuery;
  for (const IntegralQuery& q : queries)
    ofQuery.push_back(ofRoughness[static_cast<size_t>(std::lower_bound(roughnesses.begin(), roughnesses.end(), q.roughness) - roughnesses.begin())]);
  const std::vector<Sums> all = sums(queries, ofQuery, nodes.polar, nodes.around);
  const size_t polarCount = nodes.polar.size();
  std::vector<ModelIntegral> integrals(queries.size());
  for (size_t i = 0; i < all.size(); ++i) {
    ModelIntegral& integral = integrals[i / polarCount];
    const size_t node = i % polarCount;
    integral.specular += nodes.specular[node] * glm::dvec3(all[i].specular);
    integral.specularBlack += nodes.specular[node] * glm::dvec3(all[i].specularBlack);
    integral.white += nodes.specular[node] * glm::dvec3(all[i].white);
    integral.diffuse += nodes.diffuse[node] * glm::dvec3(all[i].diffuse);
    integral.scattered += 4 * nodes.diffuse[node] * glm::dvec3(all[i].scattered);
    integral.distribution += nodes.distribution[node] * static_cast<double>(all[i].specular.w);
    integral.projected += nodes.distribution[node] * static_cast<double>(all[i].specularBlack.w);
  }
  return integrals;
}

double ModelIntegrals::averageAlbedo(float roughness, bool analyticLight) const {
  const int azimuths = setting_.shader->model->usesTangent ? 12 : 1;
  std::vector<IntegralQuery> queries;
  std::vector<double> weights;
  // Squared nodes: directional albedos of smooth lobes change fastest where the view grazes.
  for (const QuadratureNode& node : gaussLegendre(24))
    for (int a = 0; a < azimuths; ++a) {
      queries.push_back({.roughness = roughness, .NoV = static_cast<float>(node.x * node.x), .analyticLight = analyticLight,
                         .azimuth = azimuths == 1 ? 0.f : static_cast<float>(pi * (a + 0.5) / azimuths)});
      weights.push_back(2 * node.x * node.x * 2 * node.x * node.weight / azimuths);
    }
  const std::vector<ModelIntegral> integrals = evaluate(queries);
  double sum = 0;
  for (size_t i = 0; i < integrals.size(); ++i) sum += weights[i] * integrals[i].specular.g;
  return sum;
}

}  // namespace glint
