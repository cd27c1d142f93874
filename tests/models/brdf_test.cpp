// BRDF Explorer's files: read as they are, and evaluated as that program would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <random>

#include "materials/base/files.h"
#include "materials/brdf_file.h"
#include "materials/glsl_loops.h"
#include "materials/glsl_namespace.h"
#include "materials/model_file.h"
#include "renderer/environment_lighting.h"
#include "renderer/comparison.h"
#include "renderer/gl/context.h"
#include "renderer/mesh.h"
#include "renderer/model_health.h"
#include "renderer/model_probe.h"
#include "renderer/renderer.h"
#include "tests/support/mutate.h"
#include "tests/support/simple_scene.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using std::numbers::pi;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const fs::path kSamples = fs::path(GLINT_TESTS_DIR) / "data/brdf";

std::string text(const Diagnostics& problems) {
  std::string all;
  for (const Diagnostic& d : problems) all += d.text() + "\n";
  return all;
}

ShadingModel sample(const std::string& name) {
  Diagnostics warnings;
  auto model = readModelFile(kSamples / name, warnings);
  EXPECT_EQ(text(warnings), "");
  EXPECT_TRUE(model) << (model ? "" : text(model.diagnostics()));
  return model ? *model : ShadingModel{};
}

std::string brdf(const std::string& parameters, const std::string& body = "return vec3(1);") {
  return "analytic\n::begin parameters\n" + parameters + "::end parameters\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n" + body + "\n}\n::end shader\n";
}

std::string faults(const std::string& file) {
  Diagnostics warnings;
  const auto model = parseBrdf("m.brdf", file, warnings);
  return (model ? "" : text(model.diagnostics())) + text(warnings);
}

TEST(BrdfFile, WholeExample) {
  const ShadingModel model = sample("brushed.brdf");
  EXPECT_EQ(model.id, "brushed");
  EXPECT_FALSE(model.claims.reciprocal || model.claims.energyConserving);
  EXPECT_TRUE(model.reads("normal"));
  EXPECT_FALSE(model.reads("roughness") || model.reads("baseColor"));
  ASSERT_EQ(model.parameters.size(), 3u);
  const ModelParameter &color = model.parameters[0], &roughness = model.parameters[1], &stretch = model.parameters[2];
  EXPECT_EQ(color.standard, Value::color(.9f, .6f, .3f));
  EXPECT_EQ(color.slot, 0);
  EXPECT_EQ(roughness.name, "ownRoughness") << "the attribute keeps its name";
  EXPECT_EQ(roughness.fileName, "roughness");
  EXPECT_EQ(model.parameter("roughness"), &roughness);
  EXPECT_EQ(roughness.slot, 3);
  EXPECT_EQ(stretch.name, "stretch");
  EXPECT_EQ(stretch.slot, -1);
  EXPECT_EQ(stretch.minimum, .1f);
  EXPECT_EQ(stretch.maximum, 10);
  EXPECT_EQ(stretch.standard.v[0], 4);
  EXPECT_EQ(sample("windows.brdf").parameters[0].standard, Value::color(1, .5f, .25f));
}

TEST(BrdfFile, TheIdIsTheFilesName) {
  EXPECT_EQ(modelIdOfFile("a/disney.brdf"), "disney");
  EXPECT_EQ(modelIdOfFile("_My model (2).v3.brdf"), "My-model--2-.v3");
  EXPECT_EQ(modelIdOfFile("\xc3\xa4.brdf"), "brdf");
  EXPECT_TRUE(isModelId(modelIdOfFile(std::string(300, 'x') + ".brdf")));
}

