// Things that were dear to make, by key: what is in use stays, of the rest only what was used last.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace glint {

template <class Value>
class RecentlyUsed {
 public:
  // Null when it is not there. Both count as a use. A pointer lives until nextFrame() or clear().
  Value* find(uint64_t key) {
    const auto found = items_.find(key);
    if (found == items_.end()) return nullptr;
    found->second.used = frame_;
    return &found->second.value;
  }
  Value& put(uint64_t key, Value value) {
    return items_.insert_or_assign(key, Item{std::move(value), frame_}).first->second.value;
  }

  // Drops what was not used since the last call, but for the `spare` of them that were used last: who goes back and
  // forth between a few things need not wait for them.
  void nextFrame(size_t spare) {
    std::vector<std::pair<uint64_t, uint64_t>> unused;  // when, key
    for (const auto& [key, item] : items_)
      if (item.used < frame_) unused.emplace_back(item.used, key);
    std::sort(unused.begin(), unused.end());
    for (size_t i = 0; i + spare < unused.size(); ++i) items_.erase(unused[i].second);
    ++frame_;
  }

  void clear() { items_.clear(); }
  size_t size() const { return items_.size(); }

 private:
  struct Item {
    Value value;
    uint64_t used;
  };
  std::unordered_map<uint64_t, Item> items_;
  uint64_t frame_ = 1;
};

}  // namespace glint
