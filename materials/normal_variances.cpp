#include "materials/normal_variances.h"

#include <cctype>

namespace glint {
namespace {

// GLSL with names replaced; what follows a dot is none.
std::string withNames(const std::string& text, const std::map<std::string, std::string>& names) {
  std::string out, word;
  const auto flush = [&] {
    const auto found = names.find(word);
    out += found == names.end() ? word : found->second;
    word.clear();
  };
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.') {
      word += c;
    } else {
      flush();
      out += c;
    }
  }
  flush();
  return out;
}

bool isNormal(const PinType& type) { return type == PinType::exact(ValueType::Vec3); }

}  // namespace

ValueId NormalVariances::of(ValueId normal) const {
  const auto found = variances_.find(normal);
  return found == variances_.end() ? -1 : found->second;
}

void NormalVariances::keep(const GlslProgram::Origin& origin, ValueId normal, std::string text, std::vector<ValueId> arguments) {
  variances_[normal] = program_.expression(origin, origin.node + "_variance", ValueType::Float, std::move(text), std::move(arguments));
}

void NormalVariances::sampled(const GlslProgram::Origin& origin, ValueId color, ValueId alpha) {
  keep(origin, color, fmt::format("(1.0 - {0}) * (1.0 - {0})", program_.text(alpha)), {alpha});
}

void NormalVariances::made(const GlslProgram::Origin& origin, const NodeKind& kind, const std::vector<ValueId>& arguments, ValueId normal) {
  std::vector<ValueId> used;
  std::map<std::string, std::string> names;
  bool any = false;
  for (size_t i = 0; i < kind.inputs.size(); ++i) {
    const bool varies = isNormal(kind.inputs[i].type);
    const ValueId id = varies ? of(arguments[i]) : arguments[i];
    any |= varies && id >= 0;
    names[kind.inputs[i].name] = id < 0 ? "0.0" : program_.text(id);
    if (id >= 0) used.push_back(id);
  }
  if (any) keep(origin, normal, withNames(kind.variance, names), std::move(used));
}

void NormalVariances::blended(const GlslProgram::Origin& origin, ValueId a, ValueId b, ValueId mask, ValueId normal) {
  ValueId low = of(a), high = of(b);
  if (low < 0 && high < 0) return;
  const ValueId none = program_.literal(Value::scalar(0));
  if (low < 0) low = none;
  if (high < 0) high = none;
  keep(origin, normal, fmt::format("mix({}, {}, {})", program_.text(low), program_.text(high), program_.text(mask)), {low, high, mask});
}

bool holdsNormals(const Material& document, const GraphAnalysis& analysis, const NodeId& sampling) {
  bool any = false;
  for (const auto& [id, node] : document.nodes)
    for (const auto& [pin, input] : node.inputs) {
      if (!input.from || input.from->node != sampling) continue;
      const auto user = analysis.nodes.find(id);
      const NodeKind* kind = user == analysis.nodes.end() ? nullptr : user->second.kind;
      const Pin* into = kind && !kind->variance.empty() ? kind->input(pin) : nullptr;
      if (!into || input.from->pin != "color" || !isNormal(into->type)) return false;
      any = true;
    }
  return any;
}

}  // namespace glint