TEST(BrdfFile, EveryFaultAtItsLine) {
  const std::string said = faults(
      "analytic\n"
      "::begin parameters\n"
      "float a 0 1 2\n"
      "float b 1 1 1\n"
      "float c 0 1\n"
      "bool d true\n"
      "color e 0 0 2\n"
      "int f 0 1 0\n"
      "float half 0 1 0\n"
      "float thetaH 0 1 0\n"
      "float 2x 0 1 0\n"
      "float g 0 x 1e99\n"
      "float h 0 1 0 # with a remark\n"
      "bool h 1\n"
      "::begin shader\n"
      "uniform float x;\n"
      "float BRDF(vec3 L) { return 1; }\n"
      "::end parameters\n"
      "::end\n"
      "::begin sampling\n");
  for (const char* expected : {
           "m.brdf:3: parameter 'a': the default 2 is outside 0..1; widen the range or move the default",
           "m.brdf:4: parameter 'b': the range 1..1 is empty",
           "m.brdf:5: parameter 'c' has 2 of 3 values; write float NAME MIN MAX DEFAULT",
           "m.brdf:6: parameter 'd': 'true' is not 0 or 1",
           "m.brdf:7: parameter 'e': the default 0,0,2 is outside 0..1",
           "m.brdf:8: unknown type 'int' of a parameter",
           "m.brdf:9: parameter 'half': the name is a reserved word",
           "m.brdf:10: parameter 'thetaH': the name is reserved; BRDF Explorer's own shaders have it",
           "m.brdf:11: parameter '2x': the name is not a GLSL name",
           "m.brdf:12: parameter 'g': 'x' is not a number",
           "m.brdf:12: parameter 'g': '1e99' is not a number",
           "m.brdf:14: a second parameter 'h'; the first is on line 13",
           "m.brdf:15: section 'shader' begins within 'parameters', which began on line 2; add ::end parameters before it",
           "m.brdf:16: 'uniform' is not for a plugin",
           "m.brdf:17: 'BRDF' has other types than it is called with; write vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)",
           "m.brdf:18: ::end parameters in section 'shader', which began on line 15",
           "m.brdf:19: ::end without its ::begin",
           "m.brdf:20: section 'sampling' is never closed; add ::end sampling",
       })
    EXPECT_THAT(said, HasSubstr(expected));
}

TEST(BrdfFile, WhatIsNoBrdf) {
  EXPECT_THAT(faults(""), HasSubstr("m.brdf:1: is empty"));
  EXPECT_EQ(faults("/*glint {} */\n::begin x\n::begin y\n"), "m.brdf:1: starts with '/*glint {} */'; the first line of a .brdf is 'analytic'\n");
  EXPECT_THAT(faults("bparam x.brdf\n"), HasSubstr("m.brdf:1: starts with 'bparam x.brdf'"));
  EXPECT_THAT(faults("analytic\n"), HasSubstr("m.brdf:1: has no shader"));
  EXPECT_THAT(faults("analytic\n::begin shader\nfloat f() { return 1; }\n::end shader\n"), HasSubstr("m.brdf:2: defines no BRDF"));
  EXPECT_THAT(faults(brdf("", "return vec3(1);").substr(0, 100)), HasSubstr("never closed"));
  EXPECT_THAT(faults(std::string("analytic\n\0", 10)), HasSubstr("m.brdf:2: holds a zero byte"));
  EXPECT_THAT(faults(brdf("", "for (int i = 0; i < 1000000000; ++i) { }")), HasSubstr("m.brdf:6: a loop of 1000000000"));
  EXPECT_THAT(faults(brdf("", "return BRDF(L, V, N, X, Y);")), HasSubstr("m.brdf:6: 'BRDF' calls itself"));
  EXPECT_THAT(faults(brdf("", "return dFdx(V);")), HasSubstr("m.brdf:6: 'dFdx' is not for a plugin"));
}

TEST(BrdfFile, WhatIsLeftOut) {
  EXPECT_EQ(faults("words\n" + brdf("")).substr(0, 24), "m.brdf:1: starts with 'w");
  EXPECT_EQ(faults("analytic\nwords\nand more\n" + brdf("").substr(9)), "m.brdf:2: text outside of all sections, which is left out; put it between ::begin and ::end\n");
  EXPECT_EQ(faults("\xEF\xBB\xBF" + brdf("") + "::begin shadre\nwords\n::end shadre\n"), "m.brdf:9: unknown section 'shadre', which is left out; did you mean 'shader'?\n");
  EXPECT_EQ(faults(brdf("float a 0 1 +.5e0 and more\n") + "::begin isFunc\nwords\n::end isFunc\n"), "");
  const std::string twice = "analytic\n::begin shader\nnot GLSL (\n::end shader\n" + brdf("").substr(9);
  EXPECT_EQ(faults(twice), "m.brdf:7: a second shader; that of line 2 is left out; keep one of them\n");
}

