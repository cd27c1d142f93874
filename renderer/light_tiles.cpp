#include "renderer/light_tiles.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "materials/base/check.h"

namespace glint {
namespace {

// Lights as arrays, so that the tests below run several lights an instruction.
struct LightArrays {
  std::vector<float> x, y, z, radius, extent;
  // The spots, which are next to each other, with their cones.
  struct Cone {
    glm::vec3 axis;
    float cosine, sine;
  };
  size_t firstSpot = 0;
  std::vector<Cone> cones;
  // The rectangles, likewise, with the way that they shine.
  size_t firstRectangle = 0;
  std::vector<glm::vec3> axes;
  explicit LightArrays(std::span<const Light> lights) {
    for (const Light& light : lights) {
      x.push_back(light.position.x);
      y.push_back(light.position.y);
      z.push_back(light.position.z);
      radius.push_back(light.radius);
      extent.push_back(glint::extent(light));
      if (light.kind == LightKind::Rectangle) {
        if (axes.empty()) firstRectangle = x.size() - 1;
        axes.push_back(glm::normalize(light.axis));
      }
      if (light.kind != LightKind::Spot) continue;
      if (cones.empty()) firstSpot = x.size() - 1;
      cones.push_back({glm::normalize(light.axis), std::cos(light.outerAngle), std::sin(light.outerAngle)});
    }
  }
};

// Sets the bits of the lights whose sphere, and a spot's cone or a rectangle's half of space, touches the cluster's sphere and that
// stand before some of its triangles.
void reachingLights(const VisibleCluster& c, const LightArrays& lights, std::vector<uint8_t>& reached) {
  const size_t count = lights.x.size();
  // A light below all tangent planes lights nothing: the highest of its directions above the cone's plane is
  // dot(light - center, axis) against the cone's spread.
  const bool cone = c.coneCosine > 0;
  const float sine = cone ? std::sqrt(std::max(0.0f, 1 - c.coneCosine * c.coneCosine)) : 0;
  for (size_t i = 0; i < count; ++i) {
    const float dx = lights.x[i] - c.center.x, dy = lights.y[i] - c.center.y, dz = lights.z[i] - c.center.z;
    const float distance2 = dx * dx + dy * dy + dz * dz;
    const float reach = lights.radius[i] + c.radius;
    const float along = dx * c.axis.x + dy * c.axis.y + dz * c.axis.z;
    // For every normal of the cone and point of the sphere, the height of the light's points above the plane there is at
    // most cosine (along + extent) + sine (distance + extent) + radius.
    const float bound = -(c.coneCosine * along + c.radius + (c.coneCosine + sine) * lights.extent[i]);
    const bool behind = cone & (bound > 0) & (bound * bound > sine * sine * distance2);
    reached[i] = (distance2 < reach * reach) & !behind;
  }
  for (size_t k = 0; k < lights.cones.size(); ++k) {
    const LightArrays::Cone& spot = lights.cones[k];
    const size_t i = lights.firstSpot + k;
    if (spot.cosine < 0) continue;   // it shines to more than one side
    const glm::vec3 d = c.center - glm::vec3(lights.x[i], lights.y[i], lights.z[i]);
    const float along = glm::dot(d, spot.axis), across = std::sqrt(std::max(glm::dot(d, d) - along * along, 0.0f));
    // How far the sphere's middle lies outside the cone.
    reached[i] &= spot.cosine * across - spot.sine * along < c.radius;
  }
  for (size_t k = 0; k < lights.axes.size(); ++k) {
    const size_t i = lights.firstRectangle + k;
    reached[i] &= glm::dot(c.center - glm::vec3(lights.x[i], lights.y[i], lights.z[i]), lights.axes[k]) > -c.radius;
  }
}

LightTiles tilesOf(int side, std::span<const VisibleCluster> clusters, std::span<const Light> lights, glm::ivec4 rectangle) {
  const int columns = (rectangle.z + side - 1) / side, rows = (rectangle.w + side - 1) / side;
  const size_t words = (lights.size() + 63) / 64;
  std::vector<uint64_t> masks(static_cast<size_t>(columns * rows) * words);
  std::vector<uint8_t> touched(static_cast<size_t>(columns * rows));

  const LightArrays arrays(lights);
  std::vector<uint8_t> reached(words * 64);
  std::vector<uint64_t> mask(words);
  for (const VisibleCluster& cluster : clusters) {
    const int x0 = std::clamp((cluster.pixels.x - rectangle.x) / side, 0, columns - 1);
    const int x1 = std::clamp((cluster.pixels.z - 1 - rectangle.x) / side, 0, columns - 1);
    const int y0 = std::clamp((cluster.pixels.y - rectangle.y) / side, 0, rows - 1);
    const int y1 = std::clamp((cluster.pixels.w - 1 - rectangle.y) / side, 0, rows - 1);
    reachingLights(cluster, arrays, reached);
    for (size_t w = 0; w < words; ++w) {
      uint64_t bits = 0;
      for (size_t b = 0; b < 64; ++b) bits |= static_cast<uint64_t>(reached[w * 64 + b]) << b;
      mask[w] = bits;
    }
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const size_t tile = static_cast<size_t>(y * columns + x);
        touched[tile] = 1;
        for (size_t w = 0; w < words; ++w) masks[tile * words + w] |= mask[w];
      }
  }

  LightTiles result;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const size_t tile = static_cast<size_t>(y * columns + x);
      if (!touched[tile]) continue;
      int32_t counts[6] = {};
      for (size_t w = 0; w < words; ++w)
        for (uint64_t bits = masks[tile * words + w]; bits; bits &= bits - 1) {
          const size_t light = w * 64 + static_cast<size_t>(std::countr_zero(bits));
          result.list.push_back(static_cast<uint32_t>(light));
          ++counts[static_cast<size_t>(lights[light].kind)];
        }
      result.tiles.push_back({rectangle.x + x * side, rectangle.y + y * side,
                              rectangle.x + std::min((x + 1) * side, rectangle.z),
                              rectangle.y + std::min((y + 1) * side, rectangle.w), static_cast<int32_t>(result.texels), counts[1], counts[2] | counts[3] << 16,
                              counts[4] | counts[5] << 16});
      result.texels += static_cast<size_t>(counts[1] * kPointTexels + (counts[2] + counts[3] + counts[4] + counts[5]) * kPlacedTexels);
    }
  return result;
}

}  // namespace

LightTiles buildLightTiles(std::span<const VisibleCluster> clusters, std::span<const Light> lights, glm::ivec4 rectangle, size_t mostTexels) {
  GLINT_CHECK(lights.size() < 65536, "{} lights", lights.size());
  // Small tiles pay when there are many lights to keep apart (measured on software GL: 64 pixels wins for 128
  // lights, 32 for 1024). Larger ones bound the memory where most lights reach everything.
  for (int side = lights.size() > 256 ? 32 : 64;; side *= 2) {
    LightTiles tiles = tilesOf(side, clusters, lights, rectangle);
    if (tiles.texels <= mostTexels || side >= std::max(rectangle.z, rectangle.w)) return tiles;
  }
}

}  // namespace glint
