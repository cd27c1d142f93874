// Evaluates terms and whole models at chosen points through the GLSL that draws, on the device: for numbers
// (tests, `eval`), laws (model_laws.h) and plots. Needs a current context.
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "materials/terms.h"
#include "renderer/model_setting.h"
#include "renderer/model_tables.h"

namespace glint {

// What a `Shading` is made of; the normal is +Z.
struct ProbePoint {
  glm::vec3 light{0, 0, 1}, view{0, 0, 1};   // unit
  float NoL = 1, NoV = 1, NoH = 1, VoH = 1, LoV = 1, sinH2 = 0;
  float roughness = 0.5f;
  glm::vec3 F0{0.04f}, diffuseColor{0.8f}, baseColor{0.8f};
  float metallic = 0, specular = 0.5f;
  bool analyticLight = true;
  bool plainNonmetal = false;                // metallic and specular unconnected, as in shading.glsl
  glm::vec4 a{0}, b{0};                      // arguments of expressions
  // Of a model: its per-pixel parameters are `a`, as where a material varies them, instead of the probe's own.
  bool ownParameters = false;
  int choice = 0;                            // the expression, of ofChoices()
  // The cosines come from `light` and `view` as in a picture (setDirections of shading.glsl) instead of from
  // the members above.
  bool fromDirections = false;
  // F0 and diffuseColor come from baseColor, metallic and specular, by the model's own rule where it has one, instead of
  // from the members above.
  bool fromAttributes = false;

  // All cosines from two unit vectors, in double precision.
  static ProbePoint at(glm::dvec3 light, glm::dvec3 view);
  // As given; `light` and `view` are then a pair of directions that has NoL, NoV and VoH.
  static ProbePoint cosines(double NoL, double NoV, double NoH, double VoH);
};

class ModelProbe {
 public:
  // One output a term: (value, 0, 0, 0) or (r, g, b, 0). A term's own parameters are the point's `a`, in order; one that
  // is made for the model's own D takes the projected areas towards light and view there. Errors: GLSL that does not
  // compile.
  static Result<ModelProbe> ofTerms(std::span<const Term>);
  // Expressions are GLSL of type vec4 from `Shading s` and `vec4 a, b` of the point, with all terms at hand. One output:
  // the expression that the point chooses. Alpha is the square of the roughness, without the floor that pictures have.
  static Result<ModelProbe> ofChoices(const std::vector<std::string>& expressions);
  // Two outputs: (specular f, D) and (diffuse f, sum of the scattered light's channels), without cosine. Errors: at the plugin's own
  // lines; a model that takes too long to be asked for many values.
  // With `compensate`, which is as the head asks when not given, the specular f has the lobe of further bounces in it
  // (renderer/model_tables.h). With `ownAlpha` alpha has no floor, which is for models without such tables.
  static Result<ModelProbe> ofModel(const ShadingModel&, std::optional<bool> compensate = {}, bool ownAlpha = false);
  // Four outputs: (specular f, D), (diffuse f, V), (F, 0) and (scattered light, 0); 0 for what the model has not.
  static Result<ModelProbe> ofModelParts(const ShadingModel&, std::optional<bool> compensate = {});
  // One output: what the model's own environment() reflects, for models that define it.
  static Result<ModelProbe> ofEnvironment(const ShadingModel&);
  // Six outputs: F0, the diffuse colour, what its own environment() reflects (0 without one), the scattered light, the coat's f
  // and what comes through the coat (0 without one).
  static Result<ModelProbe> ofHooks(const ShadingModel&);
  // Five outputs, for models with a loop (lineOfDeepestLoop): of the last the first number is the line of the file's loop that
  // was broken off there, 0 when none was.
  static Result<ModelProbe> ofLoops(const ShadingModel&);

  // Of every point its outputs in order.
  std::vector<glm::vec4> evaluate(std::span<const ProbePoint>) const;
  // With other values for the parameters without a slot (ModelSetting::constants); what was derived from the model stays.
  std::vector<glm::vec4> evaluate(std::span<const ProbePoint>, std::span<const glm::vec4> constants) const;
  int outputs() const { return outputs_; }
  const ShadingModel& model() const { return *setting_.shader->model; }  // of ofModel()

  // A parameter of the model, which has its default until then.
  void set(const std::string& parameter, const Value&);

 private:
  ModelProbe() = default;
  std::vector<glm::vec4> run(std::span<const ProbePoint>) const;
  static Result<ModelProbe> build(const std::string& name, const std::string& glsl, const std::vector<std::string>& outputs,
                                  const std::string& defines = {});
  static Result<ModelProbe> ofOutputs(const ShadingModel&, const std::vector<std::string>& outputs, bool compensate, bool ownAlpha = false);
  gl::Program program_;
  int outputs_ = 0;
  std::unique_ptr<ModelTables> tables_;      // of a model
  ModelSetting setting_;
};

}  // namespace glint
