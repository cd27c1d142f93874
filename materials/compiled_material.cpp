#include "materials/compiled_material.h"

#include <cstring>

#include "materials/base/check.h"

namespace glint {

std::vector<std::byte> CompiledMaterial::block() const {
  std::vector<std::byte> bytes(static_cast<size_t>(blockSize));
  for (const UniformField& field : uniforms) {
    const int count = componentCount(field.value.type);
    GLINT_CHECK(field.offset >= 0 && field.offset + 4 * count <= blockSize, "'{}' at {} of {}", field.name,
                field.offset, blockSize);
    std::byte* at = bytes.data() + field.offset;
    for (int i = 0; i < count; ++i, at += 4) {
      if (field.value.type == ValueType::Bool || field.value.type == ValueType::Int) {
        const auto whole = static_cast<int32_t>(field.value.v[i]);
        std::memcpy(at, &whole, 4);
      } else {
        std::memcpy(at, &field.value.v[i], 4);
      }
    }
  }
  return bytes;
}

UniformField* CompiledMaterial::uniform(std::string_view wanted) {
  // One that was put there from outside wins over one of the same name in the graph.
  UniformField* found = nullptr;
  for (UniformField& field : uniforms)
    if (field.name == wanted && (!found || field.node.starts_with(kOverridePrefix))) found = &field;
  return found;
}

std::vector<Value> CompiledMaterial::modelParameterValues() const {
  std::vector<Value> values;
  for (const ModelParameterSource& source : modelParameters) {
    Value value = source.value;
    if (source.uniform >= 0) value.v = uniforms[static_cast<size_t>(source.uniform)].value.v;
    values.push_back(value);
  }
  return values;
}

}  // namespace glint
