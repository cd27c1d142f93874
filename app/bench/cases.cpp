#include "app/bench/cases.h"

namespace glint {

Renderer& BenchSetup::renderer() {
  if (!renderer_) renderer_ = std::make_unique<Renderer>(context);
  return *renderer_;
}

Result<ModelPtr> plainModel(const Libraries& libraries) { return libraries.model(newMaterial("plain").model, "bench"); }

std::vector<BenchCase> benchCases(const ModelRegistry& models) {
  std::vector<BenchCase> all;
  for (auto& group : {frameCases(models), environmentCases(models), materialCases(), modelCases(), plotCases(), startupCases()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace glint
