// How much of each light arrives at each pixel: draws the maps of the lights that cast shadows, and looks the surfaces of the
// G-buffer up in them.
#pragma once

#include <array>

#include "renderer/passes/frame.h"
#include "renderer/passes/gbuffer_pass.h"

namespace glint {

class ShadowPass {
 public:
  ShadowPass(ProgramCache& programs, DeviceMeshes& meshes, GbufferPass& gbuffer) : programs_(programs), meshes_(meshes), gbuffer_(gbuffer) {}

  // Fills the layers of the shadows' numbers of FrameTargets::visibility. A map is drawn when its light or what casts shadows
  // has changed: a still scene and a turning camera draw none. Returns how many were drawn.
  int draw(Frame&, const FrameTargets::Visibility&);

  // Of everything that the maps of a view are made from.
  uint64_t castersKey(const ReadyView&);

 private:
  struct Map {
    uint64_t key = 0, used = 0;
    gl::Texture depth;
    gl::Framebuffer framebuffer;
  };
  const Map& map(Frame&, const ReadyView&, const ShadowView&, uint64_t casters);
  void drawMap(Frame&, const ReadyView&, const ShadowView&, const Map&);

  ProgramCache& programs_;
  DeviceMeshes& meshes_;
  GbufferPass& gbuffer_;
  std::array<Map, kMostShadows> maps_;   // whichever were used last
  gl::Sampler nearest_, test_;
  uint64_t uses_ = 0;
  int drawn_ = 0;
};

}  // namespace glint
