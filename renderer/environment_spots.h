// Suns and lamps of an environment, taken out of its pixels: so small and bright that samples of a lobe miss them.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/image.h"

namespace glint {

// Light from one direction.
struct EnvironmentSpot {
  glm::vec3 direction{0, 1, 0};  // towards it, unit
  glm::vec3 irradiance{0};       // of a surface that faces it: radiance times solid angle
};

struct SpotsOfEnvironment {
  std::vector<EnvironmentSpot> spots;  // at most kMost
  ImageF rest;                         // the same picture with their light taken out; empty when there are none
  static constexpr size_t kMost = 128;
};

// What counts as small, in radians across: a connected part that is brighter than all around it, and the cells that it is
// cut into, each a spot: at least one pixel and a tenth of the part.
struct SpotSizes {
  double part, cell;
};

// `equirect`: three channels, finite and not negative. Light beyond 16 times the mean of the picture is a spot's where its
// part is small. Rest and spots add up to the picture's light.
SpotsOfEnvironment takeOutSpots(const ImageF& equirect, const SpotSizes&);

// The solid angle of a pixel in that row, in steradians.
double solidAngle(int y, int width, int height);

}  // namespace glint
