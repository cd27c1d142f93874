// Shading models in the editor: their badges, mixes of terms, plugins made of them, and the white furnace.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "materials/base/files.h"
#include "renderer/image_io.h"
#include "tests/editor/editor_fixture.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing_support::EditorTest;

TEST_F(EditorTest, AMixIsChosenByItsTerms) {
  beginComparison("ggx");
  ASSERT_EQ(document().material().model, "ggx");
  ui().click("Properties/Model");
  ui().click("Properties/Model:Mix of terms\u2026");
  const std::string first = "GGX*SmithGGXCorrelatedApprox*Schlick";
  EXPECT_EQ(document().material().model, first) << "it begins as what it was";
  ui().click("Properties/Distribution");
  ui().click("Properties/Distribution:GTR");
  ui().click("Properties/Diffuse");
  ui().click("Properties/Diffuse:Burley");
  const std::string mix = "GTR*SmithGGXCorrelatedApprox*Schlick*Burley";
  ASSERT_EQ(document().material().model, mix);
  ASSERT_TRUE(ui().settle());
  EXPECT_TRUE(ui().editor().problems().empty()) << ui().editor().problems()[0].text();
  ASSERT_EQ(ui().editor().shown().ownRow, 1);
  EXPECT_EQ(ui().editor().shown().states[1].kind, PreviewScene::State::Drawn);

  // What its terms can be told is a slider, and goes along into a row of its own.
  ASSERT_TRUE(ui().has("Properties/Gamma"));
  document().edit("Set gamma", [](GraphEditor& graph) { return graph.setModelParameter("gamma", Value::scalar(3)); });
  ui().frames(2);
  EXPECT_TRUE(writeImage8(folder() / "mix.png", ui().screenshot()).empty());
  ui().click("Properties/Add as row");
  ASSERT_EQ(document().preview().models.size(), 2u);
  EXPECT_EQ(document().preview().models[1], mix + ":gamma=3");
  ASSERT_TRUE(ui().settle());
  EXPECT_EQ(ui().editor().shown().rowTitles.size(), 3u);
  EXPECT_TRUE(ui().editor().problems().empty()) << ui().editor().problems()[0].text();

  ASSERT_EQ(document().steps().size(), 5u);
  for (int i = 0; i < 5; ++i) ui().key(Key::Z, kControl);
  EXPECT_EQ(document().material().model, "ggx");
  EXPECT_THAT(document().preview().models, ElementsAre("ggx"));
}

TEST_F(EditorTest, ARowIsChangedInPlace) {
  beginComparison("ggx");
  showModels();
  ui().click("Models/Add a mix of terms");
  const std::string first = "GGX*SmithGGXCorrelated*Schlick", second = "GGX*SmithGGXCorrelated*None";
  EXPECT_THAT(document().preview().models, ElementsAre("ggx", first));
  ui().click("Models/Fresnel");
  ui().click("Models/Fresnel:None");
  EXPECT_THAT(document().preview().models, ElementsAre("ggx", second));
  ui().key(Key::Z, kControl);
  EXPECT_THAT(document().preview().models, ElementsAre("ggx", first));
  ui().click("Models/" + first);
  EXPECT_THAT(document().preview().models, ElementsAre("ggx"));

  // One model twice, with other values; one drag is one step.
  ui().click("Models/row burley");
  ui().click("Models/Add with other values");
  EXPECT_THAT(document().preview().models, ElementsAre("ggx", "burley:gamma=1.5"));
  const size_t steps = document().steps().size();
  const ui::Rect slider = ui().rect("Models/Tail (gamma)");
  ui().drag(slider.center(), {slider.high.x + 40, slider.center().y});
  EXPECT_THAT(document().preview().models, ElementsAre("ggx", "burley:gamma=4"));
  EXPECT_EQ(document().steps().size(), steps + 1);
  ASSERT_TRUE(ui().settle());
  EXPECT_EQ(ui().editor().shown().rows[1].note, "gamma 4");
  EXPECT_TRUE(ui().editor().problems().empty()) << ui().editor().problems()[0].text();
  begin();
}