TEST(BrdfFile, NamesHaveANamespaceOfTheirOwn) {
  const GlslNamespace made = inNamespace(
      "struct S { float x, count; vec2 xy; };  // words\n"
      "const float a = 1.0e-5, b = .5;\n"
      "float c = a * n, d[2] = float[2](a >= b ? 1. : c, 2.0);\n"
      "float reflect(float x) { S s; return s.x + s.count + s.xy.yx.x + d.length() + sin(x) + step; }\n",
      "bx", {"n", "step"});
  EXPECT_EQ(made.text,
            "struct bxS { float x, bxcount; vec2 xy; };  \n"
            "const float bxa = 1.0e-5, bxb = .5;\n"
            "float bxc = bxa * bxn, bxd[2] = float[2](bxa >= bxb ? 1. : bxc, 2.0);\n"
            "float bxreflect(float bxx) { bxS bxs; return bxs.x + bxs.bxcount + bxs.xy.yx.x + bxd.length() + sin(bxx) + bxstep; }\n");
  EXPECT_EQ(made.initialisers, "bxc = bxa * bxn; bxd = float[2](bxa >= bxb ? 1. : bxc, 2.0); ");
  EXPECT_THAT(made.overloads, HasSubstr("vec3 bxreflect(vec3 a0, vec3 a1) { return reflect(a0, a1); }"));
}

TEST(BrdfFile, LoopsEnd) {
  const auto bounded = [](const char* loops) { return withBoundedLoops(loops, "t").value_or("none"); };
  EXPECT_EQ(bounded("float f() { return 1.0; } // for (;;) ;"), "none");
  EXPECT_EQ(bounded("for (int i = f(0); i < 3; ++i) x += 1.0;"), "for (int i = f(0); i < 3; ++i) if (t(1)) break; else  x += 1.0;");
  EXPECT_EQ(bounded("do { while (a) b(); } while (c);"), "do if (t(1)) break; else  { while (a) if (t(1)) break; else  b(); } while (c);");
  EXPECT_EQ(bounded("do while (a) ; while (b); while (c) {}"), "do if (t(1)) break; else  while (a) if (t(1)) break; else  ; while (b); while (c) if (t(1)) break; else  {}");
  EXPECT_EQ(bounded("\nfor (;\n;) x();"), "\nfor (;\n;) if (t(2)) break; else  x();");
}

TEST(BrdfFile, FuzzedFilesAreAnswered) {
  std::mt19937 random(7);
  std::vector<std::string> seeds;
  for (const char* name : {"mirrored.brdf", "brushed.brdf", "windows.brdf"}) seeds.push_back(*readFile(kSamples / name));
  for (int round = 0; round < 3000; ++round) {
    Diagnostics warnings;
    const auto model = parseBrdf("m.brdf", test::mutate(seeds[random() % seeds.size()], random), warnings);
    if (model) {
      EXPECT_FALSE(modelGlsl(*model, kModelSourceIndex).empty());
      for (const ModelParameter& p : model->parameters) EXPECT_TRUE(inRange(p.standard, p.minimum, p.maximum));
    } else {
      for (const Diagnostic& d : model.diagnostics()) EXPECT_EQ(d.place.substr(0, 7), "m.brdf:") << d.text();
    }
    warnings.clear();
    const std::string bparam = test::mutate("bparam m.brdf\n::begin parameters\nfloat n 1 1000 300\n::end parameters\n", random);
    EXPECT_FALSE(parseBparam("/nowhere/m.bparam", bparam, warnings));
  }
}

TEST(BparamFile, ValuesForAnotherFile) {
  const ShadingModel model = sample("glossy.bparam");
  EXPECT_EQ(model.id, "glossy");
  EXPECT_EQ(model.file, kSamples / "glossy.bparam");
  EXPECT_EQ(model.sourceFile.filename(), "halfway.brdf") << "an absolute path stands for the file beside";
  EXPECT_EQ(model.parameter("n")->standard.v[0], 300);
  EXPECT_EQ(model.parameter("coupled")->standard.v[0], 0);
  EXPECT_EQ(model.parameter("Rd")->standard.v[0], .5f);
}

