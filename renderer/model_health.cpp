#include "renderer/model_health.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "materials/base/check.h"
#include "materials/glsl_scan.h"
#include "renderer/area_light_error.h"
#include "renderer/hook_faults.h"
#include "renderer/loop_faults.h"
#include "renderer/model_integrals.h"
#include "renderer/probe_points.h"
#include "renderer/sampler_error.h"
#include "renderer/split_sum_error.h"

namespace glint {
namespace {

using std::numbers::pi;

// Single precision and quadrature stay below these, see tests/models/numbers_test.cpp.
constexpr double kReciprocal = 1e-3, kNormalised = 5e-3, kEnergy = 3e-3, kMirror = 0.03, kWhite = 0.9, kFurnace = 5e-3;
constexpr float kMirrorRoughness = 0.1f;

const std::vector<float> kFineRoughness = {0.05f, 0.1f, 0.15f, 0.2f, 0.25f, 0.3f, 0.35f, 0.4f, 0.45f, 0.5f,
                                           0.55f, 0.6f, 0.65f, 0.7f, 0.75f, 0.8f, 0.85f, 0.9f, 0.95f, 1.f};
const std::vector<float> kFineNoV = {0.005f, 0.01f, 0.02f, 0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.7f, 0.85f, 1.f};
const std::vector<float> kCoarseRoughness = {0.05f, 0.15f, 0.3f, 0.5f, 0.75f, 1.f};
const std::vector<float> kCoarseNoV = {0.005f, 0.05f, 0.2f, 0.5f, 1.f};

// A window of a hundredth of the roughness has one of them.
constexpr int kBetween = 128;

class Examination {
 public:
  Examination(const ShadingModel& model, bool compensate, ModelHealth& card, const std::function<bool()>& stopped)
      : model_(model), compensate_(compensate), card_(card), stopped_(stopped) {
    card_.laws.reserve(kLawCount);  // results are referred to while others are added
  }

  void run() {
    auto probe = ModelProbe::ofModel(model_, compensate_);
    if (!probe) return fails(probe.diagnostics());
    if (const auto fault = faultOfLoops(model_)) return fails({*fault});
    auto integrals = ModelIntegrals::of(model_, {.compensate = compensate_});
    if (!integrals) return fails(integrals.diagnostics());
    result(Law::Compiles);
    hasD_ = model_.definesD || !model_.termD.empty();
    points_ = gridPoints(model_);
    if (stopped()) return;
    values(points_, probe->evaluate(points_));
    if (stopped()) return;
    for (const ScatteredPoints& some : scatteredPoints(model_)) {
      constants_ = some.constants;
      values(some.points, probe->evaluate(some.points, constants_));
    }
    constants_.clear();
    hooks();
    if (result(Law::Finite).verdict == Verdict::Red) return;  // sums of what is not finite say nothing
    if (stopped()) return;
    energy(*integrals, kFineRoughness, kFineNoV, kBetween);
    if (stopped()) return;
    if (!model_.isWhole()) mirror(*integrals);
    if (compensate_) {
      // The split sum stands for the single bounce; further ones are lit by the irradiance.
      const auto singleProbe = ModelProbe::ofModel(model_, false);
      const auto singleIntegrals = ModelIntegrals::of(model_, {.compensate = false});
      if (singleProbe && singleIntegrals) environment(*singleProbe, *singleIntegrals);
      if (singleProbe) areaLights(*singleProbe);
    } else {
      environment(*probe, *integrals);
      areaLights(*probe);
    }
    if (stopped()) return;
    sampler(*probe);
    for (const ModelParameter& p : model_.parameters) {
      if (p.minimum == p.maximum) continue;
      for (const float end : {p.minimum, p.maximum}) {
        Value value = p.standard;
        value.v.fill(end);
        probe->set(p.name, value);
        if (p.name != model_.tangentRotation) integrals->set(p.name, value);  // which no sum around the normal sees
        setting_ = fmt::format(", {} {}", p.fileName.empty() ? p.name : p.fileName, end);
        end_ = {p.name, value};
        if (stopped()) return;
        values(points_, probe->evaluate(points_));
        if (result(Law::Finite).verdict == Verdict::Red) return;
        if (p.name != model_.tangentRotation) energy(*integrals, kCoarseRoughness, kCoarseNoV);
      }
      probe->set(p.name, p.standard);
      integrals->set(p.name, p.standard);
    }
  }

