#include "materials/terms.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "materials/base/check.h"
#include "materials/glsl_scan.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

struct KindRow {
  TermKind kind;
  std::string_view name, prefix, type;
};
constexpr KindRow kKinds[] = {
    {TermKind::D, "D", "D_", "float"},
    {TermKind::V, "V", "V_", "float"},
    {TermKind::F, "F", "F_", "vec3"},
    {TermKind::Diffuse, "diffuse", "Fd_", "vec3"},
};
const KindRow& row(TermKind kind) {
  const auto index = static_cast<size_t>(kind);
  GLINT_CHECK(index < std::size(kKinds) && kKinds[index].kind == kind, "kind {}", index);
  return kKinds[index];
}

// `  gamma from 0.5 to 6, 1.5: how long the tail is`.
std::optional<TermParameter> parameterLine(const std::string& line) {
  char name[64];
  TermParameter p;
  int end = 0;
  if (std::sscanf(line.c_str(), " %63[A-Za-z0-9_] from %f to %f, %f: %n", name, &p.minimum, &p.maximum, &p.standard, &end) != 4 ||
      end == 0)
    return std::nullopt;
  p.name = name;
  p.doc = line.substr(static_cast<size_t>(end));
  return p;
}

// The term that a function is: nothing unless each float after the Shading is told in the comment.
std::optional<Term> termOf(const GlslFunction& function, const KindRow& kind) {
  if (!function.name.starts_with(kind.prefix) || function.returnType != kind.type) return std::nullopt;
  if (function.parameterTypes.empty() || function.parameterTypes[0] != "Shading") return std::nullopt;
  Term term{kind.kind, function.name.substr(kind.prefix.size()), "", {}, false};
  std::vector<TermParameter> told;
  std::istringstream lines(function.comment);
  for (std::string line; std::getline(lines, line);) {
    if (auto parameter = parameterLine(line)) told.push_back(std::move(*parameter));
    else term.doc += (term.doc.empty() ? "" : "\n") + line;
  }
  term.ofOwnD = function.takes({"Shading", "ProjectedAreas"});
  if (term.ofOwnD) return term;
  for (size_t i = 1; i < function.parameterTypes.size(); ++i) {
    const auto at = std::find_if(told.begin(), told.end(),
                                 [&](const TermParameter& p) { return p.name == function.parameterNames[i]; });
    if (at == told.end() || function.parameterTypes[i] != "float") return std::nullopt;
    term.parameters.push_back(*at);
  }
  return term;
}

}  // namespace

std::string_view name(TermKind kind) { return row(kind).name; }
std::string_view prefix(TermKind kind) { return row(kind).prefix; }

std::string termsGlsl() {
  std::string text;
  for (const std::string& path : shipped::list("shaders/terms", ".glsl"))
    if (const auto file = shipped::read(path)) text += *file + "\n";
  return text;
}

std::vector<Term> terms() {
  std::vector<Term> found;
  for (const GlslFunction& function : scanGlsl(termsGlsl()).functions)
    for (const KindRow& kind : kKinds)
      if (auto term = termOf(function, kind)) found.push_back(std::move(*term));
  std::stable_sort(found.begin(), found.end(), [](const Term& a, const Term& b) { return a.kind < b.kind; });
  return found;
}

std::vector<std::string> termNames(TermKind kind) {
  std::vector<std::string> names;
  for (Term& term : terms())
    if (term.kind == kind) names.push_back(std::move(term.name));
  return names;
}

std::optional<Term> findTerm(TermKind kind, std::string_view name) {
  for (Term& term : terms())
    if (term.kind == kind && term.name == name) return std::move(term);
  return std::nullopt;
}

}  // namespace glint
