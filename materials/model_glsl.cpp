// What Glint writes around a plugin's text, and the way back from a driver's complaints to its lines.
#include <algorithm>
#include <charconv>

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
  else if (!term.empty())
    text += fmt::format("{} {}(Shading s, Parameters p) {{ return {}{}(s); }}\n", type, name, prefix(kind), term);
}

struct LogLine {
  int line = 0;
  bool isError = false;
  std::string message;
};

bool takeNumber(std::string_view& text, int& number) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc()) return false;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return true;
}

bool takeText(std::string_view& text, std::string_view wanted) {
  if (!text.starts_with(wanted)) return false;
  text.remove_prefix(wanted.size());
  return true;
}

void skipSpaces(std::string_view& text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
}

// "0:12(5): error: what" (Mesa), "0(12) : error C1008: what" (NVIDIA), "ERROR: 0:12: what" (others).
LogLine readLogLine(std::string_view text) {
  LogLine result;
  skipSpaces(text);
  std::string_view rest = text;
  const bool shouts = takeText(rest, "ERROR: ");
  if (!shouts && takeText(rest, "WARNING: ")) {
  }
  int source = 0, column = 0;
  bool placed = takeNumber(rest, source);
  if (placed && takeText(rest, ":")) {
    placed = takeNumber(rest, result.line);
    std::string_view after = rest;
    if (takeText(after, "(") && takeNumber(after, column) && takeText(after, ")")) rest = after;
  } else if (placed && takeText(rest, "(")) {
    placed = takeNumber(rest, result.line) && takeText(rest, ")");
  } else {
    placed = false;
  }
  if (!placed) {
    result.line = 0;
    rest = text;
  }
  skipSpaces(rest);
  if (placed) takeText(rest, ":");
  skipSpaces(rest);
  result.isError = shouts;
  if (takeText(rest, "error")) {
    result.isError = true;
    if (const size_t colon = rest.find(':'); colon != rest.npos && colon < 10) rest.remove_prefix(colon + 1);
    skipSpaces(rest);
  }
  result.message = std::string(rest);
  return result;
}

}  // namespace

std::string modelGlsl(const ShadingModel& model, int sourceIndex) {
  std::string text = "// The terms of shaders/terms/.\n" + termsGlsl() + "// The model '" + model.id + "'.\n" +
                     parametersGlsl(model);
  const bool hasD = model.definesD || !model.termD.empty();
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
  text += fmt::format("const bool modelHasD = {};\n", hasD);
  text += fmt::format("float modelD(Shading s, Parameters p) {{ return {}; }}\n", hasD ? "D(s, p)" : "0.0");
  // The scalars first: D * V is one product before the colour comes in.
  text += fmt::format("vec3 modelSpecular(Shading s, Parameters p) {{ return {}; }}\n",
                      model.definesSpecular ? "specular(s, p)" : "(D(s, p) * V(s, p)) * F(s, p)");
  text += "vec3 modelDiffuse(Shading s, Parameters p) { return diffuse(s, p); }\n";
  return text;
}

Diagnostics modelErrors(const ShadingModel& model, const std::string& driverLog) {
  const int lines = 1 + static_cast<int>(std::count(model.source.begin(), model.source.end(), '\n'));
  Diagnostics errors, others;
  for (size_t begin = 0; begin < driverLog.size() && errors.size() < 20;) {
    const size_t end = std::min(driverLog.find('\n', begin), driverLog.size());
    const LogLine line = readLogLine(std::string_view(driverLog).substr(begin, end - begin));
    begin = end + 1;
    if (line.message.empty()) continue;
    const int own = line.line - kModelLineBase;
    const std::string place =
        own >= 1 ? fmt::format("{}:{}", model.file.string(), std::min(own, lines))
                 : fmt::format("{} (generated{})", model.file.string(),
                               line.line ? fmt::format(", line {}", line.line) : std::string());
    (line.isError ? errors : others).push_back(error(place, line.message));
  }
  if (!errors.empty()) return errors;
  if (!others.empty()) return others;
  return {error(model.file.string() + " (generated)", "the driver refused the shader and did not say why")};
}

}  // namespace glint
