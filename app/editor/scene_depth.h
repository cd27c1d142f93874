// How far off the surfaces of a picture are, pixel by pixel: what is behind them, and what the pointer is on.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/handle_view.h"

namespace glint {

class SceneDepth {
 public:
  // As Renderer::depths() gives them.
  SceneDepth(glm::ivec2 size, std::vector<float> metres);

  // Whether a surface stands before this point; never where the picture ends. `view` is the same picture's, at any size.
  bool hides(const HandleView& view, glm::vec3 point) const;
  struct Surface {
    glm::vec3 at, normal;   // towards the eye
  };
  // What is seen there; nothing where that is the background.
  std::optional<Surface> under(const HandleView& view, glm::vec2 pixel) const;

 private:
  std::optional<float> at(glm::ivec2 texel) const;
  glm::ivec2 texelOf(const HandleView&, glm::vec2 pixel) const;

  glm::ivec2 size_;
  std::vector<float> metres_;
};

}  // namespace glint
