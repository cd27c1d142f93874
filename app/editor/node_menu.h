// The list of all kinds of node with a search field, opened where a node is wanted.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "materials/node_registry.h"

namespace glint {

class NodeMenu {
 public:
  // `fits` limits the list to kinds that something can be connected to.
  void open(std::function<bool(const NodeKind&)> fits = {});
  bool isOpen() const { return open_; }
  // Draws it while it is open; the chosen kind, or null.
  const NodeKind* draw(const NodeRegistry&);

 private:
  std::function<bool(const NodeKind&)> fits_;
  std::string search_;
  int at_ = 0;
  bool open_ = false, appearing_ = false;
};

}  // namespace glint
