#include "renderer/loop_faults.h"

#include "materials/glsl_loops.h"

namespace glint {
namespace {

std::optional<Diagnostic> faultAt(const ModelProbe& probe, const ShadingModel& model, std::span<const ProbePoint> points, const std::vector<glm::vec4>& constants) {
  const std::vector<glm::vec4> out = constants.empty() ? probe.evaluate(points) : probe.evaluate(points, constants);
  const size_t outputs = static_cast<size_t>(probe.outputs());
  for (size_t i = outputs - 1; i < out.size(); i += outputs)
    if (out[i].x > 0)
      return error(fmt::format("{}:{}", (model.sourceFile.empty() ? model.file : model.sourceFile).string(), static_cast<int>(out[i].x)),
                   fmt::format("a loop takes more than {} turns, with those around it", kMostTurns), "let it end sooner: it runs for each pixel and light");
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> faultOfLoops(const ShadingModel& model, std::span<const ProbePoint> points, const std::vector<glm::vec4>& constants) {
  if (!lineOfDeepestLoop(model.source)) return std::nullopt;
  const auto probe = ModelProbe::ofLoops(model);
  if (!probe) return probe.diagnostics()[0];
  return faultAt(*probe, model, points, constants);
}

std::optional<Diagnostic> faultOfLoops(const ShadingModel& model) {
  if (!lineOfDeepestLoop(model.source)) return std::nullopt;
  const auto probe = ModelProbe::ofLoops(model);
  if (!probe) return probe.diagnostics()[0];
  if (auto fault = faultAt(*probe, model, gridPoints(model), {})) return fault;
  for (const ScatteredPoints& some : scatteredPoints(model))
    if (auto fault = faultAt(*probe, model, some.points, some.constants)) return fault;
  return std::nullopt;
}

}  // namespace glint
