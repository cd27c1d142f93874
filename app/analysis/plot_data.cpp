#include "app/analysis/plot_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/analysis/plot_axis.h"

namespace glint {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr size_t kMostCompiled = 32;

glm::dvec3 direction(double degrees, double azimuth) {
  const double theta = degrees * kDegree, phi = azimuth * kDegree;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// Even steps of half a degree, and steps that shrink towards `center`, where lobes have their peaks: dense enough for
// every width of them.
std::vector<double> angleGrid(double low, double high, const std::vector<double>& centers) {
  constexpr double kStep = 0.5, kSmallest = 0.01, kReach = 40;
  constexpr int kNodes = 120;
  std::vector<double> grid;
  const int steps = static_cast<int>(std::lround((high - low) / kStep));
  for (int i = 0; i <= steps; ++i) grid.push_back(low + (high - low) * i / steps);
  for (const double center : centers)
    for (int i = 0; i <= kNodes; ++i) {
      const double offset = kSmallest * std::expm1(std::log1p(kReach / kSmallest) * i / kNodes);
      for (const double x : {center - offset, center + offset})
        if (x > low && x < high) grid.push_back(x);
    }
  std::sort(grid.begin(), grid.end());
  grid.erase(std::unique(grid.begin(), grid.end(), [](double a, double b) { return b - a < 1e-6; }), grid.end());
  return grid;
}

std::string degrees(float angle) { return fmt::format("{:g}\u00b0", angle); }

// What makes more than one curve of a model, and what each is called.
struct Variant {
  float roughness = 0, angle = 0;
  PlotPart part = PlotPart::Specular;
  PlotChannel channel = PlotChannel::Luminance;
  std::string title;
};

std::vector<Variant> variantsOf(const PlotSettings& s) {
  const bool albedo = s.kind == PlotKind::Albedo;
  const std::vector<float> one{0};
  const bool roughnesses = takes(s.kind, "roughness") && !(albedo && s.overRoughness);
  const bool angles = takes(s.kind, "angle") && !(albedo && !s.overRoughness);
  std::vector<PlotPart> parts{PlotPart::Specular};
  if (takes(s.kind, "part")) parts = s.parts;
  std::vector<PlotChannel> channels{s.channel};
  if (s.channel == PlotChannel::Rgb) channels = {PlotChannel::Red, PlotChannel::Green, PlotChannel::Blue};
  if (!takes(s.kind, "channel")) channels = {PlotChannel::Luminance};
  std::vector<Variant> variants;
  for (const float roughness : roughnesses ? s.roughness : one)
    for (const float angle : angles ? s.angles : one)
      for (const PlotPart part : parts)
        for (const PlotChannel channel : channels) {
          Variant v{roughness, angle, part, channel, {}};
          const auto add = [&](const std::string& text) { v.title += (v.title.empty() ? "" : ", ") + text; };
          if (roughnesses && s.roughness.size() > 1) add(fmt::format("roughness {:g}", roughness));
          if (angles && s.angles.size() > 1) add(degrees(angle));
          if (parts.size() > 1) add(std::string(name(part)));
          if (channels.size() > 1) add(std::string(name(channel)));
          variants.push_back(std::move(v));
        }
  return variants;
}

// The probe's outputs at a point (ModelProbe::ofModelParts).
struct Parts {
  glm::dvec3 specular, diffuse, F, scattered;
  double D, V;
  glm::dvec3 part(PlotPart p) const { return p == PlotPart::Specular ? specular : p == PlotPart::Diffuse ? diffuse : specular + diffuse; }
};

std::vector<Parts> evaluateParts(const ModelProbe& probe, const std::vector<ProbePoint>& points) {
  const std::vector<glm::vec4> out = probe.evaluate(points);
  std::vector<Parts> parts(points.size());
  for (size_t i = 0; i < parts.size(); ++i) {
    const glm::dvec4 a = out[4 * i], b = out[4 * i + 1], c = out[4 * i + 2];
    parts[i] = {glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), glm::dvec3(out[4 * i + 3]), a.w, b.w};
  }
  return parts;
}

// Light and view of each kind at one place of its axis.
struct Directions {
  glm::dvec3 light, view;
};
Directions directionsAt(const PlotSettings& s, float angle, double x) {
  switch (s.kind) {
    case PlotKind::D: {
      const glm::dvec3 h = direction(x, s.phi);
      return {h, h};
    }
    case PlotKind::F: return {direction(x, s.phi), direction(-x, s.phi)};
    // The light stands on the left, so that a view on the right meets the mirrored light.
    case PlotKind::G:
    case PlotKind::V: return {direction(-angle, s.phi), direction(x, s.phi)};
    default: return {direction(x, s.phi + s.out), direction(-angle, s.phi)};
  }
}

std::vector<double> gridOf(const PlotSettings& s, float angle) {
  switch (s.kind) {
    case PlotKind::D: return angleGrid(-90, 90, {0});
    case PlotKind::F: return angleGrid(0, 90, {});
    case PlotKind::G:
    case PlotKind::V: return angleGrid(-90, 90, {-90, 90});
    default: return angleGrid(-90, 90, {s.out == 0 ? static_cast<double>(angle) : 0.0});
  }
}

ProbePoint pointOf(const PlotData& data, float roughness, const Directions& d) {
  ProbePoint p;
  p.light = d.light;
  p.view = d.view;
  p.fromDirections = true;
  p.roughness = roughness;
  p.F0 = data.F0;
  p.diffuseColor = data.diffuseColor;
  p.baseColor = data.settings.white ? glm::vec3(1) : data.settings.baseColor;
  p.metallic = data.settings.metallic;
  p.specular = data.settings.specular;
  p.fromAttributes = !data.settings.white && !data.settings.F0;
  return p;
}

// Gives a model that has a roughness of its own, as a .brdf file may, that of the plot; empty for all others.
using OwnRoughness = std::function<void(float)>;

void addCurves(PlotData& data, const std::vector<Variant>& variants, size_t subject, const ModelProbe& probe, const OwnRoughness& ownRoughness) {
  const PlotSettings& s = data.settings;
  std::vector<ProbePoint> points;
  std::vector<std::vector<double>> grids;
  for (const Variant& v : variants) {
    // Parts and channels share their points with the variant before.
    if (!grids.empty() && v.roughness == variants[grids.size() - 1].roughness && v.angle == variants[grids.size() - 1].angle) {
      grids.push_back({});
      continue;
    }
    grids.push_back(gridOf(s, v.angle));
    for (const double x : grids.back()) points.push_back(pointOf(data, v.roughness, directionsAt(s, v.angle, x)));
  }
  std::vector<Parts> parts;
  if (!ownRoughness) parts = evaluateParts(probe, points);
  for (size_t k = 0; ownRoughness && k < variants.size(); ++k) {
    if (grids[k].empty()) continue;
    ownRoughness(variants[k].roughness);
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(parts.size());
    const std::vector<Parts> some = evaluateParts(probe, {begin, begin + static_cast<std::ptrdiff_t>(grids[k].size())});
    parts.insert(parts.end(), some.begin(), some.end());
  }
  size_t from = 0, next = 0;
  const std::vector<double>* grid = nullptr;
  for (size_t k = 0; k < variants.size(); ++k) {
    const Variant& v = variants[k];
    if (!grids[k].empty()) {
      grid = &grids[k];
      from = next;
      next += grid->size();
    }
    PlotCurve curve{subject, k, *grid, {}};
    for (size_t i = 0; i < grid->size(); ++i) {
      const Parts& at = parts[from + i];
      const Directions d = directionsAt(s, v.angle, (*grid)[i]);
      double y = 0;
      switch (s.kind) {
        case PlotKind::D: y = at.D; break;
        case PlotKind::V: y = at.V; break;
        case PlotKind::G: y = at.V * 4 * std::max(d.light.z, 0.0) * std::max(d.view.z, 0.0); break;
        case PlotKind::F: y = channelValue(at.F, v.channel); break;
        default:
          y = channelValue(at.part(v.part), v.channel) * (s.cosine ? std::max(d.light.z, 0.0) : 1.0);
          // What is scattered within has no cosine to be taken out: it is no part of f.
          if (s.cosine && v.part != PlotPart::Specular) y += channelValue(at.scattered, v.channel);
      }
      curve.y.push_back(y);
    }
    data.curves.push_back(std::move(curve));
  }
}

void addAlbedo(PlotData& data, const std::vector<Variant>& variants, size_t subject, const ModelIntegrals& integrals, double effort, const OwnRoughness& ownRoughness) {
  const PlotSettings& s = data.settings;
  std::vector<double> grid;
  if (s.overRoughness) {
    // Below 0.05 the quadrature is not to be trusted.
    const int count = std::max(12, static_cast<int>(39 * effort));
    for (int i = 0; i < count; ++i) grid.push_back(0.05 + 0.95 * i / (count - 1));
  } else {
    // Closer together towards grazing views, where albedos change fastest.
    const int count = std::max(20, static_cast<int>(60 * effort));
    for (int i = 0; i < count; ++i) grid.push_back(89.7 * (1 - std::pow(1 - double(i) / (count - 1), 2.4)));
  }
  std::vector<IntegralQuery> queries;
  std::vector<size_t> first(variants.size());
  for (size_t k = 0; k < variants.size(); ++k) {
    const Variant& v = variants[k];
    if (k > 0 && v.roughness == variants[k - 1].roughness && v.angle == variants[k - 1].angle) {
      first[k] = first[k - 1];
      continue;
    }
    first[k] = queries.size();
    for (const double x : grid) {
      IntegralQuery q;
      q.roughness = s.overRoughness ? static_cast<float>(x) : v.roughness;
      q.NoV = std::max(static_cast<float>(std::cos((s.overRoughness ? v.angle : x) * kDegree)), 0.005f);
      q.F0 = data.F0;
      q.diffuseColor = data.diffuseColor;
      queries.push_back(q);
    }
  }
  std::vector<ModelIntegral> values;
  for (size_t from = 0, to = 0; from < queries.size(); from = to) {
    // All at once where nothing has to be set between them.
    to = queries.size();
    if (ownRoughness) {
      to = from + 1;
      while (to < queries.size() && queries[to].roughness == queries[from].roughness) ++to;
      ownRoughness(queries[from].roughness);
    }
    const std::vector<ModelIntegral> some = integrals.evaluate(std::span(queries).subspan(from, to - from));
    values.insert(values.end(), some.begin(), some.end());
  }
  for (size_t k = 0; k < variants.size(); ++k) {
    PlotCurve curve{subject, k, grid, {}};
    for (size_t i = 0; i < grid.size(); ++i) {
      const ModelIntegral& at = values[first[k] + i];
      const PlotPart part = variants[k].part;
      const glm::dvec3 sum = (part == PlotPart::Diffuse ? glm::dvec3(0) : at.specular) + (part == PlotPart::Specular ? glm::dvec3(0) : at.diffuse + at.scattered);
      curve.y.push_back(channelValue(sum, variants[k].channel));
    }
    data.curves.push_back(std::move(curve));
  }
}

// As BRDF Explorer's image slice (Burley 2012, section 2): the half vector stands at theta_h over the tangent, the light
// theta_d from it at phi_d around it, and the view is the light mirrored at the half vector.
void addSlice(PlotData& data, size_t subject, const ModelProbe& probe, double effort) {
  const PlotSettings& s = data.settings;
  const int side = std::max(48, static_cast<int>(256 * effort));
  std::vector<ProbePoint> points;
  std::vector<double> cosines;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double thetaH = 90 * (column + 0.5) / side * kDegree, thetaD = 90 * (side - row - 0.5) / side;
      const glm::dvec3 d = direction(thetaD, s.phi), h(std::sin(thetaH), 0, std::cos(thetaH));
      const glm::dvec3 light(d.x * h.z + d.z * h.x, d.y, d.z * h.z - d.x * h.x);
      const glm::dvec3 view = 2 * glm::dot(h, light) * h - light;
      points.push_back(pointOf(data, s.roughness[0], {light, view}));
      // Below the horizon nothing is reflected.
      cosines.push_back(light.z > 0 && view.z > 0 ? (s.cosine ? light.z : 1) : 0);
    }
  const std::vector<Parts> parts = evaluateParts(probe, points);
  PlotSlice slice{subject, ImageF(side, side, 3)};
  for (size_t i = 0; i < parts.size(); ++i)
    for (int k = 0; k < 3; ++k) slice.f.data[3 * i + static_cast<size_t>(k)] = cosines[i] > 0 ? static_cast<float>(parts[i].part(s.parts[0])[k] * cosines[i]) : 0.0f;
  data.slices.push_back(std::move(slice));
}

