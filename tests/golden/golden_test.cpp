// Golden pictures: each case of cases/ is a command line, rendered through OSMesa and through EGL and compared with
// images/ by two thresholds, the largest and the mean difference in steps of 255. tests/golden/update makes them anew.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "renderer/image_difference.h"
#include "renderer/image_io.h"
#include "tests/support/program.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

// What a case may differ by without giving a reason: rounding of other processors and of half floats.
constexpr double kMax = 2, kMean = 0.02;

std::vector<std::string> caseNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(GLINT_TESTS_DIR) / "golden/cases")) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Golden : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(Golden, IsUnchanged) {
  const auto& [name, backend] = GetParam();
  std::ifstream in(fs::path(GLINT_TESTS_DIR) / "golden/cases" / (name + ".json"));
  const auto document = nlohmann::json::parse(in, nullptr, false);
  ASSERT_TRUE(document.is_object()) << name;
  const double most = document["max"], mean = document["mean"];
  if (most > kMax || mean > kMean) {
    EXPECT_FALSE(document.value("reason", "").empty()) << "a looser threshold needs its reason";
  }

  const fs::path folder = testing_support::scratch(), actual = folder / "actual.png";
  std::vector<std::string> arguments = document["arguments"];
  for (const std::string& more : {std::string("--backend"), backend, std::string("-o"), actual.string()}) arguments.push_back(more);
  const auto ran = testing_support::glint(arguments);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");

  const fs::path golden = fs::path(GLINT_TESTS_DIR) / "golden/images" / (name + ".png");
  const auto a = readImage8(golden), b = readImage8(actual);
  ASSERT_TRUE(a) << a.diagnostics()[0].text() << ": make it with tests/golden/update " << name;
  ASSERT_TRUE(b);
  ASSERT_EQ(b->width, a->width);
  ASSERT_EQ(b->height, a->height);
  ASSERT_EQ(b->channels, a->channels);
  Pixels<float> difference(a->width, a->height, 1);
  double largest = 0, sum = 0;
  for (size_t i = 0; i < a->data.size(); ++i) {
    const double d = std::abs(int(a->data[i]) - int(b->data[i]));
    largest = std::max(largest, d);
    sum += d;
    float& pixel = difference.data[i / size_t(a->channels)];
    pixel = std::max(pixel, float(d));
  }
  const double average = sum / double(a->data.size());
  if (largest <= most && average <= mean) return;
  fs::copy_file(golden, folder / "expected.png", fs::copy_options::overwrite_existing);
  EXPECT_TRUE(writeImage8(folder / "difference.png", heatMap(difference, float(largest))).empty());
  ADD_FAILURE() << name << " through " << backend << ": largest difference " << largest << " (allowed " << most << "), mean " << average << " (allowed "
                << mean << "); see actual.png, expected.png and difference.png in " << folder;
}

INSTANTIATE_TEST_SUITE_P(Pictures, Golden, testing::Combine(testing::ValuesIn(caseNames()), testing::Values("osmesa", "egl")), [](const auto& instance) {
  std::string name = std::get<0>(instance.param) + "_" + std::get<1>(instance.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// Every picture says what made it, and no golden is left without its case.
TEST(GoldenImages, EachHasACaseAndItsNotes) {
  for (const auto& entry : fs::directory_iterator(fs::path(GLINT_TESTS_DIR) / "golden/images")) {
    EXPECT_TRUE(fs::exists(fs::path(GLINT_TESTS_DIR) / "golden/cases" / (entry.path().stem().string() + ".json"))) << entry.path();
    const auto notes = readImageNotes(entry.path());
    ASSERT_TRUE(notes);
    EXPECT_TRUE(notes->count("Command") && notes->count("OpenGL renderer") && notes->count("Software")) << entry.path();
  }
}

}  // namespace
}  // namespace glint
