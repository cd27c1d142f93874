// Integrals of a model's f and D over the hemisphere, on the device, from the GLSL that draws: what its energy laws,
// its tables and its compensation are made of. Needs a current context.
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <vector>

#include "renderer/model_setting.h"
#include "renderer/model_tables.h"

namespace glint {

struct IntegralQuery {
  float roughness = 0.5f, NoV = 1;
  bool analyticLight = true;   // or an environment: some models differ
  glm::vec3 diffuseColor{1};
  glm::vec3 F0{1};             // of ModelIntegral::specular
  float azimuth = 0;           // of the view against the tangent, in radians, for models that use it
  // As authored, for models that read them beside the two colours above. Without, a white metal for the specular part and
  // a white nonmetal for the diffuse one.
  struct Authored {
    glm::vec3 baseColor{1};
    float metallic = 0, specular = 0.5f;
    bool plainNonmetal = false;
  };
  std::optional<Authored> authored = {};
};

// Of one query.
struct ModelIntegral {
  glm::dvec3 specular{};       // directional albedo of the specular part for the query's F0: of f NoL
  glm::dvec3 specularBlack{};  // and for F0 = 0: the B of the environment BRDF; A is the rest for F0 1 (Karis 2013, eq. 8)
  glm::dvec3 white{};          // and of facets that reflect all: modelWhite() of model.h
  glm::dvec3 diffuse{};        // directional albedo of the diffuse part
  glm::dvec3 scattered{};      // of the scattered light, over light from all around
  double distribution = 0;     // of D NoH: 1 for a distribution of normals
  double projected = 0;        // of D max(VoH, 0): the area that Smith's masking brings back to NoV (Heitz 2014, eq. 14)
};

struct IntegralOptions {
  std::optional<bool> compensate;  // with the lobe of further bounces (renderer/model_tables.h); as the head asks when empty
  bool specularOnly = false;   // leaves `diffuse`, `distribution` and `projected` at 0
  int polar = 128, quarter = 24;  // nodes from the normal to the horizon, and in a quarter around it
};

class ModelIntegrals {
 public:
  // Errors: GLSL that does not compile, at the plugin's own lines.
  static Result<ModelIntegrals> of(const ShadingModel&, const IntegralOptions& = {});
  static Result<ModelIntegrals> of(const ModelSetting&, const IntegralOptions& = {});

  // A parameter of the model, which has its default until then.
  void set(const std::string& parameter, const Value&);

  // Errors of tables that the model's terms look into are reported by of().
  // Good to about 1e-3 of each value from roughness 0.05 up, for lobes of any width around the half vector.
  std::vector<ModelIntegral> evaluate(std::span<const IntegralQuery>) const;

  // 2 times the integral of E(NoV) NoV over NoV from 0 to 1, and its mean around the normal: the part of uniform light
  // from all sides that the specular part sends back.
  double averageAlbedo(float roughness, bool analyticLight = true) const;

  // For each roughness by how much the lobe seen along the normal is wider along the bitangent than along the tangent, as
  // slopes of the half vectors at which it has fallen to a half: 1 for a model that does not use the tangent.
  std::vector<float> aspects(std::span<const float> roughnesses) const;

 private:
  struct Nodes;
  struct Sums;
  ModelIntegrals() = default;
  static Nodes makeNodes(int polar, int quarter);
  // By query, then polar node. `aspects` are the queries'.
  std::vector<Sums> sums(std::span<const IntegralQuery>, std::span<const float> aspects, std::span<const glm::vec4> polar,
                         std::span<const glm::vec4> around) const;
  ModelSetting setting_;
  std::unique_ptr<ModelTables> tables_;
  IntegralOptions options_;
  gl::Program program_;
};

}  // namespace glint
