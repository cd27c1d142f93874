// "sky": a clear sky with a sun and a ground.
//
// A. J. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999: the sky's
// luminance and chromaticity are Perez functions of the angles to the zenith and the sun (eq. 3 and 4), with the
// coefficients of its appendix A.2, linear in the turbidity.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/environment.h"
#include "renderer/parallel.h"

namespace glint {
namespace {

constexpr float kTurbidity = 2.8f;   // clear air

// One Perez function F(theta, gamma) = (1 + A e^(B / cos theta)) (1 + C e^(D gamma) + E cos^2 gamma).
struct Perez {
  float a, b, c, d, e;
  float operator()(float cosTheta, float gamma, float cosGamma) const {
    return (1 + a * std::exp(b / cosTheta)) * (1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma);
  }
};

constexpr float kT = kTurbidity;
constexpr Perez kLuminance{0.1787f * kT - 1.4630f, -0.3554f * kT + 0.4275f, -0.0227f * kT + 5.3251f,
                           0.1206f * kT - 2.5771f, -0.0670f * kT + 0.3703f};
constexpr Perez kX{-0.0193f * kT - 0.2592f, -0.0665f * kT + 0.0008f, -0.0004f * kT + 0.2125f,
                   -0.0641f * kT - 0.8989f, -0.0033f * kT + 0.0452f};
constexpr Perez kY{-0.0167f * kT - 0.2608f, -0.0950f * kT + 0.0092f, -0.0079f * kT + 0.2102f,
                   -0.0441f * kT - 1.6537f, -0.0109f * kT + 0.0529f};

// Chromaticity at the zenith: a cubic in the sun's angle from it with coefficients quadratic in turbidity.
float zenith(const std::array<std::array<float, 4>, 3>& m, float sun) {
  float sum = 0;
  const float turbidity[3] = {kT * kT, kT, 1}, angle[4] = {sun * sun * sun, sun * sun, sun, 1};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 4; ++j) sum += turbidity[i] * m[i][j] * angle[j];
  return sum;
}

// CIE xyY to linear Rec.709 (IEC 61966-2-1). Blue sky lies a little outside that gamut: clamped.
glm::vec3 rec709(float x, float y, float luminance) {
  const float X = luminance * x / y, Z = luminance * (1 - x - y) / y;
  return glm::max(glm::vec3(3.2406f * X - 1.5372f * luminance - 0.4986f * Z,
                            -0.9689f * X + 1.8758f * luminance + 0.0415f * Z,
                            0.0557f * X - 0.2040f * luminance + 1.0570f * Z),
                  glm::vec3(0));
}

class Sky {
 public:
  explicit Sky(float sunElevation) {
    const float elevation = glm::radians(sunElevation), azimuth = glm::radians(38.0f);
    toSun_ = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
    const float sun = glm::half_pi<float>() - elevation;
    zenithX_ = zenith({{{0.00166f, -0.00375f, 0.00209f, 0}, {-0.02903f, 0.06377f, -0.03202f, 0.00394f},
                        {0.11693f, -0.21196f, 0.06052f, 0.25886f}}}, sun);
    zenithY_ = zenith({{{0.00275f, -0.00610f, 0.00317f, 0}, {-0.04214f, 0.08970f, -0.04153f, 0.00516f},
                        {0.15346f, -0.26756f, 0.06670f, 0.26688f}}}, sun);
    const float cosSun = std::cos(sun);
    atZenith_ = {kX(1, sun, cosSun), kY(1, sun, cosSun), kLuminance(1, sun, cosSun)};
  }
  const glm::vec3& toSun() const { return toSun_; }
  // Relative: 1 at the zenith.
  glm::vec3 radiance(const glm::vec3& d) const {
    const float cosTheta = std::max(d.y, 0.015f);  // the model has no horizon: e^(B / 0)
    const float cosGamma = glm::clamp(glm::dot(d, toSun_), -1.0f, 1.0f), gamma = std::acos(cosGamma);
    // Towards the horizon the model turns pink, which no clear noon does: it ends at white (D65) here.
    return rec709(std::min(zenithX_ * kX(cosTheta, gamma, cosGamma) / atZenith_.x, 0.3150f),
                  std::min(zenithY_ * kY(cosTheta, gamma, cosGamma) / atZenith_.y, 0.3310f),
                  kLuminance(cosTheta, gamma, cosGamma) / atZenith_.z);
  }

