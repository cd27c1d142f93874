// Attributes from outside: `--set roughness=0.3`, sweeps.
#include "materials/attributes.h"
#include "materials/front_matter.h"
#include "materials/graph_compile.h"

namespace glint {
namespace {

// The graph's output becomes a node that sets attributes, behind a new output that takes them from the
// parameters put there. Gives the new output's id.
NodeId wrapOutput(Material& material) {
  const NodeId wrapped = std::string(kOverridePrefix) + "output";
  if (material.nodes.count(wrapped)) return wrapped;
  const NodeId old = material.outputNode();
  if (old.empty()) return {};
  // Output and set-attributes have the same pins, so the node only changes its kind.
  material.nodes[old].kind = "set-attributes";
  Node output{.kind = "output"};
  output.inputs["attributes"].from = PinRef{old, "attributes"};
  material.nodes[wrapped] = std::move(output);
  return wrapped;
}

}  // namespace

Result<Value> overrideValue(const ShadingModel& model, const std::string& name, std::string_view valueText) {
  const ModelParameter* parameter = model.parameter(name);
  const Attribute* attribute = parameter ? nullptr : findAttribute(name);
  if (!attribute && !parameter) {
    std::vector<std::string> known = attributeNames();
    for (const ModelParameter& p : model.parameters) known.push_back(p.name);
    return error(fmt::format("'{}'", name.substr(0, 80)),
                 fmt::format("is neither an attribute nor a parameter of model '{}'", model.id), suggestion(name, known));
  }
  const ValueType type = attribute ? attribute->standard.type : parameter->standard.type;
  const auto value = parseValue(type, valueText);
  if (!value)
    return error(fmt::format("'{}'", name), fmt::format("'{}' is not {} for {}", valueText.substr(0, 80), described(type), name),
                 valueHint(type));
  const float least = attribute ? attribute->minimum : parameter->minimum, most = attribute ? attribute->most : parameter->maximum;
  if (!inRange(*value, least, most))
    return error(fmt::format("'{}'", name), fmt::format("{} {} is out of range{}", name, glint::valueText(*value), parameter ? fmt::format(" of model '{}'", model.id) : ""),
                 fmt::format("{} to {} are allowed", least, most));
  return *value;
}

Diagnostics overrideAttribute(Material& material, const ShadingModel& model, const std::string& wanted,
                              std::string_view valueText) {
  // A parameter of a .brdf goes by two names.
  const ModelParameter* known = model.parameter(wanted);
  const std::string& name = known ? known->name : wanted;
  const auto value = overrideValue(model, wanted, valueText);
  if (!value) return value.diagnostics();
  const ModelParameter* parameter = model.parameter(name);
  const Attribute* attribute = parameter ? nullptr : findAttribute(name);
  const ValueType type = value->type;
  if (parameter && parameter->slot < 0) {
    material.modelParameters[name] = *value;
    return {};
  }
  const NodeId output = wrapOutput(material);
  if (output.empty()) return {error(material.place(), "has no output node", "add a node of kind 'output'")};
  const NodeId id = std::string(kOverridePrefix) + name;
  Node node{.kind = "parameter"};
  node.settings["name"] = Json::of(name);
  node.settings["type"] = Json::of(std::string(glint::name(type)));
  node.settings["value"] = valueToJson(*value);
  node.settings["min"] = Json::of(attribute ? attribute->minimum : parameter->minimum);
  node.settings["max"] = Json::of(attribute ? attribute->maximum : parameter->maximum);
  material.nodes[id] = std::move(node);
  material.nodes[output].inputs[name].from = PinRef{id, "value"};
  return {};
}

}  // namespace glint
