#include "materials/base/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace glint {

uint64_t hashBytes(const void* data, size_t size, uint64_t seed) {
  return XXH3_64bits_withSeed(data, size, seed);
}

std::string hashName(uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace glint
