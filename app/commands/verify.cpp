// glint verify: the health card of shading models, with a verdict for machines.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/health_text.h"
#include "app/scene_options.h"
#include "materials/base/log.h"
#include "materials/graph_compile.h"
#include "materials/model_file.h"
#include "materials/model_registry.h"
#include "renderer/model_health.h"

namespace glint {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

void print(const ModelHealth& card) {
  fmt::print("{}  {}  ({:.2f} s)\n", inColor(card.verdict(), fmt::format("{:<6}", name(card.verdict()))), card.model, card.seconds);
  for (const LawResult& law : card.laws) {
    fmt::print("  {} {:<14}{}{}{}{}\n", inColor(law.verdict, fmt::format("{:<5}", verdictWord(law.verdict))),
               name(law.law), finding(law), law.claimed && law.reason.empty() ? ", as it claims" : "",
               law.where.empty() ? "" : fmt::format(" ({})", law.where), law.hint.empty() ? "" : "; " + law.hint);
  }
}

// A model as it is named, "mobile:quarter=1" with values in the place of its parameters' defaults: a number is then also all
// that is tried of that parameter.
Result<ShadingModel> withParameters(const ModelRegistry& registry, const std::string& what, Diagnostics& warnings) {
  const auto whole = registry.named(what, &warnings);
  if (whole) return **whole;
  const auto choices = parseModelList(what, "models");
  if (!choices || choices->size() != 1 || choices->front().parameters.empty()) return whole.diagnostics();
  const auto found = registry.named(choices->front().id, &warnings);
  if (!found) return found.diagnostics();
  ShadingModel model = **found;
  Diagnostics faults;
  for (const Setting& setting : choices->front().parameters) {
    const auto parameter = std::find_if(model.parameters.begin(), model.parameters.end(),
                                        [&](const ModelParameter& p) { return p.name == setting.name || p.fileName == setting.name; });
    const auto value = overrideValue(model, setting.name, setting.text);
    if (!value) {
      faults.push_back(value.diagnostics()[0]);
      faults.back().place = what;
    } else if (parameter == model.parameters.end()) {
      faults.push_back(error(what, fmt::format("'{}' is an attribute of the material, not a parameter of '{}'", setting.name, model.id), "a card is of all attributes"));
    } else {
      parameter->standard = *value;
      if (componentCount(value->type) == 1) parameter->minimum = parameter->maximum = value->v[0];
    }
  }
  if (!faults.empty()) return faults;
  return model;
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
  log::report(registry.warnings());
  const bool everything = wanted.empty();
  if (everything) {
    wanted = registry.ids();
    // A file whose head is wrong has no id: it is red all the same.
    cards = unusableModels(registry);
  }
  for (const std::string& what : wanted) {
    Diagnostics warnings;
    const auto model = withParameters(registry, what, warnings);
    log::report(warnings);
    if (model) {
      cards.push_back(checkHealth(*model, arguments.has("compensate")));
      if (everything) continue;
      if (!isModelFile(what)) cards.back().model = what;
      // A file that the same id means is told beside the one that is used.
      const std::vector<ModelHealth> rivals = unusableModels(registry, model->id);
      cards.insert(cards.end(), rivals.begin(), rivals.end());
    } else if (isModelFile(what) && fs::exists(what)) cards.push_back(unmeasurable(what, what, model.diagnostics()));
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
    .options = {{"models", "ID or FILE", "models by id, mixes such as 'GGX*SmithGGX*Schlick', or files, with parameters: ID:param=value; all there are when left out", true},
                {"--compensate", "", "with what bounces among facets more than once given back, as models whose head asks for it always are"}},
    .examples = {"glint verify", "glint verify --compensate ggx", "glint verify burley ggx", "glint verify 'Blinn*SmithBeckmann*Schlick'", "glint verify my-model.glsl theirs.brdf --json"},
    .run = run,
};

}  // namespace glint
