#include "app/editor/node_values.h"

#include <algorithm>
#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "materials/front_matter.h"

namespace glint {

Json jsonFromValue(const Value& value) {
  if (value.type == ValueType::Bool) return Json::of(value.v[0] != 0);
  if (value.type == ValueType::Int) return Json::of(int(value.v[0]));
  const int count = componentCount(value.type);
  if (count <= 1) return Json::of(value.v[0]);
  Json json = Json::array();
  for (int i = 0; i < count; ++i) json.push(Json::of(value.v[size_t(i)]));
  return json;
}

Value inputValue(const Node& node, const Pin& pin) {
  const auto input = node.inputs.find(pin.name);
  return input != node.inputs.end() && input->second.value ? *input->second.value : pin.standard;
}

std::string pinTitle(const Pin& pin) { return pin.title.empty() ? pin.name : pin.title; }

bool editable(const Pin& pin) {
  if (pin.type.kind == PinType::Kind::Any) return false;
  return pin.type.kind == PinType::Kind::Numeric || componentCount(pin.type.type) > 0;
}

std::string passedThrough(const Node& node, const Pin& pin) {
  const auto given = node.inputs.find(pin.name);
  if (!pin.optional || (given != node.inputs.end() && !given->second.empty())) return {};
  const auto bundle = node.inputs.find("attributes");
  return bundle != node.inputs.end() && bundle->second.from ? bundle->second.from->text() : std::string();
}

void inputProperty(Editor& editor, const NodeId& id, const Node& node, const Pin& pin) {
  Document& document = editor.document();
  const auto input = node.inputs.find(pin.name);
  const std::string title = pinTitle(pin);
  if (input != node.inputs.end() && input->second.from) {
    ui::beginProperty(title, pin.doc);
    const float width = ImGui::CalcItemWidth(), cut = ImGui::GetFrameHeight();
    ImGui::PushStyleColor(ImGuiCol_Button, theme::grey(42));
    const float room = width - cut - theme::px(4);
    if (ImGui::Button((ui::elided("\u2190 " + input->second.from->text(), room - 2 * theme::px(8)) + "###source").c_str(), {room, 0}))
      editor.selection() = {input->second.from->node};
    ui::mark(title);
    ui::tooltip("Select the node that feeds it");
    ImGui::SameLine(0, theme::px(4));
    if (ImGui::Button("\u00d7", {cut, 0}))
      editor.refused(document.edit("Disconnect " + title, [&](GraphEditor& graph) { return graph.disconnect({id, pin.name}); }));
    ui::mark(title + ":disconnect");
    ImGui::PopStyleColor();
    ui::endProperty();
    return;
  }
  if (!editable(pin)) return;
  const bool given = input != node.inputs.end() && input->second.value;
  if (!pin.surface.empty() && !given) {
    ui::beginProperty(title, pin.doc);
    ImGui::AlignTextToFramePadding();
    ui::textDim("surface " + pin.surface);
    ui::endProperty();
    return;
  }
  if (const std::string bundle = passedThrough(node, pin); !bundle.empty()) {
    ui::beginProperty(title, pin.doc);
    if (ui::button("from " + bundle + "##" + title, false, ImGui::CalcItemWidth()))
      editor.refused(document.edit("Set " + title, [&](GraphEditor& graph) { return graph.setValue({id, pin.name}, pin.standard); }));
    ui::tooltip("Click to give it a value of its own instead");
    ui::endProperty();
    return;
  }
  Value value = inputValue(node, pin);
  if (!ui::valueProperty(title, pin.doc, value, pin.minimum, pin.maximum, pin.standard)) return;
  editor.refused(document.edit("Set " + title, [&](GraphEditor& graph) {
    return value == pin.standard ? graph.resetValue({id, pin.name}) : graph.setValue({id, pin.name}, value);
  }));
}

void settingProperty(Editor& editor, const NodeId& id, const Node& node, const SettingInfo& setting) {
  Document& document = editor.document();
  const std::string title = setting.title.empty() ? setting.name : setting.title;
  const auto given = node.settings.find(setting.name);
  const Json now = given == node.settings.end() ? setting.standard : given->second;
  const auto set = [&](const Json& json) {
    editor.refused(document.edit("Set " + title, [&](GraphEditor& graph) { return graph.setSetting(id, setting.name, json); }));
  };
  if (setting.type == SettingInfo::Type::Value) {
    const ValueType type = valueType(settingText(node, "type", "float")).value_or(ValueType::Float);
    if (componentCount(type) == 0) return;
    Value value = valueFromJson(now, type).value_or(Value{type, {}});
    const float low = settingNumber(node, "min", 0), high = settingNumber(node, "max", 1);
    const Value standard = valueFromJson(setting.standard, type).value_or(Value{type, {}});
    if (ui::valueProperty(title, setting.doc, value, low, high, standard)) set(jsonFromValue(value));
    return;
  }
  const bool reset = ui::beginProperty(title, setting.doc, given != node.settings.end());
  switch (setting.type) {
    case SettingInfo::Type::Choice: {
      int index = int(std::find(setting.values.begin(), setting.values.end(), now.text) - setting.values.begin());
      if (ui::choice(title, index, setting.values)) set(Json::of(setting.values[size_t(index)]));
      break;
    }
    case SettingInfo::Type::Bool: {
      bool on = now.boolean;
      if (ui::checkbox(title, on)) set(Json::of(on));
      break;
    }
    case SettingInfo::Type::Int: {
      float value = float(now.number);
      if (ui::slider(title, value, setting.minimum, setting.maximum, "%.0f")) set(Json::of(int(std::round(value))));
      break;
    }
    case SettingInfo::Type::Number: {
      float value = float(now.number);
      if (ui::drag(title, &value, 1, 0.01f, -1e6f, 1e6f)) set(Json::of(value));
      break;
    }
    case SettingInfo::Type::Text: {
      // Kept while it is typed; the material has it when the field is left.
      static std::string typed, owner;
      const std::string field = id + "." + setting.name;
      std::string shown = owner == field ? typed : now.text;
      const bool finished = ui::text(title, shown);
      if (ImGui::IsItemActive()) {
        owner = field;
        typed = shown;
      } else if (owner == field) {
        owner.clear();
      }
      if (finished && shown != now.text) set(Json::of(shown));
      break;
    }
    case SettingInfo::Type::File: {
      const std::string name = now.text.empty() ? "Choose a picture\u2026" : std::filesystem::path(now.text).filename().string();
      if (ImGui::Button(name.c_str(), {ImGui::CalcItemWidth(), 0}))
        editor.browse({.title = "Choose a picture", .extensions = {".png", ".jpg", ".jpeg"},
                       .chosen = [&editor, id, key = setting.name](const std::filesystem::path& file) {
                         const std::string named = editor.document().nameFile(file).string();
                         editor.refused(editor.document().edit("Choose picture", [&](GraphEditor& graph) {
                           return graph.setSetting(id, key, Json::of(named));
                         }));
                       }});
      ui::mark(title);
      ui::tooltip(now.text);
      break;
    }
    case SettingInfo::Type::Function: {
      const std::vector<std::string> names = editor.functions().names();
      int index = int(std::find(names.begin(), names.end(), now.text) - names.begin());
      if (ui::choice(title, index, names)) set(Json::of(names[size_t(index)]));
      break;
    }
    case SettingInfo::Type::Value: break;
  }
  ui::endProperty();
  if (reset)
    editor.refused(document.edit("Reset " + title, [&](GraphEditor& graph) { return graph.resetSetting(id, setting.name); }));
}

}  // namespace glint
