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
constexpr uint64_t kCacheVersion = 5;
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

// How much of a turn around the normal each layer stands for.
std::vector<double> layerShares(int layers, double aspect) {
  constexpr int kSteps = 512;
  std::vector<double> shares(static_cast<size_t>(layers), 0.0);
  if (layers == 1) return {1.0};
  for (int i = 0; i < kSteps; ++i) {
    const double azimuth = 0.5 * pi * (i + 0.5) / kSteps;
    // As glintAcross() of shaders/common/model_tables.glsl.
    const double layer = (layers - 1) * std::atan2(std::sqrt(aspect) * std::sin(azimuth), std::cos(azimuth)) * 2 / pi;
    const size_t below = std::min(static_cast<size_t>(layer), shares.size() - 2);
    const double above = layer - static_cast<double>(below);
    shares[below] += (1 - above) / kSteps;
    shares[below + 1] += above / kSteps;
  }
  return shares;
}

// The azimuth against the tangent at `across` of glintAcross(), in radians.
double azimuthAt(double across, double aspect) { return std::atan2(std::sin(0.5 * pi * across), std::sqrt(aspect) * std::cos(0.5 * pi * across)); }

// The weights of values at `count` azimuths, even from 0 to 1, for the one at `across`: what is even about both axes is a
// series of cosines.
std::vector<double> cosineSeries(int count, double across) {
  const int last = count - 1;
  std::vector<double> weights;
  for (int j = 0; j <= last; ++j) {
    double sum = 0;
    for (int k = 0; k <= last; ++k) sum += (k == 0 || k == last ? 0.5 : 1) * std::cos(pi * k * j / last) * std::cos(pi * k * across);
    weights.push_back(2.0 / last * (j == 0 || j == last ? 0.5 : 1) * sum);
  }
  return weights;
}

ModelIntegral weighted(const ModelIntegral& a, double x) {
  ModelIntegral made;
  made.specular = x * a.specular;
  made.specularBlack = x * a.specularBlack;
  made.white = x * a.white;
  return made;
}
void add(ModelIntegral& to, const ModelIntegral& a, double x) {
  to.specular += x * a.specular;
  to.specularBlack += x * a.specularBlack;
  to.white += x * a.white;
}

// Along one axis of a table, where `stride` apart are `count` integrals and `blocks` of these axes follow each other: those
// half way between are put in, by the cubic through the nearest four. Up to the index `straight` by a line.
std::vector<ModelIntegral> twiceAsMany(const std::vector<ModelIntegral>& coarse, size_t count, size_t stride, size_t straight) {
  const size_t blocks = coarse.size() / (count * stride), fineCount = 2 * count - 1;
  std::vector<ModelIntegral> fine(blocks * fineCount * stride);
  for (size_t b = 0; b < blocks; ++b)
    for (size_t k = 0; k < stride; ++k) {
      const auto at = [&](size_t i) -> const ModelIntegral& { return coarse[(b * count + i) * stride + k]; };
      for (size_t i = 0; i < count; ++i) {
        fine[(b * fineCount + 2 * i) * stride + k] = at(i);
        if (i + 1 == count) break;
        ModelIntegral& middle = fine[(b * fineCount + 2 * i + 1) * stride + k];
        if (i < straight) {
          middle = weighted(at(i), 0.5);
          add(middle, at(i + 1), 0.5);
        } else if (i == straight || i + 2 == count) {
          const bool up = i == straight;
          middle = weighted(at(up ? i : i + 1), 5.0 / 16);
          add(middle, at(up ? i + 1 : i), 15.0 / 16);
          add(middle, at(up ? i + 2 : i - 1), -5.0 / 16);
          add(middle, at(up ? i + 3 : i - 2), 1.0 / 16);
        } else {
          middle = weighted(at(i), 9.0 / 16);
          add(middle, at(i + 1), 9.0 / 16);
          add(middle, at(i - 1), -1.0 / 16);
          add(middle, at(i + 2), -1.0 / 16);
        }
      }
    }
  return fine;
}

