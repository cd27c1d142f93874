// What the editor keeps between its runs, and what comes from the folders it watches.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "materials/base/files.h"
#include "materials/material_json.h"
#include "materials/material_library.h"
#include "renderer/environment.h"
#include "renderer/image_io.h"
#include "tests/editor/editor_fixture.h"
#include "tests/support/gltf_builder.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using testing_support::EditorTest;

TEST_F(EditorTest, OffersWhatACrashLeftAtAnyStart) {
  begin();
  const fs::path config = folder() / "config";
  for (const char* name : {"first", "second"}) {
    Document crashed(ui().editor().nodes(), config);
    crashed.startNew(newMaterial(name), {});
    crashed.edit("Add", [](GraphEditor& graph) { return graph.addNode("constant", {10, 20}); });
  }
  driver_.reset();
  driver_ = std::make_unique<UiDriver>(*context_, EditorOptions{.configFolder = config}, glm::ivec2(1280, 1100));
  ui().frames(3);
  ASSERT_TRUE(ui().has("Dialog/Recover 1"));
  EXPECT_TRUE(writeImage8(folder() / "recover.png", ui().screenshot()).empty());
  ui().click("Dialog/Later");
  EXPECT_FALSE(ui().has("Dialog/Later"));
  ui().click("Menu/File");
  ui().click("Menu/Recover unsaved work\u2026");
  ui().frames(3);
  ui().click("Dialog/Discard 0");
  ui().frames(2);
  EXPECT_FALSE(ui().has("Dialog/Recover 1"));
  ui().click("Dialog/Recover 0");
  ui().frames(2);
  EXPECT_FALSE(ui().has("Dialog/Later"));
  EXPECT_EQ(document().material().nodes.size(), 2u);
  EXPECT_TRUE(document().modified());
  Diagnostics warnings;
  EXPECT_TRUE(Journal::found(config / "journal", warnings).empty()) << "decided, or ours";
  begin();
}

TEST_F(EditorTest, AModelDroppedInDrawsAndABrokenOneIsAProblem) {
  begin();
  const fs::path models = folder() / "config" / "models";
  fs::create_directories(models);
  std::ofstream(models / "flat-test.glsl") << "/*glint\n{ \"id\": \"flat-test\", \"title\": \"Flat test\", \"doc\": \"Constant.\", "
                                              "\"color\": [1, 0, 0], \"parameters\": [], \"claims\": {\"reciprocal\": true} }\n*/\n"
                                              "vec3 specular(Shading s, Parameters p) { return vec3(0.1); }\n";
  ASSERT_TRUE(until([&] { return ui().editor().models().find("flat-test") != nullptr; }));
  document().edit("Model", [](GraphEditor& graph) { return graph.setModel("flat-test"); });
  ASSERT_TRUE(ui().settle());
  EXPECT_TRUE(ui().editor().problems().empty()) << ui().editor().problems()[0].text();

  // One that is not drawn is looked at all the same.
  std::ofstream(models / "broken-test.glsl") << "/*glint { \"id\": \"broken-test\" } */\n\n"
                                                "vec3 specular(Shading s, Parameters p) { return s.nope; }\n";
  EXPECT_TRUE(until([&] { return !ui().editor().problems().empty(); }));
  ASSERT_EQ(ui().editor().problems().size(), 1u);
  EXPECT_EQ(ui().editor().problems()[0].place, (models / "broken-test.glsl").string() + ":3");
  fs::remove(models / "flat-test.glsl");
  fs::remove(models / "broken-test.glsl");
}

TEST_F(EditorTest, ScreenshotShowsTheEditor) {
  begin();
  ASSERT_TRUE(ui().settle());
  EXPECT_GE(ui().editor().shown().samples, 2) << "a still picture is refined";
  const Image8 picture = ui().screenshot();
  EXPECT_TRUE(writeImage8(folder() / "editor.png", picture).empty());
  // The sphere in the middle of the viewport is lit, and the panels have text.
  const ui::Rect view = ui().rect("Viewport/view");
  const uint8_t* middle = picture.at(int(view.center().x), int(view.center().y));
  EXPECT_GT(middle[0] + middle[1] + middle[2], 60);
  int bright = 0;
  const ui::Rect scene = ui().rect("Scene/Rotation");
  for (int y = int(scene.low.y) - 200; y < int(scene.high.y); ++y)
    for (int x = int(scene.low.x) - 100; x < int(scene.high.x); ++x) bright += picture.at(x, std::max(0, y))[1] > 180;
  EXPECT_GT(bright, 200);
  EXPECT_EQ(ui().screenshot(), picture) << "nothing changed, so nothing moves";
}

