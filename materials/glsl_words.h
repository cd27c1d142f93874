// Words of GLSL 4.50 that have a meaning of their own, and those that a plugin has no use for.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glint {

// Keywords, types and words kept for later: nothing can be called so.
bool isGlslWord(std::string_view);

// Why a word cannot stand in the body of a plugin, which is evaluated for single pairs of directions in shaders of
// every kind; nothing for all others.
struct WordFault {
  std::string what, hint;
};
std::optional<WordFault> faultOfWord(std::string_view);

}  // namespace glint