// The term a kind is about; empty for those that every model has.
const char* missingTerm(PlotKind kind, const ShadingModel& model) {
  if (kind == PlotKind::D && !model.hasD()) return "D";
  if ((kind == PlotKind::G || kind == PlotKind::V) && !model.hasV()) return "V";
  if (kind == PlotKind::F && !model.hasF()) return "F";
  return nullptr;
}

// Channels that are the same curve for every model are one.
void mergeGreyChannels(PlotData& data, std::vector<Variant>& variants) {
  if (!takes(data.settings.kind, "channel") || data.settings.channel != PlotChannel::Rgb || data.curves.empty()) return;
  for (size_t i = 0; i + 2 < data.curves.size(); i += 3)
    if (data.curves[i].y != data.curves[i + 1].y || data.curves[i].y != data.curves[i + 2].y) return;
  std::vector<PlotCurve> kept;
  for (size_t i = 0; i < data.curves.size(); i += 3) {
    data.curves[i].variant /= 3;
    kept.push_back(std::move(data.curves[i]));
  }
  data.curves = std::move(kept);
  PlotSettings grey = data.settings;
  grey.channel = PlotChannel::Luminance;
  variants = variantsOf(grey);
}

// Where the light that a model scatters within is, or that it is left out.
void noteScattered(PlotData& data, const ShadingModel& model, const std::string& title) {
  const PlotSettings& s = data.settings;
  if (!model.definesScattered || !takes(s.kind, "part") || s.parts == std::vector<PlotPart>{PlotPart::Specular}) return;
  if (s.kind == PlotKind::Albedo) data.notes.push_back(title + ": its diffuse part has the light scattered within, from all around");
  else if (s.cosine && s.kind != PlotKind::Slice) data.notes.push_back(title + ": its diffuse part has the light scattered within");
  else data.notes.push_back(title + ": the light scattered within is left out" + (s.kind == PlotKind::Slice ? "" : "; times the cosine it is there"));
}

