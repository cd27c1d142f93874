// Numbers on request: any term, model value or integral over the hemisphere, evaluated on the device from the GLSL that
// draws. What can be asked for is in evaluation.cpp, one handler a quantity. Needs a current context.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "materials/model_registry.h"

namespace glint {

struct EvaluationRequest {
  // A term ("D_GGX", "G_SmithGGX", "V_Neumann", "F_Schlick", "Fd_EON", "f_ggx" for a model's value) or a quantity
  // ("directional_albedo").
  std::string what;
  std::map<std::string, double, std::less<>> numbers;                 // arguments: "r", "NoV"
  std::map<std::string, std::vector<double>, std::less<>> vectors;    // and those with several: "baseColor"
  std::map<std::string, std::string, std::less<>> names;              // "model", "D", "G", "F": what is asked about
  std::set<std::string> extras;                                       // further values wanted, by name
};

struct EvaluationResult {
  std::map<std::string, std::vector<double>> values;  // "value", or by name; one number each, or several
  std::string fault, hint;                            // why there are none
};

// One result a request, in their order. A request that cannot be met has a fault and no values.
std::vector<EvaluationResult> evaluate(std::span<const EvaluationRequest>, const ModelRegistry&);

// Names of the quantities that are no terms.
std::vector<std::string> evaluationQuantities();

}  // namespace glint
