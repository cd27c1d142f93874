#include "renderer/model_setting.h"

#include "materials/base/hash.h"

namespace glint {

ModelShader::ModelShader(std::shared_ptr<const ShadingModel> m)
    : model(std::move(m)), glsl(modelGlsl(*model, kModelSourceIndex)), hash(hashText(glsl)) {}

ModelSetting modelSetting(std::shared_ptr<const ModelShader> shader, const std::vector<Value>& values, bool plainNonmetal) {
  ModelSetting setting;
  setting.plainNonmetal = plainNonmetal && shader->model->usesPlainNonmetal;
  const auto& parameters = shader->model->parameters;
  for (const ModelParameter& p : parameters)
    if (p.slot < 0) setting.constants.emplace_back(0.0f);
  if (setting.constants.empty()) setting.constants.emplace_back(0.0f);
  setting.shader = std::move(shader);
  for (size_t i = 0; i < parameters.size(); ++i) setting.set(parameters[i].name, i < values.size() ? values[i] : parameters[i].standard);
  return setting;
}

ModelSetting modelSetting(const ShadingModel& model) {
  return modelSetting(std::make_shared<ModelShader>(std::make_shared<const ShadingModel>(model)), {});
}

void ModelSetting::set(const std::string& name, const Value& value) {
  size_t constant = 0;
  for (const ModelParameter& p : shader->model->parameters) {
    if (p.name == name) {
      if (p.slot < 0) constants[constant] = {value.v[0], value.v[1], value.v[2], value.v[3]};
      for (int c = 0; p.slot >= 0 && c < componentCount(p.standard.type) && p.slot + c < 4; ++c)
        slots[static_cast<size_t>(p.slot + c)] = value.v[static_cast<size_t>(c)];
      return;
    }
    constant += p.slot < 0;
  }
}

uint64_t ModelSetting::key() const {
  const uint64_t h = hashBytes(slots.data(), sizeof slots, shader->hash ^ uint64_t{plainNonmetal});
  return hashBytes(constants.data(), constants.size() * sizeof(glm::vec4), h);
}

void ModelSetting::apply(const gl::Program& program) const {
  program.set4("standardParameters", slots.data());
  program.set4("glintModelConstants", &constants[0].x, static_cast<int>(constants.size()));
  program.set("plainNonmetal", plainNonmetal ? 1 : 0);
}

}  // namespace glint
