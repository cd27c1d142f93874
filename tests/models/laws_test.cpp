// The laws that every model must keep and those that it claims: no model is named here. The checks themselves are
// tested on plugins with planted faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "materials/base/files.h"
#include "materials/model_registry.h"
#include "renderer/gl/context.h"
#include "renderer/model_health_cache.h"
#include "renderer/model_speed.h"

namespace glint {
namespace {

class Laws : public testing::Test {
 protected:
  void SetUp() override {
    auto created = gl::Context::create({.backend = gl::Backend::Egl});
    ASSERT_TRUE(created) << created.diagnostics()[0].text();
    context_ = std::move(*created);
  }

  static std::string text(const Diagnostics& problems) {
    std::string all;
    for (const Diagnostic& p : problems) all += p.text() + "\n";
    return all;
  }

  // What the checks say of a model with this head and body.
  static std::string verdict(const std::string& terms, const std::string& body, const std::string& claims = "true") {
    const auto model = parseModel("planted.glsl", "/*glint {\"id\": \"planted\", \"terms\": " + terms +
                                                      ", \"claims\": {\"reciprocal\": " + claims +
                                                      ", \"energyConserving\": " + claims + "}} */\n" + body);
    if (!model) return "head: " + text(model.diagnostics());
    return card(*model);
  }

  // "red: reason (where)" and so on of every law that is not green, a line each.
  static std::string card(const ShadingModel& model) {
    std::string all;
    for (const LawResult& law : checkHealth(model).laws)
      if (law.verdict != Verdict::Green)
        all += fmt::format("{}: {} ({})\n", name(law.verdict), law.reason, law.where);
    return all;
  }
  std::unique_ptr<gl::Context> context_;
};

TEST_F(Laws, EveryModelKeepsThoseItClaims) {
  const ModelRegistry registry;
  ASSERT_TRUE(registry.problems().empty()) << text(registry.problems());
  ASSERT_GE(registry.all().size(), 5u);
  const auto page = readFile(std::filesystem::path(GLINT_TESTS_DIR) / "../shaders/models/README.md");
  ASSERT_TRUE(page) << "make it: glint models --page shaders/models";
  size_t sections = 0;
  for (size_t at = 0; (at = page->find("\n## ", at)) != std::string::npos; ++at) ++sections;
  EXPECT_EQ(sections, registry.all().size()) << "make the page anew: glint models --page shaders/models";
  for (const ModelPtr& model : registry.all()) {
    const Verdict verdict = checkHealth(*model).verdict();
    EXPECT_NE(verdict, Verdict::Red) << model->id << ": " << card(*model);
    // The page that shows them says the same of each.
    const size_t at = page->find("\n`" + model->id + "` ");
    ASSERT_NE(at, std::string::npos) << model->id << " is not on the page: make it anew with glint models --page shaders/models";
    const std::string line = page->substr(at + 1, page->find('\n', at + 1) - at - 1);
    EXPECT_NE(line.find("**" + std::string(name(verdict)) + "**"), std::string::npos)
        << line << ": make the page anew with glint models --page shaders/models";
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(GLINT_TESTS_DIR) / "../shaders/models/pictures" / (model->id + ".png")));
  }
}