TEST(BparamFile, BadInput) {
  const test::TempFolder folder;
  folder.write("m.brdf", brdf("float a 0 1 0\nbool b 1\n"));
  folder.write("inside/none.txt", "");
  const auto said = [&](const std::string& file) {
    Diagnostics warnings;
    const auto model = parseBparam(folder / "p.bparam", file, warnings);
    return (model ? "" : text(model.diagnostics())) + text(warnings);
  };
  const std::string place = (folder / "p.bparam").string();
  EXPECT_THAT(said("analytic\n"), HasSubstr(place + ":1: starts with 'analytic'"));
  EXPECT_THAT(said("bparam\n"), HasSubstr(place + ":1: names no file"));
  EXPECT_THAT(said("bparam gold.binary\n"), HasSubstr("only analytic BRDFs can be read"));
  EXPECT_THAT(said("bparam inside/../../m.brdf\n"), HasSubstr("leaves the folder"));
  EXPECT_THAT(said("bparam gone.brdf\n"), AllOf(HasSubstr(place + ":1: "), HasSubstr("gone.brdf")));
  EXPECT_EQ(said("bparam C:\\brdfs\\m.brdf\n"), "");
  EXPECT_THAT(said("bparam m.brdf\n::begin parameters\nfloat b 0 1 1\nfloat a 0 3 2\nfloat c 0 1 0\n::end parameters\n"),
              AllOf(HasSubstr("p.bparam:3: parameter 'b' is a bool in m.brdf"), HasSubstr("p.bparam:4: parameter 'a': 2 is outside 0..1 of m.brdf"),
                    HasSubstr("p.bparam:5: 'c' is no parameter of m.brdf")));
}

class Brdf : public testing::Test {
 protected:
  void SetUp() override {
    auto created = gl::Context::create({.backend = gl::Backend::Egl});
    ASSERT_TRUE(created) << created.diagnostics()[0].text();
    context_ = std::move(*created);
  }

  using Formula = std::function<glm::dvec3(const glm::dvec3& L, const glm::dvec3& V)>;
  // N = +Z, X = +X, Y = +Y.
  static void expectValues(const ShadingModel& model, const Formula& formula, const std::map<std::string, Value>& settings = {}) {
    auto probe = ModelProbe::ofModel(model);
    ASSERT_TRUE(probe) << text(probe.diagnostics());
    for (const auto& [name, value] : settings) probe->set(model.parameter(name)->name, value);
    std::vector<ProbePoint> points;
    for (const glm::dvec3 L : {glm::dvec3(0, 0, 1), {0.6, 0, 0.8}, {0.48, -0.64, 0.6}, {-0.1, 0.7, 0.7}})
      for (const glm::dvec3 V : {glm::dvec3(0.28, 0, 0.96), {-0.6, 0.48, 0.64}}) {
        points.push_back(ProbePoint::at(glm::normalize(L), glm::normalize(V)));
        points.back().fromDirections = true;
        points.back().roughness = 0.9f;
      }
    const auto values = probe->evaluate(points);
    for (size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 expected = formula(points[i].light, points[i].view);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(values[2 * i][c], expected[c], 1e-4 * (1 + std::abs(expected[c]))) << model.id << " point " << i;
        EXPECT_EQ(values[2 * i + 1][c], 0) << "all of it is in the specular part";
      }
    }
  }

  static std::string card(const std::string& body, const std::string& parameters = "") {
    Diagnostics warnings;
    const auto model = parseBrdf("m.brdf", brdf(parameters, body), warnings);
    if (!model) return text(model.diagnostics());
    std::string all;
    for (const LawResult& law : checkHealth(*model).laws)
      if (law.verdict != Verdict::Green) all += fmt::format("{}: {} ({})\n", name(law.verdict), law.reason, law.where);
    return all;
  }

  std::unique_ptr<gl::Context> context_;
};

