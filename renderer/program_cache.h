// Linked programs by the content of their texts: the same text is built once.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>

#include "renderer/gl/objects.h"
#include "renderer/shader_assembler.h"

namespace glint {

class ProgramCache {
 public:
  // The program of a vertex and a fragment shader, or the driver's log as its only diagnostic. A failure is
  // remembered too. The pointer lives as long as the cache.
  Result<const gl::Program*> get(const ShaderText& vertex, const ShaderText& fragment);
  // Of a shader that takes no text from outside: a failure breaks a contract.
  const gl::Program& shipped(const ShaderText& vertex, const ShaderText& fragment);

 private:
  std::unordered_map<uint64_t, Result<gl::Program>> programs_;
};

}  // namespace glint
