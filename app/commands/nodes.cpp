// glint nodes: every kind of node that a material's graph can have.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "materials/base/log.h"
#include "materials/node_registry.h"

namespace glint {
namespace {

using nlohmann::ordered_json;

std::string standardText(const Pin& pin) {
  if (!pin.surface.empty()) return pin.surface;
  return componentCount(pin.standard.type) > 0 ? valueText(pin.standard) : "";
}

ordered_json pinsJson(const std::vector<Pin>& pins, bool inputs) {
  ordered_json list = ordered_json::array();
  for (const Pin& pin : pins) {
    ordered_json json = {{"name", pin.name}, {"title", pin.title}, {"type", name(pin.type)}};
    if (inputs) {
      json["default"] = standardText(pin);
      json["min"] = pin.minimum;
      json["max"] = pin.maximum;
    }
    if (!pin.doc.empty()) json["doc"] = pin.doc;
    list.push_back(std::move(json));
  }
  return list;
}

ordered_json kindJson(const NodeKind& kind, const NodePins& pins) {
  ordered_json settings = ordered_json::array();
  for (const SettingInfo& setting : kind.settings) {
    ordered_json json = {{"name", setting.name}, {"title", setting.title}, {"doc", setting.doc}};
    if (!setting.values.empty()) json["values"] = setting.values;
    if (!setting.standard.text.empty()) json["default"] = setting.standard.text;
    settings.push_back(std::move(json));
  }
  return {{"id", kind.id},
          {"title", kind.title},
          {"category", kind.category},
          {"doc", kind.doc},
          {"file", kind.file},
          {"inputs", pinsJson(pins.inputs, true)},
          {"outputs", pinsJson(pins.outputs, false)},
          {"settings", settings}};
}

std::string signature(const NodePins& pins) {
  const auto join = [](const std::vector<Pin>& list) {
    std::string text;
    for (const Pin& pin : list) text += (text.empty() ? "" : ", ") + pin.name;
    return text;
  };
  return fmt::format("({}) -> {}", join(pins.inputs), join(pins.outputs));
}

void printKind(const NodeKind& kind, const NodePins& pins) {
  // As wide as what stands in them.
  size_t names = 0, types = 6, standards = 0;  // "choice"
  const auto widen = [&](const std::string& title, std::string_view type, const std::string& standard) {
    names = std::max(names, title.size());
    types = std::max(types, type.size());
    standards = std::max(standards, standard.size());
  };
  for (const Pin& pin : pins.inputs) widen(pin.name, name(pin.type), standardText(pin));
  for (const Pin& pin : pins.outputs) widen(pin.name, name(pin.type), "");
  for (const SettingInfo& setting : kind.settings) widen(setting.name, "", setting.standard.text);
  const auto line = [&](const char* what, const std::string& title, std::string_view type, const std::string& standard, const std::string& doc) {
    std::string text = fmt::format("  {}  {:<{}}  {:<{}}  {:<{}}  {}", what, title, names, type, types, standard, standards, doc);
    text.erase(text.find_last_not_of(' ') + 1);
    fmt::print("{}\n", text);
  };
  fmt::print("{} ({})\n{}\n", kind.id, kind.title, kind.doc);
  for (const Pin& pin : pins.inputs) line("in ", pin.name, name(pin.type), standardText(pin), pin.doc);
  for (const Pin& pin : pins.outputs) line("out", pin.name, name(pin.type), "", pin.doc);
  for (const SettingInfo& setting : kind.settings)
    line("set", setting.name, setting.values.empty() ? "" : "choice", setting.standard.text, setting.doc);
  if (!kind.file.empty()) fmt::print("  {}\n", kind.file);
}

int run(const Arguments& arguments) {
  const NodeRegistry registry;
  const GraphContext context{registry};
  const auto pins = [&](const NodeKind& kind) { return pinsOf(Node{.kind = kind.id}, context); };
  std::vector<const NodeKind*> chosen;
  Diagnostics unknown;
  for (const std::string& id : arguments.all("ids")) {
    if (const NodeKind* kind = registry.find(id))
      chosen.push_back(kind);
    else
      unknown.push_back(error(fmt::format("node '{}'", id), "is unknown", suggestion(id, registry.ids())));
  }
  if (!unknown.empty()) return badInput(unknown);
  const bool single = !chosen.empty();
  if (!single) chosen = registry.all();
  log::report(registry.problems());

  if (arguments.json) {
    ordered_json list = ordered_json::array();
    for (const NodeKind* kind : chosen) list.push_back(kindJson(*kind, *pins(*kind)));
    fmt::print("{}\n", ordered_json{{"nodes", list}}.dump(2, ' ', false, ordered_json::error_handler_t::replace));
    return kDone;
  }
  std::string category;
  for (const NodeKind* kind : chosen) {
    if (single) {
      printKind(*kind, *pins(*kind));
      continue;
    }
    if (kind->category != category) fmt::print("{}{}\n", category.empty() ? "" : "\n", kind->category);
    category = kind->category;
    const bool attributes = kind->category == "Attributes";
    fmt::print("  {:<18}{}{}\n", kind->id, kind->doc, attributes ? "" : "  " + signature(*pins(*kind)));
  }
  return kDone;
}

}  // namespace

extern const Command kNodesCommand;
const Command kNodesCommand = {
    .name = "nodes",
    .summary = "List the nodes that a material's graph can have",
    .options = {{.name = "ids", .argument = "ID", .help = "only these, with every pin", .repeatable = true}},
    .examples = {"glint nodes", "glint nodes noise blend-attributes", "glint nodes --json"},
    .run = run,
};

}  // namespace glint
