#include "renderer/model_probe.h"

#include <algorithm>
#include <cmath>

#include "materials/base/check.h"
#include "renderer/model_speed.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr int kGroup = 64;
constexpr size_t kBatch = size_t{1} << 18;
constexpr const char* kOwnAlpha = "#define OWN_ALPHA\n";  // of shaders/common/shading.glsl

// As the shader's `Point`, std430.
struct GpuPoint {
  glm::vec4 cosines, more, F0, diffuse, base, light, view, a, b;
};
static_assert(sizeof(GpuPoint) == 9 * 16);

constexpr const char* kPointGlsl = R"(
struct Point { vec4 cosines, more, F0, diffuse, base, light, view, a, b; };
layout(std430, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, binding = 1) writeonly buffer Values { vec4 values[]; };
uniform int pointCount;
uniform vec4 standardParameters;

Shading shadingAt(Point p) {
  Shading s;
  setDirections(s, vec3(0.0, 0.0, 1.0), p.view.xyz, p.light.xyz);
  s.T = vec3(1.0, 0.0, 0.0);
  s.B = vec3(0.0, 1.0, 0.0);
  if (p.view.w == 0.0) {
    s.NoL = p.cosines.x;
    s.NoV = p.cosines.y;
    s.NoH = p.cosines.z;
    s.VoH = p.cosines.w;
    s.LoV = p.more.x;
    s.sinH2 = p.more.y;
  }
  setRoughness(s, p.more.z);
  s.F0 = p.F0.xyz;
  s.diffuseColor = p.diffuse.xyz;
  s.baseColor = p.base.xyz;
  s.metallic = p.F0.w;
  s.specular = p.diffuse.w;
  s.analyticLight = (int(p.more.w) & 1) != 0;
  s.plainNonmetal = (int(p.more.w) & 2) != 0;
  return s;
}
)";

// Of a model, between the point and the outputs.
constexpr const char* kPrepareGlsl = R"(
  Parameters p = modelParameters(points[i].b.w != 0.0 ? a : standardParameters);
  if (points[i].base.w != 0.0) {
    setColors(s, s.baseColor, s.metallic, s.specular);
    modelColors(s, p);
  }
  modelTurn(s, p);
  modelPrepare(s, p);
)";

GpuPoint pack(const ProbePoint& p) {
  return {{p.NoL, p.NoV, p.NoH, p.VoH},
          {p.LoV, p.sinH2, p.roughness, static_cast<float>((p.analyticLight ? 1 : 0) | (p.plainNonmetal ? 2 : 0))},
          {p.F0, p.metallic},
          {p.diffuseColor, p.specular},
          {p.baseColor, p.fromAttributes ? 1.f : 0.f},
          {p.light, static_cast<float>(p.choice)},
          {p.view, p.fromDirections ? 1.f : 0.f},
          p.a,
          p.ownParameters ? glm::vec4(0, 0, 0, 1) : p.b};
}

}  // namespace

ProbePoint ProbePoint::at(glm::dvec3 light, glm::dvec3 view) {
  const glm::dvec3 sum = light + view;
  const glm::dvec3 half = glm::dot(sum, sum) > 1e-24 ? glm::normalize(sum) : glm::dvec3(0, 0, 1);
  ProbePoint p;
  p.light = light;
  p.view = view;
  p.NoL = static_cast<float>(light.z);
  p.NoV = static_cast<float>(view.z);
  p.NoH = static_cast<float>(half.z);
  p.VoH = static_cast<float>(std::max(glm::dot(view, half), 0.0));
  p.LoV = static_cast<float>(glm::dot(light, view));
  p.sinH2 = static_cast<float>(half.x * half.x + half.y * half.y);
  return p;
}

ProbePoint ProbePoint::cosines(double NoL, double NoV, double NoH, double VoH) {
  const double LoV = 2 * VoH * VoH - 1;
  const double sinL = std::sqrt(std::max(0.0, 1 - NoL * NoL)), sinV = std::sqrt(std::max(0.0, 1 - NoV * NoV));
  const double across = sinL * sinV > 0 ? std::clamp((LoV - NoL * NoV) / (sinL * sinV), -1.0, 1.0) : 1.0;
  ProbePoint p;
  p.view = glm::dvec3(sinV, 0, NoV);
  p.light = glm::dvec3(sinL * across, sinL * std::sqrt(1 - across * across), NoL);
  p.NoL = static_cast<float>(NoL);
  p.NoV = static_cast<float>(NoV);
  p.NoH = static_cast<float>(NoH);
  p.VoH = static_cast<float>(VoH);
  p.LoV = static_cast<float>(LoV);
  p.sinH2 = static_cast<float>((1 - NoH) * (1 + NoH));
  return p;
}

