#include "materials/base/json.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_set>

#include <nlohmann/json.hpp>

namespace glint {
namespace {

// The text, handed to the parser a byte at a time, so that we know how far it has read.
struct Cursor {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  size_t* consumed = nullptr;
  const char& operator*() const { return *at; }
  Cursor& operator++() {
    ++at;
    if (consumed) ++*consumed;
    return *this;
  }
  Cursor operator++(int) {
    Cursor before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Cursor& other) const { return at == other.at; }
  bool operator!=(const Cursor& other) const { return at != other.at; }
};

// Builds a Json from the parser's events.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, const std::string& file, int firstLine, const JsonLimits& limits)
      : text_(text), file_(file), line_(firstLine), limits_(limits) {}

  Json result;
  Diagnostics problems;
  size_t consumed = 0;

  bool null() override { return add({}); }
  bool boolean(bool value) override { return add(Json::of(value)); }
  bool number_integer(number_integer_t value) override {
    return addNumber(static_cast<double>(value), std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return addNumber(static_cast<double>(value), std::to_string(value));
  }
  bool number_float(number_float_t value, const string_t& spelling) override {
    return addNumber(value, spelling);
  }
  bool string(string_t& value) override { return add(Json::of(std::move(value))); }
  bool binary(binary_t&) override { return false; }

  bool start_object(size_t) override { return open(Json::object()); }
  bool start_array(size_t) override { return open(Json::array()); }
  bool end_object() override {
    stack_.pop_back();
    return true;
  }
  bool end_array() override {
    stack_.pop_back();
    return true;
  }
  bool key(string_t& value) override {
    Level& level = stack_.back();
    if (!level.seen.insert(value).second)
      return fail(lineBefore(consumed), fmt::format("key '{}' twice in one object", clip(value)),
                  "remove one");
    level.json->keys.push_back(std::move(value));
    return true;
  }
  bool parse_error(size_t position, const std::string&, const nlohmann::json::exception& e) override {
    // "[json.exception.parse_error.101] parse error at line 3, column 1: syntax error while ..." keeps the
    // parser's own line, which is not the file's; ours replaces it.
    std::string what = e.what();
    if (what.starts_with("[json.exception.out_of_range"))
      return fail(lineBefore(std::min(position, text_.size())), "a number is out of range", kRangeHint);
    if (const size_t colon = what.find(": "); colon != what.npos) what.erase(0, colon + 2);
    return fail(lineBefore(std::min(position, text_.size())), "not valid JSON: " + clip(what), syntaxHint(what));
  }

 private:
  struct Level {
    Json* json;
    std::unordered_set<std::string> seen;
  };

  static constexpr const char* kRangeHint = "numbers go up to about 1e308";
  // What to look for where the parser stopped.
  std::string syntaxHint(const std::string& what) const {
    if (text_.find_first_not_of(" \t\r\n") == text_.npos) return "the file is empty";
    if (what.find("UTF-8") != what.npos) return "save the file as UTF-8";
    if (what.find("unexpected end of input") != what.npos) return "the text ends too early: look for a bracket or a quote that is not closed";
    return "look for a comma, a quote or a bracket that is missing or too many";
  }
  static std::string clip(std::string s) {
    if (s.size() > 200) s = s.substr(0, 200) + "...";
    for (char& c : s)
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    return s;
  }
  // The line of the byte before `position`. Positions only grow, so each byte is counted once.
  int lineBefore(size_t position) {
    const size_t end = position > 0 ? position - 1 : 0;
    for (; counted_ < end; ++counted_)
      if (text_[counted_] == '\n') ++line_;
    return line_;
  }
  bool fail(int line, std::string what, std::string hint) {
    problems.push_back(error(fmt::format("{}:{}", file_, line), std::move(what), std::move(hint)));
    return false;
  }
  bool addNumber(double value, std::string spelling) {
    const int line = lineBefore(consumed);
    if (!std::isfinite(value)) return fail(line, "number " + clip(spelling) + " is out of range", kRangeHint);
    Json json{.kind = Json::Kind::Number, .number = value, .text = std::move(spelling)};
    json.line = line;
    return place(std::move(json)) != nullptr;
  }
  bool add(Json json) {
    json.line = lineBefore(consumed);
    return place(std::move(json)) != nullptr;
  }
  bool open(Json json) {
    json.line = lineBefore(consumed);
    if (static_cast<int>(stack_.size()) >= limits_.depth)
      return fail(json.line, fmt::format("nested deeper than {} levels", limits_.depth), "take a level out");
    Json* placed = place(std::move(json));
    if (placed) stack_.push_back({placed, {}});
    return placed != nullptr;
  }
  Json* place(Json json) {
    if (++values_ > limits_.values) {
      fail(json.line, fmt::format("more than {} values", limits_.values), "split the file");
      return nullptr;
    }
    // A parent's items never grow while a child of it is open, so pointers on the stack stay good.
    if (stack_.empty()) return &(result = std::move(json));
    return &stack_.back().json->items.emplace_back(std::move(json));
  }

  std::string_view text_;
  const std::string& file_;
  int line_;
  size_t counted_ = 0, values_ = 0;
  JsonLimits limits_;
  std::vector<Level> stack_;
};

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '"': out += "\\\""; break;
      case '\\': out += "\\\\"; break;
      case '\n': out += "\\n"; break;
      case '\r': out += "\\r"; break;
      case '\t': out += "\\t"; break;
      default:
        if (static_cast<unsigned char>(c) < 0x20)
          out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
          out += c;
    }
  }
  return out + '"';
}

