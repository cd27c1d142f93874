#include "app/analysis/plot_colors.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/image_io.h"

namespace glint {
namespace {

// OKLab of a display-referred colour: Ottosson 2020, A perceptual color space for image processing.
glm::dvec3 labOf(const glm::dvec3& display) {
  glm::dvec3 c;
  for (int k = 0; k < 3; ++k) c[k] = linearFromSrgb(static_cast<float>(std::clamp(display[k], 0.0, 1.0)));
  const double l = std::cbrt(0.4122214708 * c.r + 0.5363325363 * c.g + 0.0514459929 * c.b);
  const double m = std::cbrt(0.2119034982 * c.r + 0.6806995451 * c.g + 0.1073969566 * c.b);
  const double s = std::cbrt(0.0883024619 * c.r + 0.2817188376 * c.g + 0.6299787005 * c.b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

glm::dvec3 displayOf(const glm::dvec3& lab) {
  const double l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3);
  const double m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3);
  const double s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3);
  const glm::dvec3 linear{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  glm::dvec3 display;
  for (int k = 0; k < 3; ++k) display[k] = srgbFromLinear(static_cast<float>(std::clamp(linear[k], 0.0, 1.0)));
  return display;
}

PlotColor bytes(const glm::dvec3& display) {
  const auto byte = [](double x) { return static_cast<uint8_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255)); };
  return {byte(display.r), byte(display.g), byte(display.b), 255};
}
glm::dvec3 unbytes(PlotColor c) { return glm::dvec3(c.r, c.g, c.b) / 255.0; }

glm::dvec3 visible(glm::dvec3 lab, bool darkGround) {
  lab.x = darkGround ? std::clamp(lab.x, 0.68, 0.9) : std::clamp(lab.x, 0.35, 0.64);
  return lab;
}

glm::dvec3 turned(const glm::dvec3& lab, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  // A grey has no hue to turn: it is given one.
  const double chroma = std::max(std::hypot(lab.y, lab.z), degrees == 0 ? 0.0 : 0.12);
  const double hue = std::atan2(lab.z, lab.y) + angle;
  return {lab.x, chroma * std::cos(hue), chroma * std::sin(hue)};
}

}  // namespace

double colorDistance(PlotColor a, PlotColor b) { return glm::distance(labOf(unbytes(a)), labOf(unbytes(b))); }

std::vector<PlotColor> distinctColors(std::span<const std::array<float, 3>> wanted, bool darkGround) {
  constexpr double kApart = 0.12;
  std::vector<PlotColor> chosen;
  for (const auto& color : wanted) {
    const glm::dvec3 lab = visible(labOf({color[0], color[1], color[2]}), darkGround);
    PlotColor best{};
    double bestDistance = -1;
    // The nearest hue that is apart from all; where there is none, the one that is furthest.
    for (const double turn : {0.0, 40.0, -40.0, 80.0, -80.0, 120.0, -120.0, 160.0, -160.0})
      for (const double lighter : {0.0, darkGround ? 0.1 : -0.12}) {
        const PlotColor candidate = bytes(displayOf(visible(turned(lab, turn) + glm::dvec3(lighter, 0, 0), darkGround)));
        double nearest = 1;
        for (const PlotColor& other : chosen) nearest = std::min(nearest, colorDistance(candidate, other));
        if (bestDistance >= kApart || nearest <= bestDistance) continue;
        best = candidate;
        bestDistance = nearest;
      }
    chosen.push_back(best);
  }
  return chosen;
}

std::vector<PlotColor> colorRamp(const std::array<float, 3>& color, size_t count, bool darkGround) {
  const glm::dvec3 lab = labOf({color[0], color[1], color[2]});
  std::vector<PlotColor> ramp;
  for (size_t i = 0; i < count; ++i) {
    const double t = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.5;
    // Hue and lightness both change, so that neighbours differ even where lines are thin.
    glm::dvec3 step = turned(lab, 130 * t - 20);
    step.x = darkGround ? 0.9 - 0.25 * t : 0.44 + 0.24 * t;
    ramp.push_back(bytes(displayOf(step)));
  }
  return ramp;
}

}  // namespace glint
