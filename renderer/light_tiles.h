// Which point lights reach which part of a view: lists for tiles of pixels, made on the CPU from the clusters of the
// geometry that is visible, so that a tile lists the lights that reach its surfaces and no others.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/scene.h"

namespace glint {

// A cluster of triangles in world space, and the pixels it may cover (x0, y0, x1, y1; x1 and y1 exclusive).
struct VisibleCluster {
  glm::vec3 center{0};
  float radius = 0;
  glm::vec3 axis{0, 0, 1};   // cone of normals, as in Cluster
  float coneCosine = -1;     // -1 where a light behind the geometry may count (normal maps, two sides)
  glm::ivec4 pixels{0};
};

struct Tile {
  int32_t x0, y0, x1, y1;    // pixels of the target
  int32_t first, count;      // in LightTiles::list
};

struct LightTiles {
  std::vector<Tile> tiles;       // only those with geometry
  std::vector<uint32_t> list;    // indices into the lights
};

// `rectangle` is x, y, width, height in pixels. Only LightKind::Point lights are read; indices count those alone.
// The list stays below kLongestLightList entries, or below the number of lights where that is larger.
inline constexpr size_t kLongestLightList = 128 * 1024;   // 4 MiB on the device
LightTiles buildLightTiles(std::span<const VisibleCluster>, std::span<const Light> pointLights, glm::ivec4 rectangle);

}  // namespace glint
