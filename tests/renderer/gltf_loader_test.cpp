#include "renderer/gltf_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "materials/base/files.h"
#include "renderer/image_io.h"
#include "tests/support/gltf_builder.h"
#include "tests/support/mutate.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using nlohmann::ordered_json;
using test::GltfBuilder;
using testing::HasSubstr;

class Gltf : public testing::Test {
 protected:
  Result<GltfFile> load(const std::string& bytes, const char* name = "model.glb") {
    warnings_.clear();
    return parseGltf(bytes, folder_ / name, warnings_);
  }
  GltfFile good(const std::string& bytes, const char* name = "model.glb") {
    Result<GltfFile> file = load(bytes, name);
    if (!file) {
      ADD_FAILURE() << file.diagnostics()[0].text();
      return {};
    }
    return std::move(*file);
  }
  // All that is wrong, one a line.
  std::string faults(const std::string& bytes, const char* name = "model.glb") {
    const Result<GltfFile> file = load(bytes, name);
    if (file.ok()) {
      ADD_FAILURE() << "was read";
      return {};
    }
    std::string out;
    for (const Diagnostic& d : file.diagnostics()) {
      EXPECT_THAT(d.place, HasSubstr(name));
      EXPECT_FALSE(d.what.empty());
      EXPECT_FALSE(d.hint.empty());
      out += d.text() + "\n";
    }
    return out;
  }
  std::string png(uint8_t r, uint8_t g, uint8_t b, uint8_t a = 255) {
    Image8 image(2, 2, 4);
    for (size_t i = 0; i < image.data.size(); i += 4) {
      image.data[i] = r;
      image.data[i + 1] = g;
      image.data[i + 2] = b;
      image.data[i + 3] = a;
    }
    EXPECT_TRUE(writeImage8(folder_ / "made.png", image).empty());
    return *readFile(folder_ / "made.png");
  }
  test::TempFolder folder_;
  Diagnostics warnings_;
};

TEST_F(Gltf, ATriangleLoadsFromBothContainers) {
  GltfBuilder b;
  b.showTriangle();
  for (const bool binary : {true, false}) {
    const GltfFile file = good(binary ? b.glb() : b.gltf(), binary ? "model.glb" : "model.gltf");
    ASSERT_EQ(file.nodes.size(), 1u);
    ASSERT_EQ(file.materials.size(), 1u);
    const Mesh& mesh = *file.nodes[0].mesh;
    EXPECT_EQ(mesh.indices, (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.vertices[1].position, glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.vertices[2].uv0, glm::vec2(0, 0));
    EXPECT_EQ(mesh.vertices[0].tangent, glm::vec4(1, 0, 0, 1));  // computed
    EXPECT_EQ(mesh.vertices[0].color, glm::vec4(1));
    EXPECT_TRUE(warnings_.empty());
    EXPECT_TRUE(file.path.is_absolute());
  }
}

TEST_F(Gltf, FilesLoadFromTheirPath) {
  GltfBuilder b;
  b.showTriangle();
  EXPECT_TRUE(loadGltf(folder_.write("on disk.glb", b.glb()), warnings_).ok());
}

TEST_F(Gltf, IndicesOfEveryTypeAndNone) {
  for (const int component : {5121, 5123, 5125, 0}) {
    GltfBuilder b;
    ordered_json p = {{"attributes", {{"POSITION", b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3)}}}};
    if (component == 5121) p["indices"] = b.accessor(b.view(GltfBuilder::bytesOf<uint8_t>({2, 0, 1})), component, "SCALAR", 3);
    if (component == 5123) p["indices"] = b.accessor(b.view(GltfBuilder::bytesOf<uint16_t>({2, 0, 1})), component, "SCALAR", 3);
    if (component == 5125) p["indices"] = b.accessor(b.view(GltfBuilder::bytesOf<uint32_t>({2, 0, 1})), component, "SCALAR", 3);
    b.show(p);
    const Mesh mesh = *good(b.glb()).nodes.at(0).mesh;
    const auto& first = mesh.vertices[mesh.indices[0]];
    EXPECT_EQ(first.position, component ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 0));
    EXPECT_EQ(first.normal, glm::vec3(0, 0, 1));  // computed, flat
  }
}

