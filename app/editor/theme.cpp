#include "app/editor/theme.h"

#include <cmath>

namespace glint::theme {
namespace {

float currentScale = 1;

ImVec4 toVec(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }

}  // namespace

ImU32 typeColor(ValueType type) {
  switch (type) {
    case ValueType::Bool: return IM_COL32(196, 116, 116, 255);
    case ValueType::Int: return IM_COL32(116, 168, 132, 255);
    case ValueType::Float: return grey(168);
    case ValueType::Vec2: return IM_COL32(124, 190, 170, 255);
    case ValueType::Vec3: return IM_COL32(122, 138, 214, 255);
    case ValueType::Vec4: return IM_COL32(168, 128, 206, 255);
    case ValueType::Color: return IM_COL32(224, 200, 84, 255);
    case ValueType::Texture: return IM_COL32(198, 120, 168, 255);
    case ValueType::Attributes: return IM_COL32(112, 198, 108, 255);
  }
  return kText;
}

float scale() { return currentScale; }
float px(float units) { return std::round(units * currentScale); }

void apply(float scale) {
  currentScale = scale;
  ImGuiStyle style;
  style.WindowPadding = {10, 8};
  style.FramePadding = {8, 4};
  style.CellPadding = {6, 3};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 8;
  style.WindowRounding = 4;
  style.ChildRounding = 0;
  style.FrameRounding = 3;
  style.PopupRounding = 4;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 2;
  style.TabRounding = 3;
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.ChildBorderSize = 0;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.5f, 0.5f};
  style.DisabledAlpha = 0.42f;
  style.CircleTessellationMaxError = 0.2f;
  style.CurveTessellationTol = 0.6f;
  style.ScaleAllSizes(scale);
  style.WindowBorderSize = style.PopupBorderSize = std::fmax(1, std::floor(scale));

  ImVec4* c = style.Colors;
  for (int i = 0; i < ImGuiCol_COUNT; ++i) c[i] = toVec(kText);
  const auto set = [&](ImGuiCol slot, ImU32 color) { c[slot] = toVec(color); };
  set(ImGuiCol_Text, kText);
  set(ImGuiCol_TextDisabled, kTextDim);
  set(ImGuiCol_WindowBg, kPanel);
  set(ImGuiCol_ChildBg, grey(0, 0));
  set(ImGuiCol_PopupBg, grey(38));
  set(ImGuiCol_Border, grey(62));
  set(ImGuiCol_BorderShadow, grey(0, 0));
  set(ImGuiCol_FrameBg, kField);
  set(ImGuiCol_FrameBgHovered, kFieldHovered);
  set(ImGuiCol_FrameBgActive, grey(34));
  set(ImGuiCol_TitleBg, kHeader);
  set(ImGuiCol_TitleBgActive, kHeader);
  set(ImGuiCol_TitleBgCollapsed, kHeader);
  set(ImGuiCol_MenuBarBg, kHeader);
  set(ImGuiCol_ScrollbarBg, grey(0, 0));
  set(ImGuiCol_ScrollbarGrab, grey(70));
  set(ImGuiCol_ScrollbarGrabHovered, grey(88));
  set(ImGuiCol_ScrollbarGrabActive, grey(104));
  set(ImGuiCol_CheckMark, kAccent);
  set(ImGuiCol_SliderGrab, grey(110));
  set(ImGuiCol_SliderGrabActive, kAccent);
  set(ImGuiCol_Button, grey(56));
  set(ImGuiCol_ButtonHovered, grey(68));
  set(ImGuiCol_ButtonActive, grey(80));
  set(ImGuiCol_Header, grey(58));
  set(ImGuiCol_HeaderHovered, grey(66));
  set(ImGuiCol_HeaderActive, grey(76));
  set(ImGuiCol_Separator, kLine);
  set(ImGuiCol_SeparatorHovered, grey(90));
  set(ImGuiCol_SeparatorActive, kAccent);
  set(ImGuiCol_ResizeGrip, grey(0, 0));
  set(ImGuiCol_ResizeGripHovered, grey(90));
  set(ImGuiCol_ResizeGripActive, kAccent);
  set(ImGuiCol_Tab, kHeader);
  set(ImGuiCol_TabHovered, grey(58));
  set(ImGuiCol_TabActive, kPanel);
  set(ImGuiCol_TabUnfocused, kHeader);
  set(ImGuiCol_TabUnfocusedActive, kPanel);
  set(ImGuiCol_PlotLines, grey(170));
  set(ImGuiCol_PlotHistogram, kAccent);
  set(ImGuiCol_TableHeaderBg, kHeader);
  set(ImGuiCol_TableBorderStrong, kLine);
  set(ImGuiCol_TableBorderLight, grey(44));
  set(ImGuiCol_TableRowBg, grey(0, 0));
  set(ImGuiCol_TableRowBgAlt, grey(255, 6));
  set(ImGuiCol_TextSelectedBg, kAccentDim);
  set(ImGuiCol_DragDropTarget, kAccent);
  set(ImGuiCol_NavHighlight, kAccent);
  set(ImGuiCol_NavWindowingHighlight, kAccent);
  set(ImGuiCol_NavWindowingDimBg, grey(0, 90));
  set(ImGuiCol_ModalWindowDimBg, grey(0, 120));
  ImGui::GetStyle() = style;
}

}  // namespace glint::theme
