// The titles of a comparison's rows in the viewport, each with its model's badge and a menu.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "app/editor/render_thread.h"

namespace glint {

class Editor;

class RowLabels {
 public:
  // Into the current window; `low` is where the picture's top left is.
  void draw(Editor&, const FrameResult&, ImVec2 low);
  // After the viewport's own item: the pointer's business with the labels. True when a click was theirs.
  bool control(Editor&, bool hovered);

 private:
  void menu(Editor&);

  struct Label {
    ImVec2 low, high;
    RowInfo row;
    bool own = false;
  };
  std::vector<Label> labels_;
  std::string held_;       // the row on whose label a button went down
  Label chosen_;           // whose menu is open
  bool cardWanted_ = false;
};

}  // namespace glint