Result<ModelProbe> ModelProbe::build(const std::string& name, const std::string& glsl,
                                     const std::vector<std::string>& outputs, const std::string& defines) {
  const auto shading = shipped::read("shaders/common/shading.glsl");
  if (!shading) return error("shaders/common/shading.glsl", "is missing");
  std::string source = "#version 450 core\n" + defines + "layout(local_size_x = " + std::to_string(kGroup) + ") in;\n" + *shading +
                       glsl + kPointGlsl + "void main() {\n  uint i = gl_GlobalInvocationID.x;\n" +
                       "  if (i >= uint(pointCount)) return;\n  Shading s = shadingAt(points[i]);\n" +
                       "  vec4 a = points[i].a, b = points[i].b;\n" +
                       (glsl.find("modelParameters") != glsl.npos ? kPrepareGlsl : "");
  for (size_t k = 0; k < outputs.size(); ++k)
    source += fmt::format("  values[i * {}u + {}u] = {};\n", outputs.size(), k, outputs[k]);
  source += "}\n";
  auto program = gl::buildProgram(name, {{GL_COMPUTE_SHADER, source}});
  if (!program) return program.diagnostics();
  ModelProbe probe;
  probe.program_ = std::move(*program);
  probe.outputs_ = static_cast<int>(outputs.size());
  return probe;
}

Result<ModelProbe> ModelProbe::ofTerms(std::span<const Term> terms) {
  std::vector<std::string> outputs;
  for (const Term& term : terms) {
    const bool colour = term.kind == TermKind::F || term.kind == TermKind::Diffuse;
    std::string arguments = "s";
    GLINT_CHECK(term.parameters.size() <= 4, "{} has {} parameters", term.function(), term.parameters.size());
    if (term.ofOwnD) arguments += ", ProjectedAreas(a.x, a.y)";
    for (size_t i = 0; i < term.parameters.size(); ++i) arguments += std::string(", a.") + "xyzw"[i];
    outputs.push_back(fmt::format("vec4({}({}), {})", term.function(), arguments, colour ? "0.0" : "0.0, 0.0, 0.0"));
  }
  return build("terms", termsGlsl(), outputs);
}

Result<ModelProbe> ModelProbe::ofChoices(const std::vector<std::string>& expressions) {
  std::string glsl = termsGlsl() + R"(
// For expressions: a Shading with something else in it.
Shading withAlpha(Shading s, float alpha) {
  s.alpha = alpha;
  s.alpha2 = alpha * alpha;
  return s;
}
Shading withColors(Shading s, vec3 baseColor, float metallic, float specular) {
  setColors(s, baseColor, metallic, specular);
  return s;
}
vec4 chosen(int choice, Shading s, vec4 a, vec4 b) {
)";
  for (size_t i = 0; i < expressions.size(); ++i) glsl += fmt::format("  if (choice == {}) return {};\n", i, expressions[i]);
  return build("expressions", glsl + "  return vec4(0.0);\n}\n", {"chosen(int(points[i].light.w), s, a, b)"}, kOwnAlpha);
}

Result<ModelProbe> ModelProbe::ofModel(const ShadingModel& model, std::optional<bool> compensate, bool ownAlpha) {
  return ofOutputs(model, {"vec4(modelSpecular(s, p), modelD(s, p))", "vec4(modelDiffuse(s, p), dot(modelScattered(s, p), vec3(1.0)))"},
                 compensate.value_or(model.compensate), ownAlpha);
}

Result<ModelProbe> ModelProbe::ofEnvironment(const ShadingModel& model) { return ofOutputs(model, {"vec4(modelEnvironment(s, p), 0.0)"}, false); }

