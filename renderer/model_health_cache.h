// Health cards kept on disk by what they were measured on, so that listing models costs nothing the second time.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/model_health.h"

namespace glint {

// Of everything that a card follows from: the model's file, the shipped terms and shaders, and the measuring itself.
uint64_t healthKey(const ShadingModel&);

// The card, when it is on disk. Needs no context.
std::optional<ModelHealth> keptHealth(const ShadingModel&);

// That, or measured now and kept; `seconds` is what measuring took, then or now. A model whose GLSL does not compile is
// looked at each time. Needs a current context. `stopped` is as for checkHealth(): such a card is whole or nothing.
std::optional<ModelHealth> healthOf(const ShadingModel&, const std::function<bool()>& stopped);
ModelHealth healthOf(const ShadingModel&);

}  // namespace glint