// A card comes back from disk as it was measured; what it follows from is its key.
TEST_F(Laws, CardsAreKept) {
  const auto plugin = [](const std::string& claims) {
    auto model = parseModel("kept.glsl", "/*glint {\"id\": \"kept\", \"terms\": {\"D\": \"GGX\", \"F\": \"Schlick\"}, \"claims\": " + claims +
                                             "} */\nfloat V(Shading s, Parameters p) { return 0.3; }\n");
    EXPECT_TRUE(model);
    return std::move(*model);
  };
  const ShadingModel model = plugin("{}");
  const ModelHealth measured = healthOf(model);
  EXPECT_EQ(measured.verdict(), Verdict::Amber);
  const auto kept = keptHealth(model);
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->laws.size(), measured.laws.size());
  for (size_t i = 0; i < kept->laws.size(); ++i) {
    const LawResult &a = kept->laws[i], &b = measured.laws[i];
    EXPECT_EQ(std::tie(a.law, a.verdict, a.claimed, a.value, a.where, a.reason, a.hint),
              std::tie(b.law, b.verdict, b.claimed, b.value, b.where, b.reason, b.hint));
  }
  // A fault's place is in the file that has it now.
  const auto faulty = [](const char* file) { return *parseModel(file, "/*glint {\"id\": \"kept2\", \"terms\": {\"D\": \"GGX\", \"F\": \"Schlick\"}} */\nfloat V(Shading s, Parameters p) { return -1.0; }\n"); };
  EXPECT_THAT(healthOf(faulty("here/kept2.glsl")).reason(), testing::HasSubstr("(here/kept2.glsl:2, "));
  const auto moved = keptHealth(faulty("there/kept2.glsl"));
  ASSERT_TRUE(moved);
  EXPECT_THAT(moved->reason(), testing::HasSubstr("(there/kept2.glsl:2, "));
  const ShadingModel claiming = plugin("{\"energyConserving\": true}");
  EXPECT_NE(healthKey(claiming), healthKey(model));
  EXPECT_EQ(healthOf(claiming).verdict(), Verdict::Red);
}

const char* const kVF = R"({"V": "SmithGGX", "F": "Schlick"})";
const char* const kDF = R"({"D": "GGX", "F": "Schlick"})";
const char* const kDVF = R"({"D": "GGX", "V": "SmithGGX", "F": "Schlick"})";

TEST_F(Laws, SoundPlugins) {
  EXPECT_EQ(verdict(kDVF, ""), "");
  EXPECT_EQ(verdict("{}", "vec3 specular(Shading s, Parameters p) { return s.F0 * (1.0 / kPi); }"), "")
      << "a model of one function, without a D";
  EXPECT_EQ(verdict(kVF, "float D(Shading s, Parameters p) { return D_GGX(s); }"), "");
}

TEST_F(Laws, WrongFactorInD) {
  EXPECT_THAT(verdict(kVF, "float D(Shading s, Parameters p) { return D_GGX(s) * kPi; }"),
              testing::AllOf(testing::HasSubstr("D integrates to 3.14"), testing::HasSubstr("gains energy against its claim")));
  EXPECT_THAT(verdict(kVF, "float D(Shading s, Parameters p) { return D_GGX(s) * 0.98; }"),
              testing::HasSubstr("D integrates to 0.98"));
}

// A specular part without a D of its own that loses a factor.
TEST_F(Laws, WrongFactorInAWholeSpecularPart) {
  const auto specular = [](const std::string& factor) { return verdict("{}", "vec3 specular(Shading s, Parameters p) { return s.F0 * (D_GGX(s) * V_SmithGGX(s)" + factor + "); }"); };
  EXPECT_EQ(specular(""), "");
  EXPECT_THAT(specular(" / kPi"), testing::HasSubstr("amber: a white mirror reflects only 0.31"));
  EXPECT_EQ(verdict("{}", "vec3 specular(Shading s, Parameters p) { return vec3(0.05); }"), "") << "follows no F0";
}

TEST_F(Laws, VisibilityWithoutItsQuarter) {
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) { return 4.0 * V_SmithGGX(s); }"),
              testing::HasSubstr("gains energy against its claim"));
}

TEST_F(Laws, WrongSign) {
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) { return V_SmithGGX(s) - 0.3; }"),
              testing::HasSubstr("is negative"));
}

// The second summand of V in the thesis' section 4.1.2 repeats the first: it is not reciprocal.
TEST_F(Laws, OneSidedVisibility) {
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) {\n"
                           "  return 0.25 / (s.NoL * (s.NoV * (1.0 - s.alpha) + s.alpha)); }"),
              testing::HasSubstr("is not reciprocal"));
}

TEST_F(Laws, DivisionByZero) {
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) { return 0.25 / (1.0 - s.NoV); }"),
              testing::HasSubstr("is not finite"));
}

