// The widgets of one light.
#pragma once

#include "renderer/light.h"

namespace glint {

// True when something changed. Widgets are known by their properties' titles.
bool lightProperties(Light&);
// One to begin with, where it lights a subject of a metre at the origin from above and the front.
Light newLight(LightKind);

}  // namespace glint
