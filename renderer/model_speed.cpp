#include "renderer/model_speed.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

#include "materials/glsl_loops.h"
#include "renderer/gl/gl.h"
#include "renderer/gl/software.h"

namespace glint {

namespace {

// Of all threads of this process.
double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What an evaluation took. Where the processor draws, its time for this process counts: the clock on the wall runs for
// others too, and a busy machine would blame the model. A device's work shows on the wall alone.
double secondsOf(const std::function<void(int count)>& evaluate, int count, bool software) {
  const double processor = processorSeconds();
  const auto begin = std::chrono::steady_clock::now();
  evaluate(count);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return software ? std::min(wall, processorSeconds() - processor) : wall;
}

}  // namespace

std::optional<Diagnostic> faultOfSpeed(const ShadingModel& model, const std::function<void(int count)>& evaluate, int evaluations) {
  // Seconds: for the way to the device and back, and for a value. A table has tens of millions of them; sound models
  // take less than a hundredth of this for one.
  constexpr double kOverhead = 0.002, kValue = 2e-6;
  // Without a loop a text of its size can only be so slow: what takes longer than a moment was held up by other work of this
  // process, whose pictures are drawn by the same threads. A model with a loop is slow at each attempt, and not asked for long.
  const auto loop = lineOfDeepestLoop(model.source);
  const double moment = loop ? 0 : 1, mostSeconds = loop ? 0.5 : 5;
  constexpr int kAttempts = 24, kBeforeRest = 4;
  const bool software = gl::isSoftware(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  for (const int count : {16, 256, 4096}) {
    if (!loop && count < 4096) continue;  // the way there and back is all that few values show
    const double most = std::max({moment, kOverhead, count * evaluations * kValue});
    double fastest = 1e9;
    const auto begin = std::chrono::steady_clock::now();
    for (int attempt = 0; attempt < kAttempts && fastest > most; ++attempt) {
      if (attempt >= kBeforeRest) {
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > mostSeconds) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      fastest = std::min(fastest, secondsOf(evaluate, count, software));
    }
    if (fastest > most) {
      std::string place = (model.sourceFile.empty() ? model.file : model.sourceFile).string();
      if (loop) place += fmt::format(":{}", *loop);
      return error(place, fmt::format("takes {:.1f} ms for {} values", 1000 * fastest, count * evaluations), "a picture asks for millions: shorten its loops");
    }
  }
  return std::nullopt;
}

}  // namespace glint
