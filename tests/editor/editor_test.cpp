// The editor as a person uses it: mouse and keys on the real interface, drawn off screen.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "materials/base/files.h"
#include "materials/material_json.h"
#include "materials/material_library.h"
#include "renderer/image_io.h"
#include "tests/editor/editor_fixture.h"
#include "tests/support/gltf_builder.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using testing_support::EditorTest;

TEST_F(EditorTest, AddsWiresUndoesSavesAndReopens) {
  begin();
  addNode("constant");
  const NodeId constant = only("constant");
  ASSERT_FALSE(constant.empty());
  EXPECT_EQ(document().steps().size(), 1u);
  EXPECT_TRUE(document().modified());
  EXPECT_NE(document().title().find('*'), std::string::npos);

  // The new node lies in the middle; it is dragged clear of the output before its wire is drawn.
  ui().key(Key::Home);
  const NodeId output = document().material().outputNode();
  const ImVec2 at = ui().at("Graph/node:" + constant);
  ui().drag(at, {at.x - 300, at.y + 30});
  ASSERT_EQ(document().steps().size(), 2u) << "one drag is one step";
  const std::string from = "Graph/out:" + constant + ".value", to = "Graph/in:" + output + ".roughness";
  ui().drag(ui().at(from), ui().at(to));
  const auto wired = [&] {
    const Node* node = document().material().node(output);
    const auto input = node->inputs.find("roughness");
    return input != node->inputs.end() && input->second.from && input->second.from->node == constant;
  };
  ASSERT_TRUE(wired());
  ui().key(Key::Z, kControl);
  EXPECT_FALSE(wired());
  ui().key(Key::Z, kControlShift);
  EXPECT_TRUE(wired());
  ui().key(Key::Z, kControl);
  ui().key(Key::Y, kControl);
  EXPECT_TRUE(wired());

  // Ctrl+S asks where the first time, and never again.
  ui().key(Key::S, kControl);
  ASSERT_TRUE(ui().editor().files().isOpen());
  ui().editor().files().setFolder(folder());
  ui().frames(2);
  ui().click("Dialog/Files/name");
  ui().key(Key::A, kControl);
  ui().type("trial.json");
  ui().key(Key::Enter);
  ui().frames(3);
  ASSERT_TRUE(fs::exists(folder() / "trial.json"));
  EXPECT_FALSE(document().modified());
  const Material saved = document().material();

  ui().drag(ui().at("Graph/node:" + constant), {at.x - 250, at.y + 90});
  EXPECT_TRUE(document().modified());
  ui().key(Key::S, kControl);
  EXPECT_FALSE(document().modified());
  EXPECT_FALSE(ui().editor().files().isOpen());

  document().startNew(newMaterial("other"), document().preview());
  ui().frames(2);
  ui().editor().openFile(folder() / "trial.json");
  ui().frames(3);
  EXPECT_TRUE(wired());
  EXPECT_EQ(document().material().nodes, saved.nodes);
}

TEST_F(EditorTest, RefusesACycleAndSaysWhy) {
  begin();
  addNode("add");
  const NodeId id = only("add");
  const ImVec2 at = ui().at("Graph/node:" + id);
  ui().drag(at, {at.x - 300, at.y});
  const auto& kinds = ui().editor().nodes();
  const NodeKind* kind = kinds.find("add");
  ASSERT_TRUE(kind);
  const size_t steps = document().steps().size();
  // The reason shows while the wire hangs over the pin, and nothing is done on release.
  ui().move(ui().at("Graph/out:" + id + "." + kind->outputs[0].name));
  ui().press();
  ui().move(ui().at("Graph/in:" + id + "." + kind->inputs[0].name));
  EXPECT_TRUE(ui().has("Graph/reject-reason"));
  ui().release();
  EXPECT_EQ(document().steps().size(), steps);
}

