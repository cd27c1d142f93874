// Every kind of node there is: the files of shaders/nodes/ and those in C++.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "materials/node.h"

namespace glint {

class NodeRegistry {
 public:
  NodeRegistry();  // the shipped ones
  // Those in C++ and these instead of the shipped files: name and text of each.
  explicit NodeRegistry(std::span<const std::pair<std::string, std::string>> files);

  const NodeKind* find(std::string_view id) const;  // null when unknown
  std::vector<const NodeKind*> all() const;         // sorted by category, then title
  std::vector<std::string> ids() const;             // sorted
  const Diagnostics& problems() const { return problems_; }
  // A file of shaders/nodes/lib/ by its name in "includes"; null when unknown.
  const std::string* include(std::string_view name) const;
  // The pins of a data kind, shared by all its nodes.
  NodePinsPtr pins(const NodeKind&) const;

 private:
  void add(NodeKind);
  void addFile(const std::string& file, const std::string& text);

  struct Entry {
    NodeKind kind;
    NodePinsPtr pins;
  };
  std::map<std::string, Entry, std::less<>> kinds_;
  std::map<std::string, std::string, std::less<>> includes_;
  Diagnostics problems_;
};

}  // namespace glint