 private:
  LawResult& result(Law law) {
    for (LawResult& r : card_.laws)
      if (r.law == law) return r;
    card_.laws.push_back({.law = law, .where = {}, .reason = {}, .hint = {}});
    return card_.laws.back();
  }

  void fails(const Diagnostics& faults) { card_ = unmeasurable(card_.model, card_.file, faults); }

  // A fault that the model has with its parameters at their defaults is not told again of their ends.
  bool told(const LawResult& law) const { return !setting_.empty() && law.verdict != Verdict::Green; }

  std::string roughnessText(float roughness) const {
    return model_.reads("roughness") ? fmt::format("roughness {:.3g}, ", roughness) : "";
  }
  std::string at(const ProbePoint& p) const {
    return fmt::format("{}NoL {:.4g}, NoV {:.4g}{}{}", roughnessText(p.roughness), p.light.z, p.view.z, attributesText(model_, p), p.ownParameters ? parametersText(model_, p, constants_) : setting_);
  }
  std::string at(const IntegralQuery& q) const {
    ProbePoint point;
    point.F0 = q.F0;
    if (q.authored) {
      point.baseColor = q.authored->baseColor;
      point.metallic = q.authored->metallic;
      point.specular = q.authored->specular;
      point.plainNonmetal = q.authored->plainNonmetal;
    }
    return fmt::format("{}NoV {:.3g}{}{}{}{}", roughnessText(q.roughness), q.NoV, q.authored ? attributesText(model_, point) : "",
                       q.azimuth == 0 ? "" : fmt::format(", {:.3g} degrees from the tangent", static_cast<double>(q.azimuth) / pi * 180),
                       q.analyticLight ? "" : ", under an environment", setting_);
  }

  static bool isFault(float v) { return !std::isfinite(v) || v < 0; }

  // What of the model gives a value that is no light, and where in its file that stands, when it is the file's own.
  struct Culprit {
    std::string name = {}, place = {};  // ", because of D", "planted.glsl:7, "
  };
  Culprit culprit(const ProbePoint& point) {
    auto probe = ModelProbe::ofModelParts(model_, compensate_);
    if (!probe) return {};
    if (!setting_.empty()) probe->set(end_.first, end_.second);
    const ProbePoint one[] = {point};
    const std::vector<glm::vec4> out = constants_.empty() ? probe->evaluate(one) : probe->evaluate(one, constants_);
    const auto faulty = [](const glm::vec4& v) { return isFault(v.r) || isFault(v.g) || isFault(v.b); };
    std::vector<std::pair<bool, std::string>> parts = {
        {isFault(out[0].w), "D"}, {isFault(out[1].w), "V"}, {faulty(out[2]), "F"}, {faulty(out[1]), "diffuse"}, {faulty(out[3]), "scattered"}};
    if (model_.definesCoat || (model_.definesColors && point.fromAttributes))
      if (auto hooks = ModelProbe::ofHooks(model_)) {
        if (!setting_.empty()) hooks->set(end_.first, end_.second);
        const std::vector<glm::vec4> of = constants_.empty() ? hooks->evaluate(one) : hooks->evaluate(one, constants_);
        // What reflects with faulty colours is faulty too, and so is the diffuse part through a faulty coat.
        parts.insert(parts.begin(), {{model_.definesColors && (faulty(of[0]) || faulty(of[1])), "colors"}, {faulty(of[4]), "coat"}, {faulty(of[5]), "throughCoat"}});
      }
    parts.emplace_back(faulty(out[0]), "specular");
    for (const auto& [bad, name] : parts) {
      if (!bad) continue;
      const std::string own = model_.isWhole() ? model_.namePrefix + "BRDF" : name;
      for (const GlslFunction& f : scanGlsl(model_.source).functions)
        if (f.name == own) return {", because of " + (model_.isWhole() ? "BRDF" : name), fmt::format("{}:{}, ", (model_.sourceFile.empty() ? model_.file : model_.sourceFile).string(), f.line)};
      return {", because of " + name};
    }
    return {};
  }

