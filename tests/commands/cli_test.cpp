// The command line as a whole: what is common to every command.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/command.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using testing_support::glint;
using testing_support::scratch;

TEST(CommandLine, UnknownCommandNamesTheNearest) { EXPECT_BAD_INPUT(glint({"inf"}), "inf", "did you mean 'info'?"); }

TEST(CommandLine, UnknownOptionNamesTheNearest) {
  EXPECT_BAD_INPUT(glint({"info", "--jsn"}), "--jsn", "did you mean '--json'?");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "b.png", "--metrik", "flip"}), "--metrik", "did you mean '--metric'?");
  EXPECT_BAD_INPUT(glint({"--bakend", "egl", "info"}), "--bakend", "did you mean '--backend'?");
}

TEST(CommandLine, MissingValueAndRepeatedOption) {
  EXPECT_BAD_INPUT(glint({"info", "--backend"}), "--backend", "its value is missing");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "b.png", "--metric", "flip", "--metric", "max"}), "--metric", "2 times");
}

TEST(CommandLine, UnknownBackendAndFolder) {
  EXPECT_BAD_INPUT(glint({"info", "--backend", "osmessa"}), "--backend", "did you mean 'osmesa'?");
  EXPECT_BAD_INPUT(glint({"info", "--models-dir", "nowhere"}), "--models-dir", "'nowhere' is not a folder");
}

TEST(CommandLine, ExtraArgumentIsRefused) { EXPECT_BAD_INPUT(glint({"info", "more"}), "more", "takes no such argument"); }

TEST(CommandLine, ControlCharactersStayOnOneLine) {
  const auto ran = glint({"in\nfo\x1b[31m"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.errorLines().size(), 1u);
  EXPECT_EQ(ran.err.find('\x1b'), std::string::npos);
}

TEST(CommandLine, CommonOptionsStandOnEitherSide) {
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"--backend", "osmesa", "--json", "info"}, {"info", "--json", "--backend", "osmesa"}, {"--json", "info", "--backend=osmesa"}}) {
    const auto ran = glint(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    const auto document = ran.json();
    ASSERT_TRUE(document.is_object()) << ran.out;
    EXPECT_EQ(document.value("backend", ""), "osmesa");
    EXPECT_TRUE(document["software"].is_boolean() && document["workarounds"].is_array());
    EXPECT_GE(document["limits"].value("maxTextureSize", 0), 8192);
  }
}

// The standard comparison stands in for `glint` alone; a file that was named is not passed over.
TEST(CommandLine, AFileNeedsADisplay) {
  const testing_support::WithVariable display("DISPLAY", ""), wayland("WAYLAND_DISPLAY", "");
  std::ofstream(scratch() / "m.json") << R"({"glint": "material", "version": 1, "name": "m", "nodes": {"output": {"kind": "output"}}})";
  const auto ran = glint({"edit", "m.json"});
  EXPECT_EQ(ran.code, 3);
  EXPECT_EQ(ran.errorLines().size(), 1u) << ran.err;
  EXPECT_NE(ran.err.find("m.json: no display to open it on"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(scratch() / "comparison.png"));
}

TEST(CommandLine, ErrorsAreADocumentToo) {
  const auto ran = glint({"--json", "diff", "missing.png", "missing2.png"});
  EXPECT_EQ(ran.code, 2);
  const auto document = ran.json();
  ASSERT_TRUE(document.is_object()) << ran.out;
  ASSERT_EQ(document["errors"].size(), 2u);
  EXPECT_EQ(document["errors"][0]["place"], "missing.png");
  EXPECT_EQ(document["errors"][1]["place"], "missing2.png");
}

TEST(CommandLine, VersionAndHelpOfEveryCommand) {
  EXPECT_EQ(glint({"--version"}).out, "glint " GLINT_VERSION "\n");
  const auto all = glint({"--help"});
  EXPECT_EQ(all.code, 0);
  for (const Command* command : commands()) {
    EXPECT_NE(all.out.find("\n  " + command->name + " "), std::string::npos) << command->name;
    const auto one = glint({command->name, "--help"});
    EXPECT_EQ(one.code, 0);
    EXPECT_EQ(one.err, "");
    EXPECT_FALSE(command->examples.empty()) << command->name;
    for (const std::string& example : command->examples) EXPECT_NE(one.out.find("  " + example + "\n"), std::string::npos);
    EXPECT_NE(one.out.find("--backend"), std::string::npos);
    for (const Option& option : command->options) EXPECT_FALSE(option.help.empty()) << command->name << " " << option.name;
  }
}

TEST(CommandLine, NoContextIsThree) {
  // GLFW has no display in a test.
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  const auto ran = glint({"info", "--backend", "glfw"});
  EXPECT_EQ(ran.code, 3) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err.rfind("glint: error: ", 0), 0u) << ran.err;
}

