// The mixer: any D x V x F (x diffuse) of the library of terms (terms.h) is a shading model, named by what it is made
// of: "GGX*SmithGGXCorrelated*Schlick" or "GTR*SmithGGX*Schlick*Burley".
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "materials/model.h"

namespace glint {

// The terms of a mix, without their prefixes. The second is a V, or the G of the same name: one is the other over
// 4 NoL NoV.
struct ModelMix {
  std::string D, V, F, diffuse = "Lambert";
  // "GGX*SmithGGX*Schlick"; Lambert is left out.
  std::string id() const;
};

// Whether an id is meant as a mix: it has a '*', which no other model's id has.
bool isModelMix(std::string_view id);

// The mix that the literature's name stands for (shaders/terms/mixes.json): "ue4_ibl"; empty for other names.
std::string namedMix(std::string_view name);

// Errors: not three or four names, or a name that no term of its kind has.
Result<ModelMix> parseModelMix(std::string_view id);

// The text of a plugin that is this mix, with an id that a file can have: what "Save as plugin" writes. `values` are those
// of the terms' parameters that are not their standards, by name.
std::string pluginOfMix(const ModelMix&, const std::string& id, const std::map<std::string, float>& values = {});

// The model itself, as read from such a plugin; its id is the mix's. Errors: of parseModelMix().
Result<ShadingModel> mixModel(std::string_view id);

}  // namespace glint
