// What Glint derives from a model's own f and D for a setting of its parameters, and shaders look up by cosine and
// roughness (shaders/common/model_tables.glsl):
//
// - the areas that the facets of its D show towards a direction, which are Smith's masking for that D (Heitz 2014,
//   eq. 14): for the terms V_Smith and V_SmithCorrelated;
// - the light that a single bounce loses, and the average reflectance of the facets: what compensation adds (Kulla and
//   Conty 2017).
//
// Made at first use, kept on disk by content. Needs a current context.
#pragma once

#include <span>
#include <vector>

#include "renderer/model_setting.h"
#include "renderer/progress.h"
#include "renderer/recently_used.h"

namespace glint {

// Where the columns and rows of a table stand: from 0 to 1, closer together where they are small.
std::vector<double> tableCosines(int count);
std::vector<double> tableRoughnesses(int count);  // count - 1 is a multiple of 30

// For each roughness and cosine, by azimuth, roughness and cosine: the projected area less the cosine.
struct ProjectedAreaTable {
  static constexpr int kCosines = 97, kRoughnesses = 121, kLayers = 9;
  int layers = 1;                        // by cos^2 of the azimuth, from 0 to 1; 1 when D is the same all around
  std::vector<float> excess;
};
// Errors: GLSL that does not compile, at the plugin's own lines.
Result<ProjectedAreaTable> projectedAreas(const ModelSetting&);

// What a single bounce off facets that reflect all loses, 1 - E, by lighting (lights, then an environment), layer, roughness
// and cosine; 0 where a model gains. E is the largest channel's: what the others lose beyond it is taken up by the model's
// own colour, not lost to roughness. A specular() that does not follow F0 cannot be asked for white facets: nothing is known
// to be lost.
struct LossTable {
  static constexpr int kCosines = 97, kRoughnesses = 61, kLayers = 25;
  // By azimuth from the tangent (the first) to the bitangent, even in glintAcross() of shaders/common/model_tables.glsl. 1
  // when the model loses the same all around. All quarters are taken as one: its lobe mirrors in both axes.
  int layers = 1;
  int rows = kRoughnesses;  // 1 for a model that does not read the roughness
  std::vector<float> losses;
  // For each roughness, under lights and then under an environment, a scale on F0 and a bias: the reflectance of the
  // facets averaged over what a single bounce sends back; w of the scale is the loss of uniform light, w of the bias
  // ModelIntegrals::aspects().
  std::vector<glm::vec4> reflectances;
};
// Errors: as projectedAreas().
Result<LossTable> losses(const ModelSetting&);

class ModelTables {
 public:
  explicit ModelTables(bool diskCache = true) : diskCache_(diskCache) {}

  void setProgress(Progress progress) { progress_ = std::move(progress); }

  // Sets the setting's parameters in a program that holds its model's GLSL, and binds the tables that the program looks
  // into. Building them changes which program is in use and the shader storage. Errors: as projectedAreas().
  Diagnostics apply(const ModelSetting&, const gl::Program&);

  // Between frames: keeps the tables of the last one, and a few more.
  void forgetUnused();

 private:
  struct LossTextures {
    gl::Texture losses, reflectances;
  };
  Result<GLuint> areas(const ModelSetting&);
  Result<const LossTextures*> bounces(const ModelSetting&);

  bool diskCache_;
  Progress progress_;
  RecentlyUsed<gl::Texture> areas_;
  RecentlyUsed<LossTextures> bounces_;
};

}  // namespace glint
