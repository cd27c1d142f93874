#include "materials/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <vector>

#include "materials/base/check.h"
#include "materials/base/diagnostic.h"

namespace glint {
namespace {

struct TypeRow {
  ValueType type;
  std::string_view name, glsl;
  int components;
};
constexpr TypeRow kTypes[] = {
    {ValueType::Bool, "bool", "bool", 1},       {ValueType::Int, "int", "int", 1},
    {ValueType::Float, "float", "float", 1},    {ValueType::Vec2, "vec2", "vec2", 2},
    {ValueType::Vec3, "vec3", "vec3", 3},       {ValueType::Vec4, "vec4", "vec4", 4},
    {ValueType::Color, "color", "vec3", 3},     {ValueType::Texture, "texture", "sampler2D", 0},
    {ValueType::Attributes, "attributes", "MaterialAttributes", 0},
};

const TypeRow& row(ValueType type) {
  const auto index = static_cast<size_t>(type);
  GLINT_CHECK(index < std::size(kTypes) && kTypes[index].type == type, "type {}", index);
  return kTypes[index];
}

std::string_view trimmed(std::string_view text) {
  const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<float> parseFloat(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  float value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code == std::errc::result_out_of_range) return std::nullopt;
  if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

float linearFromSrgb(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

std::optional<Value> parseHexColor(std::string_view text) {
  if (text.size() != 7) return std::nullopt;
  Value value{ValueType::Color, {}};
  for (int i = 0; i < 3; ++i) {
    unsigned byte = 0;
    const char* begin = text.data() + 1 + 2 * i;
    const auto [end, code] = std::from_chars(begin, begin + 2, byte, 16);
    if (code != std::errc() || end != begin + 2) return std::nullopt;
    value.v[static_cast<size_t>(i)] = linearFromSrgb(static_cast<float>(byte) / 255.f);
  }
  return value;
}

std::string floatLiteral(float x) {
  GLINT_CHECK(std::isfinite(x), "{}", x);
  std::string text = fmt::format("{}", x);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return text;
}

}  // namespace

std::string_view name(ValueType type) { return row(type).name; }
std::string_view glslName(ValueType type) { return row(type).glsl; }
int componentCount(ValueType type) { return row(type).components; }

std::string described(ValueType type) {
  return type == ValueType::Attributes ? std::string(name(type)) : withArticle(name(type));
}

std::optional<ValueType> valueType(std::string_view wanted) {
  for (const TypeRow& r : kTypes)
    if (r.name == wanted) return r.type;
  return std::nullopt;
}

std::string glslLiteral(const Value& value) {
  const size_t count = static_cast<size_t>(componentCount(value.type));
  GLINT_CHECK(count > 0, "a {} has no literal", name(value.type));
  if (value.type == ValueType::Bool) return value.v[0] != 0 ? "true" : "false";
  if (value.type == ValueType::Int) return fmt::format("{}", static_cast<long>(value.v[0]));
  if (count == 1) return floatLiteral(value.v[0]);
  std::string text = fmt::format("{}({}", glslName(value.type), floatLiteral(value.v[0]));
  const bool same = std::all_of(value.v.begin(), value.v.begin() + static_cast<long>(count),
                                [&](float x) { return x == value.v[0]; });
  for (size_t i = 1; i < count && !same; ++i) text += ", " + floatLiteral(value.v[i]);
  return text + ")";
}

std::optional<Value> parseValue(ValueType type, std::string_view text) {
  const size_t count = static_cast<size_t>(componentCount(type));
  text = trimmed(text);
  if (count == 0 || text.empty() || text.size() > 1000) return std::nullopt;
  if (type == ValueType::Bool) {
    if (text == "true" || text == "1") return Value{type, {1, 0, 0, 0}};
    if (text == "false" || text == "0") return Value{type, {}};
    return std::nullopt;
  }
  if (type == ValueType::Color && text.starts_with('#')) return parseHexColor(text);
  std::vector<float> numbers;
  for (std::string_view rest = text;;) {
    const size_t cut = rest.find_first_of(",/");
    const auto number = parseFloat(rest.substr(0, cut));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (cut == rest.npos) break;
    rest.remove_prefix(cut + 1);
  }
  if (numbers.size() != 1 && numbers.size() != count) return std::nullopt;
  if (type == ValueType::Int && (numbers[0] != std::floor(numbers[0]) || std::abs(numbers[0]) > 1e9f))
    return std::nullopt;
  Value value{type, {}};
  for (size_t i = 0; i < count; ++i) value.v[i] = numbers[numbers.size() == 1 ? 0 : i];
  return value;
}

std::string valueText(const Value& value) {
  if (value.type == ValueType::Bool) return value.v[0] != 0 ? "true" : "false";
  std::string text;
  for (size_t i = 0; i < static_cast<size_t>(componentCount(value.type)); ++i)
    text += (i ? "," : "") + fmt::format("{}", value.v[i]);
  return text;
}

std::string valueHint(ValueType type) {
  switch (type) {
    case ValueType::Bool: return "write true or false";
    case ValueType::Int: return "write a whole number";
    case ValueType::Float: return "write a number, for example 0.5";
    case ValueType::Color: return "write r/g/b (linear), one number, or #rrggbb (sRGB)";
    default: return fmt::format("write {} numbers with / between them, or one for all", componentCount(type));
  }
}

bool inRange(const Value& value, float low, float high) {
  for (int i = 0; i < componentCount(value.type) && value.type != ValueType::Bool; ++i)
    if (!(value.v[static_cast<size_t>(i)] >= low && value.v[static_cast<size_t>(i)] <= high)) return false;
  return true;
}

Value clamped(Value value, float low, float high) {
  for (int i = 0; i < componentCount(value.type) && value.type != ValueType::Bool; ++i) {
    float& x = value.v[static_cast<size_t>(i)];
    x = x < low ? low : x > high ? high : x;
  }
  return value;
}

}  // namespace glint