// A fault that holds only between two roughnesses, two angles or two values of a parameter is found, with its function.
TEST_F(Laws, FaultsInAWindow) {
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) {\n"
                           "  return s.roughness > 0.62 && s.roughness < 0.64 ? sqrt(-s.NoL) : V_SmithGGX(s); }"),
              testing::ContainsRegex("red: is not finite, because of V \\(planted.glsl:2, roughness 0.6[23]"));
  EXPECT_THAT(verdict(kDVF, "vec3 diffuse(Shading s, Parameters p) {\n"
                            "  return s.diffuseColor * (s.NoV > 0.80 && s.NoV < 0.83 && s.NoL > 0.5 && s.NoL < 0.55 ? -0.1 : 0.3); }", "false"),
              testing::ContainsRegex("red: is negative, -0.[0-9]+, because of diffuse \\(planted.glsl:2, roughness .*NoL 0.5.*NoV 0.8"));
  EXPECT_THAT(verdict(kVF, "float D(Shading s, Parameters p) { return s.sinH2 > 0.10 && s.sinH2 < 0.12 ? -1.0 : D_GGX(s); }"),
              testing::HasSubstr("because of D (planted.glsl:2"));
}

// Attributes that a model reads as they were authored, in a window of a hundredth, and unconnected ones.
TEST_F(Laws, FaultsInAWindowOfAnAttribute) {
  EXPECT_THAT(verdict(kVF, "float D(Shading s, Parameters p) { return D_GGX(s) / (s.metallic > 0.4 && s.metallic < 0.41 ? 0.0 : 1.0); }"),
              testing::ContainsRegex("red: is not finite, because of D \\(planted.glsl:2, .*metallic 0.4"));
  EXPECT_THAT(verdict(kDVF, "vec3 diffuse(Shading s, Parameters p) { return s.diffuseColor * (s.baseColor.g > 0.70 && s.baseColor.g < 0.71 ? -1.0 : 0.3); }"),
              testing::ContainsRegex("red: is negative, .*because of diffuse \\(planted.glsl:2, .*baseColor .*/0.70?[0-9]*/"));
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) { return V_SmithGGX(s) / (1.0 - s.specular); }"), testing::ContainsRegex("red: is not finite, .*specular 1"));
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) { return V_SmithGGX(s) * (s.metallic > 0.55 && s.metallic < 0.56 ? 2.0 : 1.0); }"),
              testing::ContainsRegex("red: gains energy.*metallic 0.55"));
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) { return s.plainNonmetal ? -1.0 : V_SmithGGX(s); }"),
              testing::HasSubstr("metallic and specular unconnected"));
  EXPECT_THAT(verdict(kDVF, "vec3 environment(Shading s, Parameters p) { return vec3(s.specular > 0.25 && s.specular < 0.26 ? -1.0 : 0.5); }"),
              testing::ContainsRegex("red: is negative, -1, because of environment .*specular 0.2[56]"));
}

// The functions that are no part of f are judged too, with their lines.
TEST_F(Laws, HooksAreJudged) {
  const auto of = [](const std::string& body) { return verdict(R"({"D": "GGX", "V": "SmithGGXCorrelated", "F": "Schlick"})", body); };
  EXPECT_THAT(of("vec3 environment(Shading s, Parameters p) { return vec3(sqrt(s.NoV - 0.5)); }"),
              testing::HasSubstr("red: is not finite, because of environment (planted.glsl:2"));
  EXPECT_THAT(of("\nvec3 environment(Shading s, Parameters p) { return vec3(-0.5); }"), testing::HasSubstr("red: is negative, -0.5, because of environment (planted.glsl:3"));
  EXPECT_THAT(of("vec3 environment(Shading s, Parameters p) { return vec3(5.0); }"), testing::HasSubstr("red: gains energy against its claim: environment gives 5"));
  EXPECT_THAT(of("void colors(inout Shading s, Parameters p) { s.F0 = vec3(sqrt(s.roughness - 0.9)); }"), testing::HasSubstr("is not finite, because of colors"));
  EXPECT_THAT(of("void colors(inout Shading s, Parameters p) { s.F0 = vec3(-1.0); }"), testing::HasSubstr("because of colors"));
  EXPECT_THAT(of("void colors(inout Shading s, Parameters p) { s.diffuseColor *= 3.0; }"), testing::HasSubstr("colors gives 3"));
  EXPECT_THAT(of("vec3 scattered(Shading s, Parameters p) { return vec3(dot(s.N, s.L) < -0.3 ? sqrt(-s.NoV - 1.0) : 0.05); }"),
              testing::HasSubstr("is not finite, because of scattered"));
}

