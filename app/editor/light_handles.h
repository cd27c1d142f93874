// Lights as things to take hold of in a view: where their handles lie, what they look like, and what dragging does to
// them. Geometry only.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "renderer/light.h"
#include "renderer/scene.h"

namespace glint {

// A perspective camera as the pointer sees it: pixels from the picture's top left, y down. `scale`: pixels a UI unit.
class HandleView {
 public:
  HandleView(const Camera&, glm::vec2 size, float scale);

  // Nothing for what is not in front of the eye.
  std::optional<glm::vec2> project(glm::vec3) const;
  // Unit, from the eye.
  glm::vec3 ray(glm::vec2 pixel) const;
  // Of what faces the viewer at this point: how long so many UI units are, metres.
  float metres(float units, glm::vec3 at) const;
  // Where the pointer meets the plane through `at` that faces the camera.
  glm::vec3 onPlane(glm::vec2 pixel, glm::vec3 at) const;
  // How far along the line the pointer is nearest to it, metres; nothing when the line points at the viewer.
  std::optional<float> alongLine(glm::vec2 pixel, glm::vec3 origin, glm::vec3 unit) const;
  // Where on the picture's edge, `inset` UI units within it, one finds what is not in the picture.
  glm::vec2 edge(glm::vec3, float inset) const;

  glm::vec3 eye, target, right, up, forward;
  glm::vec2 size;
  float scale;

 private:
  float focal_;   // pixels
};

enum class LightGrip { Move, Aim, Size, From, To, Left, Right, Bottom, Top, Outer, Inner };
const char* name(LightGrip);       // "move"
const char* stepLabel(LightGrip);  // "Move light"

struct LightHandle {
  LightGrip grip;
  glm::vec3 at;
};
// The one by which the whole light is taken comes first: Move, or Aim of a directional light, whose place is on a ball
// around the camera's target.
std::vector<LightHandle> lightHandles(const Light&, const HandleView&);

// What is drawn of it beside the handles.
struct LightLine {
  std::vector<glm::vec3> points;
  bool faint = false;
};
std::vector<LightLine> lightOutline(const Light&, const HandleView&, bool selected);

// `start` when the pointer has gone from one pixel to another with the handle. Moves in the plane through the light that
// faces the camera; with `oneAxis` along the world's axis that lies in the drag's direction (a tube's end: along the tube).
Light dragged(const Light& start, LightGrip, const HandleView&, glm::vec2 from, glm::vec2 to, bool oneAxis = false);

// A little aside of it, so that both are seen.
Light placedBeside(const Light&, const HandleView&);

// How far from its target the camera sees all these lights, metres; at least `least`.
float distanceToSee(const std::vector<Light>&, Camera, glm::vec2 size, float least);

// "3.14 lx", "188 lm \u00b7 15 cd".
std::string lightIntensity(const Light&);
// What this handle has set: "0.45 m".
std::string gripText(const Light&, LightGrip);

}  // namespace glint