// One half of a LossTable, which begins at `first` of its losses and `texel` of its rows, from the integrals by layer,
// roughness and cosine.
void addLosses(std::span<const ModelIntegral> integrals, bool followsF0, std::span<const float> aspects, LossTable& table, size_t first, size_t texel) {
  constexpr size_t kRow = LossTable::kCosines;
  const std::vector<double> weights = averageWeights(LossTable::kCosines);
  const size_t rows = aspects.size(), layers = static_cast<size_t>(table.layers);
  for (size_t r = 0; r < rows; ++r) {
    const std::vector<double> shares = layerShares(table.layers, static_cast<double>(aspects[r]));
    const auto at = [&](size_t layer, size_t c) { return (layer * rows + r) * kRow + c; };
    double meanLoss = 0, white = 0;
    glm::dvec3 specular(0), black(0);
    bool sound = true;
    for (size_t layer = 0; layer < layers; ++layer)
      for (size_t c = 0; c < kRow; ++c) {
        const ModelIntegral& i = integrals[at(layer, c)];
        const double E = largest(i.white), weight = shares[layer] * weights[c];
        white += weight * E;
        specular += weight * i.specular;
        black += weight * i.specularBlack;
        sound &= std::isfinite(E + largest(i.specular) + largest(i.specularBlack));
      }
    const bool known = sound && white > 1e-3 && (!followsF0 || largest(specular - black) > 0.05 * white);
    for (size_t layer = 0; layer < layers; ++layer)
      for (size_t c = 0; c < kRow; ++c) {
        const double loss = known ? std::clamp(1 - largest(integrals[at(layer, c)].white), 0.0, 1.0) : 0.0;
        table.losses[first + at(layer, c)] = static_cast<float>(loss);
        meanLoss += shares[layer] * weights[c] * loss;
      }
    glm::vec4* row = &table.reflectances[4 * r + texel];
    row[0] = known ? glm::vec4((specular - black) / white, meanLoss) : glm::vec4(0);
    row[1] = glm::vec4(known ? glm::vec3(black / white) : glm::vec3(0), aspects[r]);
  }
}

// Of a model that does not read the roughness one row is as good as all.
int lossRows(const ShadingModel& model) { return model.reads("roughness") ? LossTable::kRoughnesses : 1; }

// Whether a few views lose the same from all sides.
bool lostAllAround(const ModelIntegrals& integrals, std::span<const float> roughnesses) {
  const double azimuths[] = {0, 0.2 * pi, 0.35 * pi, 0.5 * pi};
  std::vector<IntegralQuery> queries;
  for (size_t r = 0; r < roughnesses.size(); r += 15)
    for (const float NoV : {0.02f, 0.3f, 0.8f})
      for (const double azimuth : azimuths) queries.push_back({.roughness = roughnesses[r], .NoV = NoV, .azimuth = static_cast<float>(azimuth)});
  const std::vector<ModelIntegral> sums = integrals.evaluate(queries);
  for (size_t i = 0; i < sums.size(); ++i)
    if (!(std::abs(largest(sums[i].white) - largest(sums[i / std::size(azimuths) * std::size(azimuths)].white)) < 5e-4)) return false;
  return true;
}

constexpr size_t kAreaLayer = size_t{ProjectedAreaTable::kCosines} * ProjectedAreaTable::kRoughnesses;

