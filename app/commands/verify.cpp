// glint verify: the health card of shading models, with a verdict for machines.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/health_text.h"
#include "materials/base/log.h"
#include "materials/model_file.h"
#include "materials/model_registry.h"
#include "renderer/model_health.h"

namespace glint {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

// Whether it says that another file has a model's id.
bool isHidden(const ModelRegistry& registry, const Diagnostic& fault) {
  const auto& hidden = registry.hidden();
  return std::any_of(hidden.begin(), hidden.end(), [&](const ModelPtr& model) { return fault.place == fmt::format("{}:{}", model->file.string(), model->idLine); });
}

void print(const ModelHealth& card) {
  fmt::print("{}  {}  ({:.2f} s)\n", inColor(card.verdict(), fmt::format("{:<6}", name(card.verdict()))), card.model, card.seconds);
  for (const LawResult& law : card.laws) {
    fmt::print("  {} {:<14}{}{}{}{}\n", inColor(law.verdict, fmt::format("{:<5}", verdictWord(law.verdict))),
               name(law.law), finding(law), law.claimed && law.reason.empty() ? ", as it claims" : "",
               law.where.empty() ? "" : fmt::format(" ({})", law.where), law.hint.empty() ? "" : "; " + law.hint);
  }
}

int run(const Arguments& arguments) {
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  const ModelRegistry registry(arguments.modelFolders);
  std::vector<ModelHealth> cards;
  Diagnostics unknown;
  std::vector<std::string> wanted = arguments.all("models");
  if (wanted.empty()) {
    wanted = registry.ids();
    // A file whose head is wrong has no id: it is red all the same.
    std::map<std::string, Diagnostics> broken;  // by file
    for (const Diagnostic& fault : registry.problems())
      if (fault.severity == Severity::Error || isHidden(registry, fault)) broken[fault.place.substr(0, fault.place.rfind(':'))].push_back(fault);
      else log::report(fault);
    for (const auto& [file, faults] : broken) cards.push_back(unmeasurable(file, file, faults));
  }
  for (const std::string& what : wanted) {
    Diagnostics warnings;
    const auto model = registry.named(what, &warnings);
    log::report(warnings);
    if (model) cards.push_back(checkHealth(**model, arguments.has("compensate")));
    else if (isModelFile(what) && fs::exists(what)) cards.push_back(unmeasurable(what, what, model.diagnostics()));
    else unknown.insert(unknown.end(), model.diagnostics().begin(), model.diagnostics().end());
  }
  if (!unknown.empty()) return badInput(unknown);
  Verdict worst = Verdict::Green;
  ordered_json list = ordered_json::array();
  for (const ModelHealth& card : cards) {
    worst = std::max(worst, card.verdict());
    if (arguments.json) list.push_back(healthJson(card));
    else print(card);
  }
  if (arguments.json)
    fmt::print("{}\n", ordered_json{{"verdict", name(worst)}, {"models", list}}.dump(2, ' ', false, ordered_json::error_handler_t::replace));
  return worst == Verdict::Red ? kVerdictNo : kDone;
}

}  // namespace

extern const Command kVerifyCommand;
const Command kVerifyCommand = {
    .name = "verify",
    .summary = "The health card of models: finite, reciprocal, normalised, energy; exit 1 when a claim is broken",
    .options = {{"models", "ID or FILE", "models by id, mixes such as 'GGX*SmithGGX*Schlick', or files; all there are when left out", true},
                {"--compensate", "", "with what bounces among facets more than once given back, as models whose head asks for it always are"}},
    .examples = {"glint verify", "glint verify --compensate ggx", "glint verify burley ggx", "glint verify 'Blinn*SmithBeckmann*Schlick'", "glint verify my-model.glsl theirs.brdf --json"},
    .run = run,
};

}  // namespace glint
