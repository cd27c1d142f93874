// Directions drawn from any model's own lobe: laws for every registered model, naming none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "materials/model_registry.h"
#include "renderer/gl/context.h"
#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"
#include "renderer/model_sampler.h"
#include "renderer/sampler_error.h"

namespace glint {
namespace {

using std::numbers::pi;

class Sampler : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::Context::create({.backend = gl::Backend::Egl});
    ASSERT_TRUE(made);
    context_ = std::move(*made).release();
  }
  static void TearDownTestSuite() { delete context_; }
  static glm::dvec3 view(double NoV, double azimuth = 0) {
    const double sine = std::sqrt(1 - NoV * NoV);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), NoV};
  }
  static Result<ShadingModel> plugin(const std::string& body) { return parseModel("m.glsl", "/*glint {\"id\": \"m\"} */\n" + body); }

  // The integral of a sampler's density over the hemisphere: half of the nodes around the mirror direction, as dense for
  // every width of a lobe, the other half around the normal; each counts where its own axis is nearer.
  static double total(const DirectionSampler& sampler, const glm::dvec3& v) {
    const glm::dvec3 mirror(-v.x, -v.y, v.z), normal(0, 0, 1);
    constexpr double kSmallest = 1e-4;
    const double k = std::log1p(pi / kSmallest);
    double sum = 0;
    const auto around = [&](const glm::dvec3& axis, const glm::dvec3& other) {
      const glm::dvec3 side = glm::normalize(std::abs(axis.z) < 0.9 ? glm::cross(axis, glm::dvec3(0, 0, 1)) : glm::cross(axis, glm::dvec3(1, 0, 0)));
      const glm::dvec3 up = glm::cross(axis, side);
      for (int i = 0; i < 1000; ++i) {
        const double theta = kSmallest * std::expm1(k * (i + 0.5) / 1000);
        for (int j = 0; j < 256; ++j) {
          const double phi = 2 * pi * (j + 0.5) / 256;
          const glm::dvec3 l = std::sin(theta) * (std::cos(phi) * side + std::sin(phi) * up) + std::cos(theta) * axis;
          if (l.z <= 0 || glm::dot(l, axis) < glm::dot(l, other)) continue;
          sum += sampler.pdf(l) * std::sin(theta) * (theta + kSmallest) * k / 1000 * 2 * pi / 256;
        }
      }
    };
    around(mirror, normal);
    if (v.z < 0.999) around(normal, mirror);
    return sum;
  }

  struct Estimate {
    double mean = 0, error = 0;  // and the standard error of the mean
  };
  // The directional albedo of the specular part by 1024 directions.
  static Estimate estimate(const ModelProbe& probe, const DirectionSampler& sampler, const glm::dvec3& v, float roughness, double metallic = 1) {
    constexpr int kCount = 1024;
    std::vector<ProbePoint> points;
    std::vector<double> weights;
    for (int i = 0; i < kCount; ++i) {
      // The plastic sequence: two dimensions, evenly spread.
      const SampledDirection drawn = sampler.sample(std::fmod(0.5 + i * 0.7548776662466927, 1.0), std::fmod(0.5 + i * 0.5698402909980532, 1.0));
      EXPECT_GT(drawn.pdf, 0);
      EXPECT_GT(drawn.light.z, 0);
      points.push_back(ProbePoint::at(drawn.light, v));
      points.back().roughness = roughness;
      points.back().F0 = glm::vec3(1);
      points.back().diffuseColor = glm::vec3(0);
      points.back().metallic = static_cast<float>(metallic);
      points.back().fromDirections = true;
      weights.push_back(drawn.light.z / drawn.pdf);
    }
    const std::vector<glm::vec4> f = probe.evaluate(points);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const double x = static_cast<double>(f[2 * i].g) * weights[i];
      sum += x;
      squares += x * x;
    }
    const double mean = sum / kCount;
    return {mean, std::sqrt(std::max(squares / kCount - mean * mean, 0.0) / kCount)};
  }
  static inline gl::Context* context_ = nullptr;
};

TEST_F(Sampler, DensitiesIntegrateToOne) {
  for (const ModelPtr& model : ModelRegistry().all()) {
    const auto sampler = ModelSampler::of(modelSetting(*model));
    ASSERT_TRUE(sampler) << model->id;
    EXPECT_EQ(sampler->fault(), "") << model->id;
    for (const double roughness : {0.15, 0.6})
      for (const double NoV : {0.1, 0.7}) {
        const DirectionSampler at = sampler->at(view(NoV, 0.8), roughness, glm::dvec3(0.5), glm::dvec3(0.2));
        EXPECT_NEAR(total(at, view(NoV, 0.8)), 1, 0.01) << model->id << " roughness " << roughness << ", NoV " << NoV;
      }
  }
}