TEST_F(EditorTest, ASliderDragIsOneStepAndItsLabelResets) {
  begin();
  const NodeId output = document().material().outputNode();
  const ui::Rect slider = ui().rect("Properties/Roughness");
  const float y = slider.center().y;
  ui().drag({slider.low.x + 20, y}, {slider.high.x - 30, y});
  ASSERT_EQ(document().steps().size(), 1u);
  const auto value = [&] {
    const auto& inputs = document().material().node(output)->inputs;
    const auto found = inputs.find("roughness");
    return found == inputs.end() || !found->second.value ? -1.0f : found->second.value->v[0];
  };
  EXPECT_GT(value(), 0.6f);
  ui().key(Key::Z, kControl);
  EXPECT_EQ(value(), -1.0f);
  ui().key(Key::Z, kControlShift);
  EXPECT_GT(value(), 0.6f);
  ui().doubleClick(ui().at("Properties/Roughness:label"));
  EXPECT_EQ(value(), -1.0f);
  EXPECT_EQ(document().steps().size(), 2u);
}

TEST_F(EditorTest, TheSceneIsInTheSameHistory) {
  begin();
  const ui::Rect slider = ui().rect("Scene/Rotation");
  ui().drag(slider.center(), {slider.high.x - 10, slider.center().y});
  ASSERT_EQ(document().steps().size(), 1u);
  EXPECT_GT(document().preview().environmentRotation, 60);
  ui().click("Scene/Add light");
  ui().click("Scene/Add point");
  EXPECT_EQ(document().preview().lights.size(), 2u);
  addNode("constant");
  ASSERT_EQ(document().steps().size(), 3u);
  for (int i = 0; i < 3; ++i) ui().key(Key::Z, kControl);
  EXPECT_EQ(document().preview().environmentRotation, 0);
  EXPECT_EQ(document().preview().lights.size(), 1u);
  EXPECT_EQ(document().material().nodes.size(), 1u);
  document().goTo(3);
  EXPECT_EQ(document().preview().lights.size(), 2u);
  EXPECT_EQ(document().material().nodes.size(), 2u);
  // Looking around is no step.
  const ImVec2 view = ui().at("Viewport/view");
  ui().drag(view, {view.x + 80, view.y});
  EXPECT_EQ(document().steps().size(), 3u);
  EXPECT_NE(document().preview().orbit.yaw, Preview{}.orbit.yaw);
}

TEST_F(EditorTest, DeletesDuplicatesAndPastes) {
  begin();
  addNode("constant");
  const ImVec2 canvas = ui().at("Graph/canvas");
  ui().move({canvas.x, canvas.y + 60});
  ui().key(Key::D, kControl);
  EXPECT_EQ(document().material().nodes.size(), 3u);
  ui().key(Key::C, kControl);
  ui().key(Key::V, kControl);
  EXPECT_EQ(document().material().nodes.size(), 4u);
  ui().key(Key::Delete);
  EXPECT_EQ(document().material().nodes.size(), 3u);
  for (int i = 0; i < 4; ++i) ui().key(Key::Z, kControl);
  EXPECT_EQ(document().material().nodes.size(), 1u);
}

TEST_F(EditorTest, DroppedFilesAreUsedAndBadOnesSaidSo) {
  begin();
  ImageF sky(64, 32, 3);
  std::fill(sky.data.begin(), sky.data.end(), 0.5f);
  ASSERT_TRUE(writeImageF(folder() / "sky.hdr", sky).empty());
  ui().editor().openFile(folder() / "sky.hdr");
  EXPECT_NE(document().preview().environment.find("sky.hdr"), std::string::npos);
  Image8 dots(8, 8, 3);
  ASSERT_TRUE(writeImage8(folder() / "dots.png", dots).empty());
  ui().editor().openFile(folder() / "dots.png");
  EXPECT_FALSE(only("texture-sample").empty());

  std::ofstream(folder() / "broken.json") << "{ \"glint\": \"material\", ";
  const Material before = document().material();
  document().startNew(before, document().preview());
  ui().editor().openFile(folder() / "broken.json");
  ui().frames(2);
  EXPECT_TRUE(ui().has("message"));
  EXPECT_EQ(document().material(), before);
  ui().editor().openFile(folder() / "notes.txt");
  ui().frames(2);
  EXPECT_TRUE(ui().has("message"));

  // A mesh that is no glTF is a problem, and the window goes on.
  begin();
  std::ofstream(folder() / "broken.glb") << "not a glb";
  ui().editor().openFile(folder() / "broken.glb");
  ASSERT_TRUE(ui().settle());
  EXPECT_TRUE(std::any_of(ui().editor().problems().begin(), ui().editor().problems().end(),
                          [](const Diagnostic& d) { return d.place.find("broken.glb") != std::string::npos; }));
}

