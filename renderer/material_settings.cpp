#include "renderer/material_settings.h"

#include <algorithm>

#include "materials/attributes.h"

namespace glint {
namespace {

// The parameter nodes' names, which are what uniforms are called (materials/graph_compile.h).
std::vector<std::string> parameterNames(const Material& material) {
  std::vector<std::string> names;
  for (const auto& [id, node] : material.nodes)
    if (node.kind == "parameter") names.push_back(settingText(node, "name", id));
  return names;
}

bool isOverride(const ShadingModel& model, const std::string& name) {
  return findAttribute(name) || model.parameter(name);
}

Diagnostics setUniform(CompiledMaterial& compiled, const Setting& setting, const std::string& place) {
  UniformField* field = compiled.uniform(setting.name);
  // Pruned: the surface does not depend on it.
  if (!field) return {};
  const auto value = parseValue(field->value.type, setting.text);
  if (!value)
    return {error(place, fmt::format("'{}' is not {} for {}", setting.text, described(field->value.type), setting.name),
                  valueHint(field->value.type))};
  // The range of a parameter is its author's, unless the author went beyond it too.
  if (inRange(field->value, field->minimum, field->maximum) && !inRange(*value, field->minimum, field->maximum))
    return {error(place, fmt::format("{} {} is out of range", setting.name, valueText(*value)),
                  fmt::format("{} to {} are allowed", field->minimum, field->maximum))};
  field->value = *value;
  return {};
}

}  // namespace

bool takesSetting(const Material& material, const ShadingModel& model, const std::string& name) {
  const auto names = parameterNames(material);
  return isOverride(model, name) || std::find(names.begin(), names.end(), name) != names.end();
}

Result<SurfaceMaterial> surfaceWith(const Material& material, const ModelPtr& model, std::span<const Setting> settings,
                                    const std::string& place, const MaterialSources& sources, Diagnostics& problems) {
  Material changed = material;
  // Under another model than its own, as in a comparison, what only its own has means nothing and is no fault.
  if (model->id != material.model)
    std::erase_if(changed.modelParameters, [&](const auto& given) { return !model->parameter(given.first); });
  Diagnostics faults;
  const auto add = [&](const Diagnostics& more) { faults.insert(faults.end(), more.begin(), more.end()); };
  const auto placeOf = [&](const Setting& setting) { return setting.from.empty() ? place : setting.from; };
  for (const Setting& setting : settings) {
    if (!takesSetting(material, *model, setting.name)) {
      std::vector<std::string> known = attributeNames();
      for (const ModelParameter& parameter : model->parameters) known.push_back(parameter.name);
      for (const std::string& name : parameterNames(material)) known.push_back(name);
      faults.push_back(error(placeOf(setting), fmt::format("material '{}' with model '{}' has no '{}'", material.name, model->id, setting.name),
                             suggestion(setting.name, known)));
    } else if (isOverride(*model, setting.name)) {
      Diagnostics refused = overrideAttribute(changed, *model, setting.name, setting.text);
      for (Diagnostic& d : refused) d.place = placeOf(setting);
      add(refused);
    }
  }
  if (!faults.empty()) return faults;
  auto compiled = compileMaterial(changed, *model, sources.nodes, sources.functions, sources.compile, &problems);
  if (!compiled) return compiled.diagnostics();
  for (const Setting& setting : settings)
    if (!isOverride(*model, setting.name)) add(setUniform(*compiled, setting, placeOf(setting)));
  if (!faults.empty()) return faults;
  return surfaceMaterial(std::make_shared<CompiledMaterial>(std::move(*compiled)), model, sources.textures, problems);
}

}  // namespace glint
