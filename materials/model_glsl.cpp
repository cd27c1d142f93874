// What Glint writes around a plugin's text.
#include <algorithm>

#include "materials/base/check.h"
#include "materials/glsl_loops.h"
#include "materials/glsl_scan.h"
#include "materials/model.h"
#include "materials/terms.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

std::string_view memberType(ValueType type) { return glslName(type); }

// The expression for a parameter from `vector`, its components from `first`.
std::string fromVector(ValueType type, const std::string& vector, int first) {
  const std::string part =
      vector + "." + std::string("xyzw").substr(static_cast<size_t>(first), static_cast<size_t>(componentCount(type)));
  if (type == ValueType::Bool) return part + " > 0.5";
  if (type == ValueType::Int) return "int(floor(" + part + " + 0.5))";
  return part;
}

std::string memberName(const ShadingModel& model, const ModelParameter& p) {
  return p.fileName.empty() ? p.name : model.namePrefix + p.fileName;
}

std::string parametersGlsl(const ShadingModel& model) {
  std::string members, reads;
  int constants = 0;
  for (const ModelParameter& p : model.parameters) {
    members += fmt::format("  {} {};\n", memberType(p.standard.type), memberName(model, p));
    const std::string from = p.slot >= 0
                                 ? fromVector(p.standard.type, "slots", p.slot)
                                 : fromVector(p.standard.type, fmt::format("glintModelConstants[{}]", constants++), 0);
    reads += fmt::format("  p.{} = {};\n", memberName(model, p), from);
  }
  for (const std::string& name : model.prepared) {
    members += "  float " + name + ";\n";
    reads += "  p." + name + " = 0.0;\n";
  }
  if (members.empty()) {
    members = "  float glintNone;\n";
    reads = "  p.glintNone = 0.0;\n";
  }
  members += "#ifdef COMPENSATE\n  GlintBounces glintBounces;\n#endif\n";
  return fmt::format(
      "struct Parameters {{\n{}}};\n"
      "uniform vec4 glintModelConstants[{}];\n"
      "Parameters modelParameters(vec4 slots) {{\n  Parameters p;\n{}  return p;\n}}\n",
      members, std::max(constants, 1), reads);
}

// `float D(Shading s, Parameters p)`: a promise when the plugin defines it, the shipped term when it names it.
void entry(std::string& text, std::string_view type, std::string_view name, bool defined, TermKind kind,
           const std::string& term) {
  if (defined)
    text += fmt::format("{} {}(Shading s, Parameters p);\n", type, name);
  else if (!term.empty()) {
    std::string arguments = "s";
    if (const auto found = findTerm(kind, term))
      for (const TermParameter& p : found->parameters) arguments += ", p." + p.name;
    text += fmt::format("{} {}(Shading s, Parameters p) {{ return {}{}({}); }}\n", type, name, prefix(kind), term, arguments);
  }
}

// The tables that Glint derives from the model, and the terms that are looked up in them.
std::string tablesGlsl(const ShadingModel& model) {
  constexpr const char* kFile = "shaders/common/model_tables.glsl";
  const auto file = shipped::read(kFile);
  GLINT_CHECK(file.has_value(), "{} is not among the shipped files", kFile);
  std::string text = (model.usesTangent ? "#define MODEL_TANGENT\n" : "") + std::string(model.smithOfOwnD ? "#define GLINT_SMITH_OF_OWN_D\n" : "") + *file;
  if (model.smithOfOwnD)
    for (const Term& term : terms())
      if (term.ofOwnD)
        text += fmt::format("float {0}(Shading s) {{ return {0}(s, glintProjectedAreas(s)); }}\n", term.function());
  return text;
}

}  // namespace

