// What a crash would otherwise take: after each step the whole document goes to the end of a file that this process
// keeps locked, and the next start offers what it finds unlocked.
#pragma once

#include <chrono>
#include <filesystem>
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
    std::vector<std::string> named;   // files outside the document's folder that the user chose
    std::filesystem::path journal;
    std::chrono::system_clock::time_point time;   // of the last step
  };

  // An empty folder keeps no journal.
  explicit Journal(std::filesystem::path folder);
  ~Journal();                // what was not cleared stays, to be found
  Journal(const Journal&) = delete;

  // Appends a record; the file is begun again when it passes 16 MiB. A disk that cannot be written is reported once.
  Diagnostics append(const Record&);
  void clear();              // nothing is unsaved

  // The last whole record of every journal whose process has ended, newest first. Damaged tails are skipped; a journal
  // without one whole record is put aside as FILE.damaged, with a warning.
  static std::vector<Record> found(const std::filesystem::path& folder, Diagnostics& warnings);
  static void discard(const std::filesystem::path& journal);

 private:
  bool begin();
  bool write(const std::string&);
  void close();

  std::filesystem::path folder_, file_;
  int handle_ = -1;          // holds the lock
  uint64_t written_ = 0;
  bool failed_ = false;
};

}  // namespace glint
