#include "renderer/model_speed.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace glint {

namespace {

// Of all threads of this process.
double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What an evaluation took. On a busy machine the clock on the wall runs for others too: then what the processor did for
// this process counts, unless that clock has run so long that the work must have been a device's.
double secondsOf(const std::function<void(int count)>& evaluate, int count, double most) {
  constexpr double kOthers = 50;  // times longer than allowed: more than other processes explain
  const double processor = processorSeconds();
  const auto begin = std::chrono::steady_clock::now();
  evaluate(count);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return wall > kOthers * most ? wall : std::min(wall, processorSeconds() - processor);
}

}  // namespace

std::optional<Diagnostic> faultOfSpeed(const ShadingModel& model, const std::function<void(int count)>& evaluate, int evaluations) {
  // Seconds: for the way to the device and back, and for a value. A table has tens of millions of them; sound models
  // take less than a hundredth of this for one.
  constexpr double kOverhead = 0.002, kValue = 2e-6;
  for (const int count : {16, 256, 4096}) {
    const double most = std::max(kOverhead, count * evaluations * kValue);
    double fastest = 1e9;
    for (int attempt = 0; attempt < 8 && fastest > most; ++attempt) fastest = std::min(fastest, secondsOf(evaluate, count, most));
    if (fastest > most)
      return error((model.sourceFile.empty() ? model.file : model.sourceFile).string(),
                   fmt::format("takes {:.1f} ms for {} values", 1000 * fastest, count * evaluations), "a picture asks for millions: shorten its loops");
  }
  return std::nullopt;
}

}  // namespace glint
