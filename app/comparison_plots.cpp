#include "app/comparison_plots.h"

#include <algorithm>

#include "app/analysis/plot_layout.h"
#include "app/analysis/plot_picture.h"
#include "app/analysis/plot_svg.h"
#include "materials/graph_compile.h"

namespace glint {
namespace {

std::vector<PlotSubject> subjectsOf(std::span<const ComparisonRow> rows) {
  std::vector<PlotSubject> subjects;
  for (const ComparisonRow& row : rows) {
    PlotSubject subject{row.model, {}, row.model->title};
    for (const Setting& setting : row.settings) {
      // Attributes are the surface's: they differ from column to column.
      if (!row.model->parameter(setting.name)) continue;
      if (const auto value = overrideValue(*row.model, setting.name, setting.text)) {
        subject.parameters.emplace_back(row.model->parameter(setting.name)->name, *value);
        subject.title += ", " + setting.name + " " + setting.text;
      }
    }
    const auto same = [&](const PlotSubject& s) { return s.model == subject.model && s.title == subject.title; };
    if (std::none_of(subjects.begin(), subjects.end(), same)) subjects.push_back(std::move(subject));
  }
  return subjects;
}

}  // namespace

Result<std::vector<std::string>> comparisonPlots(std::span<const ComparisonRow> rows) {
  const std::vector<PlotSubject> subjects = subjectsOf(rows);
  const auto some = [&](bool (ShadingModel::*has)() const) {
    return std::any_of(subjects.begin(), subjects.end(), [&](const PlotSubject& s) { return ((*s.model).*has)(); });
  };
  std::vector<PlotKind> kinds;
  if (some(&ShadingModel::hasD)) kinds.push_back(PlotKind::D);
  if (some(&ShadingModel::hasV)) kinds.push_back(PlotKind::V);
  if (some(&ShadingModel::hasF)) kinds.push_back(PlotKind::F);
  kinds.insert(kinds.end(), {PlotKind::Lobe, PlotKind::Albedo});
  constexpr glm::ivec2 kSize{600, 400};
  PlotComputer computer;
  std::vector<std::string> plots;
  for (const PlotKind kind : kinds) {
    PlotSettings settings = standardPlot(kind);
    settings.ground = PlotGround::Dark;
    if (checkPlot(settings, subjects.size(), "--report").size()) continue;  // more curves than one plot can show
    const PlotData data = *computer.compute(settings, subjects);
    if (!data.problems.empty()) return data.problems;
    const auto svg = plotSvg(layOutPlot(data, {.size = kSize, .unit = 0.9f}, pictureTextMeasure()), {});
    if (!svg) return svg.diagnostics();
    plots.push_back(svg->substr(svg->find("<svg")));
  }
  return plots;
}

}  // namespace glint