// A view that has been turned comes to rest as the average that it would be anyway; without antialiasing it is one picture.
TEST_F(EditorTest, ATurnedViewComesToRestSmooth) {
  begin();
  ASSERT_TRUE(ui().settle());
  const ImVec2 view = ui().at("Viewport/view");
  ui().drag(view, {view.x + 80, view.y});
  ui().move({4, 4});
  ASSERT_TRUE(ui().settle());
  const int samples = ui().editor().shown().samples;
  EXPECT_GE(samples, 8);
  const Image8 smooth = ui().screenshot();
  const auto choose = [&](bool on) {
    Preview preview = document().preview();
    preview.antialiasing = on;
    document().setPreview("Antialiasing", preview);
    ui().frames(2);
    EXPECT_TRUE(ui().settle());
  };
  choose(false);
  EXPECT_EQ(ui().editor().shown().samples, 1);
  choose(true);
  EXPECT_EQ(ui().editor().shown().samples, samples);
  const ui::Rect drawn = ui().rect("Viewport/view");
  const Image8 again = ui().screenshot();
  int different = 0;
  for (int y = int(drawn.low.y) + 40; y < int(drawn.high.y) - 4; ++y)
    for (int x = int(drawn.low.x) + 4; x < int(drawn.high.x) - 4; ++x) different += !std::equal(smooth.at(x, y), smooth.at(x, y) + 3, again.at(x, y));
  EXPECT_EQ(different, 0) << "nothing is left of how it came there";
}

TEST_F(EditorTest, TheLayoutIsDraggedAndRemembered) {
  begin();
  const ui::Rect bar = ui().rect("splitter0"), before = ui().rect("Viewport/view");
  ui().drag(bar.center(), {bar.center().x - 120, bar.center().y});
  const ui::Rect after = ui().rect("Viewport/view");
  EXPECT_NEAR(before.high.x - after.high.x, 120, 4);
  const Json kept = ui().editor().layout().toJson();
  // It is in the file when the drag has ended, whatever ends the program.
  EXPECT_EQ(writeJson(Session::read(folder() / "config" / "editor.json").layout), writeJson(kept));
  Layout other;
  other.fromJson(kept, {"Viewport", "Graph", "Properties", "Scene"});
  EXPECT_TRUE(other.shown("Viewport"));
  EXPECT_FALSE(other.shown("History")) << "panels that are not known are dropped";
  ui().click("tab:History");
  EXPECT_TRUE(ui().editor().layout().visible("History"));
  EXPECT_TRUE(ui().has("History/start"));
}

