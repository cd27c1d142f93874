// Work spread over the machine's cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace glint {

// Calls work(i) once for every i in 0..count-1, in no order, on this thread and as many others as there are
// cores; returns when all are done. `work` must not throw and must not depend on the order.
// Starting a thread costs tens of microseconds, milliseconds on a busy machine: when the whole work is less than
// that, say `worthwhile` = false and it is done here.
template <class Work>
void parallelFor(size_t count, Work&& work, bool worthwhile = true) {
  if (!worthwhile) {
    for (size_t i = 0; i < count; ++i) work(i);
    return;
  }
  const size_t cores = std::max(1u, std::thread::hardware_concurrency());
  std::atomic<size_t> next{0};
  const auto drain = [&] {
    for (size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> helpers;  // joined when it goes
  for (size_t i = 1; i < std::min(cores, count); ++i) helpers.emplace_back(drain);
  drain();
}

}  // namespace glint
