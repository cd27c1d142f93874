// Quantities of evaluation.h that are of light: what a model sends on of one light with a surface or of an environment,
// exactly and by the approximations of Karis 2013.
#pragma once

#include "renderer/evaluation_batch.h"

namespace glint::evaluation {

// "area_light": a sphere ("kind", "center", "radius") or tube ("L0", "L1", "radius") of 1 candela. For each of the
// request's models "reference.MODEL.white", ".fc" and ".F0_0p04" (F = 1, Fc and F0 0.04), and "approx.MODEL.NAME.white" and so on;
// and "reference.irradiance".
Finish areaLight(const EvaluationRequest&, Batch&);

// "environment_light": for each of the models "models.MODEL.exact_white", "exact_Fc" and "exact_F0_0p04", "A" and "B", and
// the split sums of a GGX first sum with the model's A and B; and those first sums.
Finish environmentLight(const EvaluationRequest&, Batch&);

}  // namespace glint::evaluation
