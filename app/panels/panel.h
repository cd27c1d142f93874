// A part of the editor's window: one file here and one line in table.cpp.
#pragma once

#include <memory>
#include <span>

namespace glint {

class Editor;

class Panel {
 public:
  virtual ~Panel() = default;
  // Fills the current ImGui window, whose padding is zero: see PanelBody for the usual margins.
  virtual void draw(Editor&) = 0;
};

struct PanelInfo {
  const char* title;                    // its tab, its entry in the View menu, its name in layouts
  std::unique_ptr<Panel> (*make)();
};
std::span<const PanelInfo> panelTable();

// The scrolling, padded inside of most panels, for as long as it lives.
class PanelBody {
 public:
  PanelBody();
  ~PanelBody();
};

}  // namespace glint
