// Colours and measures of the editor. Greys are neutral, so that they do not tint the judgement of a material; one
// accent marks what is selected or active, and nothing else.
#pragma once

#include <imgui.h>

#include "materials/value.h"

namespace glint::theme {

inline constexpr ImU32 grey(int level, int alpha = 255) { return IM_COL32(level, level, level, alpha); }

inline constexpr ImU32 kGap = grey(17);            // between panels
inline constexpr ImU32 kPanel = grey(33);
inline constexpr ImU32 kHeader = grey(27);         // strips with tabs and titles
inline constexpr ImU32 kCanvas = grey(24);
inline constexpr ImU32 kGrid = grey(31), kGridStrong = grey(38);
inline constexpr ImU32 kNode = grey(48), kNodeHeader = grey(60), kNodeEdge = grey(14);
inline constexpr ImU32 kField = grey(22), kFieldHovered = grey(28), kFill = grey(72), kFillHovered = grey(84);
inline constexpr ImU32 kLine = grey(52);
inline constexpr ImU32 kText = grey(222), kTextDim = grey(150), kTextFaint = grey(105);
inline constexpr ImU32 kAccent = IM_COL32(226, 146, 74, 255);      // copper
inline constexpr ImU32 kAccentDim = IM_COL32(226, 146, 74, 90);
inline constexpr ImU32 kError = IM_COL32(232, 92, 80, 255), kWarning = IM_COL32(226, 184, 82, 255),
                       kGood = IM_COL32(126, 182, 104, 255);

// Of pins and wires.
ImU32 typeColor(ValueType);

// Sets ImGui's style for `scale` framebuffer pixels a UI unit.
void apply(float scale);
// UI units to framebuffer pixels, whole where that matters.
float px(float units);
float scale();

}  // namespace glint::theme
