#include "materials/glsl_recursion.h"

#include <fmt/format.h>

#include <algorithm>

namespace glint {
namespace {

class Walk {
 public:
  explicit Walk(const std::vector<GlslFunction>& functions) : functions_(functions), states_(functions.size(), kNew) {}

  std::vector<GlslFault> run() {
    for (size_t i = 0; i < functions_.size(); ++i)
      if (states_[i] == kNew) enter(i);
    return std::move(faults_);
  }

 private:
  enum State { kNew, kOpen, kDone };
  struct Step {
    size_t function, nextCall;
  };

  // The one function that a call can mean, or the count of them all. The same signature twice is one function under
  // two conditions.
  size_t target(const GlslCall& call) const {
    size_t found = functions_.size();
    for (size_t i = 0; i < functions_.size(); ++i) {
      if (functions_[i].name != call.name || functions_[i].parameterTypes.size() != call.arguments) continue;
      if (found < functions_.size() && functions_[found].parameterTypes != functions_[i].parameterTypes) return functions_.size();
      if (found == functions_.size()) found = i;
    }
    return found;
  }

  // Depth first with a stack of its own: a chain of calls may be long.
  void enter(size_t first) {
    states_[first] = kOpen;
    path_ = {{first, 0}};
    while (!path_.empty()) {
      Step& at = path_.back();
      const auto& calls = functions_[at.function].calls;
      if (at.nextCall == calls.size()) {
        states_[at.function] = kDone;
        path_.pop_back();
        continue;
      }
      const GlslCall& call = calls[at.nextCall++];
      const size_t to = target(call);
      if (to == functions_.size() || states_[to] == kDone) continue;
      if (states_[to] == kOpen) report(to, call);
      else {
        states_[to] = kOpen;
        path_.push_back({to, 0});
      }
    }
  }

  void report(size_t to, const GlslCall& call) {
    std::string through;
    for (const Step& step : path_)
      if (!through.empty() || step.function == to) through += functions_[step.function].name + " -> ";
    faults_.push_back({call.line, fmt::format("'{}' calls itself: {}{}", functions_[to].name, through, functions_[to].name),
                       "GLSL has no recursion: write a loop"});
  }

  const std::vector<GlslFunction>& functions_;
  std::vector<State> states_;
  std::vector<Step> path_;
  std::vector<GlslFault> faults_;
};

}  // namespace

std::vector<GlslFault> recursionFaults(const GlslScan& scan) { return Walk(scan.functions).run(); }

}  // namespace glint