TEST_F(Gltf, StripsAndFansBecomeTrianglesOfOneFacing) {
  for (const int mode : {5, 6}) {
    GltfBuilder b;
    // A square: as a strip 0 1 3 2, as a fan 0 1 2 3.
    const std::vector<float> strip = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, fan = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    b.show({{"attributes", {{"POSITION", b.floats(mode == 5 ? strip : fan, "VEC3", 3)}}}, {"mode", mode}});
    const Mesh mesh = *good(b.glb()).nodes.at(0).mesh;
    ASSERT_EQ(mesh.indices.size(), 6u);
    for (const Vertex& v : mesh.vertices) EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
  }
}

TEST_F(Gltf, MissingNormalsAreFlat) {
  GltfBuilder b;
  // Two triangles that share an edge and stand at a right angle.
  b.show({{"attributes", {{"POSITION", b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3", 3)}}},
          {"indices", b.accessor(b.view(GltfBuilder::bytesOf<uint8_t>({0, 1, 2, 0, 2, 3})), 5121, "SCALAR", 6)}});
  const Mesh mesh = *good(b.glb()).nodes.at(0).mesh;
  ASSERT_EQ(mesh.vertices.size(), 6u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(mesh.vertices[size_t(k)].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.vertices[size_t(3 + k)].normal, glm::vec3(1, 0, 0));
  }
}

TEST_F(Gltf, InterleavedQuantizedAndColouredVertices) {
  GltfBuilder b;
  // Each vertex: position as 3 shorts, 2 of padding, uv as 2 normalized unsigned bytes, 2 of padding.
  std::string data;
  const auto vertex = [&](int16_t x, int16_t y, int16_t z, uint8_t u, uint8_t v) {
    data += GltfBuilder::bytesOf<int16_t>({x, y, z, 0}) + GltfBuilder::bytesOf<uint8_t>({u, v, 0, 0});
  };
  vertex(0, 0, 0, 0, 255);
  vertex(7, 0, 0, 255, 255);
  vertex(0, -3, 0, 0, 0);
  const int view = b.view(data, 12);
  const int position = b.accessor(view, 5122, "VEC3", 3);
  const int uv = b.accessor(view, 5121, "VEC2", 3, true);
  b.json["accessors"][size_t(uv)]["byteOffset"] = 8;
  const int color = b.accessor(b.view(GltfBuilder::bytesOf<uint16_t>({65535, 0, 0, 0, 65535, 0, 0, 0, 65535}), 0), 5123, "VEC3", 3, true);
  b.show({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}, {"COLOR_0", color}}}});
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const GltfFile file = good(b.glb());
  const auto& v = file.nodes.at(0).mesh->vertices;
  EXPECT_EQ(v[1].position, glm::vec3(7, 0, 0));
  EXPECT_EQ(v[2].position, glm::vec3(0, -3, 0));
  EXPECT_EQ(v[1].uv0, glm::vec2(1, 1));
  EXPECT_EQ(v[1].color, glm::vec4(0, 1, 0, 1));
  EXPECT_TRUE(file.materials[0].vertexColors);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(Gltf, SparseAccessorsReplaceOrStartFromZero) {
  for (const bool base : {true, false}) {
    GltfBuilder b;
    const int position = base ? b.floats({0, 0, 0, 1, 0, 0, 9, 9, 9}, "VEC3", 3)
                              : b.push("accessors", {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    b.json["accessors"][size_t(position)]["sparse"] = {
        {"count", base ? 1 : 2},
        {"indices", {{"bufferView", b.view(GltfBuilder::bytesOf<uint8_t>(base ? std::vector<uint8_t>{2} : std::vector<uint8_t>{1, 2}))}, {"componentType", 5121}}},
        {"values", {{"bufferView", b.view(GltfBuilder::bytesOf<float>(base ? std::vector<float>{0, 1, 0} : std::vector<float>{1, 0, 0, 0, 1, 0}))}}}};
    b.show({{"attributes", {{"POSITION", position}}}});
    const auto v = good(b.glb()).nodes.at(0).mesh->vertices;
    EXPECT_EQ(v[0].position, glm::vec3(0, 0, 0));
    EXPECT_EQ(v[1].position, glm::vec3(1, 0, 0));
    EXPECT_EQ(v[2].position, glm::vec3(0, 1, 0));
  }
}

TEST_F(Gltf, NodesCompose) {
  GltfBuilder b;
  b.showTriangle();
  b.json["nodes"] = {{{"children", {1}}, {"translation", {1, 2, 3}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}, {"scale", {2, 2, 2}}},
                     {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}, {"name", "leaf"}}};
  b.json["scenes"][0]["nodes"] = {0};
  const GltfFile file = good(b.glb());
  EXPECT_EQ(file.nodes.at(0).name, "leaf");
  const glm::vec3 origin = file.nodes[0].worldFromModel * glm::vec4(0, 0, 0, 1);
  EXPECT_NEAR(glm::length(origin - glm::vec3(1, 12, 3)), 0, 1e-4);  // (5,0,0) scaled, turned by 90 degrees, moved
}

TEST_F(Gltf, SharedMeshesStayShared) {
  GltfBuilder b;
  b.showTriangle();
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {1, 0, 0}}});
  b.json["scenes"][0]["nodes"].push_back(1);
  const GltfFile file = good(b.glb());
  EXPECT_EQ(file.nodes.at(0).mesh, file.nodes.at(1).mesh);
}

