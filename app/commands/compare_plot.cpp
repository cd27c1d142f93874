#include "app/commands/compare_plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/analysis/plot_layout.h"
#include "app/analysis/plot_picture.h"
#include "app/analysis/plot_svg.h"
#include "app/picture_file.h"
#include "app/scene_loader.h"
#include "materials/attributes.h"
#include "materials/base/files.h"
#include "materials/base/hash.h"
#include "materials/base/log.h"
#include "materials/base/utf8.h"
#include "materials/graph_compile.h"

namespace glint {
namespace {

using nlohmann::ordered_json;

constexpr glm::ivec2 kSize{900, 600}, kLeast{240, 180};

struct Plan {
  std::vector<PlotSubject> subjects;
  PlotSettings settings;
  glm::ivec2 size = kSize;
  std::filesystem::path output;
  bool svg = false;
};

// What spheres have and curves have not.
void refuseOthers(const Arguments& arguments, Diagnostics& problems) {
  static const std::vector<std::string> kTaken = {"models", "output", "plot", "set", "size"};
  for (const auto& [option, values] : arguments.values) {
    if (std::find(kTaken.begin(), kTaken.end(), option) != kTaken.end()) continue;
    std::string hint = "with --plot there are --models, --set, --size and -o";
    if (option == "sweep") hint = "give several values in the plot: roughness=0.1/0.3/0.9";
    if (option == "against") hint = "name both under --models";
    if (option == "background") hint = "a plot has ground=light or ground=dark";
    problems.push_back(error("--" + option, "is for rows of spheres, not for a plot", hint));
  }
}

// The model's parameters as they are given, checked; into the subject.
void setParameters(PlotSubject& subject, const std::vector<Setting>& settings, Diagnostics& problems) {
  std::string described;
  for (const Setting& setting : settings) {
    Diagnostic fault = error("--models", "", "");
    const ModelParameter* parameter = subject.model->parameter(setting.name);
    const auto value = overrideValue(*subject.model, setting.name, setting.text);
    if (!parameter && findAttribute(setting.name)) {
      fault = error("--models", fmt::format("'{}' is an attribute of the material, not a parameter of '{}'", setting.name, subject.model->id),
                    fmt::format("--set {}={} gives it to all models", setting.name, setting.text));
    } else if (!value) {
      fault = value.diagnostics()[0];
      if (fault.what.starts_with("is neither")) fault.what = fmt::format("model '{}' has no parameter '{}'", subject.model->id, setting.name);
      fault.place = "--models";
    } else {
      subject.parameters.emplace_back(parameter->name, *value);
      described += fmt::format(", {} {}", setting.name, setting.text);
      continue;
    }
    problems.push_back(std::move(fault));
  }
  subject.title += described;
}

// --set: parameters for the models that have them, attributes for all others. A roughness of a model's own is the plot's,
// which may have several.
std::vector<std::pair<std::string, glm::vec3>> applySettings(const std::vector<Setting>& settings, std::vector<PlotSubject>& subjects, Diagnostics& problems) {
  std::vector<std::pair<std::string, glm::vec3>> attributes;
  for (const Setting& setting : settings) {
    const bool attribute = findAttribute(setting.name) != nullptr;
    PlotSettings trial;
    const bool owned = std::any_of(subjects.begin(), subjects.end(), [&](const PlotSubject& s) { return s.model->parameter(setting.name); });
    if (attribute && !owned && !setAttribute(trial, setting.name, glm::vec3(0))) {
      problems.push_back(error("--set", fmt::format("no plot depends on '{}'", setting.name), "baseColor, metallic, specular and roughness are seen by models"));
      continue;
    }
    bool taken = false, forAll = false;
    for (PlotSubject& subject : subjects) {
      const ModelParameter* parameter = subject.model->parameter(setting.name);
      if (!attribute && !parameter) continue;
      taken = true;
      const auto value = overrideValue(*subject.model, setting.name, setting.text);
      if (!value) {
        Diagnostic fault = value.diagnostics()[0];
        fault.place = "--set";
        if (std::find(problems.begin(), problems.end(), fault) == problems.end()) problems.push_back(std::move(fault));
        continue;
      }
      const bool ofPlot = attribute && (!parameter || isPlotRoughness(*subject.model, *parameter));
      if (ofPlot && !std::exchange(forAll, true)) attributes.emplace_back(setting.name, glm::vec3(value->v[0], value->v[1], value->v[2]));
      if (!ofPlot) subject.parameters.emplace_back(parameter->name, *value);
    }
    if (taken || subjects.empty()) continue;
    std::vector<std::string> known{"baseColor", "metallic", "specular", "roughness"};
    for (const PlotSubject& subject : subjects)
      for (const ModelParameter& p : subject.model->parameters) known.push_back(p.name);
    problems.push_back(error("--set", fmt::format("no model here has '{}'", setting.name), suggestion(setting.name, known)));
  }
  return attributes;
}

Result<Plan> parsePlan(const Arguments& arguments, const Result<std::vector<ModelChoice>>& models, const Libraries& libraries) {
  Plan plan;
  Diagnostics problems;
  refuseOthers(arguments, problems);
  const auto scene = parseSceneOptions(arguments);
  if (!models) problems.insert(problems.end(), models.diagnostics().begin(), models.diagnostics().end());
  else
    for (const ModelChoice& choice : *models) {
      PlotSubject subject;
      if (!keep(problems, libraries.namedModel(choice.id, "--models"), subject.model)) continue;
      subject.title = subject.model->title;
      setParameters(subject, choice.parameters, problems);
      plan.subjects.push_back(std::move(subject));
    }
  for (size_t i = 0; i < plan.subjects.size(); ++i)
    for (size_t k = 0; k < i; ++k)
      if (plan.subjects[i].title == plan.subjects[k].title) plan.subjects[i].title += " (" + plan.subjects[i].model->id + ")";
  std::vector<std::pair<std::string, glm::vec3>> attributes;
  if (scene) attributes = applySettings(scene->settings, plan.subjects, problems);
  else
    for (const Diagnostic& d : scene.diagnostics())
      if (d.place == "--set" || d.place == "--size") problems.push_back(d);
  if (keep(problems, parsePlot(arguments.get("plot"), "--plot", attributes), plan.settings)) {
    const Diagnostics unsound = checkPlot(plan.settings, plan.subjects.size(), "--plot");
    problems.insert(problems.end(), unsound.begin(), unsound.end());
  }
  if (arguments.has("size") && keep(problems, parseSize(arguments.get("size"), "--size"), plan.size) &&
      (plan.size.x < kLeast.x || plan.size.y < kLeast.y))
    problems.push_back(error("--size", fmt::format("{}x{} is too small for a plot", plan.size.x, plan.size.y), fmt::format("at least {}x{}", kLeast.x, kLeast.y)));
  plan.output = arguments.get("output");
  const Diagnostics place = checkOutput(plan.output, "--output", "plot that Glint writes", {".png", ".svg"});
  problems.insert(problems.end(), place.begin(), place.end());
  plan.svg = pictureKind(plan.output) != PictureKind::Display;
  Diagnostics once;
  for (Diagnostic& d : problems)
    if (std::find(once.begin(), once.end(), d) == once.end()) once.push_back(std::move(d));
  if (!once.empty()) return once;
  return plan;
}

ImageNotes notesOf(const Arguments& arguments, const gl::Context& context, const Plan& plan) {
  ImageNotes notes = pictureNotes(arguments, context, {});
  std::vector<std::string> lines;
  for (const PlotSubject& subject : plan.subjects) lines.push_back(hashName(subject.model->hash) + " " + onOneLine(subject.model->id));
  notes["Models"] = fmt::format("{}", fmt::join(lines, "\n"));
  return notes;
}

ordered_json numbers(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double v : values) list.push_back(std::isfinite(v) ? ordered_json(v) : ordered_json());
  return list;
}

ordered_json documentOf(const Plan& plan, const PlotData& data) {
  ordered_json document{{"file", plan.output.string()},
                        {"plot", name(plan.settings.kind)},
                        {"width", plan.size.x},
                        {"height", plan.size.y},
                        {"x", withoutMarks(xTitle(plan.settings))},
                        {"y", withoutMarks(yTitle(plan.settings))},
                        {"conditions", withoutMarks(plotConditions(data))}};
  const auto started = [&](size_t subject) {
    return ordered_json{{"model", plan.subjects[subject].model->id}, {"title", data.titles[subject]}};
  };
  if (plan.settings.kind == PlotKind::Slice) {
    // Rows as in the picture: theta_d falls from 90 degrees downwards.
    for (const PlotSlice& slice : data.slices) {
      ordered_json entry = started(slice.subject), rows = ordered_json::array();
      for (int y = 0; y < slice.f.height; ++y) {
        ordered_json row = ordered_json::array();
        for (int x = 0; x < slice.f.width; ++x) {
          const float* f = slice.f.at(x, y);
          if (plan.settings.channel == PlotChannel::Rgb) row.push_back(numbers({f[0], f[1], f[2]}));
          else row.push_back(numbers({channelValue({f[0], f[1], f[2]}, plan.settings.channel)})[0]);
        }
        rows.push_back(std::move(row));
      }
      entry["rows"] = std::move(rows);
      document["slices"].push_back(std::move(entry));
    }
  } else {
    document["curves"] = ordered_json::array();
    for (const PlotCurve& curve : data.curves) {
      ordered_json entry = started(curve.subject);
      if (!data.variants[curve.variant].empty()) entry["variant"] = data.variants[curve.variant];
      entry["x"] = numbers(curve.x);
      entry["y"] = numbers(curve.y);
      document["curves"].push_back(std::move(entry));
    }
  }
  if (!data.notes.empty()) document["notes"] = data.notes;
  return document;
}

}  // namespace

