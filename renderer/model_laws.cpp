#include "renderer/model_laws.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kPolar = 64, kAround = 96;

struct Node {
  double x, weight;
};

// Gauss-Legendre on (0, 1), by Newton's method from the usual first guess.
std::vector<Node> gaussLegendre(int count) {
  std::vector<Node> nodes(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (count + 0.5)), slope = 1;
    for (int step = 0; step < 50; ++step) {
      double p0 = 1, p1 = x;
      for (int k = 2; k <= count; ++k) p0 = std::exchange(p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k);
      slope = count * (x * p1 - p0) / (x * x - 1);
      const double move = p1 / slope;
      x -= move;
      if (std::abs(move) < 1e-15) break;
    }
    nodes[static_cast<size_t>(i)] = {0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)};
  }
  return nodes;
}

// Half vectors where a lobe of this width is: tan(theta) = alpha tan(psi), psi spread evenly. `weight` is the
// solid angle.
struct HalfVector {
  glm::dvec3 h;
  double sin2, weight;
};
std::vector<HalfVector> halfVectors(double roughness) {
  static const std::vector<Node> nodes = gaussLegendre(kPolar);
  const double alpha = std::max(roughness * roughness, 1e-3);
  std::vector<HalfVector> result;
  for (const Node& node : nodes) {
    const double t = std::tan(0.5 * kPi * node.x), tan = alpha * t;
    const double cos = 1 / std::sqrt(1 + tan * tan), sin = tan * cos;
    const double dTheta = alpha * (1 + t * t) / (1 + tan * tan) * 0.5 * kPi * node.weight;
    for (int j = 0; j < kAround; ++j) {
      const double phi = 2 * kPi * (j + 0.5) / kAround;
      result.push_back({{sin * std::cos(phi), sin * std::sin(phi), cos}, sin * sin,
                        sin * dTheta * 2 * kPi / kAround});
    }
  }
  return result;
}

void makeWhite(ProbePoint& point, float roughness, bool analyticLight) {
  point.roughness = roughness;
  point.F0 = point.diffuseColor = point.baseColor = glm::vec3(1);
  point.metallic = 1;
  point.analyticLight = analyticLight;
}

glm::dvec3 direction(double cosine, double azimuth) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

const float kRoughness[] = {0, 0.02f, 0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1};

// Pairs of directions over the hemispheres, with the cases that divide by zero where a model is careless.
struct Pair {
  glm::dvec3 light, view;
};
std::vector<Pair> directionPairs() {
  const double cosines[] = {1e-7, 1e-3, 0.02, 0.1, 0.35, 0.7, 0.95, 1};
  std::vector<Pair> pairs;
  for (const double l : cosines)
    for (const double v : cosines)
      for (const double azimuth : {0.0, 1.1, 2.6, kPi}) pairs.push_back({direction(l, azimuth), direction(v, 0)});
  return pairs;
}

std::string at(float roughness, const ProbePoint& p) {
  return fmt::format("roughness {}, NoL {:.4g}, NoV {:.4g}", roughness, p.light.z, p.view.z);
}

struct Checker {
  const ShadingModel& model;
  ModelProbe& probe;
  std::string setting;  // "gamma 4" when a parameter is not at its default
  Diagnostics& problems;

  void broken(const std::string& what, const std::string& hint) {
    const std::string text = what + (setting.empty() ? "" : " (" + setting + ")");
    problems.push_back(error(model.file.string(), text, hint));
  }

