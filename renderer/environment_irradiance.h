// The diffuse light of an environment.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/image.h"

namespace glint {

// Irradiance over pi, what a white surface shows, over the direction that it faces. Nine numbers hold it to a few percent
// where the light comes from all around, and not where it comes from a sun: then a map has it.
struct DiffuseLight {
  // Coefficients of spherical harmonics to the second order (Ramamoorthi and Hanrahan 2001, eq. 13), the constants of the
  // basis folded in: as diffuseIrradiance() of shaders/passes/lighting.frag adds them up.
  std::array<glm::vec4, 9> harmonics{};
  double harmonicsError = 0;        // root mean square of their difference to `map`, over its root mean square
  // A cube map with kMapSize texels a side, face by face: exact but for a filter of a degree.
  std::vector<glm::vec4> map;
  static constexpr int kMapSize = 16;
  // More of an error than this, and the map is used.
  static constexpr double kMostHarmonicsError = 0.01;
  bool needsMap() const { return harmonicsError > kMostHarmonicsError; }
};
DiffuseLight diffuseLight(const ImageF& equirect);

}  // namespace glint
