// Widgets for what a node is given: constants on its pins and its settings. Shared by the properties and the canvas.
#pragma once

#include <string>

#include "materials/graph.h"
#include "materials/node.h"

namespace glint {

class Editor;

// As a node's settings hold it; valueFromJson() of materials/front_matter.h reads it back.
Json jsonFromValue(const Value&);

// What an input pin is now, wire aside.
Value inputValue(const Node&, const Pin&);
std::string pinTitle(const Pin&);
bool editable(const Pin&);                  // has a constant that a widget can show

// What feeds the bundle on the node's pin `attributes`, when that is where an optional pin's value comes from; else "".
std::string passedThrough(const Node&, const Pin&);

// One property line for an input: its widget, or what feeds it.
void inputProperty(Editor&, const NodeId&, const Node&, const Pin&);
// One property line for a setting.
void settingProperty(Editor&, const NodeId&, const Node&, const SettingInfo&);

}  // namespace glint
