#include "renderer/model_tables.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "materials/base/check.h"
#include "materials/base/hash.h"
#include "renderer/disk_cache.h"
#include "renderer/model_integrals.h"
#include "renderer/parallel.h"
#include "renderer/quadrature.h"
#include "renderer/shader_assembler.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

using std::numbers::pi;

// Part of every key on disk: raise it when what is stored changes its meaning.
constexpr uint64_t kCacheVersion = 2;
constexpr GLuint kAreasUnit = 13, kLossesUnit = 14, kReflectancesUnit = 15;

// As shaders/common/model_tables.glsl has them.
constexpr double kSmallestCosine = 1e-4, kSmallestRoughness = 0.022360679774997897, kSmooth = 1.0 / 30;

uint64_t recipeHash() {
  uint64_t h = kCacheVersion;
  for (const char* file : {"shaders/passes/distribution.comp", "shaders/passes/model_integrals.comp", "shaders/common/shading.glsl"})
    h = hashText(shipped::read(file).value_or(""), h);
  return h;
}

// Polar angles of half vectors, as dense for every width of a lobe; weights of the angle itself.
std::vector<QuadratureNode> polarAngles(int count) {
  constexpr double kSmallest = 1e-4;
  const double k = std::log1p(0.5 * pi / kSmallest);
  std::vector<QuadratureNode> nodes = gaussLegendre(count);
  for (QuadratureNode& n : nodes) {
    const double theta = kSmallest * std::expm1(k * n.x);
    n = {theta, (theta + kSmallest) * k * n.weight};
  }
  return nodes;
}

class Distribution {
 public:
  static Result<Distribution> of(const ModelSetting& setting) {
    auto program = gl::buildProgram(setting.shader->model->file.string(),
                                    {{GL_COMPUTE_SHADER, assembleShader({"shaders/passes/distribution.comp", {}, {{"model", setting.shader->glsl}}})}});
    if (!program) return modelErrors(*setting.shader->model, program.diagnostics()[0].what);
    setting.apply(*program);
    Distribution made;
    made.program_ = std::move(*program);
    return made;
  }

  // By roughness, then polar angle, then azimuth.
  std::vector<float> at(std::span<const double> roughnesses, std::span<const QuadratureNode> polar, std::span<const double> azimuths) const {
    constexpr int kGroup = 64;
    std::vector<glm::vec4> halfVectors;
    for (const QuadratureNode& n : polar)
      for (const double phi : azimuths) {
        const double sine = std::sin(n.x);
        halfVectors.emplace_back(sine * std::cos(phi), sine * std::sin(phi), std::cos(n.x), sine * sine);
      }
    const std::vector<float> rows(roughnesses.begin(), roughnesses.end());
    std::vector<float> values(rows.size() * halfVectors.size());
    const gl::Buffer in = gl::createBuffer(std::as_bytes(std::span(halfVectors))), rough = gl::createBuffer(std::as_bytes(std::span(rows))),
                     out = gl::createBuffer(std::as_bytes(std::span(values)));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, rough.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, out.id());
    program_.use();
    glDispatchCompute(static_cast<GLuint>((values.size() + kGroup - 1) / kGroup), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(values.size() * sizeof(float)), values.data());
    return values;
  }

 private:
  gl::Program program_;
};

// The integral over all azimuths of max(-v.h, 0), where a = cos cos and b = sin sin of the two polar angles: what the
// projected area is more than the cosine, so that nothing cancels for smooth surfaces.
double turnedAway(double a, double b) {
  if (b <= a) return 0;
  return 2 * (std::sqrt(b * b - a * a) - a * std::acos(a / b));
}

bool sameAllAround(std::span<const float> values, size_t azimuths) {
  for (size_t i = 0; i < values.size(); i += azimuths) {
    const auto [low, high] = std::minmax_element(values.begin() + static_cast<long>(i), values.begin() + static_cast<long>(i + azimuths));
    if (*high - *low > 1e-3f * *high + 1e-6f) return false;
  }
  return true;
}

