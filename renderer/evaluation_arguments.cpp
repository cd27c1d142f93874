#include "renderer/evaluation_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "materials/terms.h"

namespace glint {
namespace {

// What a number may be. What is beyond it by no more than a computation's last digits is taken as the end.
struct Range {
  double low, high;
  bool openLow;
  std::string_view what;  // for hints: "a cosine above the surface is from 0 to 1"
};
constexpr double kSlack = 1e-6;
constexpr double kLongest = 1e9;
constexpr Range kUnit{0, 1, false, "it is from 0 to 1"};
constexpr Range kRoughness{0, 1, false, "a roughness is from 0 to 1"};
constexpr Range kCosine{0, 1, false, "a cosine above the surface is from 0 to 1"};
constexpr Range kAnyCosine{-1, 1, false, "a cosine is from -1 to 1"};
constexpr Range kPositive{0, kLongest, true, "it is above 0"};
constexpr Range kLength{0, kLongest, false, "a length is from 0 to 1e9 m"};
constexpr Range kPlace{-kLongest, kLongest, false, "a place is within 1e9 m"};
constexpr Range kSwitch{0, 1, false, "0 is off, 1 is on"};

struct Rule {
  std::string_view name;
  ArgumentKind kind;
  Range range;
};
constexpr Rule kRules[] = {
    {"r", ArgumentKind::Number, kRoughness},       {"roughness", ArgumentKind::Number, kRoughness},
    {"alpha", ArgumentKind::Number, {0, 1, false, "alpha is from 0 to 1, the square of the roughness"}},
    {"NoL", ArgumentKind::Number, kCosine},        {"NoV", ArgumentKind::Number, kCosine},
    {"NoH", ArgumentKind::Number, kCosine},        {"VoH", ArgumentKind::Number, kCosine},
    {"LoV", ArgumentKind::Number, kAnyCosine},     {"RoL", ArgumentKind::Number, kAnyCosine},
    {"XoH", ArgumentKind::Number, kAnyCosine},     {"YoH", ArgumentKind::Number, kAnyCosine},
    {"XoL", ArgumentKind::Number, kAnyCosine},     {"YoL", ArgumentKind::Number, kAnyCosine},
    {"XoV", ArgumentKind::Number, kAnyCosine},     {"YoV", ArgumentKind::Number, kAnyCosine},
    {"ax", ArgumentKind::Number, kPositive},       {"ay", ArgumentKind::Number, kPositive},
    {"F0", ArgumentKind::Number, {0, 1, false, "a reflectance is from 0 to 1"}},
    {"albedo", ArgumentKind::Number, {0, 1, false, "an albedo is from 0 to 1"}},
    {"gloss", ArgumentKind::Number, kUnit},        {"metallic", ArgumentKind::Number, kUnit},
    {"specular", ArgumentKind::Number, kUnit},     {"distance", ArgumentKind::Number, kLength},
    {"lightRadius", ArgumentKind::Number, kPositive}, {"sourceRadius", ArgumentKind::Number, kLength},
    {"radius", ArgumentKind::Number, {1e-4, kLongest, false, "a light with a surface has a radius of 0.0001 m and more"}},
    {"view_azimuth", ArgumentKind::Number, {-kLongest, kLongest, false, "an angle in radians"}},
    {"center", ArgumentKind::Numbers, kPlace},     {"L0", ArgumentKind::Numbers, kPlace},
    {"L1", ArgumentKind::Numbers, kPlace},         {"env", ArgumentKind::Name, {}},
    {"environment", ArgumentKind::Number, kSwitch}, {"compensate", ArgumentKind::Number, kSwitch},
    {"l", ArgumentKind::Numbers, kAnyCosine},      {"v", ArgumentKind::Numbers, kAnyCosine},
    {"baseColor", ArgumentKind::Numbers, {0, 1, false, "a base color is from 0 to 1 in each channel"}},
    {"model", ArgumentKind::Name, {}},             {"D", ArgumentKind::Name, {}},
    {"G", ArgumentKind::Name, {}},                 {"V", ArgumentKind::Name, {}},
    {"F", ArgumentKind::Name, {}},                 {"diffuse", ArgumentKind::Name, {}},
};

const Rule* ruleOf(std::string_view name) {
  const auto* at = std::find_if(std::begin(kRules), std::end(kRules), [&](const Rule& r) { return r.name == name; });
  return at == std::end(kRules) ? nullptr : at;
}

bool holds(const Range& range, double value) {
  return (range.openLow ? value > range.low : value >= range.low - kSlack) && value <= range.high + kSlack;
}

EvaluationFault outOfRange(std::string_view name, double value, const Range& range) {
  return {fmt::format("{} {:.6g} is out of range", name, value), std::string(range.what)};
}

void checkDirection(const std::string& name, const std::vector<double>& v, bool aboveSurface, std::vector<EvaluationFault>& faults) {
  if (v.size() != 3) {
    faults.push_back({fmt::format("'{}' has {} numbers", name, v.size()), "a direction is [x, y, z] with the normal along z"});
    return;
  }
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!(std::abs(length - 1) < 1e-3)) faults.push_back({fmt::format("the direction '{}' is {:.6g} long", name, length), "give it the length 1"});
  else if (aboveSurface && v[2] < -kSlack)
    faults.push_back({fmt::format("the direction '{}' points below the surface", name), "its third number is its cosine to the normal, from 0 to 1"});
}

// Before the names of numbers that are parameters of the model, in a request that is understood().
constexpr std::string_view kOwn = "own ";

// The id of the model that a request asks about; empty for terms and other quantities.
std::string modelAskedFor(const EvaluationRequest& request) {
  if (request.what.starts_with("f_")) return request.what.substr(2);
  return request.names.count("model") || request.names.count("D") ? evaluation::subject(request) : std::string();
}

// The parameters of what a request asks about, with their ranges; nothing when it is unknown, which evaluate() reports.
struct Parameters {
  bool known = false, ofModel = false;
  struct Parameter {
    std::string name;
    float minimum, maximum;
  };
  std::vector<Parameter> list;
  const Parameter* find(std::string_view name) const {
    const auto at = std::find_if(list.begin(), list.end(), [&](const Parameter& p) { return p.name == name; });
    return at == list.end() ? nullptr : &*at;
  }
};

Parameters parametersAskedFor(const EvaluationRequest& request, const ModelRegistry& registry, const std::vector<Term>& library) {
  Parameters found;
  if (const std::string id = modelAskedFor(request); !id.empty()) {
    const auto model = registry.named(id);
    if (!model) return found;
    found.known = found.ofModel = true;
    for (const ModelParameter& p : (*model)->parameters) {
      found.list.push_back({p.name, p.minimum, p.maximum});
      if (!p.fileName.empty() && p.fileName != p.name) found.list.push_back({p.fileName, p.minimum, p.maximum});
    }
    return found;
  }
  const std::vector<std::string> quantities = evaluationQuantities();
  found.known = std::find(quantities.begin(), quantities.end(), request.what) != quantities.end();
  for (const Term& t : library) {
    const bool asG = t.kind == TermKind::V && request.what == "G_" + t.name;
    if (request.what != t.function() && !asG) continue;
    found.known = true;
    for (const TermParameter& p : t.parameters) found.list.push_back({p.name, p.minimum, p.maximum});
  }
  return found;
}

}  // namespace

