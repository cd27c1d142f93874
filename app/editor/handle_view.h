// A camera as the pointer sees it: for things in the picture that are taken hold of.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "renderer/scene.h"

namespace glint {

// A perspective camera. Pixels count from the picture's top left, y down. `scale`: pixels a UI unit.
class HandleView {
 public:
  HandleView(const Camera&, glm::vec2 size, float scale);

  // Nothing for what is not in front of the eye.
  std::optional<glm::vec2> project(glm::vec3) const;
  // Unit, from the eye.
  glm::vec3 ray(glm::vec2 pixel) const;
  // In the direction of view, metres.
  float depth(glm::vec3 p) const { return glm::dot(p - eye, forward); }
  // Of what faces the viewer at this point: how long so many UI units are, metres.
  float metres(float units, glm::vec3 at) const;
  // Where the pointer meets the plane through `at` that faces the camera.
  glm::vec3 onPlane(glm::vec2 pixel, glm::vec3 at) const;
  // Where it meets this plane; nothing when that is behind the eye, or seen along the plane.
  std::optional<glm::vec3> onPlane(glm::vec2 pixel, glm::vec3 at, glm::vec3 normal) const;
  // How far along the line the pointer is nearest to it, metres; nothing when the line points at the viewer.
  std::optional<float> alongLine(glm::vec2 pixel, glm::vec3 origin, glm::vec3 unit) const;
  // Where on the picture's edge, `inset` UI units within it, one finds what is not in the picture.
  glm::vec2 edge(glm::vec3, float inset) const;
  bool inside(glm::vec2 pixel, float inset) const;   // UI units

  glm::vec3 eye, target, right, up, forward;
  glm::vec2 size;
  float scale;

 private:
  float focal_;   // pixels
};

}  // namespace glint
