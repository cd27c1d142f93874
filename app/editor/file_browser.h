// The dialog that asks for a file, drawn by the editor itself so that it looks and works the same everywhere.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace glint {

class FileBrowser {
 public:
  struct Request {
    std::string title;                         // "Open a material"
    bool saving = false;                       // asks for a name, and before it overwrites
    std::vector<std::string> extensions;       // ".json": others are not listed; empty lists all
    std::string name;                          // suggested, when saving
    std::function<void(const std::filesystem::path&)> chosen;
  };

  void open(Request);
  bool isOpen() const { return open_; }
  // Once a frame, outside of all windows.
  void draw();

  const std::filesystem::path& folder() const { return folder_; }
  void setFolder(const std::filesystem::path&);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    uintmax_t size = 0;
  };
  void list();
  void choose(const std::filesystem::path&);

  Request request_;
  std::filesystem::path folder_ = std::filesystem::current_path();
  std::vector<Entry> entries_;
  std::string name_, filter_, path_, problem_;
  std::filesystem::path overwrite_;
  bool open_ = false, appearing_ = false;
};

}  // namespace glint
