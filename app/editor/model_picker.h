// Choosing a shading model: from all there are, each with its badge, or as a mix of terms.
#pragma once

#include <functional>
#include <string>

#include "materials/model_mix.h"
#include "materials/value.h"

namespace glint {

class Editor;

// A list of every model with its badge, and a mix of terms as its last entry; `id` may be one of neither. True when
// another was chosen.
bool modelPicker(Editor&, const std::string& label, std::string& id);

// A property line for each of the four terms; true when another was chosen.
bool mixPickers(Editor&, ModelMix&);

// The mix to begin with where this model was chosen before: its own terms, as far as they have names.
ModelMix mixLike(const ShadingModel*);

// A property line for each parameter of a model. `valueOf` gives the value in force, `set` takes another.
void parameterSliders(const ShadingModel&, const std::function<Value(const ModelParameter&)>& valueOf,
                      const std::function<void(const ModelParameter&, const Value&)>& set);

}  // namespace glint
