// glint verify: the health card of shading models, with a verdict for machines.
#include <fmt/color.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "materials/base/log.h"
#include "materials/model_file.h"
#include "materials/model_registry.h"
#include "renderer/model_health.h"
#include "renderer/sampler_error.h"

namespace glint {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

// A model by its id, a mix, or a file that is one.
Result<ModelPtr> find(const std::string& what, const ModelRegistry& registry) {
  std::error_code code;
  if (!isModelFile(what) || !fs::exists(what, code)) return registry.get(what);
  Diagnostics warnings;
  auto model = readModelFile(what, warnings);
  log::report(warnings);
  if (!model) return model.diagnostics();
  return ModelPtr(std::make_shared<const ShadingModel>(std::move(*model)));
}

// The card of a file that never became a model: all that is wrong with it.
ModelHealth unreadable(const std::string& what, const Diagnostics& faults) {
  ModelHealth card{.model = what, .file = what, .laws = {}};
  for (const Diagnostic& fault : faults)
    card.laws.push_back({.law = Law::Compiles, .verdict = Verdict::Red, .where = fault.place, .reason = fault.what, .hint = fault.hint});
  return card;
}

// Whether it says that another file has a model's id.
bool isHidden(const ModelRegistry& registry, const Diagnostic& fault) {
  const auto& hidden = registry.hidden();
  return std::any_of(hidden.begin(), hidden.end(), [&](const ModelPtr& model) { return fault.place == fmt::format("{}:{}", model->file.string(), model->idLine); });
}

ordered_json toJson(const ModelHealth& card) {
  ordered_json laws = ordered_json::array();
  for (const LawResult& law : card.laws) {
    ordered_json entry{{"law", name(law.law)}, {"verdict", name(law.verdict)}, {"claimed", law.claimed}};
    if (std::isfinite(law.value)) entry["value"] = law.value;
    if (!law.where.empty()) entry["where"] = law.where;
    if (!law.reason.empty()) entry["reason"] = law.reason;
    if (!law.hint.empty()) entry["hint"] = law.hint;
    laws.push_back(std::move(entry));
  }
  return {{"model", card.model},
          {"file", card.file},
          {"verdict", name(card.verdict())},
          {"reason", card.reason()},
          {"seconds", card.seconds},
          {"laws", laws}};
}

std::string colored(Verdict verdict, const std::string& text) {
  if (!isatty(STDOUT_FILENO)) return text;
  const fmt::terminal_color color = verdict == Verdict::Green ? fmt::terminal_color::green
                                    : verdict == Verdict::Amber ? fmt::terminal_color::yellow
                                                                : fmt::terminal_color::red;
  return fmt::format(fmt::fg(color), "{}", text);
}

// What a law's number means, in words.
std::string measured(const LawResult& law) {
  switch (law.law) {
    case Law::Compiles: return "compiles";
    case Law::Finite: return "finite everywhere it was asked";
    case Law::NonNegative: return "nowhere negative";
    case Law::Reciprocity: return fmt::format("swapping light and view changes f by at most {:.2g} %", 100 * law.value);
    case Law::Normalisation: return fmt::format("D integrates to {:.4f}", law.value);
    case Law::Energy: return fmt::format("reflects at most {:.4f} of what it receives", law.value);
    case Law::Furnace: return fmt::format("white, it keeps at least {:.4f} of uniform light", law.value);
    case Law::MirrorLimit: return fmt::format("a smooth white mirror reflects {:.4f}", law.value);
    case Law::Environment: return fmt::format("split sum is {:.1f} % off (RMS)", 100 * law.value);
    case Law::Sampler: return fmt::format("{} samples give the albedo to {:.2g} %", SamplerError::kSamples, 100 * law.value);
  }
  return {};
}

void print(const ModelHealth& card) {
  fmt::print("{}  {}  ({:.2f} s)\n", colored(card.verdict(), fmt::format("{:<6}", name(card.verdict()))), card.model, card.seconds);
  for (const LawResult& law : card.laws) {
    const std::string text = law.reason.empty() ? measured(law) : law.reason;
    fmt::print("  {} {:<14}{}{}{}{}\n", colored(law.verdict, law.verdict == Verdict::Green ? "ok   " : fmt::format("{:<5}", name(law.verdict))),
               name(law.law), text, law.claimed && law.reason.empty() ? ", as it claims" : "",
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
    for (const auto& [file, faults] : broken) cards.push_back(unreadable(file, faults));
  }
  for (const std::string& what : wanted) {
    const auto model = find(what, registry);
    if (model) cards.push_back(checkHealth(**model, arguments.has("compensate")));
    else if (isModelFile(what) && fs::exists(what)) cards.push_back(unreadable(what, model.diagnostics()));
    else unknown.insert(unknown.end(), model.diagnostics().begin(), model.diagnostics().end());
  }
  if (!unknown.empty()) return badInput(unknown);
  Verdict worst = Verdict::Green;
  ordered_json list = ordered_json::array();
  for (const ModelHealth& card : cards) {
    worst = std::max(worst, card.verdict());
    if (arguments.json) list.push_back(toJson(card));
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