// What bounces() stored; false when it is not that.
bool readLosses(const std::string& bytes, int rows, LossTable& table) {
  const size_t reflectances = 4 * static_cast<size_t>(rows) * sizeof(glm::vec4), layer = 2 * sizeof(float) * static_cast<size_t>(rows) * LossTable::kCosines;
  for (const int layers : {1, LossTable::kLayers}) {
    if (bytes.size() != reflectances + static_cast<size_t>(layers) * layer) continue;
    table.rows = rows;
    table.layers = layers;
    table.reflectances.resize(4 * static_cast<size_t>(rows));
    table.losses.resize((bytes.size() - reflectances) / sizeof(float));
    std::memcpy(static_cast<void*>(table.reflectances.data()), bytes.data(), reflectances);
    std::memcpy(table.losses.data(), bytes.data() + reflectances, bytes.size() - reflectances);
    return true;
  }
  return false;
}

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
  const ShadingModel& model = *setting.shader->model;
  const auto integrals = ModelIntegrals::of(setting, {.compensate = false, .specularOnly = true, .polar = 48, .quarter = model.usesTangent ? 14 : 8});
  if (!integrals) return integrals.diagnostics();
  LossTable table;
  table.rows = lossRows(model);
  std::vector<float> roughnesses;
  for (const double r : tableRoughnesses(LossTable::kRoughnesses)) roughnesses.push_back(static_cast<float>(r));
  roughnesses.resize(static_cast<size_t>(table.rows));
  const std::vector<float> aspects = integrals->aspects(roughnesses);
  // By layer, roughness and cosine. Every second cosine is asked for: a smooth curve through them is as good as more, which
  // lines between them, as textures have, are not. From several sides it is every fourth, and every second roughness: their
  // number makes up for it.
  constexpr int kAsked = 7;
  const bool allAround = !model.usesTangent || lostAllAround(*integrals, roughnesses);
  table.layers = allAround ? 1 : LossTable::kLayers;
  const size_t step = allAround ? 1 : 2, rows = (roughnesses.size() - 1) / step + 1, columnStep = 2 * step, columns = (LossTable::kCosines - 1) / columnStep + 1;
  const std::vector<double> cosines = tableCosines(LossTable::kCosines);
  const auto evaluate = [&](bool light, size_t stride) {
    std::vector<IntegralQuery> queries;
    for (size_t i = 0; i < (allAround ? 1 : kAsked) * rows * columns; i += stride) {
      const size_t r = i / columns % rows * step;
      const double across = static_cast<double>(i / columns / rows) / (kAsked - 1);
      queries.push_back({.roughness = roughnesses[r],
                         .NoV = static_cast<float>(std::max(cosines[i % columns * columnStep], 1e-4)),  // as safeCosine() of shading.glsl
                         .analyticLight = light,
                         .azimuth = static_cast<float>(azimuthAt(across, static_cast<double>(aspects[r])))});
    }
    return integrals->evaluate(queries);
  };
  const auto whole = [&](std::vector<ModelIntegral> asked) {
    for (size_t have = columns; have < LossTable::kCosines; have = 2 * have - 1) asked = twiceAsMany(asked, have, 1, 0);
    if (allAround) return asked;
    // The floor of alpha is a corner, at the second of these rows.
    if (rows > 1) asked = twiceAsMany(asked, rows, LossTable::kCosines, 1);
    const size_t layer = asked.size() / kAsked;
    std::vector<ModelIntegral> all(layer * LossTable::kLayers);
    for (int to = 0; to < LossTable::kLayers; ++to) {
      const std::vector<double> weights = cosineSeries(kAsked, static_cast<double>(to) / (LossTable::kLayers - 1));
      for (size_t from = 0; from < kAsked; ++from)
        for (size_t i = 0; i < layer; ++i) add(all[static_cast<size_t>(to) * layer + i], asked[from * layer + i], weights[from]);
    }
    return all;
  };
  table.losses.resize(2 * static_cast<size_t>(table.layers) * roughnesses.size() * LossTable::kCosines);
  table.reflectances.resize(4 * roughnesses.size());
  const bool followsF0 = model.definesSpecular;
  const std::vector<ModelIntegral> lights = evaluate(true, 1), lightsWhole = whole(lights);
  addLosses(lightsWhole, followsF0, aspects, table, 0, 0);
  // Few models differ under an environment: a few values tell.
  constexpr size_t kStride = 53;
  const std::vector<ModelIntegral> some = evaluate(false, kStride);
  bool same = true;
  for (size_t i = 0; i < some.size(); ++i) same &= some[i].white == lights[i * kStride].white && some[i].specular == lights[i * kStride].specular;
  addLosses(same ? lightsWhole : whole(evaluate(false, 1)), followsF0, aspects, table, table.losses.size() / 2, 2);
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
  const uint64_t key = setting.key() ^ recipeHash();
  if (const LossTextures* found = bounces_.find(key)) return found;
  LossTable table;
  if (const auto stored = diskCache_ ? readCache("losses", key) : std::nullopt; !stored || !readLosses(*stored, lossRows(*setting.shader->model), table)) {
    const std::string what = "further bounces of " + setting.shader->model->title;
    if (progress_) progress_(what, 0);
    auto made = glint::losses(setting);
    if (!made) return made.diagnostics();
    table = std::move(*made);
    if (diskCache_)
      writeCache("losses", key, std::string(reinterpret_cast<const char*>(table.reflectances.data()), table.reflectances.size() * sizeof(glm::vec4)) +
                                    std::string(reinterpret_cast<const char*>(table.losses.data()), table.losses.size() * sizeof(float)));
    if (progress_) progress_(what, 1);
  }
  LossTextures textures{layeredTexture(LossTable::kCosines, table.rows, 2 * table.layers, table.losses.data()), gl::createTexture2D(GL_RGBA32F, 4, table.rows)};
  glTextureSubImage2D(textures.reflectances.id(), 0, 0, 0, 4, table.rows, GL_RGBA, GL_FLOAT, table.reflectances.data());
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
