// Arithmetic on constants while a graph is compiled: what the GLSL of these nodes does, in float.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "materials/glsl_program.h"

namespace glint {
namespace {

using Arguments = const float (&)[4];
using Scalar = float (*)(Arguments);

// By node id: nodes whose result is computed for each component from the same component of the arguments, in
// the order of their pins. Results must equal those of shaders/nodes/<id>.glsl; tests/materials compares them
// on the GL device.
const std::unordered_map<std::string, Scalar>& componentwise() {
  static const std::unordered_map<std::string, Scalar> table = {
      {"add", [](Arguments a) { return a[0] + a[1]; }},
      {"subtract", [](Arguments a) { return a[0] - a[1]; }},
      {"multiply", [](Arguments a) { return a[0] * a[1]; }},
      {"divide", [](Arguments a) { return a[1] == 0 ? 0.f : a[0] / a[1]; }},
      {"mix", [](Arguments a) { return a[0] * (1 - a[2]) + a[1] * a[2]; }},
      {"clamp", [](Arguments a) { return std::min(std::max(a[0], a[1]), a[2]); }},
      {"saturate", [](Arguments a) { return std::min(std::max(a[0], 0.f), 1.f); }},
      {"min", [](Arguments a) { return std::min(a[0], a[1]); }},
      {"max", [](Arguments a) { return std::max(a[0], a[1]); }},
      {"abs", [](Arguments a) { return std::abs(a[0]); }},
      {"floor", [](Arguments a) { return std::floor(a[0]); }},
      {"fract", [](Arguments a) { return a[0] - std::floor(a[0]); }},
      {"one-minus", [](Arguments a) { return 1 - a[0]; }},
      {"negate", [](Arguments a) { return -a[0]; }},
      {"sqrt", [](Arguments a) { return std::sqrt(std::max(a[0], 0.f)); }},
      {"step", [](Arguments a) { return a[1] < a[0] ? 0.f : 1.f; }},
      {"power", [](Arguments a) { return std::pow(std::max(a[0], 0.f), a[1]); }},
  };
  return table;
}

}  // namespace

std::optional<Value> foldCall(const NodeKind& kind, ValueType result, const std::vector<Value>& arguments) {
  const int count = componentCount(result);
  if (arguments.size() > 4 || count < 1 || result == ValueType::Bool || result == ValueType::Int) return std::nullopt;
  Value value{result, {}};
  if (kind.id.starts_with("combine-")) {
    if (static_cast<int>(arguments.size()) != count) return std::nullopt;
    for (int c = 0; c < count; ++c) value.v[c] = arguments[c].v[0];
    return value;
  }
  const auto found = componentwise().find(kind.id);
  if (found == componentwise().end()) return std::nullopt;
  for (int c = 0; c < count; ++c) {
    float a[4] = {};
    for (size_t i = 0; i < arguments.size(); ++i)
      a[i] = componentCount(arguments[i].type) == 1 ? arguments[i].v[0] : arguments[i].v[c];
    value.v[c] = found->second(a);
    if (!std::isfinite(value.v[c])) return std::nullopt;
  }
  return value;
}

}  // namespace glint
