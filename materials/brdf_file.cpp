#include "materials/brdf_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "materials/attributes.h"
#include "materials/base/files.h"
#include "materials/base/hash.h"
#include "materials/glsl_namespace.h"
#include "materials/glsl_cost.h"
#include "materials/glsl_recursion.h"
#include "materials/glsl_scan.h"
#include "materials/path_guard.h"

namespace glint {
namespace fs = std::filesystem;
namespace {

// Stands before every name that a file chose. No underscore at its end: with one at a name's start they would be two,
// which GLSL keeps for itself.
constexpr const char* kPrefix = "bx0";
constexpr uintmax_t kLargestBrdf = 1 << 20;

// Names that BRDF Explorer's own shaders have, and its entry: a parameter of that name does not compile there.
constexpr std::string_view kHostNames[] = {
    "BRDF",       "sampleBRDF", "main",       "incidentVector", "incidentTheta", "incidentPhi",      "useNDotL",
    "useLogPlot", "colorMask",  "phiV",       "phiD",           "thetaH",        "thetaD",           "brightness",
    "gamma",      "exposure",   "showChroma", "totalSamples",   "stepSize",      "useThetaHSquared", "passNumber",
    "envCube",    "probTex",    "envRotMatrix"};

struct BrdfParameter {
  std::string name;
  ValueType type = ValueType::Float;
  float minimum = 0, maximum = 1;
  std::array<float, 4> value{};
  int line = 0;
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  const size_t begin = text.find_first_not_of(kSpace);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
}

std::vector<std::string> wordsOf(std::string_view line) {
  std::vector<std::string> words;
  for (std::string_view rest = trimmed(line); !rest.empty();) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\v\f"));
    words.emplace_back(word);
    rest = trimmed(rest.substr(word.size()));
  }
  return words;
}

std::optional<float> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  float value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// The lines of a file, sorted into its sections.
class BrdfReader {
 public:
  BrdfReader(const fs::path& path, std::string_view type) : file_(path.string()), type_(type) {}

