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

// Half vectors at theta = kSmallest (e^(k u) - 1), as dense for every width of a lobe; lights at sin^2(theta) = u. Around
// the normal by quarters from the view's plane, where grazing views have their edges.
struct Nodes {
  std::vector<glm::vec4> polar, around;                       // see shaders/passes/model_integrals.comp
  std::vector<double> specular, distribution, diffuse;        // weights of the polar nodes
};

Nodes makeNodes(int polar, int quarter) {
  constexpr double kSmallest = 2e-4;
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

struct DeviceQuery {
  glm::vec4 roughnessNoVLight, slots, F0, diffuse;
};
struct Sums {
  glm::vec4 specular, specularBlack, white, diffuse, scattered;
};

}  // namespace

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

std::vector<ModelIntegral> ModelIntegrals::evaluate(std::span<const IntegralQuery> queries) const {
  const Nodes nodes = makeNodes(options_.polar, options_.quarter);
  const size_t polarCount = nodes.polar.size();
  const std::array<float, 4>& slots = setting_.slots;
  const Diagnostics faults = tables_->apply(setting_, program_);
  GLINT_CHECK(faults.empty(), "{}", faults[0].text());
  const gl::Buffer polar = gl::createBuffer(std::as_bytes(std::span(nodes.polar)));
  const gl::Buffer around = gl::createBuffer(std::as_bytes(std::span(nodes.around)));
  std::vector<ModelIntegral> integrals(queries.size());
  program_.use();
  for (size_t begin = 0; begin < queries.size(); begin += kQueriesAtOnce) {
    const auto batch = queries.subspan(begin, std::min(kQueriesAtOnce, queries.size() - begin));
    std::vector<DeviceQuery> packed;
    for (const IntegralQuery& q : batch)
      packed.push_back({{q.roughness, q.NoV, q.analyticLight ? 1.f : 0.f, 0},
                        {slots[0], slots[1], slots[2], slots[3]},
                        {q.F0, 0},
                        {q.diffuseColor, 0}});
    std::vector<Sums> sums(batch.size() * polarCount);
    const gl::Buffer in = gl::createBuffer(std::as_bytes(std::span(packed)));
    const gl::Buffer out = gl::createBuffer(std::as_bytes(std::span(sums)));
    program_.set("count", static_cast<int>(sums.size()));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, polar.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, around.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, out.id());
    glDispatchCompute(static_cast<GLuint>((sums.size() + kGroup - 1) / kGroup), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(sums.size() * sizeof(Sums)), sums.data());
    for (size_t i = 0; i < sums.size(); ++i) {
      ModelIntegral& integral = integrals[begin + i / polarCount];
      const size_t node = i % polarCount;
      integral.specular += nodes.specular[node] * glm::dvec3(sums[i].specular);
      integral.specularBlack += nodes.specular[node] * glm::dvec3(sums[i].specularBlack);
      integral.white += nodes.specular[node] * glm::dvec3(sums[i].white);
      integral.diffuse += nodes.diffuse[node] * glm::dvec3(sums[i].diffuse);
      integral.scattered += 4 * nodes.diffuse[node] * glm::dvec3(sums[i].scattered);
      integral.distribution += nodes.distribution[node] * sums[i].specular.w;
      integral.projected += nodes.distribution[node] * sums[i].specularBlack.w;
    }
  }
  return integrals;
}

double ModelIntegrals::averageAlbedo(float roughness, bool analyticLight) const {
  std::vector<IntegralQuery> queries;
  std::vector<double> weights;
  // Squared nodes: directional albedos of smooth lobes change fastest where the view grazes.
  for (const QuadratureNode& node : gaussLegendre(24)) {
    queries.push_back({roughness, static_cast<float>(node.x * node.x), analyticLight});
    weights.push_back(2 * node.x * node.x * 2 * node.x * node.weight);
  }
  const std::vector<ModelIntegral> integrals = evaluate(queries);
  double sum = 0;
  for (size_t i = 0; i < integrals.size(); ++i) sum += weights[i] * integrals[i].specular.g;
  return sum;
}

}  // namespace glint
