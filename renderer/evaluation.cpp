#include "renderer/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "materials/model_mix.h"
#include "materials/terms.h"
#include "renderer/evaluation_arguments.h"
#include "renderer/evaluation_batch.h"
#include "renderer/evaluation_light.h"
#include "renderer/multiple_scattering.h"
#include "renderer/quadrature.h"

namespace glint {
namespace {

using std::numbers::pi;
using namespace evaluation;

IntegralQuery query(const EvaluationRequest& request, double NoV) {
  return {static_cast<float>(roughness(request)), static_cast<float>(NoV), !underEnvironment(request)};
}

Values one(double value) { return {{"value", {value}}}; }

// ---- terms ----

// Functions of plain numbers: their arguments by name, as `a.x` and on in GLSL.
struct Formula {
  std::string_view name;
  std::vector<std::string> arguments;
  std::string_view expression;
};
const std::vector<Formula>& formulas() {
  static const std::vector<Formula> table = {
      {"D_Approx", {"r", "RoL"}, "vec4(approximateD(pow(alphaFromRoughness(a.x), 2.0), a.y))"},
      {"EnvBRDFApprox_A", {"r", "NoV"}, "vec4(envBrdfApprox(a.x, a.y).x)"},
      {"EnvBRDFApprox_B", {"r", "NoV"}, "vec4(envBrdfApprox(a.x, a.y).y)"},
      {"EnvBRDFApproxNonmetal", {"r", "NoV"}, "vec4(envBrdfApproxNonmetal(a.x, a.y))"},
      {"falloff_eq9", {"distance", "lightRadius"}, "vec4(windowedFalloff(a.x * a.x, 1.0 / (a.y * a.y), 1.0))"},
      {"alphaPrime_eq10", {"r", "sourceRadius", "distance"}, "vec4(widenedAlpha(alphaFromRoughness(a.x), a.y, a.z, 3.0))"},
      {"SphereNormalization_eq14", {"r", "sourceRadius", "distance"},
       "vec4(sphereNormalization(alphaFromRoughness(a.x), widenedAlpha(alphaFromRoughness(a.x), a.y, a.z, 3.0)))"},
      {"LineNormalization_eq20", {"r", "sourceRadius", "distance"},
       "vec4(lineNormalization(alphaFromRoughness(a.x), widenedAlpha(alphaFromRoughness(a.x), a.y, a.z, 3.0)))"},
      {"D_GGXaniso", {"ax", "ay", "XoH", "YoH", "NoH"}, "vec4(anisotropicGGX(a.xy, vec3(a.zw, b.x)))"},
      {"V_SmithGGXCorrelatedAniso", {"ax", "ay", "XoL", "YoL", "NoL", "XoV", "YoV", "NoV"},
       "vec4(anisotropicVisibility(a.xy, vec3(a.zw, b.x), b.yzw))"},
      {"clearcoat_D_GTR1", {"gloss", "NoH"}, "vec4(D_GTR1(withAlpha(s, clearCoatAlpha(a.x))))"},
      {"E_FON", {"r", "NoV"}, "vec4(fujiiAlbedo(a.x, a.y))"},
  };
  return table;
}

size_t formulaPoint(const Formula& formula, const EvaluationRequest& request, Batch& batch) {
  ProbePoint p = pointOf(request, {});
  for (size_t i = 0; i < formula.arguments.size(); ++i)
    (i < 4 ? p.a[static_cast<int>(i)] : p.b[static_cast<int>(i - 4)]) =
        static_cast<float>(formula.arguments[i] == "r" ? roughness(request) : number(request, formula.arguments[i]));
  return batch.point(std::string(formula.expression), p);
}

const Formula& formula(std::string_view name) {
  const auto& all = formulas();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Formula& f) { return f.name == name; });
  GLINT_CHECK(found != all.end(), "{}", name);
  return *found;
}

// The library, read once.
struct Library {
  std::vector<Term> terms = glint::terms();
  const Term* find(TermKind kind, std::string_view name) const {
    for (const Term& t : terms)
      if (t.kind == kind && t.name == name) return &t;
    return nullptr;
  }
};