  // Of points that are each followed by themselves with light and view in each other's place.
  void values(const std::vector<ProbePoint>& points, const std::vector<glm::vec4>& out) {
    LawResult &finite = result(Law::Finite), &positive = result(Law::NonNegative);
    double worst = 0;
    size_t worstAt = 0;
    const ProbePoint *broken = nullptr, *darkest = nullptr;
    for (size_t i = 0; i < points.size(); ++i) {
      for (const glm::vec4& v : {out[2 * i], out[2 * i + 1]})
        for (int c = 0; c < 4; ++c) {
          if (!std::isfinite(v[c]) && finite.verdict == Verdict::Green) {
            finite.verdict = Verdict::Red;
            broken = &points[i];
          } else if (v[c] < positive.value && !told(positive)) {
            positive.value = v[c];
            darkest = &points[i];
          }
        }
      if (i % 2) continue;
      for (size_t part = 0; part < 2; ++part)
        for (int c = 0; c < 3; ++c) {
          const double a = out[2 * i + part][c], b = out[2 * i + 2 + part][c];
          const double difference = std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-3});
          if (difference > worst) {
            worst = difference;
            worstAt = i;
          }
        }
    }
    if (broken) {
      const Culprit by = culprit(*broken);
      finite.where = by.place + at(*broken);
      finite.reason = "is not finite" + by.name;
      finite.hint = "guard a division, a root or a power";
      ModelSetting atEnd = modelSetting(model_);
      if (!setting_.empty()) atEnd.set(end_.first, end_.second);
      if (const auto fault = faultOfLoops(model_, {broken, 1}, constants_.empty() ? atEnd.constants : constants_)) {
        finite.where = fmt::format("{}, {}", fault->place, at(*broken));
        finite.reason = "is not finite: " + fault->what;
        finite.hint = fault->hint;
      }
    }
    if (darkest) {
      const Culprit by = culprit(*darkest);
      positive.verdict = Verdict::Red;
      positive.where = by.place + at(*darkest);
      positive.reason = fmt::format("is negative, {:.4g}{}", positive.value, by.name);
      positive.hint = "light cannot be taken away: clamp the term that turns";
    }
    LawResult& reciprocal = result(Law::Reciprocity);
    reciprocal.claimed = model_.claims.reciprocal;
    if (worst <= reciprocal.value || told(reciprocal)) return;
    reciprocal.value = worst;
    reciprocal.where = at(points[worstAt]);
    if (worst <= kReciprocal) return;
    reciprocal.verdict = reciprocal.claimed ? Verdict::Red : Verdict::Amber;
    reciprocal.reason = fmt::format("is not reciprocal{}: swapping light and view changes it by {:.3g} %",
                                    reciprocal.claimed ? " as it claims" : "", 100 * worst);
    reciprocal.hint = reciprocal.claimed ? "drop the claim or mend the formula" : "";
  }

  // What is no part of f.
  void hooks() {
    for (const HookFault& fault : hookFaults(model_)) {
      if (result(fault.law).verdict != Verdict::Green) continue;
      LawResult& law = result(fault.law);
      law.claimed = fault.law == Law::Energy && model_.claims.energyConserving;
      law.verdict = fault.law == Law::Energy && !law.claimed ? Verdict::Amber : Verdict::Red;
      law.value = fault.value;
      const ProbePoint& p = fault.point;
      law.where = fmt::format("{}:{}, {}NoL {:.4g}, NoV {:.4g}{}{}", (model_.sourceFile.empty() ? model_.file : model_.sourceFile).string(), fault.line,
                              roughnessText(p.roughness), p.light.z, p.view.z, attributesText(model_, p), p.ownParameters ? parametersText(model_, p, fault.constants) : "");
      if (fault.law == Law::Finite) law.reason = fmt::format("is not finite, because of {}", fault.function);
      else if (fault.law == Law::NonNegative) law.reason = fmt::format("is negative, {:.4g}, because of {}", fault.value, fault.function);
      else law.reason = fmt::format("gains energy{}: {} gives {:.4g}, more than all light", law.claimed ? " against its claim" : "", fault.function, fault.value);
      law.hint = fault.law == Law::Energy ? "a colour or a reflected share is from 0 to 1" : "guard a division, a root or a power, or clamp what turns negative";
    }
  }