Result<ModelProbe> ModelProbe::ofHooks(const ShadingModel& model) {
  return ofOutputs(model, {"vec4(s.F0, 0.0)", "vec4(s.diffuseColor, 0.0)", "vec4(modelEnvironment(s, p), 0.0)", "vec4(modelScattered(s, p), 0.0)",
                         model.definesCoat ? "vec4(modelCoat(s, p), 0.0)" : "vec4(0.0)", model.definesCoat ? "vec4(modelThroughCoat(s, p), 0.0)" : "vec4(0.0)"}, false);
}

Result<ModelProbe> ModelProbe::ofLoops(const ShadingModel& model) {
  return ofOutputs(model, {"vec4(modelSpecular(s, p), 0.0)", "vec4(modelDiffuse(s, p), 0.0)", "vec4(modelEnvironment(s, p), 0.0)", "vec4(modelScattered(s, p), 0.0)",
                         "vec4(float(glintLongLoop))"}, false);
}

Result<ModelProbe> ModelProbe::ofModelParts(const ShadingModel& model, std::optional<bool> compensate) {
  return ofOutputs(model, {"vec4(modelSpecular(s, p), modelD(s, p))", "vec4(modelDiffuse(s, p), modelV(s, p))",
                         "vec4(modelF(s, p), 0.0)", "vec4(modelScattered(s, p), 0.0)"}, compensate.value_or(model.compensate));
}

Result<ModelProbe> ModelProbe::ofOutputs(const ShadingModel& model, const std::vector<std::string>& outputs, bool compensate, bool ownAlpha) {
  ModelSetting setting = modelSetting(model);
  auto probe = build(model.file.string(), (compensate ? "#define COMPENSATE\n" : "") + setting.shader->glsl, outputs, ownAlpha ? kOwnAlpha : "");
  if (!probe) return modelErrors(model, probe.diagnostics()[0].what);
  probe->setting_ = std::move(setting);
  probe->tables_ = std::make_unique<ModelTables>();
  if (Diagnostics faults = probe->tables_->apply(probe->setting_, probe->program_); !faults.empty()) return faults;
  const auto fault = faultOfSpeed(model, [&](int count) { probe->evaluate(std::vector<ProbePoint>(static_cast<size_t>(count), ProbePoint::at({0.6, 0, 0.8}, {0, 0.6, 0.8}))); });
  if (fault) return *fault;
  return probe;
}

void ModelProbe::set(const std::string& name, const Value& value) { setting_.set(name, value); }

std::vector<glm::vec4> ModelProbe::evaluate(std::span<const ProbePoint> points) const {
  if (tables_) {
    const Diagnostics faults = tables_->apply(setting_, program_);
    GLINT_CHECK(faults.empty(), "{}", faults[0].text());
  }
  return run(points);
}

std::vector<glm::vec4> ModelProbe::evaluate(std::span<const ProbePoint> points, std::span<const glm::vec4> constants) const {
  const Diagnostics faults = tables_->apply(setting_, program_);
  GLINT_CHECK(faults.empty() && constants.size() == setting_.constants.size(), "{} constants", constants.size());
  program_.set4("glintModelConstants", &constants[0].x, static_cast<int>(constants.size()));
  return run(points);
}

std::vector<glm::vec4> ModelProbe::run(std::span<const ProbePoint> points) const {
  std::vector<glm::vec4> values;
  values.reserve(points.size() * static_cast<size_t>(outputs_));
  for (size_t begin = 0; begin < points.size(); begin += kBatch) {
    const auto batch = points.subspan(begin, std::min(kBatch, points.size() - begin));
    std::vector<GpuPoint> packed(batch.size());
    std::transform(batch.begin(), batch.end(), packed.begin(), pack);
    std::vector<glm::vec4> part(batch.size() * static_cast<size_t>(outputs_));
    const gl::Buffer in = gl::createBuffer(std::as_bytes(std::span(packed)));
    const gl::Buffer out = gl::createBuffer(std::as_bytes(std::span(part)));
    program_.use();
    program_.set("pointCount", static_cast<int>(batch.size()));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, in.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, out.id());
    glDispatchCompute(static_cast<GLuint>((batch.size() + kGroup - 1) / kGroup), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(part.size() * sizeof(glm::vec4)), part.data());
    values.insert(values.end(), part.begin(), part.end());
  }
  return values;
}

}  // namespace glint