Finish term(const Term& t, const EvaluationRequest& request, Batch& batch, bool asG) {
  if (t.ofOwnD)
    throw EvaluationFault{fmt::format("'{}' is made for the D of a model and has no value without it", request.what),
                fmt::format("ask for f_GTR1_5*{}*None, or for exact_smith_G1 of a D", t.name)};
  static const std::map<TermKind, std::vector<std::string>> kNeeded = {{TermKind::D, {"NoH"}},
                                                                       {TermKind::V, {"NoL", "NoV"}},
                                                                       {TermKind::F, {"VoH"}},
                                                                       {TermKind::Diffuse, {"NoL", "NoV"}}};
  std::vector<std::string> needed = kNeeded.at(t.kind);
  if (t.name == "Kelemen" || t.name == "CookTorrance") needed.push_back("VoH");
  if (t.kind == TermKind::V && t.name == "CookTorrance") needed.push_back("NoH");
  ProbePoint p = pointOf(request, needed);
  if (t.kind == TermKind::F) number(request, "F0");
  else if (t.kind != TermKind::Diffuse || t.name != "Lambert") roughness(request);
  std::string arguments = "s";
  for (size_t i = 0; i < t.parameters.size(); ++i) {
    p.a[static_cast<int>(i)] = static_cast<float>(number(request, t.parameters[i].name, t.parameters[i].standard));
    arguments += std::string(", a.") + "xyzw"[i];
  }
  const bool color = t.kind == TermKind::F || t.kind == TermKind::Diffuse;
  const size_t ticket = batch.point(fmt::format("vec4({}({}){})", t.function(), arguments, color ? ", 0.0" : ""), p);
  const double scale = asG ? 4.0 * static_cast<double>(p.NoL) * static_cast<double>(p.NoV) : 1.0;
  return [ticket, scale](const Batch& done) { return one(done.pointValue(ticket).x * scale); };
}

// f of a whole model, its specular part: of a mix as the product of its terms.
Finish modelValue(const std::string& id, const EvaluationRequest& request, Batch& batch) {
  ProbePoint p = pointOf(request, {"NoL", "NoV", "NoH", "VoH"});
  roughness(request);
  number(request, "F0");
  const auto ticket = batch.modelPoint(id, p, parametersOf(request), compensated(request));
  return [ticket](const Batch& done) {
    if (const std::string fault = done.faultOf(ticket); !fault.empty()) throw EvaluationFault{fault, ""};
    return one(done.modelValue(ticket).y);
  };
}

Finish termOrModel(const EvaluationRequest& request, const Library& library, Batch& batch) {
  for (const Formula& f : formulas())
    if (f.name == request.what && std::all_of(f.arguments.begin(), f.arguments.end(),
                                              [&](const std::string& a) { return a == "r" ? hasRoughness(request) : request.numbers.count(a) != 0; })) {
      const size_t ticket = formulaPoint(f, request, batch);
      return [ticket](const Batch& done) { return one(done.pointValue(ticket).x); };
    }
  if (request.what.starts_with("f_")) return modelValue(request.what.substr(2), request, batch);
  const auto named = [&](std::string_view prefix, TermKind kind) -> const Term* {
    return request.what.starts_with(prefix) ? library.find(kind, request.what.substr(prefix.size())) : nullptr;
  };
  if (const Term* t = named("D_", TermKind::D)) return term(*t, request, batch, false);
  if (const Term* t = named("V_", TermKind::V)) return term(*t, request, batch, false);
  if (const Term* t = named("G_", TermKind::V)) return term(*t, request, batch, true);
  if (const Term* t = named("Fd_", TermKind::Diffuse)) return term(*t, request, batch, false);
  if (const Term* t = named("F_", TermKind::F)) return term(*t, request, batch, false);
  for (const Formula& f : formulas())
    if (f.name == request.what) formulaPoint(f, request, batch);  // tells which argument is missing
  std::vector<std::string> known = evaluationQuantities();
  for (const Term& t : library.terms) known.push_back(t.function());
  throw EvaluationFault{fmt::format("'{}' is nothing that can be evaluated", request.what.substr(0, 80)), suggestion(request.what, known)};
}

