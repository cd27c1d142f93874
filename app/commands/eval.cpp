// glint eval: terms, model values and integrals for a list of requests, from the shipped GLSL on the device.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/option_values.h"
#include "app/picture_file.h"
#include "materials/base/files.h"
#include "materials/base/json.h"
#include "materials/base/log.h"
#include "renderer/evaluation.h"

namespace glint {
namespace {

using nlohmann::ordered_json;

constexpr uint64_t kLargestWork = uint64_t{64} << 20;
constexpr size_t kMostReported = 20, kMostErrors = 100;

using Faults = std::vector<EvaluationFault>;

struct Work {
  std::string id;
  int line = 0;
  EvaluationRequest request;
};

// An argument of an entry itself or of its "args".
void readArgument(const std::string& key, const Json& value, EvaluationRequest& request, Faults& faults) {
  const auto wrong = [&](Json::Kind wanted, std::string hint) {
    faults.push_back({fmt::format("'{}' is {}, not {}", key, name(value.kind), wanted == Json::Kind::Array ? "a list of numbers" : name(wanted)), std::move(hint)});
  };
  switch (argumentKind(key)) {
    case ArgumentKind::Number:
      if (value.isNumber()) request.numbers[key] = value.number;
      else if (value.isString() && finiteNumber(value.text)) wrong(Json::Kind::Number, fmt::format("write {} without quotes", value.text));
      else wrong(Json::Kind::Number, writtenAs(Json::Kind::Number));
      break;
    case ArgumentKind::Numbers:
      if (value.isArray() && std::all_of(value.items.begin(), value.items.end(), [](const Json& v) { return v.isNumber(); }))
        for (const Json& v : value.items) request.vectors[key].push_back(v.number);
      else if (value.isArray()) faults.push_back({fmt::format("'{}' holds something else than numbers", key), "write [0, 0.6, 0.8]"});
      else wrong(Json::Kind::Array, "write [0, 0.6, 0.8]");
      break;
    case ArgumentKind::Name:
      if (value.isString()) request.names[key] = value.text;
      else wrong(Json::Kind::String, writtenAs(Json::Kind::String));
      break;
  }
}

// The tables' own words for what an entry is: a term, a quantity, or the A and B of an environment BRDF.
std::string subjectOf(const Json& entry, Faults& faults) {
  for (const char* key : {"term", "quantity"})
    if (const Json* text = entry.find(key)) {
      if (text->isString()) return text->text;
      faults.push_back({fmt::format("'{}' is {}, not a text", key, name(text->kind)), "name what is to be evaluated, for example \"D_GGX\""});
    }
  if (entry.find("model") && (entry.find("fresnel") || entry.find("A"))) return "environment_brdf";
  if (entry.find("radius") && (entry.find("center") || entry.find("L0"))) return "area_light";
  if (entry.find("env")) return "environment_light";
  return {};
}

// The names of an object's values, and those within them as "a.b".
void gatherNames(const Json& object, const std::string& prefix, std::set<std::string>& names) {
  for (size_t i = 0; i < object.keys.size(); ++i) {
    names.insert(prefix + object.keys[i]);
    if (object.items[i].isObject()) gatherNames(object.items[i], prefix + object.keys[i] + ".", names);
  }
}

// What a table says of its environments.
std::shared_ptr<const EnvironmentFormula> readFormula(const Json& described) {
  auto formula = std::make_shared<EnvironmentFormula>();
  const auto number = [](const Json* value, double low, double high, double& to) {
    if (!value || !value->isNumber() || !(value->number >= low && value->number <= high)) return false;
    to = value->number;
    return true;
  };
  const auto vector = [&](const Json* value, glm::dvec3& to) {
    bool good = value && value->isArray() && value->items.size() == 3;
    for (int i = 0; good && i < 3; ++i) good = number(&value->items[static_cast<size_t>(i)], -1e6, 1e6, to[i]);
    return good;
  };
  if (!described.isObject() || !number(described.find("constant"), 0, 1e6, formula->constant) || !vector(described.find("linear"), formula->linear)) return nullptr;
  const Json* lobes = described.find("sg");
  if (!lobes || !lobes->isArray() || lobes->items.size() > 64) return nullptr;
  for (const Json& lobe : lobes->items) {
    EnvironmentFormula::Lobe& read = formula->lobes.emplace_back();
    if (!lobe.isObject() || !vector(lobe.find("axis"), read.axis) || !(std::abs(glm::length(read.axis) - 1) < 1e-3) ||
        !number(lobe.find("amplitude"), 0, 1e6, read.amplitude) || !number(lobe.find("sharpness"), 0, 1e4, read.sharpness)) return nullptr;
  }
  return formula;
}

Work readEntry(const Json& entry, const std::string& id, const Json* models, Faults& faults) {
  Work work{id, entry.line, {}};
  work.request.what = subjectOf(entry, faults);
  const auto mixOf = [](const Json& parts) { return parts.isArray() && parts.items.size() >= 3 ? &parts : nullptr; };
  for (const char* key : {"model", "D", "G", "V", "F", "diffuse", "l", "v", "r", "center", "L0", "L1", "radius", "env"})
    if (const Json* value = entry.find(key); value && !(key == std::string_view("model") && mixOf(*value)))
      readArgument(key, *value, work.request, faults);
  // The tables' own ways to write D x G x F: its parts, or a name for them.
  const auto named = work.request.names.find("model");
  const Json* parts = entry.find("model") ? mixOf(*entry.find("model")) : nullptr;
  if (const Json* listed = models && named != work.request.names.end() ? models->find(named->second) : nullptr) parts = mixOf(*listed);
  const auto mixId = [&](const Json& listed) {
    std::vector<std::string> names;
    for (const Json& part : listed.items) {
      if (part.isString()) names.push_back(part.text);
      else faults.push_back({fmt::format("'model' holds {}", name(part.kind)), "name D, G and F, and the diffuse part if there is one"});
    }
    return fmt::format("{}", fmt::join(names, "*"));
  };
  if (parts) work.request.names["model"] = mixId(*parts);
  if (const Json* args = entry.find("args")) {
    if (!args->isObject()) faults.push_back({"'args' is not an object", "name each argument"});
    for (size_t i = 0; args->isObject() && i < args->keys.size(); ++i) {
      // In both places the arguments' is the one.
      work.request.vectors.erase(args->keys[i]);
      readArgument(args->keys[i], args->items[i], work.request, faults);
    }
  }
  if (work.request.what == "area_light" && models && models->isObject())
    for (const std::string& name : models->keys)
      if (const Json* listed = mixOf(*models->find(name))) work.request.models.emplace_back(name, mixId(*listed));
  if (const Json* own = entry.find("models"); work.request.what == "environment_light" && own && own->isObject())
    for (const std::string& name : own->keys) work.request.models.emplace_back(name, name);
  gatherNames(entry, "", work.request.extras);
  return work;
}

std::string placeOf(const std::string& file, int line, size_t index, const std::string& id) {
  return fmt::format("{}:{}: entry {}{}", file, line, index + 1, id.empty() ? "" : fmt::format(" '{}'", id));
}

Result<std::vector<Work>> readWork(const std::string& file, const ModelRegistry& registry) {
  const auto text = readFile(file, kLargestWork);
  if (!text) return text.diagnostics();
  const auto document = parseJson(*text, file, 1, {.bytes = kLargestWork});
  if (!document) return document.diagnostics();
  const Json* entries = document->isArray() ? &*document : document->find("entries");
  if (!entries || !entries->isArray())
    return error(file, "holds no list of entries", "write a list of {\"id\", \"term\", \"args\"}, or an object with such \"entries\"");
  const Json* models = document->find("models");
  const std::vector<Term> library = terms();
  Diagnostics problems;
  std::map<std::string, std::shared_ptr<const EnvironmentFormula>> environments;
  if (const Json* described = document->find("environments"); described && described->isObject())
    for (size_t i = 0; i < described->keys.size(); ++i)
      if (!(environments[described->keys[i]] = readFormula(described->items[i])))
        problems.push_back(error(fmt::format("{}:{}: environment '{}'", file, described->items[i].line, described->keys[i]), "is not described as it must be",
                                 R"(write {"constant": 0.2, "linear": [0, 0, 0.1], "sg": [{"axis": [0, 0, 1], "amplitude": 3, "sharpness": 12}]})"));
  std::vector<Work> work;
  std::map<std::string, size_t> seen;  // ids, and where they were first
  for (size_t i = 0; i < entries->items.size(); ++i) {
    const Json& entry = entries->items[i];
    Faults faults;
    std::string id;
    if (!entry.isObject()) {
      faults.push_back({fmt::format("is {}", name(entry.kind)), "each is an object with id, term and args"});
    } else if (const Json* given = entry.find("id"); !given || !given->isString()) {
      faults.push_back({given ? fmt::format("has an id that is {}", name(given->kind)) : "has no id", "give each a text of its own"});
    } else {
      id = given->text;
      if (const auto [first, fresh] = seen.try_emplace(id, i); !fresh)
        faults.push_back({fmt::format("has the id of entry {} in line {}", first->second + 1, entries->items[first->second].line), "give each an id of its own"});
      Work read = readEntry(entry, id, models, faults);
      if (const auto named = read.request.names.find("env"); named != read.request.names.end())
        if (const auto found = environments.find(named->second); found != environments.end()) read.request.environment = found->second;
      for (EvaluationFault& fault : faultsOf(read.request, registry, library)) faults.push_back(std::move(fault));
      work.push_back(std::move(read));
    }
    for (EvaluationFault& fault : faults) problems.push_back(error(placeOf(file, entry.line, i, id), std::move(fault.what), std::move(fault.hint)));
  }
  if (problems.size() > kMostErrors) {
    const size_t more = problems.size() - kMostErrors;
    problems.resize(kMostErrors);
    problems.push_back(error(file, fmt::format("has {} more faults", more), "the first are named above"));
  }
  if (!problems.empty()) return problems;
  return work;
}

ordered_json valueJson(const EvaluationResult& result) {
  const auto plain = [](const std::vector<double>& values) { return values.size() == 1 ? ordered_json(values[0]) : ordered_json(values); };
  if (result.values.size() == 1 && result.values.begin()->first == "value") return plain(result.values.begin()->second);
  ordered_json object = ordered_json::object();
  for (const auto& [name, values] : result.values) object[name] = plain(values);
  return object;
}

// The first of many.
void report(const std::string& file, const Diagnostics& all, const std::string& what) {
  log::report(Diagnostics(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), kMostReported))));
  if (all.size() > kMostReported)
    log::report(warning(file, fmt::format("{} more {}", all.size() - kMostReported, what), "the first are named above"));
}

