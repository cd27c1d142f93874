// Draws the surfaces into the G-buffer, each with its own material's program, and marks its light group in the stencil.
#pragma once

#include "renderer/device_textures.h"
#include "renderer/passes/frame.h"
#include "renderer/program_cache.h"

namespace glint {

class GbufferPass {
 public:
  explicit GbufferPass(ProgramCache& programs) : programs_(programs) {}
  void draw(Frame&);
  void forgetUnused() { textures_.forgetUnused(); }
  // What the GLSL of a material reads, for any program that holds it; which is then in use.
  void bindMaterial(const Frame&, const ReadyView&, const gl::Program&, size_t material, int group);

 private:
  const gl::Program* program(Frame&, const CompiledMaterial&);

  ProgramCache& programs_;
  DeviceTextures textures_;
};

}  // namespace glint
