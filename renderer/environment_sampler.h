// Directions drawn in proportion to an environment's light, for shaders/common/reference_environment.glsl: the picture as
// it is, and the shares of its cells, which are its pixels. Needs a current context.
#pragma once

#include <vector>

#include "renderer/gl/objects.h"
#include "renderer/image.h"

namespace glint {

class EnvironmentSampler {
 public:
  // Of an equirectangular picture of 3 channels, finite and non-negative.
  explicit EnvironmentSampler(const ImageF&);

  void bind() const;   // at the shader's units

  // The texels of the environment, and shares of cells before each: of a row for each row, and of all for the rows.
  // A cell's share is that of the light that a bilinear lookup finds in it, so that no light is where none is drawn.
  struct Shares {
    int width = 0, height = 0;
    std::vector<float> columns;   // (width + 1) x height
    std::vector<float> rows;      // height + 1
  };
  static Shares sharesOf(const ImageF&);

 private:
  gl::Texture radiance_, columns_, rows_;
};

}  // namespace glint
