// Results that took long, kept in the cache folder by the hash of everything they were made from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace glint {

// The bytes stored under a kind ("prefiltered") and key, when they are there and sound.
std::optional<std::string> readCache(const std::string& kind, uint64_t key);
// Stores them; a failure to write is silent, the cache is only for speed. Old entries go when the folder grows over
// kLargestCache bytes.
void writeCache(const std::string& kind, uint64_t key, const std::string& bytes);
inline constexpr uint64_t kLargestCache = uint64_t{512} << 20;

}  // namespace glint
