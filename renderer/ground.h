// A surface to stand on.
#pragma once

#include "renderer/scene.h"

namespace glint {

// Adds a round plane under the lowest point of what the scene draws, some times as wide as it is, matte and grey, and shaded by
// a model that should have a diffuse part. Nothing for Ground::None and empty scenes.
void addGround(Scene&, Ground, const std::shared_ptr<const ShadingModel>&);
// Widens the range of a camera that was framed without it.
void includeGround(Camera&, const Scene&);

}  // namespace glint
