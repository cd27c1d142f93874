// What an environment needs to light the models: its cube map, its diffuse light as spherical harmonics, and, for
// each model with each set of its constants, the environment averaged under that model's own lobe and the model's
// environment BRDF. Built on first use from the model's own GLSL, kept on disk by content.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "renderer/gl/objects.h"
#include "renderer/model_setting.h"
#include "renderer/model_tables.h"
#include "renderer/program_cache.h"
#include "renderer/progress.h"
#include "renderer/recently_used.h"
#include "renderer/rectangles.h"
#include "renderer/scene.h"

namespace glint {

// The specular part without a coat, or the coat (model.h).
enum class Lobe { Base, Coat };
// Of programs that hold a model, for which of its lobes is its modelLobe().
std::vector<std::string> definesOf(Lobe);

// Coarse ones take an eighth of the time and show a little noise and blur: for a first picture. They are made only of
// what is not at hand, and never kept on disk.
enum class TableQuality { Fine, Coarse };

struct EnvironmentMaps {
  gl::Texture cube;                      // RGBA16F with a full mip chain
  int size = 0;                          // texels along a side of level 0
  // Both maps hold radiance times this: 1, unless the brightest is more than half a float holds well.
  float scale = 1;
  // The diffuse light (environment_irradiance.h), in a cube where harmonics are too far off; none otherwise.
  gl::Buffer harmonics;                  // of shaders/passes/lighting.frag
  gl::Texture irradianceCube;
};

// The direction of a point of a cube map's face, from 0 to 1 both ways: as cubeDirection() of shaders/common/cube.glsl.
glm::vec3 cubeDirection(int face, glm::vec2);

// How wide a model's lobes are, for who draws directions from them (shaders/common/reference.glsl).
struct LobeWidths;

class EnvironmentLighting {
 public:
  // Levels of the prefiltered cube: sizes 256, 128, .. 8 for roughness 0 .. 1 (levelRoughness).
  static constexpr int kSize = 256, kLevels = 6, kBrdfSize = 64;
  // The roughness whose lobe fills a level: inverse of (kLevels - 1) r (1.7 - 0.7 r) in lighting.frag.
  static float levelRoughness(int level);
  // Where the one lobe of a model stands that does not read the roughness: with texels of 0.7 degrees.
  static constexpr int kOwnLobeLevel = 1;
  // Directions drawn for each texel of a level at the standard quality: rough levels have few texels and can afford
  // many.
  static int levelSamples(int level);

  EnvironmentLighting(ProgramCache&, const Rectangles&, bool diskCache);

  void setProgress(Progress);
  // What programs look up of the models themselves.
  ModelTables& tables() { return tables_; }

  // Makes one of the tables that were coarse since the last forgetUnused() fine; false when there is none.
  bool refineOne();
  size_t coarseCount() const { return coarse_.size(); }

  // Between frames: keeps the maps and tables of the last one, and a few more to go back and forth between. Building
  // them again is only a matter of reading them from disk.
  void forgetUnused();
  // How many prefiltered cubes (4 MB each) are kept.
  size_t cubes() const { return prefiltered_.size(); }

  const EnvironmentMaps& maps(const EnvironmentPtr&);
  // A cube that is black (0) or white (1) all over, and EnvironmentMaps::harmonics of white light from all sides.
  GLuint uniformCube(int value);
  GLuint whiteIrradiance();
  // The model's lobe over the environment (cube), and its environment BRDF (2D, linear filter, clamped). An error
  // is the model's GLSL not compiling.
  Result<GLuint> prefiltered(const EnvironmentPtr&, const ModelSetting&, Lobe = Lobe::Base, TableQuality = TableQuality::Fine);
  struct BrdfTable {
    GLuint texture = 0;
    bool colored = false;  // three tables, see environmentBrdfAt() in lighting.frag; a coat's always is
  };
  Result<BrdfTable> brdf(const ModelSetting&, Lobe = Lobe::Base, TableQuality = TableQuality::Fine);
  // How many values of the tables made for a setting were not finite (or beyond what a half can hold) and are 0 instead.
  struct Invalid {
    int brdf = 0, lobe = 0;
  };
  Invalid invalid(const ModelSetting&) const;

  // The lobe's values over the angle (lobe.h), one row for each level; of a model that uses the tangent, along the
  // direction in which it is narrowest.
  Result<std::vector<std::vector<float>>> lobe(const ModelSetting&, Lobe = Lobe::Base);
  // By how much the lobe of a model that uses the tangent is wider than that, as slopes of the half vector along the
  // tangent and the bitangent.
  const std::array<glm::vec2, kLevels>& stretch(const ModelSetting&);
  // Kept. An error is the model's GLSL not compiling. Lives until the next call.
  Result<const LobeWidths*> widths(const ModelSetting&);
  // Builds the prefiltered cube anew with samples[level] directions a texel, past every cache.
  Result<gl::Texture> prefilter(const EnvironmentPtr&, const ModelSetting&, const std::array<int, kLevels>& samples, Lobe = Lobe::Base);

 private:
  // What prefilter() draws its samples from, for lobes of some width: the environment without its spots, which it adds by
  // themselves.
  enum class Spots { None, Small, Large };
  struct Rest {
    gl::Texture cube;      // none: there are no spots
    int size = 0;
    gl::Buffer spots;      // of shaders/passes/prefilter.frag
    int spotCount = 0;
  };
  const Rest& rest(const EnvironmentPtr&, Spots);
  // With a full mip chain, in units of `scale`.
  gl::Texture drawCube(const ImageF& equirect, int size, float scale, const std::string& name);

  ProgramCache& programs_;
  const Rectangles& rectangles_;
  bool diskCache_;
  Progress progress_;
  ModelTables tables_;
  // Of everything that is made from a model alone; another than its own for what is coarse.
  static uint64_t keyOf(const ModelSetting&, Lobe = Lobe::Base);
  static constexpr uint64_t kCoarseKey = 0x9e3779b97f4a7c15;
  gl::Texture storedCube(const EnvironmentPtr&, uint64_t key);   // none: it is not on disk
  gl::Texture blackCube_, whiteCube_;
  gl::Buffer whiteHarmonics_;
  RecentlyUsed<EnvironmentMaps> maps_;
  RecentlyUsed<Rest> rests_;
  struct StoredBrdf {
    gl::Texture texture;
    bool colored = false;
  };
  // Three tables of RGBA halfs, `size` texels along a side, one after the other: scale, bias, diffuse.
  Result<std::string> drawBrdf(const ModelSetting&, Lobe, int size);
  struct Coarse {
    EnvironmentPtr environment;   // null: the environment BRDF
    ModelSetting setting;
    Lobe lobe = Lobe::Base;
  };
  std::vector<Coarse> coarse_;    // used since the last forgetUnused()
  RecentlyUsed<gl::Texture> prefiltered_;
  RecentlyUsed<StoredBrdf> brdf_;
  std::unordered_map<uint64_t, Invalid> invalid_;  // by setting; only those that have any
  std::unordered_map<uint64_t, std::array<glm::vec2, kLevels>> stretches_;  // by setting; of models that use the tangent
  std::unordered_map<uint64_t, std::unique_ptr<LobeWidths>> widths_;        // by setting
};

// By level: the root of the slope of the half vector within which half of a lobe lies, which is alpha for GGX.
struct LobeWidths {
  std::array<float, EnvironmentLighting::kLevels> base{}, coat{};
  std::array<glm::vec2, EnvironmentLighting::kLevels> stretch{};

  void apply(const gl::Program&) const;
};

}  // namespace glint
