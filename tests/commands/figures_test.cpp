// glint figures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "renderer/image_io.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using testing::HasSubstr;
using testing_support::filesIn;
using testing_support::glint;
using testing_support::scratch;

TEST(FiguresCommand, EveryApproximationHasItsError) {
  const auto ran = glint({"figures", "3", "9", "12", "--cell", "32", "--reference", "64", "-o", "figures", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_THAT(filesIn(scratch() / "figures"), testing::ElementsAre("figure-03-environment-brdf.png", "figure-09-falloff.png", "figure-12-sphere-light.png"));
  std::map<std::string, std::map<std::string, double>> mean, light;
  const auto document = ran.json();
  ASSERT_EQ(document.size(), 3u);
  for (const auto& figure : document) {
    ASSERT_TRUE(readImage8(scratch() / figure["file"].get<std::string>()));
    for (const auto& cell : figure["errors"]) {
      mean[cell["row"]][cell["column"]] = cell["mean"];
      light[cell["row"]][cell["column"]] = cell["light"];
    }
  }
  EXPECT_LT(mean["table"]["ggx"], 0.005);
  // The constant takes light away, most where a lamp is near; without it nothing is lost.
  EXPECT_LT(light["Equation 9"]["constant 1"], -0.5);
  EXPECT_LT(light["Equation 9"]["constant 1"], light["Equation 9"]["constant 0.1"]);
  EXPECT_LT(mean["Equation 9"]["0, radius 10"], 0.01);
  // What smooth metal shows of physics.md: the notes' factor sends back over twice the light, Glint's own method does not.
  EXPECT_GT(light["Representative point, factor 3"]["roughness 0.1"], 0.8);
  EXPECT_LT(std::abs(light["Transformed cosines"]["roughness 0.1"]), 0.1);
  for (const auto& [column, error] : mean["Transformed cosines"]) EXPECT_LT(error, mean["Representative point, factor 2"][column]) << column;
}

TEST(FiguresCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_BAD_INPUT(glint({"figures", "11", "-o", "figures"}), "figures", "there are 3, 4, 5, 9, 10, 12, 13");
  EXPECT_BAD_INPUT(glint({"figures", "--reference", "1", "-o", "figures"}), "--reference", "2 to 65536");
  EXPECT_BAD_INPUT(glint({"figures", "4", "--model", "nosuch", "-o", "figures"}), "--model", "unknown shading model");
}

}  // namespace
}  // namespace glint