// Whoever opens a mesh first of all edits its first material, and sees it on the surfaces that wear it.
TEST_F(EditorTest, AMeshBringsItsMaterialAlong) {
  test::GltfBuilder builder;
  for (const char* name : {"Red", "Blue"})
    builder.push("materials", {{"name", name}, {"emissiveFactor", {name[0] == 'R' ? 1 : 0, 0, name[0] == 'B' ? 1 : 0}}});
  builder.showTriangle({{"material", 1}});
  builder.showTriangle({{"material", 0}});
  std::ofstream(folder() / "two.glb", std::ios::binary) << builder.glb();
  begin();
  ui().editor().openFile(folder() / "two.glb");
  ASSERT_TRUE(ui().settle());
  const NodeId output = document().material().outputNode();
  EXPECT_EQ(document().material().name, "red");
  EXPECT_EQ(document().preview().editedSlot, 0);
  EXPECT_TRUE(document().steps().empty());
  const Image8 before = ui().screenshot();
  EXPECT_TRUE(document().edit("Green", [&](GraphEditor& graph) { return graph.setValue({output, "baseColor"}, Value::color(0, 1, 0)); }).empty());
  EXPECT_TRUE(document().edit("Dark", [&](GraphEditor& graph) { return graph.disconnect({output, "emissive"}); }).empty());
  ASSERT_TRUE(ui().settle());
  EXPECT_NE(ui().screenshot(), before);

  // With work in hand a mesh is only shown.
  ui().editor().openFile(folder() / "two.glb");
  ASSERT_TRUE(ui().settle());
  EXPECT_EQ(document().preview().editedSlot, -1);
  EXPECT_GE(document().steps().size(), 2u);
}

TEST_F(EditorTest, AsksBeforeWorkIsLost) {
  begin();
  addNode("constant");
  ui().key(Key::N, kControl);
  ASSERT_TRUE(ui().has("Dialog/Cancel"));
  ui().click("Dialog/Cancel");
  EXPECT_EQ(document().material().nodes.size(), 2u);
  ui().editor().requestQuit();
  ui().frames(3);
  EXPECT_FALSE(ui().editor().quitting());
  ui().click("Dialog/Cancel");
  ui().key(Key::N, kControl);
  ui().click("Dialog/Don\u2019t save");
  EXPECT_EQ(document().material().nodes.size(), 1u);
  EXPECT_FALSE(document().modified());
}

TEST_F(EditorTest, AsksBeforeTheSceneOfAnUntitledMaterialIsLost) {
  begin();
  ui().click("Scene/Add light");
  ui().click("Scene/Add point");
  ui().editor().requestQuit();
  ui().frames(3);
  EXPECT_FALSE(ui().editor().quitting());
  ASSERT_TRUE(ui().has("Dialog/Cancel"));
  ui().click("Dialog/Cancel");
  ui().key(Key::Z, kControl);
  EXPECT_FALSE(document().modified());

  // That of a material that has a file is there again when the file is opened again.
  ASSERT_TRUE(document().saveAs(folder() / "lit.json", false).empty());
  ui().click("Scene/Add light");
  ui().click("Scene/Add point");
  EXPECT_EQ(document().preview().lights.size(), 2u);
  begin();
  ui().editor().openFile(folder() / "lit.json");
  ui().frames(3);
  EXPECT_EQ(document().preview().lights.size(), 2u);
  // But what is named beside it wins.
  begin();
  ImageF sky(16, 8, 3);
  ASSERT_TRUE(writeImageF(folder() / "named.hdr", sky).empty());
  ui().editor().openFiles({folder() / "named.hdr", folder() / "lit.json"});
  ui().frames(3);
  EXPECT_EQ(document().preview().lights.size(), 2u);
  EXPECT_NE(document().preview().environment.find("named.hdr"), std::string::npos);
}

