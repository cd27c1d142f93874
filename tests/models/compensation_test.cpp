// Light that bounces among facets more than once, given back: laws for every registered model, naming none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "materials/model_mix.h"
#include "materials/model_registry.h"
#include "renderer/gl/context.h"
#include "renderer/model_health.h"
#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"
#include "renderer/renderer.h"
#include "tests/support/simple_scene.h"

namespace glint {
namespace {

constexpr float kRoughness[] = {0.f, 0.03f, 0.07f, 0.33f, 0.71f, 1.f};
constexpr float kNoV[] = {1e-3f, 0.004f, 0.05f, 0.17f, 0.42f, 1.f};

class Compensation : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::Context::create({.backend = gl::Backend::Egl});
    ASSERT_TRUE(made);
    context_ = std::move(*made).release();
  }
  static void TearDownTestSuite() { delete context_; }

  static std::vector<IntegralQuery> queries(bool analyticLight) {
    std::vector<IntegralQuery> all;
    for (const float roughness : kRoughness)
      for (const float NoV : kNoV)
        // From all sides by turns, for models that tell them apart.
        all.push_back({.roughness = roughness, .NoV = NoV, .analyticLight = analyticLight, .azimuth = 0.9f * static_cast<float>(all.size())});
    return all;
  }
  static double largest(const glm::dvec3& v) { return std::max({v.r, v.g, v.b}); }

  // Whether F0 = 1 makes the model white: at grazing angles Fresnel hides it.
  static bool followsF0(const ShadingModel& model) {
    const IntegralQuery query[] = {{0.5f, 0.9f}};
    const ModelIntegral sum = ModelIntegrals::of(model, {.compensate = false})->evaluate(query)[0];
    return largest(sum.specular - sum.specularBlack) > 0.1 * largest(sum.specular);
  }

  // Of the compensated model the albedos for F0 = 1 where it is white and does not gain: all 1. Elsewhere no more than
  // without compensation.
  static void furnace(const ShadingModel& model) {
    const bool follows = followsF0(model);
    for (const bool light : {true, false}) {
      if (!light && model.source.find("analyticLight") == std::string::npos) continue;
      const std::vector<IntegralQuery> where = queries(light);
      auto single = ModelIntegrals::of(model, {.compensate = false}), whole = ModelIntegrals::of(model, {.compensate = true});
      ASSERT_TRUE(single && whole) << model.id;
      const std::vector<ModelIntegral> before = single->evaluate(where), after = whole->evaluate(where);
      double worst = 0;
      IntegralQuery at;
      for (size_t i = 0; i < where.size(); ++i) {
        const double E = largest(before[i].specular), compensated = largest(after[i].specular);
        ASSERT_TRUE(std::isfinite(compensated)) << model.id;
        // Where the albedo crosses 1 the table has an edge.
        const size_t row = i / std::size(kNoV) * std::size(kNoV);
        const bool gains = std::any_of(&before[row], &before[row] + std::size(kNoV), [](const ModelIntegral& b) { return largest(b.specular) > 1.003; });
        const double wanted = !follows ? E : std::max(E, 1.0), off = std::abs(compensated - wanted);
        EXPECT_LT(off, 0.1 * wanted) << model.id;
        if (!gains && off > worst) {
          worst = off;
          at = where[i];
        }
      }
      EXPECT_LT(worst, 5e-3) << model.id << " at roughness " << at.roughness << ", NoV " << at.NoV << (light ? "" : ", environment");
    }
  }
  static inline gl::Context* context_ = nullptr;
};

TEST_F(Compensation, EveryModelKeepsAllLight) {
  for (const ModelPtr& model : ModelRegistry().all()) furnace(*model);
}

TEST_F(Compensation, MixesKeepAllLight) {
  for (const char* id : {"GGX*SmithGGX*CookTorrance", "Blinn*SchlickBeckmann*None", "GGX*Implicit*SphericalGaussian", "GTR1*SmithCorrelated*Schlick"})
    furnace(*mixModel(id));
}

