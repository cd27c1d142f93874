#include "renderer/environment_spots.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "renderer/environment.h"

namespace glint {
namespace {

using std::numbers::pi;

constexpr double kTimes = 16;   // the mean
constexpr double kLeast = 1e-4; // of the picture's light: less is not worth a spot

float brightness(const float* p) { return std::max({p[0], p[1], p[2]}); }

// The pixels of a connected part, also across the seam.
struct Part {
  std::vector<size_t> pixels;
  double angle = 0;
};

class Parts {
 public:
  Parts(const ImageF& image, float threshold) : image_(image), threshold_(threshold), seen_(static_cast<size_t>(image.width) * image.height, false) {}

  std::vector<Part> find() {
    std::vector<Part> parts;
    for (size_t i = 0; i < seen_.size(); ++i)
      if (isNew(i)) parts.push_back(around(i));
    return parts;
  }

 private:
  bool isNew(size_t i) const { return !seen_[i] && brightness(&image_.data[3 * i]) > threshold_; }

  Part around(size_t first) {
    Part part;
    seen_[first] = true;
    part.pixels.push_back(first);
    for (size_t next = 0; next < part.pixels.size(); ++next) {
      const int x = static_cast<int>(part.pixels[next]) % image_.width, y = static_cast<int>(part.pixels[next]) / image_.width;
      part.angle += solidAngle(y, image_.width, image_.height);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (y + dy < 0 || y + dy >= image_.height) continue;
          const size_t i = static_cast<size_t>(y + dy) * image_.width + static_cast<size_t>((x + dx + image_.width) % image_.width);
          if (!isNew(i)) continue;
          seen_[i] = true;
          part.pixels.push_back(i);
        }
    }
    return part;
  }

  const ImageF& image_;
  float threshold_;
  std::vector<bool> seen_;
};

}  // namespace

double solidAngle(int y, int width, int height) {
  return (std::cos(y * pi / height) - std::cos((y + 1) * pi / height)) * 2 * pi / width;
}

SpotsOfEnvironment takeOutSpots(const ImageF& image, const SpotSizes& sizes) {
  SpotsOfEnvironment result;
  double mean = 0;
  for (int y = 0; y < image.height; ++y) {
    double row = 0;
    for (int x = 0; x < image.width; ++x) row += brightness(image.at(x, y));
    mean += row * solidAngle(y, image.width, image.height) / (4 * pi);
  }
  const float threshold = static_cast<float>(kTimes * mean);
  struct Found {
    EnvironmentSpot spot;
    std::vector<size_t> pixels;
    double light = 0;
  };
  std::vector<Found> found;
  for (const Part& part : Parts(image, threshold).find()) {
    if (part.angle > 0.25 * pi * sizes.part * sizes.part) continue;
    // Larger parts have larger cells, so that none takes all the spots.
    const double across = 2 * std::sqrt(part.angle / pi);
    const int cell = std::max(1, static_cast<int>(std::max(sizes.cell, across / 10) / (pi / image.height)));
    std::map<std::pair<int, int>, std::vector<size_t>> cells;
    for (const size_t i : part.pixels)
      cells[{static_cast<int>(i) % image.width / cell, static_cast<int>(i) / image.width / cell}].push_back(i);
    for (auto& [where, pixels] : cells) {
      Found one{{}, std::move(pixels), 0};
      glm::dvec3 irradiance(0), direction(0);
      for (const size_t i : one.pixels) {
        const int x = static_cast<int>(i) % image.width, y = static_cast<int>(i) / image.width;
        const double excess = 1 - static_cast<double>(threshold) / static_cast<double>(brightness(&image.data[3 * i]));
        const glm::dvec3 light = glm::dvec3(image.data[3 * i], image.data[3 * i + 1], image.data[3 * i + 2]) * (excess * solidAngle(y, image.width, image.height));
        irradiance += light;
        direction += glm::dvec3(environmentDirection(x, y, image.width, image.height)) * std::max({light.r, light.g, light.b});
      }
      one.light = std::max({irradiance.r, irradiance.g, irradiance.b});
      if (!(one.light > kLeast * 4 * pi * mean)) continue;
      one.spot = {glm::normalize(direction), irradiance};
      found.push_back(std::move(one));
    }
  }
  if (found.empty()) return result;
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.light > b.light; });
  if (found.size() > SpotsOfEnvironment::kMost) found.resize(SpotsOfEnvironment::kMost);
  result.rest = image;
  for (const Found& one : found) {
    result.spots.push_back(one.spot);
    for (const size_t i : one.pixels) {
      const float scale = threshold / brightness(&image.data[3 * i]);
      for (size_t c = 0; c < 3; ++c) result.rest.data[3 * i + c] *= scale;
    }
  }
  return result;
}

}  // namespace glint
