// What the graph compiler hands to the renderer: GLSL and how to feed it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "materials/value.h"

namespace glint {

enum class ColorSpace { sRGB, Linear };  // sRGB: a colour, decoded at load; Linear: data
enum class Wrap { Repeat, Clamp, Mirror };
enum class Filter { Linear, Nearest };

// One texture that the material samples, bound as `layout(binding = kFirstMaterialTexture + index)`.
struct TextureSlot {
  std::string sampler;   // the GLSL name
  std::string node;      // id of the node it came from
  std::string place;     // of that node, for diagnostics: "FILE:LINE: node 'n'"
  std::string file;      // absolute path or a "gltf:..." name that the scene resolves; may be empty (white)
  ColorSpace colorSpace = ColorSpace::sRGB;
  Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
  Filter filter = Filter::Linear;
  // Holds normals and is read for nothing else: its alpha may be used for their variance (renderer/normal_variance.h).
  bool normals = false;
  bool operator==(const TextureSlot&) const = default;
};
inline constexpr int kFirstMaterialTexture = 8;
inline constexpr int kMostMaterialTextures = 16;

// One member of the std140 block `MaterialParameters` (binding kMaterialParametersBinding).
struct UniformField {
  std::string name;      // as the user sees it: the parameter's name
  std::string node;      // id of the node it came from
  Value value;           // the current value
  float minimum = 0, maximum = 1;
  int offset = 0;        // bytes
};
inline constexpr int kMaterialParametersBinding = 1;
// Ids of the nodes that overrideAttribute() (graph_compile.h) puts into a graph start with this.
inline constexpr std::string_view kOverridePrefix = "override-";

// Where one of the model's parameters comes from, in the order of ShadingModel::parameters.
struct ModelParameterSource {
  std::string name;
  Value value;           // when it is constant
  int uniform = -1;      // index into uniforms, whose value it is over the whole surface
  bool varies = false;   // computed per pixel; then `value` is the model's default
};

// How much the compiler did: `glint compile --stats`.
struct CompileStats {
  int nodes = 0;         // in the document and, as often as they are called, in its functions
  int statements = 0;    // that were left
  int folded = 0, shared = 0, pruned = 0;
  double milliseconds = 0;
};

struct CompiledMaterial {
  std::string name;
  std::string model;     // id of the shading model it asks for
  // Declares the block and samplers and defines
  //   void evaluateMaterial(in MaterialInputs i, inout MaterialAttributes m)
  // for the structs of shaders/common/material.glsl, which writes every member of `m` but `model`; of that, only
  // what the graph sets: the caller puts the model's standardSlots() there before, and 0 into `normalVariance`, which
  // is written where a normal map is averaged. Deterministic: the same graph, the same text.
  std::string glsl;
  uint64_t hash = 0;     // of glsl: programs are shared by it
  std::vector<UniformField> uniforms;
  int blockSize = 0;     // bytes of the std140 block, 0 when it has no uniforms
  std::vector<TextureSlot> textures;
  // What the graph can make differ from the standard: the renderer drops what is not used.
  bool writesEmissive = false, writesOpacityMask = false, writesNormal = false,
       writesModelParameters = false;
  bool plainNonmetal = false;  // metallic and specular are left alone
  std::vector<ModelParameterSource> modelParameters;
  CompileStats stats;

  // The block as bytes, from the uniforms' current values.
  std::vector<std::byte> block() const;
  UniformField* uniform(std::string_view wanted);  // null when there is none of that name
  // The model's parameters as they are now; where one varies over the surface, its default.
  std::vector<Value> modelParameterValues() const;
};

}  // namespace glint