// A coat is a function of the file like any other, also where the base hides what is wrong with it.
TEST_F(Laws, CoatsAreJudged) {
  const auto of = [](const std::string& body, const char* strength = "1") {
    const auto model = parseModel("planted.glsl", std::string(R"(/*glint {"id": "planted", "terms": {"D": "GGX", "V": "SmithGGXCorrelated", "F": "Schlick"},
"coat": {"roughness": "gloss", "strength": "amount"},
"parameters": [{"name": "gloss", "type": "float", "min": 0, "max": 1, "default": 0.2}, {"name": "amount", "type": "float", "min": 0, "max": 1, "default": )") + strength + "}]} */\n" + body);
    return model ? card(*model) : "head: " + text(model.diagnostics());
  };
  EXPECT_THAT(of("vec3 coat(Shading s, Parameters p) { return vec3(-1.0); }"), testing::HasSubstr("red: is negative, -1, because of coat (planted.glsl:4"));
  EXPECT_THAT(of("\nvec3 coat(Shading s, Parameters p) { return vec3(sqrt(-1.0 - s.NoV)); }"), testing::HasSubstr("red: is not finite, because of coat (planted.glsl:5"));
  EXPECT_THAT(of("vec3 coat(Shading s, Parameters p) { return vec3(0.0); }\nvec3 throughCoat(Shading s, Parameters p) { return vec3(-0.5); }"),
              testing::HasSubstr("because of throughCoat (planted.glsl:5"));
  EXPECT_THAT(of("vec3 coat(Shading s, Parameters p) { return vec3(-1e-2 * D_GGX(s)); }", "0"), testing::HasSubstr("because of coat (planted.glsl:4"));
}

// Loops of 10^9 turns, however they are written; short ones may be counted by macros.
TEST_F(Laws, LongLoopsAreNamed) {
  const auto of = [](const std::string& before, const std::string& loop) {
    return verdict(kVF, before + "\nfloat D(Shading s, Parameters p) {\n  float x = 0.0;\n" + loop + "\n  return D_GGX(s) + 1e-30 * x;\n}", "false");
  };
  const auto named = testing::AllOf(testing::HasSubstr("red"), testing::HasSubstr("planted.glsl:5"));
  EXPECT_THAT(of("#define N 1000000000", "  for (int i = 0; i < N; ++i) x += s.NoL;"), testing::AllOf(testing::HasSubstr("a loop of 1000000000"), testing::HasSubstr("planted.glsl:5")));
  EXPECT_THAT(of("#define N (10 * 100000000)", "  for (int i = 0; i < N; ++i) x += s.NoL;"), named);
  EXPECT_THAT(of("", "  int i = 0; do { x += s.NoL; ++i; } while (i < 1000000000);"), named);
  EXPECT_THAT(of("", "  int i = 0; while (i < 1000000000) { x += s.NoL; i++; }"), named);
  EXPECT_THAT(of("", "  for (float i = 0.0; i < 1e9; i += 1.0) x += s.NoL;"), named);
  EXPECT_THAT(of("", "  if (s.roughness > 0.62 && s.roughness < 0.64) for (float i = 0.0; i < 1e9; i += 1.0) x += s.NoL;"),
              testing::AllOf(named, testing::HasSubstr("a loop takes more than 32768 turns")));
  EXPECT_EQ(of("#define N 16", "  for (int i = 0; i < N; ++i) x += s.NoL; int j = 0; do { ++j; } while (j < N);"), "");
}