// Each fault is one line, and each line says what to do.
TEST(CommandLine, EveryErrorHasItsHint) {
  const auto file = [](const std::string& name, const std::string& text) { std::ofstream(scratch() / name) << text; };
  const auto material = [&](const std::string& name, const std::string& rest) {
    file(name, "{\"glint\": \"material\", \"version\": 1, \"name\": \"m\",\n" + rest + "}");
  };
  std::filesystem::create_directories(scratch() / "models");
  file("models/broken.glsl", "/*glint { \"id\": \"broken\" } */\nvec3 specular(Shading s, Parameters p) { return s.nope; }\n");
  file("models/bare.glsl", "/*glint { \"id\": \"bare\", \"terms\": {\"D\": \"GGX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"},\n\"parameters\": [{\"name\": \"t\", \"type\": \"float\", \"min\": \"0\"}] } */\n");
  file("cut.json", "{ \"glint\": \"material\",\n");
  file("deep.json", std::string(200, '['));
  file("huge.json", "{\"glint\": \"material\", \"version\": 1e999}");
  material("kind.json", "\"nodes\": {\"out\": {\"kind\": 3}, \"b\": {}}, \"layout\": {\"out\": 1}");
  material("model.json", "\"model\": \"nope\", \"nodes\": {\"out\": {\"kind\": \"output\"}}");
  material("picture.json",
           "\"nodes\": {\"out\": {\"kind\": \"output\", \"inputs\": {\"baseColor\": \"t.color\"}},\n\"t\": {\"kind\": \"texture-sample\", \"file\": \"none.png\"}}");
  material("layer.json",
           "\"nodes\": {\"out\": {\"kind\": \"output\", \"inputs\": {\"attributes\": \"l.attributes\"}},\n\"l\": {\"kind\": \"layer\", \"function\": \"chip-mask\"}}");
  material("types.json",
           "\"nodes\": {\"out\": {\"kind\": \"output\", \"inputs\": {\"baseColor\": \"a.attributes\"}},\n\"a\": {\"kind\": \"make-attributes\"}}");
  struct Case {
    std::vector<std::string> arguments;
    std::vector<std::string> says;
    int lines = 1;
  };
  const Case cases[] = {
      {{"edit", "nothere.json"}, {"nothere.json: no such file; "}},
      {{"compile", "cut.json"}, {"cut.json:1: not valid JSON"}},
      {{"compile", "deep.json"}, {"deep.json:1: nested deeper"}},
      {{"compile", "huge.json"}, {"huge.json:1: "}},
      {{"compile", "kind.json"}, {"'kind' must be a string", "has no 'kind'", "layout of 'out'"}, 3},
      {{"compile", "model.json"}, {"model.json:2: unknown shading model 'nope'"}},
      {{"render", "model.json", "-o", "x.png"}, {"model.json:2: unknown shading model 'nope'"}},
      {{"render", "picture.json", "-o", "x.png"}, {"picture.json:3: node 't': texture ", "none.png: no such file"}},
      {{"compile", "layer.json"}, {"'chip-mask' is a function, not a layer"}},
      {{"compile", "types.json"}, {"attributes cannot go into a color"}},
      {{"--models-dir", "models", "render", "--model", "bare", "-o", "x.png"}, {"'default' is missing", "'min' must be a number"}, 2},
      {{"--models-dir", "models", "compare", "--models", "broken", "--sweep", "roughness=0..1:5", "--cell", "16", "-o", "x.png"}, {"broken.glsl:2: "}},
      {{"compare", "--models", "ggx", "--cell", "2048", "--sweep", "roughness=0..1:100", "-o", "x.png"}, {"a sweep of 100 values"}},
      {{"render", "--model", "burley:gamma=x", "-o", "x.png"}, {"'x' is not a float for gamma"}},
      {{"render", "--view", "foo", "-o", "x.png"}, {"lightCount"}},
  };
  for (const Case& one : cases) {
    const auto ran = glint(one.arguments);
    EXPECT_EQ(ran.code, 2) << ran.err;
    const auto lines = ran.errorLines();
    EXPECT_EQ(int(lines.size()), one.lines) << ran.err;
    for (const std::string& line : lines) EXPECT_NE(line.find("; "), std::string::npos) << line;
    for (const std::string& text : one.says) EXPECT_NE(ran.err.find(text), std::string::npos) << text << "\n" << ran.err;
  }
}

TEST(CommandLine, ColumnsOfNodesStandApart) {
  const std::string out = glint({"nodes", "output"}).out;
  EXPECT_NE(out.find("ambientOcclusion  float"), std::string::npos) << out;
  EXPECT_NE(glint({"render", "--help"}).out.find("lightCount"), std::string::npos);
}

// Cases that others compare do not change with the user's folder.
TEST(CommandLine, BenchOfFourModelsIsOfShippedOnes) {
  std::filesystem::create_directories(scratch() / "models");
  ASSERT_EQ(glint({"new-model", "aaa", "--models-dir", "models"}).code, 0);
  const auto with = glint({"--models-dir", "models", "bench", "--list"}), without = glint({"bench", "--list"});
  const auto four = [](const std::string& list) { return list.substr(list.find("models.4")); };
  EXPECT_NE(with.out.find("model.aaa"), std::string::npos) << with.out << with.err;
  EXPECT_EQ(four(with.out), four(without.out));
}

// An option that may be repeated takes one word each time, not the file after it.
TEST(CommandLine, ARepeatableOptionLeavesTheFileAlone) {
  const auto ran = glint({"render", "--models-dir", ".", "nowhere.glb", "-o", "x.png"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("nowhere.glb: no such file"), std::string::npos) << ran.err;
}

// After `--` all words are files, whatever they begin with.
TEST(CommandLine, FilesThatBeginWithADash) {
  const auto ran = glint({"diff", "--", "-lost.png", "--json"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "") << "that is no option there";
  EXPECT_EQ(ran.err.rfind("glint: error: -lost.png: ", 0), 0u) << ran.err;
  EXPECT_BAD_INPUT(glint({"--quiet", "--", "-lost.glb"}), "-lost.glb", "no such file");
}

}  // namespace
}  // namespace glint
