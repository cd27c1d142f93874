// The command line as a whole: what is common to every command.
#include <gtest/gtest.h>

#include "app/command.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using testing_support::glint;

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

// An option that may be repeated takes one word each time, not the file after it.
TEST(CommandLine, ARepeatableOptionLeavesTheFileAlone) {
  const auto ran = glint({"render", "--models-dir", ".", "nowhere.glb", "-o", "x.png"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("nowhere.glb: no such file"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace glint
