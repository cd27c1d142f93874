// How open each pixel is to its surroundings, by what stands near it on the screen.
#pragma once

#include "renderer/passes/frame.h"
#include "renderer/program_cache.h"

namespace glint {

class OcclusionPass {
 public:
  explicit OcclusionPass(ProgramCache& programs) : programs_(programs) {}
  // Fills layer 0 of FrameTargets::visibility.
  void draw(Frame&, const FrameTargets::Visibility&);

 private:
  struct Half {
    gl::Texture texture;
    gl::Framebuffer framebuffer;
  };
  ProgramCache& programs_;
  Half noisy_, smooth_;
  glm::ivec2 size_{0};
};

}  // namespace glint
