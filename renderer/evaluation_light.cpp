#include "renderer/evaluation_light.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "materials/model_file.h"
#include "renderer/environment.h"
#include "renderer/evaluation_arguments.h"

namespace glint::evaluation {
namespace {

// White, the share of Fresnel alone, and a nonmetal: one channel each.
const glm::vec3 kReflectances(1, 0, 0.04f);

template <class T>
T valueOf(const Result<T>& result) {
  if (!result) throw EvaluationFault{result.diagnostics()[0].what, result.diagnostics()[0].hint};
  return *result;
}

using NamedModels = std::vector<std::pair<std::string, ModelPtr>>;
NamedModels modelsOf(const EvaluationRequest& request, const Batch& batch, std::initializer_list<const char*> otherwise) {
  NamedModels models;
  const auto add = [&](const std::string& name, const std::string& id) {
    const auto model = batch.registry().get(id);
    if (!model) throw EvaluationFault{model.diagnostics()[0].what, model.diagnostics()[0].hint};
    models.emplace_back(name, *model);
  };
  for (const auto& [name, id] : request.models) add(name, id);
  if (models.empty())
    for (const char* name : otherwise) add(name, name);
  return models;
}

glm::dvec3 place(const EvaluationRequest& request, std::string_view name) {
  const auto v = vectorOf(request, name, 3);
  return {v[0], v[1], v[2]};
}

ReferenceProbe::Point pointOf(const EvaluationRequest& request) {
  ReferenceProbe::Point point;
  point.view = glm::normalize(place(request, "v"));
  point.roughness = roughness(request);
  point.F0 = kReflectances;
  return point;
}

// Without a window, and without eq. 9's constant.
Light lightOf(const EvaluationRequest& request) {
  Light light{.candela = 1, .radius = 1e15f, .constant = 0};
  light.size = static_cast<float>(number(request, "radius"));
  if (request.vectors.count("L0")) {
    const glm::dvec3 from = place(request, "L0"), to = place(request, "L1");
    light.kind = LightKind::Tube;
    light.position = glm::vec3(0.5 * (from + to));
    light.length = static_cast<float>(glm::length(to - from));
    if (!(light.length > 0)) throw EvaluationFault{"the tube has no length", "L0 and L1 are its ends"};
    light.axis = glm::vec3((to - from) / glm::length(to - from));
  } else {
    light.kind = LightKind::Sphere;
    light.position = glm::vec3(place(request, "center"));
  }
  if (glm::length(light.position) < 1e-6f) throw EvaluationFault{"the light is where the point is", "the point is at the origin"};
  return light;
}

void put(Values& values, const std::string& name, const glm::dvec3& v) {
  values[name + ".white"] = {v.x};
  values[name + ".fc"] = {v.y};
  values[name + ".F0_0p04"] = {v.z};
}

// f of an average over the directions that a GGX's half vectors reflect, with or without the cosine as a weight.
ModelSetting averageOf(bool weighted) {
  const std::string text = fmt::format(
      "/*glint\n{{\"id\": \"average\", \"title\": \"Average\", \"doc\": \"A GGX lobe\", \"color\": [1, 1, 1]}}\n*/\n"
      "vec3 specular(Shading s, Parameters p) {{ return vec3(D_GGX(s) * s.NoH / (4.0 * max(s.VoH, 1e-4){})); }}\n", weighted ? "" : " * s.NoL");
  Diagnostics warnings;
  const auto model = readModel("average.glsl", text, warnings);
  GLINT_CHECK(model.ok(), "{}", model.diagnostics()[0].text());
  return modelSetting(*model);
}

ImageF pictureOf(const EnvironmentFormula& formula) {
  constexpr int kWidth = 2048;   // texels of 0.18 degrees: a bilinear lookup is 1e-4 off for lobes of sharpness 60
  ImageF image(kWidth, kWidth / 2, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::dvec3 d(environmentDirection(x, y, image.width, image.height));
      double radiance = formula.constant + glm::dot(formula.linear, d);
      for (const EnvironmentFormula::Lobe& lobe : formula.lobes) radiance += lobe.amplitude * std::exp(lobe.sharpness * (glm::dot(d, lobe.axis) - 1));
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(std::max(radiance, 0.0));
    }
  return image;
}

}  // namespace

Finish areaLight(const EvaluationRequest& request, Batch& batch) {
  const Light light = lightOf(request);
  const auto point = pointOf(request);
  const NamedModels models = modelsOf(request, batch, {"ggx_smith_corr", "ue4_2013"});
  return [=](const Batch& done) {
    using Probe = ReferenceProbe;
    static const std::vector<std::pair<Probe::Approximation, const char*>> kOfSpheres = {
        {Probe::CenterPoint, "point"}, {Probe::SpecularD, "specD_eq10"}, {Probe::Plain, "rp_no_norm"}, {Probe::Factor3, "rp_eq14"},
        {Probe::Factor2, "rp_eq14_factor2"}, {Probe::OwnCosine, "rp_eq14_cos_rep"}, {Probe::AsPrinted, "rp_eq11_as_printed"}};
    static const std::vector<std::pair<Probe::Approximation, const char*>> kOfTubes = {
        {Probe::CenterPoint, "point"}, {Probe::Plain, "rp_no_norm"}, {Probe::Factor3, "rp_len3"}, {Probe::Factor2, "rp_len2_ue4"},
        {Probe::HalfLength, "rp_halflen3"}, {Probe::SmallestAngle, "rp_len3_eq18"}};
    Probe& probe = done.reference();
    Values values{{"reference.irradiance", {valueOf(probe.irradiance(light, point))}}};
    for (const auto& [name, model] : models) {
      const ModelSetting setting = modelSetting(*model);
      put(values, "reference." + name, valueOf(probe.light(setting, light, point)));
      const auto all = valueOf(probe.approximations(setting, light, point));
      for (const auto& [which, variant] : light.kind == LightKind::Tube ? kOfTubes : kOfSpheres) put(values, "approx." + name + "." + variant, all[which]);
    }
    return values;
  };
}

Finish environmentLight(const EvaluationRequest& request, Batch& batch) {
  if (!request.environment) throw EvaluationFault{"no environment of that name is described", "\"environments\" of the file describes each"};
  const auto point = pointOf(request);
  const NamedModels models =
      modelsOf(request, batch, {"ue4_ibl", "thesis_ggx", "ggx_smith", "ggx_smith_corr", "thesis_blinn", "thesis_cook", "thesis_burley"});
  std::vector<Batch::ModelTicket> albedos;
  for (const auto& [name, model] : models)
    albedos.push_back(batch.integral(model->id, {static_cast<float>(point.roughness), static_cast<float>(point.view.z), false}, {}));
  return [=, formula = request.environment](const Batch& done) {
    ReferenceProbe& probe = done.reference();
    const EnvironmentSampler& sampler = done.environment(*formula, [&] { return pictureOf(*formula); });
    Values values;
    // Karis' listing has the normal and the viewer along the reflected ray.
    ReferenceProbe::Point mirror = point;
    mirror.normal = mirror.view = glm::dvec3(-point.view.x, -point.view.y, point.view.z);
    double sums[2][2];   // n = v = r, unweighted
    for (const bool weighted : {true, false}) {
      const ModelSetting average = averageOf(weighted);
      for (const bool ofMirror : {false, true}) {
        const auto& at = ofMirror ? mirror : point;
        const double light = valueOf(probe.environment(average, &sampler, at)).x, white = valueOf(probe.environment(average, nullptr, at)).x;
        sums[ofMirror][!weighted] = light / white;
        if (!weighted && !ofMirror) values["sampling_mass_above_horizon"] = {white};
      }
    }
    values["first_sum_true_v_NoL_weighted"] = {sums[0][0]};
    values["first_sum_true_v_unweighted"] = {sums[0][1]};
    values["prefiltered_n_v_r"] = {sums[1][0]};
    values["prefiltered_n_v_r_unweighted"] = {sums[1][1]};
    for (size_t i = 0; i < models.size(); ++i) {
      const std::string of = "models." + models[i].first + ".";
      const glm::dvec3 exact = valueOf(probe.environment(modelSetting(*models[i].second), &sampler, point));
      values[of + "exact_white"] = {exact.x};
      values[of + "exact_Fc"] = {exact.y};
      values[of + "exact_F0_0p04"] = {exact.z};
      const ModelIntegral& albedo = done.integral(albedos[i]);
      const double A = albedo.specular.g - albedo.specularBlack.g, B = albedo.specularBlack.g;
      values[of + "A"] = {A};
      values[of + "B"] = {B};
      for (const bool ofMirror : {false, true})
        for (const bool unweighted : {false, true}) {
          const std::string split = of + (ofMirror ? "split_n_v_r" : "split_exact") + (unweighted ? "_unweighted." : ".");
          values[split + "white"] = {sums[ofMirror][unweighted] * (A + B)};
          values[split + "F0_0p04"] = {sums[ofMirror][unweighted] * (0.04 * A + B)};
        }
    }
    return values;
  };
}

}  // namespace glint::evaluation
