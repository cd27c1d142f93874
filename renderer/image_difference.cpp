#include "renderer/image_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

using Plane = Pixels<float>;  // one channel
using Vec3 = std::array<float, 3>;

// The illuminant D65 as FLIP's reference has it, and its sRGB primaries as exact fractions.
constexpr Vec3 kWhite = {0.950428545f, 1.0f, 1.088900371f};
constexpr double kToXyz[3][3] = {
    {10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
    {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
    {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

constexpr std::array<std::array<double, 3>, 3> inverse(const double (&m)[3][3]) {
  const auto cofactor = [&](int r, int c) {
    const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  std::array<std::array<double, 3>, 3> result{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) result[size_t(r)][size_t(c)] = cofactor(c, r) / determinant;
  return result;
}
constexpr auto kFromXyz = inverse(kToXyz);

Vec3 xyzFromLinear(const Vec3& c) {
  Vec3 result;
  for (size_t i = 0; i < 3; ++i)
    result[i] = float(kToXyz[i][0]) * c[0] + float(kToXyz[i][1]) * c[1] + float(kToXyz[i][2]) * c[2];
  return result;
}

// The opponent space YCxCz, and back.
Vec3 opponentFromLinear(const Vec3& c) {
  Vec3 xyz = xyzFromLinear(c);
  for (size_t i = 0; i < 3; ++i) xyz[i] /= kWhite[i];
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Vec3 linearFromOpponent(const Vec3& c) {
  const float y = (c[0] + 16) / 116;
  const Vec3 xyz = {(y + c[1] / 500) * kWhite[0], y * kWhite[1], (y - c[2] / 200) * kWhite[2]};
  Vec3 result;
  for (size_t i = 0; i < 3; ++i)
    result[i] = float(kFromXyz[i][0]) * xyz[0] + float(kFromXyz[i][1]) * xyz[1] + float(kFromXyz[i][2]) * xyz[2];
  return result;
}

// CIELAB with Hunt's effect: chroma counts for less in the dark.
Vec3 huntLabFromLinear(const Vec3& c) {
  const auto f = [](float t) {
    constexpr float delta = 6.0f / 29.0f;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0f / 29.0f;
  };
  Vec3 xyz = xyzFromLinear(c);
  for (size_t i = 0; i < 3; ++i) xyz[i] = f(xyz[i] / kWhite[i]);
  const float lightness = 116 * xyz[1] - 16;
  return {lightness, 0.01f * lightness * 500 * (xyz[0] - xyz[1]), 0.01f * lightness * 200 * (xyz[1] - xyz[2])};
}

float hyAB(const Vec3& a, const Vec3& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// A symmetric or odd kernel of 2 r + 1 taps.
using Kernel = std::vector<float>;

Kernel kernel(int radius, auto&& at) {
  Kernel result;
  for (int i = -radius; i <= radius; ++i) result.push_back(static_cast<float>(at(double(i))));
  return result;
}

// Positive taps to sum 1, negative ones to -1.
void normalize(Kernel& taps) {
  double positive = 0, negative = 0;
  for (float tap : taps) (tap > 0 ? positive : negative) += tap;
  for (float& tap : taps) tap = static_cast<float>(tap > 0 ? tap / positive : negative < 0 ? -tap / negative : tap);
}

// Both directions; beyond the border the picture goes on as its edge.
Plane convolve(const Plane& in, const Kernel& horizontal, const Kernel& vertical) {
  const int w = in.width, h = in.height;
  Plane middle(w, h, 1), out(w, h, 1);
  const int rx = int(horizontal.size()) / 2, ry = int(vertical.size()) / 2;
  std::vector<float> row(size_t(w + 2 * rx));
  for (int y = 0; y < h; ++y) {
    const float* source = in.at(0, y);
    for (int x = -rx; x < w + rx; ++x) row[size_t(x + rx)] = source[std::clamp(x, 0, w - 1)];
    float* to = middle.at(0, y);
    for (size_t k = 0; k < horizontal.size(); ++k)
      for (int x = 0; x < w; ++x) to[x] += horizontal[k] * row[size_t(x) + k];
  }
  for (int y = 0; y < h; ++y) {
    float* to = out.at(0, y);
    for (int k = -ry; k <= ry; ++k) {
      const float* source = middle.at(0, std::clamp(y + k, 0, h - 1));
      const float tap = vertical[size_t(k + ry)];
      for (int x = 0; x < w; ++x) to[x] += tap * source[x];
    }
  }
  return out;
}

// The eye's contrast sensitivity: an opponent channel is blurred by one or two Gaussians (FLIP, table 1).
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity kSensitivity[3] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};

Plane filtered(const Plane& in, const Sensitivity& s, double pixelsPerDegree) {
  constexpr double pi = std::numbers::pi;
  const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixelsPerDegree));
  const auto gaussian = [&](double b) {
    return kernel(radius, [&](double x) { return std::exp(-pi * pi * x * x / (pixelsPerDegree * pixelsPerDegree * b)); });
  };
  const auto sum = [](const Kernel& k) {
    double total = 0;
    for (float tap : k) total += tap;
    return total;
  };
  const Kernel first = gaussian(s.b1), second = gaussian(s.b2);
  const double w1 = s.a1 * std::sqrt(pi / s.b1), w2 = s.a2 * std::sqrt(pi / s.b2);
  const double total = w1 * sum(first) * sum(first) + w2 * sum(second) * sum(second);
  Plane out = convolve(in, first, first);
  for (float& v : out.data) v = float(v * (w1 / total));
  if (s.a2 != 0) {
    const Plane more = convolve(in, second, second);
    for (size_t i = 0; i < out.data.size(); ++i) out.data[i] += float(more.data[i] * (w2 / total));
  }
  return out;
}

// Edges and points of the lightness: the lengths of the first and second derivatives at the eye's feature width.
struct Features {
  Plane edges, points;
};

Features features(const Plane& y, double pixelsPerDegree) {
  constexpr double kFeatureWidth = 0.082;  // degrees
  const double sd = 0.5 * kFeatureWidth * pixelsPerDegree;
  const int radius = int(std::ceil(3 * sd));
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * sd * sd)); };
  Kernel smooth = kernel(radius, gaussian);
  Kernel edge = kernel(radius, [&](double x) { return -x * gaussian(x); });
  Kernel point = kernel(radius, [&](double x) { return (x * x / (sd * sd) - 1) * gaussian(x); });
  normalize(smooth);
  normalize(edge);
  normalize(point);
  const auto length = [&](const Kernel& derivative) {
    Plane across = convolve(y, derivative, smooth);
    const Plane down = convolve(y, smooth, derivative);
    for (size_t i = 0; i < across.data.size(); ++i) across.data[i] = std::hypot(across.data[i], down.data[i]);
    return across;
  };
  return {length(edge), length(point)};
}

// A picture as FLIP sees it: filtered, in Hunt-adjusted CIELAB, and its features.
struct Seen {
  std::vector<Vec3> lab;
  Features features;
};

Seen seen(const ImageF& image, double pixelsPerDegree) {
  const size_t count = size_t(image.width) * size_t(image.height);
  std::array<Plane, 3> planes;
  for (Plane& plane : planes) plane = Plane(image.width, image.height, 1);
  for (size_t i = 0; i < count; ++i) {
    const float* from = &image.data[i * size_t(image.channels)];
    Vec3 color;
    for (size_t k = 0; k < 3; ++k) color[k] = std::clamp(from[k], 0.f, 1.f);
    const Vec3 opponent = opponentFromLinear(color);
    for (size_t k = 0; k < 3; ++k) planes[k].data[i] = opponent[k];
  }
  Plane lightness = planes[0];
  for (float& v : lightness.data) v = (v + 16) / 116;
  Seen result;
  result.features = features(lightness, pixelsPerDegree);
  for (size_t k = 0; k < 3; ++k) planes[k] = filtered(planes[k], kSensitivity[k], pixelsPerDegree);
  result.lab.resize(count);
  for (size_t i = 0; i < count; ++i) {
    Vec3 color = linearFromOpponent({planes[0].data[i], planes[1].data[i], planes[2].data[i]});
    for (float& v : color) v = std::clamp(v, 0.f, 1.f);
    result.lab[i] = huntLabFromLinear(color);
  }
  return result;
}

}  // namespace