TEST_F(Brdf, SamplesHaveTheValuesOfTheirFormulas) {
  expectValues(sample("lambert.brdf"), [](auto&, auto&) { return glm::dvec3(0.8 / pi); });
  const auto halfway = [](double n, bool coupled) {
    return [=](const glm::dvec3& L, const glm::dvec3& V) {
      const glm::dvec3 H = glm::normalize(L + V);
      const double F = 0.1 + 0.9 * std::pow(1 - glm::dot(L, H), 5);
      const double diffuse = 28 / (23 * pi) * 0.5 * (1 - std::pow(1 - V.z / 2, 5)) * (1 - std::pow(1 - L.z / 2, 5)) * (coupled ? 0.9 : 1);
      return glm::dvec3((n + 8) / (8 * pi) * std::pow(H.z, n) * F + diffuse);
    };
  };
  expectValues(sample("halfway.brdf"), halfway(80, true));
  expectValues(sample("halfway.brdf"), halfway(10, false), {{"n", Value::scalar(10)}, {"coupled", {ValueType::Bool, {0}}}});
  expectValues(sample("glossy.bparam"), halfway(300, false));
  const auto brushed = [](double roughness) {
    return [=](const glm::dvec3& L, const glm::dvec3& V) {
      const glm::dvec3 H = glm::normalize(L + V);
      const double ax = 4 * roughness, ay = roughness;
      return glm::dvec3(.9, .6, .3) * std::exp(-(H.x * H.x / ax / ax + H.y * H.y / ay / ay) / (H.z * H.z)) / (4 * pi * ax * ay * std::sqrt(L.z * V.z));
    };
  };
  expectValues(sample("brushed.brdf"), brushed(0.2));
  expectValues(sample("brushed.brdf"), brushed(0.1), {{"roughness", Value::scalar(0.1f)}});
  const auto mirrored = [](double n) {
    return [=](const glm::dvec3& L, const glm::dvec3& V) {
      return glm::dvec3((n + 2) / pi * std::pow(std::max(0.0, glm::dot(glm::dvec3(-L.x, -L.y, L.z), V)), n) * 0.25);
    };
  };
  expectValues(sample("mirrored.brdf"), mirrored(20));
  expectValues(sample("mirrored.brdf"), mirrored(3), {{"n", Value::scalar(3)}});
  expectValues(sample("windows.brdf"), [](auto&, auto&) { return glm::dvec3(1, .5, .25); });
}

// Its view is a little off the normal: a lobe narrower than that was measured beside its peak, and drawn as a row of copies.
TEST_F(Brdf, ANarrowLobeIsMeasuredAroundItsOwnAxis) {
  ProgramCache programs;
  Rectangles rectangles;
  EnvironmentLighting lighting(programs, rectangles, false);
  ModelSetting setting = modelSetting(sample("brushed.brdf"));
  setting.set("ownRoughness", Value::scalar(0.01f));
  setting.set("stretch", Value::scalar(1));
  for (const glm::vec2& stretch : lighting.stretch(setting)) EXPECT_LT(glm::length(stretch), 0.002f) << "it is round";
  setting.set("stretch", Value::scalar(4));
  EXPECT_GT(glm::length(lighting.stretch(setting)[1]), 0.02f);
}

TEST_F(Brdf, ErrorsOfTheCompilerAreAtTheFilesLines) {
  Diagnostics warnings;
  const auto model = parseBrdf("m.brdf", brdf("float a 0 1 0\n# a remark\n", "# another\n\nvec3 x = nothing;\nreturn vec3(a) * sqr(a);"), warnings);
  ASSERT_TRUE(model);
  const auto probe = ModelProbe::ofModel(*model);
  ASSERT_FALSE(probe);
  EXPECT_THAT(text(probe.diagnostics()), AllOf(HasSubstr("m.brdf:10: `nothing' undeclared"), HasSubstr("m.brdf:11: no function with name 'sqr'")));
}

// Reciprocity and energy are judged without a claim: amber at most. What no model may do is red.
TEST_F(Brdf, HealthOfWhatIsWrong) {
  EXPECT_EQ(card("return vec3(0.25);"), "");
  EXPECT_THAT(card("return vec3(2);"), AllOf(HasSubstr("amber: gains energy"), Not(HasSubstr("roughness"))));
  EXPECT_THAT(card("return vec3(dot(N, V));"), HasSubstr("amber: is not reciprocal"));
  EXPECT_THAT(card("return vec3(dot(N, L) - 0.5);"), HasSubstr("red: is negative, -0.5"));
  EXPECT_THAT(card("return vec3(1 / (a - 1));", "float a 0 1 0.5\n"), AllOf(HasSubstr("red: is negative"), HasSubstr("red: is not finite"), HasSubstr("a 1")));
  EXPECT_THAT(card("return vec3(log(dot(N, L) - 2));"), HasSubstr("red: is not finite"));
}

