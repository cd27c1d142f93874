#include "materials/terms.h"

#include <algorithm>
#include <iterator>

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
  for (GlslFunction& function : scanGlsl(termsGlsl()).functions) {
    if (!function.takes({"Shading"})) continue;
    for (const KindRow& kind : kKinds)
      if (function.name.starts_with(kind.prefix) && function.returnType == kind.type)
        found.push_back({kind.kind, function.name.substr(kind.prefix.size()), std::move(function.comment)});
  }
  std::stable_sort(found.begin(), found.end(), [](const Term& a, const Term& b) { return a.kind < b.kind; });
  return found;
}

std::vector<std::string> termNames(TermKind kind) {
  std::vector<std::string> names;
  for (Term& term : terms())
    if (term.kind == kind) names.push_back(std::move(term.name));
  return names;
}

}  // namespace glint
