// Linked programs by what they are made from: the same request is assembled and built once.
#pragma once

#include <string>

#include "renderer/gl/objects.h"
#include "renderer/recently_used.h"
#include "renderer/shader_assembler.h"

namespace glint {

class ProgramCache {
 public:
  // The program of a vertex and a fragment shader, or the driver's log as its only diagnostic. A failure is
  // remembered too. The pointer lives until forgetUnused() or forget().
  Result<const gl::Program*> get(const ShaderText& vertex, const ShaderText& fragment);
  // Of a shader that takes no text from outside: a failure breaks a contract.
  const gl::Program& shipped(const ShaderText& vertex, const ShaderText& fragment);

  // Between frames: keeps the programs of the last one, and a few more.
  void forgetUnused() { programs_.nextFrame(kSpare); }
  // Drops every program: shipped files are read again, and memory is given back.
  void forget() { programs_.clear(); }
  // How many were built so far, for measurements.
  int built() const { return built_; }

 private:
  static constexpr size_t kSpare = 64;  // of about 2 MB each where they are compiled for the processor
  RecentlyUsed<Result<gl::Program>> programs_;
  int built_ = 0;
};

}  // namespace glint
