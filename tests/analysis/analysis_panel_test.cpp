// The Analysis panel as a person uses it: kinds, sliders, hovering, the legend, wheel and drag.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/editor/ui_driver.h"
#include "renderer/image_io.h"

namespace glint {
namespace {

class AnalysisPanelTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::Context::create({.backend = gl::Backend::OsMesa});
    ASSERT_TRUE(made) << made.diagnostics()[0].text();
    context_ = std::move(*made);
    driver_ = std::make_unique<UiDriver>(*context_, EditorOptions{}, glm::ivec2(1280, 1000));
    Preview preview;
    preview.subject = Preview::Subject::Mesh;
    preview.mesh = "sphere";
    preview.environment = "none";
    preview.models = {"ggx", "beckmann"};
    driver_->editor().document().startNew(newMaterial("trial"), preview);
    driver_->frames(4);
    driver_->click("tab:Analysis");
    ASSERT_TRUE(driver_->settle());
  }
  static void TearDownTestSuite() {
    driver_.reset();
    context_.reset();
  }
  static UiDriver& ui() { return *driver_; }

  static void choose(const std::string& property, const std::string& value) {
    ui().click("Analysis/" + property);
    ui().frames(2);
    ui().click("Analysis/" + property + ":" + value);
    ASSERT_TRUE(ui().settle());
  }
  static ImVec2 within(float u, float v) {
    const ui::Rect r = ui().rect("Analysis/plot");
    return {r.low.x + u * (r.high.x - r.low.x), r.low.y + v * (r.high.y - r.low.y)};
  }
  // What the table says of a model where the pointer is; NaN when it is not there.
  static double reading(const std::string& title) {
    ui().frames(2);
    const std::string start = "Analysis/reading:" + title + "=";
    for (const std::string& name : ui::names())
      if (name.starts_with(start)) return std::strtod(name.c_str() + start.size(), nullptr);
    return NAN;
  }

  static std::unique_ptr<gl::Context> context_;
  static std::unique_ptr<UiDriver> driver_;
};
std::unique_ptr<gl::Context> AnalysisPanelTest::context_;
std::unique_ptr<UiDriver> AnalysisPanelTest::driver_;

const char* const kGgx = "GGX (default lit)";

TEST_F(AnalysisPanelTest, HoveringReadsValuesThatFollowTheSliders) {
  choose("Plot", "F: Fresnel");
  ui().move(within(0.55f, 0.5f));
  const double f = reading(kGgx);
  EXPECT_GT(f, 0.04);
  EXPECT_LT(f, 0.2);
  EXPECT_DOUBLE_EQ(reading("Beckmann-Smith"), f) << "both have Schlick's";

  choose("Plot", "D: distribution");
  ui().move(within(0.62f, 0.5f));
  const double before = reading(kGgx);
  ASSERT_GT(before, 0);
  const ui::Rect slider = ui().rect("Analysis/Roughness");
  ui().click(ImVec2{slider.low.x + 0.9f * (slider.high.x - slider.low.x), slider.center().y});
  ASSERT_TRUE(ui().settle());
  ui().move(within(0.62f, 0.5f));
  EXPECT_GT(std::abs(reading(kGgx) - before), 0.01);
  ASSERT_TRUE(writeImage8(std::filesystem::path(GLINT_TESTS_OUT) / "analysis.png", ui().screenshot()).empty());
}

// The material's own model is plotted as the material has it.
TEST_F(AnalysisPanelTest, TheMaterialsModelHasItsParameters) {
  Document& document = ui().editor().document();
  Preview preview = document.preview();
  preview.models = {"burley", "ggx"};
  Material material = newMaterial("trial", "burley");
  material.modelParameters["gamma"] = Value::scalar(3);
  document.startNew(material, preview);
  ASSERT_TRUE(ui().settle());
  choose("Plot", "D: distribution");
  ui().move(within(0.51f, 0.5f));
  EXPECT_TRUE(std::isfinite(reading("Burley (GTR), Tail (gamma) 3")));
  ASSERT_TRUE(writeImage8(std::filesystem::path(GLINT_TESTS_OUT) / "analysis-own.png", ui().screenshot()).empty());
  preview.models = {"ggx", "beckmann"};
  document.startNew(newMaterial("trial"), preview);
  ASSERT_TRUE(ui().settle());
}

TEST_F(AnalysisPanelTest, AnEntryOfTheLegendHidesItsModel) {
  choose("Plot", "Lobe");
  ui().click(std::string("Analysis/legend:") + kGgx);
  ui().move(within(0.7f, 0.6f));
  EXPECT_TRUE(std::isnan(reading(kGgx)));
  EXPECT_FALSE(std::isnan(reading("Beckmann-Smith")));
  ui().click(std::string("Analysis/legend:") + kGgx);
  ui().move(within(0.7f, 0.6f));
  EXPECT_FALSE(std::isnan(reading(kGgx)));
}

TEST_F(AnalysisPanelTest, TheWheelEnlargesAndADoubleClickShowsAll) {
  choose("Plot", "V: visibility");
  ui().move(within(0.9f, 0.5f));
  const double whole = reading(kGgx);
  // Around a place left of there: what is under the pointer's place moves towards it.
  for (int i = 0; i < 4; ++i) ui().wheel(within(0.4f, 0.5f), 1);
  ui().move(within(0.9f, 0.5f));
  EXPECT_NE(reading(kGgx), whole);
  ui().doubleClick(within(0.5f, 0.5f));
  ui().move(within(0.9f, 0.5f));
  EXPECT_DOUBLE_EQ(reading(kGgx), whole);
}

TEST_F(AnalysisPanelTest, EveryKindIsDrawnAndNothingIsWhenNothingChanges) {
  for (const char* kind : {"G: masking", "Lobe, polar", "Albedo", "Slice"}) {
    choose("Plot", kind);
    ui().move(within(0.3f, 0.5f));
    ui().frames(2);
    ASSERT_TRUE(writeImage8(std::filesystem::path(GLINT_TESTS_OUT) / (std::string("analysis-") + kind + ".png"), ui().screenshot()).empty());
    const uint64_t serial = ui().editor().render().plot()->serial;
    ui().frames(5);
    EXPECT_TRUE(ui().editor().render().settled()) << kind;
    EXPECT_EQ(ui().editor().render().plot()->serial, serial) << kind;
  }
  EXPECT_FALSE(std::isnan(reading(kGgx))) << "of a slice";
}

}  // namespace
}  // namespace glint
