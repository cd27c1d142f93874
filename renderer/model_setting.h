// A shading model with values for its parameters, as programs that hold its GLSL take it.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "materials/model.h"
#include "renderer/gl/objects.h"

namespace glint {

// A model's GLSL, made once.
struct ModelShader {
  std::shared_ptr<const ShadingModel> model;
  std::string glsl;
  uint64_t hash = 0;                     // of glsl, which holds the shipped terms it uses

  explicit ModelShader(std::shared_ptr<const ShadingModel>);
};

// A model with one value for each of its parameters: those of a material, where they do not vary over it.
struct ModelSetting {
  std::shared_ptr<const ModelShader> shader;
  std::array<float, 4> slots{};          // by ModelParameter::slot
  std::vector<glm::vec4> constants;      // glintModelConstants: one each without a slot, at least one
  bool plainNonmetal = false;            // Shading::plainNonmetal, for models that read it

  uint64_t key() const;                  // of the text and the values
  // Another value for a parameter; nothing when the model has none of that name.
  void set(const std::string& parameter, const Value&);
  // Sets standardParameters, glintModelConstants and plainNonmetal. Who draws calls ModelTables::apply() instead, which
  // binds what was derived from the model too.
  void apply(const gl::Program&) const;
};
// `values` are in the order of the model's parameters; those missing are at their defaults.
ModelSetting modelSetting(std::shared_ptr<const ModelShader>, const std::vector<Value>& values, bool plainNonmetal = false);
// With all parameters at their defaults.
ModelSetting modelSetting(const ShadingModel&);

}  // namespace glint
