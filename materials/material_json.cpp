#include "materials/material_json.h"

#include <algorithm>
#include <cmath>

#include "materials/attributes.h"
#include "materials/base/files.h"
#include "materials/front_matter.h"

namespace glint {
namespace {

const std::vector<std::string> kDocumentKeys = {"glint", "version",         "name",  "doc",
                                                "model", "modelParameters", "nodes", "layout"};

// A constant by its shape: the pin's type is settled later, when it is known.
std::optional<Value> valueByShape(const Json& json) {
  if (json.isBool()) return valueFromJson(json, ValueType::Bool);
  if (json.isNumber()) return valueFromJson(json, ValueType::Float);
  if (json.isString()) return valueFromJson(json, ValueType::Color);
  if (json.isArray() && json.items.size() >= 2 && json.items.size() <= 4)
    return valueFromJson(json, static_cast<ValueType>(static_cast<int>(ValueType::Vec2) + json.items.size() - 2));
  return std::nullopt;
}

// Reads one document; collects every fault.
class Reader {
 public:
  Reader(const std::string& file, const NodeRegistry& nodes, Diagnostics& errors, Diagnostics& warnings)
      : file_(file), nodes_(nodes), errors_(errors), warnings_(warnings),
        lines_(std::make_shared<SourceLines>()) {}

  std::shared_ptr<SourceLines> lines() const { return lines_; }
  void modelLine(int line) { lines_->model = line; }

  void fail(const Json& at, std::string what, std::string hint = {}) {
    errors_.push_back(error(place(at), std::move(what), std::move(hint)));
  }

  // The member, when it is there and of that kind; another kind is an error.
  const Json* member(const Json& object, const char* key, Json::Kind kind) {
    const Json* found = object.find(key);
    if (!found || found->kind == kind) return found;
    fail(*found, fmt::format("'{}' must be {}, not {}", key, name(kind), name(found->kind)), writtenAs(kind));
    return nullptr;
  }

  bool version(const Json& document) {
    const Json* version = document.find("version");
    if (!version) {
      fail(document, "'version' is missing", fmt::format("this program writes \"version\": {}", kMaterialVersion));
      return false;
    }
    if (!version->isNumber() || version->number != std::floor(version->number) || version->number < 1) {
      fail(*version, "'version' must be a whole number from 1", fmt::format("this program writes \"version\": {}", kMaterialVersion));
      return false;
    }
    if (version->number > kMaterialVersion) {
      fail(*version, fmt::format("version {} is newer than this program, which knows {}", version->text,
                                 kMaterialVersion),
           "open it with the Glint that wrote it, or a later one");
      return false;
    }
    return true;
  }

  void readNodes(const Json& document, std::map<NodeId, Node>& nodes) {
    const Json* list = member(document, "nodes", Json::Kind::Object);
    if (!list) return;
    if (list->items.size() > kMostNodes)
      return fail(*list, fmt::format("{} nodes, more than the {} that fit", list->items.size(), kMostNodes), "put parts of it into functions");
    for (size_t i = 0; i < list->items.size(); ++i) {
      const std::string& id = list->keys[i];
      const Json& json = list->items[i];
      if (!validNodeId(id)) {
        fail(json, fmt::format("'{}' is no node id", id.substr(0, 80)), "letters, digits, '-' and '_', at most 64");
        continue;
      }
      if (!json.isObject()) {
        fail(json, fmt::format("node '{}' must be an object, not {}", id, name(json.kind)), "write {\"kind\": ...}");
        continue;
      }
      lines_->nodes[id] = json.line;
      readNode(id, json, nodes[id]);
    }
  }

  void readLayout(const Json& document, std::map<NodeId, Position>& layout) {
    const Json* list = member(document, "layout", Json::Kind::Object);
    if (!list) return;
    for (size_t i = 0; i < list->items.size(); ++i) {
      const auto at = valueFromJson(list->items[i], ValueType::Vec2);
      if (!validNodeId(list->keys[i]) || !list->items[i].isArray() || !at)
        fail(list->items[i], fmt::format("layout of '{}' must be [x, y]", list->keys[i].substr(0, 80)), "two numbers, and a node's id for their key");
      else
        layout[list->keys[i]] = {at->v[0], at->v[1]};
    }
  }

  void readParameters(const Json& document, std::map<std::string, Value>& parameters) {
    const Json* list = member(document, "modelParameters", Json::Kind::Object);
    if (!list) return;
    for (size_t i = 0; i < list->items.size(); ++i) {
      if (const auto value = valueByShape(list->items[i]))
        parameters[list->keys[i]] = *value;
      else
        fail(list->items[i], fmt::format("model parameter '{}' is no constant", list->keys[i].substr(0, 80)),
             "a number, an array of 2 to 4, true or false");
    }
  }

