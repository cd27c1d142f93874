// Directions drawn from a model's lobe, for prefiltering environments: deterministic, and derived from the model's
// own values, so that a dropped-in model has them too.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace glint {

// `kernel` holds the lobe's values (per steradian, any scale) at the angles lobeAngle(i, kernel.size()) from its axis
// +Z. Gives `count` unit directions with equal weight, xyz, and in w the mip level of a cube map with `sourceSize`
// texels a side whose texels cover the solid angle that the sample stands for. A lobe of zeros yields the axis.
std::vector<glm::vec4> lobeSamples(std::span<const float> kernel, int count, int sourceSize);

// Such a kernel per steradian, its integral over the sphere 1; zeros for a lobe of zeros.
std::vector<float> lobeDensity(std::span<const float> kernel);

// A lobe around +Z that is not round: `rows` are kernels as above, one for each of the azimuths pi k / rows.size().
struct StretchedLobe {
  size_t narrowest = 0;      // the row
  glm::vec2 stretch{0};      // a slope of the half vector, along the direction in which it is widest: the root of
                             // the difference of the squared widths
};
StretchedLobe stretchedLobe(std::span<const std::vector<float>> rows);

// The slope of the half vector that half of a kernel's light lies within: alpha, for a narrow GGX. 0 without any light.
double medianSlope(std::span<const float> kernel);

// The angle of entry i in radians: pi/2 u^2 at u = (i + 1/2) / size, denser towards the axis. shaders/passes/lobe.frag
// evaluates the kernel there.
float lobeAngle(size_t i, size_t size);

}  // namespace glint
