#include "materials/node.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "materials/front_matter.h"
#include "tests/materials/support/graphs.h"

namespace glint {
namespace {

using testing::HasSubstr;

const char* const kGood = R"(// A comment /*glint is no head here
/*glint
{ "id": "twice", "category": "Math", "doc": "Twice as much",
  "inputs": [{"name": "x", "type": "numeric", "default": 1}],
  "outputs": [{"name": "value", "type": "numeric"}] }
*/
T node_twice(T x) { return 2.0 * x; }
)";

TEST(FrontMatter, TheHeadIsBlankedAndLinesStay) {
  const auto front = readFrontMatter("f.glsl", kGood);
  ASSERT_TRUE(front) << test::texts(front.diagnostics());
  EXPECT_EQ(front->head.find("id")->line, 3);
  const std::string text = kGood;
  EXPECT_EQ(std::count(front->body.begin(), front->body.end(), '\n'), std::count(text.begin(), text.end(), '\n'));
  EXPECT_EQ(front->body.find("node_twice"), text.find("node_twice"));
  EXPECT_EQ(front->body.find("Twice as"), std::string::npos);
}

TEST(FrontMatter, FaultsHaveTheLineOfTheFile) {
  const auto place = [](const std::string& text) {
    const auto front = readFrontMatter("f.glsl", text);
    return front ? std::string() : front.diagnostics()[0].text();
  };
  EXPECT_THAT(place("void f() {}"), HasSubstr("f.glsl:1: has no head"));
  EXPECT_THAT(place("/* other */\n/*glint {"), HasSubstr("f.glsl:2: the head's comment never ends"));
  EXPECT_THAT(place("/*glint\n{\n \"id\": }\n*/"), HasSubstr("f.glsl:3: not valid JSON"));
  EXPECT_THAT(place("/*glint [] */"), HasSubstr("f.glsl:1: the head is an array"));
  EXPECT_THAT(place("/*glint " + std::string(100, '[') + "*/"), HasSubstr("deeper than 12"));
  EXPECT_THAT(place("// /*glint {} */\n/*glinty {} */"), HasSubstr("has no head"));
}

TEST(NodeKind, ReadsAHead) {
  const auto kind = parseNodeKind("f.glsl", kGood);
  ASSERT_TRUE(kind) << test::texts(kind.diagnostics());
  EXPECT_EQ(kind->title, "Twice");
  EXPECT_EQ(kind->inputs[0].type, PinType::numeric());
  EXPECT_EQ(kind->function, "node_twice");
}

TEST(NodeKind, VarianceIsOfOneNormal) {
  std::string text = kGood;
  text.replace(text.find("\"inputs\""), 0, "\"variance\": \"x\", ");
  const auto kind = parseNodeKind("f.glsl", text);
  ASSERT_FALSE(kind);
  EXPECT_THAT(test::texts(kind.diagnostics()), HasSubstr("'variance' is of one normal"));
}

TEST(NodeKind, EveryFaultOfAHeadIsReported) {
  const auto kind = parseNodeKind("f.glsl", R"(/*glint
{ "id": "bad id", "category": "Math", "dox": "x",
  "inputs": [{"name": "x", "type": "vec5"},
             {"name": "1y", "type": "float", "default": "red"},
             {"name": "uv", "type": "vec2", "default": "uv7"},
             {"name": "m", "type": "attributes"}],
  "outputs": [{"name": "value", "type": "numeric", "default": 1}],
  "settings": [{"name": "mode", "type": "choice", "values": ["a", "b"], "default": "c"}] }
*/
float other() { return 1.0; })");
  ASSERT_FALSE(kind);
  const std::string all = test::texts(kind.diagnostics());
  for (const char* what : {"f.glsl:2: 'bad id' is no id", "'doc' is missing", "unknown key 'dox'; did you mean 'doc'?",
                           "f.glsl:3: input 'x': unknown type 'vec5'", "f.glsl:4: input '1y': '1y' is no name",
                           "the surface has no 'red'", "f.glsl:5: input 'uv': the surface has no 'uv7'; did you mean 'uv0'?",
                           "f.glsl:6: input 'm'", "f.glsl:7: output 'value': unknown key 'default'",
                           "'default' is none of the values", "defines no function"})
    EXPECT_THAT(all, HasSubstr(what));
}

TEST(NodeRegistry, FilesOfOneIdAndMissingIncludesAreProblems) {
  const std::string includes = R"(/*glint {"id": "b", "category": "c", "doc": "d", "includes": ["hush"],
    "outputs": [{"name": "value", "type": "float"}]} */
float node_b() { return 1.0; })";
  const std::pair<std::string, std::string> files[] = {{"one.glsl", kGood}, {"two.glsl", kGood}, {"b.glsl", includes}};
  const NodeRegistry registry{std::span(files)};
  EXPECT_THAT(test::texts(registry.problems()), HasSubstr("two.glsl: id 'twice' is taken by one.glsl"));
  EXPECT_THAT(test::texts(registry.problems()), HasSubstr("b.glsl: includes 'hush'"));
  EXPECT_TRUE(registry.find("twice"));
  EXPECT_FALSE(registry.find("b"));
  EXPECT_TRUE(registry.find("blend-attributes"));
}

TEST(PinTypes, FloatsArePromotedAndNothingElseIsGuessed) {
  EXPECT_TRUE(converts(ValueType::Float, ValueType::Vec3));
  EXPECT_TRUE(converts(ValueType::Vec3, ValueType::Color));
  EXPECT_TRUE(converts(ValueType::Bool, ValueType::Float));
  EXPECT_FALSE(converts(ValueType::Vec4, ValueType::Vec3));
  EXPECT_FALSE(converts(ValueType::Vec3, ValueType::Float));
  EXPECT_FALSE(converts(ValueType::Float, ValueType::Bool));
  EXPECT_EQ(promote(ValueType::Float, ValueType::Vec2), ValueType::Vec2);
  EXPECT_EQ(promote(ValueType::Color, ValueType::Vec3), ValueType::Color);
  EXPECT_EQ(promote(ValueType::Vec2, ValueType::Vec3), std::nullopt);
  EXPECT_EQ(promote(ValueType::Texture, ValueType::Float), std::nullopt);
}

TEST(Pins, AModelsParametersAppearAsPinsByThemselves) {
  const GraphContext context{test::nodes(), &test::withParameters(), nullptr};
  const NodePinsPtr output = pinsOf(Node{.kind = "output"}, context);
  ASSERT_TRUE(output->input("gamma"));
  EXPECT_EQ(output->input("gamma")->maximum, 4);
  EXPECT_EQ(output->input("tint")->type, PinType::exact(ValueType::Color));
  EXPECT_FALSE(output->input("quality")) << "has no slot, so no pin";
  EXPECT_TRUE(pinsOf(Node{.kind = "break-attributes"}, context)->output("gamma"));
  const GraphContext plain{test::nodes(), &test::ggx(), nullptr};
  EXPECT_FALSE(pinsOf(Node{.kind = "output"}, plain)->input("gamma"));
}

}  // namespace
}  // namespace glint
