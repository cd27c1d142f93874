// A plot in the editor's window: drawn, pointed at, moved and enlarged.
#pragma once

#include <imgui.h>

#include <memory>
#include <set>
#include <vector>

#include "app/analysis/plot_layout.h"
#include "app/analysis/plot_reading.h"
#include "renderer/gl/objects.h"

namespace glint {

class PlotCanvas {
 public:
  // Fills the rectangle. `data` is the same object for as long as it is the same plot. A click on an entry of the legend
  // hides its model or shows it again: `hidden` is changed.
  void draw(const std::shared_ptr<const PlotData>& data, ImVec2 low, ImVec2 size, std::set<size_t>& hidden);

  void showAll() { x_.reset(), y_.reset(); }    // of the axes

 private:
  void layOut();
  void paint(ImVec2 low);
  void legend(ImVec2 low, std::set<size_t>& hidden);
  void navigate(ImVec2 low);
  void read(ImVec2 low, const std::set<size_t>& hidden);

  std::shared_ptr<const PlotData> data_;
  PlotView view_;
  PlotDrawing drawing_;
  std::vector<gl::Texture> textures_;           // of the drawing's bitmaps, in their order
  std::optional<PlotAxis> x_, y_;
  PlotFrame held_;                              // what is being moved, as it was when it was taken hold of
};

}  // namespace glint
