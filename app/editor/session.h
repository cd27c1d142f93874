// What the editor remembers from one day to the next: layout, recent files, the window's size.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/base/json.h"

namespace glint {

struct Session {
  std::vector<std::string> recent;      // newest first, at most 10
  std::string folder;                   // of the last file dialog
  std::string environmentFolder;        // whose environments are offered
  Json layout;                          // Layout::toJson(); null: the standard one
  bool lightGizmos = true;              // lights are shown in the viewport
  int width = 1600, height = 960;       // of the window, in screen coordinates

  void addRecent(const std::filesystem::path&);
  // A missing or damaged file gives the defaults.
  static Session read(const std::filesystem::path& file);
  Diagnostics write(const std::filesystem::path& file) const;
};

}  // namespace glint