// Long lobes, in a plugin's own words: Ward 1992 without what it gains (Duer 2006), Ashikhmin and Shirley 2000, and GGX.
constexpr const char* kLongLobes[] = {
    "/*glint {\"id\": \"duer\", \"uses\": [\"metallic\", \"baseColor\", \"specular\"]} */\n"
    "vec3 specular(Shading s, Parameters p) {\n"
    "  vec2 a = vec2(0.15, 0.9), h = vec2(dot(s.H, s.T), dot(s.H, s.B)) / a;\n"
    "  float cos2 = max(s.NoH * s.NoH, 1e-6);\n"
    "  return s.F0 * exp(-dot(h, h) / cos2) / (4.0 * kPi * a.x * a.y * s.VoH * s.VoH * cos2 * cos2 + 1e-9) * min(1.0, 2.0 * s.NoH * min(s.NoL, s.NoV) / s.VoH) ; }\n",
    "/*glint {\"id\": \"ashikhmin-shirley\", \"uses\": [\"metallic\", \"baseColor\", \"specular\"]} */\n"
    "vec3 specular(Shading s, Parameters p) {\n"
    "  vec2 n = vec2(10.0, 1000.0), h = vec2(dot(s.H, s.T), dot(s.H, s.B));\n"
    "  float k = dot(n, h * h) / max(dot(h, h), 1e-12);\n"
    "  return F_Schlick(s) * sqrt((n.x + 1.0) * (n.y + 1.0)) * pow(s.NoH, k) / (8.0 * kPi * s.VoH * max(s.NoL, s.NoV)); }\n",
    "/*glint {\"id\": \"long-ggx\", \"terms\": {\"F\": \"Schlick\"}} */\n"
    "float D(Shading s, Parameters p) { return D_GGXaniso(s, 0.9); }\n"
    "float V(Shading s, Parameters p) { return V_SmithGGXCorrelatedAniso(s, 0.9); }\n"};

TEST_F(Compensation, LongLobesKeepAllLightFromAllSides) {
  for (const char* text : kLongLobes) {
    const auto model = parseModel("long.glsl", text);
    ASSERT_TRUE(model) << text;
    ASSERT_TRUE(model->usesTangent);
    furnace(*model);
    const auto table = losses(modelSetting(*model));
    ASSERT_TRUE(table);
    EXPECT_EQ(table->layers, LossTable::kLayers);
    EXPECT_EQ(table->rows, model->reads("roughness") ? LossTable::kRoughnesses : 1);
  }
}

// Who reads the tangent and loses the same from all sides pays nothing for it.
TEST_F(Compensation, ARoundLobeHasOneLayer) {
  const auto round = parseModel("round.glsl", "/*glint {\"id\": \"round\", \"terms\": {\"V\": \"SmithGGXCorrelated\", \"F\": \"Schlick\"}} */\n"
                                              "float D(Shading s, Parameters p) { return D_GGXaniso(s, 0.0); }\n");
  ASSERT_TRUE(round && round->usesTangent);
  EXPECT_EQ(losses(modelSetting(*round))->layers, 1);
  furnace(*round);
}

TEST_F(Compensation, IsReciprocal) {
  std::vector<ProbePoint> points;
  for (const float roughness : {0.05f, 0.3f, 0.8f})
    for (const double l : {0.003, 0.2, 0.9})
      for (const double v : {0.01, 0.5, 1.0})
        for (const bool swapped : {false, true}) {
          const glm::dvec3 a(std::sqrt(1 - l * l), 0, l), b(0, std::sqrt(1 - v * v), v);
          points.push_back(swapped ? ProbePoint::at(b, a) : ProbePoint::at(a, b));
          points.back().roughness = roughness;
          points.back().F0 = {1, 0.7, 0.2};
        }
  for (const ModelPtr& model : ModelRegistry().all()) {
    if (!model->claims.reciprocal) continue;
    const std::vector<glm::vec4> f = ModelProbe::ofModel(*model, true)->evaluate(points);
    for (size_t i = 0; i < points.size(); i += 2)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[2 * i][c], f[2 * i + 2][c], 1e-3f * f[2 * i][c] + 1e-6f) << model->id;
  }
}

