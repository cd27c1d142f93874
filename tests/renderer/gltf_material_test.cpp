#include "renderer/gltf_material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "materials/graph_compile.h"
#include "materials/model_registry.h"

namespace glint {
namespace {

using testing::HasSubstr;

class GltfMaterials : public testing::Test {
 protected:
  GltfMaterials() {
    file_.path = "/models/robot.glb";
    for (const char* name : {"a", "b", "c"}) file_.images[name] = std::make_shared<Image8>(1, 1, 4);
  }
  GltfTexture texture(const char* name) const {
    GltfTexture t;
    t.name = fmt::format("gltf:/models/robot.glb#{}", name);
    t.image = file_.images.at(name);
    return t;
  }
  CompiledMaterial compile(const GltfMaterial& material) {
    const Material graph = gltfMaterialGraph(material, file_);
    auto compiled = compileMaterial(graph, *models_.find("ggx"), nodes_, functions_);
    if (!compiled) {
      for (const Diagnostic& d : compiled.diagnostics()) ADD_FAILURE() << d.text();
      return {};
    }
    return std::move(*compiled);
  }
  static Value valueOf(CompiledMaterial& compiled, const char* name) {
    const UniformField* field = compiled.uniform(name);
    EXPECT_TRUE(field) << name;
    return field ? field->value : Value{};
  }
  GltfMaterial full() const {
    GltfMaterial m;
    m.name = "Robot Arm (left)";
    m.baseColor = texture("a");
    m.metallicRoughness = m.occlusion = texture("b");
    m.normal = texture("c");
    m.emissive = texture("a");
    m.baseColorFactor = {0.1f, 0.2f, 0.3f, 0.5f};
    m.metallicFactor = 0.4f;
    m.roughnessFactor = 0.6f;
    m.normalScale = 0.7f;
    m.occlusionStrength = 0.8f;
    m.emissiveFactor = {5, 6, 7};
    return m;
  }
  GltfFile file_;
  ModelRegistry models_;
  NodeRegistry nodes_;
  FunctionLibrary functions_;
};

TEST_F(GltfMaterials, AllTexturesAndFactors) {
  CompiledMaterial compiled = compile(full());
  EXPECT_EQ(compiled.name, "robot-arm-left");
  // Base colour and emissive share a sample; so do metallic-roughness and occlusion.
  ASSERT_EQ(compiled.textures.size(), 3u);
  for (const TextureSlot& slot : compiled.textures)
    EXPECT_EQ(slot.colorSpace, slot.file.ends_with("#a") ? ColorSpace::sRGB : ColorSpace::Linear) << slot.file;
  EXPECT_EQ(valueOf(compiled, "Base color"), Value::color(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(valueOf(compiled, "Metallic"), Value::scalar(0.4f));
  EXPECT_EQ(valueOf(compiled, "Roughness"), Value::scalar(0.6f));
  EXPECT_EQ(valueOf(compiled, "Normal strength"), Value::scalar(0.7f));
  EXPECT_EQ(valueOf(compiled, "Occlusion strength"), Value::scalar(0.8f));
  EXPECT_EQ(valueOf(compiled, "Emissive"), Value::color(5, 6, 7));
  EXPECT_TRUE(compiled.writesEmissive);
  EXPECT_TRUE(compiled.writesNormal);
  EXPECT_FALSE(compiled.writesOpacityMask);
}

TEST_F(GltfMaterials, ValuesAndPicturesAreNoPartOfTheText) {
  GltfMaterial other = full();
  other.name = "Something else";
  other.baseColorFactor = {1, 1, 1, 1};
  other.metallicFactor = 0.9f;
  other.baseColor = other.emissive = texture("c");
  other.normal = texture("a");
  other.emissiveFactor = {1, 0, 0};
  EXPECT_EQ(compile(full()).glsl, compile(other).glsl);
  GltfMaterial plain;
  EXPECT_NE(compile(plain).glsl, compile(full()).glsl);
}

TEST_F(GltfMaterials, APlainOneHasOnlyItsFactors) {
  CompiledMaterial compiled = compile(GltfMaterial{});
  EXPECT_TRUE(compiled.textures.empty());
  EXPECT_EQ(compiled.uniforms.size(), 3u);
  EXPECT_FALSE(compiled.writesEmissive);
  EXPECT_FALSE(compiled.writesNormal);
}

TEST_F(GltfMaterials, AlphaIsAMaskWhereItCounts) {
  GltfMaterial m = full();
  m.alpha = GltfMaterial::Alpha::Mask;
  m.alphaCutoff = 0.25f;
  EXPECT_TRUE(compile(m).writesOpacityMask);
  SurfaceMaterial surface;
  m.doubleSided = true;
  setSurfaceState(m, surface);
  EXPECT_EQ(surface.opacityCutoff, 0.25f);
  EXPECT_TRUE(surface.doubleSided);
  // Blending: a mask where the picture has an alpha, opaque where it has none.
  m.alpha = GltfMaterial::Alpha::Blend;
  EXPECT_TRUE(compile(m).writesOpacityMask);
  m.baseColor.image = std::make_shared<Image8>(1, 1, 3);
  EXPECT_FALSE(compile(m).writesOpacityMask);
}

TEST_F(GltfMaterials, SamplersAndSecondCoordinates) {
  GltfMaterial m;
  m.baseColor = texture("a");
  m.baseColor.wrapS = Wrap::Clamp;
  m.baseColor.wrapT = Wrap::Mirror;
  m.baseColor.filter = Filter::Nearest;
  m.baseColor.texCoord = 1;
  m.vertexColors = true;
  const CompiledMaterial compiled = compile(m);
  EXPECT_EQ(compiled.textures.at(0).wrapS, Wrap::Clamp);
  EXPECT_EQ(compiled.textures.at(0).wrapT, Wrap::Mirror);
  EXPECT_EQ(compiled.textures.at(0).filter, Filter::Nearest);
  EXPECT_THAT(compiled.glsl, HasSubstr("uv1"));
  EXPECT_THAT(compiled.glsl, HasSubstr("vertexColor"));
}

// KHR_texture_transform in a space where v grows downwards (KhronosGroup/glTF issue 1563): scale, then turn
// counter-clockwise, then move.
glm::vec2 expected(const GltfTexture& t, const glm::vec2& uv) {
  const glm::vec2 p = uv * t.scale;
  const float c = std::cos(t.rotation), s = std::sin(t.rotation);
  return glm::vec2(c * p.x + s * p.y, c * p.y - s * p.x) + t.offset;
}

// What the graph's transform-uv nodes do to a coordinate: shaders/nodes/transform-uv.glsl, in C++.
glm::vec2 throughGraph(const Material& graph, const std::string& node, const glm::vec2& uv) {
  const Node& transform = graph.nodes.at(node);
  const auto setting = [&](const char* pin, size_t component) {
    const Json& value = graph.nodes.at(transform.inputs.at(pin).from->node).settings.at("value");
    return float(value.isArray() ? value.items[component].number : value.number);
  };
  glm::vec2 p = uv;
  if (const auto before = transform.inputs.find("uv"); before != transform.inputs.end())
    p = throughGraph(graph, before->second.from->node, uv);
  p -= glm::vec2(0.5f);
  const float a = glm::radians(setting("rotation", 0)), c = std::cos(a), s = std::sin(a);
  return glm::vec2(c * p.x + s * p.y, c * p.y - s * p.x) * glm::vec2(setting("tile", 0), setting("tile", 1)) + 0.5f +
         glm::vec2(setting("offset", 0), setting("offset", 1));
}

TEST_F(GltfMaterials, TextureTransformsAreThoseOfTheExtension) {
  for (const auto& [offset, scale, rotation] :
       {std::tuple(glm::vec2(0.3f, -0.2f), glm::vec2(1), 0.0f), {glm::vec2(0, 1), glm::vec2(0.5f), 1.57079632679f},
        {glm::vec2(0.1f, 0.2f), glm::vec2(2, 3), 0.0f}, {glm::vec2(0.1f, 0.2f), glm::vec2(2, -3), 0.7f}}) {
    GltfMaterial m;
    m.baseColor = texture("a");
    m.baseColor.offset = offset;
    m.baseColor.scale = scale;
    m.baseColor.rotation = rotation;
    compile(m);
    const Material graph = gltfMaterialGraph(m, file_);
    const PinRef from = *graph.nodes.at("base-color-texture").inputs.at("uv").from;
    for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0.3f, 0.8f)})
      EXPECT_LT(glm::length(throughGraph(graph, from.node, uv) - expected(m.baseColor, uv)), 1e-5f);
  }
}

TEST_F(GltfMaterials, PicturesAreKnownByTheNamesOfTheGraph) {
  TextureCache cache;
  putPictures(file_, cache);
  EXPECT_EQ(*cache.get("a"), file_.images.at("a"));
}

}  // namespace
}  // namespace glint