  void values() {
    const std::vector<Pair> pairs = directionPairs();
    std::vector<ProbePoint> points;
    for (const bool light : {true, false})
      for (const float roughness : kRoughness)
        for (const float F0 : {0.f, 0.04f, 1.f})
          for (const Pair& pair : pairs)
            for (const bool swapped : {false, true}) {
              ProbePoint p = ProbePoint::at(swapped ? pair.view : pair.light, swapped ? pair.light : pair.view);
              p.fromDirections = true;
              p.roughness = roughness;
              p.F0 = glm::vec3(F0);
              p.analyticLight = light;
              points.push_back(p);
            }
    const std::vector<glm::vec4> out = probe.evaluate(points);
    bool finite = true, positive = true;
    double worst = 0;
    size_t worstAt = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      for (const glm::vec4& v : {out[2 * i], out[2 * i + 1]})
        for (int c = 0; c < 4; ++c) {
          if (finite && !std::isfinite(v[c])) {
            broken("is not finite at " + at(points[i].roughness, points[i]), "guard a division or a power");
            finite = false;
          } else if (positive && v[c] < 0) {
            broken(fmt::format("is negative, {:.4g}, at {}", v[c], at(points[i].roughness, points[i])),
                   "light cannot be taken away: clamp the term that turns");
            positive = false;
          }
        }
      if (i % 2) continue;
      for (int part = 0; part < 2; ++part)
        for (int c = 0; c < 3; ++c) {
          const double a = out[2 * i + static_cast<size_t>(part)][c], b = out[2 * i + 2 + static_cast<size_t>(part)][c];
          const double difference = std::abs(a - b) / std::max({a, b, 1e-3});
          if (difference > worst) {
            worst = difference;
            worstAt = i;
          }
        }
    }
    if (finite && model.claims.reciprocal && worst > 1e-3)
      broken(fmt::format("is not reciprocal as it claims: swapping light and view changes it by {:.3g} % at {}",
                         100 * worst, at(points[worstAt].roughness, points[worstAt])),
             "drop the claim or mend the formula");
  }

  void energy() {
    if (!model.claims.energyConserving) return;
    std::vector<AlbedoQuery> queries;
    for (const bool light : {true, false})
      for (const float roughness : {0.05f, 0.15f, 0.3f, 0.5f, 0.75f, 1.f})
        for (const float NoV : {0.02f, 0.05f, 0.2f, 0.5f, 1.f}) queries.push_back({roughness, NoV, light});
    const std::vector<Albedo> albedos = directionalAlbedo(probe, queries);
    size_t worst = 0;
    const auto most = [&](size_t i) { return std::max(albedos[i].specular, albedos[i].diffuse); };
    for (size_t i = 0; i < albedos.size(); ++i)
      if (most(i) > most(worst)) worst = i;
    if (!(most(worst) <= 1.003))
      broken(fmt::format("does not conserve energy as it claims: the {} part reflects {:.4g} times what it receives "
                         "at roughness {}, NoV {}",
                         albedos[worst].specular > albedos[worst].diffuse ? "specular" : "diffuse", most(worst),
                         queries[worst].roughness, queries[worst].NoV),
             "drop the claim or mend the formula");
  }

  void distribution() {
    if (!model.definesD && model.termD.empty()) return;
    const float roughness[] = {0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 1.f};
    const std::vector<double> integrals = integralOfD(probe, roughness);
    size_t worst = 0;
    for (size_t i = 0; i < integrals.size(); ++i)
      if (!(std::abs(integrals[i] - 1) <= std::abs(integrals[worst] - 1))) worst = i;
    if (!(std::abs(integrals[worst] - 1) <= 5e-3))
      broken(fmt::format("D integrates to {:.4g} at roughness {}, not to 1", integrals[worst], roughness[worst]),
             "the integral of D (n.h) over the hemisphere must be 1: check its factor, 1/pi included");
  }
};

}  // namespace

std::vector<Albedo> directionalAlbedo(const ModelProbe& probe, std::span<const AlbedoQuery> queries) {
  std::vector<ProbePoint> points;
  std::vector<double> weights;
  std::vector<size_t> owner;
  for (size_t q = 0; q < queries.size(); ++q) {
    const glm::dvec3 view = direction(queries[q].NoV, 0);
    for (const HalfVector& half : halfVectors(queries[q].roughness)) {
      const double VoH = glm::dot(view, half.h);
      const glm::dvec3 light = 2 * VoH * half.h - view;
      if (VoH <= 0 || light.z <= 0) continue;
      ProbePoint p = ProbePoint::at(light, view);
      p.sinH2 = static_cast<float>(half.sin2);
      makeWhite(p, queries[q].roughness, queries[q].analyticLight);
      points.push_back(p);
      weights.push_back(half.weight * 4 * VoH * light.z);
      owner.push_back(q);
    }
  }
  const std::vector<glm::vec4> out = probe.evaluate(points);
  std::vector<Albedo> result(queries.size());
  for (size_t i = 0; i < points.size(); ++i) {
    result[owner[i]].specular += out[2 * i].g * weights[i];
    result[owner[i]].diffuse += out[2 * i + 1].g * weights[i];
  }
  return result;
}

std::vector<double> integralOfD(const ModelProbe& probe, std::span<const float> roughness) {
  std::vector<ProbePoint> points;
  std::vector<double> weights;
  for (const float r : roughness)
    for (const HalfVector& half : halfVectors(r)) {
      // Looking along the half vector itself, as the environment's prefilter does.
      ProbePoint p = ProbePoint::at(half.h, half.h);
      p.sinH2 = static_cast<float>(half.sin2);
      makeWhite(p, r, true);
      points.push_back(p);
      weights.push_back(half.weight * half.h.z);
    }
  const std::vector<glm::vec4> out = probe.evaluate(points);
  std::vector<double> result(roughness.size());
  for (size_t i = 0; i < points.size(); ++i) result[i / (kPolar * kAround)] += out[2 * i].a * weights[i];
  return result;
}

Diagnostics checkLaws(const ShadingModel& model) {
  auto probe = ModelProbe::ofModel(model);
  if (!probe) return probe.diagnostics();
  Diagnostics problems;
  Checker checker{model, *probe, "", problems};
  const auto all = [&] {
    checker.values();
    checker.energy();
    checker.distribution();
  };
  all();
  for (const ModelParameter& p : model.parameters) {
    for (const float end : {p.minimum, p.maximum}) {
      Value value = p.standard;
      value.v.fill(end);
      probe->set(p.name, value);
      checker.setting = fmt::format("{} {}", p.name, end);
      all();
    }
    probe->set(p.name, p.standard);
  }
  return problems;
}

}  // namespace glint