TEST_F(Gltf, MaterialsWithEverything) {
  GltfBuilder b;
  const int base = b.texture(png(1, 2, 3, 4));
  const int other = b.texture(png(5, 6, 7));
  b.push("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  b.json["textures"][0]["sampler"] = 0;
  b.push("materials",
         {{"name", "All"},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
            {"metallicFactor", 0.5},
            {"roughnessFactor", 0.6},
            {"baseColorTexture",
             {{"index", base}, {"texCoord", 1}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.25, 0.5}}, {"scale", {2, 3}}, {"rotation", 1.5}}}}}}},
            {"metallicRoughnessTexture", {{"index", other}}}}},
          {"normalTexture", {{"index", other}, {"scale", 0.7}}},
          {"occlusionTexture", {{"index", other}, {"strength", 0.8}}},
          {"emissiveTexture", {{"index", other}}},
          {"emissiveFactor", {1, 0.5, 0}},
          {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 10}}}}},
          {"alphaMode", "MASK"},
          {"alphaCutoff", 0.3},
          {"doubleSided", true}});
  b.showTriangle({{"material", 0}});
  b.showTriangle();  // without one
  b.json["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_emissive_strength"};
  const GltfFile file = good(b.glb());
  EXPECT_TRUE(warnings_.empty());
  ASSERT_EQ(file.materials.size(), 2u);
  EXPECT_EQ(file.nodes[0].material, 0);
  EXPECT_EQ(file.nodes[1].material, 1);
  const GltfMaterial& m = file.materials[0];
  EXPECT_EQ(m.name, "All");
  EXPECT_EQ(m.baseColorFactor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallicFactor, 0.5f);
  EXPECT_EQ(m.roughnessFactor, 0.6f);
  EXPECT_EQ(m.normalScale, 0.7f);
  EXPECT_EQ(m.occlusionStrength, 0.8f);
  EXPECT_EQ(m.emissiveFactor, glm::vec3(10, 5, 0));
  EXPECT_EQ(m.alpha, GltfMaterial::Alpha::Mask);
  EXPECT_EQ(m.alphaCutoff, 0.3f);
  EXPECT_TRUE(m.doubleSided);
  EXPECT_EQ(m.baseColor.texCoord, 1);
  EXPECT_EQ(m.baseColor.wrapS, Wrap::Clamp);
  EXPECT_EQ(m.baseColor.wrapT, Wrap::Mirror);
  EXPECT_EQ(m.baseColor.filter, Filter::Nearest);
  EXPECT_EQ(m.baseColor.offset, glm::vec2(0.25f, 0.5f));
  EXPECT_EQ(m.baseColor.scale, glm::vec2(2, 3));
  EXPECT_EQ(m.baseColor.rotation, 1.5f);
  EXPECT_EQ(m.baseColor.image->data[3], 4);
  EXPECT_EQ(m.normal.image, m.emissive.image);
  EXPECT_EQ(m.normal.image->data[0], 5);
  EXPECT_EQ(m.normal.name, fmt::format("gltf:{}#1", file.path.string()));
  EXPECT_EQ(file.images.size(), 2u);
}