void noteGaps(PlotData& data) {
  for (size_t subject = 0; subject < data.titles.size(); ++subject) {
    size_t gaps = 0, all = 0;
    for (const PlotCurve& curve : data.curves)
      if (curve.subject == subject) {
        all += curve.y.size();
        gaps += static_cast<size_t>(std::count_if(curve.y.begin(), curve.y.end(), [](double y) { return !std::isfinite(y); }));
      }
    for (const PlotSlice& slice : data.slices)
      if (slice.subject == subject) {
        all += slice.f.data.size() / 3;
        for (size_t i = 0; i < slice.f.data.size(); i += 3)
          gaps += !(std::isfinite(slice.f.data[i]) && std::isfinite(slice.f.data[i + 1]) && std::isfinite(slice.f.data[i + 2]));
      }
    if (gaps) data.notes.push_back(fmt::format("{}: not finite at {} of {} points", data.titles[subject], gaps, all));
  }
}

// A curve a hundred times as high as any other would press them all to the axis: it is cut off, and said so.
void limitTop(PlotData& data) {
  constexpr double kMost = 100;
  const PlotSettings& s = data.settings;
  if (s.log || s.most || data.curves.size() < 2) return;
  std::vector<std::pair<double, const PlotCurve*>> peaks;
  for (const PlotCurve& curve : data.curves) {
    double peak = 0;
    for (const double y : curve.y)
      if (std::isfinite(y)) peak = std::max(peak, y);
    if (peak > 0) peaks.emplace_back(peak, &curve);
  }
  std::sort(peaks.begin(), peaks.end());
  for (size_t i = 1; i < peaks.size(); ++i) {
    if (peaks[i].first < kMost * peaks[i - 1].first) continue;
    data.top = peaks[i - 1].first;
    const PlotCurve& highest = *peaks.back().second;
    const std::string& variant = data.variants[highest.variant];
    data.notes.push_back(fmt::format("{}{}{} reaches {}: cut off; max= or log=1 shows it", data.titles[highest.subject], variant.empty() ? "" : ", ", variant,
                                     readable(peaks.back().first)));
    return;
  }
}

}  // namespace

