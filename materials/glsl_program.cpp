#include "materials/glsl_program.h"

#include <algorithm>
#include <cctype>
#include <numeric>

#include "materials/base/check.h"

namespace glint {
namespace {

// As a part of an identifier: no characters that GLSL does not know, no "__", which it reserves.
std::string identifier(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const char d = std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 128 ? c : '_';
    if (d != '_' || (!out.empty() && out.back() != '_')) out += d;
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  return out.empty() ? "x" : out.substr(0, 200);
}

int alignment(ValueType type) {
  const int count = componentCount(type);
  return count == 1 ? 4 : count == 2 ? 8 : 16;
}

}  // namespace

std::string commentText(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 120)) {
    const auto u = static_cast<unsigned char>(c);
    // No line ends, and no backslash, which would join the next line to the comment.
    out += u < 128 && (std::isalnum(u) || std::string_view(" .,-_()/+:'").find(c) != std::string_view::npos) ? c : '?';
  }
  return out;
}

ValueId GlslProgram::add(Entry entry) {
  values_.push_back(std::move(entry));
  return static_cast<ValueId>(values_.size()) - 1;
}

std::string GlslProgram::unique(std::string_view wish) {
  std::string name(wish);
  for (int n = 2; !names_.insert(name).second; ++n) name = fmt::format("{}_{}", wish, n);
  return name;
}

ValueId GlslProgram::literal(const Value& value) {
  std::string text = glslLiteral(value);
  auto& known = known_[text];
  if (known.empty()) known.push_back(add({.type = value.type, .text = text, .constant = value}));
  return known[0];
}

ValueId GlslProgram::surface(std::string_view field) {
  std::string text = fmt::format("i.{}", field);
  auto& known = known_[text];
  if (known.empty())
    known.push_back(add({.type = field.starts_with("uv") ? ValueType::Vec2
                                 : field == "vertexColor" ? ValueType::Vec4
                                                          : ValueType::Vec3,
                         .text = text}));
  return known[0];
}

ValueId GlslProgram::uniform(const std::string& key, UniformField field) {
  const auto [at, fresh] = uniformKeys_.try_emplace(key, -1);
  if (!fresh) return at->second;
  Entry entry{.type = field.value.type, .text = unique("u_" + identifier(field.name))};
  entry.uniform = static_cast<int>(uniforms_.size());
  uniformNames_.push_back(entry.text);
  uniforms_.push_back(std::move(field));
  return at->second = add(std::move(entry));
}

std::optional<ValueId> GlslProgram::texture(TextureSlot slot) {
  for (const ValueId id : textureValues_) {
    TextureSlot other = textures_[values_[id].texture];
    other.sampler = slot.sampler;
    other.node = slot.node;
    other.place = slot.place;
    if (other == slot) return id;
  }
  if (textures_.size() >= static_cast<size_t>(kMostMaterialTextures)) return std::nullopt;
  Entry entry{.type = ValueType::Texture, .text = unique("t_" + identifier(slot.node))};
  entry.texture = static_cast<int>(textures_.size());
  slot.sampler = entry.text;
  textures_.push_back(std::move(slot));
  textureValues_.push_back(add(std::move(entry)));
  return textureValues_.back();
}

ValueId GlslProgram::convert(ValueId id, ValueType to) {
  const Entry& from = values_[id];
  if (from.type == to || (componentCount(from.type) == componentCount(to) && glslName(from.type) == glslName(to)))
    return id;
  const auto number = [](ValueType t) { return t == ValueType::Bool || t == ValueType::Int; };
  if (from.constant) {
    Value value{to, from.constant->v};
    if (componentCount(from.type) == 1)
      for (int i = 0; i < 4; ++i) value.v[i] = i < componentCount(to) ? from.constant->v[0] : 0;
    return literal(value);
  }
  std::string text = from.text;
  if (number(from.type) && to != from.type) text = fmt::format("float({})", text);
  if (componentCount(to) > 1) text = fmt::format("{}({})", glslName(to), text);
  auto& known = known_[text];
  if (known.empty()) {
    const ValueId made = add({.type = to, .text = text, .source = id});
    known_[text].push_back(made);
    return made;
  }
  return known[0];
}

