#include "app/bench/measure.h"

#include <algorithm>
#include <chrono>

#include "materials/base/check.h"

namespace glint {

double timed(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Measurement summarize(std::string name, std::vector<double> times, std::string note) {
  GLINT_CHECK(!times.empty(), "{}", name);
  std::sort(times.begin(), times.end());
  const size_t n = times.size();
  const double median = n % 2 ? times[n / 2] : (times[n / 2 - 1] + times[n / 2]) / 2;
  return {std::move(name), median, times.front(), times.back(), static_cast<int>(n), std::move(note)};
}

Measurement measure(std::string name, const Effort& effort, const std::function<void()>& work, std::string note) {
  for (int i = 0; i < effort.warmUps; ++i) work();
  std::vector<double> times;
  double total = 0;
  while (static_cast<int>(times.size()) < effort.most &&
         (static_cast<int>(times.size()) < effort.least || total < effort.seconds * 1000)) {
    times.push_back(timed(work));
    total += times.back();
  }
  return summarize(std::move(name), std::move(times), std::move(note));
}

}  // namespace glint