  // Over a grid, and at `between` roughnesses evenly between its lines.
  void energy(const ModelIntegrals& integrals, const std::vector<float>& roughness, const std::vector<float>& NoV, int between = 0) {
    std::vector<IntegralQuery> queries;
    const auto ask = [&](float r, float v, bool light) {
      // From all sides by turns, also such as a lobe that mirrors in both axes cannot tell apart.
      constexpr float kDegrees[] = {0, 90, -35, 15, 75, 130, 48};
      const float side = model_.usesTangent ? kDegrees[queries.size() % std::size(kDegrees)] : 0;
      queries.push_back({.roughness = r, .NoV = v, .analyticLight = light, .azimuth = side / 180 * std::numbers::pi_v<float>});
    };
    if (model_.reads("roughness"))
      for (int i = 0; i < between; ++i)
        ask(roughness.front() + (1 - roughness.front()) * (float(i) + 0.5f) / float(between), NoV[size_t(i * 7) % NoV.size()], true);
    if (between > 0) {
      const std::vector<IntegralQuery> authored = authoredQueries(model_, roughness, NoV, between);
      queries.insert(queries.end(), authored.begin(), authored.end());
    }
    for (const bool light : {true, false})
      for (const float r : model_.reads("roughness") ? roughness : std::vector{0.5f})
        for (const float v : NoV) ask(r, v, light);
    const std::vector<ModelIntegral> sums = integrals.evaluate(queries);
    // A specular part that does not follow F0 is never white. Where light grazes Fresnel hides it: the last query does not.
    const ModelIntegral& facing = sums.back();
    const bool followsF0 = facing.specular.g - facing.specularBlack.g > 0.05 * facing.specular.g;
    LawResult& law = result(Law::Energy);
    law.claimed = model_.claims.energyConserving;
    if (between > 0)
      black_ = std::none_of(sums.begin(), sums.end(), [](const ModelIntegral& s) { return s.specular != glm::dvec3(0) || s.diffuse != glm::dvec3(0) || s.scattered != glm::dvec3(0); });
    for (size_t i = 0; i < sums.size(); ++i) {
      if (hasD_) distribution(sums[i].distribution, queries[i]);
      if (followsF0 && !queries[i].authored) furnace(sums[i], queries[i]);
      for (const auto& [part, albedo] : {std::pair{"specular", sums[i].specular}, {"diffuse", sums[i].diffuse}, {"scattered", sums[i].scattered}}) {
        const double most = std::max({albedo.r, albedo.g, albedo.b});
        if (!(most > law.value) || told(law)) continue;
        law.value = most;
        law.where = at(queries[i]);
        if (most <= 1 + kEnergy) continue;
        law.verdict = law.claimed ? Verdict::Red : Verdict::Amber;
        law.reason = fmt::format("gains energy{}: {} reflects {:.4g} times what it receives", law.claimed ? " against its claim" : "",
                                 model_.isWhole() ? "it" : fmt::format("the {} part", part), most);
        law.hint = law.claimed ? "drop the claim or mend the formula" : "";
      }
    }
  }

  // What a white surface keeps of light from all sides.
  void furnace(const ModelIntegral& sum, const IntegralQuery& query) {
    const double albedo = std::max({sum.specular.r, sum.specular.g, sum.specular.b});
    LawResult& law = result(Law::Furnace);
    law.claimed = model_.compensate;
    if ((law.value != 0 && albedo >= law.value) || told(law)) return;
    law.value = albedo;
    law.where = at(query) + (model_.definesEnvironment ? ", of its f: a furnace shows its environment()" : "");
    if (!compensate_ || albedo >= 1 - kFurnace) return;
    law.verdict = law.claimed ? Verdict::Red : Verdict::Amber;
    law.reason = fmt::format("a compensated white surface keeps only {:.4f} of uniform light", albedo);
    law.hint = model_.usesTangent ? "what a bounce loses is tabulated by angle, roughness and one quarter around the tangent: is the lobe the same on both its sides?"
                                  : "what a bounce loses is tabulated by angle and roughness: is there a step in either?";
  }

