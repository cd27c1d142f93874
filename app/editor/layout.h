// Panels side by side: a tree of splits whose leaves hold tabs. The user drags the bars, drags a tab to another place,
// and finds it all again the next day.
#pragma once

#include <imgui.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "materials/base/json.h"

namespace glint {

class Layout {
 public:
  struct Node {
    // A leaf holds panels by their titles; a split holds two nodes, `first` left of or above `second`.
    std::vector<std::string> panels;
    int active = 0;
    bool stacked = false;       // above one another, else side by side
    float ratio = 0.5f;         // of `first`, 0.05..0.95
    std::unique_ptr<Node> first, second;
    bool leaf() const { return !first; }
  };

  Layout();                                 // the arrangement that Glint starts with
  static std::unique_ptr<Node> standard();

  // Draws every leaf in the rectangle; `drawPanel` fills the active one's content.
  void draw(ImVec2 low, ImVec2 high, const std::function<void(const std::string& title)>& drawPanel);

  bool shown(const std::string& panel) const;   // has a tab somewhere
  bool visible(const std::string& panel) const; // and is the active one
  void show(const std::string& panel);          // makes it the active tab, adding it when absent
  void hide(const std::string& panel);
  void reset() { root_ = standard(); }

  // A small sign on a panel's tab ("3"); empty removes it.
  void setBadge(const std::string& panel, const std::string& badge);

  Json toJson() const;
  // Panels that are not in `known` are dropped, damaged parts fall back to the standard arrangement.
  void fromJson(const Json&, const std::vector<std::string>& known);

  // Changes by the user since the last call, for saving.
  bool takeChanged() { return std::exchange(changed_, false); }

 private:
  enum class Side { Center, Left, Right, Top, Bottom };
  void drawNode(Node&, ImVec2 low, ImVec2 high, const std::function<void(const std::string&)>&);
  void drawLeaf(Node&, ImVec2 low, ImVec2 high, const std::function<void(const std::string&)>&);
  void drawTabs(Node&, ImVec2 low, float width, float strip);
  void drawTab(Node&, int index, ImVec2 low, ImVec2 high);
  float tabWidth(const std::string& panel) const;
  std::string badgeOf(const std::string& panel) const;
  void place(const std::string& panel, Node& target, Side);
  void prune();

  std::unique_ptr<Node> root_;
  std::vector<std::pair<std::string, std::string>> badges_;
  std::string dragged_;
  // A drop, done after the tree has been walked.
  std::string dropPanel_;
  Node* dropTarget_ = nullptr;
  Side dropSide_ = Side::Center;
  std::string hide_;
  int splitterId_ = 0, leafId_ = 0;
  bool changed_ = false;
};

}  // namespace glint
