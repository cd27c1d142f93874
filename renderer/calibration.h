// A fixed workload for the device, so that times of different machines can be put in ratio.
#pragma once

#include "renderer/gl/objects.h"

namespace glint {

class Calibration {
 public:
  Calibration();

  // Each runs its part once and waits for the device.
  void arithmetic();  // 1280x720 pixels of 64 steps of a logistic map on four components
  void fill();        // 16 screens of 1280x720, blended
  void triangles();   // 50 000 small triangles with depth test
  void all() {
    arithmetic();
    fill();
    triangles();
  }

 private:
  gl::Program arithmetic_, fill_, triangles_;
  gl::Texture color_, depth_;
  gl::Framebuffer target_;
  gl::VertexArray empty_;
};

}  // namespace glint
