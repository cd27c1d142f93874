// glint models and glint new-model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <fstream>

#include "tests/support/program.h"

namespace glint {
namespace {

using testing::HasSubstr;
using testing_support::filesIn;
using testing_support::glint;
using testing_support::scratch;

void write(const std::string& name, const std::string& text) {
  std::filesystem::create_directories((scratch() / name).parent_path());
  std::ofstream(scratch() / name) << text;
}

TEST(ModelsCommand, ListsModelsAndTerms) {
  const auto ran = glint({"models"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_THAT(ran.out, testing::AllOf(HasSubstr("burley"), HasSubstr("gamma 1.5 (1..4)"), HasSubstr("SmithGGXCorrelated")));
}

TEST(ModelsCommand, Json) {
  const auto document = glint({"models", "--json"}).json();
  ASSERT_TRUE(document.is_object());
  ASSERT_GE(document["models"].size(), 5u);
  for (const auto& model : document["models"])
    for (const char* key : {"id", "title", "file", "parameters", "terms", "claims", "cite", "health"})
      EXPECT_TRUE(model.contains(key)) << model;
  for (const auto& model : document["models"]) {
    EXPECT_NE(model["health"]["verdict"], "red") << model;
    EXPECT_EQ(model["health"]["laws"][0]["law"], "compiles");
  }
  EXPECT_TRUE(document["problems"].empty());
}

// Listed with its verdict, measured or not.
TEST(ModelsCommand, SaysTheVerdict) {
  write("mine/bright.glsl", "/*glint {\"id\": \"bright\", \"terms\": {\"D\": \"GGX\", \"F\": \"Schlick\"},\n"
                            "\"claims\": {\"energyConserving\": true}} */\nfloat V(Shading s, Parameters p) { return 1.0; }\n");
  write("mine/broken.glsl", "/*glint {\"id\": \"broken\", \"terms\": {\"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n"
                            "float D(Shading s, Parameters p) { return s.nonsense; }\n");
  for (int i = 0; i < 2; ++i) {  // measured, and from disk
    const auto ran = glint({"models", "--models-dir", "mine"});
    EXPECT_THAT(ran.out, HasSubstr("red: gains energy against its claim: the specular part reflects 3.999 times"));
    EXPECT_THAT(ran.out, testing::ContainsRegex("red: .*nonsense.*mine/broken.glsl:2"));
    EXPECT_THAT(ran.out, HasSubstr("amber: gains energy"));
  }
}

TEST(ModelsCommand, WritesAPage) {
  const auto ran = glint({"models", "--page", "page", "--quiet"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  std::ifstream in(scratch() / "page/README.md");
  const std::string page((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THAT(page, testing::AllOf(HasSubstr("`burley` \u26a0\ufe0f **amber**: gains energy"), HasSubstr("![Burley (GTR) on a row of roughness](pictures/burley.png)"),
                                   HasSubstr("Walter et al. 2007")));
  const auto pictures = filesIn(scratch() / "page/pictures");
  EXPECT_THAT(pictures, testing::Contains("burley.png"));
  EXPECT_EQ(pictures.size(), glint({"models", "--json"}).json()["models"].size());
}

// Files that give no model have a red row too, with all that is wrong.
TEST(ModelsCommand, ThePageHasWhatCannotBeUsed) {
  write("mine/other.glsl", "/*glint {\"id\": \"ggx\", \"terms\": {\"D\": \"Beckmann\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n");
  write("mine/broken.glsl", "/*glint {\"id\": \"broken\", \"terms\": {\"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n"
                            "float D(Shading s, Parameters p) { return s.nonsense; }\n");
  write("mine/headless.glsl", "/*glint {\"id\": \"headless\", \"terms\": {\"D\": \"GXX\"}, \"parameters\": [{\"name\": \"float\", \"type\": \"float\"}]} */\n");
  glint({"models", "--models-dir", "mine", "--page", "page", "--quiet"});
  std::ifstream in(scratch() / "page/README.md");
  const std::string page((std::istreambuf_iterator<char>(in)), {});
  for (const char* row : {"| \u274c | mine/other.glsl | | its id 'ggx' is taken by", "| \u274c | mine/headless.glsl | |", "| \u274c | broken | |",
                          "- mine/headless.glsl:1: terms: unknown D term 'GXX'", "- mine/headless.glsl:1: parameter 'float': the name is a reserved word", "- mine/broken.glsl:2: "})
    EXPECT_THAT(page, HasSubstr(row));
}

// With the file that loses an id to another, and with values for parameters.
TEST(VerifyCommand, TakesModelsAsTheyAreNamed) {
  write("mine/one.glsl", "/*glint {\"id\": \"twin\", \"terms\": {\"D\": \"GGX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n");
  write("mine/two.glsl", "/*glint {\"id\": \"twin\", \"terms\": {\"D\": \"GGX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n");
  const auto twin = glint({"verify", "twin", "--models-dir", "mine"});
  EXPECT_EQ(twin.code, 1);
  EXPECT_THAT(twin.out, testing::AllOf(HasSubstr("green   twin"), HasSubstr("red     mine/two.glsl"), HasSubstr("its id 'twin' is taken by mine/one.glsl:1")));
  EXPECT_EQ(glint({"verify", "ggx", "--models-dir", "mine"}).code, 0);

  const auto mirror = [](const std::string& model) {
    const nlohmann::json card = glint({"verify", model, "--json"}).json()["models"][0];
    EXPECT_EQ(card["model"], model);
    for (const auto& law : card["laws"])
      if (law["law"] == "mirror limit") return law["value"].get<double>();
    return 0.0;
  };
  EXPECT_NEAR(mirror("mobile"), 4 * mirror("mobile:quarter=1,fullyRough=0"), 1e-4);
  EXPECT_BAD_INPUT(glint({"verify", "mobile:quart=1"}), "mobile:quart=1", "did you mean 'quarter'?");
  EXPECT_BAD_INPUT(glint({"verify", "mobile:metallic=1"}), "mobile:metallic=1", "a card is of all attributes");
}

TEST(ModelsCommand, NamesProblemsAndListsTheRest) {
  write("mine/bad.glsl", "/*glint\n{\"id\": \"bad\",\n \"terms\": {\"D\": \"GXX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}}\n*/");
  const auto ran = glint({"models", "--models-dir", "mine"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.out, HasSubstr("ggx"));
  EXPECT_EQ(ran.err, "glint: error: mine/bad.glsl:3: terms: unknown D term 'GXX'; did you mean 'GGX'?\n");
  const auto json = glint({"models", "--models-dir", "mine", "--json"});
  EXPECT_EQ(json.code, 1);
  EXPECT_EQ(json.json()["problems"][0]["place"], "mine/bad.glsl:3");
}

// Whether it is drawn or not: that is what the exit code is for.
TEST(ModelsCommand, CompilesEveryModel) {
  write("mine/bad.glsl", "/*glint {\"id\": \"bad\", \"terms\": {\"D\": \"GGX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n"
                         "vec3 diffuse(Shading s, Parameters p) {\n"
                         "  vec3 x = vec3(s.nope) * max(s.nope, s);\n"
                         "  return max(x, s);\n}\n");
  const auto ran = glint({"models", "--models-dir", "mine"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.out, HasSubstr("mine/bad.glsl")) << "it is listed all the same";
  const auto lines = ran.errorLines();
  ASSERT_EQ(lines.size(), 2u) << ran.err;
  EXPECT_EQ(lines[0].rfind("glint: error: mine/bad.glsl:3: ", 0), 0u) << ran.err;
  EXPECT_EQ(lines[1].rfind("glint: error: mine/bad.glsl:4: ", 0), 0u) << ran.err;
  EXPECT_THAT(ran.err, testing::Not(HasSubstr("candidates")));
  const auto json = glint({"models", "--models-dir", "mine", "--json"}).json();
  EXPECT_EQ(json["problems"][0]["place"], "mine/bad.glsl:3");
}

TEST(ModelsCommand, ATakenIdIsSaid) {
  write("mine/other.glsl", "/*glint {\"id\": \"ggx\", \"terms\": {\"D\": \"Beckmann\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"render", "--size", "8x8", "--env", "none", "-o", "out.png"},
        {"compare", "--models", "burley", "--sweep", "roughness=0..1:2", "--cell", "16", "--env", "none", "-o", "out.png"}}) {
    std::vector<std::string> all = command;
    all.insert(all.end(), {"--models-dir", "mine"});
    const auto ran = glint(all);
    EXPECT_EQ(ran.code, 0) << ran.err;
    ASSERT_EQ(ran.errorLines().size(), 1u) << ran.err;
    EXPECT_EQ(ran.err.rfind("glint: warning: mine/other.glsl:1: its id 'ggx' is taken by ", 0), 0u) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("shaders/models/ggx.glsl:3, which is used"));
  }
  EXPECT_EQ(glint({"models", "--models-dir", "mine"}).code, 1);
}

// Under an environment alone a model is only seen through its tables.
TEST(ModelsCommand, OneThatTakesForEverIsRefused) {
  write("mine/slow.glsl", "/*glint {\"id\": \"slow\"} */\n"
                          "vec3 specular(Shading s, Parameters p) {\n  float x = s.NoV;\n"
                          "  for (int i = 0; i < 4000; ++i) for (int j = 0; j < 4000; ++j) x = fract(sin(x) * 1e4 + s.NoL);\n"
                          "  return vec3(x);\n}\n");
  const auto ran = glint({"render", "--models-dir", "mine", "--model", "slow", "--size", "32x32", "-o", "out.png"});
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_THAT(ran.err, testing::ContainsRegex("mine/slow.glsl:4: takes [0-9.]+ ms for 16 values; a picture asks for millions"));
}

TEST(ModelsCommand, TablesThatAreNotFiniteAreSaid) {
  write("mine/nan.glsl", "/*glint {\"id\": \"nan\"} */\n"
                         "vec3 specular(Shading s, Parameters p) { return vec3(s.NoV < 2.0 ? 1e38 * 1e38 : 1.0); }\n");
  const std::vector<std::string> words = {"--models-dir", "mine", "--env", "furnace", "-o", "out.png"};
  std::vector<std::string> render = {"render", "--model", "nan", "--size", "8x8", "--samples", "1"};
  std::vector<std::string> compare = {"compare", "--models", "nan", "--sweep", "roughness=0..1:2", "--cell", "16", "--samples", "1"};
  for (auto& command : {&render, &compare, &render}) {  // the last with what the others left on disk
    command->insert(command->end(), words.begin(), words.end());
    const auto ran = glint(*command);
    if (command == &render) command->resize(command->size() - words.size());
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("glint: warning: mine/nan.glsl: 4096 values of its environment BRDF were not finite and are black; "));
    EXPECT_THAT(ran.err, HasSubstr("values of its lobe over the environment were not finite and are black"));
    EXPECT_EQ(ran.errorLines().size(), 2u) << ran.err;
  }
}

TEST(VerifyCommand, ABrokenClaimIsRed) {
  write("mine/bright.glsl", "/*glint {\"id\": \"bright\", \"terms\": {\"D\": \"GGX\", \"F\": \"Schlick\"},\n"
                            "\"claims\": {\"energyConserving\": true}} */\n"
                            "float V(Shading s, Parameters p) { return 1.0; }\n");
  const auto ran = glint({"verify", "bright", "--models-dir", "mine"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.out, HasSubstr("red     bright"));
  EXPECT_THAT(ran.out, HasSubstr("gains energy against its claim: the specular part reflects 3.999 times"));
  const auto one = glint({"verify", "mine/bright.glsl", "ggx", "--json"});
  EXPECT_EQ(one.code, 1);
  const auto document = nlohmann::json::parse(one.out);
  EXPECT_EQ(document["verdict"], "red");
  EXPECT_EQ(document["models"][0]["verdict"], "red");
  EXPECT_EQ(document["models"][1]["verdict"], "green");
}

TEST(VerifyCommand, KnownCases) {
  const auto ran = glint({"verify", "burley", "Blinn*SmithBeckmann*Schlick"});
  EXPECT_EQ(ran.code, 0) << "neither claims to conserve energy";
  EXPECT_THAT(ran.out, HasSubstr("amber   burley"));
  EXPECT_THAT(ran.out, testing::ContainsRegex("reflects 2[.]3[0-3].*roughness 0[.]1[3-5]")) << "physics.md H3: 2.30 at roughness 0.15, NoV 0.005; a little more beside it";
  EXPECT_THAT(ran.out, HasSubstr("reflects 1.33")) << "B6: 1.330 at roughness 1, NoV 0.005";
}

TEST(VerifyCommand, BadInput) {
  EXPECT_BAD_INPUT(glint({"verify", "gxx"}), "model 'gxx'", "unknown shading model");
  EXPECT_BAD_INPUT(glint({"verify", "GGX*Nothing*Schlick"}), "model 'GGX*Nothing*Schlick'", "unknown V term 'Nothing'");
  write("mine/broken.glsl", "/*glint {\"id\": \"broken\", \"terms\": {\"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n"
                            "float D(Shading s, Parameters p) { return s.nonsense; }\n");
  const auto ran = glint({"verify", "--models-dir", "mine"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.out, HasSubstr("mine/broken.glsl:2"));
}

const char* const kShiny = "analytic\n::begin parameters\nfloat roughness 0.05 1 0.2\nfloat level 0 1 0.5\n::end parameters\n::begin shader\n"
                           "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)\n{\n"
                           "  return vec3(level * exp((dot(N, normalize(L + V)) - 1) / (roughness * roughness)));\n}\n::end shader\n";

TEST(BrdfFiles, ArePluginsAsTheyAre) {
  write("mine/shiny.brdf", kShiny);
  write("mine/dull.bparam", "bparam /home/somebody/shiny.brdf\n::begin parameters\nfloat roughness 0 1 0.8\n::end parameters\n");
  const auto listed = glint({"models", "--models-dir", "mine"});
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_THAT(listed.out, testing::AllOf(HasSubstr("mine/shiny.brdf"), HasSubstr("ownRoughness 0.2 (0.05..1)"), HasSubstr("ownRoughness 0.8 (0.05..1)"), HasSubstr("level 0.5 (0..1)")));
  const auto verified = glint({"verify", "mine/shiny.brdf", "dull", "--models-dir", "mine", "--json"});
  EXPECT_EQ(verified.code, 0) << verified.out;
  EXPECT_EQ(verified.json()["models"][0]["model"], "shiny");
  const std::vector<std::string> rest = {"--models-dir", "mine", "--size", "24x24", "--quiet"};
  const auto render = [&](const std::string& model, const std::string& set, const std::string& out) {
    std::vector<std::string> words = {"render", "--model", model, "--set", set, "-o", out};
    words.insert(words.end(), rest.begin(), rest.end());
    const auto ran = glint(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
  };
  // By the file's own name or Glint's, from either option; the attribute of that name does not reach it.
  render("shiny:roughness=0.8", "level=0.5", "a.png");
  render("shiny", "roughness=0.8", "b.png");
  render("shiny:ownRoughness=0.8", "metallic=1", "c.png");
  render("dull", "baseColor=0.1/0.2/0.3", "d.png");
  render("shiny", "level=0.5", "e.png");
  for (const char* same : {"b.png", "c.png", "d.png"}) EXPECT_EQ(glint({"diff", "a.png", same, "--fail-above", "0.001"}).code, 0) << same;
  EXPECT_EQ(glint({"diff", "a.png", "e.png", "--fail-above", "0.001"}).code, 1);
  const auto swept = glint({"compare", "--models-dir", "mine", "--models", "ggx,shiny", "--sweep", "roughness=0.1..1:2", "--cell", "16", "-o", "sheet.png"});
  EXPECT_EQ(swept.code, 0) << swept.err;
  EXPECT_BAD_INPUT(glint({"render", "--models-dir", "mine", "--model", "shiny:roughness=2", "-o", "f.png"}), "--model", "roughness 2 is out of range of model 'shiny'");
}

// Wherever a model is named, so can be its file, in whatever folder it lies.
TEST(ModelFiles, AreTakenByEveryCommand) {
  write("mine/shiny.brdf", kShiny);
  write("mine/dim.bparam", "bparam shiny.brdf\n::begin parameters\nfloat roughness 0 1 .9\n::end parameters\n");
  write("mine/open.brdf", std::string(kShiny).substr(0, std::string(kShiny).rfind("::end")));
  write("mine/ggx.glsl", "/*glint\n{ \"id\": \"ggx\", \"title\": \"Other\", \"terms\": {\"D\": \"Beckmann\", \"V\": \"Implicit\", \"F\": \"Schlick\"} }\n*/\n");
  write("work.json", R"([{"id": "file", "term": "f_mine/shiny.brdf", "args": {"l": [0, 0, 1], "v": [0, 0, 1], "roughness": 0.5, "F0": 1}},
                         {"id": "other", "term": "directional_albedo", "model": "mine/ggx.glsl", "args": {"roughness": 0.5, "NoV": 0.5}}])");
  const std::string file = "mine/shiny.brdf";
  const std::vector<std::vector<std::string>> commands = {
      {"verify", file}, {"models", file, "ggx"}, {"eval", "work.json"}, {"compile", "painted-metal", "--model", file},
      {"render", "--model", file + ":roughness=0.8", "--size", "8x8", "-o", "a.png"}, {"render", "--model", "mine/dim.bparam", "--size", "8x8", "-o", "b.png"},
      {"compare", "--models", "ggx,mine/ggx.glsl," + file + ":roughness=0.8", "--against", file, "--sweep", "metallic=0..1:2", "--cell", "16", "--samples", "1", "-o", "c.png"},
      {"compare", "--models", "ggx," + file + ":roughness=0.8", "--plot", "lobe", "-o", "d.svg"}};
  for (const auto& command : commands) {
    const auto ran = glint(command);
    EXPECT_EQ(ran.code, 0) << testing::PrintToString(command) << ran.err;
    EXPECT_EQ(ran.err.find("error"), std::string::npos) << ran.err;
  }
  EXPECT_THAT(glint(commands[1]).out, testing::AllOf(HasSubstr("mine/shiny.brdf"), HasSubstr("ggx.glsl"), testing::Not(HasSubstr("burley"))));
  // The file, not the shipped model that has its id.
  EXPECT_NE(glint({"eval", "work.json"}).json()[1]["value"], 0);
  EXPECT_BAD_INPUT(glint({"models", "mine/ggx.glsl", "ggx"}), "ggx", "has the id of mine/ggx.glsl");
  for (const char* missing : {"mine/none.brdf", "mine/none.glsl"}) {
    EXPECT_BAD_INPUT(glint({"models", missing}), missing, "no such file");
    EXPECT_BAD_INPUT(glint({"render", "--model", missing, "-o", "e.png"}), missing, "no such file");
    EXPECT_BAD_INPUT(glint({"compare", "--models", missing, "--plot", "lobe", "-o", "e.png"}), missing, "no such file");
  }
  for (const auto& command : std::vector<std::vector<std::string>>{{"models", "mine/open.brdf"}, {"render", "--model", "mine/open.brdf", "-o", "e.png"},
                                                                   {"compare", "--models", "mine/open.brdf", "-o", "e.png"}, {"compile", "painted-metal", "--model", "mine/open.brdf"}})
    EXPECT_BAD_INPUT(glint(command), "mine/open.brdf:6", "section 'shader' is never closed");
}

TEST(BrdfFiles, WhatIsWrongIsRedAndNamed) {
  write("mine/open.brdf", std::string(kShiny).substr(0, std::string(kShiny).rfind("::end")));
  write("mine/ggx.brdf", kShiny);
  write("mine/good.brdf", kShiny);
  write("mine/faulty.brdf", "analytic\n::begin parameters\nfloat sample 0 1 0\nfloat b 0 1 7\n::end parameters\n::begin shader\n" + std::string(kShiny).substr(107));
  write("mine/typo.brdf", "analytic\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)\n{\n  # no code\n  return vec3(nothing);\n}\n::end shader\n");
  const auto models = glint({"models", "--models-dir", "mine"});
  EXPECT_EQ(models.code, 1);
  for (const char* expected : {"mine/open.brdf:6: section 'shader' is never closed", "mine/ggx.brdf:1: its id 'ggx' is taken by", "mine/faulty.brdf:3: parameter 'sample': the name is a reserved word",
                               "mine/faulty.brdf:4: parameter 'b': the default 7 is outside 0..1", "mine/typo.brdf:6: `nothing' undeclared"})
    EXPECT_THAT(models.err, HasSubstr(expected));
  EXPECT_THAT(models.out, HasSubstr("mine/good.brdf"));
  const auto verify = glint({"verify", "mine/open.brdf", "mine/faulty.brdf", "mine/typo.brdf", "mine/good.brdf", "--json"});
  EXPECT_EQ(verify.code, 1);
  const auto cards = verify.json()["models"];
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(cards[i]["verdict"], "red") << cards[i];
  EXPECT_EQ(cards[1]["laws"].size(), 2u) << "both faults are told";
  EXPECT_NE(cards[3]["verdict"], "red") << cards[3];
  const auto open = glint({"render", "--models-dir", "mine", "--model", "open", "-o", "open.png"});
  EXPECT_EQ(open.code, 2);
  EXPECT_THAT(open.err, HasSubstr("glint: error: mine/open.brdf:6: section 'shader' is never closed"));
  EXPECT_EQ(glint({"render", "--models-dir", "mine", "--model", "good", "--size", "8x8", "-o", "out.png"}).code, 0);
  const auto typo = glint({"render", "--models-dir", "mine", "--model", "typo", "--size", "8x8", "-o", "typo.png"});
  EXPECT_EQ(typo.code, 2);
  EXPECT_THAT(typo.err, HasSubstr("mine/typo.brdf:6: `nothing' undeclared"));
}

TEST(CompareCommand, TheWhiteFurnaceHasNumbers) {
  const auto ran = glint({"compare", "--models", "burley,ggx", "--sweep", "roughness=0.2..1:2", "--view", "furnace", "--cell", "64", "-o", "furnace.png",
                          "--report", "furnace.html", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto cells = ran.json()["furnace"];
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_EQ(cells[1]["row"], "Burley (GTR)");
  EXPECT_EQ(cells[1]["column"], "1");
  EXPECT_GT(cells[0]["most"], 1.1);
  EXPECT_LT(cells[3]["mean"], 0.7);
  EXPECT_NEAR(cells[3]["least"], 0.3069, 0.01);
  std::ifstream in(scratch() / "furnace.html");
  const std::string html((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THAT(html, testing::AllOf(HasSubstr("<figcaption>mean\u00a00."), HasSubstr("class=\"badge amber\""), HasSubstr("class=\"badge green\""), HasSubstr("gains energy")));
}

TEST(CompareCommand, TheErrorViewHasNumbers) {
  const auto ran = glint({"compare", "--models", "ggx", "--sweep", "roughness=0.2..0.6:2", "--set", "metallic=1", "--env", "none", "--light", "sphere:pos=1/1/2,size=0.5,cd=10",
                          "--area-lights", "plain", "--view", "error", "--reference", "64", "--cell", "48", "-o", "error.png", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto cells = ran.json()["errors"];
  ASSERT_EQ(cells.size(), 2u);
  for (const auto& cell : cells) {
    EXPECT_GT(cell["light"], 0.1);
    EXPECT_GE(cell["mean"], cell["light"]);
    EXPECT_LT(cell["noise"], cell["mean"]);
  }
  const auto one = glint({"render", "--view", "error", "--reference", "8", "--size", "32x32", "--samples", "2", "-o", "one.png"});
  EXPECT_THAT(one.out, testing::AllOf(HasSubstr("%\u00a0off"), HasSubstr("of 8 samples a pixel; blue \u221225")));
  EXPECT_BAD_INPUT(glint({"render", "--view", "error", "--reference", "1", "-o", "x.png"}), "--reference", "2 to 65536");
  EXPECT_BAD_INPUT(glint({"render", "--error-scale", "5", "-o", "x.png"}), "--error-scale", "error view alone");
}

TEST(NewModelCommand, WritesOneThatWorks) {
  std::filesystem::create_directory(scratch() / "mine");
  const auto made = glint({"new-model", "two-lobe", "--models-dir", "mine", "--quiet"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, "mine/two-lobe.glsl\n");
  EXPECT_EQ(filesIn(scratch() / "mine"), std::vector<std::string>{"two-lobe.glsl"});
  const auto checked = glint({"verify", "two-lobe", "--models-dir", "mine", "--json"});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("\"model\": \"two-lobe\""));
}

TEST(NewModelCommand, GoesToTheConfigurationByDefault) {
  const testing_support::WithVariable folder("XDG_CONFIG_HOME", scratch() / "config");
  EXPECT_EQ(glint({"new-model", "mine"}).code, 0);
  EXPECT_EQ(filesIn(scratch() / "config/glint/models"), std::vector<std::string>{"mine.glsl"});
  EXPECT_THAT(glint({"models"}).out, HasSubstr("mine.glsl"));
}

TEST(NewModelCommand, BadInput) {
  write("mine/taken.glsl", "anything");
  EXPECT_BAD_INPUT(glint({"new-model", "taken", "--models-dir", "mine"}), "mine/taken.glsl", "is there already");
  EXPECT_BAD_INPUT(glint({"new-model", "ggx", "--models-dir", "mine"}), "'ggx'", "is taken by");
  EXPECT_BAD_INPUT(glint({"new-model", "../escape", "--models-dir", "mine"}), "'../escape'", "is no id");
  EXPECT_BAD_INPUT(glint({"new-model", "", "--models-dir", "mine"}), "''", "is no id");
  const testing_support::WithVariable folder("XDG_CONFIG_HOME", scratch() / "mine/taken.glsl");
  EXPECT_BAD_INPUT(glint({"new-model", "mine"}), (scratch() / "mine/taken.glsl/glint/models").string(), "cannot be made");
  EXPECT_EQ(filesIn(scratch() / "mine"), std::vector<std::string>{"taken.glsl"});
  EXPECT_EQ(glint({"new-model"}).code, 2);
}

}  // namespace
}  // namespace glint