int run(const Arguments& arguments) {
  const std::string file = arguments.get("work"), output = arguments.get("output");
  if (!output.empty())
    if (const Diagnostics problems = checkOutput(output, "--output", "list of values", {".json"}); !problems.empty()) return badInput(problems);
  const ModelRegistry registry(arguments.modelFolders);
  log::report(registry.warnings());
  const auto work = readWork(file, registry);
  if (!work) return badInput(work.diagnostics());
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  std::vector<EvaluationRequest> requests;
  for (const Work& w : *work) requests.push_back(w.request);
  const std::vector<EvaluationResult> results = evaluate(requests, registry);

  ordered_json values = ordered_json::array();
  Diagnostics missing, notes;
  for (size_t i = 0; i < results.size(); ++i) {
    const std::string place = placeOf(file, (*work)[i].line, i, (*work)[i].id);
    if (results[i].fault.empty()) {
      if (!results[i].note.empty()) notes.push_back(warning(place, results[i].note, "ask for a greater roughness, or for single terms"));
      // Values that an entry lists under its own names are asked for; others would be compared with nothing.
      EvaluationResult kept = results[i];
      const bool ofLight = requests[i].what == "area_light" || requests[i].what == "environment_light";
      const bool lists = std::any_of(kept.values.begin(), kept.values.end(), [&](const auto& v) { return requests[i].extras.count(v.first) != 0; });
      if (kept.values.size() > 1 && (lists || !ofLight))
        std::erase_if(kept.values, [&](const auto& v) { return v.first != "value" && v.first != "A" && v.first != "B" &&
                                                               !requests[i].extras.count(v.first); });
      values.push_back({{"id", (*work)[i].id}, {"value", valueJson(kept)}});
    } else {
      missing.push_back(warning(place, "is not evaluated: " + results[i].fault, results[i].hint));
    }
  }
  const std::string text = values.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  if (!output.empty()) {
    if (const Diagnostics problems = writeFileAtomic(output, text); !problems.empty()) return badInput(problems);
  }
  if (output.empty() || arguments.json) fmt::print("{}", text);
  else if (!arguments.quiet) fmt::print("{}\n", output);
  report(file, notes, "are computed with another alpha");
  report(file, missing, "are not evaluated");
  return missing.empty() ? kDone : kVerdictNo;
}

}  // namespace

extern const Command kEvalCommand;
const Command kEvalCommand = {
    .name = "eval",
    .summary = "Evaluate terms, models and integrals from the GLSL that draws; exit 1 when an entry cannot be",
    .options = {{.name = "work", .argument = "WORK.json", .help = "a list of {\"id\", \"term\", \"args\"}, or a table with such \"entries\"; of a model, f_ID or f_FILE, the args are what it reads: r and F0 of the surface, and its own parameters", .required = true},
                {.name = "-o,--output", .argument = "OUT.json", .help = "write the list of {\"id\", \"value\"} there; standard output without it"}},
    .examples = {"glint eval work.json -o values.json", "glint eval terms.public.json -o values.json"},
    .run = run,
};

}  // namespace glint
