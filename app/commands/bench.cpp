// glint bench: measured times that others can compare.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/bench/cases.h"
#include "app/command.h"
#include "materials/base/log.h"

namespace glint {
namespace {

// "frame.dir" for itself, "frame" for all of its group.
bool wanted(const std::string& name, const std::vector<std::string>& words) {
  return words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
           return name == word || name.starts_with(word + ".");
         });
}

int list(const Arguments& arguments, const std::vector<BenchCase>& cases) {
  if (arguments.json) {
    nlohmann::ordered_json document = nlohmann::ordered_json::array();
    for (const BenchCase& c : cases) document.push_back({{"name", c.name}, {"doc", c.doc}});
    fmt::print("{}\n", document.dump(2));
    return kDone;
  }
  for (const BenchCase& c : cases) fmt::print("{:<20} {}\n", c.name, c.doc);
  return kDone;
}

int run(const Arguments& arguments) {
  Libraries libraries(arguments.modelFolders);
  const std::vector<BenchCase> all = benchCases(libraries.models);
  if (arguments.has("list")) return list(arguments, all);
  const std::vector<std::string> words = arguments.all("cases");
  Diagnostics problems;
  for (const std::string& word : words) {
    if (std::any_of(all.begin(), all.end(), [&](const BenchCase& c) { return wanted(c.name, {word}); })) continue;
    std::vector<std::string> names;
    for (const BenchCase& c : all) names.push_back(c.name);
    problems.push_back(error(word, "no such case", suggestion(word, names)));
  }
  if (!problems.empty()) return badInput(problems);

  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  if (arguments.has("first-frame")) {
    problems = drawFirstFrame(**context, libraries);
    if (!problems.empty()) return badInput(problems);
    // The one byte that the parent waits for (app/bench/startup_cases.cpp).
    return ::write(STDOUT_FILENO, "\n", 1) == 1 ? kDone : kBadInput;
  }

  const bool quick = arguments.has("quick");
  const Effort effort = quick ? Effort{1, 1, 1, 0} : Effort{};
  BenchSetup setup(**context, libraries, effort, quick);
  const gl::Context::Info& info = (*context)->info();
  nlohmann::ordered_json document;
  document["glint"] = GLINT_VERSION;
  document["renderer"] = info.renderer;
  document["version"] = info.version;
  document["quick"] = quick;
  document["unit"] = "ms";
  document["cases"] = nlohmann::ordered_json::array();
  if (!arguments.json) {
    fmt::print("{} ({}), milliseconds\n", info.renderer, info.version);
    fmt::print("{:<20} {:>9} {:>9} {:>9} {:>4}\n", "case", "median", "min", "max", "n");
    std::fflush(stdout);
  }
  for (const BenchCase& c : all) {
    if (!wanted(c.name, words)) continue;
    const auto result = c.run(setup);
    if (!result) {
      // What was printed stays; with --json nothing was.
      return badInput(result.diagnostics());
    }
    if (arguments.json) {
      document["cases"].push_back({{"name", result->name}, {"median", result->median}, {"min", result->minimum},
                                   {"max", result->maximum}, {"n", result->count}, {"note", result->note}});
    } else {
      fmt::print("{:<20} {:>9.2f} {:>9.2f} {:>9.2f} {:>4}  {}\n", result->name, result->median, result->minimum, result->maximum, result->count, result->note);
      std::fflush(stdout);
    }
  }
  if (arguments.json) fmt::print("{}\n", document.dump(2));
  return kDone;
}

}  // namespace

extern const Command kBenchCommand;
const Command kBenchCommand = {
    .name = "bench",
    .summary = "Measure: frames, models, environments, materials, verdicts, start-up",
    .options = {{"cases", "CASE", "names or groups (frame, model, env, graph, edit, verify, eval, startup); all when none is given", true},
                {"--quick", "", "one run of each: whether it works, not how fast"},
                {"--list", "", "only name the cases"},
                {"--first-frame", "", "only draw the first frame of the start-up case and write a line break"}},
    .examples = {"glint bench", "glint bench frame model --json", "glint bench frame.p128 --backend osmesa", "glint bench --list"},
    .run = run,
};

}  // namespace glint