TEST_F(Gltf, PicturesFromFilesAndDataUris) {
  GltfBuilder b;
  folder_.write("sub folder/a+b.png", png(10, 20, 30));
  b.push("images", {{"uri", "sub%20folder/a+b.png"}});
  b.push("images", {{"uri", "data:image/png;base64," + GltfBuilder::base64(png(40, 50, 60))}});
  b.push("textures", {{"source", 0}});
  b.push("textures", {{"source", 1}});
  b.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"emissiveTexture", {{"index", 1}}}});
  b.showTriangle({{"material", 0}});
  const GltfFile file = good(b.gltf(), "model.gltf");
  EXPECT_EQ(file.materials[0].baseColor.image->data[0], 10);
  EXPECT_EQ(file.materials[0].emissive.image->data[0], 40);
}

TEST_F(Gltf, BuffersFromFilesAreReadAndTheirSizeChecked) {
  GltfBuilder b;
  b.showTriangle();
  ordered_json out = b.json;
  out["buffers"] = {{{"byteLength", b.bin.size()}, {"uri", "data.bin"}}};
  folder_.write("data.bin", b.bin);
  EXPECT_EQ(good(out.dump(), "model.gltf").nodes.size(), 1u);
  folder_.write("data.bin", b.bin.substr(1));
  EXPECT_THAT(faults(out.dump(), "model.gltf"), HasSubstr("'data.bin' holds"));
}

TEST_F(Gltf, OnlyFilesInItsFolderAreRead) {
  const test::TempFolder& outer = folder_;
  outer.write("secret.png", png(1, 1, 1));
  std::filesystem::create_directories(outer / "model");
  std::filesystem::create_symlink(outer / "secret.png", outer / "model/link.png");
  for (const char* uri : {"../secret.png", "%2e%2e/secret.png", "link.png", "/etc/passwd", "file:///etc/passwd", "http://example.org/x.png",
                          "..\\\\secret.png", "a/../../secret.png", "%00", "bad%zz", ""}) {
    GltfBuilder b;
    b.push("images", {{"uri", uri}});
    b.push("textures", {{"source", 0}});
    b.push("materials", {{"emissiveTexture", {{"index", 0}}}});
    b.showTriangle({{"material", 0}});
    EXPECT_THAT(faults(b.gltf(), "model/model.gltf"), HasSubstr("images[0].uri")) << uri;
  }
}

TEST_F(Gltf, MissingAndCorruptPicturesAreNamed) {
  GltfBuilder b;
  const std::string whole = png(1, 2, 3);
  b.push("materials", {{"emissiveTexture", {{"index", b.texture(whole.substr(0, whole.size() - 20))}}}});
  b.showTriangle({{"material", 0}});
  EXPECT_THAT(faults(b.glb()), HasSubstr("images[0] is a truncated PNG"));

  GltfBuilder missing;
  missing.push("images", {{"uri", "nowhere.png"}});
  missing.push("textures", {{"source", 0}});
  missing.push("materials", {{"emissiveTexture", {{"index", 0}}}});
  missing.showTriangle({{"material", 0}});
  EXPECT_THAT(faults(missing.gltf(), "model.gltf"), HasSubstr("'nowhere.png': no such file"));
}

TEST_F(Gltf, PicturesThatNothingUsesAreNotDecoded) {
  GltfBuilder b;
  b.texture("not a picture at all");
  b.showTriangle();
  EXPECT_TRUE(good(b.glb()).images.empty());
}

// ---- Bad input ----

struct Bad {
  const char* name;
  void (*spoil)(GltfBuilder&);
  const char* says;
};
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

class BadGltf : public Gltf, public testing::WithParamInterface<Bad> {};

