// glint models: every shading model there is, what it is made of, what it claims and what is wrong with it.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/health_text.h"
#include "app/models_page.h"
#include "app/option_values.h"
#include "app/scene_loader.h"
#include "materials/base/files.h"
#include "materials/base/hash.h"
#include "materials/base/log.h"
#include "materials/model_registry.h"
#include "materials/terms.h"
#include "renderer/image_io.h"
#include "renderer/model_health_cache.h"
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

ordered_json modelJson(const ShadingModel& m, const ModelHealth* card) {
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
          {"health", card ? healthJson(*card) : ordered_json()},
          {"uses", m.uses},
          {"cite", m.cite}};
}

ordered_json problemsJson(const Diagnostics& problems) {
  ordered_json list = ordered_json::array();
  for (const Diagnostic& p : problems) list.push_back({{"place", p.place}, {"what", p.what}, {"hint", p.hint}});
  return list;
}

void printModel(const ShadingModel& m, const ModelHealth* card) {
  fmt::print("{:<15} {}\n", m.id, m.title);
  if (card) fmt::print("{:<16}{}\n", "", inColor(card->verdict(), oneLine(*card)));
  if (!m.doc.empty()) fmt::print("{:<16}{}\n", "", m.doc);
  fmt::print("{:<16}{}\n", "", partsText(m));
  for (const ModelParameter& p : m.parameters)
    fmt::print("{:<16}{} {} ({}..{}): {}\n", "", p.name, valueText(p.standard), p.minimum, p.maximum, p.doc);
  fmt::print("{:<16}claims: {}\n", "", claimsText(m));
  for (const std::string& cite : m.cite) fmt::print("{:<16}cites {}\n", "", cite);
  fmt::print("{:<16}{}\n\n", "", m.file.string());
}

// What compilers say of every model, drawn anywhere or not, and the cards of those they say nothing of: kept ones, and
// others measured now.
struct Examined {
  Diagnostics faults;
  std::vector<ModelPtr> sound;               // those that compile
  std::map<std::string, ModelHealth> cards;  // by id
};

Examined examine(Renderer& renderer, const std::vector<ModelPtr>& all) {
  Examined found;
  bool measured = false;
  for (size_t i = 0; i < all.size(); ++i) {
    const ShadingModel& model = *all[i];
    const Diagnostics faults = renderer.check(all[i]);
    if (faults.empty()) found.sound.push_back(all[i]);
    auto card = faults.empty() ? keptHealth(model) : unmeasurable(model.id, model.file.string(), faults);
    if (!card) {
      log::progress("checking " + model.id, double(i) / double(all.size()));
      card = healthOf(model);
      measured = true;
    }
    found.cards.emplace(model.id, std::move(*card));
    found.faults.insert(found.faults.end(), faults.begin(), faults.end());
  }
  if (measured) log::progress("checking models", 1);
  return found;
}

// README.md and a picture for each model that compiles. Nothing is written unless all of it is there to write.
Diagnostics writePage(const Arguments& arguments, const gl::Context& context, Renderer& renderer, Libraries& libraries,
                      const Examined& found) {
  namespace fs = std::filesystem;
  const fs::path folder = arguments.get("page"), pictures = folder / "pictures";
  std::vector<ModelHealth> unusable;
  if (arguments.all("models").empty()) unusable = unusableModels(libraries.models);
  for (const auto& [id, card] : found.cards)
    if (std::none_of(found.sound.begin(), found.sound.end(), [&, wanted = std::string_view(id)](const ModelPtr& m) { return m->id == wanted; })) unusable.push_back(card);
  const auto page = modelsPage(renderer, libraries, found.sound, found.cards, unusable, "glint models --page " + folder.generic_string());
  if (!page) return page.diagnostics();
  std::error_code code;
  fs::create_directories(pictures, code);
  if (code) return {error(pictures.string(), "cannot be made: " + code.message(), "check its permissions")};
  Diagnostics faults;
  for (const auto& [id, picture] : page->pictures) {
    const ModelPtr model = *std::find_if(found.sound.begin(), found.sound.end(), [&, wanted = std::string_view(id)](const ModelPtr& m) { return m->id == wanted; });
    const ImageNotes notes = {{"Command", arguments.commandLine}, {"Software", "Glint " GLINT_VERSION}, {"OpenGL renderer", context.info().renderer},
                              {"Models", hashName(model->hash) + " " + id}};
    const Diagnostics failed = writeImage8(pictures / (id + ".png"), picture, notes);
    faults.insert(faults.end(), failed.begin(), failed.end());
  }
  if (faults.empty()) faults = writeFileAtomic(folder / "README.md", page->text);
  return faults;
}