// Whether a container reads best on one line: arrays of numbers and short strings always do.
bool inlined(const Json& json, size_t& budget) {
  switch (json.kind) {
    case Json::Kind::Object: return json.items.empty();
    case Json::Kind::Array:
      for (const Json& item : json.items)
        if (item.isObject() || item.isArray() || !inlined(item, budget)) return false;
      return true;
    default: {
      const size_t length = json.text.size() + 4;
      if (json.isString() && length > budget) return false;
      budget -= std::min(budget, length);
      return true;
    }
  }
}

void write(const Json& json, int indent, std::string& out) {
  switch (json.kind) {
    case Json::Kind::Null: out += "null"; return;
    case Json::Kind::Bool: out += json.boolean ? "true" : "false"; return;
    case Json::Kind::Number: out += json.text; return;
    case Json::Kind::String: out += quoted(json.text); return;
    case Json::Kind::Array:
    case Json::Kind::Object: break;
  }
  const bool object = json.isObject();
  size_t budget = 90;
  const bool oneLine = inlined(json, budget);
  const std::string pad = oneLine ? "" : "\n" + std::string(indent + 2, ' ');
  out += object ? '{' : '[';
  for (size_t i = 0; i < json.items.size(); ++i) {
    if (i) out += oneLine ? ", " : ",";
    out += pad;
    if (object) out += quoted(json.keys[i]) + ": ";
    write(json.items[i], indent + 2, out);
  }
  if (!oneLine && !json.items.empty()) out += "\n" + std::string(indent, ' ');
  out += object ? '}' : ']';
}

}  // namespace

Json Json::of(bool value) {
  Json json;
  json.kind = Kind::Bool;
  json.boolean = value;
  return json;
}

Json Json::of(double value) {
  GLINT_CHECK(std::isfinite(value), "JSON has no {}", value);
  Json json;
  json.kind = Kind::Number;
  json.number = value == 0 ? 0 : value;  // no -0
  json.text = fmt::format("{}", json.number);
  if (json.text.ends_with(".0")) json.text.resize(json.text.size() - 2);
  return json;
}

Json Json::of(float value) {
  GLINT_CHECK(std::isfinite(value), "JSON has no {}", value);
  Json json = of(static_cast<double>(value));
  if (value != 0) json.text = fmt::format("{}", value);
  if (json.text.ends_with(".0")) json.text.resize(json.text.size() - 2);
  return json;
}

Json Json::of(int value) {
  Json json;
  json.kind = Kind::Number;
  json.number = value;
  json.text = std::to_string(value);
  return json;
}

Json Json::of(std::string value) {
  Json json;
  json.kind = Kind::String;
  json.text = std::move(value);
  return json;
}

const Json* Json::find(std::string_view key) const {
  if (kind != Kind::Object) return nullptr;
  for (size_t i = 0; i < keys.size(); ++i)
    if (keys[i] == key) return &items[i];
  return nullptr;
}

Json& Json::set(std::string key, Json value) {
  GLINT_CHECK(kind == Kind::Object, "set '{}' on {}", key, name(kind));
  for (size_t i = 0; i < keys.size(); ++i)
    if (keys[i] == key) return items[i] = std::move(value);
  keys.push_back(std::move(key));
  return items.emplace_back(std::move(value));
}

Json& Json::push(Json value) {
  GLINT_CHECK(kind == Kind::Array, "push on {}", name(kind));
  return items.emplace_back(std::move(value));
}

bool Json::operator==(const Json& other) const {
  if (kind != other.kind) return false;
  switch (kind) {
    case Kind::Null: return true;
    case Kind::Bool: return boolean == other.boolean;
    case Kind::Number:
    case Kind::String: return text == other.text;
    case Kind::Array: return items == other.items;
    case Kind::Object: return keys == other.keys && items == other.items;
  }
  return false;
}

std::string_view name(Json::Kind kind) {
  switch (kind) {
    case Json::Kind::Null: return "null";
    case Json::Kind::Bool: return "true or false";
    case Json::Kind::Number: return "a number";
    case Json::Kind::String: return "a string";
    case Json::Kind::Array: return "an array";
    case Json::Kind::Object: return "an object";
  }
  return "";
}

std::string writtenAs(Json::Kind kind) {
  switch (kind) {
    case Json::Kind::Null: return "write null";
    case Json::Kind::Bool: return "write true or false";
    case Json::Kind::Number: return "write a number without quotes, for example 0.5";
    case Json::Kind::String: return "put it in quotes: \"...\"";
    case Json::Kind::Array: return "write [...]";
    case Json::Kind::Object: return "write {...}";
  }
  return "";
}

Result<Json> parseJson(std::string_view text, const std::string& file, int firstLine,
                       const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    return error(file, fmt::format("{} bytes, more than the {} that are read", text.size(), limits.bytes), "split the file");
  Builder builder(text, file, firstLine, limits);
  const bool ok = nlohmann::json::sax_parse(Cursor{text.data(), &builder.consumed},
                                            Cursor{text.data() + text.size(), nullptr}, &builder);
  if (ok && builder.problems.empty()) return std::move(builder.result);
  if (builder.problems.empty())
    builder.problems.push_back(error(fmt::format("{}:{}", file, firstLine), "not valid JSON", "write one JSON value"));
  return std::move(builder.problems);
}

std::string writeJson(const Json& json) {
  std::string out;
  write(json, 0, out);
  out += '\n';
  return out;
}

}  // namespace glint
