// Edges of a view that moves. Each frame is drawn with another offset within the pixel; the frames before are brought to where
// their surfaces are now, and averaged with it where they show the same. Averages are of what a display shows, not of
// radiance: a bright edge is then as smooth as a dark one.
#pragma once

#include <array>
#include <vector>

#include "renderer/passes/frame.h"
#include "renderer/program_cache.h"

namespace glint {

class TemporalPass {
 public:
  explicit TemporalPass(ProgramCache& programs) : programs_(programs) {}

  // Of a pixel's samples, the one to draw next; never the first, which is its centre.
  int nextSample() { return 1 + turn_++ % kSamples; }

  // What `count` pictures of the frame's view add up to becomes what was seen before: a view that has rested starts to move.
  void remember(const Frame&, GLuint sum, int count);
  // The frame's picture, display-referred linear, averaged with those before, into `picture`; what is of another size or of
  // other rectangles is forgotten first.
  void draw(const Frame&, GLuint current, FrameTargets::Picture& picture);
  // The average, as it was drawn last.
  GLuint average() const { return history_[newest_].texture.id(); }
  int age() const { return age_; }     // how many pictures it is of

 private:
  static constexpr int kSamples = 16;
  // Where a view's surfaces were: without the offset within the pixel.
  struct Past {
    glm::mat4 clipFromWorld{1};
    glm::vec4 depthTerms{0};
    glm::ivec4 rectangle{0};
  };
  struct History {
    gl::Texture texture;               // RGBA16F: the average, and metres along the line of sight to the nearest surface about
    gl::Framebuffer framebuffer;
  };
  void resize(glm::ivec2);
  std::vector<Past> pastOf(const Frame&) const;
  const gl::Program& begin(const Frame&, bool remember, GLuint framebuffer, GLuint current, GLuint before);

  ProgramCache& programs_;
  std::array<History, 2> history_;
  size_t newest_ = 0;
  glm::ivec2 size_{0};
  std::vector<Past> past_;
  int age_ = 0, turn_ = 0;
};

}  // namespace glint
