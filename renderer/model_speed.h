// Whether a model is fast enough to be drawn at all: one that is not would hold up every picture and table.
#pragma once

#include <functional>
#include <optional>

#include "materials/model.h"

namespace glint {

// `evaluate` makes the device compute that many values of the model, whole multiples of 16, and waits for it. Few are
// asked for first, the fastest of some tries counts. `evaluations` is how often f is asked for one of them.
std::optional<Diagnostic> faultOfSpeed(const ShadingModel&, const std::function<void(int count)>& evaluate, int evaluations = 1);

}  // namespace glint
