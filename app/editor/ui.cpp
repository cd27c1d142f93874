#include "app/editor/ui.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <map>

#include "app/editor/fonts.h"
#include "app/editor/theme.h"
#include "renderer/image_io.h"

namespace glint::ui {
namespace {

struct Registry {
  std::map<std::string, Rect> shown, next;
  std::vector<std::string> scopes;
  Fonts* fonts = nullptr;
} registry;

std::string scoped(const std::string& name) {
  std::string whole;
  for (const std::string& scope : registry.scopes) whole += scope + "/";
  return whole + name;
}

std::string hidden(const std::string& label) { return "##" + label; }

// The filled part of a slider's field, under the slider itself, which is drawn without a frame.
void fieldWithFill(float fraction, bool hovered) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high = {low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool over = hovered && ImGui::IsMouseHoveringRect(low, high);
  list.AddRectFilled(low, high, over ? theme::kFieldHovered : theme::kField, rounding);
  const float x = low.x + (high.x - low.x) * std::clamp(fraction, 0.0f, 1.0f);
  if (x > low.x + 1) {
    list.PushClipRect(low, {x, high.y}, true);
    list.AddRectFilled(low, high, over ? theme::kFillHovered : theme::kFill, rounding);
    list.PopClipRect();
  }
}

}  // namespace

void beginFrame(Fonts& fonts) {
  registry.shown = std::move(registry.next);
  registry.next.clear();
  registry.scopes.clear();
  registry.fonts = &fonts;
}
void pushScope(const std::string& name) { registry.scopes.push_back(name); }
void popScope() { registry.scopes.pop_back(); }
void markRect(const std::string& name, ImVec2 low, ImVec2 high) { registry.next[scoped(name)] = {low, high}; }
void mark(const std::string& name) { markRect(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()); }
const Rect* find(const std::string& name) {
  const auto found = registry.shown.find(name);
  return found == registry.shown.end() ? nullptr : &found->second;
}
std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& [name, rect] : registry.shown) all.push_back(name);
  return all;
}
Fonts& fonts() { return *registry.fonts; }

void textDim(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextDim);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void textSmall(const std::string& text) {
  ImGui::PushFont(fonts().small());
  textDim(text);
  ImGui::PopFont();
}

void heading(const std::string& text) {
  ImGui::PushFont(fonts().heading());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

namespace {

void showTooltip(const std::string& text) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(9), theme::px(6)});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(theme::px(340));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace

void tooltip(const std::string& text) {
  if (!text.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) showTooltip(text);
}

std::string elided(const std::string& text, float room, ImFont* font) {
  if (!font) font = ImGui::GetFont();
  const auto width = [&](const std::string& t) { return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, t.c_str()).x; };
  if (width(text) <= room) return text;
  std::string kept = text;
  do {
    // A whole character goes, however many bytes it has.
    while (!kept.empty() && (kept.back() & 0xc0) == 0x80) kept.pop_back();
    if (!kept.empty()) kept.pop_back();
  } while (!kept.empty() && width(kept + "\u2026") > room);
  return kept + "\u2026";
}

void elidedText(ImVec2 at, float room, ImU32 color, const std::string& text, ImFont* font) {
  if (!font) font = ImGui::GetFont();
  const std::string shown = elided(text, room, font);
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, color, shown.c_str());
  const ImVec2 end = {at.x + room, at.y + font->FontSize};
  if (shown != text && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end)) showTooltip(text);
}

bool section(const char* title, bool open) {
  ImGui::PushFont(fonts().bold());
  ImGui::PushStyleColor(ImGuiCol_Header, theme::grey(42));
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered, theme::grey(48));
  ImGui::PushStyleColor(ImGuiCol_HeaderActive, theme::grey(52));
  const bool shown = ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  mark(title);
  ImGui::PopStyleColor(3);
  ImGui::PopFont();
  if (shown) ImGui::Dummy({0, theme::px(1)});
  return shown;
}