ArgumentKind argumentKind(std::string_view name) {
  const Rule* rule = ruleOf(name);
  return rule ? rule->kind : ArgumentKind::Number;
}

std::vector<EvaluationFault> faultsOf(const EvaluationRequest& request, const ModelRegistry& registry, const std::vector<Term>& library) {
  std::vector<EvaluationFault> faults;
  const Parameters parameters = parametersAskedFor(request, registry, library);
  const auto own = evaluation::parametersOf(request);
  for (const auto& [name, value] : request.numbers) {
    const Rule* rule = ruleOf(name);
    const auto* parameter = parameters.ofModel || own.count(name) ? parameters.find(name) : nullptr;
    if (parameter) {
      // A term of itself is a function, whose range is only what sliders have.
      const bool within = value >= parameter->minimum - kSlack && value <= parameter->maximum + kSlack;
      if (!within && parameters.ofModel)
        faults.push_back({fmt::format("{} {:.6g} is out of range", name, value), fmt::format("{:g} to {:g} are allowed", parameter->minimum, parameter->maximum)});
      else if (!within && !(std::abs(value) <= kLongest)) faults.push_back(outOfRange(name, value, kLength));
    } else if (rule && rule->kind == ArgumentKind::Number) {
      if (!holds(rule->range, value)) faults.push_back(outOfRange(name, value, rule->range));
    } else if (parameters.known) {
      std::vector<std::string> names;
      for (const Rule& r : kRules) names.emplace_back(r.name);
      for (const auto& p : parameters.list) names.push_back(p.name);
      const std::string near = nearest(name, names);
      faults.push_back({fmt::format("'{}' has no argument '{}'", request.what, name),
                        near.empty() ? "glint models lists the parameters of models" : fmt::format("did you mean '{}'?", near)});
    }
  }
  // A D and an F only have the half vector of two directions, and cosines that are given go before directions.
  const bool litFrom = !request.what.starts_with("D_") && !request.what.starts_with("F_") && !request.numbers.count("NoL") && !request.numbers.count("NoH");
  for (const auto& [name, values] : request.vectors) {
    const Rule* rule = ruleOf(name);
    if (name == "l" || name == "v") checkDirection(name, values, litFrom, faults);
    else if (rule)
      for (const double value : values)
        if (!holds(rule->range, value)) faults.push_back(outOfRange(name, value, rule->range));
  }
  std::vector<std::string> widths;
  for (const char* name : {"alpha", "roughness", "r"})
    if (request.numbers.count(name) && !(parameters.ofModel && parameters.find(name))) widths.emplace_back(name);
  for (size_t i = 1; i < widths.size(); ++i) {
    const auto roughnessBy = [&](const std::string& name) {
      const double value = request.numbers.find(name)->second;
      return name == "alpha" ? std::sqrt(std::max(value, 0.0)) : value;
    };
    if (std::abs(roughnessBy(widths[0]) - roughnessBy(widths[i])) > 1e-6)
      faults.push_back({fmt::format("the roughness is given twice, by '{}' and by '{}', and differs", widths[0], widths[i]),
                        "give one of r, roughness and alpha, which is its square"});
  }
  return faults;
}

