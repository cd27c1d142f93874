// The arguments of requests (evaluation.h): which there are, what they may be, and how they are read.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/evaluation.h"
#include "renderer/model_probe.h"

namespace glint::evaluation {

// Of a request: an argument that must be there. Throws EvaluationFault.
double number(const EvaluationRequest&, std::string_view name);
double number(const EvaluationRequest&, std::string_view name, double otherwise);
std::vector<double> vectorOf(const EvaluationRequest&, std::string_view name, size_t size);
// "r", "roughness" or "alpha", which is its square.
double roughness(const EvaluationRequest&);
bool hasRoughness(const EvaluationRequest&);
// "compensate": 1 asks for the model with the lobe of further bounces.
bool compensated(const EvaluationRequest&);
// "environment": 1 asks for the model as an environment lights it, where that differs.
bool underEnvironment(const EvaluationRequest&);
// What a request asks about: a model's id, or a mix of the terms it names; the missing ones do nothing.
std::string subject(const EvaluationRequest&);
// The request as its model understands it: numbers that go by the name of one of the model's own parameters (roughness, alpha
// or F0 of a .brdf) are that parameter, and what the model does not read has a value, so that nobody need give it.
EvaluationRequest understood(const EvaluationRequest&, const ModelRegistry&);
// Numbers that are no argument of the request itself: parameters of the model that it asks about.
std::map<std::string, double> parametersOf(const EvaluationRequest&);
// Attributes of a surface, which every model is given and a .brdf may have as parameters of its own.
bool isAttribute(std::string_view name);
// The point of a term: from two directions l and v about n = +Z, or from the cosines that are given. `needed` must be.
ProbePoint pointOf(const EvaluationRequest&, const std::vector<std::string>& needed);

}  // namespace glint::evaluation
