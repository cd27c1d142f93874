// Lights as things to take hold of in a view: where their handles lie, what they look like, and what dragging does to
// them. Geometry only.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/handle_view.h"
#include "renderer/light.h"

namespace glint {

// Axes and planes are the world's, a plane named by the axis across it. Aim is what the light points at, Turn the tip of
// its arrow, Reach where it ends (Light::radius). Scale has no handle: all that it measures, by the pointer's distance.
enum class LightGrip {
  Move, AxisX, AxisY, AxisZ, PlaneX, PlaneY, PlaneZ, Aim, Turn, Size, From, To, Left, Right, Bottom, Top, Outer, Inner, Reach, Scale
};
const char* name(LightGrip);       // "move", "axis x"
const char* stepLabel(LightGrip);  // "Move light"
// 0, 1, 2 for x, y and z; -1 for others.
int axisOf(LightGrip);
int planeOf(LightGrip);
// By which the whole light is taken: Move, or Aim of a directional light, whose place is on a ball around the camera's target.
LightGrip wholeGrip(const Light&);

struct LightHandle {
  LightGrip grip;
  glm::vec3 at;
};
// That of wholeGrip() comes first. `aim`: how far off lies what it points at, metres; see aimDistance().
std::vector<LightHandle> lightHandles(const Light&, const HandleView&, float aim);
// Where a light that points somewhere passes the camera's target, or as far away as that.
float aimDistance(const Light&, const HandleView&);
// The corners of a plane's handle.
std::vector<glm::vec3> planeCorners(const Light&, const HandleView&, int plane);

// What is drawn of it beside the handles.
struct LightLine {
  std::vector<glm::vec3> points;
  bool faint = false;
};
std::vector<LightLine> lightOutline(const Light&, const HandleView&, bool selected);
// Where it ends.
LightLine reachOutline(const Light&, const HandleView&);

struct LightDrag {
  LightGrip grip = LightGrip::Move;
  glm::vec2 from{0}, to{0};            // the pointer, pixels
  float aim = 0;                       // as lightHandles(), when it was taken
  bool straight = false;               // Move: along the axis that the drag runs along; a tube's end: along the tube
  bool snap = false;                   // to round numbers, of the size of some pixels
  std::optional<glm::vec3> surface;    // Aim: at this point, instead
};
// `start` when the pointer has gone from one pixel to another with a handle. Move goes in the plane that faces the camera.
// `start` itself where there is no answer.
Light dragged(const Light& start, const HandleView&, const LightDrag&);
// What Aim now points at is so far off.
float draggedAim(const Light& start, const HandleView&, const LightDrag&);

// With its highlight on this point, where the surface has this normal, as far from it as before. A light that points
// somewhere points there.
Light highlighting(const Light&, const HandleView&, glm::vec3 point, glm::vec3 normal);
Light aimedAt(const Light&, glm::vec3 point);

// A little aside of it, so that both are seen.
Light placedBeside(const Light&, const HandleView&);

// How far from its target the camera sees all these lights, metres; at least `least`.
float distanceToSee(const std::vector<Light>&, Camera, glm::vec2 size, float least);

// "35 cm", "1.25 m".
std::string lengthText(float metres);
// "3.14 lx", "188 lm \u00b7 15 cd".
std::string lightIntensity(const Light&);
// What this handle sets: "radius 35 cm".
std::string gripText(const Light&, LightGrip);

}  // namespace glint
