// Numbers on request: any term, model value or integral over the hemisphere, evaluated on the device from the GLSL that
// draws. What can be asked for is in evaluation.cpp, one handler a quantity. Needs a current context.
//
// Pictures keep alpha above 0.0005. Terms and models' values are evaluated without that floor; integrals, and models with
// tables that Glint derived for pictures, have it, and results say so where it counts.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "materials/model_registry.h"
#include "materials/terms.h"

namespace glint {

// Radiance by direction d: constant + linear . d + the sum of amplitude exp(sharpness (d . axis - 1)), at least 0.
struct EnvironmentFormula {
  struct Lobe {
    glm::dvec3 axis{0, 0, 1};   // unit
    double amplitude = 0, sharpness = 1;
  };
  double constant = 0;
  glm::dvec3 linear{0};
  std::vector<Lobe> lobes;
};

struct EvaluationRequest {
  // A term ("D_GGX", "G_SmithGGX", "V_Neumann", "F_Schlick", "Fd_EON", "f_ggx" for a model's value) or a quantity
  // ("directional_albedo").
  std::string what;
  std::map<std::string, double, std::less<>> numbers;                 // arguments: "r", "NoV"
  std::map<std::string, std::vector<double>, std::less<>> vectors;    // and those with several: "baseColor"
  std::map<std::string, std::string, std::less<>> names;              // "model", "D", "G", "F": what is asked about
  std::set<std::string> extras;                                       // further values wanted, by name; of what is within others "a.b"
  // Of what is asked of several models at once: names for the values, and ids. May be empty.
  std::vector<std::pair<std::string, std::string>> models;
  std::shared_ptr<const EnvironmentFormula> environment;              // may be null
};

struct EvaluationResult {
  std::map<std::string, std::vector<double>> values;  // "value", or by name; one number each, or several
  std::string fault, hint;                            // why there are none
  std::string note;                                   // how they differ from what was asked for; mostly empty
};

// What is wrong with a request: the cause, and what would do.
struct EvaluationFault {
  std::string what, hint;
};

enum class ArgumentKind { Number, Numbers, Name };
// What an argument of that name must be; those of no name that is known are parameters of models, which are numbers.
ArgumentKind argumentKind(std::string_view name);

// All that is wrong with a request's arguments before it is evaluated: beyond what they may be, or of no name that
// anything has. What is missing, or asked of what there is not, evaluate() tells.
std::vector<EvaluationFault> faultsOf(const EvaluationRequest&, const ModelRegistry&, const std::vector<Term>& library);

// One result a request, in their order. A request that cannot be met has a fault and no values.
std::vector<EvaluationResult> evaluate(std::span<const EvaluationRequest>, const ModelRegistry&);

// Names of what can be asked for beside the terms and the models' values.
std::vector<std::string> evaluationQuantities();

}  // namespace glint
