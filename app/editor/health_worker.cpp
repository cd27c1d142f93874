#include "app/editor/health_worker.h"

#include <algorithm>
#include <chrono>

#include "renderer/model_health_cache.h"
#include "renderer/renderer.h"

namespace glint {

HealthWorker::HealthWorker(std::unique_ptr<gl::Context> context, std::function<bool()> busy, std::function<void()> wake)
    : context_(std::move(context)), busy_(std::move(busy)), wake_(std::move(wake)) {
  thread_ = std::thread([this] { run(); });
}

HealthWorker::~HealthWorker() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void HealthWorker::want(const std::vector<ModelPtr>& models, bool again) {
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(entries_, [&](const auto& entry) { return std::find(models.begin(), models.end(), entry.first) == models.end(); });
    waiting_.clear();
    for (auto model = models.rbegin(); model != models.rend(); ++model)
      if (const auto [entry, fresh] = entries_.try_emplace(*model); again || !entry->second.card) waiting_.push_back(*model);
  }
  changed_.notify_all();
}

ModelHealthPtr HealthWorker::card(const ModelPtr& model) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(model);
  return found == entries_.end() ? nullptr : found->second.card;
}

bool HealthWorker::takeNews() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, false);
}

bool HealthWorker::settled() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && !working_;
}

bool HealthWorker::awaitQuiet() {
  constexpr auto kLook = std::chrono::milliseconds(30);
  constexpr int kQuietLooks = 4;
  std::unique_lock lock(mutex_);
  for (int quiet = 0; quiet < kQuietLooks && !stop_; quiet = busy_() ? 0 : quiet + 1) changed_.wait_for(lock, kLook, [&] { return stop_; });
  return !stop_;
}

void HealthWorker::run() {
  context_->makeCurrent();
  {
    Renderer renderer(*context_);
    const auto stopped = [this] {
      const std::lock_guard lock(mutex_);
      return stop_;
    };
    for (;;) {
      ModelPtr model;
      uint64_t known = 0;
      {
        std::unique_lock lock(mutex_);
        working_ = false;
        changed_.wait(lock, [&] { return stop_ || !waiting_.empty(); });
        if (stop_) break;
        model = std::move(waiting_.back());
        waiting_.pop_back();
        working_ = true;
        if (const auto entry = entries_.find(model); entry != entries_.end()) known = entry->second.key;
      }
      const uint64_t key = healthKey(*model);
      if (key == known) continue;
      auto card = keptHealth(*model);
      if (!card) {
        if (!awaitQuiet()) break;
        // A model that does not compile, or takes for ever, is not measured.
        const Diagnostics faults = renderer.check(model);
        card = faults.empty() ? healthOf(*model, stopped) : unmeasurable(model->id, model->file.string(), faults);
        if (!card) break;
      }
      {
        const std::lock_guard lock(mutex_);
        if (const auto entry = entries_.find(model); entry != entries_.end())
          entry->second = {key, std::make_shared<const ModelHealth>(std::move(*card))};
        news_ = true;
      }
      wake_();
    }
  }
  context_->release();
}

}  // namespace glint
