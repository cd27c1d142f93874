#include "materials/base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace glint {
namespace fs = std::filesystem;

Result<std::string> readFile(const fs::path& path, uint64_t cap) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) return error(path.string(), "no such file", "check the path");
  if (fs::is_directory(status)) return error(path.string(), "is a folder", "name a file");
  if (!fs::is_regular_file(status)) return error(path.string(), "is not a regular file", "name a file");
  const uint64_t size = fs::file_size(path, code);
  if (code) return error(path.string(), "cannot be read: " + code.message(), "check the path and its permissions");
  if (size > cap)
    return error(path.string(), fmt::format("is {} bytes long", size),
                 fmt::format("at most {} are read", cap));
  std::ifstream in(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (!in || !in.read(bytes.data(), static_cast<std::streamsize>(size)))
    return error(path.string(), "cannot be read", "check its permissions");
  return bytes;
}

Diagnostics writeFileAtomic(const fs::path& path, std::string_view bytes) {
  static std::atomic<unsigned> serial{0};
  const fs::path temporary = path.parent_path() / fmt::format(".{}.{}.{}", path.filename().string(),
                                                              ::getpid(), serial++);
  const auto failed = [&](const char* step) {
    const std::string reason = std::strerror(errno);
    ::unlink(temporary.c_str());
    return Diagnostics{error(path.string(), fmt::format("cannot be written: {}: {}", step, reason),
                             "check that the folder exists and is writable")};
  };
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0) return failed("create");
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int reason = errno;
      ::close(file);
      errno = reason;
      return failed("write");
    }
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  if (::fsync(file) != 0 || ::close(file) != 0) return failed("flush");
  if (::rename(temporary.c_str(), path.c_str()) != 0) return failed("rename");
  return {};
}

namespace {

fs::path userFolder(const char* variable, const char* fallback) {
  if (const char* folder = std::getenv(variable); folder && *folder) return fs::path(folder) / "glint";
  const char* home = std::getenv("HOME");
  return fs::path(home && *home ? home : "/tmp") / fallback / "glint";
}

}  // namespace

fs::path cacheFolder() { return userFolder("XDG_CACHE_HOME", ".cache"); }
fs::path configFolder() { return userFolder("XDG_CONFIG_HOME", ".config"); }

}  // namespace glint