// Other work of the process takes the processor too: that is not the model's fault.
TEST_F(Laws, ABusyMachineBlamesNoModel) {
  const auto plugin = [](const std::string& body) {
    return *parseModel("planted.glsl", "/*glint {\"id\": \"planted\", \"terms\": {\"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\nfloat D(Shading s, Parameters p) { " + body + " }\n");
  };
  const ShadingModel straight = plugin("return D_GGX(s);"), looping = plugin("float x = 0.0;\nfor (int i = 0; i < 8; ++i) x += s.NoL;\nreturn x;");
  const auto busyFor = [](int slowCalls, double seconds) {
    return [left = slowCalls, seconds](int) mutable {
      if (left-- <= 0) return;
      const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
      while (std::chrono::steady_clock::now() < end) {}
    };
  };
  EXPECT_FALSE(faultOfSpeed(straight, busyFor(1000, 0.012)));
  EXPECT_FALSE(faultOfSpeed(straight, busyFor(1000, 0.3)));
  EXPECT_FALSE(faultOfSpeed(looping, busyFor(12, 0.012)));
  const auto slow = faultOfSpeed(looping, busyFor(1000, 0.02));
  ASSERT_TRUE(slow);
  EXPECT_EQ(slow->place, "planted.glsl:3");
}

// So is energy that is gained, or lost by the distribution, between two roughnesses alone.
TEST_F(Laws, EnergyInAWindow) {
  EXPECT_THAT(verdict(kDF, "float V(Shading s, Parameters p) { return V_SmithGGX(s) * (s.roughness > 0.31 && s.roughness < 0.33 ? 2.0 : 1.0); }"),
              testing::ContainsRegex("red: gains energy.*roughness 0.3[123]"));
  EXPECT_THAT(verdict(kVF, "float D(Shading s, Parameters p) { return D_GGX(s) * (s.roughness > 0.87 && s.roughness < 0.89 ? 0.9 : 1.0); }"),
              testing::HasSubstr("red: D integrates to 0.9"));
}

TEST_F(Laws, FaultsWithinTheRangeOfAParameter) {
  // The fifth number is a constant of the material.
  for (const char* name : {"first", "fifth"}) {
    const auto model = parseModel("within.glsl", fmt::format(R"(/*glint {{"id": "within", "terms": {{"D": "GGX", "F": "Schlick"}},
      "parameters": [{{"name": "first", "type": "float", "default": 0}}, {{"name": "b", "type": "color", "default": 0}},
                     {{"name": "fifth", "type": "float", "default": 0}}]}} */
      float V(Shading s, Parameters p) {{ return p.{0} > 0.3 && p.{0} < 0.7 ? -1.0 : V_SmithGGX(s); }})", name));
    ASSERT_TRUE(model) << text(model.diagnostics());
    EXPECT_THAT(card(*model), testing::ContainsRegex(fmt::format("red: is negative, .*because of V .within.glsl:4, .*, {} 0[.][3-6]", name)));
  }
}

TEST_F(Laws, DiffusePartCounts) {
  EXPECT_THAT(verdict(kDVF, "vec3 diffuse(Shading s, Parameters p) { return s.diffuseColor * 0.5; }"),
              testing::HasSubstr("the diffuse part reflects 1.57"));
  EXPECT_THAT(verdict(kDVF, "vec3 diffuse(Shading s, Parameters p) { return s.diffuseColor * 0.8 / kPi; }"),
              testing::HasSubstr("amber: a white diffuse surface reflects only 0.8 "));
}

TEST_F(Laws, WhatReflectsNothingIsRed) {
  EXPECT_THAT(verdict("{}", "vec3 specular(Shading s, Parameters p) { return vec3(0.0); }\nvec3 diffuse(Shading s, Parameters p) { return vec3(0.0); }"),
              testing::HasSubstr("red: reflects nothing from any direction: there is no lobe to draw directions from (planted.glsl:2)"));
  EXPECT_EQ(verdict("{}", "vec3 specular(Shading s, Parameters p) { return vec3(0.0); }"), "") << "diffuse light alone";
}

TEST_F(Laws, OnlyClaimsBind) {
  EXPECT_THAT(verdict(kDVF, "vec3 diffuse(Shading s, Parameters p) { return s.diffuseColor * 0.5 * s.NoV; }", "false"),
              testing::AllOf(testing::HasSubstr("amber: is not reciprocal"), testing::Not(testing::HasSubstr("red"))));
}

