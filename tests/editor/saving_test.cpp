// Saving takes along what a material uses: after it the file renders by itself, anywhere, and the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "app/editor/ui_driver.h"
#include "materials/base/files.h"
#include "materials/material_json.h"
#include "renderer/image_io.h"
#include "tests/support/gltf_builder.h"
#include "tests/support/program.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing_support::filesIn;

// Of noise, so that a picture drawn with it tells how it is laid and filtered.
std::string png(unsigned seed, int side = 8) {
  Image8 image(side, side, 3);
  for (uint8_t& v : image.data) v = uint8_t((seed = seed * 1664525 + 1013904223) >> 24);
  const fs::path file = testing_support::scratch() / "made.png";
  EXPECT_TRUE(writeImage8(file, image).empty());
  const std::string bytes = readFile(file).value();
  fs::remove(file);
  return bytes;
}

void write(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string textured(const std::string& file, const std::string& more = "") {
  return R"({"glint": "material", "version": 1, "name": "m", "nodes": {"t": {"kind": "texture-sample", "file": ")" + file + R"("}, )" + more +
         R"("output": {"kind": "output", "inputs": {"baseColor": "t.color"}}}})";
}

std::string fileOf(const Material& material, const NodeId& id) { return settingText(*material.node(id), "file"); }

// Rendered by the program, in a process of its own that knows nothing of the editor.
Image8 rendered(const std::vector<std::string>& what) {
  std::vector<std::string> arguments = {"render", "--size", "64x64", "--samples", "1", "-o", "picture.png"};
  arguments.insert(arguments.begin() + 1, what.begin(), what.end());
  const auto ran = testing_support::glint(arguments);
  EXPECT_EQ(ran.code, 0) << ran.err;
  const auto picture = readImage8(testing_support::scratch() / "picture.png");
  fs::remove(testing_support::scratch() / "picture.png");
  return picture ? *picture : Image8();
}

class SavingTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const fs::path config = fs::path(GLINT_TESTS_OUT) / "saving-config";
    fs::remove_all(config);
    fs::create_directories(config / "models");
    auto made = gl::Context::create({.backend = gl::Backend::OsMesa});
    ASSERT_TRUE(made) << made.diagnostics()[0].text();
    context_ = std::move(*made);
    driver_ = std::make_unique<UiDriver>(*context_, EditorOptions{.configFolder = config}, glm::ivec2(960, 640));
  }
  static void TearDownTestSuite() {
    driver_.reset();
    context_.reset();
  }
  void SetUp() override {
    Preview preview;
    preview.subject = Preview::Subject::Mesh;
    preview.mesh = "sphere";
    preview.environment = "none";
    preview.lights.push_back({});
    document().startNew(newMaterial("trial"), preview);
    ui().editor().selection().clear();
    ui().editor().layout().reset();
    ui().frames(4);
  }

  UiDriver& ui() { return *driver_; }
  Document& document() { return driver_->editor().document(); }
  fs::path folder() { return testing_support::scratch(); }
  // By the keys that a person presses.
  void saveAs(const fs::path& file) {
    fs::create_directories(file.parent_path());
    ui().key(Key::S, kControlShift);
    ASSERT_TRUE(ui().editor().files().isOpen());
    ui().editor().files().setFolder(file.parent_path());
    ui().frames(2);
    ui().type(file.filename().string());
    ui().key(Key::Enter);
    if (ui().editor().files().isOpen()) ui().key(Key::Enter);  // over a file that is there
    ASSERT_FALSE(ui().editor().files().isOpen());
    ui().frames(2);
  }
  Image8 viewport() {
    EXPECT_TRUE(ui().settle());
    ui().move({950, 630});
    ui().frames(2);
    const Image8 whole = ui().screenshot();
    const ui::Rect view = ui().rect("Viewport/view");
    // Its middle: messages lie elsewhere.
    const int side = 100, left = int(view.center().x) - side / 2, top = int(view.center().y) - side / 2;
    Image8 part(side, side, whole.channels);
    for (int y = 0; y < side; ++y) std::copy_n(whole.at(left, top + y), side * whole.channels, part.at(0, y));
    return part;
  }
  void expectNoProblems() {
    EXPECT_TRUE(ui().settle());
    ui().frames(2);
    for (const Diagnostic& d : ui().editor().problems()) ADD_FAILURE() << d.text();
  }

  static std::unique_ptr<gl::Context> context_;
  static std::unique_ptr<UiDriver> driver_;
};
std::unique_ptr<gl::Context> SavingTest::context_;
std::unique_ptr<UiDriver> SavingTest::driver_;

