// Where a model is asked for its values, to be told what is wrong with it.
#pragma once

#include <string>
#include <vector>

#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"

namespace glint {

// Each point is followed by itself with light and view in each other's place.

// On a grid with the cases that divide by zero where a model is careless. Of what the model does not read one value is as
// good as all.
std::vector<ProbePoint> gridPoints(const ShadingModel&);

// Spread evenly over roughness, light and view, the same at every call: what holds only in a window of 0.02 in roughness
// and a few degrees is met; so are such windows of metallic, specular and baseColor. Half of them, and all of those with constants of their own, have parameters of their own too.
struct ScatteredPoints {
  std::vector<ProbePoint> points;
  std::vector<glm::vec4> constants;  // of ModelProbe::evaluate()
};
std::vector<ScatteredPoints> scatteredPoints(const ShadingModel&);

// Integrals over attributes as a material may author them, `count` for those that the model reads and some for a plain
// nonmetal; none for a model that reads none. Roughness and NoV by turns from the lists.
std::vector<IntegralQuery> authoredQueries(const ShadingModel&, const std::vector<float>& roughness, const std::vector<float>& NoV, int count);

// ", F0 0.04" and what the model reads of the attributes: ", metallic 0.4".
std::string attributesText(const ShadingModel&, const ProbePoint&);

// ", gamma 2.3, tint 0.1/0.5/1" of a point with parameters of its own.
std::string parametersText(const ShadingModel&, const ProbePoint&, const std::vector<glm::vec4>& constants);

}  // namespace glint
