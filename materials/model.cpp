#include "materials/model.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "materials/attributes.h"
#include "materials/base/hash.h"
#include "materials/front_matter.h"
#include "materials/glsl_cost.h"
#include "materials/glsl_recursion.h"
#include "materials/glsl_scan.h"
#include "materials/glsl_words.h"
#include "materials/terms.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr size_t kLargestModel = size_t{256} << 10;

std::string faultOfName(const std::string& name) {
  const std::string fault = faultOfParameterName(name);
  return fault.empty() && findAttribute(name) ? "is the name of an attribute" : fault;
}

std::string titleOf(std::string name) {
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::optional<ModelParameter> readParameter(const Json& json, const std::string& file, Diagnostics& problems) {
  std::string where = "parameter";
  if (const Json* name = json.find("name"); name && name->isString()) where += " '" + name->text + "'";
  ObjectReader reader(json, file, where, problems);
  const size_t before = problems.size();
  ModelParameter parameter;
  parameter.name = reader.text("name", true).value_or("");
  if (const Json* name = json.find("name"); name && name->isString())
    if (const std::string fault = faultOfName(name->text); !fault.empty())
      reader.problem(*name, "the name " + fault, "choose another");
  parameter.title = reader.text("title").value_or(parameter.name);
  parameter.doc = reader.text("doc").value_or("");
  const auto typeName = reader.text("type", true);
  static const std::vector<std::string> kTypes = {"bool", "int", "float", "vec2", "vec3", "vec4", "color"};
  const std::optional<ValueType> found = typeName ? valueType(*typeName) : std::nullopt;
  const ValueType type = found.value_or(ValueType::Texture);
  if (typeName && componentCount(type) == 0)
    reader.problem(*json.find("type"), fmt::format("unknown type '{}'", *typeName), suggestion(*typeName, kTypes));
  parameter.minimum = reader.number("min").value_or(0.f);
  parameter.maximum = reader.number("max").value_or(1.f);
  if (!(parameter.minimum < parameter.maximum)) {
    const Json* at = json.find("max") ? json.find("max") : json.find("min");
    reader.problem(at ? *at : json,
                   fmt::format("the range {}..{} is empty", parameter.minimum, parameter.maximum),
                   "'min' must be less than 'max'; they are 0 and 1 when not given");
  }
  if (componentCount(type) > 0) {
    if (const auto value = reader.value("default", type, true)) {
      parameter.standard = *value;
      if (parameter.minimum < parameter.maximum &&
          !inRange(*value, parameter.minimum, parameter.maximum))
        reader.problem(*json.find("default"),
                       fmt::format("the default {} is outside {}..{}", valueText(*value), parameter.minimum,
                                   parameter.maximum),
                       "widen the range or move the default");
    }
  } else {
    reader.any("default");
  }
  reader.finish();
  if (problems.size() != before) return std::nullopt;
  return parameter;
}

void readParameters(const Json& list, const std::string& file, ShadingModel& model, Diagnostics& problems) {
  if (list.items.size() > kMostModelParameters) {
    problems.push_back(error(fmt::format("{}:{}", file, list.line),
                             fmt::format("{} parameters", list.items.size()),
                             fmt::format("at most {} are possible", kMostModelParameters)));
    return;
  }
  int used = 0;
  std::vector<std::pair<std::string, int>> seen;
  for (const Json& item : list.items) {
    if (const Json* name = item.find("name"); name && name->isString()) {
      for (const auto& [other, line] : seen)
        if (other == name->text)
          problems.push_back(error(fmt::format("{}:{}", file, name->line),
                                   fmt::format("a second parameter '{}'", name->text),
                                   fmt::format("the first is on line {}", line)));
      seen.emplace_back(name->text, name->line);
    }
    auto parameter = readParameter(item, file, problems);
    if (!parameter) continue;
    const int count = componentCount(parameter->standard.type);
    if (used + count <= 4) {
      parameter->slot = used;
      used += count;
    }
    model.parameters.push_back(std::move(*parameter));
  }
}

void readTerms(const Json& json, const std::string& file, ShadingModel& model, Diagnostics& problems) {
  ObjectReader reader(json, file, "terms", problems);
  const auto read = [&](std::string_view key, TermKind kind, std::string& term) {
    const auto name = reader.text(key);
    if (!name) return;
    const std::vector<std::string> known = termNames(kind);
    if (std::find(known.begin(), known.end(), *name) == known.end())
      reader.problem(*json.find(key), fmt::format("unknown {} term '{}'", key, *name), suggestion(*name, known));
    term = *name;
  };
  read("D", TermKind::D, model.termD);
  read("V", TermKind::V, model.termV);
  read("G", TermKind::V, model.termG);
  read("F", TermKind::F, model.termF);
  read("diffuse", TermKind::Diffuse, model.termDiffuse);
  if (!model.termV.empty() && !model.termG.empty())
    reader.problem(*json.find("G"), "both V and G are named", "V is G / (4 NoL NoV): name one");
  reader.finish();
}

// The terms that the head names, of whatever kind.
std::vector<std::pair<TermKind, std::string>> namedTerms(const ShadingModel& model) {
  std::vector<std::pair<TermKind, std::string>> named = {{TermKind::D, model.termD},
                                                         {TermKind::V, model.termV.empty() ? model.termG : model.termV},
                                                         {TermKind::F, model.termF},
                                                         {TermKind::Diffuse, model.termDiffuse}};
  std::erase_if(named, [](const auto& term) { return term.second.empty(); });
  return named;
}

// What the named terms take besides the Shading, after what the head declares: one that has its name is that one.
void addTermParameters(ShadingModel& model) {
  int used = 0;
  for (const ModelParameter& p : model.parameters) used += p.slot < 0 ? 0 : componentCount(p.standard.type);
  for (const auto& [kind, name] : namedTerms(model)) {
    const auto term = findTerm(kind, name);
    if (!term) continue;
    for (const TermParameter& p : term->parameters)
      if (!model.parameter(p.name))
        model.parameters.push_back({p.name, titleOf(p.name), p.doc, Value::scalar(p.standard), p.minimum, p.maximum,
                                    used < 4 ? used++ : -1});
  }
}

void readHead(const Json& head, const std::string& file, ShadingModel& model, Diagnostics& problems) {
  ObjectReader reader(head, file, "", problems);
  model.id = reader.text("id", true).value_or("");
  if (const Json* id = head.find("id")) model.idLine = id->line;
  if (const Json* id = head.find("id"); id && id->isString() && !isModelId(id->text))
    reader.problem(*id, fmt::format("'{}' is no id", id->text.substr(0, 64)), kModelIdRule);
  model.title = reader.text("title").value_or(model.id);
  model.doc = reader.text("doc").value_or("");
  if (const auto color = reader.value("color", ValueType::Vec3)) {
    if (!inRange(*color, 0, 1)) reader.problem(*head.find("color"), "'color' is outside 0..1", "three numbers from 0 to 1");
    model.color = {color->v[0], color->v[1], color->v[2]};
  } else {
    model.color = colorOfId(model.id);
  }
  if (const Json* list = reader.array("parameters")) readParameters(*list, file, model, problems);
  model.prepared = reader.texts("prepared").value_or(std::vector<std::string>{});
  for (size_t i = 0; i < model.prepared.size(); ++i) {
    const std::string& name = model.prepared[i];
    std::string fault = faultOfName(name);
    if (model.parameter(name)) fault = "is a parameter";
    if (std::find(model.prepared.begin(), model.prepared.begin() + static_cast<long>(i), name) !=
        model.prepared.begin() + static_cast<long>(i))
      fault = "is there twice";
    if (!fault.empty()) reader.problem(*head.find("prepared"), fmt::format("prepared '{}' {}", name, fault), "choose another name");
  }
  if (model.prepared.size() > kMostModelParameters)
    reader.problem(*head.find("prepared"), fmt::format("{} prepared members", model.prepared.size()),
                   fmt::format("at most {} are possible", kMostModelParameters));
  if (const Json* json = reader.object("terms")) readTerms(*json, file, model, problems);
  addTermParameters(model);
  // The name of one of the model's parameters, a float or, where that is allowed, a color.
  const auto readName = [&](ObjectReader& from, const Json& json, std::string_view key, bool required, bool color) {
    const std::string name = from.text(key, required).value_or("");
    const ModelParameter* parameter = model.parameter(name);
    const auto fits = [&](const ModelParameter& p) {
      return p.standard.type == ValueType::Float || (color && p.standard.type == ValueType::Color);
    };
    if (name.empty() || (parameter && fits(*parameter))) return name;
    std::vector<std::string> fitting;
    for (const ModelParameter& p : model.parameters)
      if (fits(p)) fitting.push_back(p.name);
    from.problem(*json.find(key), fmt::format("'{}' names no parameter of type float{}", key, color ? " or color" : ""), suggestion(name, fitting));
    return name;
  };
  if (const Json* json = reader.object("coat")) {
    ObjectReader coat(*json, file, "coat", problems);
    model.coatRoughness = readName(coat, *json, "roughness", true, false);
    model.coatStrength = readName(coat, *json, "strength", true, true);
    coat.finish();
  }
  model.tangentRotation = readName(reader, head, "tangentRotation", false, false);
  if (const Json* json = reader.object("claims")) {
    ObjectReader claims(*json, file, "claims", problems);
    model.claims.reciprocal = claims.boolean("reciprocal").value_or(false);
    model.claims.energyConserving = claims.boolean("energyConserving").value_or(false);
    claims.finish();
  }
  model.compensate = reader.boolean("compensate").value_or(false);
  model.cite = reader.texts("cite").value_or(std::vector<std::string>{});
  model.uses = reader.texts("uses").value_or(std::vector<std::string>{});
  for (const std::string& use : model.uses)
    if (!findAttribute(use))
      reader.problem(*head.find("uses"), fmt::format("unknown attribute '{}'", use), suggestion(use, attributeNames()));
  reader.finish();
}

struct Entry {
  std::string_view name, type;
  bool ShadingModel::*defines;
  std::string ShadingModel::*term;
  std::string_view parameters = "Shading s, Parameters p";
};
const Entry kEntries[] = {
    {"D", "float", &ShadingModel::definesD, &ShadingModel::termD},
    {"V", "float", &ShadingModel::definesV, &ShadingModel::termV},
    {"F", "vec3", &ShadingModel::definesF, &ShadingModel::termF},
    {"diffuse", "vec3", &ShadingModel::definesDiffuse, &ShadingModel::termDiffuse},
    {"specular", "vec3", &ShadingModel::definesSpecular, nullptr},
    {"prepare", "void", &ShadingModel::definesPrepare, nullptr, "Shading s, inout Parameters p"},
    {"colors", "void", &ShadingModel::definesColors, nullptr, "inout Shading s, Parameters p"},
    {"coat", "vec3", &ShadingModel::definesCoat, nullptr},
    {"throughCoat", "vec3", &ShadingModel::definesThroughCoat, nullptr},
    {"environment", "vec3", &ShadingModel::definesEnvironment, nullptr},
    {"scattered", "vec3", &ShadingModel::definesScattered, nullptr},
};

// Whether the plugin or a term that it calls or names reads one of these members of `Shading`. A macro may hide it.
bool reads(const GlslScan& scan, const GlslScan& library, const ShadingModel& model, const std::set<std::string>& members) {
  const auto readsOne = [&](const GlslFunction& f) {
    return std::any_of(f.members.begin(), f.members.end(), [&](const std::string& m) { return members.count(m) != 0; });
  };
  if (!scan.macros.empty() &&
      std::any_of(members.begin(), members.end(), [&](const std::string& m) { return model.source.find("." + m) != std::string::npos; }))
    return true;
  std::vector<std::string> called;
  for (const auto& [kind, name] : namedTerms(model)) called.push_back(std::string(prefix(kind)) + name);
  for (const GlslFunction& f : scan.functions) {
    if (readsOne(f)) return true;
    for (const GlslCall& call : f.calls) called.push_back(call.name);
  }
  std::set<std::string> seen;
  while (!called.empty()) {
    const std::string name = std::move(called.back());
    called.pop_back();
    if (!seen.insert(name).second) continue;
    for (const GlslFunction& f : library.functions) {
      if (f.name != name) continue;
      if (readsOne(f)) return true;
      for (const GlslCall& call : f.calls) called.push_back(call.name);
    }
  }
  return false;
}

void checkNames(const GlslScan& scan, const GlslScan& library, const std::string& file, Diagnostics& problems) {
  static const std::vector<std::string_view> kOwn = {"main", "Shading", "Parameters", "modelD", "modelSpecular",
                                                     "modelDiffuse", "modelV", "modelF", "modelParameters", "modelPrepare", "modelHasD",
                                                     "modelBase", "modelLobe", "modelDiffuseBelow", "modelColors", "modelTurn",
                                                     "modelThroughCoat", "modelCoatRoughness", "modelCoatStrength",
                                                     "modelEnvironment", "modelHasEnvironment", "modelScattered",
                                                     "modelScatters", "modelCoat", "modelSingleBounce", "modelWhite", "modelLobeWhite", "ProjectedAreas",
                                                     "GlintBounces", "MODEL_COAT", "MODEL_TANGENT", "COAT"};
  for (const GlslName& name : scan.names)
    if (name.name.starts_with("glint") ||
        std::find(kOwn.begin(), kOwn.end(), name.name) != kOwn.end())
      problems.push_back(error(fmt::format("{}:{}", file, name.line),
                               fmt::format("defines '{}', which is Glint's", name.name), "choose another name"));
  for (const GlslFunction& own : scan.functions)
    for (const GlslFunction& theirs : library.functions)
      if (own.name == theirs.name && own.takes(theirs.parameterTypes))
        problems.push_back(error(fmt::format("{}:{}", file, own.line),
                                 fmt::format("defines '{}' again", own.name),
                                 "Glint's terms have it: call that one, or choose another name"));
}

// Terms that are made for the model's own D, named in the head or called in its text.
void checkOwnSmith(const GlslScan& scan, const std::string& file, const Json& head, ShadingModel& model, Diagnostics& problems) {
  const std::string& V = model.termV.empty() ? model.termG : model.termV;
  int line = 0;
  std::string used;
  for (const Term& term : terms()) {
    if (!term.ofOwnD) continue;
    if (term.name == V) {
      const Json* named = head.find("terms");
      line = named ? named->line : head.line;
      used = term.function();
    }
    for (const GlslFunction& function : scan.functions)
      for (const GlslCall& call : function.calls)
        if (call.name == term.function() && call.arguments == 1) {
          line = call.line;
          used = term.function();
        }
  }
  model.smithOfOwnD = !used.empty();
  if (model.smithOfOwnD && !model.definesD && model.termD.empty())
    problems.push_back(error(fmt::format("{}:{}", file, line), fmt::format("uses {} but has no D", used),
                             "it is made from the model's own D: name one in \"terms\" or write float D(Shading s, Parameters p)"));
}

void checkBody(const GlslScan& scan, const std::string& file, int headLine, const Json& head, ShadingModel& model,
               Diagnostics& problems) {
  std::vector<GlslFault> faults = scan.faults;
  if (faults.empty()) faults = recursionFaults(scan);
  if (faults.empty()) faults = growthFaults(model.source);
  int last = 0;  // one fault for each line: the next is often the same one
  for (const GlslFault& fault : faults)
    if (fault.line != std::exchange(last, fault.line))
      problems.push_back(error(fmt::format("{}:{}", file, fault.line), fault.what, fault.hint));
  const GlslScan library = scanGlsl(shipped::read("shaders/common/shading.glsl").value_or("") + termsGlsl());
  checkNames(scan, library, file, problems);
  for (const Entry& entry : kEntries) {
    int near = 0;
    for (const GlslFunction& function : scan.functions) {
      if (function.name != entry.name) continue;
      near = function.line;
      if (function.returnType == entry.type && function.takes({"Shading", "Parameters"})) {
        model.*entry.defines = true;
        break;
      }
    }
    if (near && !(model.*entry.defines))
      problems.push_back(error(fmt::format("{}:{}", file, near),
                               fmt::format("'{}' has other types than Glint calls it with", entry.name),
                               fmt::format("write {} {}({})", entry.type, entry.name, entry.parameters)));
    const bool named = entry.term && (!(model.*entry.term).empty() || (entry.name == "V" && !model.termG.empty()));
    if (near && named)
      problems.push_back(error(fmt::format("{}:{}", file, near),
                               fmt::format("defines '{}', which \"terms\" of the head names too", entry.name),
                               "keep one of them"));
    // A fault in "terms" has been reported there.
    const bool needed = !model.definesSpecular && entry.term != nullptr && entry.name != "diffuse";
    const Json* terms = head.find("terms");
    if (needed && !near && !named && !(terms && terms->find(entry.name)))
      if (std::none_of(scan.functions.begin(), scan.functions.end(),
                       [](const GlslFunction& f) { return f.name == "specular"; }))
        problems.push_back(error(fmt::format("{}:{}", file, headLine), fmt::format("has no {}", entry.name),
                                 fmt::format("name one in \"terms\" or write {} {}(Shading s, Parameters p)",
                                             entry.type, entry.name)));
  }
  if (!model.prepared.empty() && !model.definesPrepare)
    problems.push_back(error(fmt::format("{}:{}", file, head.find("prepared")->line), "\"prepared\" is never filled",
                             "write void prepare(Shading s, inout Parameters p)"));
  if (model.definesCoat != !model.coatRoughness.empty())
    problems.push_back(error(fmt::format("{}:{}", file, model.definesCoat ? headLine : head.find("coat")->line),
                             model.definesCoat ? "the head does not tell of its coat" : "\"coat\" has no function",
                             model.definesCoat ? R"(write "coat": {"roughness": "NAME", "strength": "NAME"} with two of its parameters)"
                                               : "write vec3 coat(Shading s, Parameters p)"));
  if (!model.definesDiffuse && model.termDiffuse.empty()) model.termDiffuse = "Lambert";
  model.usesTangent = reads(scan, library, model, {"T", "B"});
  model.usesPlainNonmetal = reads(scan, library, model, {"plainNonmetal"});
  for (const char* attribute : {"baseColor", "metallic", "specular"})
    if (reads(scan, library, model, {attribute})) model.authored.emplace_back(attribute);
  checkOwnSmith(scan, file, head, model, problems);
}

}  // namespace

