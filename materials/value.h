// The types and values that travel on wires, in parameters and in plugin heads.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace glint {

enum class ValueType { Bool, Int, Float, Vec2, Vec3, Vec4, Color, Texture, Attributes };

// How JSON and diagnostics write a type: "bool", "int", "float", "vec2", "vec3", "vec4", "color",
// "texture", "attributes".
std::string_view name(ValueType);
// The same in a sentence: "a float", "an int", "attributes".
std::string described(ValueType);
std::optional<ValueType> valueType(std::string_view name);
std::string_view glslName(ValueType);  // "float", "vec3", "MaterialAttributes"
int componentCount(ValueType);         // 1..4; 0 for textures and attributes

// A constant of a numeric type. Colour is linear Rec.709. Bool is 0 or 1, Int a whole number.
struct Value {
  ValueType type = ValueType::Float;
  std::array<float, 4> v{};

  static Value scalar(float x) { return {ValueType::Float, {x, 0, 0, 0}}; }
  static Value color(float r, float g, float b) { return {ValueType::Color, {r, g, b, 0}}; }
  bool operator==(const Value&) const = default;
};

// The shortest GLSL literal that reads back as the same value ("0.5", "vec3(1.0, 0.5, 0.0)").
std::string glslLiteral(const Value&);
// "0.5" or "0.8,0.1,0.1" (also "0.8/0.1/0.1", "#rrggbb" in sRGB for colours; one number fills a
// colour or vector). Nothing when the text is not a finite value of that type.
std::optional<Value> parseValue(ValueType, std::string_view text);
std::string valueText(const Value&);  // "0.8,0.1,0.1": reads back with parseValue
// How a value of that type is typed, for hints: "write a number, for example 0.5".
std::string valueHint(ValueType);

// Whether every component lies between the two; a Bool always does.
bool inRange(const Value&, float low, float high);
// The nearest value for which that is so.
Value clamped(Value, float low, float high);

}  // namespace glint
