// Shows one of the frame's buffers as a picture: the views that are not lit.
#pragma once

#include "renderer/passes/frame.h"
#include "renderer/passes/lighting_pass.h"

namespace glint {

class BufferViewPass {
 public:
  explicit BufferViewPass(ProgramCache& programs) : programs_(programs) {}
  void draw(const Frame&, LightLists&);

 private:
  ProgramCache& programs_;
};

}  // namespace glint