ProjectedAreaTable aroundTheNormal(const Distribution& D, std::span<const double> roughnesses, std::span<const double> cosines) {
  const std::vector<QuadratureNode> polar = polarAngles(256);
  const double azimuth[] = {0.3};
  const std::vector<float> values = D.at(roughnesses, polar, azimuth);
  std::vector<double> kernel;
  for (const double c : cosines) {
    const double sine = std::sqrt((1 - c) * (1 + c));
    for (const QuadratureNode& n : polar)
      kernel.push_back(turnedAway(std::cos(n.x) * c, std::sin(n.x) * sine) * std::sin(n.x) * n.weight);
  }
  ProjectedAreaTable table;
  for (size_t r = 0; r < roughnesses.size(); ++r)
    for (size_t c = 0; c < cosines.size(); ++c) {
      double sum = 0;
      for (size_t i = 0; i < polar.size(); ++i) sum += static_cast<double>(values[r * polar.size() + i]) * kernel[c * polar.size() + i];
      table.excess.push_back(static_cast<float>(sum));
    }
  return table;
}

// For a D that mirrors in both of the tangent frame's planes, as all do that are stretched along an axis.
ProjectedAreaTable byAzimuth(const Distribution& D, std::span<const double> roughnesses, std::span<const double> cosines) {
  constexpr size_t kPolar = 96, kQuarter = 24;
  const std::vector<QuadratureNode> polar = polarAngles(kPolar);
  std::vector<double> azimuths;
  for (size_t j = 0; j < kQuarter; ++j) azimuths.push_back(0.5 * pi * (static_cast<double>(j) + 0.5) / kQuarter);
  const std::vector<float> values = D.at(roughnesses, polar, azimuths);
  std::vector<glm::dvec2> around;
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0})
      for (const double phi : azimuths) around.emplace_back(sx * std::cos(phi), sy * std::sin(phi));
  ProjectedAreaTable table;
  table.layers = ProjectedAreaTable::kLayers;
  const size_t layerSize = roughnesses.size() * cosines.size();
  table.excess.resize(layerSize * static_cast<size_t>(table.layers));
  parallelFor(roughnesses.size(), [&](size_t r) {
    for (size_t layer = 0; layer < static_cast<size_t>(table.layers); ++layer) {
      const double cos2 = static_cast<double>(layer) / (table.layers - 1);
      const glm::dvec2 side(std::sqrt(cos2), std::sqrt(1 - cos2));
      std::vector<double> along;
      for (const glm::dvec2& a : around) along.push_back(glm::dot(a, side));
      for (size_t c = 0; c < cosines.size(); ++c) {
        const double sine = std::sqrt((1 - cosines[c]) * (1 + cosines[c]));
        double sum = 0;
        for (size_t i = 0; i < kPolar; ++i) {
          const double a = std::cos(polar[i].x) * cosines[c], b = std::sin(polar[i].x) * sine;
          if (b <= a) continue;
          const float* row = &values[(r * kPolar + i) * kQuarter];
          double ring = 0;
          for (size_t j = 0; j < around.size(); ++j) ring += static_cast<double>(row[j % kQuarter]) * std::max(-a - b * along[j], 0.0);
          sum += ring * std::sin(polar[i].x) * polar[i].weight * 2 * pi / static_cast<double>(around.size());
        }
        table.excess[layer * layerSize + r * cosines.size() + c] = static_cast<float>(sum);
      }
    }
  });
  return table;
}

// The weights of the values at tableCosines() for 2 times the integral of their linear interpolation times the cosine, as
// the shader interpolates them.
std::vector<double> averageWeights(int count) {
  const double step = std::log1p(1 / kSmallestCosine) / (count - 1);
  std::vector<double> weights(static_cast<size_t>(count), 0.0);
  const std::vector<QuadratureNode> nodes = gaussLegendre(8);
  for (size_t i = 0; i + 1 < weights.size(); ++i)
    for (const QuadratureNode& n : nodes) {
      const double grown = kSmallestCosine * std::exp((static_cast<double>(i) + n.x) * step), cosine = grown - kSmallestCosine;
      const double weight = 2 * cosine * grown * step * n.weight;
      weights[i] += (1 - n.x) * weight;
      weights[i + 1] += n.x * weight;
    }
  return weights;
}

double largest(const glm::dvec3& v) { return std::max({v.r, v.g, v.b}); }

