#include "app/analysis/plot_settings.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>

#include "app/option_values.h"
#include "materials/attributes.h"

namespace glint {
namespace {

constexpr std::string_view kKinds[] = {"d", "g", "v", "f", "lobe", "polar", "albedo", "slice"};
constexpr std::string_view kTitles[] = {"D: distribution", "G: masking", "V: visibility", "F: Fresnel", "Lobe", "Lobe, polar", "Albedo", "Slice"};
constexpr std::string_view kChannels[] = {"luminance", "r", "g", "b", "rgb"};
constexpr std::string_view kParts[] = {"specular", "diffuse", "sum"};
constexpr std::string_view kGrounds[] = {"light", "dark"};
constexpr std::string_view kAxes[] = {"angle", "roughness"};

constexpr unsigned bit(PlotKind kind) { return 1u << static_cast<unsigned>(kind); }
constexpr unsigned kAll = 0xff;
constexpr unsigned kOfColor = bit(PlotKind::F) | bit(PlotKind::Lobe) | bit(PlotKind::Polar) | bit(PlotKind::Albedo) | bit(PlotKind::Slice);
constexpr unsigned kLobes = bit(PlotKind::Lobe) | bit(PlotKind::Polar);

template <size_t N>
Result<size_t> parseWord(const std::string& text, const std::string_view (&words)[N], const char* what, const std::string& place) {
  const auto found = std::find(std::begin(words), std::end(words), text);
  if (found == std::end(words))
    return error(place, fmt::format("unknown {} '{}'", what, text), suggestion(text, {std::begin(words), std::end(words)}));
  return static_cast<size_t>(found - std::begin(words));
}

Result<std::vector<float>> parseNumbers(const std::string& text, float low, float high, const std::string& place) {
  std::vector<float> numbers;
  Diagnostics problems;
  for (const std::string& part : splitText(text, '/')) {
    float number = 0;
    if (keep(problems, parseNumber(part, low, high, place), number) && std::find(numbers.begin(), numbers.end(), number) == numbers.end())
      numbers.push_back(number);
  }
  if (!problems.empty()) return problems;
  return numbers;
}

using Apply = std::function<void(PlotSettings&, const std::string& value, const std::string& place, Diagnostics&)>;

struct KeyInfo {
  PlotKey key;
  unsigned kinds;
  Apply apply;
};

Apply number(float PlotSettings::*member, float low, float high) {
  return [=](PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& p) { keep(p, parseNumber(v, low, high, place), s.*member); };
}
Apply numbers(std::vector<float> PlotSettings::*member, float low, float high) {
  return [=](PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& p) { keep(p, parseNumbers(v, low, high, place), s.*member); };
}
Apply flag(bool PlotSettings::*member) {
  return [=](PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& p) {
    int on = 0;
    if (keep(p, parseWhole(v, 0, 1, place), on)) s.*member = on != 0;
  };
}
Apply attribute(const char* name) {
  return [=](PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& p) {
    const Attribute* found = findAttribute(name);
    glm::vec3 value{0};
    if (found->standard.type == ValueType::Color) {
      if (!keep(p, parseColor(v, place), value)) return;
      if (std::max({value.r, value.g, value.b}) > found->most)
        return p.push_back(error(place, fmt::format("{} {} is out of range", name, v), fmt::format("0 to {:g} are allowed", found->most)));
    } else if (!keep(p, parseNumber(v, found->minimum, found->most, place), value.x)) {
      return;
    }
    setAttribute(s, name, value);
  };
}

void channelKey(PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& problems) {
  size_t index = 0;
  if (keep(problems, parseWord(v, kChannels, "channel", place), index)) s.channel = static_cast<PlotChannel>(index);
}
void partKey(PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& problems) {
  std::vector<PlotPart> parts;
  for (const std::string& word : splitText(v, '/')) {
    size_t index = 0;
    if (!keep(problems, parseWord(word, kParts, "part", place), index)) continue;
    if (std::find(parts.begin(), parts.end(), static_cast<PlotPart>(index)) == parts.end()) parts.push_back(static_cast<PlotPart>(index));
  }
  if (!parts.empty()) s.parts = parts;
}
void overKey(PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& problems) {
  size_t index = 0;
  if (keep(problems, parseWord(v, kAxes, "axis", place), index)) s.overRoughness = index == 1;
}
void groundKey(PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& problems) {
  size_t index = 0;
  if (keep(problems, parseWord(v, kGrounds, "ground", place), index)) s.ground = static_cast<PlotGround>(index);
}
void f0Key(PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& problems) {
  glm::vec3 value{0};
  if (!keep(problems, parseColor(v, place), value)) return;
  if (std::max({value.r, value.g, value.b}) > 1) return problems.push_back(error(place, fmt::format("F0 {} is out of range", v), "0 to 1 are allowed"));
  s.F0 = value;
  s.white = false;
}
void mostKey(PlotSettings& s, const std::string& v, const std::string& place, Diagnostics& problems) {
  float value = 0;
  if (keep(problems, parseNumber(v, 1e-6f, 1e9f, place), value)) s.most = value;
}

const std::vector<KeyInfo>& keyTable() {
  static const std::vector<KeyInfo> table = {
      {{"roughness", "0..1, several by /"}, kAll & ~bit(PlotKind::F), numbers(&PlotSettings::roughness, 0, 1)},
      {{"angle", "of the view from the normal, 0..90 degrees, several by /; of the light for g and v"},
       kLobes | bit(PlotKind::G) | bit(PlotKind::V) | bit(PlotKind::Albedo), numbers(&PlotSettings::angles, 0, 90)},
      {{"phi", "degrees from the tangent to the plane of incidence; of a slice, phi_d"}, kAll & ~bit(PlotKind::Albedo), number(&PlotSettings::phi, -360, 360)},
      {{"out", "degrees that the plane of the lights is turned out of the plane of incidence"}, kLobes, number(&PlotSettings::out, -180, 180)},
      {{"channel", "luminance, r, g, b or rgb"}, kOfColor, channelKey},
      {{"part", "specular, diffuse or sum, several by /"}, kOfColor & ~bit(PlotKind::F), partKey},
      {{"cosine", "1: f times the cosine of the light"}, kLobes | bit(PlotKind::Slice), flag(&PlotSettings::cosine)},
      {{"compensate", "1: with multiple scattering"}, kOfColor & ~bit(PlotKind::F), flag(&PlotSettings::compensate)},
      {{"over", "angle or roughness: the axis"}, bit(PlotKind::Albedo), overKey},
      {{"log", "1: the value's axis is logarithmic, as a slice is"}, kAll, flag(&PlotSettings::log)},
      {{"max", "where the value's axis ends"}, kAll, mostKey},
      {{"baseColor", "r/g/b"}, kOfColor, attribute("baseColor")},
      {{"metallic", "0..1"}, kOfColor, attribute("metallic")},
      {{"specular", "0..1"}, kOfColor, attribute("specular")},
      {{"F0", "instead of what follows from the three"}, kOfColor, f0Key},
      {{"ground", "light or dark"}, kAll, groundKey},
  };
  return table;
}

// "lobe, polar and albedo"
std::string kindsOf(unsigned kinds) {
  std::vector<std::string_view> names;
  for (size_t i = 0; i < std::size(kKinds); ++i)
    if (kinds >> i & 1) names.push_back(kKinds[i]);
  if (names.size() == 1) return std::string(names[0]);
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

}  // namespace

std::string_view name(PlotKind kind) { return kKinds[static_cast<size_t>(kind)]; }
std::string_view title(PlotKind kind) { return kTitles[static_cast<size_t>(kind)]; }
std::string_view name(PlotPart part) { return kParts[static_cast<size_t>(part)]; }
std::string_view name(PlotChannel channel) { return kChannels[static_cast<size_t>(channel)]; }
std::span<const std::string_view> plotKindNames() { return kKinds; }
std::span<const std::string_view> plotChannelNames() { return kChannels; }

bool takes(PlotKind kind, std::string_view key) {
  return std::any_of(keyTable().begin(), keyTable().end(), [&](const KeyInfo& info) { return info.key.name == key && info.kinds & bit(kind); });
}

std::vector<PlotKey> plotKeys() {
  std::vector<PlotKey> keys;
  for (const KeyInfo& info : keyTable()) keys.push_back(info.key);
  return keys;
}

PlotSettings standardPlot(PlotKind kind) {
  PlotSettings settings;
  settings.kind = kind;
  for (const char* name : {"baseColor", "metallic", "specular", "roughness"}) {
    const auto& v = findAttribute(name)->standard.v;
    setAttribute(settings, name, {v[0], v[1], v[2]});
  }
  if (kind == PlotKind::G || kind == PlotKind::V) settings.angles = {0};
  if (kind == PlotKind::Slice) {
    settings.phi = 90;
    settings.log = true;   // peaks would leave the rest black
  }
  if (kind == PlotKind::Albedo) settings.white = true;
  return settings;
}

bool setAttribute(PlotSettings& settings, std::string_view name, const glm::vec3& value) {
  if (name == "roughness") {
    settings.roughness = {value.x};
    return true;
  }
  if (name == "baseColor") settings.baseColor = value;
  else if (name == "metallic") settings.metallic = value.x;
  else if (name == "specular") settings.specular = value.x;
  else return false;
  settings.white = false;
  return true;
}

Result<PlotSettings> parsePlot(const std::string& text, const std::string& place,
                               std::span<const std::pair<std::string, glm::vec3>> attributes) {
  const size_t colon = text.find(':');
  std::string word = text.substr(0, colon);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto kind = parseWord(word, kKinds, "plot", place);
  if (!kind) {
    Diagnostics problems = kind.diagnostics();
    problems[0].what = fmt::format("unknown plot '{}'", text.substr(0, colon));
    return problems;
  }
  PlotSettings settings = standardPlot(static_cast<PlotKind>(*kind));
  for (const auto& [attribute, value] : attributes) setAttribute(settings, attribute, value);
  if (colon == std::string::npos) return settings;
  std::vector<std::string> known;
  for (const KeyInfo& info : keyTable()) known.emplace_back(info.key.name);
  const auto keys = parseKeys(text.substr(colon + 1), place, known);
  if (!keys) return keys.diagnostics();
  Diagnostics problems;
  for (const KeyValue& given : *keys) {
    const KeyInfo& info = *std::find_if(keyTable().begin(), keyTable().end(), [&](const KeyInfo& k) { return k.key.name == given.key; });
    if (info.kinds & bit(settings.kind)) info.apply(settings, given.value, fmt::format("{} {}", place, given.key), problems);
    else problems.push_back(error(place, fmt::format("'{}' means nothing to the plot '{}'", given.key, word), "it is for " + kindsOf(info.kinds)));
  }
  if (!problems.empty()) return problems;
  return settings;
}

Diagnostics checkPlot(const PlotSettings& s, size_t models, const std::string& place) {
  Diagnostics problems;
  if (s.kind == PlotKind::Slice) {
    if (s.parts.size() > 1) problems.push_back(error(place, fmt::format("a slice shows one part, not {}", s.parts.size()), "give one of specular, diffuse and sum"));
    if (s.roughness.size() > 1) problems.push_back(error(place, fmt::format("a slice has one roughness, not {}", s.roughness.size()), "give one"));
    if (models > 12) problems.push_back(error(place, fmt::format("{} slices", models), "at most 12 models are drawn"));
    return problems;
  }
  if (s.kind == PlotKind::Albedo && s.overRoughness && s.roughness.size() > 1)
    problems.push_back(error(place, "roughness is the axis already", "leave it out"));
  if (s.kind == PlotKind::Albedo && !s.overRoughness && s.angles.size() > 1)
    problems.push_back(error(place, "the angle is the axis already", "leave it out, or write over=roughness"));
  size_t curves = models;
  const bool colors = takes(s.kind, "channel");
  if (takes(s.kind, "angle") && (s.kind != PlotKind::Albedo || s.overRoughness)) curves *= s.angles.size();
  if (takes(s.kind, "roughness") && !(s.kind == PlotKind::Albedo && s.overRoughness)) curves *= s.roughness.size();
  if (takes(s.kind, "part")) curves *= s.parts.size();
  if (colors && s.channel == PlotChannel::Rgb) curves *= 3;
  if (curves > kMostPlotCurves)
    problems.push_back(error(place, fmt::format("{} curves", curves), fmt::format("a plot has at most {}: name fewer models, angles or roughnesses", kMostPlotCurves)));
  return problems;
}

}  // namespace glint