// Whatever is compared, the material is seen as it is: its own model has a row, and picking another moves it.
TEST_F(EditorTest, TheMaterialsOwnModelIsAlwaysARow) {
  begin();
  Preview preview = document().preview();
  preview.subject = Preview::Subject::Comparison;
  preview.models = {"ggx"};
  preview.materials = {"aluminium", "black"};
  Material material = newMaterial("aluminium");
  material.model = "burley";
  document().startNew(material, preview);
  ASSERT_TRUE(ui().settle());
  const FrameResult& shown = ui().editor().shown();
  ASSERT_EQ(shown.rowTitles.size(), 2u);
  EXPECT_EQ(shown.ownRow, 1);
  EXPECT_TRUE(ui().has("Viewport/own row:" + ui().editor().models().find("burley")->title));
  EXPECT_EQ(shown.columnTitles, (std::vector<std::string>{"aluminium (edited)", "aluminium (library)", "black"}));
  for (const std::string& title : shown.columnTitles) EXPECT_TRUE(ui().has("Viewport/column:" + title));
  document().edit("Model", [](GraphEditor& graph) { return graph.setModel("ggx"); });
  ASSERT_TRUE(ui().settle());
  EXPECT_EQ(ui().editor().shown().rowTitles.size(), 1u);
  EXPECT_EQ(ui().editor().shown().ownRow, 0);

  // The wheel goes closer about the pointer, in every cell; on the way back nothing is cut.
  const ui::Rect view = ui().rect("Viewport/view");
  const glm::vec4 cell = ui().editor().shown().layout.grid.rectangle(0, 0);
  const Orbit whole = document().preview().comparisonOrbit;
  ui().wheel({view.low.x + cell.x + cell.z * 0.75f, view.high.y - cell.y - cell.w * 0.5f}, 3);
  const Orbit close = document().preview().comparisonOrbit;
  EXPECT_LT(close.fov, whole.fov);
  EXPECT_GT(close.target.x, 0.1f);
  EXPECT_NEAR(close.target.y, 0, 0.02);
  ui().wheel({view.low.x + cell.x + 4, view.high.y - cell.y - 4}, -8);
  EXPECT_NEAR(document().preview().comparisonOrbit.fov, whole.fov, 1e-3);
  EXPECT_NEAR(glm::length(document().preview().comparisonOrbit.target), 0, 1e-4);
  begin();
}

// What stands under a material's name is that material, or says that it is not.
TEST_F(EditorTest, AMaterialThatCannotBeDrawnSaysSo) {
  begin();
  Preview preview = document().preview();
  preview.subject = Preview::Subject::Comparison;
  preview.models = {"ggx", "gone-model"};
  preview.materials = {"black"};
  document().startNew(newMaterial("sound"), preview);
  ASSERT_TRUE(ui().settle());
  using State = PreviewScene::State;
  const auto states = [&] {
    std::vector<int> kinds;
    for (const State& state : ui().editor().shown().states) kinds.push_back(state.kind);
    return kinds;
  };
  EXPECT_EQ(states(), (std::vector<int>{State::Drawn, State::Drawn, State::NotDrawn, State::NotDrawn}));
  // A model that is gone keeps its place in the list, so that it can be left out.
  showModels();
  ASSERT_TRUE(ui().has("Models/gone-model"));
  ui().click("Models/gone-model");
  EXPECT_EQ(document().preview().models, std::vector<std::string>{"ggx"});

  std::ofstream(folder() / "cycle.json") << R"({"glint": "material", "version": 1, "name": "round", "nodes": {
    "a": {"kind": "add", "inputs": {"a": {"from": "b.result"}}}, "b": {"kind": "add", "inputs": {"a": {"from": "a.result"}}},
    "output": {"kind": "output", "inputs": {"roughness": {"from": "a.result"}}}}})";
  document().startNew(newMaterial("sound"), document().preview());  // nothing to be asked about
  ui().editor().openFile(folder() / "cycle.json");
  ASSERT_TRUE(ui().settle());
  ASSERT_EQ(document().material().name, "round");
  EXPECT_EQ(states(), (std::vector<int>{State::NotDrawn, State::Drawn}));
  EXPECT_FALSE(ui().editor().shown().states[0].why.empty());
  EXPECT_TRUE(ui().has("Viewport/not drawn:0"));
  EXPECT_FALSE(ui().has("Viewport/not drawn:1"));

  // The same material's last good picture stays, and is called so.
  document().startNew(newMaterial("sound"), document().preview());
  ASSERT_TRUE(ui().settle());
  document().edit("Model", [](GraphEditor& graph) {
    NodeId made;
    graph.addNode("texture-sample", {-300, 0}, &made);
    return graph.connect({made, "no-such-pin"}, {graph.material().outputNode(), "baseColor"});
  });
  ASSERT_TRUE(ui().settle());
  EXPECT_EQ(states(), (std::vector<int>{State::LastGood, State::Drawn}));
  EXPECT_TRUE(ui().has("Viewport/last good:0"));
  begin();
}