TEST_F(Laws, ParametersAtTheirEnds) {
  const auto model = parseModel("ends.glsl", R"(/*glint {"id": "ends", "terms": {"D": "GGX", "F": "Schlick"},
    "parameters": [
      {"name": "a", "type": "color", "default": [0, 0, 0]}, {"name": "b", "type": "vec2", "default": 0},
      {"name": "gain", "type": "int", "default": 1, "min": 1, "max": 3}],
    "claims": {"energyConserving": true}} */
    float V(Shading s, Parameters p) { return V_SmithGGX(s) * float(p.gain); })");
  ASSERT_TRUE(model) << text(model.diagnostics());
  EXPECT_EQ(model->parameter("b")->slot, -1) << "the four are taken";
  EXPECT_EQ(model->parameter("gain")->slot, 3);
  EXPECT_THAT(card(*model), testing::HasSubstr("gain 3)"));
}

// How far the one lobe that area lights are seen through is from the model's own.
TEST_F(Laws, AreaLightsTellWhetherOneLobeIsEnough) {
  const auto offOf = [](const std::string& body, const char* terms = R"({"V": "SmithGGXCorrelated", "F": "Schlick", "diffuse": "Lambert"})") {
    const auto model = parseModel("planted.glsl", std::string("/*glint {\"id\": \"planted\", \"terms\": ") + terms + "} */\n" + body);
    EXPECT_TRUE(model) << text(model.diagnostics());
    const ModelHealth health = checkHealth(*model);
    const LawResult* law = health.find(Law::AreaLights);
    EXPECT_TRUE(law);
    return law ? law->value : -1;
  };
  const double ggx = offOf("float D(Shading s, Parameters p) { return D_GGX(s); }");
  EXPECT_GT(ggx, 0.01);
  EXPECT_LT(ggx, 0.06);
  // A cosine is one itself.
  EXPECT_LT(offOf("vec3 specular(Shading s, Parameters p) { return s.F0 / kPi; }", "{}"), 0.005);
  // Two lobes are not: half of the light goes back to where it came from.
  EXPECT_GT(offOf("vec3 specular(Shading s, Parameters p) { return s.F0 * (pow(clamp(s.LoV, 0.0, 1.0), 40.0) + D_GGX(s) * V_SmithGGX(s)); }", "{}"), 2 * ggx);
}

// A model's error is at its own line, whichever part of the program it came from.
TEST_F(Laws, CompileErrorsAreAtThePluginsLine) {
  const auto model = parseModel("broken.glsl", "/*glint\n{\"id\": \"broken\",\n \"terms\": {\"V\": \"SmithGGX\", \"F\": \"Schlick\"}}\n*/\n"
                                               "float D(Shading s, Parameters p) {\n  return s.nonsense;\n}\n");
  ASSERT_TRUE(model) << text(model.diagnostics());
  const ModelHealth health = checkHealth(*model);
  ASSERT_EQ(health.verdict(), Verdict::Red);
  EXPECT_EQ(health.laws[0].where, "broken.glsl:6") << card(*model);
  EXPECT_THAT(health.reason(), testing::HasSubstr("nonsense"));
}

// Names that a plugin may well use for its own helpers do not meet what is written around it, and its macros
// end with it.
TEST_F(Laws, PluginsNamesDoNotCollide) {
  EXPECT_EQ(verdict(kDF, R"(
#define NdotL s.NoL
#define values 3.0
const float PI = 3.14159265;
struct Frame { vec3 x, y; };
float pow5(float x) { return x * x * x * x * x; }
float sqr(float x) { return x * x; }
float V_mine(Shading s, float x);
float V(Shading s, float x, Parameters p) { return x; }
float G1(float x, float k) { return x / (x * (1.0 - k) + k); }
float V(Shading s, Parameters p) { return V_mine(s, values) * V(s, 1.0, p); }
float V_mine(Shading s, float x) { return G1(NdotL, 0.5) * G1(s.NoV, 0.5) / (4.0 * NdotL * s.NoV) * x / 3.0; }
)"), "");
}

}  // namespace
}  // namespace glint
