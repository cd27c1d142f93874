// glTF 2.0 files (.glb, .gltf) as meshes, transforms and materials. Everything in them is untrusted.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/compiled_material.h"
#include "renderer/scene.h"

namespace glint {

struct GltfTexture {
  std::shared_ptr<const Image8> image;  // null where the material has none
  int texCoord = 0;                     // 0 or 1
  Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
  Filter filter = Filter::Linear;
  glm::vec2 offset{0}, scale{1};        // KHR_texture_transform
  float rotation = 0;                   // radians
};

// The core metallic-roughness material, and KHR_materials_emissive_strength, _unlit is not read.
struct GltfMaterial {
  std::string name;
  glm::vec4 baseColorFactor{1};
  float metallicFactor = 1, roughnessFactor = 1, normalScale = 1, occlusionStrength = 1;
  glm::vec3 emissiveFactor{0};
  GltfTexture baseColor, metallicRoughness, normal, occlusion, emissive;
  enum class Alpha { Opaque, Mask, Blend } alpha = Alpha::Opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
};

struct GltfNode {
  MeshPtr mesh;                // one primitive
  glm::mat4 worldFromModel{1};
  int material = 0;            // index into GltfFile::materials
};

struct GltfFile {
  std::filesystem::path path;
  std::vector<GltfMaterial> materials;  // at least one; the last is glTF's default where one is needed
  std::vector<GltfNode> nodes;          // of the default scene
};

// Errors name the file and what in it is wrong. Warnings: extensions that are not read, blend drawn as opaque.
Result<GltfFile> loadGltf(const std::filesystem::path&, Diagnostics& warnings);

}  // namespace glint