const Bad kBad[] = {
    {"Version", [](GltfBuilder& b) { b.json["asset"]["version"] = "1.0"; }, "asset.version is '1.0'"},
    {"NoAsset", [](GltfBuilder& b) { b.json.erase("asset"); }, "has no 'asset'"},
    {"Draco", [](GltfBuilder& b) { b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }, "needs the extension 'KHR_draco_mesh_compression'"},
    {"ListIsObject", [](GltfBuilder& b) { b.json["meshes"] = ordered_json::object(); }, "meshes is an object, not an array"},
    {"ItemIsNumber", [](GltfBuilder& b) { b.json["nodes"] = {1}; }, "nodes[0] is a number, not an object"},
    {"BufferTooLong", [](GltfBuilder& b) { b.json["bufferViews"][1]["byteLength"] = 100000; }, "bufferViews[1] ends at byte"},
    {"ViewOffsetOverflows", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteOffset"] = 18446744073709551615ull; }, "bufferViews[0].byteOffset"},
    {"ViewOfNoBuffer", [](GltfBuilder& b) { b.json["bufferViews"][0]["buffer"] = 7; }, "bufferViews[0].buffer is 7, but there are 1 buffers"},
    {"EmptyView", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteLength"] = 0; }, "bufferViews[0].byteLength is 0"},
    {"Stride", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteStride"] = 3; }, "bufferViews[0].byteStride is 3"},
    {"StrideTooSmall", [](GltfBuilder& b) { b.json["bufferViews"][0]["byteStride"] = 4; }, "has elements of 12 bytes every 4"},
    {"AccessorTooLong", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 4; }, "accessors[0] ends at byte"},
    {"AccessorOffset", [](GltfBuilder& b) { b.json["accessors"][0]["byteOffset"] = 4; }, "accessors[0] ends at byte"},
    {"HugeCount", [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 4000000000u; }, "accessors[0].count"},
    {"HugeZeros", [](GltfBuilder& b) { b.json["accessors"][0].erase("bufferView"); b.json["accessors"][0]["count"] = 100000000u; }, "accessors[0].count"},
    {"NegativeIndex", [](GltfBuilder& b) { b.json["accessors"][0]["bufferView"] = -1; }, "accessors[0].bufferView is -1"},
    {"FractionalIndex", [](GltfBuilder& b) { b.json["accessors"][0]["bufferView"] = 0.5; }, "accessors[0].bufferView is 0.5"},
    {"TextIndex", [](GltfBuilder& b) { b.json["accessors"][0]["bufferView"] = "0"; }, "accessors[0].bufferView is a string"},
    {"ComponentType", [](GltfBuilder& b) { b.json["accessors"][0]["componentType"] = 5130; }, "accessors[0].componentType is 5130"},
    {"Type", [](GltfBuilder& b) { b.json["accessors"][0]["type"] = "VEC5"; }, "accessors[0].type is 'VEC5'"},
    {"PositionType", [](GltfBuilder& b) { b.json["accessors"][0]["type"] = "VEC2"; }, "attributes.POSITION is of type VEC2"},
    {"Counts", [](GltfBuilder& b) { b.json["accessors"][1]["count"] = 2; }, "attributes.NORMAL has 2 elements"},
    {"IndexType", [](GltfBuilder& b) { b.json["accessors"][3]["componentType"] = 5122; }, "indices is of type SCALAR with component type 5122"},
    {"IndexOutOfRange", [](GltfBuilder& b) { b.bin[b.bin.size() - 2] = 3; }, "index 2 is 3, but there are 3 vertices"},
    {"NotFinite", [](GltfBuilder& b) { b.bin.replace(12, 4, "\xff\xff\xff\x7f"); }, "POSITION of vertex 1 is not finite"},
    {"NoPosition", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }, "has no POSITION"},
    {"NoPrimitives", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"] = ordered_json::array(); }, "primitives is empty"},
    {"Mode", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["mode"] = 7; }, "primitives[0].mode is 7"},
    {"MaterialIndex", [](GltfBuilder& b) { b.json["meshes"][0]["primitives"][0]["material"] = 0; }, "material is 0, but there are 0 materials"},
    {"MeshIndex", [](GltfBuilder& b) { b.json["nodes"][0]["mesh"] = 1; }, "nodes[0].mesh is 1, but there are 1 meshes"},
    {"Matrix", [](GltfBuilder& b) { b.json["nodes"][0]["matrix"] = {1, 2, 3}; }, "nodes[0].matrix is not a list of 16 numbers"},
    {"HugeTransform", [](GltfBuilder& b) { b.json["nodes"][0]["scale"] = {1e300, 1, 1}; }, "has a transform that is not finite"},
    {"Cycle", [](GltfBuilder& b) { b.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}, {"mesh", 0}}}; }, "its own ancestor"},
    {"OwnChild", [](GltfBuilder& b) { b.json["nodes"][0]["children"] = {0}; }, "its own ancestor"},
    {"TwoParents", [](GltfBuilder& b) { b.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}}; }, "which nodes[0] already holds"},
    {"RootWithParent", [](GltfBuilder& b) { b.json["nodes"].push_back({{"children", {0}}}); }, "a scene lists root nodes only"},
    {"SceneIndex", [](GltfBuilder& b) { b.json["scene"] = 3; }, "scene is 3, but there are 1 scenes"},
    {"NothingDrawn", [](GltfBuilder& b) { b.json["scenes"][0]["nodes"] = ordered_json::array(); }, "draws no triangles"},
    {"ImageView", [](GltfBuilder& b) { b.push("images", {{"bufferView", 99}, {"mimeType", "image/png"}}); }, "images[0].bufferView is 99"},
    {"TextureSource", [](GltfBuilder& b) { b.push("textures", {{"source", 4}}); }, "textures[0].source is 4"},
    {"Wrap", [](GltfBuilder& b) { b.push("samplers", {{"wrapS", 1}}); }, "samplers[0].wrapS is 1"},
    {"TextureIndex", [](GltfBuilder& b) { b.push("materials", {{"normalTexture", {{"index", 2}}}}); }, "normalTexture.index is 2"},
    {"AlphaMode", [](GltfBuilder& b) { b.push("materials", {{"alphaMode", "MAYBE"}}); }, "alphaMode is 'MAYBE'"},
    {"SparseIndexView", [](GltfBuilder& b) { b.json["accessors"][0]["sparse"] = {{"count", 1}, {"indices", {{"bufferView", 44}, {"componentType", 5121}}}, {"values", {{"bufferView", 0}}}}; }, "sparse.indices.bufferView is 44"},
    {"SparseCount", [](GltfBuilder& b) { b.json["accessors"][0]["sparse"] = {{"count", 5}, {"indices", {{"bufferView", 0}, {"componentType", 5121}}}, {"values", {{"bufferView", 0}}}}; }, "sparse.count is 5"},
    {"SparseIndexOutOfRange", [](GltfBuilder& b) { b.json["accessors"][0]["sparse"] = {{"count", 1}, {"indices", {{"bufferView", b.view("\x09")}, {"componentType", 5121}}}, {"values", {{"bufferView", 0}}}}; }, "sparse part of POSITION replaces element 9 of 3"},
};

