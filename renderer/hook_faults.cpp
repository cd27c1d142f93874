#include "renderer/hook_faults.h"

#include <algorithm>
#include <cmath>

#include "materials/glsl_scan.h"

namespace glint {
namespace {

struct Hook {
  const char* function;
  bool defined;
  size_t output;               // of ModelProbe::ofHooks()
  size_t outputs;
  bool bounded;                // at most 1: a share of the light
};

// With the colours made of the attributes, and every other light from behind.
std::vector<ProbePoint> withAttributes(std::vector<ProbePoint> points) {
  for (size_t i = 0; i < points.size(); ++i) {
    points[i].fromAttributes = true;
    if (i / 2 % 2) points[i].light.z = -points[i].light.z;
  }
  return points;
}

}  // namespace

std::vector<HookFault> hookFaults(const ShadingModel& model) {
  constexpr double kRounding = 3e-3;
  const Hook hooks[] = {{"colors", model.definesColors, 0, 2, true}, {"environment", model.definesEnvironment, 2, 1, true}, {"scattered", model.definesScattered, 3, 1, false},
                        {"coat", model.definesCoat, 4, 1, false}, {"throughCoat", model.definesThroughCoat, 5, 1, true}};
  if (std::none_of(std::begin(hooks), std::end(hooks), [](const Hook& hook) { return hook.defined; })) return {};
  const auto probe = ModelProbe::ofHooks(model);
  if (!probe) return {};  // which is told already: it is the same text
  const size_t kOutputs = static_cast<size_t>(probe->outputs());
  std::vector<HookFault> faults;
  const auto told = [&](const Hook& hook, Law law, double value, const ProbePoint& point, const std::vector<glm::vec4>& constants) {
    const auto same = std::find_if(faults.begin(), faults.end(), [&](const HookFault& f) { return f.law == law && f.function == hook.function; });
    if (same != faults.end() && (law == Law::Finite || std::abs(value) <= std::abs(same->value))) return;
    HookFault fault{law, value, hook.function, 0, point, constants};
    for (const GlslFunction& f : scanGlsl(model.source).functions)
      if (f.name == hook.function) fault.line = f.line;
    if (same == faults.end()) faults.push_back(std::move(fault));
    else *same = std::move(fault);
  };
  for (const ScatteredPoints& some : scatteredPoints(model)) {
    const std::vector<ProbePoint> points = withAttributes(some.points);
    const std::vector<glm::vec4> out = some.constants.empty() ? probe->evaluate(points) : probe->evaluate(points, some.constants);
    for (size_t i = 0; i < points.size(); ++i)
      for (const Hook& hook : hooks)
        for (size_t k = 0; hook.defined && k < hook.outputs; ++k) {
          const glm::vec4& v = out[kOutputs * i + hook.output + k];
          for (int c = 0; c < 3; ++c) {
            if (!std::isfinite(v[c])) told(hook, Law::Finite, 0, points[i], some.constants);
            else if (v[c] < -kRounding) told(hook, Law::NonNegative, v[c], points[i], some.constants);
            else if (hook.bounded && v[c] > 1 + kRounding) told(hook, Law::Energy, v[c], points[i], some.constants);
          }
        }
  }
  return faults;
}

}  // namespace glint
