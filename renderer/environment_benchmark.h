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
  // Of each rough level of the prefiltered cube, the root mean square error relative to the root mean square of the exact
  // values: the lobe's average over every pixel of the environment. Over all texels of a level, or where it has more over an
  // even choice of some and as many of the brightest, which an even choice would miss.
  Result<std::vector<double>> errors(const EnvironmentPtr&, size_t texels = 512);

 private:
  ProgramCache programs_;
  Rectangles rectangles_;
  ModelSetting setting_;
};

}  // namespace glint
