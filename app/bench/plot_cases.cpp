#include "app/analysis/plot_layout.h"
#include "app/analysis/plot_picture.h"
#include "app/bench/cases.h"

namespace glint {
namespace {

// What a slider of the analysis panel waits for: numbers on the device, brought back and laid out; the model is compiled.
BenchCase plotCase(const std::string& name, const std::string& doc, PlotKind kind) {
  return {name, doc, [=](BenchSetup& setup) -> Result<Measurement> {
            const auto model = plainModel(setup.libraries);
            if (!model) return model.diagnostics();
            const std::vector<PlotSubject> subjects{{*model, {}, (*model)->title}};
            PlotComputer computer;
            const TextMeasure texts = pictureTextMeasure();
            PlotSettings settings = standardPlot(kind);
            const auto once = [&] {
              settings.roughness[0] = settings.roughness[0] < 0.9f ? settings.roughness[0] + 0.01f : 0.1f;
              const auto data = computer.compute(settings, subjects);
              (void)layOutPlot(*data, {}, texts);
              return data->problems;
            };
            if (const Diagnostics problems = once(); !problems.empty()) return problems;
            return measure(name, setup.effort, [&] { once(); });
          }};
}

}  // namespace

std::vector<BenchCase> plotCases() {
  return {plotCase("plot.lobe", "the lobe of one model after a slider moved", PlotKind::Lobe),
          plotCase("plot.albedo", "the directional albedo of one model over 60 angles", PlotKind::Albedo),
          plotCase("plot.slice", "the slice of one model, 256x256", PlotKind::Slice)};
}

}  // namespace glint
