// The editor's widgets. Every one of them records where it lies under its name, so that a test (or a script) can
// address it as a person would: by what it says.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/value.h"

struct ImGuiWindow;

namespace glint {
class Fonts;
}

namespace glint::ui {

struct Rect {
  ImVec2 low, high;
  ImVec2 center() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

// Names of this frame's widgets. `panel` names prefix what is drawn inside them: "Properties/roughness".
void beginFrame(Fonts&);
void pushScope(const std::string&);
void popScope();
void mark(const std::string& name);                     // the item just submitted
void markRect(const std::string& name, ImVec2 low, ImVec2 high);
const Rect* find(const std::string& name);              // of the last finished frame; null when not there
std::vector<std::string> names();
Fonts& fonts();

// Text in a named face; the plain one is ImGui's own.
void textDim(const std::string&);
void textSmall(const std::string&);
void heading(const std::string&);
void tooltip(const std::string&);                       // over the item just submitted, after a moment

// The text, or as much of it as there is room for, ending in an ellipsis. `font` null: ImGui's own.
std::string elided(const std::string&, float room, ImFont* font = nullptr);
// Draws that; where something had to go, the pointer finds the whole.
void elidedText(ImVec2 at, float room, ImU32 color, const std::string&, ImFont* font = nullptr);

// A titled part of a panel; false when folded.
bool section(const char* title, bool open = true);

// A property: its label on the left (double click or its menu resets), its widget on the right. `beginProperty`
// returns true when it is to be reset.
bool beginProperty(const std::string& label, const std::string& doc = {}, bool canReset = false);
void endProperty();

// Widgets of a property line; true when the value changed. `label` is the name they are known under.
bool slider(const std::string& label, float& value, float low, float high, const char* format = "%.3f");
bool drag(const std::string& label, float* values, int count, float speed, float low, float high,
          const char* format = "%.3f");
bool color(const std::string& label, float* linearRgb, float maximum = 1);   // linear Rec.709 in and out
bool checkbox(const std::string& label, bool& value);
bool choice(const std::string& label, int& index, std::span<const std::string> names,
            std::span<const std::string> docs = {});
bool text(const std::string& label, std::string& value, const char* hint = "");  // true on Enter or leaving it

// A whole property line for a value of a numeric type: sliders where there is a range, a picker for colours.
bool valueProperty(const std::string& label, const std::string& doc, Value& value, float low, float high,
                   const Value& standard);

bool button(const std::string& label, bool primary = false, float width = 0);
bool toggle(const std::string& label, bool on, float width = 0);    // a button that stays down
bool segments(const std::string& label, int& index, std::span<const std::string> names);
// A row of a list: title, and dim detail on the right; true when clicked.
bool row(const std::string& name, const std::string& title, const std::string& detail, bool selected);

// A centred question, asked once `wanted` is set; returns whether it is open: then it is filled, and ended by
// ImGui::EndPopup().
bool beginQuestion(const char* title, bool& wanted);

void diagnostic(const Diagnostic&);

}  // namespace glint::ui
