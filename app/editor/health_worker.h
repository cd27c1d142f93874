// Measures health cards on a thread and a context of its own, one model after another, while no picture is being drawn:
// the window never waits for a verdict, and no picture does.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "materials/model_registry.h"
#include "renderer/gl/context.h"
#include "renderer/model_health.h"

namespace glint {

using ModelHealthPtr = std::shared_ptr<const ModelHealth>;

class HealthWorker {
 public:
  // `context` is current nowhere. From the worker's thread: `busy` says that a picture is being drawn, `wake` that a
  // card is there.
  HealthWorker(std::unique_ptr<gl::Context> context, std::function<bool()> busy, std::function<void()> wake);
  ~HealthWorker();
  HealthWorker(const HealthWorker&) = delete;

  // The window's thread. Cards of all these are wanted, the first first; what is wanted no more is forgotten. `again`
  // also looks at those that have one: a shipped term may have changed under them.
  void want(const std::vector<ModelPtr>&, bool again);
  // Null while it is being measured, or nobody wants it.
  ModelHealthPtr card(const ModelPtr&) const;
  bool takeNews();        // whether a card came since the last call
  bool settled() const;   // nothing left to measure

 private:
  void run();
  // Waits until no picture has been drawn for a moment; false to stop.
  bool awaitQuiet();

  struct Entry {
    uint64_t key = 0;     // of what the card was measured on; 0: not yet known
    ModelHealthPtr card;
  };
  std::unique_ptr<gl::Context> context_;
  std::function<bool()> busy_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<ModelPtr> waiting_;            // the next one last
  std::map<ModelPtr, Entry> entries_;
  bool stop_ = false, working_ = false, news_ = false;
  std::thread thread_;
};

}  // namespace glint