// ---- integrals ----

Finish integralOf(const EvaluationRequest& request, Batch& batch, double NoV, std::function<double(const ModelIntegral&)> pick) {
  const auto ticket = batch.integral(subject(request), query(request, NoV), parametersOf(request), compensated(request));
  return [ticket, pick = std::move(pick)](const Batch& done) {
    if (const std::string fault = done.faultOf(ticket); !fault.empty()) throw EvaluationFault{fault, ""};
    return one(pick(done.integral(ticket)));
  };
}

// Of any ax and ay, which no model's anisotropy can give: the points are made here.
Finish anisotropicNormalisation(const EvaluationRequest& request, Batch& batch) {
  const double ax = number(request, "ax"), ay = number(request, "ay");
  constexpr int kPolar = 96, kAround = 128;
  constexpr double kSmallest = 2e-4;
  const double k = std::log1p(0.5 * pi / kSmallest);
  std::vector<std::pair<size_t, double>> tickets;
  const std::string expression(formula("D_GGXaniso").expression);
  for (const QuadratureNode& node : gaussLegendre(kPolar)) {
    const double theta = kSmallest * std::expm1(k * node.x);
    for (int j = 0; j < kAround; ++j) {
      const double phi = 2 * pi * (j + 0.5) / kAround;
      ProbePoint p;
      p.a = {ax, ay, std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi)};
      p.b.x = static_cast<float>(std::cos(theta));
      tickets.emplace_back(batch.point(expression, p), 2 * pi / kAround * std::sin(theta) * std::cos(theta) *
                                                           (theta + kSmallest) * k * node.weight);
    }
  }
  return [tickets = std::move(tickets)](const Batch& done) {
    double sum = 0;
    for (const auto& [ticket, weight] : tickets) sum += weight * done.pointValue(ticket).x;
    return one(sum);
  };
}

Finish normalisation(const EvaluationRequest& request, Batch& batch) {
  if (request.numbers.count("ax")) return anisotropicNormalisation(request, batch);
  return integralOf(request, batch, 1, [](const ModelIntegral& i) { return i.distribution; });
}

Finish directionalAlbedo(const EvaluationRequest& request, Batch& batch) {
  return integralOf(request, batch, number(request, "NoV"), [](const ModelIntegral& i) { return i.specular.g; });
}

Finish exactSmithG1(const EvaluationRequest& request, Batch& batch) {
  const double NoV = number(request, "NoV");
  return integralOf(request, batch, NoV, [NoV](const ModelIntegral& i) { return NoV / i.projected; });
}

// The weights of E(NoV) for its cosine-weighted mean; squared nodes, because E changes fastest where the view grazes.
std::vector<QuadratureNode> averageNodes() {
  std::vector<QuadratureNode> nodes = gaussLegendre(24);
  for (QuadratureNode& n : nodes) n = {n.x * n.x, 4 * n.x * n.x * n.x * n.weight};
  return nodes;
}

// Tickets of the directional albedos that an average is made of.
struct Average {
  std::vector<std::pair<Batch::ModelTicket, double>> parts;
  double value(const Batch& done) const {
    double sum = 0;
    for (const auto& [ticket, weight] : parts) {
      if (const std::string fault = done.faultOf(ticket); !fault.empty()) throw EvaluationFault{fault, ""};
      sum += weight * done.integral(ticket).specular.g;
    }
    return sum;
  }
};
Average average(const EvaluationRequest& request, Batch& batch) {
  Average made;
  for (const QuadratureNode& n : averageNodes())
    made.parts.emplace_back(batch.integral(subject(request), query(request, n.x), parametersOf(request), compensated(request)), n.weight);
  return made;
}

Finish averageAlbedo(const EvaluationRequest& request, Batch& batch) {
  return [mean = average(request, batch)](const Batch& done) { return one(mean.value(done)); };
}

