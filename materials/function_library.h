// Functions and layers that graphs call: those Glint ships and those beside a material.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "materials/graph.h"

namespace glint {

using MaterialPtr = std::shared_ptr<const Material>;

// Reads each document once, again when its file changed. Safe to use from several threads.
class FunctionLibrary {
 public:
  // `name` is a shipped function ("layer-rust") or a file relative to `folder`, where it must stay. Errors:
  // unknown (names the nearest), outside the folder, faults of the file, a document that is no function.
  Result<MaterialPtr> find(const std::string& name, const std::filesystem::path& folder) const;
  // Names of the shipped ones, sorted.
  std::vector<std::string> names() const;
  // Adds or replaces one that is not on disk: an editor's unsaved function, or a test's.
  void put(const std::string& name, Material);

 private:
  struct Entry {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    std::shared_ptr<const Result<MaterialPtr>> result;
  };
  mutable std::mutex mutex_;
  mutable std::map<std::string, Entry> entries_;
  std::map<std::string, MaterialPtr, std::less<>> given_;
};

// What a function takes and gives, from its function-input and function-output nodes, ordered by their
// "order" setting, then by name. The node whose pin it is comes with each.
struct FunctionSignature {
  struct Port {
    NodeId node;
    std::string name, doc;
    ValueType type = ValueType::Float;
    Value standard;
    std::string surface;  // instead of `standard`, as in Pin
    float minimum = 0, maximum = 1;
  };
  std::vector<Port> inputs, outputs;
};
FunctionSignature signatureOf(const Material&);

}  // namespace glint