TEST_F(EditorTest, EnvironmentsAreChosenByTheirPictures) {
  begin();
  const fs::path files = folder() / "environments";
  fs::create_directories(files);
  ImageF dusk(512, 256, 3);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) {
      float* p = dusk.at(x, y);
      const float up = 1 - float(y) / 128;
      p[0] = y < 128 ? 0.002f * (1.2f - up) : 0.0004f;
      p[1] = y < 128 ? 0.0012f : 0.0003f;
      p[2] = y < 128 ? 0.001f + 0.001f * up : 0.0003f;
    }
  dusk.at(100, 110)[0] = 1e6f;
  ASSERT_TRUE(writeImageF(files / "dusk.hdr", dusk).empty());
  ASSERT_TRUE(writeImageF(files / "a-name-that-is-too-long-for-its-place.exr", skyPixels(256)).empty());
  ASSERT_TRUE(writeImageF(files / "square.pfm", ImageF(64, 64, 3)).empty());
  std::ofstream(files / "broken.hdr") << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n";
  std::ofstream(files / "notes.txt") << "none of them";
  ui().editor().openFile(files / "dusk.hdr");
  ui().frames(3);

  const size_t steps = document().steps().size();
  EnvironmentThumbnails& thumbnails = ui().editor().environmentThumbnails();
  ui().click("Scene/Map");
  ui().frames(2);
  EXPECT_TRUE(ui().has("Scene/environment:sky")) << "before any picture is made";
  ASSERT_TRUE(until([&] { return thumbnails.settled() && thumbnails.names().size() == environmentNames().size() + 4; }));
  ui().frames(4);
  for (const char* name : {"studio", "sky", "furnace", "none", "dusk.hdr", "broken.hdr"})
    EXPECT_TRUE(ui().has("Scene/environment:" + std::string(name))) << name;
  EXPECT_FALSE(ui().has("Scene/environment:notes.txt"));
  EXPECT_TRUE(ui().has("Scene/broken:broken.hdr"));
  EXPECT_FALSE(ui().has("Scene/broken:dusk.hdr"));
  const auto broken = thumbnails.find((files / "broken.hdr").string());
  ASSERT_TRUE(broken);
  EXPECT_NE(broken->fault.find("truncated"), std::string::npos) << broken->fault;
  EXPECT_NE(thumbnails.find((files / "square.pfm").string())->notes.find("64 x 64"), std::string::npos);
  // However dark the picture and bright its sun, it is seen.
  const auto seen = thumbnails.find((files / "dusk.hdr").string());
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->inFile.width, 512);
  double mean = 0;
  for (const uint8_t v : seen->picture.data) mean += double(v) / double(seen->picture.data.size());
  EXPECT_GT(mean, 70);
  EXPECT_LT(mean, 180);
  ui().move(ui().at("Scene/environment:broken.hdr"));
  ui().frames(4);
  EXPECT_TRUE(writeImage8(folder() / "environments-broken.png", ui().screenshot()).empty());
  ui().move(ui().at("Scene/environment:dusk.hdr"));
  ui().frames(4);
  EXPECT_TRUE(writeImage8(folder() / "environments.png", ui().screenshot()).empty());

  // One that cannot be read is not chosen; another is, as one step.
  ui().click("Scene/environment:broken.hdr");
  EXPECT_EQ(document().steps().size(), steps);
  ui().click("Scene/environment:sky");
  ui().frames(2);
  EXPECT_EQ(document().preview().environment, "sky");
  EXPECT_EQ(document().steps().size(), steps + 1);
  EXPECT_FALSE(ui().has("Scene/environment:sky")) << "the list is closed";
  ui().key(Key::Z, kControl);
  EXPECT_EQ(fs::path(document().preview().environment).filename(), "dusk.hdr");
  // Its folder is offered again, whatever is shown then.
  EXPECT_EQ(fs::path(ui().editor().session().environmentFolder).filename(), "environments");
  begin();
}

TEST(EnvironmentThumbnails, SayHowManyFilesTheyLeaveOut) {
  const fs::path files = fs::path(GLINT_TESTS_OUT) / "many-environments";
  fs::create_directories(files);
  for (size_t i = 0; i < EnvironmentThumbnails::kMostFiles + 7; ++i) std::ofstream(files / fmt::format("{:03}.hdr", i)) << "empty";
  EnvironmentThumbnails thumbnails([] {});
  thumbnails.open({files, files});
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (thumbnails.left() == 0 && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_EQ(thumbnails.left(), 7u) << "a folder that is named twice counts once";
  EXPECT_EQ(thumbnails.names().size(), environmentNames().size() + EnvironmentThumbnails::kMostFiles);
}

TEST(Journal, KeepsWhatACrashWouldTake) {
  const fs::path folder = fs::path(GLINT_TESTS_OUT) / "journal";
  fs::remove_all(folder);
  const NodeRegistry nodes;
  Diagnostics warnings;
  Material kept;
  {
    Document document(nodes, folder);
    document.edit("Add", [](GraphEditor& graph) { return graph.addNode("constant", {10, 20}); });
    document.edit("Add", [](GraphEditor& graph) { return graph.addNode("constant", {30, 20}); });
    kept = document.material();
    EXPECT_TRUE(Journal::found(folder / "journal", warnings).empty()) << "its writer lives";
  }
  const fs::path own = fs::directory_iterator(folder / "journal")->path();
  std::ofstream(own, std::ios::app) << "glint-journal-record 400\n{ torn";
  std::ofstream(folder / "journal" / "junk.journal") << "glint-journal-record 99999999999999999999\n{}";
  const auto found = Journal::found(folder / "journal", warnings);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].steps, 2);
  EXPECT_LT(std::chrono::system_clock::now() - found[0].time, std::chrono::minutes(5));
  EXPECT_EQ(warnings.size(), 1u) << "the one that is damaged throughout";
  EXPECT_EQ(Journal::found(folder / "journal", warnings).size(), 1u);
  EXPECT_EQ(warnings.size(), 1u) << "which is said once";
  Document document(nodes, {});
  EXPECT_TRUE(document.recover(found[0]).empty());
  EXPECT_EQ(document.material().nodes, kept.nodes);
  EXPECT_TRUE(document.modified());
}