Finish kullaConty(const EvaluationRequest& request, Batch& batch) {
  const std::string id = subject(request);
  const auto light = batch.integral(id, query(request, number(request, "NoL"))), view = batch.integral(id, query(request, number(request, "NoV")));
  return [light, view, mean = average(request, batch)](const Batch& done) -> Values {
    const double average = mean.value(done), l = done.integral(light).specular.g, v = done.integral(view).specular.g;
    return {{"value", {kullaContyLobe(l, v, average)}},
            {"E_l", {l}},
            {"E_v", {v}},
            {"E_avg", {average}},
            {"turquin_scale_F0_1", {turquinScale(1, v)}},
            {"turquin_scale_F0_0p5", {turquinScale(0.5, v)}},
            {"kulla_conty_Fms_F0_0p5", {kullaContyTint(0.5, average)}}};
  };
}

// IntegrateBRDF of Karis 2013 as its listing has it, with 1024 directions of Hammersley's set drawn from GGX; in the
// listing's tangent frame, a half vector is turned by a quarter (physics.md K11).
std::vector<std::pair<size_t, glm::dvec2>> listingPoints(const std::string& V, double r, double NoV, bool turned, Batch& batch) {
  constexpr unsigned kCount = 1024;
  const double alpha = r * r;
  const glm::dvec3 view(std::sqrt(1 - NoV * NoV), 0, NoV);
  std::vector<std::pair<size_t, glm::dvec2>> tickets;
  for (unsigned i = 0; i < kCount; ++i) {
    unsigned bits = i;
    double radical = 0, digit = 0.5;
    for (; bits; bits >>= 1, digit /= 2) radical += (bits & 1) * digit;
    const double phi = 2 * pi * i / kCount;
    const double cos = std::sqrt((1 - radical) / (1 + (alpha * alpha - 1) * radical)), sin = std::sqrt(1 - cos * cos);
    const glm::dvec3 drawn(sin * std::cos(phi), sin * std::sin(phi), cos);
    const glm::dvec3 half = turned ? glm::dvec3(drawn.y, -drawn.x, drawn.z) : drawn;
    const double VoH = glm::dot(view, half);
    const glm::dvec3 light = 2 * VoH * half - view;
    if (light.z <= 0 || VoH <= 0) continue;
    ProbePoint p = ProbePoint::at(light, view);
    p.roughness = static_cast<float>(r);
    const double weight = 4 * light.z * VoH / cos / kCount;  // of V: G VoH / (NoH NoV)
    const double fresnel = std::pow(1 - VoH, 5);
    tickets.emplace_back(batch.point("vec4(V_" + V + "(s))", p), glm::dvec2(1 - fresnel, fresnel) * weight);
  }
  return tickets;
}

Finish environmentBrdf(const EvaluationRequest& request, const Library& library, Batch& batch) {
  const std::string id = subject(request);
  const double NoV = number(request, "NoV");
  const auto ticket = batch.integral(id, query(request, NoV), parametersOf(request));
  std::vector<std::pair<std::string, std::vector<std::pair<size_t, glm::dvec2>>>> sums;
  const auto mix = parseModelMix(isModelMix(id) ? id : namedMix(id));
  for (const auto& [name, turned] : {std::pair{"hammersley1024", false}, {"hammersley1024_listing_frame", true}})
    if (request.extras.count(name) && mix && mix->D == "GGX" && library.find(TermKind::V, mix->V))
      sums.emplace_back(name, listingPoints(mix->V, roughness(request), NoV, turned, batch));
  std::vector<size_t> approximate;
  if (request.extras.count("EnvBRDFApprox"))
    for (const char* part : {"EnvBRDFApprox_A", "EnvBRDFApprox_B"}) approximate.push_back(formulaPoint(formula(part), request, batch));
  return [=](const Batch& done) -> Values {
    if (const std::string fault = done.faultOf(ticket); !fault.empty()) throw EvaluationFault{fault, ""};
    const ModelIntegral& sum = done.integral(ticket);
    Values values{{"A", {sum.specular.g - sum.specularBlack.g}}, {"B", {sum.specularBlack.g}}};
    for (const auto& [name, parts] : sums) {
      glm::dvec2 total(0);
      for (const auto& [point, weight] : parts) total += done.pointValue(point).x * weight;
      values[name] = {total.x, total.y};
    }
    for (const size_t point : approximate) values["EnvBRDFApprox"].push_back(done.pointValue(point).x);
    return values;
  };
}

