// Whatever is in the file of an environment, no pixel of the picture is NaN, infinite or negative.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "renderer/image_io.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using testing_support::filesIn;
using testing_support::glint;
using testing_support::scratch;

TEST(RenderEnvironments, NoInvalidPixelComesOfABadFile) {
  const float nan = std::nanf(""), infinite = std::numeric_limits<float>::infinity();
  const struct {
    const char* name;
    int width, height;
    std::vector<float> pixels;  // these over a grey picture
    size_t warnings;
  } cases[] = {{"all-faults.pfm", 32, 20, {nan, -1, infinite, -infinite, 1e35f, nan}, 5},
               {"all-nan.pfm", 2, 1, {nan, nan, nan, nan, nan, nan}, 1},
               {"infinite.exr", 16, 8, {infinite, infinite, infinite, nan, -3, 0}, 2},
               {"one.pfm", 1, 1, {}, 1},
               {"two.pfm", 2, 1, {}, 0},
               {"tall.pfm", 1, 64, {}, 1},
               {"sun.pfm", 64, 32, {1e6f, 1e6f, 1e6f}, 0},
               {"brightest.pfm", 64, 32, {1e12f, 1e12f, 1e12f}, 0},
               {"black.pfm", 2, 1, {0, 0, 0, 0, 0, 0}, 0}};
  for (const auto& one : cases) {
    ImageF image(one.width, one.height, 3);
    std::fill(image.data.begin(), image.data.end(), 0.5f);
    std::copy(one.pixels.begin(), one.pixels.end(), image.data.begin());
    ASSERT_TRUE(writeImageF(scratch() / one.name, image).empty());
    const auto ran = glint({"render", "--size", "24x24", "--samples", "1", "--set", "roughness=0.2", "--env", one.name, "--json", "-o", "out.exr"});
    ASSERT_EQ(ran.code, 0) << one.name << ran.err;
    EXPECT_EQ(ran.json().value("invalidPixels", -1), 0) << one.name;
    EXPECT_EQ(size_t(std::count(ran.err.begin(), ran.err.end(), '\n')), one.warnings) << ran.err;
    const auto picture = readImageF(scratch() / "out.exr");
    ASSERT_TRUE(picture);
    for (const float v : picture->data) ASSERT_TRUE(std::isfinite(v) && v >= 0) << one.name << " " << v;
  }
}

TEST(RenderEnvironments, WhatIsNoEnvironmentIsBadInput) {
  const std::pair<const char*, std::string> cases[] = {
      {"empty.hdr", ""}, {"magic.exr", "not an exr at all"}, {"cut.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n\2\2"},
      {"huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000000 +X 2000000000\n"}};
  for (const auto& [name, bytes] : cases) {
    std::ofstream(scratch() / name, std::ios::binary) << bytes;
    const auto ran = glint({"render", "--size", "24x24", "--env", name, "-o", "out.png"});
    EXPECT_BAD_INPUT(ran, name, "; ");
  }
  for (const std::string& name : filesIn(scratch())) EXPECT_NE(name, "out.png");
}

}  // namespace
}  // namespace glint