bool beginProperty(const std::string& label, const std::string& doc, bool canReset) {
  ImGui::PushID(label.c_str());
  const float width = ImGui::GetContentRegionAvail().x;
  const float labelWidth = std::floor(std::clamp(width * 0.38f, theme::px(70), theme::px(150)));
  const ImVec2 at = ImGui::GetCursorPos();
  ImGui::InvisibleButton("label", {labelWidth, ImGui::GetFrameHeight()});
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  mark(label + ":label");
  bool reset = canReset && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
  std::string tip = elided(label, high.x - low.x - theme::px(4)) == label ? "" : label;
  if (!doc.empty()) tip += (tip.empty() ? "" : "\n") + doc;
  if (canReset) tip += (tip.empty() ? "" : "\n") + std::string("Double-click to reset");
  tooltip(tip);
  if (canReset && ImGui::BeginPopupContextItem("menu")) {
    if (ImGui::MenuItem("Reset to default")) reset = true;
    ImGui::EndPopup();
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string shown = elided(label, high.x - low.x - theme::px(4));
  list.AddText({low.x, low.y + ImGui::GetStyle().FramePadding.y}, canReset ? theme::kText : theme::grey(190), shown.c_str());
  ImGui::SetCursorPos({at.x + labelWidth, at.y});
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::PushItemWidth(width - labelWidth);
  return reset;
}

void endProperty() {
  ImGui::PopItemWidth();
  ImGui::PopID();
}

bool slider(const std::string& label, float& value, float low, float high, const char* format) {
  const float width = ImGui::CalcItemWidth();
  ImGui::SetNextItemWidth(width);
  fieldWithFill(high > low ? (value - low) / (high - low) : 0, true);
  ImGui::SetNextItemWidth(width);
  for (ImGuiCol slot : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_SliderGrab,
                        ImGuiCol_SliderGrabActive})
    ImGui::PushStyleColor(slot, IM_COL32(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 1);
  const bool changed = ImGui::SliderFloat(hidden(label).c_str(), &value, low, high, format,
                                          ImGuiSliderFlags_NoRoundToFormat);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(5);
  mark(label);
  tooltip(ImGui::IsItemActive() ? "" : "Ctrl+click to type a value");
  return changed;
}

bool drag(const std::string& label, float* values, int count, float speed, float low, float high,
          const char* format) {
  const bool changed = ImGui::DragScalarN(hidden(label).c_str(), ImGuiDataType_Float, values, count, speed, &low,
                                          &high, format);
  mark(label);
  return changed;
}

bool color(const std::string& label, float* linear, float maximum) {
  // The picker works on what the eye sees, the value is light: what exceeds 1 becomes an intensity.
  const float peak = std::max({linear[0], linear[1], linear[2], 0.0f});
  float intensity = std::max(1.0f, peak);
  float shown[3];
  for (int i = 0; i < 3; ++i) shown[i] = srgbFromLinear(std::clamp(linear[i] / intensity, 0.0f, 1.0f));
  const float width = ImGui::CalcItemWidth();
  bool changed = false;
  ImGui::PushID(label.c_str());
  if (ImGui::ColorButton("##swatch", {shown[0], shown[1], shown[2], 1},
                         ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, {width, ImGui::GetFrameHeight()}))
    ImGui::OpenPopup("picker");
  mark(label);
  char text[96];
  std::snprintf(text, sizeof text, "linear %.3f  %.3f  %.3f\nsRGB #%02x%02x%02x", linear[0], linear[1], linear[2],
                int(shown[0] * 255 + 0.5f), int(shown[1] * 255 + 0.5f), int(shown[2] * 255 + 0.5f));
  tooltip(text);
  if (ImGui::BeginPopup("picker")) {
    ImGui::SetNextItemWidth(theme::px(220));
    changed |= ImGui::ColorPicker3("##picker", shown,
                                   ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_NoSidePreview |
                                       ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHex |
                                       ImGuiColorEditFlags_NoSmallPreview);
    if (maximum > 1) {
      ImGui::SetNextItemWidth(theme::px(220));
      changed |= ImGui::DragFloat("##intensity", &intensity, 0.05f, 1, maximum, "intensity %.2f");
    }
    ImGui::EndPopup();
  }
  ImGui::PopID();
  if (changed)
    for (int i = 0; i < 3; ++i) linear[i] = linearFromSrgb(shown[i]) * intensity;
  return changed;
}

bool checkbox(const std::string& label, bool& value) {
  const bool changed = ImGui::Checkbox(hidden(label).c_str(), &value);
  mark(label);
  return changed;
}

bool choice(const std::string& label, int& index, std::span<const std::string> names,
            std::span<const std::string> docs) {
  const std::string shown = index >= 0 && index < int(names.size()) ? names[size_t(index)] : "";
  bool changed = false;
  if (ImGui::BeginCombo(hidden(label).c_str(), shown.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (int i = 0; i < int(names.size()); ++i) {
      if (ImGui::Selectable((names[size_t(i)] + "##" + std::to_string(i)).c_str(), i == index)) {
        changed = i != index;
        index = i;
      }
      mark(label + ":" + names[size_t(i)]);
      if (size_t(i) < docs.size()) tooltip(docs[size_t(i)]);
    }
    ImGui::EndCombo();
  } else {
    mark(label);
  }
  return changed;
}

bool text(const std::string& label, std::string& value, const char* hint) {
  ImGui::InputTextWithHint(hidden(label).c_str(), hint, &value);
  const bool finished = ImGui::IsItemDeactivatedAfterEdit();
  mark(label);
  return finished;
}

bool valueProperty(const std::string& label, const std::string& doc, Value& value, float low, float high,
                   const Value& standard) {
  if (beginProperty(label, doc, true) && !(value == standard)) {
    value = standard;
    endProperty();
    return true;
  }
  bool changed = false;
  const bool ranged = high > low && high - low < 1e4f;
  const float speed = ranged ? (high - low) / 300 : 0.01f;
  switch (value.type) {
    case ValueType::Bool: {
      bool on = value.v[0] != 0;
      if ((changed = checkbox(label, on))) value.v[0] = on;
      break;
    }
    case ValueType::Int:
      changed = ranged ? slider(label, value.v[0], low, high, "%.0f") : drag(label, value.v.data(), 1, 0.05f, -1e9f, 1e9f, "%.0f");
      if (changed) value.v[0] = std::round(value.v[0]);
      break;
    case ValueType::Color: changed = color(label, value.v.data(), std::max(high, 1.0f)); break;
    case ValueType::Float:
      changed = ranged ? slider(label, value.v[0], low, high) : drag(label, value.v.data(), 1, speed, -FLT_MAX, FLT_MAX);
      break;
    case ValueType::Vec2:
    case ValueType::Vec3:
    case ValueType::Vec4:
      changed = drag(label, value.v.data(), componentCount(value.type), speed, ranged ? low : -FLT_MAX, ranged ? high : FLT_MAX);
      break;
    default: textDim("on the wire only"); break;
  }
  for (float& x : value.v)
    if (!std::isfinite(x)) x = 0;
  endProperty();
  return changed;
}

bool button(const std::string& label, bool primary, float width) {
  if (primary) {
    ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(186, 112, 46, 255));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, IM_COL32(204, 126, 56, 255));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, IM_COL32(220, 140, 66, 255));
  }
  const std::string text = label.substr(0, label.find("##"));
  const std::string shown = width > 0 ? elided(text, width - 2 * theme::px(4)) : text;
  if (shown != text) ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme::px(4), ImGui::GetStyle().FramePadding.y});
  const bool pressed = ImGui::Button((shown + "###" + label).c_str(), {width, 0});
  if (shown != text) ImGui::PopStyleVar();
  if (primary) ImGui::PopStyleColor(3);
  mark(text);
  if (shown != text) tooltip(text);
  return pressed;
}