  void read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
      const size_t end = text.find('\n');
      takeLine(text.substr(0, end));
      shader += '\n';
      text = end == text.npos ? std::string_view() : text.substr(end + 1);
    }
    if (line_ == 0) fault(1, "is empty", firstLineHint());
    if (!section_.empty()) fault(sectionLine_, fmt::format("section '{}' is never closed", section_), fmt::format("add ::end {}", section_));
  }

  std::vector<BrdfParameter> parameters;
  std::string shader;           // the lines of that section at their places, all others empty
  int shaderLine = 0;           // of its ::begin, 0 without one
  std::string named;            // what follows the type in the first line
  Diagnostics problems, warnings;

 private:
  std::string at(int line) const { return fmt::format("{}:{}", file_, line); }
  void fault(int line, std::string what, std::string hint) { problems.push_back(error(at(line), std::move(what), std::move(hint))); }
  std::string firstLineHint() const {
    return type_ == "analytic" ? "the first line of a .brdf is 'analytic'" : "the first line of a .bparam is 'bparam PATH', the path of a .brdf";
  }

  void takeLine(std::string_view line) {
    ++line_;
    const std::string_view words = trimmed(line);
    if (line_ == 1) return takeType(words);
    if (words.empty() || words[0] == '#') return;
    const std::vector<std::string> tokens = wordsOf(words);
    if (tokens[0] == "::begin") return begin(tokens);
    if (tokens[0] == "::end") return end(tokens);
    if (section_ == "parameters") return takeParameter(tokens);
    if (section_ == "shader") shader += line;
    else if (section_.empty() && std::exchange(outside_, true) == false)
      warnings.push_back(warning(at(line_), "text outside of all sections, which is left out", "put it between ::begin and ::end"));
  }

  void takeType(std::string_view words) {
    const std::string_view type = words.substr(0, words.find(' '));
    if (type != type_) fault(1, fmt::format("starts with '{}'", words.substr(0, 40)), firstLineHint());
    else if (type.size() < words.size()) named = trimmed(words.substr(type.size()));
  }

  void begin(const std::vector<std::string>& tokens) {
    const std::string name = tokens.size() > 1 ? tokens[1] : "";
    if (name.empty()) return fault(line_, "::begin names no section", "write ::begin parameters or ::begin shader");
    if (!section_.empty())
      fault(line_, fmt::format("section '{}' begins within '{}', which began on line {}", name, section_, sectionLine_), fmt::format("add ::end {} before it", section_));
    section_ = name;
    sectionLine_ = line_;
    if (name == "shader") {
      // The last one counts, as in BRDF Explorer.
      if (shaderLine) {
        warnings.push_back(warning(at(line_), fmt::format("a second shader; that of line {} is left out", shaderLine), "keep one of them"));
        for (char& c : shader)
          if (c != '\n') c = ' ';
      }
      shaderLine = line_;
    } else if (name != "parameters" && name != "isFunc") {
      warnings.push_back(warning(at(line_), fmt::format("unknown section '{}', which is left out", name), suggestion(name, {"parameters", "shader", "isFunc"})));
    }
  }

  void end(const std::vector<std::string>& tokens) {
    const std::string name = tokens.size() > 1 ? tokens[1] : "";
    if (section_.empty()) fault(line_, fmt::format("::end{} without its ::begin", name.empty() ? "" : " " + name), "remove it, or begin the section");
    else if (name != section_) fault(line_, fmt::format("::end {} in section '{}', which began on line {}", name, section_, sectionLine_), fmt::format("write ::end {}", section_));
    section_.clear();
  }

  void takeParameter(const std::vector<std::string>& tokens) {
    static const std::map<std::string, std::pair<ValueType, std::string>> kTypes = {
        {"float", {ValueType::Float, "float NAME MIN MAX DEFAULT"}}, {"bool", {ValueType::Bool, "bool NAME 0, or 1"}}, {"color", {ValueType::Color, "color NAME R G B"}}};
    const auto found = kTypes.find(tokens[0]);
    if (found == kTypes.end())
      return fault(line_, fmt::format("unknown type '{}' of a parameter", tokens[0].substr(0, 64)), suggestion(tokens[0], {"float", "bool", "color"}));
    const auto& [type, form] = found->second;
    const size_t values = type == ValueType::Bool ? 1 : 3;
    if (tokens.size() < 2) return fault(line_, "a parameter without a name", "write " + form);
    BrdfParameter p{.name = tokens[1], .type = type, .line = line_};
    const std::string what = fmt::format("parameter '{}'", p.name.substr(0, 64));
    const size_t before = problems.size();
    checkName(p.name, what);
    if (tokens.size() < 2 + values) {
      fault(line_, fmt::format("{} has {} of {} values", what, tokens.size() - 2, values), "write " + form);
      return;
    }
    std::array<float, 3> given{};
    for (size_t i = 0; i < values; ++i) {
      const std::string& word = tokens[2 + i];
      const auto value = number(word);
      const bool fits = value && (type != ValueType::Bool || word == "0" || word == "1");
      if (!fits) fault(line_, fmt::format("{}: '{}' is not {}", what, word.substr(0, 64), type == ValueType::Bool ? "0 or 1" : "a number"), "write " + form);
      given[i] = value.value_or(0.f);
    }
    if (problems.size() != before) return;
    if (type == ValueType::Float) {
      p.minimum = given[0];
      p.maximum = given[1];
      p.value = {given[2]};
      if (!(p.minimum < p.maximum))
        return fault(line_, fmt::format("{}: the range {}..{} is empty", what, p.minimum, p.maximum), "write " + form);
    } else {
      p.value = {given[0], given[1], given[2]};
    }
    const Value value{type, p.value};
    if (!inRange(value, p.minimum, p.maximum))
      return fault(line_, fmt::format("{}: the default {} is outside {}..{}", what, valueText(value), p.minimum, p.maximum), "widen the range or move the default");
    parameters.push_back(std::move(p));
    if (parameters.size() == kMostModelParameters + 1)
      fault(line_, fmt::format("more than {} parameters", kMostModelParameters), "make some of them constants of the shader");
  }

  void checkName(const std::string& name, const std::string& what) {
    if (const std::string wrong = faultOfParameterName(name); !wrong.empty()) fault(line_, fmt::format("{}: the name {}", what, wrong), "choose another");
    else if (std::find(std::begin(kHostNames), std::end(kHostNames), name) != std::end(kHostNames))
      fault(line_, fmt::format("{}: the name is reserved", what), "BRDF Explorer's own shaders have it: choose another");
    for (const BrdfParameter& other : parameters)
      if (other.name == name) fault(line_, fmt::format("a second parameter '{}'", name.substr(0, 64)), fmt::format("the first is on line {}", other.line));
  }

  std::string file_, type_, section_;
  int line_ = 0, sectionLine_ = 0;
  bool outside_ = false;
};

