// Masking that Glint derives from a model's own D: against closed forms and exact numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "materials/model_mix.h"
#include "materials/model_registry.h"
#include "renderer/gl/context.h"
#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"

namespace glint {
namespace {

class OwnSmith : public testing::Test {
 protected:
  void SetUp() override {
    auto created = gl::Context::create({.backend = gl::Backend::Egl});
    ASSERT_TRUE(created) << created.diagnostics()[0].text();
    context_ = std::move(*created);
  }
  static ModelProbe probe(const std::string& id) {
    const auto model = ModelRegistry().get(id);
    GLINT_CHECK(model.ok(), "{}", model.diagnostics()[0].text());
    auto made = ModelProbe::ofModel(**model);
    GLINT_CHECK(made.ok(), "{}", made.diagnostics()[0].text());
    return std::move(*made);
  }
  // The largest relative difference of the specular parts of two models, over roughnesses and directions between the
  // table's nodes, grazing ones too.
  static double difference(const std::string& id, const std::string& reference) {
    std::vector<ProbePoint> points;
    for (const float roughness : {0.f, 0.01f, 0.024f, 0.05f, 0.073f, 0.11f, 0.3f, 0.47f, 0.61f, 0.83f, 1.f})
      for (const double l : {1e-4, 7e-4, 3e-3, 0.011, 0.047, 0.13, 0.31, 0.62, 0.97})
        for (const double v : {2e-4, 5e-3, 0.061, 0.4, 0.93})
          for (const double azimuth : {0.0, 0.5, 1.3, 2.9}) {
            const double a = std::sqrt(1 - l * l), b = std::sqrt(1 - v * v);
            points.push_back(ProbePoint::at({a * std::cos(azimuth), a * std::sin(azimuth), l}, {b * std::cos(0.7), b * std::sin(0.7), v}));
            points.back().roughness = roughness;
            points.back().fromDirections = true;
          }
    const std::vector<glm::vec4> got = probe(id).evaluate(points), wanted = probe(reference).evaluate(points);
    double worst = 0;
    for (size_t i = 0; i < got.size(); i += 2)
      if (wanted[i].g > 1e-20f) worst = std::max(worst, std::abs(static_cast<double>(got[i].g) / static_cast<double>(wanted[i].g) - 1));
    return worst;
  }
  std::unique_ptr<gl::Context> context_;
};

// V has two such areas: 2e-3 of it is 1e-3 of each.
TEST_F(OwnSmith, OfGgxIsSmithsClosedForm) {
  EXPECT_LT(difference("GGX*Smith*None", "GGX*SmithGGX*None"), 2e-3);
  EXPECT_LT(difference("GGX*SmithCorrelated*None", "GGX*SmithGGXCorrelated*None"), 2e-3);
}

TEST_F(OwnSmith, OfStretchedGgxFollowsTheAzimuth) {
  EXPECT_LT(difference("GGXaniso*SmithCorrelated*None", "GGXaniso*SmithGGXCorrelatedAniso*None"), 0.02);
}

// Walter's fit for Beckmann is itself off by 0.35 % for each direction.
TEST_F(OwnSmith, OfBeckmannIsWithinItsFit) { EXPECT_LT(difference("Beckmann*Smith*None", "Beckmann*SmithBeckmann*None"), 9e-3); }

// G1 = NoV / area, from 4 NoL NoV V at l = n, where the other G1 is 1. Exact values by quadrature of high precision.
TEST_F(OwnSmith, ExactMaskingOfGtr) {
  const struct {
    const char* D;
    float roughness;
    double NoV, G1;
  } cases[] = {{"GTR1_5", 0.2f, 0.05, 0.61490155873}, {"GTR1_5", 0.6f, 0.8, 0.96811578311}, {"GTR1_5", 0.8f, 0.2, 0.42868784221},
               {"GTR1", 0.2f, 0.05, 0.28066608871},   {"GTR1", 0.4f, 0.5, 0.86428709921},   {"GTR1", 0.8f, 0.8, 0.92138132766},
               {"Blinn", 0.4f, 0.05, 0.66804533026},  {"Blinn", 1.f, 0.5, 0.66666666667},   {"Beckmann", 0.6f, 0.05, 0.38946193774}};
  for (const auto& c : cases) {
    ProbePoint p = ProbePoint::at({0, 0, 1}, {std::sqrt(1 - c.NoV * c.NoV), 0, c.NoV});
    p.roughness = c.roughness;
    p.F0 = glm::vec3(1);
    const ProbePoint points[] = {p};
    const glm::vec4 smith = probe(std::string(c.D) + "*Smith*None").evaluate(points)[0];
    EXPECT_NEAR(smith.g / (smith.a * p.F0.g) * 4 * c.NoV, c.G1, 1e-3 * c.G1) << c.D << " " << c.roughness << " " << c.NoV;
  }
}

TEST_F(OwnSmith, KeepsEveryTailFromGaining) {
  for (const char* D : {"GTR1", "GTR1_5", "GTR3", "Blinn"})
    for (const char* V : {"Smith", "SmithCorrelated"}) {
      const auto model = mixModel(std::string(D) + "*" + V + "*None");
      auto integrals = ModelIntegrals::of(*model);
      ASSERT_TRUE(integrals);
      std::vector<IntegralQuery> queries;
      for (const float roughness : {0.05f, 0.15f, 0.3f, 0.5f, 0.8f, 1.f})
        for (const float NoV : {0.005f, 0.05f, 0.3f, 0.8f}) queries.push_back({roughness, NoV});
      double most = 0;
      for (const ModelIntegral& i : integrals->evaluate(queries)) most = std::max(most, i.specular.g);
      EXPECT_LE(most, 1.003) << model->id;
      EXPECT_GT(most, 0.9) << model->id;
    }
}

TEST_F(OwnSmith, FollowsItsParameters) {
  ModelProbe gtr = probe("GTR*Smith*None");
  gtr.set("gamma", Value::scalar(2));
  ProbePoint p = ProbePoint::at(glm::normalize(glm::dvec3(0.9, 0.1, 0.2)), glm::normalize(glm::dvec3(-0.7, 0.3, 0.2)));
  p.fromDirections = true;
  p.roughness = 0.6f;
  const ProbePoint points[] = {p};
  EXPECT_NEAR(gtr.evaluate(points)[0].g / probe("GGX*SmithGGX*None").evaluate(points)[0].g, 1, 2e-3) << "gamma 2 is GGX";
}

TEST(OwnSmithHead, NeedsAD) {
  const auto named = parseModel("m.glsl", "/*glint {\"id\": \"m\",\n \"terms\": {\"V\": \"Smith\"}} */\n"
                                          "vec3 specular(Shading s, Parameters p) { return s.F0; }\n");
  ASSERT_FALSE(named);
  EXPECT_THAT(named.diagnostics()[0].text(), testing::AllOf(testing::HasSubstr("m.glsl:2"), testing::HasSubstr("uses V_Smith but has no D")));
  const auto called = parseModel("m.glsl", "/*glint {\"id\": \"m\"} */\nvec3 specular(Shading s, Parameters p) {\n"
                                           "  return s.F0 * (D_GGX(s) * V_SmithCorrelated(s));\n}\n");
  ASSERT_FALSE(called);
  EXPECT_THAT(called.diagnostics()[0].text(), testing::HasSubstr("m.glsl:3"));
  const auto sound = parseModel("m.glsl", "/*glint {\"id\": \"m\"} */\nfloat D(Shading s, Parameters p) { return D_GTR1(s); }\n"
                                          "vec3 specular(Shading s, Parameters p) { return s.F0 * (D(s, p) * V_Smith(s)); }\n");
  ASSERT_TRUE(sound) << sound.diagnostics()[0].text();
  EXPECT_TRUE(sound->smithOfOwnD);
  EXPECT_FALSE(mixModel("GGX*SmithGGX*Schlick")->smithOfOwnD);
}

}  // namespace
}  // namespace glint