// Two materials, one of them on a mirrored node; samplers and packing of their own; pictures named alike.
TEST_F(SavingTest, AModelsPicturesGoAlong) {
  const std::string color = png(1), packed = png(2);
  test::GltfBuilder builder;
  const int base = builder.texture(color), metal = builder.texture(packed), again = builder.texture(color);
  for (auto& image : builder.json["images"]) image["name"] = "../Skin one.png";
  builder.json["textures"][size_t(base)]["sampler"] =
      builder.push("samplers", {{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}});
  builder.push("materials", {{"name", "Skin"},
                             {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", base}}}, {"metallicRoughnessTexture", {{"index", metal}}}}},
                             {"emissiveFactor", {0.1, 0.1, 0.1}},
                             {"emissiveTexture", {{"index", again}}}});
  builder.push("materials", {{"name", "Blue"}, {"emissiveFactor", {0, 0, 1}}});
  builder.showTriangle({{"material", 0}});
  builder.showTriangle({{"material", 1}});
  builder.json["nodes"][1]["translation"] = {0, -1, 0};
  builder.showTriangle({{"material", 0}});
  builder.json["nodes"][2]["scale"] = {-1, 1, 1};
  write(folder() / "two.glb", builder.glb());

  ui().editor().openFile(folder() / "two.glb");
  ASSERT_TRUE(ui().settle());
  ASSERT_EQ(document().material().name, "skin");
  const NodeId output = document().material().outputNode();
  EXPECT_TRUE(document().edit("Specular", [&](GraphEditor& graph) { return graph.setValue({output, "specular"}, Value::scalar(0.4f)); }).empty());
  const Image8 before = viewport();
  saveAs(folder() / "out" / "skin.json");
  EXPECT_FALSE(document().modified());
  EXPECT_THAT(filesIn(folder() / "out"), ElementsAre("skin.json", "skin_textures"));
  EXPECT_THAT(filesIn(folder() / "out" / "skin_textures"), ElementsAre("Skin-one-2.png", "Skin-one.png"));
  const std::string text = readFile(folder() / "out" / "skin.json").value();
  EXPECT_THAT(text, Not(HasSubstr("gltf:")));
  const Material& saved = document().material();
  EXPECT_EQ(fileOf(saved, "base-color-texture"), "skin_textures/Skin-one.png");
  EXPECT_EQ(fileOf(saved, "emissive-texture"), "skin_textures/Skin-one.png") << "the same bytes";
  EXPECT_EQ(fileOf(saved, "metallic-roughness-texture"), "skin_textures/Skin-one-2.png");
  EXPECT_EQ(readFile(folder() / "out" / "skin_textures" / "Skin-one.png").value(), color);
  EXPECT_EQ(readFile(folder() / "out" / "skin_textures" / "Skin-one-2.png").value(), packed);
  const Node& sample = *saved.node("base-color-texture");
  EXPECT_EQ(settingText(sample, "wrap"), "clamp");
  EXPECT_EQ(settingText(sample, "wrapV"), "mirror");
  EXPECT_EQ(settingText(sample, "filter"), "nearest");
  EXPECT_EQ(settingText(*saved.node("metallic-roughness-texture"), "colorSpace"), "linear");
  expectNoProblems();
  EXPECT_EQ(viewport(), before);

  // The step before the save is undone on the saved pictures, and the next save writes nothing anew.
  ui().key(Key::Z, kControl);
  EXPECT_TRUE(document().modified());
  EXPECT_EQ(fileOf(document().material(), "base-color-texture"), "skin_textures/Skin-one.png");
  expectNoProblems();
  ui().key(Key::S, kControl);
  EXPECT_FALSE(document().modified());
  EXPECT_EQ(filesIn(folder() / "out" / "skin_textures").size(), 2u);
  ui().key(Key::Z, kControlShift);
  EXPECT_EQ(viewport(), before);
}

TEST_F(SavingTest, WhatIsSavedFromAModelRendersByItselfAndTheSame) {
  test::GltfBuilder builder;
  const int base = builder.texture(png(3)), normal = builder.texture(png(4));
  builder.push("materials", {{"name", "Only"},
                             {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", base}}}, {"metallicRoughnessTexture", {{"index", normal}}}}},
                             {"normalTexture", {{"index", normal}}}});
  builder.showTriangle({{"material", 0}});
  builder.showTriangle({{"material", 0}});
  builder.json["nodes"][1]["scale"] = {-1, 1, 1};
  write(folder() / "one.glb", builder.glb());
  ui().editor().openFile(folder() / "one.glb");
  ASSERT_TRUE(ui().settle());
  saveAs(folder() / "out" / "only.json");
  const Image8 model = rendered({"one.glb"});
  fs::rename(folder() / "out", folder() / "moved");  // it is whole
  EXPECT_EQ(rendered({"--mesh", "one.glb", "--material", "moved/only.json"}), model);
  fs::remove(folder() / "one.glb");
  EXPECT_FALSE(rendered({"moved/only.json"}).empty());
}

TEST_F(SavingTest, PicturesGoWhereverTheMaterialGoes) {
  write(folder() / "a" / "maps" / "skin.png", png(5));
  write(folder() / "a" / "maps" / "other.png", png(6));
  write(folder() / "elsewhere" / "skin.png", png(7));
  write(folder() / "a" / "parts" / "inner.png", png(8));
  write(folder() / "a" / "parts" / "paint.json",
        R"({"glint": "function", "version": 1, "name": "paint", "nodes": {"s": {"kind": "texture-sample", "file": "inner.png"},
            "o": {"kind": "function-output", "type": "color", "inputs": {"value": "s.color"}}}})");
  write(folder() / "a" / "m.json", textured("maps/skin.png", R"("u": {"kind": "texture-sample", "file": "maps/other.png"},
      "f": {"kind": "function", "function": "parts/paint.json"}, "mix": {"kind": "multiply", "inputs": {"a": "f.o", "b": "t.color"}}, )"));
  ui().editor().openFile(folder() / "a" / "m.json");
  ui().frames(3);
  expectNoProblems();
  const NodeId output = document().material().outputNode();
  EXPECT_TRUE(document().edit("Wire", [&](GraphEditor& graph) { return graph.connect({"mix", "value"}, {output, "baseColor"}); }).empty());
  ui().editor().openFile(folder() / "elsewhere" / "skin.png");  // dropped on the window
  const std::set<NodeId> dropped = ui().editor().selection();
  ASSERT_EQ(dropped.size(), 1u);
  EXPECT_TRUE(document().edit("Wire", [&](GraphEditor& graph) { return graph.connect({*dropped.begin(), "color"}, {output, "emissive"}); }).empty());
  EXPECT_TRUE(document().edit("Remove", [&](GraphEditor& graph) { return graph.removeNodes({"u"}); }).empty());
  expectNoProblems();
  const Image8 before = viewport();
  ui().key(Key::S, kControl);
  EXPECT_EQ(fileOf(document().material(), *dropped.begin()), "m_textures/skin.png");
  EXPECT_EQ(fileOf(document().material(), "t"), "maps/skin.png") << "it lies below the material";
  const Image8 here = rendered({"a/m.json"});

  // A different file of that name is there already, and an equal one.
  write(folder() / "b" / "n_textures" / "skin.png", "mine");
  write(folder() / "b" / "n_textures" / "skin-2.png", png(5));
  saveAs(folder() / "b" / "n.json");
  EXPECT_THAT(filesIn(folder() / "b"), ElementsAre("n.json", "n_functions", "n_textures"));
  EXPECT_THAT(filesIn(folder() / "b" / "n_textures"), ElementsAre("skin-2.png", "skin-3.png", "skin.png"));
  EXPECT_EQ(readFile(folder() / "b" / "n_textures" / "skin.png").value(), "mine");
  EXPECT_THAT(filesIn(folder() / "b" / "n_functions"), ElementsAre("paint.json", "paint_textures"));
  expectNoProblems();
  EXPECT_EQ(viewport(), before);
  EXPECT_EQ(rendered({"b/n.json"}), here);

  // Undo brings back a node whose picture stayed behind: it is drawn from there, and goes along with the next save.
  ui().key(Key::Z, kControl);
  ASSERT_TRUE(document().material().node("u"));
  expectNoProblems();
  saveAs(folder() / "c" / "n.json");
  EXPECT_EQ(fileOf(document().material(), "u"), "n_textures/other.png");
  fs::remove_all(folder() / "a");
  fs::remove_all(folder() / "b");
  EXPECT_EQ(rendered({"c/n.json"}), here);
  // As a project too.
  ASSERT_TRUE(document().saveAs(folder() / "d" / "p.json", true).size() == 1u) << "no such folder";
  fs::create_directory(folder() / "d");
  ASSERT_TRUE(document().saveAs(folder() / "d" / "p.json", true).empty());
  fs::remove_all(folder() / "c");
  EXPECT_TRUE(document().material().file == folder() / "d" / "p.json");
  ui().editor().openFile(folder() / "d" / "p.json");
  expectNoProblems();
  EXPECT_EQ(viewport(), before);
}

TEST_F(SavingTest, WhatCannotGoAlongStopsTheSave) {
  write(folder() / "a" / "here.png", png(9));
  write(folder() / "a" / "lost.png", png(10));
  write(folder() / "a" / "m.json", textured("here.png", R"("u": {"kind": "texture-sample", "file": "lost.png"}, )"));
  fs::create_directory(folder() / "b");
  ui().editor().openFile(folder() / "a" / "m.json");
  ui().frames(3);
  EXPECT_TRUE(document().edit("Name", [](GraphEditor& graph) { return graph.setName("new"); }).empty());
  fs::remove(folder() / "a" / "lost.png");
  saveAs(folder() / "b" / "n.json");
  EXPECT_TRUE(ui().has("message"));
  EXPECT_TRUE(document().modified());
  EXPECT_EQ(document().file(), folder() / "a" / "m.json");
  EXPECT_TRUE(filesIn(folder() / "b").empty());
  const auto said = [&] {
    const Diagnostics& all = ui().editor().problems();
    return std::count_if(all.begin(), all.end(), [](const Diagnostic& d) { return d.text().find("lost.png: no such file") != std::string::npos; });
  };
  ui().frames(2);
  EXPECT_EQ(said(), 1);
  // In its own folder nothing has to go anywhere: work is saved, lost picture or not.
  ui().key(Key::S, kControl);
  EXPECT_FALSE(document().modified());
  ui().frames(2);
  EXPECT_EQ(document().saveProblems().size(), 0u);
  // Nor is anything written where the folder of pictures cannot be.
  write(folder() / "a" / "lost.png", png(10));
  write(folder() / "b" / "n_textures", "a file");
  saveAs(folder() / "b" / "n.json");
  EXPECT_EQ(document().saveProblems().size(), 1u) << "one place, however many pictures";
  EXPECT_THAT(filesIn(folder() / "b"), ElementsAre("n_textures"));
  fs::remove(folder() / "b" / "n_textures");
  fs::create_directory_symlink(folder() / "a", folder() / "b" / "n_textures");
  saveAs(folder() / "b" / "n.json");
  EXPECT_EQ(document().saveProblems().size(), 1u) << "one place, however many pictures";
  EXPECT_THAT(filesIn(folder() / "a"), ElementsAre("here.png", "lost.png", "m.json"));
  fs::remove(folder() / "b" / "n_textures");
  saveAs(folder() / "b" / "n.json");
  EXPECT_TRUE(document().saveProblems().empty());
  EXPECT_THAT(filesIn(folder() / "b" / "n_textures"), ElementsAre("here.png", "lost.png"));
}

// A file names what it likes; that does not make it the user's wish.
TEST_F(SavingTest, AFileCannotHaveOthersCopied) {
  write(folder() / "secret.png", png(11));
  test::GltfBuilder builder;
  builder.texture(png(12));
  builder.showTriangle();
  write(folder() / "secret.glb", builder.glb());
  fs::create_directory(folder() / "b");
  for (const std::string& name : {(folder() / "secret.png").string(), std::string("../secret.png"), "gltf:" + (folder() / "secret.glb").string() + "#0"}) {
    write(folder() / "a" / "m.json", textured(name));
    ui().editor().openFile(folder() / "a" / "m.json");
    ui().frames(3);
    ASSERT_EQ(document().saveAs(folder() / "b" / "n.json", false).size(), 1u) << name;
    EXPECT_TRUE(filesIn(folder() / "b").empty());
    EXPECT_TRUE(document().save().empty()) << "as it was";
    EXPECT_EQ(fileOf(document().material(), "t"), name);
  }
  Diagnostics warnings;
  write(folder() / "a" / "loop.json", R"({"glint": "function", "version": 1, "name": "loop", "nodes": {"f": {"kind": "function", "function": "loop.json"}}})");
  write(folder() / "a" / "m.json", textured("", R"("f": {"kind": "function", "function": "loop.json"}, )"));
  ASSERT_TRUE(document().open(folder() / "a" / "m.json", warnings).empty());
  const Diagnostics problems = document().saveAs(folder() / "b" / "n.json", false);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_THAT(problems[0].text(), HasSubstr("calls itself"));
  EXPECT_TRUE(filesIn(folder() / "b").empty());
}

TEST_F(SavingTest, ARecoveredMaterialStillHasItsPictures) {
  write(folder() / "else" / "drop.png", png(13));
  write(folder() / "a" / "map.png", png(14));
  write(folder() / "a" / "m.json", textured("map.png"));
  const fs::path state = folder() / "state";
  Diagnostics warnings;
  {
    Document crashed(ui().editor().nodes(), state);
    ASSERT_TRUE(crashed.open(folder() / "a" / "m.json", warnings).empty());
    fs::create_directory(folder() / "b");
    ASSERT_TRUE(crashed.saveAs(folder() / "b" / "n.json", false).empty());
    const std::string name = crashed.nameFile(folder() / "else" / "drop.png").string();
    ASSERT_TRUE(crashed.edit("Drop", [&](GraphEditor& graph) { return graph.setSetting("t", "file", Json::of(name)); }).empty());
  }
  const auto found = Journal::found(state / "journal", warnings);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(document().recover(found[0]).empty());
  expectNoProblems();
  ASSERT_TRUE(document().save().empty());
  EXPECT_EQ(fileOf(document().material(), "t"), "n_textures/drop.png");
  EXPECT_THAT(filesIn(folder() / "b" / "n_textures"), ElementsAre("drop.png", "map.png"));
  ui().key(Key::Z, kControl);
  EXPECT_EQ(fileOf(document().material(), "t"), "n_textures/map.png");
  expectNoProblems();
}

}  // namespace
}  // namespace glint