int run(const Arguments& arguments) {
  Libraries libraries(arguments.modelFolders);
  const ModelRegistry& registry = libraries.models;
  std::vector<ModelPtr> listed;
  Diagnostics problems;
  for (const std::string& wanted : arguments.all("models")) {
    ModelPtr model;
    if (!keep(problems, libraries.namedModel(wanted, "models"), model)) continue;
    const auto taken = std::find_if(listed.begin(), listed.end(), [&](const ModelPtr& other) { return other->id == model->id; });
    if (taken == listed.end()) listed.push_back(std::move(model));
    else if (*taken != model) problems.push_back(error(wanted, fmt::format("has the id of {}, '{}'", (*taken)->file.string(), model->id), "list one of them"));
  }
  if (!problems.empty()) return badInput(problems);
  const bool everything = listed.empty();
  if (everything) {
    listed = registry.all();
    problems = registry.problems();
  }
  auto context = gl::Context::create({.backend = arguments.backend});
  Examined found;
  if (context) {
    Renderer renderer(**context);
    found = examine(renderer, listed);
    problems.insert(problems.end(), found.faults.begin(), found.faults.end());
    if (arguments.has("page"))
      if (const Diagnostics faults = writePage(arguments, **context, renderer, libraries, found); !faults.empty()) return badInput(faults);
  } else if (arguments.backend != gl::Backend::Auto || arguments.has("page")) {
    log::report(context.diagnostics());
    return kNoContext;
  } else {
    log::report(warning("glint models", "without OpenGL no model's GLSL was compiled", context.diagnostics()[0].what));
    for (const ModelPtr& model : listed)
      if (auto kept = keptHealth(*model)) found.cards.emplace(model->id, std::move(*kept));
  }
  const auto cardOf = [&](const ModelPtr& model) -> const ModelHealth* {
    const auto card = found.cards.find(model->id);
    return card == found.cards.end() ? nullptr : &card->second;
  };
  const std::vector<Term> library = terms();
  if (arguments.json) {
    ordered_json document{{"models", ordered_json::array()}, {"terms", ordered_json::array()}};
    for (const ModelPtr& model : listed) document["models"].push_back(modelJson(*model, cardOf(model)));
    for (const Term& term : library)
      document["terms"].push_back({{"kind", name(term.kind)}, {"name", term.name}, {"doc", term.doc}});
    document["problems"] = problemsJson(problems);
    fmt::print("{}\n", document.dump(2, ' ', false, ordered_json::error_handler_t::replace));
  } else {
    for (const ModelPtr& model : listed) printModel(*model, cardOf(model));
    if (everything)
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
    .summary = "List the shading models and terms, with health, parameters, claims, citations; exit 1 when any has a problem",
    .options = {{"models", "ID or FILE", "models by id, mixes, or files; all there are when left out", true},
                {"--page", "DIR", "also write a page that shows them, DIR/README.md, with a picture for each"}},
    .examples = {"glint models", "glint models ggx my-model.brdf", "glint models --json", "glint models --page models-page", "glint models --models-dir my-models"},
    .run = run,
};

}  // namespace glint