// A lobe six times as long as wide loses more from some sides than from others. The numbers are by a double-precision sum
// over 10^6 half vectors drawn from D, in another program.
TEST_F(Compensation, AlbedosOfALongLobeFromEachSide) {
  const auto model = parseModel("long.glsl", "/*glint {\"id\": \"long\", \"terms\": {\"F\": \"None\"}} */\n"
                                             "float D(Shading s, Parameters p) { return D_GGXaniso(s, 0.9); }\n"
                                             "float V(Shading s, Parameters p) { return V_SmithGGXCorrelatedAniso(s, 0.9); }\n");
  ASSERT_TRUE(model);
  const struct { float alpha, NoV; double E[6]; } exact[] = {
      {1, 0.1f, {0.7067, 0.6916, 0.6364, 0.4809, 0.4056, 0.3860}}, {1, 0.3f, {0.4508, 0.4317, 0.3709, 0.2677, 0.2461, 0.2444}},
      {0.5f, 0.1f, {0.8425, 0.8339, 0.8014, 0.6928, 0.6104, 0.5651}}, {0.09f, 0.3f, {0.8834, 0.8857, 0.8986, 0.9364, 0.9531, 0.9603}}};
  constexpr double kDegrees[] = {0, 22.5, 45, 70, 80, 90};
  std::vector<IntegralQuery> queries;
  std::vector<double> wanted;
  for (const auto& row : exact)
    for (size_t i = 0; i < std::size(kDegrees); ++i)
      for (const double azimuth : {kDegrees[i], -kDegrees[i], 180 - kDegrees[i]}) {
        queries.push_back({.roughness = std::sqrt(row.alpha), .NoV = row.NoV, .azimuth = static_cast<float>(glm::radians(azimuth))});
        wanted.push_back(row.E[i]);
      }
  for (const int quarter : {24, 14}) {
    auto integrals = ModelIntegrals::of(*model, {.compensate = false, .polar = quarter == 14 ? 48 : 128, .quarter = quarter});
    ASSERT_TRUE(integrals);
    const float few[] = {0.05f, 0.3f, 1.f};
    for (const float aspect : integrals->aspects(few)) EXPECT_NEAR(aspect, 0.19, 0.02);
    const std::vector<ModelIntegral> E = integrals->evaluate(queries);
    for (size_t i = 0; i < E.size(); ++i)
      EXPECT_NEAR(E[i].specular.g, wanted[i], quarter == 14 ? 4e-3 : 2e-3) << "roughness " << queries[i].roughness << ", NoV " << queries[i].NoV << ", azimuth " << glm::degrees(queries[i].azimuth) << ", quarter " << quarter;
  }
}

// Facets that absorb, absorb more with each bounce: the colour deepens, and less light comes back than from white ones.
TEST_F(Compensation, ColoursDeepen) {
  auto integrals = ModelIntegrals::of(*mixModel("GGX*SmithGGXCorrelated*None"), {.compensate = true});
  const IntegralQuery query[] = {{.roughness = 1, .NoV = 0.7f, .F0 = {0.9f, 0.5f, 0.2f}}};
  const glm::dvec3 E = integrals->evaluate(query)[0].specular;
  EXPECT_LT(E.r, 0.9);
  EXPECT_LT(E.g / E.r, 0.5 / 0.9);
  EXPECT_LT(E.b / E.g, 0.2 / 0.5);
}

TEST_F(Compensation, AModelThatIsNeverWhiteIsLeftAlone) {
  const auto model = parseModel("m.glsl", "/*glint {\"id\": \"m\"} */\nvec3 specular(Shading s, Parameters p) {\n"
                                          "  return vec3(0.3 * D_GGX(s) * V_SmithGGX(s)); }\n");
  furnace(*model);
}

TEST_F(Compensation, WhatReflectsNothingOrNoNumberAddsNothing) {
  for (const char* value : {"vec3(0.0)", "vec3(1.0, 0.0, 0.0) / max(s.NoL - 2.0, 0.0)", "s.F0 * -1.0"}) {
    const auto model = parseModel("m.glsl", std::string("/*glint {\"id\": \"m\"} */\nvec3 specular(Shading s, Parameters p) { return ") + value + "; }\n");
    ProbePoint p;
    p.roughness = 0.5f;
    const ProbePoint points[] = {p};
    const glm::vec4 single = ModelProbe::ofModel(*model, false)->evaluate(points)[0], whole = ModelProbe::ofModel(*model, true)->evaluate(points)[0];
    EXPECT_TRUE(single.g == whole.g || (std::isnan(single.g) && std::isnan(whole.g))) << value;
  }
}

