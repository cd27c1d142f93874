// What lights look like in the viewport's picture, beside the light that they give.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "app/editor/light_handles.h"
#include "app/editor/scene_depth.h"

namespace glint {

// Where it is drawn: over the picture whose top left is `low`. `depth` may be null; what it hides is dimmed.
struct LightCanvas {
  ImDrawList& list;
  const HandleView& view;
  const SceneDepth* depth;
  ImVec2 low;
};

struct LightLook {
  bool selected = false, hovered = false;
  bool plain = false;              // a dot alone
  bool held = false;               // its `grip` is being dragged: no other handle is shown
  std::optional<LightGrip> grip;   // under the pointer, or held
};

void drawLight(const LightCanvas&, const Light&, float aim, const LightLook&);
// The sign on the picture's edge of one outside it.
void drawLightEdge(const LightCanvas&, const Light&, glm::vec2 at, const LightLook&);
// Its name and its light, or what is being set, beside `at` and `away` from the light; known as "light label".
void drawLightLabel(const LightCanvas&, glm::vec2 at, glm::vec2 away, const std::string& title, const std::string& detail, bool selected);

}  // namespace glint
