// What a crash would otherwise take: after each step the whole document goes to the end of a file of this process, and
// the next start offers what it finds there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"

namespace glint {

class Journal {
 public:
  struct Record {
    std::string file;        // of the document; empty when it was never saved
    std::string name;        // of the material
    std::string label;       // of the last step
    int steps = 0;           // since the last save
    std::string material;    // materialText()
    std::string preview;     // previewJson() as text
    std::filesystem::path journal;
  };

  // An empty folder keeps no journal.
  explicit Journal(std::filesystem::path folder);
  ~Journal();                // a journal that was cleared leaves no file
  Journal(const Journal&) = delete;

  // Appends a record; the file is begun again when it passes 16 MiB. A disk that cannot be written is reported once.
  Diagnostics append(const Record&);
  void clear();              // nothing is unsaved

  // The last whole record of every journal whose process has ended, newest first. Damaged tails are skipped.
  static std::vector<Record> found(const std::filesystem::path& folder);
  static void discard(const std::filesystem::path& journal);

 private:
  std::filesystem::path folder_, file_;
  bool failed_ = false;
};

}  // namespace glint