TEST_P(BadGltf, IsOneClearFault) {
  GltfBuilder b;
  b.showTriangle();
  GetParam().spoil(b);
  const std::string told = faults(b.glb());
  EXPECT_THAT(told, HasSubstr(GetParam().says));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
}

INSTANTIATE_TEST_SUITE_P(Files, BadGltf, testing::ValuesIn(kBad), [](const auto& bad) { return bad.param.name; });

TEST_F(Gltf, SeveralFaultsComeAtOnceWithTheirLines) {
  GltfBuilder b;
  b.showTriangle();
  b.json["accessors"][0]["type"] = "VEC5";
  b.json["nodes"][0]["mesh"] = 9;
  const Result<GltfFile> file = load(b.gltf(), "model.gltf");
  ASSERT_FALSE(file.ok());
  ASSERT_EQ(file.diagnostics().size(), 2u);
  for (const Diagnostic& d : file.diagnostics()) EXPECT_THAT(d.place, testing::MatchesRegex(".*model\\.gltf:[0-9]+"));
}

// What follows from a bad buffer is not told as well: its views, their accessors, the attributes and pictures of those.
TEST_F(Gltf, OneBadBufferIsOneFault) {
  GltfBuilder b;
  b.showTriangle();
  b.texture(png(1, 2, 3));
  const auto withBuffer = [&](const ordered_json& buffers) {
    ordered_json json = b.json;
    if (!buffers.is_null()) json["buffers"] = buffers;
    return json.dump(1);
  };
  const std::string data = "data:application/octet-stream;base64,";
  const std::pair<ordered_json, const char*> cases[] = {
      {{{{"uri", data + GltfBuilder::base64(b.bin)}}}, "buffers[0] has no 'byteLength'"},
      {{{{"byteLength", 0}, {"uri", data}}}, "buffers[0].byteLength is 0"},
      {{{{"byteLength", -4}, {"uri", data}}}, "buffers[0].byteLength is -4"},
      {{{{"byteLength", "many"}}}, "buffers[0].byteLength is a string"},
      {{{{"byteLength", b.bin.size()}}}, "buffers[0] has no 'uri'"},
      {{{{"byteLength", 12}, {"uri", data + GltfBuilder::base64(b.bin)}}}, "but byteLength is 12"},
      {{{{"byteLength", 12}, {"uri", data + "!!"}}}, "is not valid base64"},
      {{{{"byteLength", 12}, {"uri", "nowhere.bin"}}}, "'nowhere.bin': no such file"},
      {{{{"byteLength", 12}, {"uri", data + GltfBuilder::base64(b.bin.substr(0, 12))}}}, "bufferViews[0] ends at byte 36 of buffers[0], which has 12; 4 more of its views"},
      {nullptr, "bufferViews[0].buffer is 0, but there are 0 buffers"},
  };
  for (const auto& [buffers, says] : cases) {
    const std::string told = faults(withBuffer(buffers), "model.gltf");
    EXPECT_THAT(told, HasSubstr(says));
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1) << told;
  }
}

