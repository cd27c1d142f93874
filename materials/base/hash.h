// Content hashes, for caches and for what a picture says of its inputs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace glint {

// XXH3, 64 bits: the same on every machine. Not for secrets.
uint64_t hashBytes(const void* data, size_t size, uint64_t seed = 0);
inline uint64_t hashText(std::string_view text, uint64_t seed = 0) {
  return hashBytes(text.data(), text.size(), seed);
}
std::string hashName(uint64_t hash);  // 16 hexadecimal digits

}  // namespace glint
