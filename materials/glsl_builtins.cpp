#include "materials/glsl_builtins.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace glint {
namespace {

// What comes back, then what goes in. G: float, vec2, vec3 or vec4, the same in each place; S: float; V: vec3; B: bool
// or bvec of G's size, which comes back from tests.
struct Function {
  std::string_view name, forms;
};
constexpr Function kFunctions[] = {
    {"radians", "GG"}, {"degrees", "GG"}, {"sin", "GG"}, {"cos", "GG"}, {"tan", "GG"}, {"asin", "GG"}, {"acos", "GG"},
    {"atan", "GG GGG"}, {"sinh", "GG"}, {"cosh", "GG"}, {"tanh", "GG"}, {"asinh", "GG"}, {"acosh", "GG"}, {"atanh", "GG"},
    {"pow", "GGG"}, {"exp", "GG"}, {"log", "GG"}, {"exp2", "GG"}, {"log2", "GG"}, {"sqrt", "GG"}, {"inversesqrt", "GG"},
    {"abs", "GG"}, {"sign", "GG"}, {"floor", "GG"}, {"trunc", "GG"}, {"round", "GG"}, {"roundEven", "GG"},
    {"ceil", "GG"}, {"fract", "GG"}, {"mod", "GGG GGS"}, {"min", "GGG GGS"}, {"max", "GGG GGS"},
    {"clamp", "GGGG GGSS"}, {"mix", "GGGG GGGS GGGB"}, {"step", "GGG GSG"}, {"smoothstep", "GGGG GSSG"},
    {"isnan", "BG"}, {"isinf", "BG"}, {"fma", "GGGG"},
    {"length", "SG"}, {"distance", "SGG"}, {"dot", "SGG"}, {"cross", "VVV"}, {"normalize", "GG"},
    {"faceforward", "GGGG"}, {"reflect", "GGG"}, {"refract", "GGGS"}};

constexpr std::string_view kOthers[] = {
    "modf", "frexp", "ldexp", "floatBitsToInt", "floatBitsToUint", "intBitsToFloat", "uintBitsToFloat", "packUnorm2x16",
    "packSnorm2x16", "packUnorm4x8", "packSnorm4x8", "unpackUnorm2x16", "unpackSnorm2x16", "unpackUnorm4x8",
    "unpackSnorm4x8", "packDouble2x32", "unpackDouble2x32", "packHalf2x16", "unpackHalf2x16", "matrixCompMult",
    "outerProduct", "transpose", "determinant", "inverse", "lessThan", "lessThanEqual", "greaterThan",
    "greaterThanEqual", "equal", "notEqual", "any", "all", "not", "uaddCarry", "usubBorrow", "umulExtended",
    "imulExtended", "bitfieldExtract", "bitfieldInsert", "bitfieldReverse", "bitCount", "findLSB", "findMSB",
    "noise1", "noise2", "noise3", "noise4"};

std::string typeOf(char letter, int size) {
  constexpr std::array<const char*, 4> kFloats = {"float", "vec2", "vec3", "vec4"};
  constexpr std::array<const char*, 4> kBools = {"bool", "bvec2", "bvec3", "bvec4"};
  const auto at = static_cast<size_t>(size - 1);
  return letter == 'G' ? kFloats[at] : letter == 'B' ? kBools[at] : letter == 'V' ? kFloats[2] : kFloats[0];
}

const Function* find(std::string_view name) {
  const auto found = std::find_if(std::begin(kFunctions), std::end(kFunctions), [&](const Function& f) { return f.name == name; });
  return found == std::end(kFunctions) ? nullptr : &*found;
}

}  // namespace

bool isGlslFunction(std::string_view name) {
  return find(name) || std::find(std::begin(kOthers), std::end(kOthers), name) != std::end(kOthers);
}

std::vector<GlslSignature> glslSignatures(std::string_view function) {
  std::vector<GlslSignature> all;
  const Function* found = find(function);
  if (!found) return all;
  for (std::string_view forms = found->forms; !forms.empty();) {
    const std::string_view form = forms.substr(0, forms.find(' '));
    forms.remove_prefix(std::min(forms.size(), form.size() + 1));
    for (int size = 1; size <= (form.find('G') == form.npos ? 1 : 4); ++size) {
      GlslSignature signature{typeOf(form[0], size), {}};
      for (const char letter : form.substr(1)) signature.parameterTypes.push_back(typeOf(letter, size));
      // Of size 1 the forms with a scalar are those without.
      if (std::none_of(all.begin(), all.end(), [&](const GlslSignature& s) { return s.parameterTypes == signature.parameterTypes; }))
        all.push_back(std::move(signature));
    }
  }
  return all;
}

}  // namespace glint