TEST_F(Brdf, LoopsWithoutEndAreRefused) {
  EXPECT_THAT(card("float x = 0; for (int i = 0; i < 30000; ++i) for (int j = 0; j < 30000; ++j) x += sin(x + i); return vec3(x);"), HasSubstr("red: takes"));
  EXPECT_THAT(card("float x = dot(N, L); while (x > -1) x = abs(sin(x)); return vec3(x);"), HasSubstr("red: takes"));
  // In few directions only: there it is no number.
  EXPECT_THAT(card("float x = dot(N, L); while (x > 0.9999) x = max(x, 0.99999); return vec3(0.1);"), testing::AnyOf(HasSubstr("a loop takes more than 32768 turns"), HasSubstr("red: takes")));
  EXPECT_EQ(card("float x = 0; for (int i = 0; i < 8; ++i) x += 0.01; do x += 0.01; while (x < 0.1); return vec3(x);"), "");
}

// A picture of a sphere under an environment alone, `top` above and black below.
ImageF underSky(Renderer& renderer, const ModelPtr& model, const test::Look& look) {
  static const EnvironmentPtr sky = [] {
    auto half = std::make_shared<Environment>(*test::uniformEnvironment(1, 256));
    for (int y = 0; y < half->pixels.height; ++y)
      for (int x = 0; x < half->pixels.width; ++x)
        for (int c = 0; c < 3; ++c) half->pixels.at(x, y)[c] = y < half->pixels.height / 2 ? 1.f : 0.f;
    half->hash += 17;
    return half;
  }();
  Scene scene;
  scene.environment = sky;
  scene.materials.push_back(test::material(model, look));
  scene.instances.push_back({sphereMesh(), glm::mat4(1), 0});
  const View view{&scene, comparisonCamera(), {0, 0, 64, 64}};
  return renderer.linear(std::span(&view, 1), {64, 64}, {.background = Background::None});
}

double difference(const ImageF& a, const ImageF& b) {
  double most = 0;
  for (size_t i = 0; i < a.data.size(); ++i) most = std::max(most, double(std::abs(a.data[i] - b.data[i])));
  return most;
}

// It has no roughness, so the surface's must not matter, and its diffuse light is that of a diffuse surface.
TEST_F(Brdf, AnEnvironmentIsSeenThroughItsOwnLobe) {
  Renderer renderer(*context_);
  const auto shared = [](ShadingModel model) { return std::make_shared<const ShadingModel>(std::move(model)); };
  for (const char* name : {"lambert.brdf", "halfway.brdf", "mirrored.brdf"}) {
    const ModelPtr model = shared(sample(name));
    const ImageF smooth = underSky(renderer, model, {.roughness = 0}), rough = underSky(renderer, model, {.baseColor = {0.1f, 0.2f, 0.3f}, .metallic = 1, .roughness = 1});
    EXPECT_LT(difference(smooth, rough), 1e-3) << name;
    EXPECT_GT(*std::max_element(smooth.data.begin(), smooth.data.end()), 0.1f) << name;
  }
  const auto plain = parseModel("plain.glsl", "/*glint {\"id\": \"plain\"} */ vec3 specular(Shading s, Parameters p) { return vec3(0.0); }");
  ASSERT_TRUE(plain);
  EXPECT_LT(difference(underSky(renderer, shared(sample("lambert.brdf")), {}), underSky(renderer, shared(*plain), {})), 0.01) << "its Lambert is Glint's";
  EXPECT_TRUE(renderer.problems().empty()) << text(renderer.problems());
}

// Lit views draw what is negative as black.
TEST_F(Brdf, NegativeValuesTakeNoLightAway) {
  Renderer renderer(*context_);
  Diagnostics warnings;
  const auto model = parseBrdf("m.brdf", brdf("", "return vec3(dot(L, X) > 0 ? -1 : 1);"), warnings);
  ASSERT_TRUE(model) << text(model.diagnostics());
  Scene scene;
  scene.lights.push_back({.direction = {0.70711f, 0, 0.70711f}, .lux = 1});
  scene.lights.push_back({.direction = {-0.70711f, 0, 0.70711f}, .lux = 1});
  scene.materials.push_back(test::material(std::make_shared<const ShadingModel>(*model), {}));
  scene.instances.push_back({sphereMesh(), glm::mat4(1), 0});
  const View view{&scene, comparisonCamera(), {0, 0, 32, 32}};
  const ImageF picture = renderer.linear(std::span(&view, 1), {32, 32}, {.background = Background::None});
  EXPECT_NEAR(picture.at(16, 16)[0], 0.7071, 0.05) << "of the two lights one counts";
}

}  // namespace
}  // namespace glint