TEST_F(Gltf, ManyFaultsAreCutShort) {
  GltfBuilder b;
  b.showTriangle();
  for (int i = 0; i < 1000; ++i) b.push("materials", {{"alphaMode", "MAYBE"}});
  const Result<GltfFile> file = load(b.glb());
  ASSERT_FALSE(file.ok());
  EXPECT_EQ(file.diagnostics().size(), 13u);
  EXPECT_THAT(file.diagnostics().back().what, HasSubstr("988 more"));
}

TEST_F(Gltf, DeepNestingIsRefused) {
  GltfBuilder b;
  b.showTriangle();
  std::string text = b.json.dump();
  text.pop_back();
  text += ",\"extras\":" + std::string(200000, '[') + std::string(200000, ']') + "}";
  EXPECT_THAT(faults(text, "model.gltf"), HasSubstr("deep"));
}

TEST_F(Gltf, ADeepHierarchyIsRefused) {
  GltfBuilder b;
  b.showTriangle();
  b.json["nodes"][0] = {{"children", {1}}};
  for (int i = 1; i < 1000; ++i) b.json["nodes"].push_back({{"children", {i + 1}}});
  b.json["nodes"].push_back({{"mesh", 0}});
  EXPECT_THAT(faults(b.glb()), HasSubstr("nodes deep"));
}

TEST_F(Gltf, OneMeshInMillionsOfPlacesIsRefused) {
  GltfBuilder b;
  b.showTriangle();
  const ordered_json primitive = b.json["meshes"][0]["primitives"][0];
  for (int i = 0; i < 2000; ++i) b.json["meshes"][0]["primitives"].push_back(primitive);
  for (int i = 0; i < 2000; ++i) {
    b.json["scenes"][0]["nodes"].push_back(b.json["nodes"].size());
    b.json["nodes"].push_back({{"mesh", 0}});
  }
  EXPECT_THAT(faults(b.glb()), HasSubstr("more than a million instances"));
}

