// How far the linearly transformed cosines, which light models with area lights, are from the lobes they stand for: of one
// model, under soft lights all over the sky.
#pragma once

#include "renderer/model_probe.h"

namespace glint {

struct AreaLightError {
  double mean = 0, worst = 0;          // what is too much or too little of all light, over roughness and NoV
  float roughness = 0, NoV = 0;        // of the worst
};
// Of the specular part of facets that reflect all.
AreaLightError areaLightError(const ModelProbe&);

}  // namespace glint
