#include <gtest/gtest.h>

#include <set>

#include "materials/attributes.h"

namespace glint {
namespace {

TEST(Value, TypesHaveNames) {
  for (const ValueType type : {ValueType::Bool, ValueType::Int, ValueType::Float, ValueType::Vec2, ValueType::Vec3,
                               ValueType::Vec4, ValueType::Color, ValueType::Texture, ValueType::Attributes})
    EXPECT_EQ(valueType(name(type)), type);
  EXPECT_FALSE(valueType("colour"));
  EXPECT_EQ(glslName(ValueType::Color), "vec3");
  EXPECT_EQ(componentCount(ValueType::Attributes), 0);
}

TEST(Value, GlslLiterals) {
  EXPECT_EQ(glslLiteral(Value::scalar(0.5f)), "0.5");
  EXPECT_EQ(glslLiteral(Value::scalar(2)), "2.0");
  EXPECT_EQ(glslLiteral(Value::scalar(-1e-20f)), "-1e-20");
  EXPECT_EQ(glslLiteral(Value::scalar(0.1f)), "0.1") << "the shortest that reads back";
  EXPECT_EQ(glslLiteral(Value::color(1, 0.5f, 0)), "vec3(1.0, 0.5, 0.0)");
  EXPECT_EQ(glslLiteral(Value::color(1, 1, 1)), "vec3(1.0)");
  EXPECT_EQ(glslLiteral({ValueType::Bool, {1}}), "true");
  EXPECT_EQ(glslLiteral({ValueType::Int, {-3}}), "-3");
}

TEST(Value, TextReadsBack) {
  for (const Value& value : {Value::scalar(0.1f), Value::color(0.8f, 1e-9f, 3), Value{ValueType::Bool, {1}},
                             Value{ValueType::Int, {7}}, Value{ValueType::Vec4, {1, 2, 3, -4}}})
    EXPECT_EQ(parseValue(value.type, valueText(value)), value) << valueText(value);
}

TEST(Value, ManyWaysToWriteOne) {
  EXPECT_EQ(parseValue(ValueType::Vec3, "1/2/3"), (Value{ValueType::Vec3, {1, 2, 3}}));
  EXPECT_EQ(parseValue(ValueType::Vec2, " 0.5 "), (Value{ValueType::Vec2, {0.5f, 0.5f}}));
  EXPECT_EQ(parseValue(ValueType::Float, "+.5"), Value::scalar(0.5f));
  EXPECT_EQ(parseValue(ValueType::Color, "#ff0000"), Value::color(1, 0, 0));
  EXPECT_NEAR(parseValue(ValueType::Color, "#808080")->v[1], 0.2158605f, 1e-6) << "sRGB";
}

TEST(Value, Nonsense) {
  for (const char* text : {"", " ", "x", "1,", ",1", "1,2", "1,2,3,4", "nan", "inf", "1e99", "1e", "0x10", "--1", "+-1", "1 2", "#12345", "#12345g"})
    EXPECT_FALSE(parseValue(ValueType::Vec3, text)) << text;
  EXPECT_FALSE(parseValue(ValueType::Int, "1.5"));
  EXPECT_FALSE(parseValue(ValueType::Bool, "yes"));
  EXPECT_FALSE(parseValue(ValueType::Texture, "1"));
}

TEST(Attributes, TableIsWhole) {
  std::set<std::string_view> names;
  for (const Attribute& attribute : attributes()) {
    EXPECT_TRUE(names.insert(attribute.name).second);
    EXPECT_EQ(findAttribute(attribute.name), &attribute);
    EXPECT_LT(attribute.minimum, attribute.maximum);
    EXPECT_FALSE(attribute.doc.empty());
  }
  EXPECT_EQ(names.size(), 9u);
  EXPECT_EQ(findAttribute("baseColor")->standard, Value::color(0.8f, 0.8f, 0.8f));
  EXPECT_EQ(findAttribute("colour"), nullptr);
}

}  // namespace
}  // namespace glint
