#include "renderer/model_speed.h"

#include <algorithm>
#include <chrono>

namespace glint {

std::optional<Diagnostic> faultOfSpeed(const ShadingModel& model, const std::function<void(int count)>& evaluate, int evaluations) {
  // Seconds: for the way to the device and back, and for a value. A table has tens of millions of them; sound models
  // take less than a hundredth of this for one.
  constexpr double kOverhead = 0.002, kValue = 2e-6;
  for (const int count : {16, 256, 4096}) {
    const double most = std::max(kOverhead, count * evaluations * kValue);
    double fastest = 1e9;
    for (int attempt = 0; attempt < 8 && fastest > most; ++attempt) {
      const auto begin = std::chrono::steady_clock::now();
      evaluate(count);
      fastest = std::min(fastest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    if (fastest > most)
      return error((model.sourceFile.empty() ? model.file : model.sourceFile).string(),
                   fmt::format("takes {:.1f} ms for {} values", 1000 * fastest, count * evaluations), "a picture asks for millions: shorten its loops");
  }
  return std::nullopt;
}

}  // namespace glint
