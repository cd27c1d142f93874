// Reading with a cap, writing without ever leaving half a file, and the user's folders.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "materials/base/diagnostic.h"

namespace glint {

// 1 GiB: no file that Glint reads is larger.
inline constexpr uint64_t kLargestFile = uint64_t{1} << 30;

// The whole of a regular file. Errors: missing, a folder, unreadable, larger than `cap` bytes.
Result<std::string> readFile(const std::filesystem::path&, uint64_t cap = kLargestFile);

// Writes beside the target and renames over it, so that a reader sees the old or the new file whole.
// Returns nothing, or why it failed; then the target is untouched.
Diagnostics writeFileAtomic(const std::filesystem::path&, std::string_view bytes);

// $XDG_CACHE_HOME/glint, $XDG_CONFIG_HOME/glint (~/.cache, ~/.config where unset). May not exist yet.
std::filesystem::path cacheFolder();
std::filesystem::path configFolder();

}  // namespace glint