bool isModelId(const std::string& id) {
  return !id.empty() && id.size() <= 64 && std::isalnum(static_cast<unsigned char>(id[0])) &&
         std::all_of(id.begin(), id.end(), [](unsigned char c) {
           return c < 128 && (std::isalnum(c) || c == '-' || c == '_' || c == '.');
         });
}

std::string faultOfParameterName(const std::string& name) {
  if (name.empty() || name.size() > 64 || std::isdigit(static_cast<unsigned char>(name[0])) ||
      !std::all_of(name.begin(), name.end(),
                   [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '_'); }))
    return "is not a GLSL name of letters, digits and _";
  if (name.starts_with("gl_") || name.starts_with("glint") || name.find("__") != name.npos ||
      isGlslWord(name))
    return "is a reserved word";
  return {};
}

std::array<float, 3> colorOfId(const std::string& id) {
  const uint64_t hash = hashText(id);
  std::array<float, 3> color;
  for (size_t i = 0; i < 3; ++i) {
    const float angle = 6.2831853f * (static_cast<float>(hash % 1024) / 1024.f + static_cast<float>(i) / 3.f);
    color[i] = 0.6f + 0.25f * std::cos(angle);
  }
  return color;
}

std::optional<Diagnostic> faultOfModelText(const std::filesystem::path& file, const std::string& text) {
  if (text.size() > kLargestModel)
    return error(file.string(), fmt::format("is {} bytes long", text.size()), fmt::format("a shading model has at most {}", kLargestModel));
  if (const size_t zero = text.find('\0'); zero != text.npos)
    return error(fmt::format("{}:{}", file.string(), 1 + std::count(text.begin(), text.begin() + static_cast<long>(zero), '\n')),
                 "holds a zero byte", "a shading model is a text file");
  return std::nullopt;
}