ValueId GlslProgram::swizzle(ValueId id, std::string_view components, ValueType type) {
  std::string text = fmt::format("{}.{}", values_[id].text, components);
  if (const auto& known = known_[text]; !known.empty()) return known[0];
  const ValueId made = add({.type = type, .text = text, .source = id});
  known_[text].push_back(made);
  return made;
}

std::vector<ValueId> GlslProgram::statement(Statement made,
                                            const std::vector<std::pair<std::string, ValueType>>& results) {
  if (const auto& known = known_[made.call]; !known.empty()) {
    ++shared_;
    return known;
  }
  const int index = static_cast<int>(statements_.size());
  for (const auto& [name, type] : results) {
    Entry entry{.type = type, .text = unique("n_" + identifier(name))};
    entry.statement = index;
    made.results.push_back(add(std::move(entry)));
  }
  known_[made.call] = made.results;
  statements_.push_back(std::move(made));
  return statements_.back().results;
}

ValueId GlslProgram::expression(const Origin& origin, std::string_view name, ValueType type, std::string text,
                                std::vector<ValueId> arguments) {
  return statement({.origin = origin, .call = std::move(text), .arguments = std::move(arguments), .results = {}},
                   {{std::string(name), type}})[0];
}

std::vector<ValueId> GlslProgram::call(const Origin& origin, const NodeKind& kind, ValueType generic,
                                       std::vector<ValueId> arguments, const std::vector<std::string>& settings,
                                       const std::vector<ValueType>& outputs) {
  if (settings.empty() && !kind.surface && outputs.size() == 1 && !arguments.empty()) {
    std::vector<Value> constants;
    for (const ValueId id : arguments)
      if (values_[id].constant) constants.push_back(*values_[id].constant);
    if (constants.size() == arguments.size())
      if (const auto value = foldCall(kind, outputs[0], constants)) {
        ++folded_;
        return {literal(*value)};
      }
  }
  std::string text = kind.function + "(";
  const char* comma = "";
  const auto argument = [&](std::string_view a) {
    text += comma;
    text += a;
    comma = ", ";
  };
  if (kind.surface) argument("i");
  for (const ValueId id : arguments) argument(values_[id].text);
  for (const std::string& s : settings) argument(s);
  if (outputs.size() == 1) text += ")";
  std::vector<std::pair<std::string, ValueType>> results;
  for (size_t i = 0; i < outputs.size(); ++i)
    results.emplace_back(outputs.size() == 1 ? origin.node : origin.node + "_" + kind.outputs[i].name, outputs[i]);
  return statement({.origin = origin, .call = std::move(text), .arguments = std::move(arguments), .results = {},
                    .kind = &kind, .generic = generic},
                   results);
}

void GlslProgram::finish(const std::vector<ValueId>& results) {
  std::vector<bool> seen(values_.size()), usedUniforms(uniforms_.size()), usedTextures(textures_.size());
  std::vector<ValueId> todo = results;
  while (!todo.empty()) {
    const ValueId id = todo.back();
    todo.pop_back();
    if (id < 0 || seen[id]) continue;
    seen[id] = true;
    const Entry& entry = values_[id];
    if (entry.source >= 0) todo.push_back(entry.source);
    if (entry.uniform >= 0) usedUniforms[entry.uniform] = true;
    if (entry.texture >= 0) usedTextures[entry.texture] = true;
    if (entry.statement >= 0 && !statements_[entry.statement].kept) {
      Statement& s = statements_[entry.statement];
      s.kept = true;
      todo.insert(todo.end(), s.arguments.begin(), s.arguments.end());
    }
  }
  layOut(usedUniforms, usedTextures);
}