bool toggle(const std::string& label, bool on, float width) {
  ImGui::PushStyleColor(ImGuiCol_Button, on ? theme::grey(78) : theme::grey(0, 0));
  ImGui::PushStyleColor(ImGuiCol_Text, on ? theme::kText : theme::kTextDim);
  const bool pressed = ImGui::Button(label.c_str(), {width, 0});
  ImGui::PopStyleColor(2);
  mark(label.substr(0, label.find("##")));
  return pressed;
}

bool segments(const std::string& label, int& index, std::span<const std::string> names) {
  const float width = ImGui::CalcItemWidth();
  const float each = std::floor(width / float(names.size()));
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + each * float(names.size()), low.y + ImGui::GetFrameHeight()}, theme::kField,
                                            ImGui::GetStyle().FrameRounding);
  bool changed = false;
  ImGui::PushID(label.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme::px(2), ImGui::GetStyle().FramePadding.y});
  for (int i = 0; i < int(names.size()); ++i) {
    if (i) ImGui::SameLine(0, 0);
    ImGui::PushStyleColor(ImGuiCol_Button, i == index ? theme::grey(78) : theme::grey(0, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, i == index ? theme::kText : theme::kTextDim);
    if (ImGui::Button(names[size_t(i)].c_str(), {each, 0})) {
      changed = i != index;
      index = i;
    }
    ImGui::PopStyleColor(2);
    mark(label + ":" + names[size_t(i)]);
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

bool row(const std::string& name, const std::string& title, const std::string& detail, bool selected) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  const bool pressed = ImGui::Selectable(hidden(name).c_str(), selected, ImGuiSelectableFlags_AllowDoubleClick, {width, height});
  mark(name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = low.y + (height - ImGui::GetFontSize()) / 2;
  const float detailWidth = detail.empty() ? 0 : ImGui::CalcTextSize(detail.c_str()).x + theme::px(8);
  const std::string shown = elided(title, width - detailWidth - theme::px(12));
  list.AddText({low.x + theme::px(6), y}, theme::kText, shown.c_str());
  if (shown != title) tooltip(title);
  if (!detail.empty()) list.AddText({low.x + width - detailWidth, y}, theme::kTextDim, detail.c_str());
  return pressed;
}

bool beginQuestion(const char* title, bool& wanted) {
  if (std::exchange(wanted, false)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y * 0.42f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(theme::px(460), display.x * 0.9f), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(18), theme::px(16)});
  const bool open = ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar |
                                                              ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  if (open) {
    heading(title);
    ImGui::Dummy({0, theme::px(4)});
  }
  return open;
}

void diagnostic(const Diagnostic& d) {
  const bool wrong = d.severity == Severity::Error;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFontSize();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + size * 0.4f, at.y + size * 0.5f}, size * 0.27f,
                                              wrong ? theme::kError : theme::kWarning);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + size * 1.1f);
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(d.what.c_str());
  ImGui::PopTextWrapPos();
  textSmall(d.hint.empty() ? d.place : d.place + "  \u00b7  " + d.hint);
  ImGui::EndGroup();
}

}  // namespace glint::ui