const ModelParameter* ShadingModel::parameter(std::string_view wanted) const {
  for (const ModelParameter& p : parameters)
    if (p.name == wanted || p.fileName == wanted) return &p;
  return nullptr;
}

bool ShadingModel::reads(std::string_view attribute) const {
  return uses.empty() || std::find(uses.begin(), uses.end(), attribute) != uses.end();
}

int ShadingModel::coatRoughnessSlot() const {
  const ModelParameter* roughness = definesCoat ? parameter(coatRoughness) : nullptr;
  return roughness ? roughness->slot : -1;
}

std::array<float, 4> ShadingModel::standardSlots() const {
  std::array<float, 4> slots{};
  for (const ModelParameter& p : parameters)
    for (int i = 0; p.slot >= 0 && i < componentCount(p.standard.type); ++i)
      slots[static_cast<size_t>(p.slot + i)] = p.standard.v[static_cast<size_t>(i)];
  return slots;
}

Result<ShadingModel> parseModel(const std::filesystem::path& path, const std::string& text) {
  const std::string file = path.string();
  if (auto fault = faultOfModelText(path, text)) return *fault;
  auto front = readFrontMatter(file, text);
  if (!front) return front.diagnostics();
  ShadingModel model;
  model.file = path;
  model.hash = hashText(text);
  model.source = std::move(front->body);
  if (model.source.starts_with("\xEF\xBB\xBF")) model.source.replace(0, 3, "   ");
  Diagnostics problems;
  readHead(front->head, file, model, problems);
  checkBody(scanGlsl(model.source), file, front->head.line, front->head, model, problems);
  if (!problems.empty()) return problems;
  return model;
}

}  // namespace glint
