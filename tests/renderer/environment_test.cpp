#include "renderer/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/image_io.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using testing::HasSubstr;

// What a surface with normal `n` gets, in lux over pi: what a white one shows.
glm::dvec3 shownByWhite(const ImageF& image, const glm::vec3& n) {
  glm::dvec3 sum(0);
  for (int y = 0; y < image.height; ++y) {
    const double step = M_PI / image.height;
    const double solid = 2 * M_PI / image.width * (std::cos(step * y) - std::cos(step * (y + 1)));
    for (int x = 0; x < image.width; ++x) {
      const float cosine = glm::dot(environmentDirection(x, y, image.width, image.height), n);
      const float* p = image.at(x, y);
      if (cosine > 0) sum += glm::dvec3(p[0], p[1], p[2]) * (solid * double(cosine));
    }
  }
  return sum / M_PI;
}

TEST(Environments, EveryNameLoadsAndIsClean) {
  for (const std::string& name : environmentNames()) {
    const auto loaded = loadEnvironment(name);
    ASSERT_TRUE(loaded.ok()) << name;
    if (name == "none") {
      EXPECT_EQ(*loaded, nullptr);
      continue;
    }
    const Environment& e = **loaded;
    EXPECT_EQ(e.name, name);
    EXPECT_EQ(e.pixels.width, 2 * e.pixels.height);
    EXPECT_EQ(e.pixels.channels, 3);
    for (const float v : e.pixels.data) ASSERT_TRUE(v >= 0 && std::isfinite(v));
    EXPECT_EQ((*loadEnvironment(name))->hash, e.hash) << "the same at every call";
  }
}

TEST(Environments, DirectionsAreOrientedAsTheContractSays) {
  // u = 0.5 + atan2(d.z, d.x) / 2 pi, v from the top = acos(d.y) / pi
  const int width = 256, height = 128;
  for (const glm::ivec2 p : {glm::ivec2(0, 0), glm::ivec2(77, 30), glm::ivec2(200, 100)}) {
    const glm::vec3 d = environmentDirection(p.x, p.y, width, height);
    EXPECT_NEAR((0.5 + std::atan2(d.z, d.x) / (2 * M_PI)) * width, p.x + 0.5, 1e-2);
    EXPECT_NEAR(std::acos(d.y) / M_PI * height, p.y + 0.5, 1e-2);
  }
}

TEST(Environments, FurnaceShowsWhiteAsOne) {
  const auto furnace = loadEnvironment("furnace");
  for (const float v : (*furnace)->pixels.data) EXPECT_EQ(v, 1);
}

TEST(Environments, StudioSuitsExposureZero) {
  const ImageF studio = studioPixels(256);
  const glm::dvec3 key = shownByWhite(studio, glm::normalize(glm::vec3(-0.5f, 0.5f, 0.6f)));
  const glm::dvec3 below = shownByWhite(studio, {0, -1, 0});
  EXPECT_GT(key.g, 0.6);
  EXPECT_LT(key.g, 1.0);
  EXPECT_GT(below.g, 0.05);
  EXPECT_LT(below.g, key.g / 3);
}

TEST(Environments, SkyShowsALevelWhiteSurfaceAsOneWithASaneSun) {
  for (const float elevation : {10.0f, 42.0f, 80.0f}) {
    const ImageF sky = skyPixels(512, elevation);
    const glm::dvec3 level = shownByWhite(sky, {0, 1, 0});
    EXPECT_NEAR(0.2126 * level.r + 0.7152 * level.g + 0.0722 * level.b, 1, 0.01) << elevation;
    // The sun gives four fifths of it: without pixels over a hundredth of the brightest it is gone.
    ImageF dome = sky;
    float brightest = 0;
    for (const float v : sky.data) brightest = std::max(brightest, v);
    EXPECT_GT(brightest, 50);
    for (float& v : dome.data)
      if (v > brightest / 100) v = 0;
    EXPECT_NEAR(shownByWhite(dome, {0, 1, 0}).g / level.g, 0.2, 0.04) << elevation;
    // Blue overhead.
    const float* zenith = sky.at(0, 8);
    EXPECT_GT(zenith[2], 1.5f * zenith[0]);
  }
}

TEST(Environments, SunStandsWhereItIsSaid) {
  const ImageF sky = skyPixels(512, 30);
  size_t brightest = 0;
  for (size_t i = 0; i < sky.data.size(); i += 3)
    if (sky.data[i] > sky.data[brightest]) brightest = i;
  const int pixel = int(brightest / 3);
  const glm::vec3 d = environmentDirection(pixel % 512, pixel / 512, 512, 256);
  EXPECT_NEAR(glm::degrees(std::asin(d.y)), 30, 1.5);
  EXPECT_GT(d.z, 0);
  EXPECT_GT(d.x, 0);
}

class EnvironmentFiles : public testing::Test {
 protected:
  Diagnostics load(ImageF image, const char* name = "x.pfm") {
    EXPECT_TRUE(writeImageF(folder_ / name, image).empty());
    const auto loaded = loadEnvironment((folder_ / name).string());
    return loaded.ok() ? Diagnostics{} : loaded.diagnostics();
  }
  ImageF good() const {
    ImageF image(8, 4, 3);
    std::fill(image.data.begin(), image.data.end(), 0.5f);
    return image;
  }
  test::TempFolder folder_;
};

TEST_F(EnvironmentFiles, AllThreeFormatsLoad) {
  for (const char* name : {"x.hdr", "x.exr", "x.pfm"}) {
    EXPECT_TRUE(load(good(), name).empty()) << name;
    const auto loaded = loadEnvironment((folder_ / name).string());
    EXPECT_EQ((*loaded)->name, name);
    EXPECT_EQ((*loaded)->pixels, good());
  }
}

TEST_F(EnvironmentFiles, MustBeTwiceAsWideAsHigh) {
  const Diagnostics d = load(ImageF(8, 5, 3));
  ASSERT_EQ(d.size(), 1u);
  EXPECT_THAT(d[0].what, HasSubstr("8 x 5"));
}

TEST_F(EnvironmentFiles, BadPixelsAreNamedWithTheirPlaceAndNumber) {
  for (const auto& [value, word] : {std::pair(std::nanf(""), "NaN"), {std::numeric_limits<float>::infinity(), "infinite"}, {-2.5f, "-2.5"}}) {
    ImageF image = good();
    image.at(5, 2)[1] = value;
    image.at(6, 3)[0] = value;
    const Diagnostics d = load(image);
    ASSERT_EQ(d.size(), 1u);
    EXPECT_THAT(d[0].what, HasSubstr("pixel (5, 2)"));
    EXPECT_THAT(d[0].what, HasSubstr(word));
    EXPECT_THAT(d[0].what, HasSubstr("in green, and 1 more"));
  }
}

TEST_F(EnvironmentFiles, BothFaultsAtOnce) {
  ImageF image(8, 5, 3);
  image.at(0, 0)[0] = -1;
  EXPECT_EQ(load(image).size(), 2u);
}

TEST_F(EnvironmentFiles, UnknownNamesGetAHint) {
  EXPECT_THAT(loadEnvironment("studoi").diagnostics()[0].hint, HasSubstr("'studio'"));
  EXPECT_THAT(loadEnvironment("/nowhere/x.hdr").diagnostics()[0].place, HasSubstr("/nowhere/x.hdr"));
  EXPECT_FALSE(loadEnvironment(folder_.path().string()).ok());
}

}  // namespace
}  // namespace glint
