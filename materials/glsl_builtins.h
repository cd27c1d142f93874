// The functions that GLSL 4.50 has by itself (chapter 8, without textures, images and derivatives).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint {

bool isGlslFunction(std::string_view name);

struct GlslSignature {
  std::string returnType;
  std::vector<std::string> parameterTypes;
};
// All forms of such a function on floats and their vectors; none for functions that have no such form.
std::vector<GlslSignature> glslSignatures(std::string_view function);

}  // namespace glint
