// The lights in the viewport's picture: their signs, and the handles that move, aim and size them. For a mesh only: each
// cell of a comparison is a scene of its own in the same lights, so they would stand there many times over, on top of the
// spheres that are to be compared, and most of them outside of the tight frame around each.
#pragma once

#include <imgui.h>

#include <optional>

#include "app/editor/light_handles.h"

namespace glint {

class Editor;

class LightGizmos {
 public:
  // After the viewport's own item, whose top left is `low`: the pointer's and the keys' business with lights, and then
  // their drawing. True when the pointer is theirs.
  bool draw(Editor&, ImVec2 low, ImVec2 size, bool hovered);

 private:
  struct Hit {
    size_t light = 0;
    LightGrip grip = LightGrip::Move;
    bool edge = false;        // the sign on the picture's edge of a light outside it
  };
  std::optional<Hit> under(const std::vector<Light>&, int selected, const HandleView&, glm::vec2 pointer) const;
  void press(Editor&, const std::vector<Light>&, const Hit&, glm::vec2 pointer);
  void drag(Editor&, const HandleView&, glm::vec2 pointer);
  static void keys(Editor&, const HandleView&, bool hovered);

  std::optional<Hit> held_;
  Light start_;               // as it was taken
  glm::vec2 from_{0};
  bool moved_ = false;
  std::optional<glm::vec2> pressedBeside_;   // where nothing of a light is: a click there selects none
};

}  // namespace glint
