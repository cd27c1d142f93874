#include "materials/front_matter.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr int kDeepestHead = 12;

int lineAt(std::string_view text, size_t offset) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + offset, '\n'));
}

// Where the first comment that starts with `glint` opens, or npos. Walks the text as GLSL does, so that the
// mark inside another comment does not count.
size_t findHead(std::string_view text) {
  for (size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '/') continue;
    if (text[i + 1] == '/') {
      i = std::min(text.find('\n', i), text.size());
    } else if (text[i + 1] == '*') {
      const std::string_view rest = text.substr(i + 2);
      if (rest.starts_with("glint") &&
          (rest.size() == 5 || std::string_view(" \t\r\n{").find(rest[5]) != rest.npos))
        return i;
      const size_t end = text.find("*/", i + 2);
      if (end == text.npos) return text.npos;
      i = end + 1;
    }
  }
  return text.npos;
}

}  // namespace

Result<FrontMatter> readFrontMatter(const std::string& file, std::string_view text) {
  const size_t open = findHead(text);
  if (open == text.npos)
    return error(file + ":1", "has no head",
                 "start the file with a comment /*glint { \"id\": ... } */");
  const int line = lineAt(text, open);
  const size_t close = text.find("*/", open + 2);
  if (close == text.npos)
    return error(fmt::format("{}:{}", file, line), "the head's comment never ends", "close it with */");
  constexpr size_t kMark = 7;  // of "/*glint"
  auto head = parseJson(text.substr(open + kMark, close - open - kMark), file, line,
                        {.depth = kDeepestHead});
  if (!head) return head.diagnostics();
  if (!head->isObject())
    return error(fmt::format("{}:{}", file, head->line),
                 fmt::format("the head is {}", name(head->kind)), "it must be an object {...}");
  FrontMatter result{std::move(*head), std::string(text)};
  for (size_t i = open; i < close + 2; ++i)
    if (result.body[i] != '\n') result.body[i] = ' ';
  return result;
}

ObjectReader::ObjectReader(const Json& json, std::string file, std::string where, Diagnostics& problems)
    : json_(json), file_(std::move(file)), where_(std::move(where)), problems_(problems) {
  if (!json_.isObject()) problem(fmt::format("must be an object, not {}", name(json_.kind)), "write {...}");
}

std::string ObjectReader::place(const Json& at) const {
  return at.line > 0 ? fmt::format("{}:{}", file_, at.line) : file_;
}

void ObjectReader::problem(const Json& at, std::string what, std::string hint) {
  problems_.push_back(error(place(at), where_.empty() ? std::move(what) : where_ + ": " + what,
                            std::move(hint)));
}

void ObjectReader::problem(std::string what, std::string hint) {
  problem(json_, std::move(what), std::move(hint));
}

const Json* ObjectReader::take(std::string_view key, bool required) {
  known_.emplace_back(key);
  const Json* found = json_.find(key);
  if (!found && required && json_.isObject()) problem(fmt::format("'{}' is missing", key), fmt::format("add \"{}\": ...", key));
  return found;
}

const Json* ObjectReader::take(std::string_view key, bool required, Json::Kind kind) {
  const Json* found = take(key, required);
  if (!found || found->kind == kind) return found;
  problem(*found, fmt::format("'{}' must be {}, not {}", key, name(kind), name(found->kind)), writtenAs(kind));
  return nullptr;
}

std::optional<std::string> ObjectReader::text(std::string_view key, bool required) {
  const Json* found = take(key, required, Json::Kind::String);
  if (!found) return std::nullopt;
  return found->text;
}

std::optional<float> ObjectReader::number(std::string_view key, bool required) {
  const Json* found = take(key, required, Json::Kind::Number);
  if (!found) return std::nullopt;
  const float value = static_cast<float>(found->number);
  if (std::isfinite(value)) return value;
  problem(*found, fmt::format("'{}' is {}, which a float cannot hold", key, found->text), "numbers go up to 3.4e38");
  return std::nullopt;
}

std::optional<bool> ObjectReader::boolean(std::string_view key, bool required) {
  const Json* found = take(key, required, Json::Kind::Bool);
  if (!found) return std::nullopt;
  return found->boolean;
}

std::optional<std::vector<std::string>> ObjectReader::texts(std::string_view key) {
  const Json* found = take(key, false, Json::Kind::Array);
  if (!found) return std::nullopt;
  std::vector<std::string> result;
  for (const Json& item : found->items) {
    if (item.isString())
      result.push_back(item.text);
    else
      problem(item, fmt::format("'{}' must hold strings, not {}", key, name(item.kind)), writtenAs(Json::Kind::String));
  }
  return result;
}

std::optional<Value> ObjectReader::value(std::string_view key, ValueType type, bool required) {
  const Json* found = take(key, required);
  if (!found) return std::nullopt;
  auto result = valueFromJson(*found, type);
  if (!result)
    problem(*found, fmt::format("'{}' is not {}", key, described(type)),
            jsonHint(type));
  return result;
}

const Json* ObjectReader::object(std::string_view key, bool required) {
  return take(key, required, Json::Kind::Object);
}
const Json* ObjectReader::array(std::string_view key, bool required) {
  return take(key, required, Json::Kind::Array);
}
const Json* ObjectReader::any(std::string_view key) { return take(key, false); }

void ObjectReader::finish() {
  if (!json_.isObject()) return;
  for (size_t i = 0; i < json_.keys.size(); ++i)
    if (std::find(known_.begin(), known_.end(), json_.keys[i]) == known_.end())
      problem(json_.items[i], fmt::format("unknown key '{}'", json_.keys[i]),
              suggestion(json_.keys[i], known_));
}

std::string jsonHint(ValueType type) {
  return type == ValueType::Bool      ? "true or false"
         : type == ValueType::Color   ? "[r, g, b] in linear Rec.709, or \"#rrggbb\" in sRGB"
         : componentCount(type) > 1   ? fmt::format("an array of {} numbers", componentCount(type))
         : type == ValueType::Int     ? "a whole number"
                                      : "a number";
}

std::optional<Value> valueFromJson(const Json& json, ValueType type) {
  const int count = componentCount(type);
  if (count == 0) return std::nullopt;
  Value result{type, {}};
  if (json.isBool()) {
    if (type != ValueType::Bool) return std::nullopt;
    result.v[0] = json.boolean ? 1.f : 0.f;
    return result;
  }
  if (type == ValueType::Bool) return std::nullopt;
  if (json.isString()) {
    if (type != ValueType::Color || !json.text.starts_with('#')) return std::nullopt;
    return parseValue(type, json.text);
  }
  if (json.isNumber()) {
    if (type == ValueType::Int && json.number != std::floor(json.number)) return std::nullopt;
    for (int i = 0; i < count; ++i) result.v[i] = static_cast<float>(json.number);
  } else if (json.isArray()) {
    if (static_cast<int>(json.items.size()) != count) return std::nullopt;
    for (int i = 0; i < count; ++i) {
      if (!json.items[i].isNumber()) return std::nullopt;
      result.v[i] = static_cast<float>(json.items[i].number);
    }
  } else {
    return std::nullopt;
  }
  for (int i = 0; i < count; ++i)
    if (!std::isfinite(result.v[i])) return std::nullopt;
  return result;
}

Json valueToJson(const Value& value) {
  const int count = componentCount(value.type);
  if (value.type == ValueType::Bool) return Json::of(value.v[0] != 0);
  if (count == 1) return Json::of(value.v[0]);
  Json result = Json::array();
  for (int i = 0; i < count; ++i) result.push(Json::of(value.v[i]));
  return result;
}

}  // namespace glint
