#include "materials/glsl_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glint {
namespace {

constexpr std::array<std::string_view, 94> kWords = {
    "attribute", "bool",      "break",     "buffer",   "bvec2",      "bvec3",    "bvec4",    "case",      "centroid",
    "coherent",  "const",     "continue",  "default",  "discard",    "do",       "double",   "else",      "false",
    "flat",      "float",     "for",       "highp",    "if",         "image2D",  "in",       "inout",     "int",
    "invariant", "isampler2D", "ivec2",    "ivec3",    "ivec4",      "layout",   "lowp",     "mat2",      "mat3",
    "mat4",      "mediump",   "noperspective", "out",  "patch",      "precise",  "precision", "readonly", "restrict",
    "return",    "sample",    "sampler2D", "sampler3D", "samplerCube", "shared", "smooth",   "struct",    "subroutine",
    "switch",    "true",      "uint",      "uniform",  "uvec2",      "uvec3",    "uvec4",    "varying",   "vec2",
    "vec3",      "vec4",      "void",      "volatile", "while",      "writeonly", "dvec2",   "dvec3",     "dvec4",
    "samplerBuffer", "sampler2DArray", "usampler2D", "mat2x2", "mat2x3", "mat2x4", "mat3x2", "mat3x3", "mat3x4",
    "mat4x2", "mat4x3", "mat4x4", "dmat2", "dmat3", "dmat4", "sampler1D", "sampler1DArray", "sampler2DShadow",
    "atomic_uint", "image1D", "image3D", "usampler3D"};

// Section 3.6: kept for later versions of the language.
constexpr std::array<std::string_view, 36> kReserved = {
    "active", "asm",    "cast",     "class",  "common",   "enum",     "extern", "external",  "filter",
    "fixed",  "goto",   "half",     "inline", "input",    "interface", "long",  "namespace", "noinline",
    "output", "partition", "public", "resource", "short", "sizeof",   "static", "superp",    "template",
    "this",   "typedef", "union",   "unsigned", "using",  "hvec2",    "hvec3",  "hvec4",     "sampler3DRect"};

constexpr std::array<std::string_view, 9> kDerivatives = {"dFdx",     "dFdxCoarse", "dFdxFine",     "dFdy",      "dFdyCoarse",
                                                          "dFdyFine", "fwidth",     "fwidthCoarse", "fwidthFine"};

template <size_t n>
bool contains(const std::array<std::string_view, n>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

bool isGlslWord(std::string_view word) { return contains(kWords, word) || contains(kReserved, word); }

std::optional<WordFault> faultOfWord(std::string_view word) {
  const auto notForPlugins = [&](const char* hint) {
    return WordFault{fmt::format("'{}' is not for a plugin", word), hint};
  };
  if (word == "discard") return notForPlugins("a model has no pixel to drop: return vec3(0.0), or use the opacityMask of a material");
  if (word.starts_with("gl_")) return notForPlugins("a model is evaluated for one pair of directions: all it has is what it is called with");
  if (contains(kDerivatives, word)) return notForPlugins("a model has no neighbouring pixels: all it has is what it is called with");
  if (contains(kReserved, word)) return WordFault{fmt::format("'{}' is a reserved word of GLSL", word), "choose another name"};
  if (word.find("__") != word.npos)
    return WordFault{fmt::format("'{}' is reserved: names with two underscores are the compiler's", word), "choose another name"};
  return std::nullopt;
}

}  // namespace glint
