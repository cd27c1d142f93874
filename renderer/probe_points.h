// Where a model is asked for its values, to be told what is wrong with it.
#pragma once

#include <string>
#include <vector>

#include "renderer/model_probe.h"

namespace glint {

// Each point is followed by itself with light and view in each other's place.

// On a grid with the cases that divide by zero where a model is careless. Of what the model does not read one value is as
// good as all.
std::vector<ProbePoint> gridPoints(const ShadingModel&);

// Spread evenly over roughness, light and view, the same at every call: what holds only in a window of 0.02 in roughness
// and a few degrees is met. Half of them, and all of those with constants of their own, have parameters of their own too.
struct ScatteredPoints {
  std::vector<ProbePoint> points;
  std::vector<glm::vec4> constants;  // of ModelProbe::evaluate()
};
std::vector<ScatteredPoints> scatteredPoints(const ShadingModel&);

// ", gamma 2.3, tint 0.1/0.5/1" of a point with parameters of its own.
std::string parametersText(const ShadingModel&, const ProbePoint&, const std::vector<glm::vec4>& constants);

}  // namespace glint