std::vector<std::string> differenceMetricNames() { return {"flip", "rmse", "max"}; }

std::optional<DifferenceMetric> differenceMetric(const std::string& name) {
  const auto names = differenceMetricNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<DifferenceMetric>(found - names.begin());
}

Pixels<float> flip(const ImageF& reference, const ImageF& test, float pixelsPerDegree) {
  GLINT_CHECK(reference.width == test.width && reference.height == test.height);
  GLINT_CHECK(reference.channels >= 3 && test.channels >= 3);
  // FLIP, section 4: the exponent and knee of the colour error, and the exponent of the feature error.
  constexpr float qc = 0.7f, pc = 0.4f, pt = 0.95f, qf = 0.5f;
  const float most = std::pow(hyAB(huntLabFromLinear({0, 1, 0}), huntLabFromLinear({0, 0, 1})), qc);
  const float knee = pc * most;
  const Seen a = seen(reference, pixelsPerDegree), b = seen(test, pixelsPerDegree);
  Pixels<float> result(reference.width, reference.height, 1);
  for (size_t i = 0; i < result.data.size(); ++i) {
    const float distance = std::pow(hyAB(a.lab[i], b.lab[i]), qc);
    const float color = distance < knee ? pt / knee * distance : pt + (distance - knee) / (most - knee) * (1 - pt);
    const float edge = std::abs(a.features.edges.data[i] - b.features.edges.data[i]);
    const float point = std::abs(a.features.points.data[i] - b.features.points.data[i]);
    const float feature = std::clamp(std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, qf), 0.f, 1.f);
    result.data[i] = std::clamp(std::pow(color, 1 - feature), 0.f, 1.f);
  }
  return result;
}

