#include "materials/base/log.h"

#include <algorithm>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <mutex>

namespace glint::log {
namespace {

spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> instance = [] {
    auto made = std::make_shared<spdlog::logger>("glint", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    made->set_pattern("glint: %v");
    made->set_level(spdlog::level::info);
    return made;
  }();
  return *instance;
}

std::atomic<Diagnostics*> collector{nullptr};
std::mutex collectorMutex;

// A name in a file may hold line breaks or control characters; a message stays one line.
std::string oneLine(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

}  // namespace

void setQuiet(bool quiet) { logger().set_level(quiet ? spdlog::level::err : spdlog::level::info); }
void info(const std::string& text) { logger().info(oneLine(text)); }

void setCollector(Diagnostics* to) { collector = to; }

void report(const Diagnostic& d) {
  if (Diagnostics* to = collector) {
    const std::lock_guard lock(collectorMutex);
    to->push_back(d);
  }
  if (d.severity == Severity::Error)
    logger().error("error: {}", oneLine(d.text()));
  else
    logger().warn("warning: {}", oneLine(d.text()));
}

void report(const Diagnostics& diagnostics) {
  // What several cells or rows have in common is said once.
  for (auto d = diagnostics.begin(); d != diagnostics.end(); ++d)
    if (std::find(diagnostics.begin(), d, *d) == d) report(*d);
}

void progress(const std::string& what, double fraction) {
  static const bool terminal = ::isatty(STDERR_FILENO);
  if (!terminal || logger().level() > spdlog::level::info) return;
  std::fprintf(stderr, "\rglint: %s %3.0f %%\x1b[K%s", oneLine(what).c_str(), 100 * fraction,
               fraction >= 1 ? "\n" : "");
  std::fflush(stderr);
}

}  // namespace glint::log