std::string modelGlsl(const ShadingModel& model, int sourceIndex) {
  std::string text = "// The terms of shaders/terms/.\n" + termsGlsl() + tablesGlsl(model) + "// The model '" + model.id + "'.\n" +
                     parametersGlsl(model);
  entry(text, "float", "D", model.definesD, TermKind::D, model.termD);
  // A G of the head is the V of that name: the library holds G / (4 NoL NoV) without its 0/0.
  entry(text, "float", "V", model.definesV, TermKind::V, model.termV.empty() ? model.termG : model.termV);
  entry(text, "vec3", "F", model.definesF, TermKind::F, model.termF);
  entry(text, "vec3", "diffuse", model.definesDiffuse, TermKind::Diffuse, model.termDiffuse);
  if (model.definesSpecular) entry(text, "vec3", "specular", true, TermKind::F, "");
  for (const auto& [defined, prototype] :
       {std::pair{model.definesPrepare, "void prepare(Shading s, inout Parameters p)"}, {model.definesColors, "void colors(inout Shading s, Parameters p)"},
        {model.definesCoat, "vec3 coat(Shading s, Parameters p)"}, {model.definesThroughCoat, "vec3 throughCoat(Shading s, Parameters p)"},
        {model.definesEnvironment, "vec3 environment(Shading s, Parameters p)"}, {model.definesScattered, "vec3 scattered(Shading s, Parameters p)"}})
    if (defined) text += std::string(prototype) + ";\n";
  const auto bounded = withBoundedLoops(model.source, "glintTurn");
  if (bounded)
    text += fmt::format("int glintTurns = 0, glintLongLoop = 0;\nbool glintTurn(int line) {{\n  if (++glintTurns <= {}) return false;\n"
                        "  if (glintLongLoop == 0) glintLongLoop = line;\n  return true;\n}}\n", kMostTurns);
  text += fmt::format("#line {} {}\n", kModelLineBase + 1, sourceIndex);
  text += bounded ? *bounded : model.source;
  text += fmt::format("\n\n#line 1 {}\n", sourceIndex + 1);
  for (const std::string& macro : scanGlsl(model.source).macros) text += "#undef " + macro + "\n";
  text += fmt::format("void modelPrepare(Shading s, inout Parameters p) {{\n{}{}#ifdef COMPENSATE\n"
                      "  p.glintBounces = glintBouncesTowards(s);\n#endif\n}}\n",
                      bounded ? "  glintTurns = 0;\n" : "", model.definesPrepare ? "  prepare(s, p);\n" : "");
  text += fmt::format("const bool modelHasD = {}, modelHasParts = {};\n", model.hasD(), model.hasD() && model.hasV() && model.hasF() && !model.definesCoat);
  const auto function = [&](std::string_view type, std::string_view name, std::string body) {
    if (const std::string_view value = body; bounded && value.starts_with("return "))
      body = fmt::format("glintTurns = 0; {0} x = {1} return glintTurns > {2} ? {0}(uintBitsToFloat(0x7fc00000u)) : x;", type, value.substr(7), kMostTurns);
    text += fmt::format("{} {}(Shading s, Parameters p) {{ {} }}\n", type, name, body);
  };
  const auto vectorFunction = [&](std::string_view name, const std::string& body) { function("vec3", name, body); };
  function("float", "modelD", model.hasD() ? "return D(s, p);" : "return 0.0;");
  function("float", "modelV", model.hasV() ? "return V(s, p);" : "return 0.0;");
  vectorFunction("modelF", model.hasF() ? "return F(s, p);" : "return vec3(0.0);");
  // The scalars first: D * V is one product before the colour comes in.
  vectorFunction("modelBase", model.definesSpecular ? "return specular(s, p);" : "return (D(s, p) * V(s, p)) * F(s, p);");
  vectorFunction("modelDiffuseBelow", "return diffuse(s, p);");
  text += fmt::format("void modelColors(inout Shading s, Parameters p) {{{}}}\n", model.definesColors ? " colors(s, p); " : "");
  text += fmt::format("void modelTurn(inout Shading s, Parameters p) {{{}}}\n",
                      model.tangentRotation.empty() ? "" : fmt::format(" turnTangent(s, radians(p.{})); ", model.tangentRotation));
  if (model.definesCoat) {
    text += "#define MODEL_COAT\n";
    text += fmt::format("float modelCoatRoughness(Parameters p) {{ return p.{}; }}\n", model.coatRoughness);
    text += fmt::format("vec3 modelCoatStrength(Parameters p) {{ return vec3(p.{}); }}\n", model.coatStrength);
    vectorFunction("modelThroughCoat", model.definesThroughCoat ? "return throughCoat(s, p);" : "return vec3(1.0);");
    text += "Shading glintOfCoat(Shading s, Parameters p) { setRoughness(s, modelCoatRoughness(p)); return s; }\n";
    vectorFunction("modelCoat", "return coat(glintOfCoat(s, p), p);");
    vectorFunction("modelSingleBounce", "return modelThroughCoat(s, p) * modelBase(s, p) + modelCoatStrength(p) * modelCoat(s, p);");
    vectorFunction("modelDiffuse", "return modelThroughCoat(s, p) * diffuse(s, p);");
    text += "#ifdef COAT\n";
    vectorFunction("modelLobe", "return coat(s, p);");
    text += "#else\n";
    vectorFunction("modelLobe", "return modelBase(s, p);");
    text += "#endif\n";
  } else {
    for (const char* name : {"modelSingleBounce", "modelLobe"}) vectorFunction(name, "return modelBase(s, p);");
    vectorFunction("modelDiffuse", "return diffuse(s, p);");
  }
  vectorFunction("modelSpecular", "\n#ifdef COMPENSATE\n  return modelSingleBounce(s, p) + glintFurtherBounces(s, p.glintBounces);\n"
                                  "#else\n  return modelSingleBounce(s, p);\n#endif\n");
  vectorFunction("modelLobeWhite", model.definesSpecular ? "return modelLobe(s, p);" : "return vec3(D(s, p) * V(s, p));");
  vectorFunction("modelWhite", model.definesSpecular || model.definesCoat ? "return modelSingleBounce(s, p);" : "return vec3(D(s, p) * V(s, p));");
  text += fmt::format("const bool modelHasEnvironment = {}, modelScatters = {};\n", model.definesEnvironment, model.definesScattered);
  vectorFunction("modelEnvironment", model.definesEnvironment ? "return environment(s, p);" : "return vec3(0.0);");
  vectorFunction("modelScattered", model.definesScattered ? "return scattered(s, p);" : "return vec3(0.0);");
  // BRDF Explorer draws what is negative as black, and plots it as it is.
  vectorFunction("modelLit", model.isWhole() ? "return dot(s.N, s.L) > 0.0 ? max(modelSpecular(s, p), 0.0) : vec3(0.0);" : "return modelDiffuse(s, p) + modelSpecular(s, p);");
  text += fmt::format("const bool modelReadsRoughness = {};\n{}", model.reads("roughness"), model.isWhole() ? "#define MODEL_IS_WHOLE\n" : "");
  return text;
}

}  // namespace glint
