// The lights in the viewport's picture: their signs, and the handles that move, aim and size them. For a mesh only: each
// cell of a comparison is a scene of its own in the same lights, so they would stand there many times over, on top of the
// spheres that are to be compared, and most of them outside of the tight frame around each.
#pragma once

#include <imgui.h>

#include <optional>

#include "app/panels/light_drawing.h"

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
  struct Pointer {
    const HandleView& view;
    const SceneDepth* depth;
    glm::vec2 at;
    bool hovered;
  };
  std::optional<Hit> under(const std::vector<Light>&, int selected, const HandleView&, glm::vec2 pointer) const;
  void input(Editor&, const Pointer&, std::optional<Hit>& hit);
  void take(Editor&, const Hit&, const Pointer&);
  void drag(Editor&, const Pointer&);
  void cancel(Editor&);
  void keys(Editor&, const Pointer&);
  void heldKeys(Editor&);
  void drawAll(Editor&, const LightCanvas&, const std::optional<Hit>&) const;
  float aimOf(const Light&, size_t index, const HandleView&) const;
  std::string detailOf(const Light&, const Hit&) const;

  std::optional<Hit> held_;
  bool loose_ = false;        // without a button: begun by a key, ended by a click
  bool swallow_ = false;      // until the buttons are up they are nobody's
  Light start_;               // as it was taken
  glm::vec2 from_{0};
  float startAim_ = 0;
  bool moved_ = false;
  std::optional<glm::vec2> pressedBeside_;   // where nothing of a light is: a click there selects none
  // How far off the selected light's target was left by the last aiming.
  int aimLight_ = -1;
  float aim_ = 0;
};

}  // namespace glint