TEST_F(Gltf, OtherFilesAreNamedAsSuch) {
  EXPECT_THAT(faults(""), HasSubstr("is empty"));
  EXPECT_THAT(faults("v 0 0 0\nf 1 2 3\n"), HasSubstr("is not a glTF"));
  EXPECT_THAT(faults("{\"asset\": "), HasSubstr("model.glb:1"));
  EXPECT_THAT(faults("[]"), HasSubstr("is not a glTF"));
  EXPECT_THAT(load("x", "y").diagnostics()[0].text(), HasSubstr("is not a glTF"));
  Diagnostics warnings;
  EXPECT_THAT(loadGltf(folder_ / "nowhere.glb", warnings).diagnostics()[0].what, HasSubstr("no such file"));
}

TEST_F(Gltf, EveryTruncationOfABinaryFileIsAFault) {
  GltfBuilder b;
  b.showTriangle();
  const std::string bytes = b.glb();
  for (size_t n = 4; n < bytes.size(); ++n) ASSERT_THAT(faults(bytes.substr(0, n)), HasSubstr("truncated .glb")) << n;
}

TEST_F(Gltf, WhatIsNotReadIsSaid) {
  GltfBuilder b;
  b.showTriangle();
  b.json["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_texture_transform"};
  b.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  b.push("materials", {{"alphaMode", "BLEND"}});
  EXPECT_EQ(good(b.glb()).nodes.size(), 1u);
  std::string said;
  for (const Diagnostic& d : warnings_) {
    EXPECT_EQ(d.severity, Severity::Warning);
    said += d.what + "\n";
  }
  EXPECT_THAT(said, HasSubstr("not read: KHR_materials_clearcoat\n"));
  EXPECT_THAT(said, HasSubstr("points or lines"));
  EXPECT_THAT(said, HasSubstr("blended by alpha"));
}

// ---- Fuzz ----

// A file with a bit of everything.
std::string rich(const std::string& picture, bool binary) {
  GltfBuilder b;
  const int texture = b.texture(picture);
  b.push("samplers", {{"wrapS", 33071}});
  b.json["textures"][size_t(texture)]["sampler"] = 0;
  b.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.1, 0.2}}, {"rotation", 0.5}}}}}}}, {"baseColorFactor", {1, 0.5, 0.25, 1}}}},
                       {"normalTexture", {{"index", texture}, {"scale", 0.5}}},
                       {"emissiveFactor", {0.1, 0.2, 0.3}}});
  b.showTriangle({{"material", 0}});
  const int position = b.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3", 3);
  b.json["accessors"][size_t(position)]["sparse"] = {{"count", 1}, {"indices", {{"bufferView", b.view("\x02")}, {"componentType", 5121}}}, {"values", {{"bufferView", b.view(std::string(12, '\0'))}}}};
  b.show({{"attributes", {{"POSITION", position}}}, {"mode", 5}});
  b.json["nodes"].push_back({{"children", {0, 1}}, {"rotation", {0, 0, 0, 1}}});
  b.json["scenes"][0]["nodes"] = {2};
  return binary ? b.glb() : b.gltf();
}

class GltfFuzz : public Gltf {
 protected:
  void fuzz(const std::string& bytes, int iterations) {
    ASSERT_TRUE(load(bytes).ok()) << load(bytes).diagnostics()[0].text();
    std::mt19937 random(7);
    for (int i = 0; i < iterations; ++i) {
      const Result<GltfFile> file = load(test::mutate(bytes, random));
      if (!file) {
        ASSERT_FALSE(file.diagnostics().empty());
        continue;
      }
      for (const GltfNode& node : file->nodes) {
        ASSERT_LT(size_t(node.material), file->materials.size());
        for (const uint32_t index : node.mesh->indices) ASSERT_LT(index, node.mesh->vertices.size());
        for (const Vertex& v : node.mesh->vertices) ASSERT_TRUE(std::isfinite(v.position.x) && std::isfinite(v.normal.x) && std::isfinite(v.tangent.x));
      }
    }
  }
};

TEST_F(GltfFuzz, Binary) { fuzz(rich(png(1, 2, 3), true), 3000); }
TEST_F(GltfFuzz, Text) { fuzz(rich(png(1, 2, 3), false), 3000); }

}  // namespace
}  // namespace glint
