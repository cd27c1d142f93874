// Where the handles of lights lie and how large they are: shared by what shows them and by what dragging them does.
#pragma once

#include "app/editor/handle_view.h"
#include "renderer/light.h"

namespace glint::handle_places {

// UI units.
inline constexpr float kArrow = 64, kCone = 96, kConeArrow = 110, kAxisFrom = 20, kAxis = 64, kPlaneFrom = 13, kPlaneTo = 27;
inline constexpr float kLeastReach = 20;   // how near to the middle a handle may come
inline constexpr float kFarReach = 120;    // that of a light's end, when it ends outside the picture

// Of the ball around the camera's target on which directional lights lie, metres.
float sunBall(const HandleView&);
glm::vec3 worldAxis(int);
// Across the axis and the line of sight, so that it is seen at full length.
glm::vec3 sideOf(glm::vec3 axis, glm::vec3 at, const HandleView&);
// On a spot's cone, to the side with this sign.
glm::vec3 rim(const Light&, const HandleView&, float angle, float sign);
// How long the arrow is that says where it shines, metres.
float arrowLength(const Light&, const HandleView&);
glm::vec3 reachHandle(const Light&, const HandleView&);

}  // namespace glint::handle_places
