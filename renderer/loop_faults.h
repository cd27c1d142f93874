// Loops of a model that do not end, or only after more turns than it may take (materials/model.h: kMostTurns). They are broken
// off and the value is no number; here they are named.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/probe_points.h"

namespace glint {

// The first loop that was broken off at any of the points, at its line in the model's file. `constants` as of
// ModelProbe::evaluate(). Nothing for a model without loops. Needs a current context.
std::optional<Diagnostic> faultOfLoops(const ShadingModel&, std::span<const ProbePoint>, const std::vector<glm::vec4>& constants = {});
// The same over the whole range of what a model is asked.
std::optional<Diagnostic> faultOfLoops(const ShadingModel&);

}  // namespace glint