Difference imageDifference(const ImageF& a, const ImageF& b, DifferenceMetric metric) {
  GLINT_CHECK(a.width == b.width && a.height == b.height && !a.empty());
  Difference result;
  if (metric == DifferenceMetric::Flip) {
    result.map = flip(a, b);
    for (float v : result.map.data) result.value += v;
    result.value /= double(result.map.data.size());
  } else {
    GLINT_CHECK(a.channels == b.channels);
    result.map = Pixels<float>(a.width, a.height, 1);
    double squares = 0;
    for (size_t i = 0; i < a.data.size(); ++i) {
      const float difference = std::abs(a.data[i] - b.data[i]);
      squares += double(difference) * double(difference);
      float& largest = result.map.data[i / size_t(a.channels)];
      largest = std::max(largest, difference);
    }
    result.value = metric == DifferenceMetric::Rmse ? std::sqrt(squares / double(a.data.size()))
                                                    : *std::max_element(result.map.data.begin(), result.map.data.end());
  }
  const auto worst = std::max_element(result.map.data.begin(), result.map.data.end());
  const int index = static_cast<int>(worst - result.map.data.begin());
  result.largest = *worst;
  result.x = index % a.width;
  result.y = index / a.width;
  return result;
}

Image8 heatMap(const Pixels<float>& map, float white) {
  // Matplotlib's magma as a polynomial in each channel (Zucker's fit).
  constexpr float c[7][3] = {{-0.002136485f, -0.000749655f, -0.005386128f}, {0.2516605f, 0.6775232f, 2.4940266f},
                             {8.3537173f, -3.5777195f, 0.3144679f},         {-27.6687331f, 14.2647308f, -13.6492132f},
                             {52.1761398f, -27.9436061f, 12.9441694f},      {-50.7685254f, 29.0465828f, 4.2341530f},
                             {18.6557051f, -11.4897735f, -5.6019615f}};
  Image8 result(map.width, map.height, 3);
  for (size_t i = 0; i < map.data.size(); ++i) {
    const float t = white > 0 ? std::clamp(map.data[i] / white, 0.f, 1.f) : 0;
    for (size_t k = 0; k < 3; ++k) {
      float v = c[6][k];
      for (int n = 5; n >= 0; --n) v = v * t + c[n][k];
      result.data[3 * i + k] = static_cast<uint8_t>(std::lround(255 * std::clamp(v, 0.f, 1.f)));
    }
  }
  return result;
}

}  // namespace glint
