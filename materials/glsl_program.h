// The body of evaluateMaterial() while it is built: values that know their GLSL, and statements that make them.
// Equal statements are one, constants are folded where they arise, and only what the results need is written.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "materials/compiled_material.h"
#include "materials/node.h"
#include "materials/value.h"

namespace glint {

using ValueId = int;  // of a GlslProgram; negative: none

class GlslProgram {
 public:
  // Who makes a statement: its name in the text ("rust.noise" for a node of a function) and its kind's title.
  struct Origin {
    std::string node, title;
  };

  ValueId literal(const Value&);
  // A field of MaterialInputs: "uv0".
  ValueId surface(std::string_view field);
  // Uniforms of one key are one; the first decides its value and range. Its `offset` is set at the end.
  ValueId uniform(const std::string& key, UniformField);
  // Textures of one file and settings are one. Nothing when there is no slot left.
  std::optional<ValueId> texture(TextureSlot);

  // The same value as another type (see converts()); no statement of its own.
  ValueId convert(ValueId, ValueType);
  // `.xyz` of a value.
  ValueId swizzle(ValueId, std::string_view components, ValueType);
  // One statement with one result: `text` is GLSL made of the texts of `arguments`.
  ValueId expression(const Origin&, std::string_view name, ValueType, std::string text,
                     std::vector<ValueId> arguments);
  // A call of a data node: one result for each output, of those types. `settings` are literals. Folds calls of
  // arithmetic with constant arguments.
  std::vector<ValueId> call(const Origin&, const NodeKind&, ValueType generic, std::vector<ValueId> arguments,
                            const std::vector<std::string>& settings, const std::vector<ValueType>& outputs);

  const std::string& text(ValueId id) const { return values_[id].text; }
  ValueType type(ValueId id) const { return values_[id].type; }
  const std::optional<Value>& constant(ValueId id) const { return values_[id].constant; }
  // Index into uniforms(), or -1: only of a uniform itself.
  int uniformIndex(ValueId id) const { return values_[id].uniform; }

  // Keeps what `results` need and drops the rest; then the lists below are final.
  void finish(const std::vector<ValueId>& results);
  const std::vector<UniformField>& uniforms() const { return uniforms_; }
  const std::vector<TextureSlot>& textures() const { return textures_; }
  int blockSize() const { return blockSize_; }

  std::string declarations() const;              // the block and the samplers
  std::string statements() const;                // indented lines
  struct Used {
    const NodeKind* kind;
    ValueType generic;
    auto operator<=>(const Used&) const = default;
  };
  std::vector<Used> functions() const;           // that the statements call, by id, then type

  size_t statementCount() const { return statements_.size(); }
  int keptCount() const;
  int64_t operations() const;                    // of the kept statements, see glslOperations()
  int folded() const { return folded_; }
  int shared() const { return shared_; }

 private:
  struct Entry {
    ValueType type = ValueType::Float;
    std::string text;
    ValueId source = -1;       // of a conversion or swizzle
    int statement = -1, uniform = -1, texture = -1;
    std::optional<Value> constant;
  };
  struct Statement {
    Origin origin;
    std::string call;          // right-hand side; or, with several results, the call without its `)`
    std::vector<ValueId> arguments, results;
    const NodeKind* kind = nullptr;
    ValueType generic = ValueType::Float;
    bool kept = false;
  };

  ValueId add(Entry);
  std::vector<ValueId> statement(Statement, const std::vector<std::pair<std::string, ValueType>>& results);
  std::string unique(std::string_view wish);
  void layOut(const std::vector<bool>& usedUniforms, const std::vector<bool>& usedTextures);

  std::vector<Entry> values_;
  std::vector<Statement> statements_;
  std::unordered_map<std::string, std::vector<ValueId>> known_;  // by text
  std::map<std::string, ValueId> uniformKeys_;
  std::set<std::string> names_;
  std::vector<UniformField> uniforms_;
  std::vector<std::string> uniformNames_;  // in GLSL
  std::vector<TextureSlot> textures_;
  std::vector<ValueId> textureValues_;
  int blockSize_ = 0, folded_ = 0, shared_ = 0;
};

// The result of a data node's arithmetic on constants, when C++ knows it as well: nothing otherwise.
std::optional<Value> foldCall(const NodeKind&, ValueType result, const std::vector<Value>& arguments);

// Text that is safe inside a GLSL comment.
std::string commentText(std::string_view);

}  // namespace glint