std::string uniqueName(const std::string& own, const std::vector<BrdfParameter>& all) {
  std::string name = "own" + own;
  name[3] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[3])));
  while (std::any_of(all.begin(), all.end(), [&](const BrdfParameter& p) { return p.name == name; })) name += '_';
  return name;
}

void addParameters(const std::vector<BrdfParameter>& parameters, ShadingModel& model) {
  int used = 0;
  for (const BrdfParameter& p : parameters) {
    ModelParameter made{.name = p.name, .title = p.name, .doc = {}, .standard = {p.type, p.value}, .minimum = p.minimum, .maximum = p.maximum, .fileName = p.name};
    if (findAttribute(p.name)) {
      made.name = uniqueName(p.name, parameters);
      made.doc = fmt::format("'{}' of the file, which does not read the attribute", p.name);
    }
    const int count = componentCount(p.type);
    if (used + count <= 4) {
      made.slot = used;
      used += count;
    }
    model.parameters.push_back(std::move(made));
  }
}

// The GLSL of the model: variables for the parameters on the first line, which is none of the shader's; the shader on its own
// lines; below them what Glint calls.
std::string sourceOf(const BrdfReader& brdf) {
  std::vector<std::string> names;
  std::string variables, values;
  for (const BrdfParameter& p : brdf.parameters) {
    names.push_back(p.name);
    variables += fmt::format("{} {}{} = {}; ", glslName(p.type), kPrefix, p.name, glslLiteral({p.type, p.value}));
    values += fmt::format("{0}{1} = p.{0}{1}; ", kPrefix, p.name);
  }
  const GlslNamespace own = inNamespace(brdf.shader, kPrefix, names);
  return variables + own.overloads + own.text +
         fmt::format("vec3 specular(Shading s, Parameters p) {{ {}{}return {}BRDF(s.L, s.V, s.N, s.T, s.B); }} "
                     "vec3 diffuse(Shading s, Parameters p) {{ return vec3(0.0); }}\n",
                     values, own.initialisers, kPrefix);
}

// Whether the last two of what BRDF() gets, the tangent and the bitangent, are used: then their names stand again.
bool usesTangent(const std::string& shader) {
  for (const GlslFunction& function : scanGlsl(shader).functions) {
    if (function.name != "BRDF") continue;
    for (size_t i = 3; i < function.parameterNames.size(); ++i) {
      const std::string& name = function.parameterNames[i];
      int count = 0;
      const auto isNamed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
      for (size_t at = shader.find(name); !name.empty() && at != shader.npos; at = shader.find(name, at + name.size()))
        count += (at == 0 || !isNamed(shader[at - 1])) && (at + name.size() == shader.size() || !isNamed(shader[at + name.size()]));
      if (count > 1) return true;
    }
  }
  return false;
}

void checkShader(const BrdfReader& brdf, const std::string& file, Diagnostics& problems) {
  if (brdf.shaderLine == 0) {
    problems.push_back(error(file + ":1", "has no shader", "write ::begin shader, the GLSL of BRDF(), ::end shader"));
    return;
  }
  const GlslScan scan = scanGlsl(brdf.shader);
  std::vector<GlslFault> faults = scan.faults;
  if (faults.empty()) faults = recursionFaults(scan);
  if (faults.empty()) faults = growthFaults(brdf.shader);
  int last = 0;  // one fault for each line: the next is often the same one
  for (const GlslFault& fault : faults)
    if (fault.line != std::exchange(last, fault.line)) problems.push_back(error(fmt::format("{}:{}", file, fault.line), fault.what, fault.hint));
  int near = 0;
  for (const GlslFunction& function : scan.functions) {
    if (function.name != "BRDF") continue;
    near = function.line;
    if (function.returnType == "vec3" && function.takes({"vec3", "vec3", "vec3", "vec3", "vec3"})) return;
  }
  if (near || faults.empty())
    problems.push_back(error(fmt::format("{}:{}", file, near ? near : brdf.shaderLine), near ? "'BRDF' has other types than it is called with" : "defines no BRDF",
                             "write vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)"));
}

}  // namespace

std::string modelIdOfFile(const fs::path& path) {
  std::string id;
  for (const char c : path.stem().string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool fits = byte < 128 && (std::isalnum(byte) || c == '-' || c == '_' || c == '.');
    if (id.empty() && !(fits && std::isalnum(byte))) continue;
    id += fits ? c : '-';
  }
  id.resize(std::min<size_t>(id.size(), 64));
  return id.empty() ? "brdf" : id;
}

