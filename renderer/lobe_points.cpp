#include "renderer/lobe_points.h"

#include <cmath>
#include <numbers>

#include "renderer/quadrature.h"

namespace glint {
namespace {

using std::numbers::pi;

constexpr int kPolar = 48, kAround = 32;

struct HalfVector {
  glm::dvec3 h;
  double sin2, weight;  // solid angle
};

// As in model_integrals.cpp.
const std::vector<HalfVector>& halfVectors() {
  static const std::vector<HalfVector> vectors = [] {
    constexpr double kSmallest = 1e-3;
    const double k = std::log1p(0.5 * pi / kSmallest);
    std::vector<HalfVector> made;
    for (const QuadratureNode& node : gaussLegendre(kPolar)) {
      const double theta = kSmallest * std::expm1(k * node.x), sin = std::sin(theta);
      for (int j = 0; j < kAround; ++j) {
        const double phi = 2 * pi * (j + 0.5) / kAround;
        made.push_back({{sin * std::cos(phi), sin * std::sin(phi), std::cos(theta)}, sin * sin,
                        2 * pi / kAround * sin * (theta + kSmallest) * k * node.weight});
      }
    }
    return made;
  }();
  return vectors;
}

}  // namespace

void addLobePoints(const glm::dvec3& view, float roughness, float F0, bool analyticLight, std::vector<ProbePoint>& points,
                   std::vector<LobeDirection>& directions) {
  static_assert(kPolar * kAround == kLobePoints);
  for (const HalfVector& half : halfVectors()) {
    const double VoH = glm::dot(view, half.h);
    const glm::dvec3 light = 2 * VoH * half.h - view;
    const bool seen = VoH > 0 && light.z > 0;
    ProbePoint p = seen ? ProbePoint::at(light, view) : ProbePoint{};
    if (seen) p.sinH2 = static_cast<float>(half.sin2);
    p.roughness = roughness;
    p.F0 = glm::vec3(F0);
    p.diffuseColor = glm::vec3(0);
    p.metallic = 1;
    p.analyticLight = analyticLight;
    points.push_back(p);
    directions.push_back({seen ? light : glm::dvec3(0, 0, 1), seen ? half.weight * 4 * VoH * light.z : 0});
  }
}

}  // namespace glint
