// glTF 2.0 files (.glb, .gltf) as meshes, transforms and materials. Everything in them is untrusted.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/compiled_material.h"
#include "renderer/scene.h"

namespace glint {

// A texture as one material uses it.
struct GltfTexture {
  // What a TextureSlot calls it: "gltf:PATH#N" for images[N] of the model at the absolute PATH. Empty where the
  // material has none.
  std::string name;
  Image8Ptr image;                      // null where the material has none
  int texCoord = 0;                     // 0 or 1
  Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
  Filter filter = Filter::Linear;
  glm::vec2 offset{0}, scale{1};        // KHR_texture_transform
  float rotation = 0;                   // radians, counter-clockwise

  bool present() const { return !name.empty(); }
};

// The core metallic-roughness material, with KHR_materials_emissive_strength multiplied into the factor.
struct GltfMaterial {
  std::string name;
  glm::vec4 baseColorFactor{1};
  float metallicFactor = 1, roughnessFactor = 1, normalScale = 1, occlusionStrength = 1;
  glm::vec3 emissiveFactor{0};          // nits
  GltfTexture baseColor, metallicRoughness, normal, occlusion, emissive;
  enum class Alpha { Opaque, Mask, Blend } alpha = Alpha::Opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  bool vertexColors = false;            // some primitive that wears it has COLOR_0
};

struct GltfNode {
  std::string name;                     // of the node, for lists
  MeshPtr mesh;                         // one primitive; a mirrored copy where the transform mirrors
  glm::mat4 worldFromModel{1};
  int material = 0;                     // index into GltfFile::materials
};

struct GltfFile {
  std::filesystem::path path;           // absolute
  std::vector<GltfMaterial> materials;  // at least one; the last is glTF's default where one is needed
  std::vector<GltfNode> nodes;          // of the default scene
  // The pictures by the names that GltfTexture uses; those that no material uses are not decoded.
  std::map<std::string, Image8Ptr> images;
};

// The most that one file may hold, all its primitives together and all its pictures together.
inline constexpr uint64_t kMostGltfVertices = uint64_t{1} << 24;
inline constexpr uint64_t kMostGltfIndices = uint64_t{1} << 26;
inline constexpr uint64_t kMostGltfPixels = uint64_t{1} << 28;

// Errors name the file and what in it is wrong ("model.glb: accessors[3].bufferView"), all of them. Files that
// it names are read only from its own folder and those below. Warnings: extensions that are not read, alpha
// blending, which is drawn masked or opaque.
Result<GltfFile> loadGltf(const std::filesystem::path&, Diagnostics& warnings);
// The same for bytes that are there already; the path names them, and its folder is where other files are sought.
Result<GltfFile> parseGltf(std::string_view bytes, const std::filesystem::path&, Diagnostics& warnings);

// A picture as the file has it, not decoded.
struct GltfPicture {
  std::string name;                     // what the file calls it, untrusted; may be empty
  std::string bytes;                    // PNG or JPEG by what the file says; empty where it has none
};
// images[0], [1], .. of a model, whether a material uses them or not. Errors as loadGltf().
Result<std::vector<GltfPicture>> gltfPictures(const std::filesystem::path&);

}  // namespace glint
