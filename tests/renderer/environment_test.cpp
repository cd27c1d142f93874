#include "renderer/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "materials/base/files.h"
#include "renderer/environment_file.h"
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
  // What is said of the picture when it is read; `pixels_` are what it was read as.
  Diagnostics load(const ImageF& image, const char* name = "x.pfm") {
    EXPECT_TRUE(writeImageF(folder_ / name, image).empty());
    return load(name);
  }
  Diagnostics load(const char* name) {
    Diagnostics found;
    const auto loaded = loadEnvironment((folder_ / name).string(), &found);
    pixels_ = {};
    if (!loaded) return loaded.diagnostics();
    EXPECT_FALSE(hasErrors(found));
    pixels_ = (*loaded)->pixels;
    EXPECT_EQ(pixels_.width, 2 * pixels_.height);
    for (const float v : pixels_.data) EXPECT_TRUE(v >= 0 && v <= kBrightestPixel) << v;
    return found;
  }
  static ImageF grey(int width, int height) {
    ImageF image(width, height, 3);
    std::fill(image.data.begin(), image.data.end(), 0.5f);
    return image;
  }
  void write(const char* name, const std::string& bytes) { EXPECT_TRUE(writeFileAtomic(folder_ / name, bytes).empty()); }

  test::TempFolder folder_;
  ImageF pixels_;
};

TEST_F(EnvironmentFiles, AllThreeFormatsLoad) {
  for (const char* name : {"x.hdr", "x.exr", "x.pfm"}) {
    EXPECT_TRUE(load(grey(8, 4), name).empty()) << name;
    EXPECT_EQ(pixels_, grey(8, 4));
    EXPECT_EQ((*loadEnvironment((folder_ / name).string()))->name, name);
  }
}

TEST_F(EnvironmentFiles, OneOfAnotherShapeIsStretchedAndSaidSo) {
  for (const glm::ivec2 size : {glm::ivec2(8, 5), {1, 1}, {5, 8}, {16, 1}, {1, 300}, {7, 7}, {4096, 1}}) {
    const Diagnostics d = load(grey(size.x, size.y));
    ASSERT_EQ(d.size(), 1u);
    EXPECT_THAT(d[0].what, HasSubstr(fmt::format("is {} x {} pixels, not twice as wide as high", size.x, size.y)));
    EXPECT_FALSE(d[0].hint.empty());
    EXPECT_LE(pixels_.width * pixels_.height, 16 * size.x * size.y);
    for (const float v : pixels_.data) EXPECT_NEAR(v, 0.5f, 1e-6);
  }
  EXPECT_TRUE(load(grey(2, 1)).empty());
  // The upper half stays above.
  ImageF halves = grey(6, 6);
  for (int i = 0; i < 18 * 3; ++i) halves.data[size_t(i)] = 2;
  load(halves);
  EXPECT_EQ(pixels_.height, 6);
  EXPECT_EQ(pixels_.at(11, 2)[0], 2);
  EXPECT_EQ(pixels_.at(0, 3)[0], 0.5f);
}

TEST_F(EnvironmentFiles, BadPixelsAreMendedWithTheirPlaceAndNumber) {
  const float inf = std::numeric_limits<float>::infinity();
  const struct {
    float value, becomes;
    const char* word;
  } cases[] = {{std::nanf(""), 0, "NaN"}, {inf, 65504, "infinite"}, {-2.5f, 0, "negative"}, {-inf, 0, "negative"}, {3e30f, kBrightestPixel, "brighter"}};
  for (const auto& one : cases) {
    ImageF image = grey(8, 4);
    image.at(5, 2)[1] = one.value;
    Diagnostics d = load(image);
    ASSERT_EQ(d.size(), 1u);
    EXPECT_THAT(d[0].what, testing::AllOf(HasSubstr("pixel (5, 2)"), HasSubstr(one.word)));
    EXPECT_EQ(pixels_.at(5, 2)[1], one.becomes);
    EXPECT_EQ(pixels_.at(5, 2)[0], 0.5f) << "the other channels stay";
    image.at(6, 3)[0] = image.at(6, 3)[2] = one.value;
    d = load(image);
    ASSERT_EQ(d.size(), 1u);
    EXPECT_THAT(d[0].what, testing::AllOf(HasSubstr("2 pixels"), HasSubstr("(5, 2)")));
  }
  // An infinite sun is no darker than what is beside it.
  ImageF image = grey(8, 4);
  image.at(0, 0)[0] = 1e6f;
  image.at(1, 0)[0] = inf;
  load(image);
  EXPECT_EQ(pixels_.at(1, 0)[0], 1e6f);
}