bool isPlotRoughness(const ShadingModel& model, const ModelParameter& parameter) {
  return &parameter == model.parameter("roughness") && parameter.standard.type == ValueType::Float;
}

double channelValue(const glm::dvec3& color, PlotChannel channel) {
  switch (channel) {
    case PlotChannel::Red: return color.r;
    case PlotChannel::Green: return color.g;
    case PlotChannel::Blue: return color.b;
    default: return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722));
  }
}

PlotComputer::Compiled& PlotComputer::compiled(const ShadingModel& model, bool integrals, const Making& making) {
  const auto key = std::tuple(model.id, model.hash, making);
  if (!models_.count(key) && models_.size() >= kMostCompiled)
    models_.erase(std::min_element(models_.begin(), models_.end(), [](const auto& a, const auto& b) { return a.second.used < b.second.used; }));
  Compiled& entry = models_[key];
  entry.used = ++clock_;
  if (!entry.problems.empty()) return entry;
  if (integrals && !entry.integrals) {
    IntegralOptions options{.compensate = making.compensate, .specularOnly = making.specularOnly};
    if (making.coarse) options.polar /= 2, options.quarter /= 2;
    auto made = ModelIntegrals::of(model, options);
    if (made) entry.integrals = std::move(*made);
    else entry.problems = made.diagnostics();
  } else if (!integrals && !entry.probe) {
    auto made = ModelProbe::ofModelParts(model, making.compensate);
    if (made) entry.probe = std::move(*made);
    else entry.problems = made.diagnostics();
  }
  return entry;
}