  void distribution(double integral, const IntegralQuery& query) {
    LawResult& law = result(Law::Normalisation);
    if (law.value != 0 && std::abs(integral - 1) <= std::abs(law.value - 1)) return;
    law.value = integral;
    law.where = at(query);
    if (std::abs(integral - 1) <= kNormalised) return;
    law.verdict = Verdict::Red;
    law.reason = fmt::format("D integrates to {:.4g}, not to 1", integral);
    law.hint = "the integral of D (n.h) over the hemisphere must be 1: check its factor, 1/pi included";
  }

  // A microfacet model with smooth, white facets is a mirror: what is missing then is a lost factor.
  void mirror(const ModelIntegrals& integrals) {
    const IntegralQuery query[] = {{kMirrorRoughness, 1.f, true}};
    const ModelIntegral sum = integrals.evaluate(query)[0];
    // A coat keeps some of the light from what is below it.
    const bool diffuseLost = !model_.definesCoat && sum.diffuse.g > 0 && sum.diffuse.g < kWhite;
    LawResult& law = result(Law::MirrorLimit);
    law.value = sum.specular.g;
    law.where = at(query[0]);
    // One without a D counts where it follows F0, as a mirror does.
    const bool mirrors = hasD_ || sum.specular.g - sum.specularBlack.g > 0.1;
    if (mirrors && !model_.definesCoat && sum.specular.g < 1 - kMirror) {
      law.verdict = Verdict::Amber;
      law.reason = fmt::format("a white mirror reflects only {:.4g} of what it receives", sum.specular.g);
      law.hint = "check the factors of D and V: V is G / (4 NoL NoV), D has its 1/pi";
    } else if (diffuseLost) {
      law.verdict = Verdict::Amber;
      law.value = sum.diffuse.g;
      law.reason = fmt::format("a white diffuse surface reflects only {:.4g} of what it receives", sum.diffuse.g);
      law.hint = "diffuse is f itself: diffuseColor / pi for Lambert's";
    }
  }

  void environment(const ModelProbe& probe, const ModelIntegrals& integrals) {
    std::optional<ModelProbe> own;
    if (model_.definesEnvironment)
      if (auto made = ModelProbe::ofEnvironment(model_)) own = std::move(*made);
    const SplitSumError found = splitSumError(probe, integrals, own ? &*own : nullptr);
    LawResult& law = result(Law::Environment);
    law.value = found.rms;
    law.where = fmt::format("worst {:.3g} at {}NoV {:.3g}", found.worst, roughnessText(found.roughness), found.NoV);
  }

  void areaLights(const ModelProbe& probe) {
    // Others have no one lobe that could be a cosine's, or are drawn by representative points.
    if (model_.isWhole() || model_.usesTangent || model_.definesCoat) return;
    const AreaLightError found = areaLightError(probe);
    if (found.worst == 0) return;
    LawResult& law = result(Law::AreaLights);
    law.value = found.mean;
    law.where = fmt::format("worst {:.2g} % at {}NoV {:.3g}", 100 * found.worst, roughnessText(found.roughness), found.NoV);
  }

