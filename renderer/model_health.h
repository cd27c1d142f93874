// The health card of a shading model: the laws that physics sets it, measured on its own GLSL, beside what it claims.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/model_registry.h"

namespace glint {

// Green: keeps the law. Amber: breaks one that it does not claim to keep, or looks wrong. Red: breaks what it claims, or
// what no model may break.
enum class Verdict { Green, Amber, Red };
std::string_view name(Verdict);  // "green"

enum class Law {
  Compiles,       // its GLSL
  Finite,         // values, over roughness, F0, directions and the range of each parameter
  NonNegative,    // likewise
  Reciprocity,    // f(l, v) = f(v, l): `value` is the largest relative change by swapping
  Normalisation,  // of D: `value` is the worst integral of D NoH over the hemisphere, wanted 1
  Energy,         // `value` is the largest directional albedo of the specular or diffuse part, wanted <= 1
  Furnace,        // `value` is the smallest directional albedo of a white specular part; wanted 1 where it is compensated
  MirrorLimit,    // `value` is the albedo of a smooth white mirror seen from above, wanted 1: finds lost factors
  Environment,    // `value` is the relative RMS error of the split sum against the integral it stands for
  AreaLights,     // `value` is how far its linearly transformed cosine is off under soft lights, as a part of the light
  Sampler,        // `value` is the relative error of the albedo by SamplerError::kSamples directions of its own sampler
};
inline constexpr int kLawCount = 11;
std::string_view name(Law);  // "reciprocity"

struct LawResult {
  Law law;
  Verdict verdict = Verdict::Green;
  bool claimed = false;
  double value = 0;
  std::string where;   // of the worst case: "roughness 0.15, NoV 0.005, gamma 4"
  std::string reason;  // what is broken, in words; empty when green
  std::string hint;
};

struct ModelHealth {
  std::string model, file;
  std::vector<LawResult> laws;
  double seconds = 0;
  Verdict verdict() const;     // the worst of them
  std::string reason() const;  // of the first law with that verdict; empty when green
  const LawResult* find(Law) const;
};

// The card of a model that cannot be measured, for the faults that keep it from that: red.
ModelHealth unmeasurable(const std::string& model, const std::string& file, const Diagnostics& faults);

// Such cards of the registry's files that give no model to use: those that cannot be read, and those whose id another has,
// which only lose to it when `id` is given and theirs.
std::vector<ModelHealth> unusableModels(const ModelRegistry&, const std::string& id = {});

// Needs a current context. GLSL that does not compile is a red card, with the plugin's own lines in `where`. With
// `compensate` the model is measured with the lobe of further bounces (renderer/model_tables.h), as one whose head asks
// for it always is. `stopped` is asked between the parts of the work; once it says so, what is left of it is left out.
ModelHealth checkHealth(const ShadingModel&, bool compensate = false, const std::function<bool()>& stopped = {});

}  // namespace glint
