// glint eval: terms, model values and integrals for a list of requests, from the shipped GLSL on the device.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/picture_file.h"
#include "materials/base/files.h"
#include "materials/base/json.h"
#include "materials/base/log.h"
#include "renderer/evaluation.h"

namespace glint {
namespace {

using nlohmann::ordered_json;

constexpr uint64_t kLargestWork = uint64_t{64} << 20;
constexpr size_t kMostReported = 20;

struct Work {
  std::string id;
  int line = 0;
  EvaluationRequest request;
};

// Numbers, lists of numbers and names, from an entry itself or its "args".
void addArguments(const Json& object, EvaluationRequest& request) {
  for (size_t i = 0; i < object.keys.size(); ++i) {
    const std::string& key = object.keys[i];
    const Json& value = object.items[i];
    if (value.isNumber()) request.numbers[key] = value.number;
    else if (value.isString()) request.names[key] = value.text;
    else if (value.isArray() && !value.items.empty() &&
             std::all_of(value.items.begin(), value.items.end(), [](const Json& v) { return v.isNumber(); }))
      for (const Json& v : value.items) request.vectors[key].push_back(v.number);
  }
}

// The tables' own words for what an entry is: a term, a quantity, or the A and B of an environment BRDF.
std::string subjectOf(const Json& entry) {
  for (const char* key : {"term", "quantity"})
    if (const Json* text = entry.find(key); text && text->isString()) return text->text;
  if (entry.find("model") && (entry.find("fresnel") || entry.find("A"))) return "environment_brdf";
  return {};
}

std::optional<Work> readEntry(const Json& entry, const std::string& file, const Json* models, Diagnostics& problems) {
  const std::string place = fmt::format("{}:{}", file, entry.line);
  if (!entry.isObject()) {
    problems.push_back(error(place, fmt::format("an entry is {}", name(entry.kind)), "each is an object with id, term and args"));
    return std::nullopt;
  }
  const Json* id = entry.find("id");
  if (!id || !id->isString()) {
    problems.push_back(error(place, "an entry has no id", "give each a text of its own"));
    return std::nullopt;
  }
  Work work{id->text, entry.line, {}};
  work.request.what = subjectOf(entry);
  for (const char* key : {"model", "D", "G", "V", "F", "diffuse"})
    if (const Json* text = entry.find(key); text && text->isString()) work.request.names[key] = text->text;
  // The table's own name for D x G x F.
  if (const auto model = work.request.names.find("model"); model != work.request.names.end() && models)
    if (const Json* parts = models->find(model->second); parts && parts->isArray() && parts->items.size() >= 3)
      model->second = parts->items[0].text + "*" + parts->items[1].text + "*" + parts->items[2].text;
  if (const Json* args = entry.find("args")) {
    if (args->isObject()) addArguments(*args, work.request);
    else problems.push_back(error(fmt::format("{}:{}", file, args->line), "'args' is not an object", "name each argument"));
  }
  for (const char* key : {"l", "v"})
    if (const Json* vector = entry.find(key); vector && vector->isArray() && !work.request.vectors.count(key))
      for (const Json& v : vector->items) work.request.vectors[key].push_back(v.number);
  for (const std::string& key : entry.keys) work.request.extras.insert(key);
  return work;
}

Result<std::vector<Work>> readWork(const std::string& file) {
  const auto text = readFile(file, kLargestWork);
  if (!text) return text.diagnostics();
  const auto document = parseJson(*text, file, 1, {.bytes = kLargestWork});
  if (!document) return document.diagnostics();
  const Json* entries = document->isArray() ? &*document : document->find("entries");
  if (!entries || !entries->isArray())
    return error(file, "holds no list of entries", "write a list of {\"id\", \"term\", \"args\"}, or an object with such \"entries\"");
  const Json* models = document->find("models");
  Diagnostics problems;
  std::vector<Work> work;
  for (const Json& entry : entries->items)
    if (auto read = readEntry(entry, file, models, problems)) work.push_back(std::move(*read));
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

int run(const Arguments& arguments) {
  const std::string file = arguments.get("work"), output = arguments.get("output");
  if (!output.empty())
    if (const Diagnostics problems = checkOutput(output, "--output", "list of values", {".json"}); !problems.empty()) return badInput(problems);
  const auto work = readWork(file);
  if (!work) return badInput(work.diagnostics());
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  const ModelRegistry registry(arguments.modelFolders);
  std::vector<EvaluationRequest> requests;
  for (const Work& w : *work) requests.push_back(w.request);
  const std::vector<EvaluationResult> results = evaluate(requests, registry);

  ordered_json values = ordered_json::array();
  Diagnostics missing;
  for (size_t i = 0; i < results.size(); ++i) {
    if (results[i].fault.empty()) {
      // Values that an entry lists under its own names are asked for; others would be compared with nothing.
      EvaluationResult kept = results[i];
      if (kept.values.size() > 1)
        std::erase_if(kept.values, [&](const auto& v) { return v.first != "value" && v.first != "A" && v.first != "B" &&
                                                               !requests[i].extras.count(v.first); });
      values.push_back({{"id", (*work)[i].id}, {"value", valueJson(kept)}});
    } else {
      missing.push_back(warning(fmt::format("{}:{}", file, (*work)[i].line), fmt::format("'{}' is not evaluated: {}", (*work)[i].id, results[i].fault),
                                results[i].hint));
    }
  }
  const std::string text = values.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  if (!output.empty()) {
    if (const Diagnostics problems = writeFileAtomic(output, text); !problems.empty()) return badInput(problems);
  }
  if (output.empty() || arguments.json) fmt::print("{}", text);
  else if (!arguments.quiet) fmt::print("{}\n", output);
  if (missing.size() > kMostReported) {
    const size_t more = missing.size() - kMostReported;
    missing.resize(kMostReported);
    missing.push_back(warning(file, fmt::format("{} more are not evaluated", more), "the first are named above"));
  }
  log::report(missing);
  return missing.empty() ? kDone : kVerdictNo;
}

}  // namespace

extern const Command kEvalCommand;
const Command kEvalCommand = {
    .name = "eval",
    .summary = "Evaluate terms, models and integrals from the GLSL that draws; exit 1 when an entry cannot be",
    .options = {{.name = "work", .argument = "WORK.json", .help = "a list of {\"id\", \"term\", \"args\"}, or a table with such \"entries\"", .required = true},
                {.name = "-o,--output", .argument = "OUT.json", .help = "write the list of {\"id\", \"value\"} there; standard output without it"}},
    .examples = {"glint eval work.json -o values.json", "glint eval terms.public.json -o values.json"},
    .run = run,
};

}  // namespace glint
