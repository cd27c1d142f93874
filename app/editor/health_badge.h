// The badge of a shading model: one dot that says whether it keeps the laws, wherever the model is listed. Its sign
// tells the verdict without its colour. The pointer finds the card, a click keeps it open.
#pragma once

#include <imgui.h>

#include <string>

#include "app/editor/health_worker.h"

namespace glint {

class Editor;

// The sign alone; a null card is one that is still being measured.
void drawHealthSign(ImDrawList&, ImVec2 center, float radius, const ModelHealth*);
float healthSignRadius();

// An item of the height of a line. `name` is what a test knows it under, as "health:NAME".
void healthBadge(Editor&, const std::string& name, const ModelPtr&);

// The whole card as text, for a tooltip over the item just submitted; also under the pointer when `always`.
void healthTooltip(const ModelPtr&, const ModelHealth*, bool always = false);

// The whole card as widgets, as wide as its window.
void healthCard(const ModelPtr&, const ModelHealth*);

}  // namespace glint
