#include "renderer/evaluation_batch.h"

#include <fmt/format.h>

#include "materials/base/check.h"
#include "renderer/evaluation_arguments.h"

namespace glint::evaluation {

size_t Batch::point(const std::string& expression, ProbePoint p) {
  const auto [at, fresh] = expressionIndex_.try_emplace(expression, static_cast<int>(expressions_.size()));
  if (fresh) expressions_.push_back(expression);
  p.choice = at->second;
  points_.push_back(p);
  return points_.size() - 1;
}

Batch::ModelTicket Batch::modelPoint(const std::string& id, const ProbePoint& p, const std::map<std::string, double>& parameters, bool compensate) {
  const size_t m = model(id, parameters, compensate);
  models_[m].points.push_back(p);
  return {m, models_[m].points.size() - 1};
}

Batch::ModelTicket Batch::integral(const std::string& id, const IntegralQuery& query, const std::map<std::string, double>& parameters, bool compensate) {
  const size_t m = model(id, parameters, compensate);
  models_[m].queries.push_back(query);
  return {m, models_[m].queries.size() - 1};
}

void Batch::run() {
  if (!points_.empty()) {
    auto probe = ModelProbe::ofChoices(expressions_);
    GLINT_CHECK(probe.ok(), "{}", probe.diagnostics()[0].text());
    for (const glm::vec4& v : probe->evaluate(points_)) pointValues_.emplace_back(v);
  }
  for (Model& m : models_) runModel(m);
}

ReferenceProbe& Batch::reference() const {
  if (!reference_) reference_ = std::make_unique<ReferenceProbe>();
  return *reference_;
}

const EnvironmentSampler& Batch::environment(const EnvironmentFormula& formula, const std::function<ImageF()>& make) const {
  const auto found = environments_.find(&formula);
  return found != environments_.end() ? found->second : environments_.emplace(&formula, EnvironmentSampler(make())).first->second;
}

size_t Batch::model(const std::string& id, const std::map<std::string, double>& parameters, bool compensate) {
  std::string key = id + (compensate ? " compensated" : "");
  for (const auto& [name, value] : parameters) key += fmt::format(" {}={}", name, value);
  if (const auto found = modelIndex_.find(key); found != modelIndex_.end()) return found->second;
  const auto made = registry_.named(id);
  if (!made) {
    const Diagnostic& fault = made.diagnostics()[0];
    throw EvaluationFault{(fault.place == unknownModelPlace(id) ? "" : fault.place + ": ") + fault.what, fault.hint};
  }
  std::map<std::string, double> own;  // by the names that Glint has for them
  for (const auto& [name, value] : parameters) {
    if (const ModelParameter* parameter = (*made)->parameter(name)) own[parameter->name] = value;
    else if (!isAttribute(name)) throw EvaluationFault{fmt::format("'{}' has no parameter '{}'", id, name), ""};
  }
  models_.push_back({*made, std::move(own), compensate || (*made)->compensate, {}, {}, {}, {}, {}});
  return modelIndex_[key] = models_.size() - 1;
}

void Batch::runModel(Model& m) {
  if (!m.points.empty()) {
    auto probe = ModelProbe::ofModel(*m.model, m.compensate, !hasTables(*m.model, m.compensate));
    if (!probe) return void(m.fault = probe.diagnostics()[0].text());
    for (const auto& [name, value] : m.parameters) probe->set(name, Value::scalar(static_cast<float>(value)));
    for (const glm::vec4& v : probe->evaluate(m.points)) m.pointValues.emplace_back(v);
  }
  if (!m.queries.empty()) {
    // Integrals are made of thousands of values: not of a model that takes too long for one.
    if (m.points.empty())
      if (const auto probe = ModelProbe::ofModel(*m.model); !probe) return void(m.fault = probe.diagnostics()[0].text());
    auto integrals = ModelIntegrals::of(*m.model, {.compensate = m.compensate});
    if (!integrals) return void(m.fault = integrals.diagnostics()[0].text());
    for (const auto& [name, value] : m.parameters) integrals->set(name, Value::scalar(static_cast<float>(value)));
    m.integrals = integrals->evaluate(m.queries);
  }
}

}  // namespace glint::evaluation
