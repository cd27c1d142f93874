#include "shaders/shipped_files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

namespace glint::shipped {
namespace {

struct Embedded {
  const char* path;
  const char* begin;
  const char* end;
};
#include "embedded_files.inc"

std::filesystem::path root() {
  if (const char* folder = std::getenv("GLINT_DATA_DIR"); folder && *folder) return folder;
  return GLINT_SOURCE_DIR;
}

}  // namespace

std::filesystem::path onDisk(std::string_view path) {
  std::filesystem::path file = root() / path;
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) ? file : std::filesystem::path();
}

std::optional<std::string> read(std::string_view path) {
  if (const auto file = onDisk(path); !file.empty()) {
    std::ifstream in(file, std::ios::binary);
    if (in) return std::string(std::istreambuf_iterator<char>(in), {});
  }
  for (const Embedded& e : kEmbedded)
    if (path == e.path) return std::string(e.begin, e.end);
  return std::nullopt;
}

std::vector<std::string> list(std::string_view folder, std::string_view extension) {
  std::set<std::string> found;
  const auto wanted = [&](std::string_view path) {
    return path.size() > folder.size() + 1 && path.substr(0, folder.size()) == folder &&
           path[folder.size()] == '/' && path.find('/', folder.size() + 1) == path.npos &&
           path.ends_with(extension);
  };
  // The tree on disk, when there is one, is the whole truth: a file deleted there is gone.
  std::error_code error;
  std::filesystem::directory_iterator files(root() / folder, error);
  if (!error) {
    for (const auto& entry : files) {
      const std::string path = std::string(folder) + '/' + entry.path().filename().string();
      if (wanted(path)) found.insert(path);
    }
  } else {
    for (const Embedded& e : kEmbedded)
      if (wanted(e.path)) found.insert(e.path);
  }
  return {found.begin(), found.end()};
}

}  // namespace glint::shipped
