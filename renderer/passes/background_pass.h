// Draws what is seen behind the surfaces, and surfaces of one colour.
#pragma once

#include "renderer/environment_lighting.h"
#include "renderer/passes/frame.h"

namespace glint {

class BackgroundPass {
 public:
  BackgroundPass(ProgramCache& programs, EnvironmentLighting& lighting) : programs_(programs), lighting_(lighting) {}
  // What shaders/common/backdrop.glsl reads.
  struct Backdrop {
    glm::vec4 color{0, 0, 0, 1};
    float level = 0;
    GLuint cube = 0;
    void bind(const gl::Program&) const;
  };
  // Builds maps of an environment that it meets for the first time, which changes the state.
  Backdrop backdrop(const Frame&, const ReadyView&);
  // True when all is black, which a clear gives for less.
  static bool isBlack(const Frame&);
  void draw(const Frame&);
  // A plugin that never compiled shows as a flat magenta, which no light makes by itself.
  void drawBroken(const Frame&, const ReadyView&, int group);

 private:
  void fill(const Frame&, const ReadyView&, int group, const Backdrop&);

  ProgramCache& programs_;
  EnvironmentLighting& lighting_;
};

}  // namespace glint