  void keepUnknown(const Json& document, std::map<std::string, Json>& extra) {
    for (size_t i = 0; i < document.keys.size(); ++i) {
      const std::string& key = document.keys[i];
      if (std::find(kDocumentKeys.begin(), kDocumentKeys.end(), key) != kDocumentKeys.end()) continue;
      warnings_.push_back(warning(place(document.items[i]), fmt::format("unknown key '{}' is kept", key.substr(0, 80)),
                                  suggestion(key, kDocumentKeys)));
      extra[key] = document.items[i];
    }
  }

 private:
  std::string place(const Json& at) const {
    return at.line > 0 ? fmt::format("{}:{}", file_, at.line) : file_;
  }

  void readNode(const NodeId& id, const Json& json, Node& node) {
    const Json* kindName = member(json, "kind", Json::Kind::String);
    if (!kindName) {
      if (!json.find("kind")) fail(json, fmt::format("node '{}' has no 'kind'", id), "add \"kind\": ...; 'glint nodes' lists them");
      return;
    }
    node.kind = kindName->text;
    const NodeKind* kind = nodes_.find(node.kind);
    for (size_t i = 0; i < json.keys.size(); ++i) {
      const std::string& key = json.keys[i];
      if (key == "kind" || key == "inputs") continue;
      if (kind && !kind->setting(key)) {
        std::vector<std::string> known = {"kind", "inputs"};
        for (const SettingInfo& setting : kind->settings) known.push_back(setting.name);
        warnings_.push_back(warning(place(json.items[i]),
                                    fmt::format("node '{}': unknown key '{}' is kept", id, key.substr(0, 80)),
                                    suggestion(key, known)));
      }
      node.settings[key] = json.items[i];
    }
    const Json* inputs = member(json, "inputs", Json::Kind::Object);
    if (!inputs) return;
    for (size_t i = 0; i < inputs->items.size(); ++i) {
      const std::string& pin = inputs->keys[i];
      lines_->pins[{id, pin}] = inputs->items[i].line;
      Input input;
      if (readInput(id, pin, inputs->items[i], input)) {
        settle(kind, pin, input);
        node.inputs[pin] = std::move(input);
      }
    }
  }

  bool readInput(const NodeId& id, const std::string& pin, const Json& json, Input& input) {
    if (json.isObject()) {
      const Json* from = json.find("from");
      const Json* value = json.find("value");
      bool good = from || value;
      for (const std::string& key : json.keys) good = good && (key == "from" || key == "value");
      if (good && from) good = from->isString() && readWire(from->text, input);
      if (good && value) good = (input.value = valueByShape(*value)).has_value();
      if (!good)
        fail(json, fmt::format("node '{}' pin '{}' is neither a constant nor a wire", id, pin.substr(0, 80)),
             "{\"from\": \"node.pin\", \"value\": constant}");
      return good;
    }
    if (json.isString() && !json.text.starts_with('#')) {
      if (readWire(json.text, input)) return true;
      fail(json, fmt::format("node '{}' pin '{}': '{}' is no wire", id, pin.substr(0, 80), json.text.substr(0, 80)),
           "\"node.pin\"");
      return false;
    }
    input.value = valueByShape(json);
    if (!input.value)
      fail(json, fmt::format("node '{}' pin '{}' must be a constant or a wire, not {}", id, pin.substr(0, 80),
                             name(json.kind)),
           "a number, an array of 2 to 4, true or false, \"#rrggbb\" or \"node.pin\"");
    return input.value.has_value();
  }

  static bool readWire(const std::string& text, Input& input) {
    const size_t dot = text.find('.');
    if (dot == text.npos || dot + 1 == text.size() || text.size() > 200) return false;
    if (!validNodeId(text.substr(0, dot))) return false;
    input.from = PinRef{text.substr(0, dot), text.substr(dot + 1)};
    return true;
  }

  // An array of three is a vec3 until its pin says that it is a colour.
  static void settle(const NodeKind* kind, const std::string& pin, Input& input) {
    if (!kind || !input.value || input.value->type != ValueType::Vec3) return;
    const Pin* known = kind->input(pin);
    const Attribute* attribute = known ? nullptr : findAttribute(pin);
    if ((known && known->type == PinType::exact(ValueType::Color)) ||
        (attribute && attribute->standard.type == ValueType::Color))
      input.value->type = ValueType::Color;
  }

