// A GLSL text put into a namespace of its own, so that it can stand in one shader with any other: GLSL has none.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct GlslNamespace {
  // The same lines without their comments. Every name has the prefix, be it a variable, function, type or member, but
  // for GLSL's own: its words, its functions unless the text defines some of that name, and swizzles.
  std::string text;
  // For the functions of GLSL that the text defines some forms of: the other forms, on one line, to stand before it.
  std::string overloads;
  // Assignments, on one line, that give the text's global variables again what they start from.
  std::string initialisers;
};

// `variables` are names that are declared elsewhere but belong to the text. Comments are those of GLSL 4.10: a
// backslash does not continue them.
GlslNamespace inNamespace(std::string_view text, std::string_view prefix, const std::vector<std::string>& variables);

}  // namespace glint