  void sampler(const ModelProbe& probe) {
    if (black_) {
      LawResult& law = result(Law::Sampler);
      law.verdict = Verdict::Red;
      law.where = fmt::format("{}:{}", (model_.sourceFile.empty() ? model_.file : model_.sourceFile).string(), firstFunctionLine());
      law.reason = "reflects nothing from any direction: there is no lobe to draw directions from";
      law.hint = "check the parameters' defaults and what is clamped to 0";
      return;
    }
    const auto made = ModelSampler::of(modelSetting(model_));
    if (!made) return;
    LawResult& law = result(Law::Sampler);
    const SamplerError found = samplerError(probe, *made);
    law.value = found.worst;
    law.where = fmt::format("worst at {}NoV {:.3g}; {:.2g} % by the cosine", roughnessText(found.roughness), found.NoV, 100 * found.cosine);
    if (made->fault().empty() || found.worst == 0) return;
    law.verdict = Verdict::Amber;
    law.reason = "its directions go by the cosine, which is slow: " + made->fault();
    law.hint = "a sampler is tabulated from f, which must be finite and positive";
  }

  // Of the file's first function that a model is made of; of its head without one.
  int firstFunctionLine() const {
    for (const GlslFunction& f : scanGlsl(model_.source).functions)
      for (const char* name : {"BRDF", "specular", "D", "V", "F", "diffuse"})
        if (f.name == model_.namePrefix + name) return f.line;
    return model_.idLine;
  }

  bool stopped() const { return stopped_ && stopped_(); }

  const ShadingModel& model_;
  bool compensate_;
  ModelHealth& card_;
  const std::function<bool()>& stopped_;
  bool hasD_ = false, black_ = false;  // black: reflects nothing at all
  std::vector<ProbePoint> points_;
  std::string setting_;  // ", gamma 4" while a parameter is not at its default
  std::pair<std::string, Value> end_;  // that one
  std::vector<glm::vec4> constants_;   // of points with their own
};

}  // namespace

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 3> kNames = {"green", "amber", "red"};
  return kNames[static_cast<size_t>(verdict)];
}

std::string_view name(Law law) {
  constexpr std::array<std::string_view, kLawCount> kNames = {"compiles",      "finite", "non-negative", "reciprocity",
                                                      "normalisation", "energy", "white furnace", "mirror limit", "environment", "area lights", "sampler"};
  return kNames[static_cast<size_t>(law)];
}

Verdict ModelHealth::verdict() const {
  Verdict worst = Verdict::Green;
  for (const LawResult& r : laws) worst = std::max(worst, r.verdict);
  return worst;
}

std::string ModelHealth::reason() const {
  const Verdict worst = verdict();
  for (const LawResult& r : laws)
    if (worst != Verdict::Green && r.verdict == worst) return r.reason + " (" + r.where + ")";
  return {};
}

const LawResult* ModelHealth::find(Law law) const {
  for (const LawResult& r : laws)
    if (r.law == law) return &r;
  return nullptr;
}

ModelHealth unmeasurable(const std::string& model, const std::string& file, const Diagnostics& faults) {
  ModelHealth card{.model = model, .file = file, .laws = {}};
  for (const Diagnostic& fault : faults)
    card.laws.push_back({.law = Law::Compiles, .verdict = Verdict::Red, .where = fault.place, .reason = fault.what, .hint = fault.hint});
  return card;
}

std::vector<ModelHealth> unusableModels(const ModelRegistry& registry, const std::string& id) {
  std::map<std::string, Diagnostics> faults;  // by file
  for (const Diagnostic& problem : registry.problems()) {
    const auto hides = [&](const ModelPtr& model) {
      return problem.place == fmt::format("{}:{}", model->file.string(), model->idLine) && (id.empty() || model->id == id);
    };
    const bool hidden = std::any_of(registry.hidden().begin(), registry.hidden().end(), hides);
    if (hidden || (id.empty() && problem.severity == Severity::Error)) faults[problem.place.substr(0, problem.place.rfind(':'))].push_back(problem);
  }
  std::vector<ModelHealth> cards;
  for (const auto& [file, ofFile] : faults) cards.push_back(unmeasurable(file, file, ofFile));
  return cards;
}

ModelHealth checkHealth(const ShadingModel& model, bool compensate, const std::function<bool()>& stopped) {
  const auto begin = std::chrono::steady_clock::now();
  ModelHealth card{.model = model.id, .file = model.file.string(), .laws = {}};
  Examination(model, (compensate || model.compensate) && !model.isWhole(), card, stopped).run();
  card.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return card;
}

}  // namespace glint
