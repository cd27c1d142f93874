// The numbers of a plot: series of D, V, F, f and albedos of several models, computed on the device from the GLSL that
// draws. No drawing; see plot_layout.h.
#pragma once

#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/analysis/plot_settings.h"
#include "materials/model_registry.h"
#include "renderer/image.h"
#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"

namespace glint {

// One model as it is plotted.
struct PlotSubject {
  ModelPtr model;
  std::vector<std::pair<std::string, Value>> parameters;  // where they are not the model's own defaults
  std::string title;                                      // in the legend
};

// Two axes' values in order of x. Angles are degrees; a value that is not finite is a gap.
struct PlotCurve {
  size_t subject = 0;
  size_t variant = 0;                // which of PlotData::variants
  std::vector<double> x, y;
};

// f over theta_h (0..90 degrees, left to right) and theta_d (0..90, bottom to top), at the centres of pixels.
struct PlotSlice {
  size_t subject = 0;
  ImageF f;                          // three channels; not finite where f is not
};

struct PlotData {
  PlotSettings settings;
  std::vector<std::string> titles;                    // of the subjects
  std::vector<std::array<float, 3>> colors;           // that the models ask for
  std::vector<std::string> variants;                  // what tells curves of one subject apart: "45\u00b0", "r"; one empty when nothing
  std::vector<PlotCurve> curves;
  std::vector<PlotSlice> slices;
  glm::vec3 F0{0}, diffuseColor{0};                   // of the surface
  std::optional<double> top;                          // of the value's axis, where a curve beyond it would flatten all others
  std::vector<std::string> notes;                     // what is left out, and why
  Diagnostics problems;                               // models that do not compile: their curves are missing
};

// Compiles a model when it is first asked for and keeps it; needs a current context, always the same.
class PlotComputer {
 public:
  // Effort: how finely what is dear is computed (albedos and slices); 1 for a picture, less while a slider moves.
  // `stop` is asked between models: once it says true the work is given up and nothing comes back.
  std::optional<PlotData> compute(const PlotSettings&, const std::vector<PlotSubject>&, double effort = 1,
                                  const std::function<bool()>& stop = {});

 private:
  struct Compiled {
    std::optional<ModelProbe> probe;
    std::optional<ModelIntegrals> integrals;
    Diagnostics problems;
    uint64_t used = 0;
  };
  // What a model is compiled with.
  struct Making {
    bool compensate = false, specularOnly = false, coarse = false;
    auto operator<=>(const Making&) const = default;
  };
  Compiled& compiled(const ShadingModel&, bool integrals, const Making&);
  void resolveColors(PlotData&);
  std::map<std::tuple<std::string, uint64_t, Making>, Compiled> models_;
  std::optional<ModelProbe> colors_;
  uint64_t clock_ = 0;
};

// Whether a parameter of the model is the roughness that a plot asks for, as that of a .brdf file may be.
bool isPlotRoughness(const ShadingModel&, const ModelParameter&);

// The luminance of a linear colour, Rec.709; or one of its channels.
double channelValue(const glm::dvec3&, PlotChannel);

}  // namespace glint