// What falls as the square of the cosine even where it is smooth is as whole between the table's lines as on them.
TEST_F(Compensation, SteepLossesAreGivenBackBetweenTheLinesOfTheTable) {
  for (const char* mix : {"GGX*Implicit*Schlick", "Beckmann*Implicit*Schlick"}) {
    const auto model = ModelRegistry().get(mix);
    ASSERT_TRUE(model);
    const auto integrals = ModelIntegrals::of(**model, {.compensate = true});
    ASSERT_TRUE(integrals);
    std::vector<IntegralQuery> queries;
    for (const float roughness : {0.05f, 0.1f, 0.37f, 0.9f})
      for (const float NoV : {0.02f, 0.15f, 0.4f, 0.75f, 0.85f, 0.9f, 0.95f}) queries.push_back({.roughness = roughness, .NoV = NoV});
    const std::vector<ModelIntegral> sums = integrals->evaluate(queries);
    for (size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i].specular.g, 1, 5e-3) << mix << " at " << queries[i].roughness << ", " << queries[i].NoV;
  }
}

// A sphere under light from everywhere vanishes at every angle and roughness.
TEST_F(Compensation, WhiteMetalsVanishInTheFurnace) {
  Renderer renderer(*context_);
  const MeshPtr sphere = sphereMesh(48, 24);
  Camera camera;
  camera.orthoHeight = 2.1f;
  for (const ModelPtr& model : ModelRegistry().all()) {
    // One with colours of its own may be diffuse where others are metals.
    if (!followsF0(*model) || model->definesColors) continue;
    auto integrals = ModelIntegrals::of(*model, {.compensate = false});
    for (const float roughness : {0.f, 0.25f, 1.f}) {
      Scene scene;
      scene.materials.push_back(test::material(model, {.baseColor = glm::vec3(1), .metallic = 1, .roughness = roughness}));
      scene.instances.push_back({sphere, glm::mat4(1), 0});
      scene.environment = test::uniformEnvironment(1);
      std::vector<IntegralQuery> where;
      for (const float NoV : {0.01f, 0.1f, 0.3f, 0.6f, 1.f}) where.push_back({roughness, NoV, false});
      const std::vector<ModelIntegral> E = integrals->evaluate(where);
      const bool gains = std::any_of(E.begin(), E.end(), [](const ModelIntegral& i) { return largest(i.specular) > 1.003; });
      if (gains) continue;
      const View view{&scene, camera, {0, 0, 64, 64}};
      const ImageF image = renderer.linear(std::span(&view, 1), {64, 64}, {.compensate = true});
      float low = 2, high = 0;
      for (size_t i = 0; i < image.data.size(); i += 3) {
        const float most = std::max({image.data[i], image.data[i + 1], image.data[i + 2]});
        low = std::min(low, most);
        high = std::max(high, most);
      }
      EXPECT_NEAR(low, 1, 5e-3) << model->id << " roughness " << roughness;
      EXPECT_NEAR(high, 1, 5e-3) << model->id << " roughness " << roughness;
    }
  }
}

TEST_F(Compensation, AHeadThatAsksForItIsMeasuredWithIt) {
  const auto model = parseModel("m.glsl", "/*glint {\"id\": \"m\", \"terms\": {\"D\": \"GGX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}, \"compensate\": true} */\n");
  ASSERT_TRUE(model);
  EXPECT_TRUE(model->compensate);
  const ModelHealth health = checkHealth(*model);
  ASSERT_TRUE(health.find(Law::Furnace));
  EXPECT_NEAR(health.find(Law::Furnace)->value, 1, 5e-3) << health.find(Law::Furnace)->where;
  EXPECT_EQ(health.find(Law::Furnace)->verdict, Verdict::Green);
}

}  // namespace
}  // namespace glint
