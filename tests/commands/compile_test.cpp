// glint compile and glint nodes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/program.h"

namespace glint {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing_support::filesIn;
using testing_support::glint;
using testing_support::scratch;

void write(const std::string& name, const std::string& text) { std::ofstream(scratch() / name) << text; }

TEST(CompileCommand, WritesTheShader) {
  const auto ran = glint({"compile", "painted-metal", "-o", "out.glsl", "--stats"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_THAT(ran.err, HasSubstr("painted-metal: 44 nodes"));
  std::ifstream in(scratch() / "out.glsl");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_THAT(text, AllOf(HasSubstr("struct MaterialAttributes"), HasSubstr("void evaluateMaterial(")));
  EXPECT_EQ(glint({"compile", "painted-metal"}).out, text);
}

TEST(CompileCommand, Json) {
  const auto document = glint({"compile", "rubber", "--model", "burley", "--json"}).json();
  ASSERT_TRUE(document.is_object());
  EXPECT_EQ(document["model"], "burley");
  EXPECT_EQ(document["uniforms"][0]["name"], "Dirt");
  EXPECT_THAT(document["glsl"].get<std::string>(), HasSubstr("evaluateMaterial"));
}

TEST(CompileCommand, BadInputIsOneLineAndWritesNothing) {
  EXPECT_BAD_INPUT(glint({"compile", "aluminum", "-o", "x.glsl"}), "material 'aluminum'", "did you mean 'aluminium'?");
  EXPECT_BAD_INPUT(glint({"compile", "black", "--target", "spirv", "-o", "x.glsl"}), "--target", "use glsl");
  EXPECT_BAD_INPUT(glint({"compile", "black", "--model", "ggy", "-o", "x.glsl"}), "--model", "ggx");
  EXPECT_BAD_INPUT(glint({"compile", "missing.json", "-o", "x.glsl"}), "missing.json", "no such file");
  write("broken.json", "{\"glint\": \"material\",\n \"version\": 1,\n \"nodes\": [}");
  EXPECT_BAD_INPUT(glint({"compile", "broken.json", "-o", "x.glsl"}), "broken.json:3", "not valid JSON");
  write("cycle.json", R"({"glint": "material", "version": 1, "nodes": {
    "output": {"kind": "output", "inputs": {"roughness": "a.value"}},
    "a": {"kind": "add", "inputs": {"a": "b.value"}},
    "b": {"kind": "add", "inputs": {"a": "a.value"}}}})");
  EXPECT_BAD_INPUT(glint({"compile", "cycle.json", "-o", "x.glsl"}), "cycle.json:3: node 'a'", "cycle");
  EXPECT_THAT(filesIn(scratch()), testing::Not(testing::Contains("x")));
}

TEST(NodesCommand, ListsAndDescribes) {
  EXPECT_THAT(glint({"nodes"}).out, AllOf(HasSubstr("blend-attributes"), HasSubstr("noise"), HasSubstr("Pattern")));
  EXPECT_THAT(glint({"nodes", "noise"}).out, AllOf(HasSubstr("octaves"), HasSubstr("shaders/nodes/noise.glsl")));
  const auto document = glint({"nodes", "--json"}).json();
  ASSERT_TRUE(document.is_object());
  EXPECT_GE(document["nodes"].size(), 80u);
  EXPECT_BAD_INPUT(glint({"nodes", "nois"}), "node 'nois'", "did you mean 'noise'?");
}

}  // namespace
}  // namespace glint