  std::string file_;
  const NodeRegistry& nodes_;
  Diagnostics& errors_;
  Diagnostics& warnings_;
  std::shared_ptr<SourceLines> lines_;
};

Json nodesJson(const std::map<NodeId, Node>& nodes) {
  Json list = Json::object();
  for (const auto& [id, node] : nodes) {
    Json& json = list.set(id, Json::object());
    json.set("kind", Json::of(node.kind));
    for (const auto& [key, value] : node.settings) json.set(key, value);
    if (node.inputs.empty()) continue;
    Json inputs = Json::object();
    for (const auto& [pin, input] : node.inputs) {
      if (input.empty()) continue;
      if (input.from && input.value) {
        Json both = Json::object();
        both.set("from", Json::of(input.from->text()));
        both.set("value", valueToJson(*input.value));
        inputs.set(pin, std::move(both));
      } else {
        inputs.set(pin, input.from ? Json::of(input.from->text()) : valueToJson(*input.value));
      }
    }
    json.set("inputs", std::move(inputs));
  }
  return list;
}

Json layoutJson(const std::map<NodeId, Position>& layout) {
  Json list = Json::object();
  for (const auto& [id, at] : layout) {
    Json place = Json::array();
    place.push(Json::of(at.x));
    place.push(Json::of(at.y));
    list.set(id, std::move(place));
  }
  return list;
}

constexpr JsonLimits kLimits = {.bytes = kLargestMaterialFile, .values = 1'000'000, .depth = 32};

void append(Diagnostics* to, const Diagnostics& from) {
  if (to) to->insert(to->end(), from.begin(), from.end());
}

}  // namespace

Result<Material> parseMaterial(const std::string& text, const std::filesystem::path& file,
                               const NodeRegistry& registry, Diagnostics* warnings) {
  const std::string placeName = file.empty() ? "material" : file.string();
  auto json = parseJson(text, placeName, 1, kLimits);
  if (!json) return json.diagnostics();
  if (!json->isObject())
    return error(fmt::format("{}:{}", placeName, json->line), fmt::format("is {}, not a material", name(json->kind)),
                 "a material file is an object with \"glint\": \"material\"");
  Diagnostics errors, found;
  Reader reader(placeName, registry, errors, found);
  Material material;
  const Json* kind = reader.member(*json, "glint", Json::Kind::String);
  if (!kind) {
    if (!json->find("glint"))
      return error(placeName + ":1", "is not a material of Glint", "\"glint\": \"material\" is missing");
    return errors;
  }
  if (const auto known = documentKind(kind->text))
    material.kind = *known;
  else
    reader.fail(*kind, fmt::format("'{}' is no kind of document", kind->text.substr(0, 80)),
                suggestion(kind->text, {"material", "function", "layer"}));
  if (!reader.version(*json)) return errors;
  if (const Json* given = reader.member(*json, "name", Json::Kind::String)) material.name = given->text;
  if (material.name.empty()) material.name = file.stem().string();
  if (const Json* doc = reader.member(*json, "doc", Json::Kind::String)) material.doc = doc->text;
  if (const Json* model = reader.member(*json, "model", Json::Kind::String)) {
    material.model = model->text;
    reader.modelLine(model->line);
  }
  reader.readParameters(*json, material.modelParameters);
  reader.readNodes(*json, material.nodes);
  reader.readLayout(*json, material.layout);
  reader.keepUnknown(*json, material.extra);
  append(warnings, found);
  if (!errors.empty()) return errors;
  material.file = file;
  material.lines = reader.lines();
  return material;
}

std::string materialText(const Material& material) {
  Json json = Json::object();
  json.set("glint", Json::of(std::string(name(material.kind))));
  json.set("version", Json::of(kMaterialVersion));
  json.set("name", Json::of(material.name));
  if (!material.doc.empty()) json.set("doc", Json::of(material.doc));
  if (material.kind == DocumentKind::Material) json.set("model", Json::of(material.model));
  if (!material.modelParameters.empty()) {
    Json parameters = Json::object();
    for (const auto& [key, value] : material.modelParameters) parameters.set(key, valueToJson(value));
    json.set("modelParameters", std::move(parameters));
  }
  for (const auto& [key, value] : material.extra) json.set(key, value);
  json.set("nodes", nodesJson(material.nodes));
  json.set("layout", layoutJson(material.layout));
  return writeJson(json);
}

Result<Material> readMaterial(const std::filesystem::path& file, const NodeRegistry& registry,
                              Diagnostics* warnings) {
  auto text = readFile(file, kLargestMaterialFile);
  if (!text) return text.diagnostics();
  return parseMaterial(*text, file, registry, warnings);
}

Diagnostics writeMaterial(const std::filesystem::path& file, Material& material) {
  Diagnostics problems = writeFileAtomic(file, materialText(material));
  if (problems.empty()) material.file = file;
  return problems;
}

std::string clipText(const Clip& clip) {
  Json json = Json::object();
  json.set("glint", Json::of("clip"));
  json.set("version", Json::of(kMaterialVersion));
  json.set("nodes", nodesJson(clip.nodes));
  json.set("layout", layoutJson(clip.layout));
  return writeJson(json);
}

Result<Clip> parseClip(const std::string& text, const NodeRegistry& registry) {
  auto json = parseJson(text, "clipboard", 1, kLimits);
  if (!json) return json.diagnostics();
  const Json* kind = json->find("glint");
  if (!kind || !kind->isString() || kind->text != "clip")
    return error("clipboard", "holds no nodes", "copy some from a graph first");
  Diagnostics errors, warnings;
  Reader reader("clipboard", registry, errors, warnings);
  Clip clip;
  if (reader.version(*json)) {
    reader.readNodes(*json, clip.nodes);
    reader.readLayout(*json, clip.layout);
  }
  if (!errors.empty()) return errors;
  return clip;
}

}  // namespace glint
