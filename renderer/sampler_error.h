// How well a model's own sampler (model_sampler.h) draws: the error of the directional albedo by few directions.
#pragma once

#include "renderer/model_probe.h"
#include "renderer/model_sampler.h"

namespace glint {

struct SamplerError {
  static constexpr int kSamples = 1024;
  double worst = 0;                    // relative standard error of the albedo by kSamples directions
  double cosine = 0;                   // the same there by as many directions drawn by the cosine
  float roughness = 0, NoV = 0;        // where
};
// Of the specular part for F0 = 1, over roughness and NoV. Both of the same model with the same parameters.
SamplerError samplerError(const ModelProbe&, const ModelSampler&);

}  // namespace glint