Result<ShadingModel> parseBrdf(const fs::path& path, const std::string& text, Diagnostics& warnings) {
  if (auto fault = faultOfModelText(path, text)) return *fault;
  BrdfReader brdf(path, "analytic");
  brdf.read(text);
  checkShader(brdf, path.string(), brdf.problems);
  if (!brdf.problems.empty()) {
    // A file of another kind has one fault, not one a line.
    if (brdf.problems.front().place.ends_with(":1")) brdf.problems.resize(1);
    return brdf.problems;
  }
  warnings.insert(warnings.end(), brdf.warnings.begin(), brdf.warnings.end());
  ShadingModel model;
  model.file = path;
  model.hash = hashText(text);
  model.id = modelIdOfFile(path);
  model.title = path.stem().string();
  model.doc = "A file of BRDF Explorer: one BRDF, which reads no attribute of the surface but its normal.";
  model.color = colorOfId(model.id);
  model.uses = {"normal"};
  model.namePrefix = kPrefix;
  model.definesSpecular = model.definesDiffuse = true;
  model.usesTangent = usesTangent(brdf.shader);
  addParameters(brdf.parameters, model);
  model.source = sourceOf(brdf);
  return model;
}

Result<fs::path> fileOfBparam(const fs::path& bparam, const std::string& text) {
  BrdfReader reader(bparam, "bparam");
  reader.read(std::string_view(text).substr(0, text.find('\n')));
  if (!reader.problems.empty()) return reader.problems;
  const std::string place = bparam.string() + ":1";
  fs::path named = reader.named;
  if (named.empty()) return error(place, "names no file", "write bparam PATH, the path of a .brdf");
  if (named.extension() != ".brdf")
    return error(place, fmt::format("'{}' is no .brdf", reader.named.substr(0, 200)), "only analytic BRDFs can be read");
  if (named.is_absolute() || reader.named.find('\\') != std::string::npos) named = reader.named.substr(reader.named.find_last_of("/\\") + 1);
  auto inside = resolveInside(bparam.parent_path(), named.string());
  if (!inside) return error(place, fmt::format("'{}' leaves the folder of the file", reader.named.substr(0, 200)), "copy the .brdf beside it");
  return inside;
}

Result<ShadingModel> parseBparam(const fs::path& path, const std::string& text, Diagnostics& warnings) {
  if (auto fault = faultOfModelText(path, text)) return *fault;
  BrdfReader given(path, "bparam");
  given.read(text);
  const auto source = fileOfBparam(path, text);
  if (!source) return source.diagnostics();
  const auto whole = readFile(*source, kLargestBrdf);
  if (!whole) return error(path.string() + ":1", fmt::format("{} {}", source->string(), whole.diagnostics()[0].what), "copy the .brdf beside it");
  auto model = parseBrdf(*source, *whole, warnings);
  if (!model) return model.diagnostics();
  std::vector<std::string> known;
  for (const ModelParameter& p : model->parameters) known.push_back(p.fileName);
  for (const BrdfParameter& p : given.parameters) {
    const std::string place = fmt::format("{}:{}", path.string(), p.line);
    const auto target = std::find_if(model->parameters.begin(), model->parameters.end(), [&](const ModelParameter& m) { return m.fileName == p.name; });
    if (target == model->parameters.end()) {
      warnings.push_back(warning(place, fmt::format("'{}' is no parameter of {}", p.name, source->filename().string()), suggestion(p.name, known)));
    } else if (target->standard.type != p.type) {
      given.problems.push_back(error(place, fmt::format("parameter '{}' is {} in {}", p.name, described(target->standard.type), source->filename().string()), valueHint(target->standard.type)));
    } else if (!inRange({p.type, p.value}, target->minimum, target->maximum)) {
      given.problems.push_back(error(place, fmt::format("parameter '{}': {} is outside {}..{} of {}", p.name, valueText({p.type, p.value}), target->minimum, target->maximum, source->filename().string()),
                                     "move the value into the range"));
    } else {
      target->standard.v = p.value;
    }
  }
  if (!given.problems.empty()) return given.problems;
  warnings.insert(warnings.end(), given.warnings.begin(), given.warnings.end());
  model->file = path;
  model->sourceFile = *source;
  model->hash = hashText(text, model->hash);
  model->id = modelIdOfFile(path);
  model->title = path.stem().string();
  model->color = colorOfId(model->id);
  return model;
}

}  // namespace glint