namespace evaluation {

double number(const EvaluationRequest& request, std::string_view name) {
  const auto found = request.numbers.find(name);
  if (found == request.numbers.end()) throw EvaluationFault{fmt::format("'{}' needs the argument '{}'", request.what, name), ""};
  const Rule* rule = ruleOf(name);
  return rule && holds(rule->range, found->second) ? std::clamp(found->second, rule->range.low, rule->range.high) : found->second;
}

double number(const EvaluationRequest& request, std::string_view name, double otherwise) {
  return request.numbers.count(std::string(name)) ? number(request, name) : otherwise;
}

bool hasRoughness(const EvaluationRequest& request) {
  return request.numbers.count("alpha") || request.numbers.count("roughness") || request.numbers.count("r");
}

double roughness(const EvaluationRequest& request) {
  if (request.numbers.count("alpha")) return std::sqrt(number(request, "alpha"));
  return request.numbers.count("roughness") ? number(request, "roughness") : number(request, "r");
}

std::vector<double> vectorOf(const EvaluationRequest& request, std::string_view name, size_t size) {
  const auto found = request.vectors.find(name);
  if (found == request.vectors.end() || found->second.size() != size)
    throw EvaluationFault{fmt::format("'{}' needs '{}' as {} numbers", request.what, name, size), ""};
  return found->second;
}

bool compensated(const EvaluationRequest& request) { return number(request, "compensate", 0) != 0; }

bool underEnvironment(const EvaluationRequest& request) { return number(request, "environment", 0) != 0; }

ProbePoint pointOf(const EvaluationRequest& request, const std::vector<std::string>& needed) {
  ProbePoint p;
  if (request.vectors.count("l") && request.vectors.count("v") && !request.numbers.count("NoL") && !request.numbers.count("NoH")) {
    const auto l = vectorOf(request, "l", 3), v = vectorOf(request, "v", 3);
    p = ProbePoint::at(glm::normalize(glm::dvec3(l[0], l[1], l[2])), glm::normalize(glm::dvec3(v[0], v[1], v[2])));
  } else {
    for (const std::string& name : needed) number(request, name);
    const double LoV = number(request, "LoV", 2);
    const double VoH = number(request, "VoH", LoV <= 1 ? std::sqrt(0.5 * (1 + LoV)) : 1);
    p = ProbePoint::cosines(number(request, "NoL", 1), number(request, "NoV", 1), number(request, "NoH", 1), VoH);
    if (LoV <= 1) p.LoV = static_cast<float>(LoV);
  }
  if (hasRoughness(request)) p.roughness = static_cast<float>(roughness(request));
  p.F0 = glm::vec3(static_cast<float>(number(request, "F0", 1)));
  p.diffuseColor = glm::vec3(static_cast<float>(number(request, "albedo", 1)));
  p.metallic = static_cast<float>(number(request, "metallic", 0));
  p.specular = static_cast<float>(number(request, "specular", 0.5));
  p.analyticLight = !underEnvironment(request);
  return p;
}

std::string subject(const EvaluationRequest& request) {
  const auto named = [&](std::string_view key, std::string_view otherwise) {
    const auto found = request.names.find(key);
    return found == request.names.end() ? std::string(otherwise) : found->second;
  };
  if (request.names.count("model")) return named("model", "");
  if (!request.names.count("D")) throw EvaluationFault{fmt::format("'{}' needs a model, or D and G", request.what), ""};
  std::string id = named("D", "") + "*" + named("V", named("G", "Implicit")) + "*" + named("F", "None");
  return request.names.count("diffuse") ? id + "*" + named("diffuse", "") : id;
}

std::map<std::string, double> parametersOf(const EvaluationRequest& request) {
  static const std::set<std::string, std::less<>> kOthers = {"r", "roughness", "alpha", "NoL", "NoV", "NoH", "VoH", "LoV", "RoL",
                                                             "F0", "albedo", "environment", "ax", "ay", "compensate"};
  std::map<std::string, double> parameters;
  for (const auto& [name, value] : request.numbers) {
    if (name.starts_with(kOwn)) parameters[name.substr(kOwn.size())] = value;
    else if (!kOthers.count(name)) parameters[name] = value;
  }
  return parameters;
}

EvaluationRequest understood(const EvaluationRequest& request, const ModelRegistry& registry) {
  const std::string id = modelAskedFor(request);
  if (id.empty()) return request;
  const auto model = registry.named(id);
  if (!model) return request;
  EvaluationRequest made = request;
  for (const auto& [name, value] : request.numbers)
    if ((*model)->parameter(name)) {
      made.numbers.erase(name);
      made.numbers[std::string(kOwn) + name] = value;
    }
  const auto reads = [&](std::string_view attribute) { return (*model)->reads(attribute); };
  if (!reads("roughness")) {
    for (const char* name : {"r", "alpha"}) made.numbers.erase(name);
    made.numbers["roughness"] = 0.5;
  }
  if (!reads("baseColor") && !reads("metallic") && !reads("specular")) made.numbers["F0"] = 1;
  return made;
}

bool isAttribute(std::string_view name) { return name == "metallic" || name == "specular"; }

}  // namespace evaluation
}  // namespace glint