// ---- diffuse, sheen, attributes ----

const std::vector<std::pair<std::string, std::string>> kDiffuse = {
    {"burley", "Burley"}, {"oren_nayar_sigma", "OrenNayar"}, {"fon", "FON"}, {"eon", "EON"}};

Finish diffuseAlbedo(const EvaluationRequest& request, Batch& batch) {
  const double NoV = number(request, "NoV");
  if (request.names.count("model") || request.names.count("D")) {
    IntegralQuery q = query(request, NoV);
    q.diffuseColor = glm::vec3(1);
    const auto ticket = batch.integral(subject(request), q, parametersOf(request));
    return [ticket](const Batch& done) -> Values {
      if (const std::string fault = done.faultOf(ticket); !fault.empty()) throw EvaluationFault{fault, ""};
      return {{"value", {done.integral(ticket).diffuse.g}}};
    };
  }
  std::vector<std::pair<std::string, Batch::ModelTicket>> tickets;
  const auto add = [&](const std::string& name, const std::string& term, float color) {
    IntegralQuery q = query(request, NoV);
    q.diffuseColor = glm::vec3(color);
    tickets.emplace_back(name, batch.integral("GGX*Implicit*None*" + term, q));
  };
  add("burley", "Burley", 1);
  add("oren_nayar_sigma", "OrenNayar", 1);
  add("fon", "FON", 1);
  add("eon_rho1", "EON", 1);
  add("eon_rho0p5", "EON", 0.5f);
  const size_t closed = formulaPoint(formula("E_FON"), request, batch);
  return [tickets = std::move(tickets), closed](const Batch& done) {
    Values values{{"E_FON_closed_form", {done.pointValue(closed).x}}};
    for (const auto& [name, ticket] : tickets) values[name] = {done.integral(ticket).diffuse.g};
    values["value"] = values["burley"];
    return values;
  };
}

Finish diffuseBrdf(const EvaluationRequest& request, const Library& library, Batch& batch) {
  std::vector<std::pair<std::string, Finish>> parts;
  number(request, "LoV");
  for (const auto& [name, termName] : kDiffuse) {
    const Term* t = library.find(TermKind::Diffuse, termName);
    GLINT_CHECK(t, "{}", termName);
    parts.emplace_back(name, term(*t, request, batch, false));
  }
  return [parts = std::move(parts)](const Batch& done) {
    Values values;
    for (const auto& [name, finish] : parts) values[name] = finish(done).at("value");
    values["value"] = values["burley"];
    return values;
  };
}

Finish sheenAlbedo(const EvaluationRequest& request, Batch& batch) {
  const IntegralQuery q = query(request, number(request, "NoV"));
  const auto neubelt = batch.integral("Charlie*Neubelt*None", q), fit = batch.integral("Charlie*CharlieFit*None", q);
  return [neubelt, fit](const Batch& done) -> Values {
    const double a = done.integral(neubelt).specular.g, b = done.integral(fit).specular.g;
    return {{"value", {a}}, {"V_Neubelt", {a}}, {"V_CharlieFit", {b}}};
  };
}

Finish materialColors(const EvaluationRequest& request, Batch& batch) {
  const auto base = vectorOf(request, "baseColor", 3);
  ProbePoint p;
  p.a = {base[0], base[1], base[2], number(request, "metallic")};
  p.b.x = static_cast<float>(number(request, "specular"));
  const size_t F0 = batch.point("vec4(withColors(s, a.xyz, a.w, b.x).F0, 0.0)", p);
  const size_t diffuse = batch.point("vec4(withColors(s, a.xyz, a.w, b.x).diffuseColor, 0.0)", p);
  return [F0, diffuse](const Batch& done) -> Values {
    const glm::dvec4 f = done.pointValue(F0), d = done.pointValue(diffuse);
    return {{"value", {f.x}}, {"F0", {f.x, f.y, f.z}}, {"diffuseColor", {d.x, d.y, d.z}}};
  };
}

