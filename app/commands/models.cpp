// glint models: every shading model there is, what it is made of, what it claims and what is wrong with it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "materials/base/log.h"
#include "materials/model_registry.h"
#include "materials/terms.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

using nlohmann::ordered_json;

// The head's name of a part, or "own" where the file defines it.
std::string part(bool defined, const std::string& term) { return defined ? "own" : term; }

std::string partsText(const ShadingModel& m) {
  if (m.definesSpecular) return "specular own, diffuse " + part(m.definesDiffuse, m.termDiffuse);
  const std::string V = m.termV.empty() ? m.termG : m.termV;
  return fmt::format("D {}, V {}, F {}, diffuse {}", part(m.definesD, m.termD), part(m.definesV, V),
                     part(m.definesF, m.termF), part(m.definesDiffuse, m.termDiffuse));
}

ordered_json valueJson(const Value& value) {
  if (value.type == ValueType::Bool) return value.v[0] != 0;
  if (value.type == ValueType::Int) return static_cast<int>(value.v[0]);
  if (componentCount(value.type) == 1) return value.v[0];
  ordered_json list = ordered_json::array();
  for (int i = 0; i < componentCount(value.type); ++i) list.push_back(value.v[static_cast<size_t>(i)]);
  return list;
}

ordered_json modelJson(const ShadingModel& m) {
  ordered_json parameters = ordered_json::array();
  for (const ModelParameter& p : m.parameters)
    parameters.push_back({{"name", p.name},
                          {"title", p.title},
                          {"type", name(p.standard.type)},
                          {"default", valueJson(p.standard)},
                          {"min", p.minimum},
                          {"max", p.maximum},
                          {"perPixel", p.slot >= 0},
                          {"doc", p.doc}});
  ordered_json terms = ordered_json::object();
  const auto add = [&](const char* key, bool defined, const std::string& term) {
    if (defined || !term.empty()) terms[key] = part(defined, term);
  };
  add("specular", m.definesSpecular, "");
  add("D", m.definesD, m.termD);
  add("V", m.definesV, m.termV.empty() ? m.termG : m.termV);
  add("F", m.definesF, m.termF);
  add("diffuse", m.definesDiffuse, m.termDiffuse);
  return {{"id", m.id},
          {"title", m.title},
          {"doc", m.doc},
          {"file", m.file.string()},
          {"color", m.color},
          {"parameters", parameters},
          {"terms", terms},
          {"claims", {{"reciprocal", m.claims.reciprocal}, {"energyConserving", m.claims.energyConserving}}},
          {"uses", m.uses},
          {"cite", m.cite}};
}

ordered_json problemsJson(const Diagnostics& problems) {
  ordered_json list = ordered_json::array();
  for (const Diagnostic& p : problems) list.push_back({{"place", p.place}, {"what", p.what}, {"hint", p.hint}});
  return list;
}

void printModel(const ShadingModel& m) {
  fmt::print("{:<16}{}\n", m.id, m.title);
  if (!m.doc.empty()) fmt::print("{:<16}{}\n", "", m.doc);
  fmt::print("{:<16}{}\n", "", partsText(m));
  for (const ModelParameter& p : m.parameters)
    fmt::print("{:<16}{} {} ({}..{}): {}\n", "", p.name, valueText(p.standard), p.minimum, p.maximum, p.doc);
  fmt::print("{:<16}claims: {}\n", "",
             m.claims.reciprocal && m.claims.energyConserving ? "reciprocal, energy conserving"
             : m.claims.reciprocal                            ? "reciprocal"
             : m.claims.energyConserving                      ? "energy conserving"
                                                              : "nothing");
  for (const std::string& cite : m.cite) fmt::print("{:<16}cites {}\n", "", cite);
  fmt::print("{:<16}{}\n\n", "", m.file.string());
}

// What compilers say of every model, drawn anywhere or not.
Diagnostics compileFaults(const gl::Context& context, const ModelRegistry& registry) {
  Renderer renderer(context);
  Diagnostics faults;
  for (const ModelPtr& model : registry.all()) {
    const Diagnostics found = renderer.check(model);
    faults.insert(faults.end(), found.begin(), found.end());
  }
  return faults;
}

int run(const Arguments& arguments) {
  const ModelRegistry registry(arguments.modelFolders);
  Diagnostics problems = registry.problems();
  auto context = gl::Context::create({.backend = arguments.backend});
  if (context) {
    const Diagnostics faults = compileFaults(**context, registry);
    problems.insert(problems.end(), faults.begin(), faults.end());
  } else if (arguments.backend != gl::Backend::Auto) {
    log::report(context.diagnostics());
    return kNoContext;
  } else {
    log::report(warning("glint models", "without OpenGL no model's GLSL was compiled", context.diagnostics()[0].what));
  }
  const std::vector<Term> library = terms();
  if (arguments.json) {
    ordered_json document{{"models", ordered_json::array()}, {"terms", ordered_json::array()}};
    for (const ModelPtr& model : registry.all()) document["models"].push_back(modelJson(*model));
    for (const Term& term : library)
      document["terms"].push_back({{"kind", name(term.kind)}, {"name", term.name}, {"doc", term.doc}});
    document["problems"] = problemsJson(problems);
    fmt::print("{}\n", document.dump(2, ' ', false, ordered_json::error_handler_t::replace));
  } else {
    for (const ModelPtr& model : registry.all()) printModel(*model);
    for (const TermKind kind : {TermKind::D, TermKind::V, TermKind::F, TermKind::Diffuse})
      fmt::print("terms {:<10}{}\n", name(kind), fmt::join(termNames(kind), ", "));
  }
  log::report(problems);
  return problems.empty() ? kDone : kVerdictNo;
}

}  // namespace

extern const Command kModelsCommand;
const Command kModelsCommand = {
    .name = "models",
    .summary = "List the shading models and terms, with parameters, claims, citations; exit 1 when any has a problem",
    .examples = {"glint models", "glint models --json", "glint models --models-dir my-models"},
    .run = run,
};

}  // namespace glint
