#include "renderer/surface_material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "materials/graph_compile.h"
#include "materials/model_registry.h"
#include "renderer/image_io.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using testing::HasSubstr;

Image8 flat(uint8_t value, int size = 2) {
  Image8 image(size, size, 3);
  std::fill(image.data.begin(), image.data.end(), value);
  return image;
}

TEST(TextureCache, AFileIsReadOnceAndAgainWhenItChanged) {
  const test::TempFolder folder;
  ASSERT_TRUE(writeImage8(folder / "a.png", flat(1)).empty());
  TextureCache cache;
  const auto first = cache.get((folder / "a.png").string());
  ASSERT_TRUE(first.ok());
  EXPECT_EQ((*first)->data[0], 1);
  EXPECT_EQ(*cache.get((folder / "a.png").string()), *first);
  EXPECT_FALSE(cache.refresh());
  ASSERT_TRUE(writeImage8(folder / "a.png", flat(2, 9)).empty());
  EXPECT_TRUE(cache.refresh());
  EXPECT_EQ((*cache.get((folder / "a.png").string()))->data[0], 2);
}

TEST(TextureCache, AFailureIsKeptUntilItIsMended) {
  const test::TempFolder folder;
  const std::string path = (folder / "late.png").string();
  TextureCache cache;
  EXPECT_THAT(cache.get(path).diagnostics()[0].what, HasSubstr("no such file"));
  ASSERT_TRUE(writeImage8(path, flat(3)).empty());
  EXPECT_FALSE(cache.get(path).ok());
  EXPECT_TRUE(cache.refresh());
  EXPECT_TRUE(cache.get(path).ok());
}

TEST(TextureCache, NoNameIsWhiteAndPicturesOfModelsComeFromWhoOpenedThem) {
  TextureCache cache;
  EXPECT_EQ(*cache.get(""), nullptr);
  EXPECT_THAT(cache.get("gltf:/x/model.glb#0").diagnostics()[0].what, HasSubstr("not open"));
  const auto image = std::make_shared<const Image8>(flat(5));
  cache.put("gltf:/x/model.glb#0", image);
  EXPECT_EQ(*cache.get("gltf:/x/model.glb#0"), image);
  EXPECT_FALSE(cache.refresh());
}

TEST(TextureCache, PreparesSeveralAtOnce) {
  const test::TempFolder folder;
  std::vector<std::string> files;
  for (int i = 0; i < 20; ++i) {
    files.push_back((folder / fmt::format("{}.png", i % 10)).string());
    ASSERT_TRUE(writeImage8(files.back(), flat(uint8_t(i % 10))).empty());
  }
  TextureCache cache;
  cache.prepare(files);
  for (int i = 0; i < 20; ++i) EXPECT_EQ((*cache.get(files[size_t(i)]))->data[0], i % 10);
}

class Surfaces : public testing::Test {
 protected:
  SurfaceMaterial make(const Material& material) {
    const ModelPtr model = models_.find("ggx");
    auto compiled = compileMaterial(material, *model, nodes_, functions_);
    EXPECT_TRUE(compiled.ok()) << compiled.diagnostics()[0].text();
    return surfaceMaterial(std::make_shared<CompiledMaterial>(std::move(*compiled)), model, cache_, problems_);
  }
  // A texture sample wired to the base colour.
  Material textured(const std::string& file) {
    Material m = newMaterial("textured");
    m.file = folder_ / "textured.json";
    Node& sample = m.nodes["picture"];
    sample.kind = "texture-sample";
    sample.settings["file"] = Json::of(file);
    m.nodes[m.outputNode()].inputs["baseColor"].from = PinRef{"picture", "color"};
    return m;
  }
  test::TempFolder folder_;
  ModelRegistry models_;
  NodeRegistry nodes_;
  FunctionLibrary functions_;
  TextureCache cache_;
  Diagnostics problems_;
};

TEST_F(Surfaces, HaveOneTextureForEachSlotAndTheWholeBlock) {
  ASSERT_TRUE(writeImage8(folder_ / "a.png", flat(7)).empty());
  Material m = textured("a.png");
  Node& roughness = m.nodes["roughness"];
  roughness.kind = "parameter";
  roughness.settings["type"] = Json::of("float");
  roughness.settings["value"] = Json::of(0.25f);
  m.nodes[m.outputNode()].inputs["roughness"].from = PinRef{"roughness", "value"};
  const SurfaceMaterial surface = make(m);
  EXPECT_TRUE(problems_.empty());
  ASSERT_EQ(surface.textures.size(), 1u);
  EXPECT_EQ(surface.textures[0]->data[0], 7);
  ASSERT_EQ(surface.block.size(), size_t(surface.compiled->blockSize));
  float value;
  std::memcpy(&value, surface.block.data() + surface.compiled->uniforms.at(0).offset, sizeof value);
  EXPECT_EQ(value, 0.25f);
  EXPECT_EQ(surface.modelParameters.size(), surface.model->parameters.size());
}

TEST_F(Surfaces, AMissingTextureIsAnErrorAtItsNodeAndLoud) {
  const SurfaceMaterial surface = make(textured("nowhere.png"));
  ASSERT_EQ(problems_.size(), 1u);
  EXPECT_EQ(problems_[0].severity, Severity::Error);
  EXPECT_THAT(problems_[0].place, HasSubstr("textured.json: node 'picture'"));
  EXPECT_THAT(problems_[0].what, HasSubstr("nowhere.png"));
  ASSERT_EQ(surface.textures.size(), 1u);
  EXPECT_EQ(surface.textures[0], missingTexture());
  EXPECT_EQ(missingTexture()->at(0, 0)[0], 255);
  EXPECT_EQ(missingTexture()->at(0, 0)[1], 0);
  EXPECT_EQ(missingTexture()->at(8, 0)[0], 0);
}

}  // namespace
}  // namespace glint
