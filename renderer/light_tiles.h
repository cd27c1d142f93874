// Which lights with a place reach which part of a view: lists for tiles of pixels, made on the CPU from the clusters of the
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
  int32_t first;             // texel of its first light on the device
  int32_t points;            // point lights, and then of each other kind, two to a number, the first in the low half:
  int32_t spotsAndSpheres, tubesAndRectangles;
};

struct LightTiles {
  std::vector<Tile> tiles;       // only those with geometry
  std::vector<uint32_t> list;    // indices into the lights, tile after tile
  size_t texels = 0;             // of 16 bytes, that the lists take on the device
};

// On the device: PointBlock and PlacedBlock of renderer/prepared_view.h.
inline constexpr int32_t kPointTexels = 2, kPlacedTexels = 4;

// `rectangle` is x, y, width, height in pixels. The lights are in the order of their kinds, none directional. The lists stay below
// `mostTexels`, or below what all lights take once where that is more.
inline constexpr size_t kMostLightTexels = 256 * 1024;   // of a view: 4 MiB
LightTiles buildLightTiles(std::span<const VisibleCluster>, std::span<const Light> lights, glm::ivec4 rectangle, size_t mostTexels = kMostLightTexels);

}  // namespace glint
