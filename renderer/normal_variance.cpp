#include "renderer/normal_variance.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "renderer/parallel.h"

namespace glint {
namespace {

using Normals = Pixels<float>;

// Of slopes, that eight bits make of a smooth surface: a step is 2 / 255, and rounding a twelfth of its square.
constexpr float kRounding = 4.0f / (255 * 255 * 12);

glm::vec3 decoded(const uint8_t* p) {
  // Eight bits have no zero: what is flat reads as (1, 1) / 255.
  const glm::vec2 xy = glm::vec2(p[0], p[1]) * (2.0f / 255) - 1.0f;
  const float z2 = 1 - glm::dot(xy, xy);
  return z2 > 0 ? glm::vec3(xy, std::sqrt(z2)) : glm::vec3(glm::normalize(xy), 0);
}

// The texels of the larger level that one of the smaller covers, along one axis: two, or three where the size is odd.
struct Span {
  int first, end;
};
Span spanOf(int texel, int size, int larger) { return {texel * larger / size, ((texel + 1) * larger + size - 1) / size}; }

template <class At>
Normals halved(int width, int height, const At& at) {
  Normals half(std::max(width / 2, 1), std::max(height / 2, 1), 3);
  const auto row = [&](size_t index) {
    const int y = static_cast<int>(index);
    const Span rows = spanOf(y, half.height, height);
    for (int x = 0; x < half.width; ++x) {
      const Span columns = spanOf(x, half.width, width);
      glm::vec3 sum(0);
      for (int j = rows.first; j < rows.end; ++j)
        for (int i = columns.first; i < columns.end; ++i) sum += at(i, j);
      sum /= static_cast<float>((rows.end - rows.first) * (columns.end - columns.first));
      std::copy(&sum.x, &sum.x + 3, half.at(x, y));
    }
  };
  parallelFor(static_cast<size_t>(half.height), row, half.width * half.height > 1 << 18);
  return half;
}

Pixels<uint8_t> encoded(const Normals& normals) {
  Pixels<uint8_t> out(normals.width, normals.height, 1);
  for (size_t i = 0; i < out.data.size(); ++i) {
    const float* n = &normals.data[3 * i];
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const float variance = std::clamp(1 / std::max(length, 0.5f) - 1 - kRounding, 0.0f, 1.0f);
    out.data[i] = static_cast<uint8_t>(std::lround(255 * (1 - std::sqrt(variance))));
  }
  return out;
}

}  // namespace

std::vector<Pixels<uint8_t>> encodedNormalVariance(const Image8& image) {
  std::vector<Pixels<uint8_t>> levels;
  levels.emplace_back(image.width, image.height, 1);
  std::fill(levels.back().data.begin(), levels.back().data.end(), uint8_t{255});
  if (image.channels < 3 || (image.width == 1 && image.height == 1)) {
    // Grey says the same of x and y and is no normal map; its levels have none.
    for (int w = image.width, h = image.height; w > 1 || h > 1;) {
      w = std::max(w / 2, 1);
      h = std::max(h / 2, 1);
      levels.emplace_back(w, h, 1);
      std::fill(levels.back().data.begin(), levels.back().data.end(), uint8_t{255});
    }
    return levels;
  }
  Normals normals = halved(image.width, image.height, [&](int x, int y) { return decoded(image.at(x, y)); });
  levels.push_back(encoded(normals));
  while (normals.width > 1 || normals.height > 1) {
    normals = halved(normals.width, normals.height, [&](int x, int y) {
      const float* n = normals.at(x, y);
      return glm::vec3(n[0], n[1], n[2]);
    });
    levels.push_back(encoded(normals));
  }
  return levels;
}

}  // namespace glint
