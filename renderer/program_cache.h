// Linked programs by what they are made from: the same request is assembled and built once.
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
  // remembered too. The pointer lives until forget().
  Result<const gl::Program*> get(const ShaderText& vertex, const ShaderText& fragment);
  // Of a shader that takes no text from outside: a failure breaks a contract.
  const gl::Program& shipped(const ShaderText& vertex, const ShaderText& fragment);

  size_t size() const { return programs_.size(); }
  // Drops every program: shipped files are read again, and memory is given back.
  void forget() { programs_.clear(); }

 private:
  std::unordered_map<uint64_t, Result<gl::Program>> programs_;
};

}  // namespace glint