// Within a few standard errors, which are far below those of directions drawn by the cosine.
TEST_F(Sampler, AlbedosOfEveryModel) {
  for (const ModelPtr& model : ModelRegistry().all()) {
    const auto sampler = ModelSampler::of(modelSetting(*model));
    auto probe = ModelProbe::ofModel(*model, false);
    auto integrals = ModelIntegrals::of(*model, {.compensate = false});
    ASSERT_TRUE(sampler && probe && integrals);
    for (const float roughness : {0.1f, 0.3f, 0.7f, 1.f})
      for (const float NoV : {0.1f, 0.4f, 1.f}) {
        const IntegralQuery query[] = {{roughness, NoV}};
        const double exact = integrals->evaluate(query)[0].specular.g;
        const DirectionSampler at = sampler->at(view(NoV), roughness, glm::dvec3(1), glm::dvec3(0));
        const Estimate got = estimate(*probe, at, view(NoV), roughness);
        EXPECT_NEAR(got.mean, exact, 4 * got.error + 3e-3 * exact) << model->id << " roughness " << roughness << ", NoV " << NoV;
      }
    const SamplerError error = samplerError(*probe, *sampler);
    EXPECT_LT(error.worst, 0.03) << model->id << " roughness " << error.roughness << ", NoV " << error.NoV;
  }
}

TEST_F(Sampler, DrawsWhatItSays) {
  const auto sampler = ModelSampler::of(modelSetting(*ModelRegistry().all()[0]));
  const DirectionSampler at = sampler->at(view(0.5, 2), 0.6, glm::dvec3(0.04), glm::dvec3(0.5));
  // Shares of four quarters around the normal, drawn and integrated.
  std::array<double, 4> drawn{}, expected{};
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const glm::dvec3 l = at.sample(std::fmod(0.5 + i * 0.7548776662466927, 1.0), std::fmod(0.5 + i * 0.5698402909980532, 1.0)).light;
    EXPECT_NEAR(glm::length(l), 1, 1e-6);
    drawn[(l.x > 0 ? 1 : 0) + (l.y > 0 ? 2 : 0)] += 1.0 / kCount;
  }
  for (int i = 0; i < 500; ++i)
    for (int j = 0; j < 500; ++j) {
      const double z = (i + 0.5) / 500, phi = 2 * pi * (j + 0.5) / 500, s = std::sqrt(1 - z * z);
      const glm::dvec3 l(s * std::cos(phi), s * std::sin(phi), z);
      expected[(l.x > 0 ? 1 : 0) + (l.y > 0 ? 2 : 0)] += at.pdf(l) * 2 * pi / 250000;
    }
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(drawn[i], expected[i], 5e-3) << i;
}

TEST_F(Sampler, WhatCannotBeTabulatedGoesByTheCosine) {
  for (const auto& [body, fault] : {std::pair{"return vec3(0.0);", "the specular part is 0 everywhere"},
                                    {"return vec3(1.0) / max(s.NoL - 2.0, 0.0);", "f is not finite at roughness 0, NoV 0"},
                                    {"return vec3(sqrt(s.NoL - 2.0));", "f is not finite at roughness 0, NoV 0"},
                                    {"return -s.F0;", "f is negative at roughness 0, NoV 0"}}) {
    const auto model = plugin(std::string("vec3 specular(Shading s, Parameters p) { ") + body + " }\n");
    ASSERT_TRUE(model);
    const auto sampler = ModelSampler::of(modelSetting(*model), false);
    ASSERT_TRUE(sampler);
    EXPECT_EQ(sampler->fault(), fault);
    const DirectionSampler at = sampler->at(view(0.4), 0.5, glm::dvec3(1), glm::dvec3(0));
    EXPECT_NEAR(at.pdf({0, 0, 1}), 1 / pi, 1e-9) << body;
    EXPECT_NEAR(at.sample(0.3, 0.8).pdf, at.sample(0.3, 0.8).light.z / pi, 1e-9);
  }
  // Where only some of it cannot be, the rest is drawn from.
  const auto partly = plugin("vec3 specular(Shading s, Parameters p) {\n"
                             "  return s.F0 * (s.roughness < 0.2 ? 1.0 / max(s.NoL - 2.0, 0.0) : D_GGX(s) * V_SmithGGX(s)); }\n");
  const auto sampler = ModelSampler::of(modelSetting(*partly), false);
  EXPECT_NE(sampler->fault(), "");
  EXPECT_GT(sampler->at(view(0.9), 0.3, glm::dvec3(1), glm::dvec3(0)).pdf({-std::sqrt(1 - 0.81), 0, 0.9}), 1);
}

TEST_F(Sampler, BrokenGlslIsAtItsLine) {
  const auto model = plugin("vec3 specular(Shading s, Parameters p) {\n  return s.nonsense; }\n");
  const auto sampler = ModelSampler::of(modelSetting(*model), false);
  ASSERT_FALSE(sampler);
  EXPECT_EQ(sampler.diagnostics()[0].place, "m.glsl:3");
}

}  // namespace
}  // namespace glint
