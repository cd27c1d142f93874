#include "materials/base/diagnostic.h"

#include <algorithm>

namespace glint {

std::string Diagnostic::text() const {
  return hint.empty() ? fmt::format("{}: {}", place, what)
                      : fmt::format("{}: {}; {}", place, what, hint);
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

namespace {

size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

}  // namespace

std::string withArticle(std::string_view noun) {
  const size_t first = noun.find_first_not_of("'\"");
  const bool vowel = first != noun.npos && std::string_view("aeioAEIO").find(noun[first]) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

std::string nearest(const std::string& name, const std::vector<std::string>& names) {
  if (name.size() > 200) return {};
  std::string best;
  size_t bestDistance = std::max<size_t>(2, name.size() / 2) + 1;
  for (const std::string& candidate : names) {
    if (candidate.size() > 200) continue;
    const size_t distance = editDistance(name, candidate);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string suggestion(const std::string& name, const std::vector<std::string>& names) {
  if (const std::string best = nearest(name, names); !best.empty())
    return fmt::format("did you mean '{}'?", best);
  if (names.empty()) return {};
  std::string known = "known: ";
  for (size_t i = 0; i < names.size(); ++i) {
    if (i == 12) return known + ", ...";
    known += (i ? ", " : "") + names[i];
  }
  return known;
}

}  // namespace glint
