// What is wrong with the functions of a model that are no part of its f: what it makes of the attributes' colours
// (`colors`), what it reflects of an environment by its own rule (`environment`), and the light that it scatters, also from
// behind (`scattered`). And with its coat and what comes through it, which the rest of f may hide. Needs a current context.
#pragma once

#include <string>
#include <vector>

#include "renderer/model_health.h"
#include "renderer/probe_points.h"

namespace glint {

struct HookFault {
  Law law = Law::Finite;       // Finite, NonNegative or Energy
  double value = 0;            // the worst
  std::string function;        // "environment"
  int line = 0;                // of it in the model's file; 0: unknown
  ProbePoint point;
  std::vector<glm::vec4> constants;   // of the point, when it has parameters of its own
};

// Of each function at most one for each law, that of the worst value. Empty for a model without such functions.
std::vector<HookFault> hookFaults(const ShadingModel&);

}  // namespace glint
