#include "materials/node.h"

#include <algorithm>
#include <cctype>

#include "materials/front_matter.h"

namespace glint {
namespace {

const std::vector<std::string> kSurfaceNames = {"uv0",           "uv1",    "position",
                                                "localPosition", "normal", "view"};

template <class T>
const T* byName(const std::vector<T>& list, std::string_view name) {
  for (const T& item : list)
    if (item.name == name) return &item;
  return nullptr;
}

// "edgeWear" -> "Edge wear"
std::string titled(const std::string& name) {
  std::string title;
  for (const char c : name) {
    if (title.empty())
      title += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    else if (std::isupper(static_cast<unsigned char>(c)))
      title += {' ', static_cast<char>(std::tolower(static_cast<unsigned char>(c)))};
    else
      title += c == '-' ? ' ' : c;
  }
  return title;
}

bool isIdentifier(std::string_view text) {
  return !text.empty() && text.size() <= 40 && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
}

Pin readPin(const Json& json, const std::string& file, bool input, Diagnostics& problems) {
  Pin pin;
  const std::string where = input ? "input" : "output";
  const Json* named = json.find("name");
  ObjectReader reader(json, file, named && named->isString() ? where + " '" + named->text + "'" : where, problems);
  pin.name = reader.text("name", true).value_or("");
  if (!pin.name.empty() && !isIdentifier(pin.name))
    reader.problem(*named, fmt::format("'{}' is no name for a pin", pin.name), "letters and digits, 40 at most");
  pin.title = reader.text("title").value_or(titled(pin.name));
  pin.doc = reader.text("doc").value_or("");
  if (const auto type = reader.text("type", true)) {
    if (const auto known = pinType(*type); known && known->kind != PinType::Kind::Any)
      pin.type = *known;
    else
      reader.problem(*json.find("type"), fmt::format("unknown type '{}'", *type),
                     suggestion(*type, {"numeric", "bool", "int", "float", "vec2", "vec3", "vec4", "color"}));
  }
  const bool exact = pin.type.kind == PinType::Kind::Exact;
  if (exact && componentCount(pin.type.type) == 0)
    reader.problem(*json.find("type"), fmt::format("a '{}' cannot be a pin of a node in GLSL", name(pin.type)), "numbers, vectors, colours and textures can");
  pin.standard.type = exact ? pin.type.type : ValueType::Float;
  if (input) {
    pin.minimum = reader.number("min").value_or(0.f);
    pin.maximum = reader.number("max").value_or(1.f);
    if (pin.minimum > pin.maximum) reader.problem("'min' is more than 'max'", "exchange them");
    const Json* standard = reader.any("default");
    if (standard && standard->isString() && !standard->text.starts_with('#')) {
      pin.surface = standard->text;
      if (std::find(kSurfaceNames.begin(), kSurfaceNames.end(), pin.surface) == kSurfaceNames.end())
        reader.problem(*standard, fmt::format("the surface has no '{}'", pin.surface),
                       suggestion(pin.surface, kSurfaceNames));
    } else if (standard && componentCount(pin.standard.type) > 0) {
      if (!exact && standard->isArray() && standard->items.size() >= 2 && standard->items.size() <= 4)
        pin.standard.type = static_cast<ValueType>(static_cast<int>(ValueType::Vec2) + standard->items.size() - 2);
      if (const auto value = valueFromJson(*standard, pin.standard.type))
        pin.standard = *value;
      else
        reader.problem(*standard, fmt::format("'default' is not {}", pin.type.kind == PinType::Kind::Exact ? described(pin.type.type) : "a number"),
                       jsonHint(pin.type.kind == PinType::Kind::Exact ? pin.type.type : ValueType::Float));
    }
  }
  reader.finish();
  return pin;
}

SettingInfo readSetting(const Json& json, const std::string& file, Diagnostics& problems) {
  SettingInfo setting;
  const Json* named = json.find("name");
  ObjectReader reader(json, file, named && named->isString() ? "setting '" + named->text + "'" : "setting",
                      problems);
  setting.name = reader.text("name", true).value_or("");
  if (!setting.name.empty() && (!isIdentifier(setting.name) || setting.name == "kind" || setting.name == "inputs"))
    reader.problem(*named, fmt::format("'{}' is no name for a setting", setting.name), "letters and digits");
  setting.title = reader.text("title").value_or(titled(setting.name));
  setting.doc = reader.text("doc").value_or("");
  const std::string type = reader.text("type", true).value_or("choice");
  if (type == "choice") {
    setting.values = reader.texts("values").value_or(std::vector<std::string>{});
    if (setting.values.empty()) reader.problem("a choice needs 'values'", "add \"values\": [\"...\"]");
    setting.standard = Json::of(reader.text("default").value_or(setting.values.empty() ? "" : setting.values[0]));
    if (std::find(setting.values.begin(), setting.values.end(), setting.standard.text) == setting.values.end())
      reader.problem(fmt::format("'default' is none of the values"), suggestion(setting.standard.text, setting.values));
  } else if (type == "int") {
    setting.type = SettingInfo::Type::Int;
    setting.minimum = reader.number("min").value_or(0.f);
    setting.maximum = reader.number("max").value_or(16.f);
    const auto standard = reader.value("default", ValueType::Int, true);
    setting.standard = Json::of(static_cast<int>(standard ? standard->v[0] : 0));
  } else if (type == "bool") {
    setting.type = SettingInfo::Type::Bool;
    setting.standard = Json::of(reader.boolean("default").value_or(false));
  } else {
    reader.problem(*json.find("type"), fmt::format("unknown type '{}'", type),
                   suggestion(type, {"choice", "int", "bool"}));
  }
  reader.finish();
  return setting;
}

bool definesFunction(const std::string& source, const std::string& function) {
  for (size_t at = source.find(function); at != source.npos; at = source.find(function, at + 1)) {
    size_t after = at + function.size();
    while (after < source.size() && std::isspace(static_cast<unsigned char>(source[after]))) ++after;
    const bool starts = at > 0 && std::isspace(static_cast<unsigned char>(source[at - 1]));
    if (starts && after < source.size() && source[after] == '(') return true;
  }
  return false;
}

}  // namespace

std::string_view name(PinType type) {
  switch (type.kind) {
    case PinType::Kind::Numeric: return "numeric";
    case PinType::Kind::Any: return "any";
    case PinType::Kind::Exact: break;
  }
  return name(type.type);
}

std::optional<PinType> pinType(std::string_view wanted) {
  if (wanted == "numeric") return PinType::numeric();
  if (wanted == "any") return PinType::any();
  if (const auto type = valueType(wanted)) return PinType::exact(*type);
  return std::nullopt;
}

bool converts(ValueType from, ValueType to) {
  if (from == to) return true;
  const bool scalar = from == ValueType::Float || from == ValueType::Bool || from == ValueType::Int;
  const bool vector = to == ValueType::Float || to == ValueType::Vec2 || to == ValueType::Vec3 ||
                      to == ValueType::Vec4 || to == ValueType::Color;
  if (scalar) return vector;
  return (from == ValueType::Vec3 && to == ValueType::Color) ||
         (from == ValueType::Color && to == ValueType::Vec3);
}

std::optional<ValueType> promote(ValueType a, ValueType b) {
  const auto plain = [](ValueType t) {
    return t == ValueType::Bool || t == ValueType::Int ? ValueType::Float : t;
  };
  a = plain(a);
  b = plain(b);
  if (componentCount(a) == 0 || componentCount(b) == 0) return std::nullopt;
  if (a == b || b == ValueType::Float) return a;
  if (a == ValueType::Float) return b;
  if (converts(a, b)) return ValueType::Color;  // vec3 with color
  return std::nullopt;
}

const Pin* NodeKind::input(std::string_view wanted) const { return byName(inputs, wanted); }
const Pin* NodeKind::output(std::string_view wanted) const { return byName(outputs, wanted); }
const SettingInfo* NodeKind::setting(std::string_view wanted) const { return byName(settings, wanted); }
const Pin* NodePins::input(std::string_view wanted) const { return byName(inputs, wanted); }
const Pin* NodePins::output(std::string_view wanted) const { return byName(outputs, wanted); }

Result<NodeKind> parseNodeKind(const std::string& file, const std::string& text) {
  auto front = readFrontMatter(file, text);
  if (!front) return front.diagnostics();
  Diagnostics problems;
  NodeKind kind;
  kind.file = file;
  kind.source = std::move(front->body);
  ObjectReader reader(front->head, file, "", problems);
  kind.id = reader.text("id", true).value_or("");
  if (!kind.id.empty() && !validNodeId(kind.id))
    reader.problem(*front->head.find("id"), fmt::format("'{}' is no id", kind.id), "letters, digits and '-'");
  kind.title = reader.text("title").value_or(titled(kind.id));
  kind.category = reader.text("category", true).value_or("");
  kind.doc = reader.text("doc", true).value_or("");
  kind.keywords = reader.texts("keywords").value_or(std::vector<std::string>{});
  kind.surface = reader.boolean("surface").value_or(false);
  kind.includes = reader.texts("includes").value_or(std::vector<std::string>{});
  if (const Json* inputs = reader.array("inputs"))
    for (const Json& input : inputs->items) kind.inputs.push_back(readPin(input, file, true, problems));
  if (const Json* outputs = reader.array("outputs", true))
    for (const Json& output : outputs->items) kind.outputs.push_back(readPin(output, file, false, problems));
  if (const Json* settings = reader.array("settings"))
    for (const Json& setting : settings->items) kind.settings.push_back(readSetting(setting, file, problems));
  kind.variance = reader.text("variance").value_or("");
  if (!kind.variance.empty() && (kind.outputs.size() != 1 || kind.outputs[0].type != PinType::exact(ValueType::Vec3)))
    reader.problem(*front->head.find("variance"), "'variance' is of one normal", "give the node one output, a vec3");
  reader.finish();
  if (kind.outputs.empty()) reader.problem("has no outputs", "add \"outputs\": [...]");
  std::vector<std::string> names;
  for (const Pin& pin : kind.inputs) names.push_back(pin.name);
  for (const SettingInfo& setting : kind.settings) names.push_back(setting.name);
  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    reader.problem(fmt::format("two inputs or settings are called '{}'", *twice), "rename one of them");
  kind.function = "node_" + kind.id;
  std::replace(kind.function.begin(), kind.function.end(), '-', '_');
  if (!definesFunction(kind.source, kind.function))
    problems.push_back(error(file, fmt::format("defines no function {}()", kind.function),
                             "its arguments are the inputs, then the settings"));
  if (!problems.empty()) return problems;
  return kind;
}

}  // namespace glint
