#include "renderer/disk_cache.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "materials/base/files.h"
#include "materials/base/hash.h"

namespace glint {
namespace fs = std::filesystem;
namespace {

fs::path fileOf(const std::string& kind, uint64_t key) { return cacheFolder() / (kind + "-" + hashName(key)); }

void prune() {
  struct Entry {
    fs::path path;
    fs::file_time_type time;
    uint64_t size;
  };
  std::vector<Entry> entries;
  uint64_t total = 0;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(cacheFolder(), error)) {
    if (!file.is_regular_file(error)) continue;
    entries.push_back({file.path(), file.last_write_time(error), file.file_size(error)});
    total += entries.back().size;
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.time < b.time; });
  for (const Entry& entry : entries) {
    if (total <= kLargestCache) break;
    total -= entry.size;
    fs::remove(entry.path, error);
  }
}

}  // namespace

std::optional<std::string> readCache(const std::string& kind, uint64_t key) {
  auto bytes = readFile(fileOf(kind, key));
  if (!bytes || bytes->size() < 8) return std::nullopt;
  uint64_t checksum;
  std::memcpy(&checksum, bytes->data(), 8);
  std::string body = bytes->substr(8);
  if (checksum != hashText(body)) return std::nullopt;
  return body;
}

void writeCache(const std::string& kind, uint64_t key, const std::string& bytes) {
  std::error_code error;
  fs::create_directories(cacheFolder(), error);
  std::string whole(8, '\0');
  const uint64_t checksum = hashText(bytes);
  std::memcpy(whole.data(), &checksum, 8);
  whole += bytes;
  (void)writeFileAtomic(fileOf(kind, key), whole);
  prune();
}

}  // namespace glint