// One half of a LossTable from the integrals at its roughnesses and cosines.
void addLosses(std::span<const ModelIntegral> integrals, bool followsF0, LossTable& table, size_t texel) {
  constexpr size_t kRow = LossTable::kCosines;
  const std::vector<double> weights = averageWeights(LossTable::kCosines);
  for (size_t r = 0; r < integrals.size() / kRow; ++r) {
    double meanLoss = 0, white = 0;
    glm::dvec3 specular(0), black(0);
    bool sound = true;
    for (size_t c = 0; c < kRow; ++c) {
      const ModelIntegral& i = integrals[r * kRow + c];
      const double E = largest(i.white);
      white += weights[c] * E;
      specular += weights[c] * i.specular;
      black += weights[c] * i.specularBlack;
      sound &= std::isfinite(E + largest(i.specular) + largest(i.specularBlack));
    }
    const bool known = sound && white > 1e-3 && (!followsF0 || largest(specular - black) > 0.05 * white);
    for (size_t c = 0; c < kRow; ++c) {
      const double loss = known ? std::clamp(1 - largest(integrals[r * kRow + c].white), 0.0, 1.0) : 0.0;
      table.losses.push_back(static_cast<float>(loss));
      meanLoss += weights[c] * loss;
    }
    glm::vec4* row = &table.reflectances[4 * r + texel];
    row[0] = known ? glm::vec4((specular - black) / white, meanLoss) : glm::vec4(0);
    row[1] = known ? glm::vec4(black / white, 0) : glm::vec4(0);
  }
}

constexpr size_t kAreaLayer = size_t{ProjectedAreaTable::kCosines} * ProjectedAreaTable::kRoughnesses;

gl::Texture layeredTexture(int width, int height, int layers, const float* values) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id);
  gl::Texture texture(id);
  glTextureStorage3D(id, 1, GL_R32F, width, height, layers);
  glTextureSubImage3D(id, 0, 0, 0, 0, width, height, layers, GL_RED, GL_FLOAT, values);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

std::vector<double> tableCosines(int count) {
  std::vector<double> cosines;
  for (int i = 0; i < count; ++i)
    cosines.push_back(std::min(kSmallestCosine * std::expm1(std::log1p(1 / kSmallestCosine) * i / (count - 1)), 1.0));
  return cosines;
}

std::vector<double> tableRoughnesses(int count) {
  GLINT_CHECK((count - 1) % 30 == 0, "{} rows have none at the end of the smooth ones", count);
  std::vector<double> roughnesses;
  for (int i = 0; i < count; ++i) {
    const double y = static_cast<double>(i) / (count - 1);
    roughnesses.push_back(y < kSmooth ? y / kSmooth * kSmallestRoughness : std::pow(kSmallestRoughness, (1 - y) / (1 - kSmooth)));
  }
  return roughnesses;
}

Result<ProjectedAreaTable> projectedAreas(const ModelSetting& setting) {
  auto D = Distribution::of(setting);
  if (!D) return D.diagnostics();
  const std::vector<double> roughnesses = tableRoughnesses(ProjectedAreaTable::kRoughnesses), cosines = tableCosines(ProjectedAreaTable::kCosines);
  const double few[] = {0.1, 0.5, 1}, azimuths[] = {0, 0.25 * pi, 0.5 * pi, 1.2 * pi};
  return sameAllAround(D->at(few, polarAngles(32), azimuths), std::size(azimuths)) ? aroundTheNormal(*D, roughnesses, cosines)
                                                                                     : byAzimuth(*D, roughnesses, cosines);
}

Result<LossTable> losses(const ModelSetting& setting) {
  const auto integrals = ModelIntegrals::of(setting, {.compensate = false, .specularOnly = true, .polar = 48, .quarter = 8});
  if (!integrals) return integrals.diagnostics();
  std::vector<IntegralQuery> queries, some;
  for (const double roughness : tableRoughnesses(LossTable::kRoughnesses))
    for (const double cosine : tableCosines(LossTable::kCosines))
      // As safeCosine() of shading.glsl.
      queries.push_back({.roughness = static_cast<float>(roughness), .NoV = static_cast<float>(std::max(cosine, 1e-4))});
  LossTable table;
  table.reflectances.resize(4 * size_t{LossTable::kRoughnesses});
  const bool followsF0 = setting.shader->model->definesSpecular;
  const std::vector<ModelIntegral> lights = integrals->evaluate(queries);
  addLosses(lights, followsF0, table, 0);
  // Few models differ under an environment: a few values tell.
  constexpr size_t kStride = 53;
  for (IntegralQuery& q : queries) q.analyticLight = false;
  for (size_t i = 0; i < queries.size(); i += kStride) some.push_back(queries[i]);
  const std::vector<ModelIntegral> probes = integrals->evaluate(some);
  bool same = true;
  for (size_t i = 0; i < some.size(); ++i)
    same &= probes[i].white == lights[i * kStride].white && probes[i].specular == lights[i * kStride].specular;
  addLosses(same ? lights : integrals->evaluate(queries), followsF0, table, 2);
  return table;
}

