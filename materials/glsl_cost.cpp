#include "materials/glsl_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "materials/glsl_scan.h"

namespace glint {
namespace {

constexpr int64_t kMost = 1'000'000'000;

class Counter {
 public:
  explicit Counter(std::string_view text) : scan_(scanGlsl(text)), totals_(scan_.functions.size(), kUnknown) {}

  // Overloads of one name are told apart by nothing here: the dearest counts.
  int64_t total(std::string_view name) {
    int64_t most = 1;
    for (size_t i = 0; i < scan_.functions.size(); ++i)
      if (scan_.functions[i].name == name) most = std::max(most, total(i));
    return most;
  }

 private:
  static constexpr int64_t kUnknown = -1;

  int64_t total(size_t index) {
    if (totals_[index] != kUnknown) return totals_[index];
    totals_[index] = 1;  // for a function that calls itself
    int64_t sum = scan_.functions[index].operators;
    for (const GlslCall& call : scan_.functions[index].calls) sum = std::min(kMost, sum + total(call.name));
    return totals_[index] = std::max<int64_t>(1, sum);
  }

  GlslScan scan_;
  std::vector<int64_t> totals_;
};

}  // namespace

std::vector<GlslFault> growthFaults(std::string_view text) {
  constexpr int64_t kMostOperations = 100'000;  // sound models have hundreds
  Counter counter(text);
  for (const GlslFunction& function : scanGlsl(text).functions)
    if (const int64_t operations = counter.total(function.name); operations > kMostOperations)
      return {{function.line, fmt::format("'{}' comes to {} operations when each call is written out", function.name,
                                          operations >= kMost ? "over a thousand million" : std::to_string(operations)),
               "compilers write every call out: call once and keep the value"}};
  return {};
}

int64_t glslOperations(std::string_view text, std::string_view function) { return Counter(text).total(function); }

}  // namespace glint
