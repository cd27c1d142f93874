// Where a light's shadow map looks, and how soft its shadows are. Values only, no OpenGL.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "materials/base/diagnostic.h"
#include "renderer/light.h"

namespace glint {

// Most lights of a view that cast shadows, and the side of a map, in texels. With what is kept of other views there are
// never more maps than that: 8 of 4 MiB.
inline constexpr int kMostShadows = 8, kShadowMapSide = 1024;

// A box in world space around what casts shadows; empty while low > high.
struct CasterBounds {
  glm::vec3 low{1}, high{0};

  bool empty() const { return low.x > high.x; }
  void add(glm::vec3 point);
  glm::vec3 center() const { return 0.5f * (low + high); }
  float radius() const { return 0.5f * glm::length(high - low); }
};

struct ShadowView {
  // From world space to the map: texture coordinates and depth in 0 .. 1, after the division by w.
  glm::mat4 mapFromWorld{1};
  // Two half axes of the light's source as it is seen in the map (xy and zw), for each unit of depth between what casts the
  // shadow and what receives it. Depth is linear in the distance for a directional light and in its inverse for the others,
  // and a penumbra's width is linear in either (Fernando 2005, in other words).
  glm::vec4 source{0};
  glm::vec4 towards{0};    // xyz: where the light is, w = 1; or the direction to a directional one, w = 0
  float texel = 0;         // of the map, in metres; with w = 1 for each metre from the light
  float sine = 0;          // of the angle that half of the source takes up: it sinks below a surface's horizon over twice that
};
// Tight around the casters. None without casters, and for a light that stands among them and has no cone.
std::optional<ShadowView> shadowView(const Light&, const CasterBounds&, int side);

// A number for each light: 0 without a shadow, else from 1 on, the brightest on the casters first. Says which have none though
// they should: beyond kMostShadows, or because they stand among the casters.
std::vector<int> shadowNumbers(std::span<const Light>, const CasterBounds&, Diagnostics& problems);

}  // namespace glint