int plotComparison(const Arguments& arguments, const Result<std::vector<ModelChoice>>& models) {
  const Libraries libraries(arguments.modelFolders);
  log::report(libraries.models.warnings());
  const auto plan = parsePlan(arguments, models, libraries);
  if (!plan) return badInput(plan.diagnostics());
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  PlotComputer computer;
  const PlotData data = *computer.compute(plan->settings, plan->subjects);
  if (!data.problems.empty()) return badInput(data.problems);
  const PlotDrawing drawing = layOutPlot(data, {.size = plan->size, .unit = plotUnit(plan->size)}, pictureTextMeasure());
  const ImageNotes notes = notesOf(arguments, **context, *plan);
  Diagnostics faults;
  if (plan->svg) {
    const auto svg = plotSvg(drawing, notes);
    if (!svg) return badInput(svg.diagnostics());
    faults = writeFileAtomic(plan->output, *svg);
  } else {
    faults = writeImage8(plan->output, plotPicture(drawing), notes);
  }
  if (!faults.empty()) return badInput(faults);
  for (const std::string& note : data.notes) log::report(warning(plan->output.string(), note));
  if (arguments.json) fmt::print("{}\n", documentOf(*plan, data).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  else if (!arguments.quiet) fmt::print("{}\n", plan->output.string());
  return kDone;
}

}  // namespace glint
