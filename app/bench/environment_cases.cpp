#include "app/bench/cases.h"
#include "renderer/environment.h"
#include "renderer/environment_benchmark.h"

namespace glint {

std::vector<BenchCase> environmentCases(const ModelRegistry&) {
  std::vector<BenchCase> cases;
  const auto prefilter = [](const char* name, const char* environmentName) {
    return [name, environmentName](BenchSetup& setup) -> Result<Measurement> {
      const auto model = plainModel(setup.libraries);
      if (!model) return model.diagnostics();
      const auto environment = loadEnvironment(environmentName);
      if (!environment) return environment.diagnostics();
      EnvironmentBenchmark benchmark(*model);
      if (const Diagnostics problems = benchmark.prefilter(*environment); !problems.empty()) return problems;
      Measurement result = measure(name, setup.effort, [&] { benchmark.prefilter(*environment); });
      if (setup.quick) return result;
      const auto errors = benchmark.errors(*environment);
      if (!errors) return errors.diagnostics();
      result.note = fmt::format("{}x{}, relative RMS error by level", (*environment)->pixels.width, (*environment)->pixels.height);
      for (const double error : *errors) result.note += fmt::format(" {:.4f}", error);
      return result;
    };
  };
  cases.push_back({"env.prefilter", "a 1024x512 environment made ready for one model, past every cache", prefilter("env.prefilter", "studio")});
  cases.push_back({"env.prefilter.sun", "the same with a sun", prefilter("env.prefilter.sun", "sky")});
  cases.push_back({"env.brdf", "the environment BRDF of one model, past every cache", [](BenchSetup& setup) -> Result<Measurement> {
                     const auto model = plainModel(setup.libraries);
                     if (!model) return model.diagnostics();
                     EnvironmentBenchmark benchmark(*model);
                     if (const Diagnostics problems = benchmark.brdf(); !problems.empty()) return problems;
                     return measure("env.brdf", setup.effort, [&] { benchmark.brdf(); });
                   }});
  return cases;
}

}  // namespace glint