TEST_F(EditorTest, AMixOfTermsIsAModel) {
  fs::create_directories(folder() / "config" / "models");
  begin();
  Preview preview = document().preview();
  preview.subject = Preview::Subject::Comparison;
  preview.models = {"ggx"};
  preview.materials.clear();
  Material material = newMaterial("mixed");
  material.model = "Beckmann*SmithGGX*Schlick";
  document().startNew(material, preview);
  ASSERT_TRUE(ui().settle());
  EXPECT_TRUE(ui().editor().problems().empty()) << ui().editor().problems()[0].text();
  EXPECT_EQ(ui().editor().shown().ownRow, 1);
  EXPECT_EQ(ui().editor().shown().states[1].kind, PreviewScene::State::Drawn);
  begin();
}

// A picture dropped anywhere on the window becomes a node that is seen.
TEST_F(EditorTest, ADroppedPictureIsInView) {
  begin();
  auto material = loadMaterial("painted-metal", ui().editor().nodes());
  ASSERT_TRUE(material);
  document().startNew(*material, document().preview());
  ui().frames(4);
  ASSERT_TRUE(writeImage8(folder() / "seen.png", Image8(8, 8, 3)).empty());
  ui().editor().openFile(folder() / "seen.png");
  ui().frames(4);
  ASSERT_EQ(ui().editor().selection().size(), 1u);
  const ui::Rect canvas = ui().rect("Graph/canvas"), node = ui().rect("Graph/node:" + *ui().editor().selection().begin());
  EXPECT_GT(node.low.x, canvas.low.x);
  EXPECT_LT(node.high.x, canvas.high.x);
  EXPECT_GT(node.low.y, canvas.low.y);
  EXPECT_LT(node.high.y, canvas.high.y);
  begin();
}