TEST_F(EditorTest, AMixIsSavedAsAPlugin) {
  beginComparison("ggx");
  const fs::path file = ui().editor().models().folders().back() / "my-mix.glsl";
  fs::remove(file);
  document().edit("Model", [](GraphEditor& graph) { return graph.setModel("Beckmann*Neumann*Schlick"); });
  ui().frames(3);
  const auto typeId = [&](const std::string& id) {
    ui().click("Dialog/plugin id");
    ui().key(Key::A, kControl);
    ui().type(id);
  };
  ui().click("Properties/Save as plugin\u2026");
  ASSERT_TRUE(ui().has("Dialog/plugin id"));
  EXPECT_FALSE(ui().has("Dialog/plugin refused")) << "what is suggested is free";
  for (const char* refused : {"ggx", "no/id", ".hidden"}) {
    typeId(refused);
    EXPECT_TRUE(ui().has("Dialog/plugin refused")) << refused;
    ui().key(Key::Enter);
    EXPECT_TRUE(ui().has("Dialog/plugin id")) << refused;
  }
  typeId("my-mix");
  EXPECT_TRUE(writeImage8(folder() / "save-plugin.png", ui().screenshot()).empty());
  EXPECT_FALSE(ui().has("Dialog/plugin refused"));
  ui().key(Key::Enter);
  ui().frames(2);
  EXPECT_FALSE(ui().has("Dialog/plugin id"));
  ASSERT_TRUE(fs::exists(file));
  EXPECT_LT(readFile(file)->size(), 1000u);
  ASSERT_TRUE(ui().editor().models().find("my-mix"));
  EXPECT_EQ(document().material().model, "my-mix") << "it stands where the mix did";
  ASSERT_TRUE(ui().settle());
  EXPECT_TRUE(ui().editor().problems().empty()) << ui().editor().problems()[0].text();
  ui().key(Key::Z, kControl);
  EXPECT_EQ(document().material().model, "Beckmann*Neumann*Schlick");
  EXPECT_EQ(pluginRefusal("my-mix", file.parent_path(), ui().editor().models()).rfind("Taken by", 0), 0u);
  fs::remove(file);
  begin();
}

// A plugin's verdict follows its file.
TEST_F(EditorTest, ABadgeFollowsTheFile) {
  beginComparison("badge-test");
  showModels();
  const fs::path file = folder() / "config" / "models" / "badge-test.glsl";
  fs::create_directories(file.parent_path());
  const auto write = [&](const char* body) {
    std::ofstream(file) << "/*glint { \"id\": \"badge-test\", \"title\": \"Badge test\", \"terms\": {\"D\": \"GGX\", \"F\": \"Schlick\"},\n"
                           "\"claims\": {\"energyConserving\": true} } */\n" << body;
  };
  write("float V(Shading s, Parameters p) { return 1.0; }\n");
  ASSERT_TRUE(until([&] { return ui().has("Models/health:badge-test:red"); }));
  ui().move(ui().at("Models/health:badge-test"));
  ui().frames(3);
  EXPECT_TRUE(writeImage8(folder() / "badge.png", ui().screenshot()).empty());
  ui().click("Models/health:badge-test");
  ui().frames(2);
  EXPECT_TRUE(ui().has("Models/health:badge-test:card"));
  ui().key(Key::Escape);
  write("float V(Shading s, Parameters p) { return V_SmithGGX(s); }\n");
  EXPECT_TRUE(until([&] { return ui().has("Models/health:badge-test:green"); }));
  // In the viewport the row's label has it too, and a menu.
  ASSERT_TRUE(ui().settle());
  ui().click("Viewport/row:Badge test");
  ui().frames(2);
  ASSERT_TRUE(ui().has("Viewport/Use for this material"));
  ui().click("Viewport/Use for this material");
  EXPECT_EQ(document().material().model, "badge-test");
  fs::remove(file);
  begin();
}

TEST_F(EditorTest, TheWhiteFurnaceShowsItsNumbers) {
  beginComparison("burley");
  Preview preview = document().preview();
  preview.view = kFurnaceView;
  document().setPreview("View", preview);
  ASSERT_TRUE(ui().settle());
  const auto& shares = ui().editor().shown().furnace;
  ASSERT_EQ(shares.size(), 2u);
  for (const Renderer::FurnaceShare& share : shares) EXPECT_GT(share.pixels, 1000);
  EXPECT_GT(shares[0].most, 1.1) << "burley gains energy where it grazes";
  EXPECT_LT(shares[1].most, 1.01);
  EXPECT_TRUE(ui().has("Viewport/furnace:1"));
  EXPECT_TRUE(writeImage8(folder() / "furnace.png", ui().screenshot()).empty());
  begin();
}

TEST_F(EditorTest, TheErrorViewConvergesAndHasItsNumbers) {
  beginComparison("burley");
  Preview preview = document().preview();
  preview.view = kErrorView;
  preview.errorScale = 0.1f;
  document().setPreview("View", preview);
  ASSERT_TRUE(until([&] { return ui().editor().shown().reference >= 8 && ui().editor().shown().errors.size() == 2; }));
  const FrameResult early = ui().editor().shown();
  for (const ReferenceError& error : early.errors) EXPECT_GT(error.pixels, 1000);
  EXPECT_TRUE(ui().has("Viewport/error:1"));
  EXPECT_TRUE(ui().has("Viewport/reference"));
  EXPECT_TRUE(writeImage8(folder() / "error.png", ui().screenshot()).empty());
  // Its switch alone shows the truth.
  preview.view = "lit";
  preview.reference = true;
  document().setPreview("Reference", preview);
  ASSERT_TRUE(until([&] { return ui().editor().shown().errors.empty() && ui().editor().shown().reference >= 4; }));
  EXPECT_GT(ui().editor().shown().referenceInAll, 100);
  begin();
  ASSERT_TRUE(ui().settle());
  EXPECT_EQ(ui().editor().shown().referenceInAll, 0);
}

}  // namespace
}  // namespace glint