// A material's file says nothing of lights; they are kept all the same, without a save and whatever ends the program.
TEST(Scene, OfAPlainMaterialIsKeptBesideTheSession) {
  const fs::path folder = fs::path(GLINT_TESTS_OUT) / "scenes";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const NodeRegistry nodes;
  Diagnostics warnings;
  const fs::path file = folder / "plain.json";
  Document first(nodes, folder / "state");
  first.startNew(newMaterial("plain"), {});
  Preview lit = first.preview();
  lit.lights.push_back({.kind = LightKind::Point, .position = {1, 2, 3}, .candela = 7});
  lit.models = {"burley"};
  first.setPreview("Light", lit);
  EXPECT_TRUE(first.modified()) << "it has no file yet to keep it by";
  ASSERT_TRUE(first.saveAs(file, false).empty());
  EXPECT_FALSE(first.modified());
  const std::string bytes = readFile(file).value();
  EXPECT_EQ(bytes.find("lights"), std::string::npos);
  lit.exposure = 2;
  first.setPreview("Exposure", lit);
  EXPECT_FALSE(first.modified());
  EXPECT_EQ(readFile(file).value(), bytes);

  // The first still runs: what it would do when it ends is not needed.
  Document second(nodes, folder / "state");
  ASSERT_TRUE(second.open(file, warnings).empty());
  EXPECT_TRUE(second.preview().sameSettings(lit));
  EXPECT_FALSE(second.modified());
  // Where the viewer stood is kept when the document is left.
  Orbit orbit = second.preview().comparisonOrbit;
  orbit.yaw = 77;
  second.setOrbit(orbit);
  second.startNew(newMaterial("other"), {});
  EXPECT_TRUE(second.preview().lights.empty());
  ASSERT_TRUE(second.open(file, warnings).empty());
  EXPECT_EQ(second.preview().lights.size(), 1u);
  EXPECT_EQ(second.preview().comparisonOrbit.yaw, 77);
  EXPECT_TRUE(second.problems().empty());

  const fs::path state = fs::directory_iterator(folder / "state" / "scenes")->path();
  for (const char* damage : {"", "{ \"material\": ", "[1, 2]", "{\"material\": 3, \"scene\": {}}", "\xff\xfe\0"}) {
    std::ofstream(state, std::ios::trunc) << damage;
    Document third(nodes, folder / "state");
    EXPECT_TRUE(third.open(file, warnings).empty()) << damage;
    EXPECT_EQ(third.problems().size(), 1u) << damage;
    EXPECT_TRUE(third.preview().lights.empty()) << damage;
    std::ofstream(state, std::ios::trunc) << damage;
  }
  EXPECT_TRUE(warnings.empty());
}

TEST(Preview, ReadsBackWhatItWroteAndForgivesDamage) {
  Preview preview;
  preview.columns = Preview::Columns::Sweep;
  preview.lights.push_back({.kind = LightKind::Point, .position = {1, 2, 3}, .candela = 7});
  preview.lights.push_back({.kind = LightKind::Directional, .angle = glm::radians(3.0f), .shadow = false});
  preview.lights.push_back({.kind = LightKind::Spot, .innerAngle = glm::radians(20.0f), .outerAngle = glm::radians(35.0f)});
  // Angles of files are in degrees (product.md 1).
  EXPECT_EQ(previewJson(preview).find("lights")->items[2].find("outerAngle")->number, 35);
  preview.shadows = Shadows::Maps;
  preview.materialOcclusion = preview.screenOcclusion = false;
  preview.ground = Ground::Shadow;
  preview.antialiasing = preview.specularAntialiasing = false;
  preview.tonemap = Tonemap::AgX;
  preview.exposure = -1.5f;
  Diagnostics warnings;
  const Preview back = previewFrom(*parseJson(writeJson(previewJson(preview)), "p"), "p", warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_TRUE(back.sameSettings(preview));
  const Preview damaged = previewFrom(*parseJson(R"({"exposure": "dark", "tonemap": "acess", "lights": 3})", "p"), "p", warnings);
  EXPECT_EQ(warnings.size(), 2u);
  EXPECT_EQ(damaged.exposure, 0);
}

}  // namespace
}  // namespace glint