TEST_F(EditorTest, NewNodesLieFreeAndOneDroppedOnAWireIsOneStep) {
  begin();
  for (int i = 0; i < 3; ++i) addNode("constant");
  const NodeId output = document().material().outputNode();
  std::vector<ui::Rect> heads;
  for (const auto& [id, node] : document().material().nodes) heads.push_back(ui().rect("Graph/node:" + id));
  for (size_t i = 0; i < heads.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      EXPECT_TRUE(heads[i].low.x > heads[j].high.x || heads[j].low.x > heads[i].high.x || heads[i].low.y > heads[j].high.y + 10 ||
                  heads[j].low.y > heads[i].high.y + 10);

  begin();
  addNode("constant");
  const NodeId constant = only("constant");
  ui().key(Key::Home);
  const ImVec2 at = ui().at("Graph/node:" + constant);
  ui().drag(at, {at.x - 330, at.y});
  ui().drag(ui().at("Graph/out:" + constant + ".value"), ui().at("Graph/in:" + output + ".roughness"));
  addNode("one minus");
  const NodeId inserted = only("one-minus");
  const size_t steps = document().steps().size();
  const ImVec2 a = ui().at("Graph/out:" + constant + ".value"), b = ui().at("Graph/in:" + output + ".roughness");
  ui().drag(ui().at("Graph/node:" + inserted), {(a.x + b.x) / 2, (a.y + b.y) / 2});
  const auto through = [&] {
    const auto& inputs = document().material().node(output)->inputs;
    const auto found = inputs.find("roughness");
    return found != inputs.end() && found->second.from && found->second.from->node == inserted;
  };
  EXPECT_TRUE(through());
  EXPECT_EQ(document().steps().size(), steps + 1);
  ui().key(Key::Z, kControl);
  EXPECT_FALSE(through());
}

TEST_F(EditorTest, AGraphOpensReadable) {
  begin();
  auto material = loadMaterial("painted-metal", ui().editor().nodes());
  ASSERT_TRUE(material);
  document().startNew(*material, document().preview());
  ui().frames(4);
  const ui::Rect canvas = ui().rect("Graph/canvas"), output = ui().rect("Graph/node:" + document().material().outputNode());
  EXPECT_GT(output.high.y - output.low.y, 18) << "the height of a title";
  EXPECT_GT(output.low.x, canvas.low.x);
  EXPECT_LT(output.high.x, canvas.high.x);
  EXPECT_GT(output.low.y, canvas.low.y);
  EXPECT_LT(output.high.y, canvas.high.y);
}

TEST_F(EditorTest, SavesByEnterAndClosesByEscape) {
  begin();
  addNode("constant");
  fs::remove(folder() / "typed.json");
  ui().editor().files().setFolder(folder());
  ui().key(Key::S, kControl);
  ASSERT_TRUE(ui().editor().files().isOpen());
  ui().key(Key::Escape);
  EXPECT_FALSE(ui().editor().files().isOpen());
  EXPECT_TRUE(document().modified());
  // The name has the keyboard, and what is suggested is typed over.
  ui().key(Key::S, kControl);
  ui().type("typed");
  ui().key(Key::Enter);
  EXPECT_FALSE(ui().editor().files().isOpen());
  ASSERT_TRUE(fs::exists(folder() / "typed.json"));
  EXPECT_FALSE(document().modified());
  // Over a file that is there, Enter is pressed twice.
  addNode("constant");
  ui().key(Key::S, kControlShift);
  ui().type("typed");
  ui().key(Key::Enter);
  EXPECT_TRUE(ui().editor().files().isOpen());
  EXPECT_TRUE(document().modified());
  ui().key(Key::Enter);
  EXPECT_FALSE(ui().editor().files().isOpen());
  EXPECT_FALSE(document().modified());

  ui().click("Menu/File");
  ASSERT_TRUE(ui().has("Menu/Quit"));
  ui().key(Key::Escape);
  EXPECT_FALSE(ui().has("Menu/Quit"));
  ui().click("Scene/Map");
  ui().key(Key::Escape);
  ui().click("Graph/Add node");  // which a list still open would have swallowed
  ASSERT_TRUE(ui().has("Graph/Add/search"));
  ui().key(Key::Escape);
  EXPECT_FALSE(ui().has("Graph/Add/search"));
}

// On a display of twice the pixels there is half the room: tabs without any go under a menu.
TEST_F(EditorTest, TabsWithoutRoomAreUnderAMenu) {
  begin();
  Preview preview = document().preview();
  preview.subject = Preview::Subject::Comparison;
  preview.models = {"ggx"};
  preview.materials = {"black"};
  document().startNew(newMaterial("trial"), preview);
  ui().editor().setScale(2);
  ui().frames(4);
  ASSERT_TRUE(ui().settle());
  EXPECT_TRUE(writeImage8(folder() / "scale2.png", ui().screenshot()).empty());
  const std::string more = "more tabs:History";
  EXPECT_FALSE(ui().has("tab:Problems"));
  ASSERT_TRUE(ui().has(more));
  ui().click(more);
  ui().click("tab:Problems");
  EXPECT_TRUE(ui().editor().layout().visible("Problems"));
  EXPECT_TRUE(ui().has("tab:Problems"));
  ui().editor().setScale(1);
  begin();
}

TEST(ColumnTitles, AreTold) {
  EXPECT_EQ(distinctTitles({{"a", "x"}, {"b", "y"}}), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(distinctTitles({{"a", "x"}, {"a", "y"}, {"a", "y"}}), (std::vector<std::string>{"a (x)", "a (y)", "a (y) 2"}));
}

}  // namespace
}  // namespace glint
