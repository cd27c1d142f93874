// What is plotted of shading models, and the words for it on the command line: "lobe:roughness=0.3,angle=30/60,log=1".
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "materials/base/diagnostic.h"

namespace glint {

enum class PlotKind { D, G, V, F, Lobe, Polar, Albedo, Slice };
enum class PlotChannel { Luminance, Red, Green, Blue, Rgb };
enum class PlotPart { Specular, Diffuse, Sum };
enum class PlotGround { Light, Dark };

// The surface under the model: attributes as a material has them. Angles are degrees.
struct PlotSettings {
  PlotKind kind = PlotKind::Lobe;
  PlotChannel channel = PlotChannel::Luminance;
  std::vector<PlotPart> parts{PlotPart::Specular};  // one alone for a slice
  std::vector<float> roughness{0.5f};
  std::vector<float> angles{45};     // of the view from the normal (of the light, for G and V), 0..90
  float phi = 0;                     // from the tangent to the plane of incidence; of a slice, phi_d
  float out = 0;                     // from the plane of incidence to the plane of the lights of a lobe
  glm::vec3 baseColor{0.8f};
  float metallic = 0, specular = 0.5f;
  std::optional<glm::vec3> F0;       // instead of what follows from the three
  bool white = false;                // F0 and the diffuse colour are 1: a furnace
  bool compensate = false;           // with the lobe of multiple scattering
  bool overRoughness = false;        // an albedo's axis, instead of the view's angle
  bool log = false, cosine = false;  // the value's axis; f times the light's cosine
  std::optional<float> most;         // the value's axis ends here
  PlotGround ground = PlotGround::Light;
  bool operator==(const PlotSettings&) const = default;
};

inline constexpr int kMostPlotCurves = 96;

std::string_view name(PlotKind);
std::string_view name(PlotPart);
std::string_view title(PlotKind);          // short: "D: distribution"
std::string_view name(PlotChannel);
std::span<const std::string_view> plotKindNames();   // in the order of PlotKind
std::span<const std::string_view> plotChannelNames();

// Settings that mean something to a kind. The editor shows no others, the command line refuses them.
struct PlotKey {
  std::string_view name, doc;
};
bool takes(PlotKind, std::string_view key);
std::vector<PlotKey> plotKeys();     // of all kinds

// What the plot of a kind is when nothing else is said: an albedo is that of a furnace.
PlotSettings standardPlot(PlotKind);

// "KIND" or "KIND:key=value,..", the kind in lower or upper case. Every fault, with `place` as its place; an unknown kind
// or key names its neighbours, and a key that means nothing to the kind says where it does. `attributes` (see
// setAttribute) hold where no key says otherwise.
Result<PlotSettings> parsePlot(const std::string& text, const std::string& place,
                               std::span<const std::pair<std::string, glm::vec3>> attributes = {});

// An attribute of `--set`: baseColor, metallic, specular or roughness, whose value has been checked. False for others,
// which no BRDF sees. A colour given this way ends a furnace.
bool setAttribute(PlotSettings&, std::string_view attribute, const glm::vec3& value);

// Whether the keys' combination is sound: how many curves it makes, and what excludes what. `place` as above.
Diagnostics checkPlot(const PlotSettings&, size_t models, const std::string& place);

}  // namespace glint