using Handler = std::function<Finish(const EvaluationRequest&, const Library&, Batch&)>;
const std::map<std::string, Handler, std::less<>>& handlers() {
  const auto plain = [](Finish (*f)(const EvaluationRequest&, Batch&)) {
    return [f](const EvaluationRequest& r, const Library&, Batch& b) { return f(r, b); };
  };
  static const std::map<std::string, Handler, std::less<>> table = {
      {"normalisation", plain(normalisation)},
      {"area_light", plain(areaLight)},
      {"environment_light", plain(environmentLight)},
      {"directional_albedo", plain(directionalAlbedo)},
      {"average_albedo", plain(averageAlbedo)},
      {"environment_brdf", environmentBrdf},
      {"exact_smith_G1", plain(exactSmithG1)},
      {"kulla_conty_f_ms", plain(kullaConty)},
      {"sheen_directional_albedo", plain(sheenAlbedo)},
      {"diffuse_directional_albedo", plain(diffuseAlbedo)},
      {"diffuse_brdf_rho1", diffuseBrdf},
      {"material_F0_diffuse", plain(materialColors)},
  };
  return table;
}

// What is said where a value is of the floor of alpha (shaders/common/shading.glsl) and not of the alpha asked for.
std::string noteOf(const EvaluationRequest& request, const ModelRegistry& registry) {
  constexpr double kSmallestAlpha = 5e-4;
  static const std::set<std::string, std::less<>> kOfPictures = {"normalisation", "directional_albedo", "average_albedo", "environment_brdf",
                                                                 "exact_smith_G1", "kulla_conty_f_ms", "sheen_directional_albedo"};
  const double alpha = hasRoughness(request) ? roughness(request) * roughness(request) : 1;
  if (alpha >= kSmallestAlpha * (1 - 1e-6)) return {};
  bool ofPictures = kOfPictures.count(request.what) != 0;
  if (request.what.starts_with("f_"))
    if (const auto model = registry.named(request.what.substr(2))) ofPictures = Batch::hasTables(**model, compensated(request));
  if (!ofPictures) return {};
  return fmt::format("is computed with alpha {:g} (roughness {:.4f}), the smallest that pictures have, instead of {:.4g}", kSmallestAlpha,
                     std::sqrt(kSmallestAlpha), alpha);
}

}  // namespace

std::vector<std::string> evaluationQuantities() {
  std::vector<std::string> names;
  for (const Formula& f : formulas()) names.emplace_back(f.name);
  for (const auto& [name, handler] : handlers()) names.push_back(name);
  return names;
}

std::vector<EvaluationResult> evaluate(std::span<const EvaluationRequest> asked, const ModelRegistry& registry) {
  std::vector<EvaluationRequest> requests;
  for (const EvaluationRequest& request : asked) requests.push_back(understood(request, registry));
  const Library library;
  Batch batch(registry);
  std::vector<EvaluationResult> results(requests.size());
  std::vector<Finish> finishes(requests.size());
  const auto guarded = [&](size_t i, const auto& work) {
    try {
      work();
    } catch (const EvaluationFault& fault) {
      results[i] = {{}, fault.what, fault.hint, {}};
    }
  };
  for (size_t i = 0; i < requests.size(); ++i)
    guarded(i, [&] {
      const auto handler = handlers().find(requests[i].what);
      finishes[i] = handler == handlers().end() ? termOrModel(requests[i], library, batch)
                                                : handler->second(requests[i], library, batch);
      results[i].note = noteOf(requests[i], registry);
    });
  batch.run();
  for (size_t i = 0; i < requests.size(); ++i)
    if (finishes[i])
      guarded(i, [&] {
        results[i].values = finishes[i](batch);
        for (const auto& [name, values] : results[i].values)
          for (const double v : values)
            if (!std::isfinite(v)) throw EvaluationFault{fmt::format("'{}' is not finite there", name), "the arguments may be out of range"};
      });
  for (EvaluationResult& r : results)
    if (!r.fault.empty()) r.values.clear();
  return results;
}

}  // namespace glint
