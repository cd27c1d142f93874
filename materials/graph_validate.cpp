#include "materials/graph_validate.h"

#include <algorithm>
#include <functional>
#include <set>
#include <unordered_map>

#include "materials/front_matter.h"
#include "materials/function_library.h"
#include "materials/graph_analysis.h"
#include "materials/model.h"
#include "materials/node_registry.h"

namespace glint {
namespace {

constexpr size_t kDeepestCalls = 16;

// Judges a document and, once each, the functions that it calls.
class Validator {
 public:
  explicit Validator(const GraphContext& context) : context_(context) {}

  void visit(const Material& material) {
    const GraphAnalysis analysis = analyse(material, context_);
    problems.insert(problems.end(), analysis.problems.begin(), analysis.problems.end());
    if (!context_.functions) return;
    calling_.push_back(&material);
    for (const auto& [id, info] : analysis.nodes) {
      if (!info.kind || (info.kind->builtin != Builtin::Function && info.kind->builtin != Builtin::Layer)) continue;
      const std::string name = settingText(*info.node, "function");
      if (name.empty()) continue;
      const auto found = context_.functions->find(name, material.file.parent_path());
      if (!found) continue;  // reported by the analysis
      const Material* function = found->get();
      const auto sameDocument = [&](const Material* other) {
        return other == function || (!other->file.empty() && other->file == function->file);
      };
      if (std::any_of(calling_.begin(), calling_.end(), sameDocument)) {
        problems.push_back(error(material.place(id), fmt::format("'{}' calls itself", name),
                                 "a function cannot be a part of itself"));
      } else if (calling_.size() >= kDeepestCalls) {
        problems.push_back(error(material.place(id), fmt::format("calls nested deeper than {}", kDeepestCalls), "put the inner ones together into one function"));
      } else if (seen_.insert(function).second) {
        held_.push_back(*found);
        visit(*function);
      }
    }
    calling_.pop_back();
  }

  Diagnostics problems;

 private:
  const GraphContext& context_;
  std::vector<const Material*> calling_;
  std::set<const Material*> seen_;
  std::vector<MaterialPtr> held_;  // so that addresses stay distinct
};

}  // namespace

Diagnostics validate(const Material& material, const GraphContext& context) {
  Validator validator(context);
  validator.visit(material);
  if (context.model)
    for (const auto& [name, value] : material.modelParameters) {
      const ModelParameter* parameter = context.model->parameter(name);
      std::vector<std::string> known;
      for (const ModelParameter& p : context.model->parameters) known.push_back(p.name);
      if (!parameter)
        validator.problems.push_back(
            warning(material.place(), fmt::format("model '{}' has no parameter '{}'; it is kept", context.model->id, name),
                    suggestion(name, known)));
      else if (!coerced(value, parameter->standard.type))
        validator.problems.push_back(error(material.place(), fmt::format("model parameter '{}' is not {}", name,
                                                                         described(parameter->standard.type)),
                                           jsonHint(parameter->standard.type)));
      else if (!inRange(value, parameter->minimum, parameter->maximum))
        validator.problems.push_back(
            warning(material.place(), fmt::format("model parameter '{}' is {}, outside {} to {}; the nearest is used", name,
                                                  valueText(value), parameter->minimum, parameter->maximum)));
    }
  return std::move(validator.problems);
}

Diagnostics connectionProblems(const Material& material, const GraphContext& context, const PinRef& from,
                               const PinRef& to) {
  const std::string place = material.place(to.node, to.pin);
  const Node* source = material.node(from.node);
  const Node* target = material.node(to.node);
  if (!source || !target) return {error(place, "one end of the wire is not there")};
  const std::filesystem::path folder = material.file.parent_path();
  if (!pinsOf(*source, context, folder)->output(from.pin))
    return {error(place, fmt::format("'{}' has no output '{}'", from.node, from.pin))};
  if (!pinsOf(*target, context, folder)->input(to.pin))
    return {error(place, fmt::format("'{}' has no input '{}'", to.node, to.pin))};
  if (from.node == to.node) return {error(place, "a node cannot feed itself")};

  // The graph with the wire, against the graph without: what is new is the wire's fault.
  Material without = material, with = material;
  without.nodes[to.node].inputs[to.pin].from.reset();
  with.nodes[to.node].inputs[to.pin].from = from;
  const Diagnostics before = analyse(without, context).problems;
  Diagnostics fresh;
  for (Diagnostic& d : analyse(with, context).problems)
    if (d.severity == Severity::Error && std::find(before.begin(), before.end(), d) == before.end())
      fresh.push_back(std::move(d));
  return fresh;
}

std::vector<NodeId> topologicalOrder(const Material& material, std::vector<NodeId>* cycle) {
  // Kahn's algorithm over indices in the order of ids; the ready node with the smallest id comes first.
  std::vector<const NodeId*> ids;
  std::unordered_map<std::string_view, int> indexOf;
  for (const auto& [id, node] : material.nodes) {
    indexOf[id] = static_cast<int>(ids.size());
    ids.push_back(&id);
  }
  std::vector<std::vector<int>> next(ids.size()), previous(ids.size());
  std::vector<int> waiting(ids.size(), 0);
  int index = 0;
  for (const auto& [id, node] : material.nodes) {
    for (const auto& [pin, input] : node.inputs) {
      if (!input.from) continue;
      const auto source = indexOf.find(input.from->node);
      if (source == indexOf.end()) continue;
      next[source->second].push_back(index);
      previous[index].push_back(source->second);
      ++waiting[index];
    }
    ++index;
  }
  std::set<int> ready;
  for (int i = 0; i < static_cast<int>(ids.size()); ++i)
    if (waiting[i] == 0) ready.insert(i);
  std::vector<NodeId> order;
  order.reserve(ids.size());
  while (!ready.empty()) {
    const int i = *ready.begin();
    ready.erase(ready.begin());
    order.push_back(*ids[i]);
    for (const int j : next[i])
      if (--waiting[j] == 0) ready.insert(j);
  }
  if (cycle && order.size() < ids.size()) {
    // Each node that waits is fed by another that waits: going back must come round.
    int at = 0;
    while (waiting[at] == 0) ++at;
    std::vector<int> path, placeInPath(ids.size(), -1);
    while (placeInPath[at] < 0) {
      placeInPath[at] = static_cast<int>(path.size());
      path.push_back(at);
      for (const int before : previous[at])
        if (waiting[before] > 0) {
          at = before;
          break;
        }
    }
    for (size_t i = path.size(); i-- > static_cast<size_t>(placeInPath[at]);) cycle->push_back(*ids[path[i]]);
    std::rotate(cycle->begin(), std::min_element(cycle->begin(), cycle->end()), cycle->end());
  }
  return order;
}

std::map<PinRef, ValueType> outputTypes(const Material& material, const GraphContext& context) {
  return analyse(material, context).outputs;
}

}  // namespace glint
