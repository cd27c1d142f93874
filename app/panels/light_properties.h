// The widgets of one light.
#pragma once

#include <span>
#include <vector>

#include "renderer/light.h"

namespace glint {

// True when something changed. Widgets are known by their properties' titles.
bool lightProperties(Light&);
// Sets of lights for a subject of a metre at the origin: "Three-point", "Sun", ...
struct LightPreset {
  const char* name;
  const char* doc;
  std::vector<Light> (*make)();
};
std::span<const LightPreset> lightPresets();
// One to begin with, where it lights a subject of a metre at the origin from above and the front.
Light newLight(LightKind);

}  // namespace glint
