// The preparation of an environment as something to measure: each run starts from nothing, past every cache.
#pragma once

#include <vector>

#include "renderer/environment_lighting.h"

namespace glint {

class EnvironmentBenchmark {
 public:
  explicit EnvironmentBenchmark(std::shared_ptr<const ShadingModel>);

  // From the pixels to all that lights the model but its environment BRDF; waits for the device. Errors: the model's
  // GLSL does not compile.
  Diagnostics prefilter(const EnvironmentPtr&);
  // The environment BRDF; waits for the device.
  Diagnostics brdf();
  // Of each rough level of the prefiltered cube, the root mean square difference to kReferenceSamples directions a
  // texel, relative to the reference's root mean square.
  Result<std::vector<double>> errors(const EnvironmentPtr&);
  static constexpr int kReferenceSamples = 4096;

 private:
  ProgramCache programs_;
  Rectangles rectangles_;
  ModelSetting setting_;
};

}  // namespace glint
