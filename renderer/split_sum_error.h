// How far the split sum (Karis 2013, eq. 7), which lights models with environments, is from the integral it stands for:
// for one model's own lobe and tables, under a small environment that is known in closed form.
#pragma once

#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"

namespace glint {

struct SplitSumError {
  double rms = 0, worst = 0;           // relative, over roughness, NoV and F0 of 0.04 and 1
  float roughness = 0, NoV = 0;        // of the worst
};
// All of the same model with the same parameters. `environment` is ModelProbe::ofEnvironment() of a model that has one:
// it then takes the place of the table.
SplitSumError splitSumError(const ModelProbe&, const ModelIntegrals&, const ModelProbe* environment = nullptr);

}  // namespace glint
