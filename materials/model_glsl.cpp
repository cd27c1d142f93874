// What Glint writes around a plugin's text.
#include <algorithm>

#include "materials/glsl_scan.h"
#include "materials/model.h"
#include "materials/terms.h"

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

std::string parametersGlsl(const ShadingModel& model) {
  std::string members, reads;
  int constants = 0;
  for (const ModelParameter& p : model.parameters) {
    members += fmt::format("  {} {};\n", memberType(p.standard.type), p.name);
    const std::string from = p.slot >= 0
                                 ? fromVector(p.standard.type, "slots", p.slot)
                                 : fromVector(p.standard.type, fmt::format("glintModelConstants[{}]", constants++), 0);
    reads += fmt::format("  p.{} = {};\n", p.name, from);
  }
  for (const std::string& name : model.prepared) {
    members += "  float " + name + ";\n";
    reads += "  p." + name + " = 0.0;\n";
  }
  if (members.empty()) {
    members = "  float glintNone;\n";
    reads = "  p.glintNone = 0.0;\n";
  }
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

}  // namespace

std::string modelGlsl(const ShadingModel& model, int sourceIndex) {
  std::string text = "// The terms of shaders/terms/.\n" + termsGlsl() + "// The model '" + model.id + "'.\n" +
                     parametersGlsl(model);
  entry(text, "float", "D", model.definesD, TermKind::D, model.termD);
  // A G of the head is the V of that name: the library holds G / (4 NoL NoV) without its 0/0.
  entry(text, "float", "V", model.definesV, TermKind::V, model.termV.empty() ? model.termG : model.termV);
  entry(text, "vec3", "F", model.definesF, TermKind::F, model.termF);
  entry(text, "vec3", "diffuse", model.definesDiffuse, TermKind::Diffuse, model.termDiffuse);
  if (model.definesSpecular) entry(text, "vec3", "specular", true, TermKind::F, "");
  if (model.definesPrepare) text += "void prepare(Shading s, inout Parameters p);\n";
  text += fmt::format("#line {} {}\n", kModelLineBase + 1, sourceIndex);
  text += model.source;
  text += fmt::format("\n\n#line 1 {}\n", sourceIndex + 1);
  for (const std::string& macro : scanGlsl(model.source).macros) text += "#undef " + macro + "\n";
  text += fmt::format("void modelPrepare(Shading s, inout Parameters p) {{{}}}\n",
                      model.definesPrepare ? " prepare(s, p); " : "");
  text += fmt::format("const bool modelHasD = {};\n", model.hasD());
  text += fmt::format("float modelD(Shading s, Parameters p) {{ return {}; }}\n", model.hasD() ? "D(s, p)" : "0.0");
  text += fmt::format("float modelV(Shading s, Parameters p) {{ return {}; }}\n", model.hasV() ? "V(s, p)" : "0.0");
  text += fmt::format("vec3 modelF(Shading s, Parameters p) {{ return {}; }}\n", model.hasF() ? "F(s, p)" : "vec3(0.0)");
  // The scalars first: D * V is one product before the colour comes in.
  text += fmt::format("vec3 modelSpecular(Shading s, Parameters p) {{ return {}; }}\n",
                      model.definesSpecular ? "specular(s, p)" : "(D(s, p) * V(s, p)) * F(s, p)");
  text += "vec3 modelDiffuse(Shading s, Parameters p) { return diffuse(s, p); }\n";
  return text;
}

}  // namespace glint
