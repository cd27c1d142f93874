// Environments under lobes, against exact averages over their pixels; and the suns and lamps that are taken out for that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "renderer/environment.h"
#include "renderer/environment_benchmark.h"
#include "renderer/environment_irradiance.h"
#include "renderer/environment_spots.h"
#include "tests/support/renderer_fixture.h"
#include "tests/support/simple_scene.h"

namespace glint {
namespace {

constexpr int kWidth = 256;
constexpr size_t kTexels = 64;
constexpr double kDegree = std::numbers::pi / 180;
constexpr SpotSizes kSizes{4 * kDegree, 0.5 * kDegree};

// A grey gradient with a disc of light.
ImageF pictureWithDisc(const glm::vec3& towards, double radius, float radiance, int width = kWidth) {
  ImageF image(width, width / 2, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::vec3 d = environmentDirection(x, y, width, image.height);
      const bool inside = static_cast<double>(glm::distance(d, towards)) < 2 * std::sin(radius / 2);
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = (inside ? radiance * (c == 2 ? 0.5f : 1.0f) : 0) + 0.3f + 0.2f * d.y;
    }
  return image;
}

glm::dvec3 lightOf(const ImageF& image) {
  glm::dvec3 sum(0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) sum[c] += static_cast<double>(image.at(x, y)[c]) * solidAngle(y, image.width, image.height);
  return sum;
}

const glm::vec3 kAbove = glm::normalize(glm::vec3(0.5f, 0.7f, -0.4f)), kAtTheSeam = glm::normalize(glm::vec3(-1, 0.3f, 0.001f));

TEST(EnvironmentSpots, ASunIsTakenOutAndNothingIsLost) {
  for (const glm::vec3& towards : {kAbove, kAtTheSeam}) {
    const ImageF image = pictureWithDisc(towards, 1 * kDegree, 20000);
    const SpotsOfEnvironment found = takeOutSpots(image, kSizes);
    ASSERT_FALSE(found.spots.empty());
    ASSERT_LE(found.spots.size(), 16u);
    glm::dvec3 flux(0), direction(0);
    for (const EnvironmentSpot& spot : found.spots) {
      flux += glm::dvec3(spot.irradiance);
      direction += glm::dvec3(spot.direction) * static_cast<double>(spot.irradiance.g);
    }
    EXPECT_GT(glm::dot(glm::normalize(direction), glm::dvec3(towards)), std::cos(1 * kDegree));
    const glm::dvec3 before = lightOf(image), rest = lightOf(found.rest);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(rest[c] + flux[c], before[c], 1e-4 * before[c]);
    EXPECT_LT(*std::max_element(found.rest.data.begin(), found.rest.data.end()), 17 * before.r / (4 * std::numbers::pi));
  }
}

TEST(EnvironmentSpots, WhatIsLargeOrDimStays) {
  EXPECT_TRUE(takeOutSpots(pictureWithDisc(kAbove, 8 * kDegree, 20000), kSizes).spots.empty());
  EXPECT_FALSE(takeOutSpots(pictureWithDisc(kAbove, 8 * kDegree, 20000), {20 * kDegree, 2 * kDegree}).spots.empty());
  EXPECT_TRUE(takeOutSpots(pictureWithDisc(kAbove, 1 * kDegree, 2), kSizes).spots.empty());
  EXPECT_TRUE(takeOutSpots(ImageF(2, 1, 3), kSizes).spots.empty()) << "a black one";
}

// The brightest of many are taken.
TEST(EnvironmentSpots, ThereAreOnlySoMany) {
  ImageF image = pictureWithDisc(kAbove, 0.1 * kDegree, 0);
  for (int i = 0; i < 400; ++i) image.at(8 + i % 40 * 6, 20 + i / 40 * 8)[1] = 2000 + 20.0f * static_cast<float>(i);
  const SpotsOfEnvironment found = takeOutSpots(image, kSizes);
  EXPECT_EQ(found.spots.size(), SpotsOfEnvironment::kMost);
  EXPECT_NEAR(lightOf(found.rest).g, lightOf(image).g - [&] { double sum = 0; for (const auto& s : found.spots) sum += static_cast<double>(s.irradiance.g); return sum; }(), 1e-3);
}

// Irradiance over pi of a constant is the constant; of a sky that is 1 above the horizon, (1 + n.y) / 2.
TEST(DiffuseLight, OfAConstantAndOfHalfASky) {
  const auto evaluate = [](const std::array<glm::vec4, 9>& c, glm::vec3 n) {
    return c[0].x + c[1].x * n.y + c[2].x * n.z + c[3].x * n.x + c[4].x * n.x * n.y + c[5].x * n.y * n.z +
           c[6].x * (3 * n.z * n.z - 1) + c[7].x * n.x * n.z + c[8].x * (n.x * n.x - n.y * n.y);
  };
  const auto constant = diffuseLight(test::uniformEnvironment(2)->pixels).harmonics;
  EXPECT_NEAR(evaluate(constant, glm::normalize(glm::vec3(1, 2, -3))), 2, 1e-3);
  ImageF sky(128, 64, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 128; ++x) std::fill_n(sky.at(x, y), 3, 1.0f);
  const auto half = diffuseLight(sky).harmonics;
  for (const glm::vec3 n : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::normalize(glm::vec3(1, 1, 0)), glm::vec3(0, 0, 1)})
    EXPECT_NEAR(evaluate(half, n), (1 + n.y) / 2, 2e-3);
  // A light from +X alone is brightest there.
  ImageF spot(128, 64, 3);
  spot.at(64, 32)[0] = 100;
  const auto side = diffuseLight(spot).harmonics;
  EXPECT_GT(evaluate(side, {1, 0, 0}), 5 * std::abs(evaluate(side, {0, 0, 1})));
  EXPECT_GT(evaluate(side, {1, 0, 0}), evaluate(side, glm::vec3(std::cos(1.0f), 0, std::sin(1.0f))));
}

// The map is exact, and used where harmonics are not.
TEST(DiffuseLight, AMapHasWhatHarmonicsHaveNot) {
  const DiffuseLight even = diffuseLight(pictureWithDisc(kAbove, 1 * kDegree, 0));
  EXPECT_LT(even.harmonicsError, 0.001);
  EXPECT_FALSE(even.needsMap());
  const ImageF image = pictureWithDisc(kAbove, 1 * kDegree, 20000);
  const DiffuseLight sun = diffuseLight(image);
  EXPECT_GT(sun.harmonicsError, 0.05);
  EXPECT_TRUE(sun.needsMap());
  constexpr int kSize = DiffuseLight::kMapSize;
  for (const int texel : {0, 300, 517, 777, 1034, 1535}) {
    const glm::vec3 n = glm::normalize(cubeDirection(texel / (kSize * kSize), (glm::vec2(texel % kSize, texel / kSize % kSize) + 0.5f) / static_cast<float>(kSize)));
    double exact = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        exact += static_cast<double>(image.at(x, y)[1] * std::max(0.0f, glm::dot(n, environmentDirection(x, y, image.width, image.height)))) *
                 solidAngle(y, image.width, image.height) / std::numbers::pi;
    EXPECT_NEAR(static_cast<double>(sun.map[static_cast<size_t>(texel)].g), exact, 2e-3 * exact + 1e-4) << texel;
  }
}

class Prefiltered : public test::RendererFixture<Prefiltered> {
 protected:
  static std::vector<double> errors(ImageF pixels) {
    const auto environment = std::make_shared<Environment>(Environment{"test", std::move(pixels), 0});
    EnvironmentBenchmark benchmark(*models->get("ggx"));
    const auto found = benchmark.errors(environment, kTexels);
    EXPECT_TRUE(found);
    return *found;
  }
};

// Of a sun of any size the error stays below 1 % at each level but the sharpest, whose samples meet large ones by themselves.
TEST_F(Prefiltered, SunsAndLampsAreNearlyExact) {
  for (const auto& [radius, sharpest] : {std::pair{0.8, 0.03}, {3.0, 0.03}, {5.0, 0.06}}) {
    const std::vector<double> found = errors(pictureWithDisc(kAbove, radius * kDegree, 40000));
    ASSERT_EQ(found.size(), 5u);
    EXPECT_LT(found[0], sharpest) << radius;
    for (size_t level = 1; level < 5; ++level) EXPECT_LT(found[level], 0.01) << radius << " degrees, level " << level + 1;
  }
}

TEST_F(Prefiltered, TheStudioIs) {
  const std::vector<double> found = errors(studioPixels(512));
  for (const double error : found) EXPECT_LT(error, 0.01);
}

// One whose lobe does not widen has it at its own level, and a sun is not drawn as dots there.
TEST_F(Prefiltered, ASunInANarrowLobeIsWhole) {
  const auto model = parseModel("narrow.glsl", "/*glint {\"id\": \"narrow\", \"uses\": [\"baseColor\"]} */\n"
                                               "vec3 specular(Shading s, Parameters p) { return vec3(exp(-s.sinH2 * 2e5) * 1e4); }\n");
  ASSERT_TRUE(model);
  EnvironmentBenchmark benchmark(std::make_shared<const ShadingModel>(*model));
  const auto environment = std::make_shared<Environment>(Environment{"test", pictureWithDisc(kAbove, 1.5 * kDegree, 5000, 1024), 7});
  const auto found = benchmark.errors(environment, kTexels);
  ASSERT_TRUE(found);
  EXPECT_LT(found->front(), 0.1);
}

}  // namespace
}  // namespace glint
