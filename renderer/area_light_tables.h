// Linearly transformed cosines (Heitz, Dupuy, Hill and Neubelt 2016) for any model: for each roughness and view the matrix
// that turns a cosine lobe into the model's, so that the light of a shape through the lobe is its light through a cosine
// (shaders/common/linearly_transformed_cosines.glsl). Fitted from the model's own f, and kept on disk by content. Needs a
// current context.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/environment_lighting.h"
#include "renderer/model_setting.h"
#include "renderer/program_cache.h"

namespace glint {

class AreaLightTables {
 public:
  // Columns stand at NoV = 1 - x^2 for x from 0 to 1, rows at roughness 0 to 1.
  static constexpr int kViews = 24, kRoughnesses = 32;

  AreaLightTables(ProgramCache& programs, const Rectangles& rectangles, ModelTables& tables, bool diskCache)
      : programs_(programs), rectangles_(rectangles), tables_(tables), diskCache_(diskCache) {}

  // Three layers of RGBA32F: of the inverse matrix, divided by its middle, the entries xx, xz, zx and zz; then what is sent
  // on, as scale on F0 and bias. Three more for a coat. Errors: the model's GLSL does not compile.
  Result<GLuint> of(const ModelSetting&);
  void forgetUnused() { kept_.nextFrame(8); }

 private:
  Result<std::vector<glm::vec4>> make(const ModelSetting&, Lobe);

  ProgramCache& programs_;
  const Rectangles& rectangles_;
  ModelTables& tables_;
  bool diskCache_;
  RecentlyUsed<gl::Texture> kept_;
};

}  // namespace glint
