// How much the normals of a normal map vary within the texels of its smaller levels: what averaging them loses, and
// highlights need (shaders/common/specular_antialiasing.glsl). No OpenGL calls.
#pragma once

#include <vector>

#include "renderer/image.h"

namespace glint {

// For each level of a full chain, from the picture itself down to 1 x 1, a byte a texel, rows as in the picture: of the
// variance v of slopes along one axis, at most 1, it is 255 (1 - sqrt(v)), so that 255 is none and fine steps are where the
// eye sees them. v is 1 / r - 1 for normals whose average is r long (Toksvig 2005, "Mipmapping Normal Maps"). Normals are
// read as the node "Normal map" reads them: x and y of the picture, z from these.
std::vector<Pixels<uint8_t>> encodedNormalVariance(const Image8&);

}  // namespace glint