 private:
  glm::vec3 toSun_{0}, atZenith_{0};
  float zenithX_ = 0, zenithY_ = 0;
};

}  // namespace

ImageF skyPixels(int width, float sunElevation) {
  GLINT_CHECK(width >= 2 && width % 2 == 0 && sunElevation >= 5 && sunElevation <= 85, "{} {}", width, sunElevation);
  const Sky sky(sunElevation);
  ImageF image(width, width / 2, 3);
  const auto solidAngle = [&](int y) {
    const float step = glm::pi<float>() / float(image.height);
    return glm::two_pi<float>() / float(width) * (std::cos(step * float(y)) - std::cos(step * float(y + 1)));
  };

  // The dome, and what it gives a level surface.
  std::vector<glm::dvec3> rows(size_t(image.height) / 2);
  parallelFor(rows.size(), [&](size_t row) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3 d = environmentDirection(x, int(row), width, image.height);
      const glm::vec3 light = sky.radiance(d);
      for (int c = 0; c < 3; ++c) image.at(x, int(row))[c] = light[c];
      rows[row] += glm::dvec3(light) * double(d.y * solidAngle(int(row)));
    }
  });
  glm::dvec3 fromSky(0);
  for (const glm::dvec3& row : rows) fromSky += row;

  // The sun is painted larger than it is (0.27 degrees), so that a picture this small holds it, at the same
  // energy: measured over the pixels that it covers. On a clear day it gives a level surface about four times
  // what the sky does; a little redder than it by what the air scattered away.
  constexpr float kSunRadius = 0.9f, kSunEdge = 0.5f;  // degrees
  constexpr float kSunToSky = 4.0f;
  const glm::vec3 sunColor{1.0f, 0.93f, 0.82f};
  const float cosReach = std::cos(glm::radians(kSunRadius + kSunEdge));
  const auto sunShape = [&](const glm::vec3& d) {
    const float cosine = glm::dot(d, sky.toSun());
    if (cosine < cosReach) return 0.0f;
    const float angle = glm::degrees(std::acos(std::min(cosine, 1.0f)));
    const float t = glm::clamp((kSunRadius + kSunEdge - angle) / kSunEdge, 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
  };
  double sunArea = 0;
  for (int y = 0; y < image.height / 2; ++y)
    for (int x = 0; x < width; ++x)
      sunArea += double(sunShape(environmentDirection(x, y, width, image.height)) * solidAngle(y));
  const double luminanceOfSky = 0.2126 * fromSky.r + 0.7152 * fromSky.g + 0.0722 * fromSky.b;
  const double luminanceOfSun = kSunToSky * luminanceOfSky;
  const double sunWhite = 0.2126 * sunColor.r + 0.7152 * sunColor.g + 0.0722 * sunColor.b;
  // A picture too small to hold the disc has no sun.
  const glm::vec3 sun = sunArea > 0 ? sunColor * float(luminanceOfSun / (sunArea * double(sky.toSun().y) * sunWhite))
                                    : glm::vec3(0);
  const glm::vec3 level = glm::vec3(fromSky) + sun * float(sunArea) * sky.toSun().y;

  // A level white surface shows 1.
  const float scale = glm::pi<float>() / float(luminanceOfSky + (sunArea > 0 ? luminanceOfSun : 0));
  const glm::vec3 ground = glm::vec3(0.155f, 0.145f, 0.125f) * level / glm::pi<float>();
  std::vector<glm::vec3> horizon;
  for (int x = 0; x < width; ++x) {
    const glm::vec3 d = environmentDirection(x, image.height / 2, width, image.height);
    horizon.push_back(sky.radiance(glm::normalize(glm::vec3(d.x, 0.02f, d.z))));
  }
  parallelFor(size_t(image.height), [&](size_t row) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3 d = environmentDirection(x, int(row), width, image.height);
      float* out = image.at(x, int(row));
      glm::vec3 light;
      if (d.y > 0) {
        light = glm::vec3(out[0], out[1], out[2]) + sun * sunShape(d);
      } else {
        // Haze takes the far ground towards the colour of the horizon.
        light = glm::mix(ground, horizon[size_t(x)], 0.85f * std::exp(d.y / 0.06f));
      }
      for (int c = 0; c < 3; ++c) out[c] = light[c] * scale;
    }
  });
  return image;
}

}  // namespace glint