// Uniforms in the order of their names, at their std140 offsets; textures in the order of their samplers.
void GlslProgram::layOut(const std::vector<bool>& usedUniforms, const std::vector<bool>& usedTextures) {
  std::vector<int> order;
  for (size_t i = 0; i < uniforms_.size(); ++i)
    if (usedUniforms[i]) order.push_back(static_cast<int>(i));
  std::sort(order.begin(), order.end(), [&](int a, int b) { return uniformNames_[a] < uniformNames_[b]; });
  std::vector<UniformField> fields;
  std::vector<std::string> names;
  std::vector<int> newIndex(uniforms_.size(), -1);
  int offset = 0;
  for (const int old : order) {
    newIndex[old] = static_cast<int>(fields.size());
    UniformField field = uniforms_[old];
    const int align = alignment(field.value.type);
    offset = (offset + align - 1) / align * align;
    field.offset = offset;
    offset += 4 * componentCount(field.value.type);
    fields.push_back(std::move(field));
    names.push_back(uniformNames_[old]);
  }
  blockSize_ = (offset + 15) / 16 * 16;
  uniforms_ = std::move(fields);
  uniformNames_ = std::move(names);

  std::vector<int> textureOrder, newTexture(textures_.size(), -1);
  for (size_t i = 0; i < textures_.size(); ++i)
    if (usedTextures[i]) textureOrder.push_back(static_cast<int>(i));
  std::sort(textureOrder.begin(), textureOrder.end(),
            [&](int a, int b) { return textures_[a].sampler < textures_[b].sampler; });
  std::vector<TextureSlot> slots;
  for (const int old : textureOrder) {
    newTexture[old] = static_cast<int>(slots.size());
    slots.push_back(textures_[old]);
  }
  textures_ = std::move(slots);
  for (Entry& entry : values_) {
    if (entry.uniform >= 0) entry.uniform = newIndex[entry.uniform];
    if (entry.texture >= 0) entry.texture = newTexture[entry.texture];
  }
}

std::string GlslProgram::declarations() const {
  std::string text;
  if (!uniforms_.empty()) {
    text += fmt::format("layout(std140, binding = {}) uniform MaterialParameters {{\n", kMaterialParametersBinding);
    for (size_t i = 0; i < uniforms_.size(); ++i)
      text += fmt::format("  {} {};  // {}\n", glslName(uniforms_[i].value.type), uniformNames_[i],
                          commentText(uniforms_[i].name));
    text += "};\n";
  }
  for (size_t i = 0; i < textures_.size(); ++i)
    text += fmt::format("layout(binding = {}) uniform sampler2D {};\n", kFirstMaterialTexture + i, textures_[i].sampler);
  return text;
}

std::string GlslProgram::statements() const {
  std::string text;
  const std::string* last = nullptr;
  for (const Statement& s : statements_) {
    if (!s.kept) continue;
    if (!last || *last != s.origin.node)
      text += fmt::format("  // {}: {}\n", commentText(s.origin.node), commentText(s.origin.title));
    last = &s.origin.node;
    if (s.results.size() == 1) {
      const Entry& result = values_[s.results[0]];
      text += fmt::format("  {} {} = {};\n", glslName(result.type), result.text, s.call);
      continue;
    }
    std::string outs;
    for (const ValueId id : s.results) {
      text += fmt::format("  {} {};\n", glslName(values_[id].type), values_[id].text);
      outs += ", " + values_[id].text;
    }
    text += fmt::format("  {}{});\n", s.call, s.call.ends_with('(') ? outs.substr(2) : outs);
  }
  return text;
}

std::vector<GlslProgram::Used> GlslProgram::functions() const {
  std::vector<Used> used;
  for (const Statement& s : statements_)
    if (s.kept && s.kind) used.push_back({s.kind, s.generic});
  const auto before = [](const Used& a, const Used& b) {
    return a.kind->id != b.kind->id ? a.kind->id < b.kind->id : a.generic < b.generic;
  };
  std::sort(used.begin(), used.end(), before);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

int GlslProgram::keptCount() const {
  return static_cast<int>(std::count_if(statements_.begin(), statements_.end(), [](const Statement& s) { return s.kept; }));
}

int64_t GlslProgram::operations() const {
  int64_t sum = 0;
  for (const Statement& s : statements_)
    if (s.kept) sum += s.kind ? s.kind->operations : 1;
  return sum;
}

}  // namespace glint