// The two colours by the shader that draws with them.
void PlotComputer::resolveColors(PlotData& data) {
  const PlotSettings& s = data.settings;
  if (s.white) {
    data.F0 = data.diffuseColor = glm::vec3(1);
    return;
  }
  if (!colors_) {
    auto made = ModelProbe::ofChoices({"vec4(withColors(s, a.xyz, a.w, b.x).F0, 0.0)", "vec4(withColors(s, a.xyz, a.w, b.x).diffuseColor, 0.0)"});
    GLINT_CHECK(made.ok(), "{}", made.diagnostics()[0].text());
    colors_ = std::move(*made);
  }
  ProbePoint points[2];
  for (int i = 0; i < 2; ++i) {
    points[i].a = {s.baseColor, s.metallic};
    points[i].b.x = s.specular;
    points[i].choice = i;
  }
  const std::vector<glm::vec4> values = colors_->evaluate(points);
  data.F0 = s.F0.value_or(glm::vec3(values[0]));
  data.diffuseColor = glm::vec3(values[1]);
}

std::optional<PlotData> PlotComputer::compute(const PlotSettings& settings, const std::vector<PlotSubject>& subjects, double effort,
                                              const std::function<bool()>& stop) {
  PlotData data{.settings = settings};
  resolveColors(data);
  std::vector<Variant> variants = variantsOf(settings);
  for (size_t i = 0; i < subjects.size(); ++i) {
    if (stop && stop()) return std::nullopt;
    const ShadingModel& model = *subjects[i].model;
    data.titles.push_back(subjects[i].title);
    data.colors.push_back(model.color);
    if (const char* term = missingTerm(settings.kind, model)) {
      data.notes.push_back(fmt::format("{} has no {} of its own", subjects[i].title, term));
      continue;
    }
    const bool albedo = settings.kind == PlotKind::Albedo;
    noteScattered(data, model, subjects[i].title);
    Making making{.compensate = settings.compensate || model.compensate};
    if (albedo) {
      making.specularOnly = settings.parts == std::vector<PlotPart>{PlotPart::Specular};
      making.coarse = effort < 1;
    }
    Compiled& entry = compiled(model, albedo, making);
    if (!entry.problems.empty()) {
      data.problems.insert(data.problems.end(), entry.problems.begin(), entry.problems.end());
      data.notes.push_back(fmt::format("{} does not compile", subjects[i].title));
      continue;
    }
    // Unless the subject says another.
    const auto ownRoughness = [](const ShadingModel& of, const PlotSubject& subject, auto& made) -> OwnRoughness {
      const ModelParameter* own = of.parameter("roughness");
      if (!own || !isPlotRoughness(of, *own)) return {};
      for (const auto& [name, value] : subject.parameters)
        if (name == own->name && !(value == own->standard)) return {};
      return [&made, own](float roughness) { made.set(own->name, Value::scalar(roughness)); };
    };
    const auto setAll = [&](auto& made) {
      for (const ModelParameter& p : model.parameters) made.set(p.name, p.standard);
      for (const auto& [name, value] : subjects[i].parameters) made.set(name, value);
    };
    if (albedo) {
      setAll(*entry.integrals);
      addAlbedo(data, variants, i, *entry.integrals, effort, ownRoughness(model, subjects[i], *entry.integrals));
    } else {
      setAll(*entry.probe);
      const OwnRoughness own = ownRoughness(model, subjects[i], *entry.probe);
      if (own && settings.kind == PlotKind::Slice) own(settings.roughness[0]);
      if (settings.kind == PlotKind::Slice) addSlice(data, i, *entry.probe, effort);
      else addCurves(data, variants, i, *entry.probe, own);
    }
  }
  mergeGreyChannels(data, variants);
  for (const Variant& v : variants) data.variants.push_back(v.title);
  noteGaps(data);
  limitTop(data);
  return data;
}

}  // namespace glint