Result<GLuint> ModelTables::areas(const ModelSetting& setting) {
  const uint64_t key = setting.key() ^ recipeHash();
  if (const gl::Texture* found = areas_.find(key)) return found->id();
  ProjectedAreaTable table;
  const auto stored = diskCache_ ? readCache("projected-areas", key) : std::nullopt;
  if (stored && (stored->size() == kAreaLayer * 4 || stored->size() == kAreaLayer * 4 * ProjectedAreaTable::kLayers)) {
    table.layers = static_cast<int>(stored->size() / (kAreaLayer * 4));
    table.excess.resize(stored->size() / 4);
    std::memcpy(table.excess.data(), stored->data(), stored->size());
  } else {
    const std::string what = "masking of " + setting.shader->model->title;
    if (progress_) progress_(what, 0);
    auto made = projectedAreas(setting);
    if (!made) return made.diagnostics();
    table = std::move(*made);
    if (diskCache_) writeCache("projected-areas", key, std::string(reinterpret_cast<const char*>(table.excess.data()), table.excess.size() * 4));
    if (progress_) progress_(what, 1);
  }
  return areas_.put(key, layeredTexture(ProjectedAreaTable::kCosines, ProjectedAreaTable::kRoughnesses, table.layers, table.excess.data())).id();
}

Result<const ModelTables::LossTextures*> ModelTables::bounces(const ModelSetting& setting) {
  constexpr size_t kLosses = 2 * size_t{LossTable::kCosines} * LossTable::kRoughnesses * sizeof(float),
                   kReflectances = 4 * size_t{LossTable::kRoughnesses} * sizeof(glm::vec4);
  const uint64_t key = setting.key() ^ recipeHash();
  if (const LossTextures* found = bounces_.find(key)) return found;
  LossTable table;
  if (const auto stored = diskCache_ ? readCache("losses", key) : std::nullopt; stored && stored->size() == kLosses + kReflectances) {
    table.losses.resize(kLosses / sizeof(float));
    table.reflectances.resize(kReflectances / sizeof(glm::vec4));
    std::memcpy(table.losses.data(), stored->data(), kLosses);
    std::memcpy(static_cast<void*>(table.reflectances.data()), stored->data() + kLosses, kReflectances);
  } else {
    const std::string what = "further bounces of " + setting.shader->model->title;
    if (progress_) progress_(what, 0);
    auto made = glint::losses(setting);
    if (!made) return made.diagnostics();
    table = std::move(*made);
    if (diskCache_)
      writeCache("losses", key, std::string(reinterpret_cast<const char*>(table.losses.data()), kLosses) +
                                    std::string(reinterpret_cast<const char*>(table.reflectances.data()), kReflectances));
    if (progress_) progress_(what, 1);
  }
  LossTextures textures{layeredTexture(LossTable::kCosines, LossTable::kRoughnesses, 2, table.losses.data()),
                        gl::createTexture2D(GL_RGBA32F, 4, LossTable::kRoughnesses)};
  glTextureSubImage2D(textures.reflectances.id(), 0, 0, 0, 4, LossTable::kRoughnesses, GL_RGBA, GL_FLOAT, table.reflectances.data());
  glTextureParameteri(textures.reflectances.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(textures.reflectances.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(textures.reflectances.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return &bounces_.put(key, std::move(textures));
}

Diagnostics ModelTables::apply(const ModelSetting& setting, const gl::Program& program) {
  setting.apply(program);
  if (program.location("glintAreas") >= 0) {
    const auto texture = areas(setting);
    if (!texture) return texture.diagnostics();
    glBindTextureUnit(kAreasUnit, *texture);
  }
  if (program.location("glintLosses") >= 0 || program.location("glintReflectances") >= 0) {
    const auto textures = bounces(setting);
    if (!textures) return textures.diagnostics();
    glBindTextureUnit(kLossesUnit, (*textures)->losses.id());
    glBindTextureUnit(kReflectancesUnit, (*textures)->reflectances.id());
  }
  return {};
}

void ModelTables::forgetUnused() {
  constexpr size_t kSpare = 16;
  areas_.nextFrame(kSpare);
  bounces_.nextFrame(kSpare);
}

}  // namespace glint
