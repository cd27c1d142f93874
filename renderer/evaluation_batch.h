// Work for the device, gathered from many requests (evaluation.h) so that it runs in a few large pieces.
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "renderer/evaluation.h"
#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"
#include "renderer/reference_probe.h"

namespace glint::evaluation {

class Batch {
 public:
  explicit Batch(const ModelRegistry& registry) : registry_(registry) {}

  // The value of a vec4 expression (ModelProbe::ofChoices) at a point, at its own alpha.
  size_t point(const std::string& expression, ProbePoint);
  glm::dvec4 pointValue(size_t ticket) const { return pointValues_[ticket]; }

  // A model's specular value at a point: (r, g, b, D); at the point's own alpha unless hasTables().
  struct ModelTicket {
    size_t model, index;
  };
  ModelTicket modelPoint(const std::string& id, const ProbePoint&, const std::map<std::string, double>& parameters, bool compensate);
  glm::dvec4 modelValue(ModelTicket t) const { return models_[t.model].pointValues[2 * t.index]; }
  // Whether it looks into tables that Glint derived from it (model_tables.h), which are those of pictures.
  static bool hasTables(const ShadingModel& m, bool compensate) { return compensate || m.compensate || m.smithOfOwnD; }

  ModelTicket integral(const std::string& id, const IntegralQuery&, const std::map<std::string, double>& parameters = {}, bool compensate = false);
  const ModelIntegral& integral(ModelTicket t) const { return models_[t.model].integrals[t.index]; }

  // What is wrong with the GLSL of a model, known after run().
  std::string faultOf(ModelTicket t) const { return models_[t.model].fault; }

  void run();

  const ModelRegistry& registry() const { return registry_; }
  // Asked when all else has run.
  ReferenceProbe& reference() const;
  // A formula's, made once of the picture that `make` gives.
  const EnvironmentSampler& environment(const EnvironmentFormula&, const std::function<ImageF()>& make) const;

 private:
  struct Model {
    ModelPtr model;
    std::map<std::string, double> parameters;
    bool compensate = false;
    std::vector<ProbePoint> points;
    std::vector<glm::dvec4> pointValues;
    std::vector<IntegralQuery> queries;
    std::vector<ModelIntegral> integrals;
    std::string fault;
  };
  // Throws EvaluationFault where there is no such model or parameter.
  size_t model(const std::string& id, const std::map<std::string, double>& parameters, bool compensate);
  static void runModel(Model&);

  const ModelRegistry& registry_;
  std::vector<std::string> expressions_;
  std::map<std::string, int> expressionIndex_;
  std::vector<ProbePoint> points_;
  std::vector<glm::dvec4> pointValues_;
  std::vector<Model> models_;
  std::map<std::string, size_t> modelIndex_;
  mutable std::unique_ptr<ReferenceProbe> reference_;
  mutable std::map<const EnvironmentFormula*, EnvironmentSampler> environments_;
};

// The values of one request, named, once the batch has run.
using Values = std::map<std::string, std::vector<double>>;
using Finish = std::function<Values(const Batch&)>;

}  // namespace glint::evaluation