TEST_F(EnvironmentFiles, EveryFaultAtOnce) {
  ImageF image = grey(8, 5);
  image.at(0, 0)[0] = -1;
  image.at(1, 0)[0] = std::nanf("");
  EXPECT_EQ(load(image).size(), 3u);
}

// Nothing of it is held that is not used: on disk it is small, and 1.6 GB as floats.
TEST_F(EnvironmentFiles, OneOf16kIsReadSmallerAndSaidSo) {
  const int width = 16384, height = 8192;
  std::string bytes = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", height, width);
  const auto row = [&](int mantissa) {
    std::string coded{2, 2, char(width >> 8), char(width & 255)};
    for (const int value : {mantissa, mantissa, mantissa, 129})
      for (int left = width; left > 0; left -= 127) coded += {char(128 + std::min(left, 127)), char(value)};
    return coded;
  };
  const std::string dark = row(64), light = row(192);
  for (int y = 0; y < height; ++y) bytes += y % 2 ? dark : light;
  write("large.hdr", bytes);
  const Diagnostics d = load("large.hdr");
  ASSERT_EQ(d.size(), 1u);
  EXPECT_THAT(d[0].what, HasSubstr("is 16384 x 8192 pixels and read as 8192 x 4096"));
  EXPECT_EQ(pixels_.width, kLargestEnvironmentWidth);
  EXPECT_EQ(pixels_.at(0, 0)[0], 1) << "the mean of 1.5 and 0.5";
  EXPECT_EQ(pixels_.at(8191, 4095)[2], 1);
}

TEST_F(EnvironmentFiles, AveragingKeepsTheLightAndTheShape) {
  for (const char* name : {"x.hdr", "x.pfm"})
    for (const int width : {64, 70, 90}) {
      ImageF image = grey(width, width / 2);
      image.at(width - 1, 0)[0] = 128;
      ASSERT_TRUE(writeImageF(folder_ / name, image).empty());
      const auto file = readEnvironmentFile(folder_ / name, 16);
      ASSERT_TRUE(file.ok());
      EXPECT_TRUE(file->warnings.empty());
      EXPECT_EQ(file->inFile.width, width);
      EXPECT_LE(file->pixels.width, 16);
      EXPECT_GT(file->pixels.width, 10);
      EXPECT_EQ(file->pixels.width, 2 * file->pixels.height);
      EXPECT_GT(file->pixels.at(file->pixels.width - 1, 0)[0], 2);
      EXPECT_NEAR(file->pixels.at(3, 3)[0], 0.5f, 1e-6);
    }
}

TEST_F(EnvironmentFiles, WhatIsNoPictureIsRefusedWithTheReason) {
  const ImageF image = grey(64, 32);
  for (const char* name : {"x.hdr", "x.exr", "x.pfm"}) {
    ASSERT_TRUE(writeImageF(folder_ / name, image).empty());
    const std::string whole = *readFile(folder_ / name);
    for (const size_t kept : {size_t(12), whole.size() / 2, whole.size() - 1}) {
      write(name, whole.substr(0, kept));
      const Diagnostics d = load(name);
      ASSERT_FALSE(d.empty()) << name << " " << kept;
      EXPECT_EQ(d[0].severity, Severity::Error);
      EXPECT_FALSE(d[0].hint.empty());
    }
  }
  const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
  const std::pair<std::string, const char*> cases[] = {
      {"", "is empty"}, {"GIF89a and more", "is not a .hdr, .exr or .pfm"}, {head + "-Y 99999999 +X 199999998\n", "pixels"},
      {head + "-Y 0 +X 0\n", "not a size"}, {head + "-Y -5 +X 10\n", "not a size"}, {"PF\n40000 20000\n-1\n", "pixels"},
      {"PF\n8 4\n-1\n", "truncated"}};
  for (const auto& [bytes, word] : cases) {
    write("x.hdr", bytes);
    const Diagnostics d = load("x.hdr");
    ASSERT_FALSE(d.empty()) << bytes;
    EXPECT_EQ(d[0].severity, Severity::Error);
    EXPECT_THAT(d[0].what, HasSubstr(word));
    EXPECT_FALSE(d[0].hint.empty());
  }
}

TEST_F(EnvironmentFiles, UnknownNamesGetAHint) {
  EXPECT_THAT(loadEnvironment("studoi").diagnostics()[0].hint, HasSubstr("'studio'"));
  EXPECT_THAT(loadEnvironment("/nowhere/x.hdr").diagnostics()[0].place, HasSubstr("/nowhere/x.hdr"));
  EXPECT_FALSE(loadEnvironment(folder_.path().string()).ok());
}

}  // namespace
}  // namespace glint
