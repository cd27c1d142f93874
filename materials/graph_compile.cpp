#include "materials/graph_compile.h"

#include <algorithm>
#include <chrono>
#include <cctype>
#include <cmath>
#include <set>

#include "materials/attributes.h"
#include "materials/base/hash.h"
#include "materials/glsl_program.h"
#include "materials/graph_analysis.h"
#include "materials/graph_validate.h"
#include "materials/normal_variances.h"
#include "materials/path_guard.h"

namespace glint {
namespace {

constexpr int kMostInstances = 200'000;   // nodes after all calls are inlined
constexpr int kLargestBlock = 16384;      // bytes that every OpenGL 4.5 uniform block has
// What is drawn, so that no file takes a driver's compiler further than this. Measured on Mesa 22.3: 1900 statements
// take 250 MB and half a minute, 15000 over 23 GB; 150 000 operations take 0.7 to 0.9 GB and 20 to 30 s.
constexpr int kMostStatements = 2000;
constexpr int64_t kMostOperations = 150'000;
constexpr int kMostLiveValues = 768;      // of valuesAsUniforms: leaves room for the parameters

// A bundle of attributes, taken apart: one value for each of attributePins(), or none where it is standard.
using Bundle = std::vector<ValueId>;

// What a pin carries while compiling.
struct Carried {
  ValueId value = -1;
  std::shared_ptr<const Bundle> bundle;
};
using Ports = std::map<std::string, Carried, std::less<>>;

class Compiler {
 public:
  Compiler(const Material& material, const ShadingModel& model, const GraphContext& context,
           const CompileOptions& options)
      : material_(material), model_(model), context_(context), options_(options), pins_(attributePins(&model)) {
    for (size_t i = 0; i < pins_.size(); ++i) pinIndex_[pins_[i].name] = i;
  }

  Diagnostics problems;
  CompiledMaterial result;

  void run() {
    const GraphAnalysis analysis = analyse(material_, context_);
    const NodeId output = material_.outputNode();
    std::map<NodeId, Ports> outputs;
    std::map<NodeId, Bundle> bundles = evaluate(material_, analysis, {output}, {}, "", outputs);
    if (!problems.empty()) return;
    Bundle attributes = std::move(bundles.at(output));
    applyModelParameters(attributes);
    std::vector<ValueId> results(attributes);
    results.push_back(variances_.of(attributes[pinIndex_.find("normal")->second]));
    for (const auto& [parameter, value] : constantParameters_) results.push_back(value);
    program_.finish(results);
    const std::string tooLong = "a driver would need gigabytes to compile it: bake a part into textures";
    if (program_.keptCount() > kMostStatements)
      problems.push_back(error(material_.place(), fmt::format("becomes {} statements, more than the {} that are drawn",
                                                              program_.keptCount(), kMostStatements), tooLong));
    else if (program_.operations() > kMostOperations)
      problems.push_back(error(material_.place(), fmt::format("becomes {} operations, more than the {} that are drawn",
                                                              program_.operations(), kMostOperations), tooLong));
    if (!problems.empty()) return;
    if (program_.blockSize() > kLargestBlock) {
      problems.push_back(error(material_.place(), fmt::format("{} bytes of parameters, more than the {} of a block",
                                                              program_.blockSize(), kLargestBlock),
                               "make some of them constants"));
      return;
    }
    write(attributes);
  }

 private:
  // Evaluates the nodes that `wanted` depend on. Gives the bundles of "output" nodes; results of all others go to
  // `values`.
  std::map<NodeId, Bundle> evaluate(const Material& document, const GraphAnalysis& analysis,
                                    const std::vector<NodeId>& wanted, const Ports& inputs,
                                    const std::string& prefix, std::map<NodeId, Ports>& values) {
    std::set<NodeId> needed;
    std::vector<NodeId> todo = wanted;
    while (!todo.empty()) {
      NodeId id = std::move(todo.back());
      todo.pop_back();
      const auto info = analysis.nodes.find(id);
      if (info == analysis.nodes.end() || !needed.insert(id).second) continue;
      for (const auto& [pin, input] : info->second.node->inputs)
        if (input.from && info->second.pins->input(pin)) todo.push_back(input.from->node);
    }
    result.stats.nodes += static_cast<int>(analysis.nodes.size());
    result.stats.pruned += static_cast<int>(analysis.nodes.size() - needed.size());
    std::map<NodeId, Bundle> bundles;
    for (const NodeId& id : analysis.order) {
      if (!needed.count(id)) continue;
      if (++instances_ > kMostInstances) {
        if (problems.empty())
          problems.push_back(error(document.place(id), fmt::format("more than {} nodes once all functions are put in",
                                                                   kMostInstances),
                                   "call fewer functions from functions"));
        return bundles;
      }
      Visit visit{document, analysis, analysis.nodes.at(id), id, inputs, prefix, values};
      node(visit, bundles);
      if (!problems.empty()) return bundles;
    }
    return bundles;
  }

  struct Visit {
    const Material& document;
    const GraphAnalysis& analysis;
    const NodeInfo& info;
    const NodeId& id;
    const Ports& inputs;             // of the function that this is
    const std::string& prefix;       // "rust." in the call of node "rust"
    std::map<NodeId, Ports>& values;
    std::string name() const { return prefix + id; }
    bool top() const { return prefix.empty(); }
  };

  GlslProgram::Origin origin(const Visit& v) const { return {v.name(), v.info.kind->title}; }

  // What feeds a pin; nothing when it has neither wire nor constant.
  Carried fed(const Visit& v, std::string_view pin) {
    const auto input = v.info.node->inputs.find(std::string(pin));
    if (input == v.info.node->inputs.end()) return {};
    if (input->second.from) {
      const auto source = v.values.find(input->second.from->node);
      if (source == v.values.end()) return {};
      const auto carried = source->second.find(input->second.from->pin);
      return carried == source->second.end() ? Carried{} : carried->second;
    }
    const Pin* known = v.info.pins->input(pin);
    if (!input->second.value || !known) return {};
    const ValueType type = known->type.kind == PinType::Kind::Exact ? known->type.type : input->second.value->type;
    const auto value = coerced(*input->second.value, type);
    if (!value) return {};
    return {constantValue(v, *known, known->most ? clamped(*value, known->minimum, *known->most) : *value), nullptr};
  }

  // A constant on a pin: folded into the text, or a uniform while someone may be dragging it.
  ValueId constantValue(const Visit& v, const Pin& pin, const Value& value) {
    const bool number = value.type != ValueType::Bool && value.type != ValueType::Int;
    if (!options_.valuesAsUniforms || !v.top() || !number || liveValues_ >= kMostLiveValues)
      return program_.literal(value);
    ++liveValues_;
    const std::string name = v.id + "." + pin.name;
    return program_.uniform("value " + name, {.name = name, .node = v.id, .value = value, .minimum = pin.minimum,
                                              .maximum = pin.maximum});
  }

  // The value of a pin, whatever feeds it, as the type that the node computes with.
  ValueId argument(const Visit& v, const Pin& pin) {
    const ValueType type = pin.type.kind == PinType::Kind::Exact ? pin.type.type
                                                                 : v.info.generic.value_or(ValueType::Float);
    const Carried carried = fed(v, pin.name);
    ValueId id = carried.value;
    if (id < 0) {
      id = !pin.surface.empty()                        ? program_.surface(pin.surface)
           : v.info.kind->builtin == Builtin::None ? constantValue(v, pin, pin.standard)
                                                       : program_.literal(pin.standard);
    }
    return program_.convert(id, type);
  }

  Bundle bundleOf(const Visit& v, std::string_view pin) {
    const Carried carried = fed(v, pin);
    return carried.bundle ? *carried.bundle : Bundle(pins_.size(), -1);
  }

  // The bundle with each attribute that has its own pin fed.
  Bundle withPins(const Visit& v, Bundle bundle) {
    for (size_t i = 0; i < pins_.size(); ++i)
      if (const ValueId id = fed(v, pins_[i].name).value; id >= 0) bundle[i] = program_.convert(id, pins_[i].type.type);
    return bundle;
  }

  ValueId attribute(const Bundle& bundle, size_t i) {
    return bundle[i] >= 0 ? bundle[i] : program_.literal(pins_[i].standard);
  }

  void node(const Visit& v, std::map<NodeId, Bundle>& bundles) {
    Ports& out = v.values[v.id];
    const auto give = [&](std::string_view pin, ValueId id) { out[std::string(pin)].value = id; };
    const auto giveBundle = [&](std::string_view pin, Bundle bundle) {
      out[std::string(pin)].bundle = std::make_shared<const Bundle>(std::move(bundle));
    };
    switch (v.info.kind->builtin) {
      case Builtin::None: data(v, out); break;
      case Builtin::Output: bundles[v.id] = withPins(v, bundleOf(v, "attributes")); break;
      case Builtin::MakeAttributes: giveBundle("attributes", withPins(v, Bundle(pins_.size(), -1))); break;
      case Builtin::SetAttributes: giveBundle("attributes", withPins(v, bundleOf(v, "attributes"))); break;
      case Builtin::BreakAttributes: {
        const Bundle bundle = bundleOf(v, "attributes");
        for (size_t i = 0; i < pins_.size(); ++i) give(pins_[i].name, attribute(bundle, i));
        break;
      }
      case Builtin::BlendAttributes:
        giveBundle("attributes", blend(v, bundleOf(v, "a"), bundleOf(v, "b"), argument(v, *v.info.pins->input("mask"))));
        break;
      case Builtin::Constant: {
        const Pin& pin = v.info.pins->outputs[0];
        give("value", constantValue(v, pin, settingValue(*v.info.node, "value", pin.type.type)
                                                .value_or(Value{pin.type.type, {}})));
        break;
      }
      case Builtin::Parameter: give("value", parameter(v)); break;
      case Builtin::Texture: give("texture", texture(v)); break;
      case Builtin::TextureSample: sample(v, out); break;
      case Builtin::FunctionInput: functionInput(v, out); break;
      case Builtin::FunctionOutput: out["value"] = port(v, v.info.pins->inputs[0]); break;
      case Builtin::Function:
      case Builtin::Layer: call(v, out); break;
      case Builtin::Reroute: {
        Carried carried = fed(v, "in");
        if (carried.value >= 0 && v.info.generic && componentCount(*v.info.generic) > 0)
          carried.value = program_.convert(carried.value, *v.info.generic);
        out["out"] = carried;
        break;
      }
      case Builtin::Comment: break;
    }
  }

  // A pin that carries anything: a number, a texture or a bundle.
  Carried port(const Visit& v, const Pin& pin) {
    if (pin.type.type == ValueType::Attributes)
      return {-1, std::make_shared<const Bundle>(bundleOf(v, pin.name))};
    if (pin.type.type == ValueType::Texture) return fed(v, pin.name);
    return {argument(v, pin), nullptr};
  }

  void data(const Visit& v, Ports& out) {
    const NodeKind& kind = *v.info.kind;
    std::vector<ValueId> arguments;
    for (const Pin& pin : kind.inputs) arguments.push_back(argument(v, pin));
    std::vector<std::string> settings;
    for (const SettingInfo& setting : kind.settings) settings.push_back(settingLiteral(*v.info.node, setting));
    const ValueType generic = v.info.generic.value_or(ValueType::Float);
    std::vector<ValueType> types;
    for (const Pin& pin : kind.outputs)
      types.push_back(pin.type.kind == PinType::Kind::Exact ? pin.type.type : generic);
    const auto results = program_.call(origin(v), kind, generic, arguments, settings, types);
    if (!kind.variance.empty()) variances_.made(origin(v), kind, arguments, results[0]);
    for (size_t i = 0; i < results.size(); ++i) out[kind.outputs[i].name].value = results[i];
  }

  static std::string settingLiteral(const Node& node, const SettingInfo& setting) {
    if (setting.type == SettingInfo::Type::Bool)
      return settingBool(node, setting.name, setting.standard.boolean) ? "true" : "false";
    if (setting.type == SettingInfo::Type::Int) {
      const float value = settingNumber(node, setting.name, static_cast<float>(setting.standard.number));
      return std::to_string(std::lround(std::clamp(value, setting.minimum, setting.maximum)));
    }
    const std::string chosen = settingText(node, setting.name, setting.standard.text);
    const auto at = std::find(setting.values.begin(), setting.values.end(), chosen);
    return std::to_string(at == setting.values.end() ? 0 : at - setting.values.begin());
  }

  ValueId parameter(const Visit& v) {
    const ValueType type = v.info.pins->outputs[0].type.type;
    std::string name = settingText(*v.info.node, "name");
    if (name.empty()) name = v.id;
    const bool override = v.top() && v.id.starts_with(kOverridePrefix);
    const std::string key = fmt::format("{} {}", override ? "override" : "parameter", name);
    const ValueId id = program_.uniform(
        key, {.name = name, .node = v.id,
              .value = settingValue(*v.info.node, "value", type).value_or(Value{type, {}}),
              .minimum = settingNumber(*v.info.node, "min", 0), .maximum = settingNumber(*v.info.node, "max", 1)});
    if (program_.type(id) != type)
      problems.push_back(error(v.document.place(v.id),
                               fmt::format("parameter '{}' is a {} here and a {} in another graph", name,
                                           glint::name(type), glint::name(program_.type(id))),
                               "parameters of one name are one; rename one of them"));
    return id;
  }

  ValueId texture(const Visit& v) {
    const Node& node = *v.info.node;
    TextureSlot slot;
    slot.node = v.name();
    slot.place = v.document.place(v.id);
    slot.colorSpace = settingText(node, "colorSpace", "srgb") == "linear" ? ColorSpace::Linear : ColorSpace::sRGB;
    const std::string wrap = settingText(node, "wrap", "repeat");
    const std::string wrapV = settingText(node, "wrapV", "same");
    const auto mode = [](const std::string& word) {
      return word == "clamp" ? Wrap::Clamp : word == "mirror" ? Wrap::Mirror : Wrap::Repeat;
    };
    slot.wrapS = mode(wrap);
    slot.wrapT = mode(wrapV == "same" ? wrap : wrapV);
    slot.filter = settingText(node, "filter", "linear") == "nearest" ? Filter::Nearest : Filter::Linear;
    slot.normals = v.info.kind->builtin == Builtin::TextureSample && holdsNormals(v.document, v.analysis, v.id);
    const std::string file = settingText(node, "file");
    if (file.starts_with("gltf:")) {
      slot.file = file;
    } else if (!file.empty()) {
      if (options_.namedFiles.count(file)) {
        slot.file = file;
      } else {
        const auto path = resolveInside(v.document.file.parent_path(), file);
        if (!path) {
          for (const Diagnostic& d : path.diagnostics())
            problems.push_back(error(v.document.place(v.id), fmt::format("texture {}: {}", d.place, d.what), d.hint));
          return -1;
        }
        slot.file = path->string();
      }
    }
    const auto id = program_.texture(std::move(slot));
    if (!id)
      problems.push_back(error(v.document.place(v.id), fmt::format("is texture number {}; {} are drawn at most",
                                                                   kMostMaterialTextures + 1, kMostMaterialTextures),
                               "use a texture again, or pack several masks into one"));
    return id.value_or(-1);
  }

  void sample(const Visit& v, Ports& out) {
    ValueId image = fed(v, "texture").value;
    const bool own = image < 0;
    if (own) image = texture(v);
    if (image < 0) return;
    const ValueId uv = argument(v, v.info.pins->inputs[1]);
    const ValueId texel =
        program_.expression(origin(v), v.name(), ValueType::Vec4,
                            fmt::format("texture({}, {})", program_.text(image), program_.text(uv)), {image, uv});
    out["color"].value = program_.swizzle(texel, "rgb", ValueType::Color);
    for (const char* component : {"r", "g", "b", "a"})
      out[component].value = program_.swizzle(texel, component, ValueType::Float);
    if (own && holdsNormals(v.document, v.analysis, v.id)) variances_.sampled(origin(v), out["color"].value, out["a"].value);
  }

  void functionInput(const Visit& v, Ports& out) {
    std::string name = settingText(*v.info.node, "name");
    if (name.empty()) name = v.id;
    const auto given = v.inputs.find(name);
    if (given != v.inputs.end()) out["value"] = given->second;
  }

  void call(const Visit& v, Ports& out) {
    const auto found = context_.functions->find(settingText(*v.info.node, "function"), v.document.file.parent_path());
    if (!found) {
      for (const Diagnostic& d : found.diagnostics()) problems.push_back(d);
      return;
    }
    const MaterialPtr function = *found;
    auto& analysis = analyses_[function.get()];
    if (!analysis.second) analysis = {function, std::make_shared<const GraphAnalysis>(analyse(*function, context_))};
    Ports inputs;
    for (const Pin& pin : v.info.pins->inputs) inputs[pin.name] = port(v, pin);
    const FunctionSignature signature = signatureOf(*function);
    std::vector<NodeId> wanted;
    for (const auto& output : signature.outputs) wanted.push_back(output.node);
    std::map<NodeId, Ports> values;
    evaluate(*function, *analysis.second, wanted, inputs, v.name() + ".", values);
    for (const auto& output : signature.outputs)
      if (const auto at = values.find(output.node); at != values.end()) out[output.name] = at->second["value"];
  }

  Bundle blend(const Visit& v, const Bundle& a, const Bundle& b, ValueId mask) {
    if (const auto& constant = program_.constant(mask)) {
      if (constant->v[0] <= 0) return a;
      if (constant->v[0] >= 1) return b;
    }
    Bundle mixed(pins_.size(), -1);
    for (size_t i = 0; i < pins_.size(); ++i) {
      if (a[i] == b[i]) {
        mixed[i] = a[i];
        continue;
      }
      const ValueType type = pins_[i].type.type;
      const ValueId from = program_.convert(attribute(a, i), type), to = program_.convert(attribute(b, i), type);
      if (from == to) {  // the standard on one side, and the same on the other
        mixed[i] = from;
        continue;
      }
      std::string text;
      if (type == ValueType::Bool || type == ValueType::Int)  // whole numbers have no between
        text = fmt::format("{} < 0.5 ? {} : {}", program_.text(mask), program_.text(from), program_.text(to));
      else
        text = fmt::format("mix({}, {}, {})", program_.text(from), program_.text(to), program_.text(mask));
      if (pins_[i].name == "normal") text = fmt::format("normalize({})", text);
      mixed[i] = program_.expression(origin(v), v.name() + "_" + pins_[i].name, type, std::move(text), {from, to, mask});
      if (pins_[i].name == "normal") variances_.blended(origin(v), from, to, mask, mixed[i]);
    }
    return mixed;
  }

  // What the material says of the model's parameters for its whole surface, where the graph says nothing.
  void applyModelParameters(Bundle& attributes) {
    for (const ModelParameter& parameter : model_.parameters) {
      const auto given = material_.modelParameters.find(parameter.name);
      if (given == material_.modelParameters.end()) continue;
      auto value = coerced(given->second, parameter.standard.type);
      if (!value) continue;  // reported by validate()
      value = clamped(*value, parameter.minimum, parameter.maximum);
      if (parameter.slot < 0) {
        constantParameters_[parameter.name] = program_.literal(*value);
        continue;
      }
      ValueId& at = attributes[pinIndex_.at(parameter.name)];
      if (at < 0)
        at = program_.uniform("model " + parameter.name,
                              {.name = parameter.name, .node = {}, .value = *value, .minimum = parameter.minimum,
                               .maximum = parameter.maximum});
    }
  }

  bool isStandard(ValueId id, const Value& standard) const {
    if (id < 0) return true;
    const auto& constant = program_.constant(id);
    return constant && constant->v == standard.v;
  }

  void write(const Bundle& attributes) {
    std::string assignments;
    result.plainNonmetal = true;
    for (size_t i = 0; i < pins_.size(); ++i) {
      const Pin& pin = pins_[i];
      const bool standard = isStandard(attributes[i], pin.standard);
      const bool own = findAttribute(pin.name) != nullptr;
      // Every attribute of its own is written, so that the result is whole whatever `m` came with; parameters of
      // the model start from what the caller put there.
      if (standard && !own) continue;
      std::string value = program_.text(program_.convert(attribute(attributes, i), pin.type.type));
      std::string target = pin.name;
      if (!own) {
        const ModelParameter& parameter = *model_.parameter(pin.name);
        const int count = componentCount(parameter.standard.type);
        target = "model." + std::string("xyzw").substr(static_cast<size_t>(parameter.slot), static_cast<size_t>(count));
        if (parameter.standard.type == ValueType::Bool || parameter.standard.type == ValueType::Int)
          value = fmt::format("float({})", value);
        result.writesModelParameters = true;
      }
      if (pin.name == "metallic" || pin.name == "specular") result.plainNonmetal &= standard;
      result.writesEmissive |= !standard && pin.name == "emissive";
      result.writesOpacityMask |= !standard && pin.name == "opacityMask";
      result.writesNormal |= !standard && pin.name == "normal";
      assignments += fmt::format("  m.{} = {};\n", target, value);
      if (const ValueId variance = pin.name == "normal" ? variances_.of(attributes[i]) : -1; variance >= 0)
        assignments += fmt::format("  m.normalVariance = {};\n", program_.text(variance));
    }
    for (const ModelParameter& parameter : model_.parameters) {
      ModelParameterSource source{.name = parameter.name, .value = parameter.standard};
      ValueId id = -1;
      if (parameter.slot >= 0)
        id = attributes[pinIndex_.at(parameter.name)];
      else if (const auto at = constantParameters_.find(parameter.name); at != constantParameters_.end())
        id = at->second;
      if (id >= 0) {
        if (const auto& constant = program_.constant(id))
          source.value.v = coerced(*constant, parameter.standard.type).value_or(parameter.standard).v;
        else if (program_.uniformIndex(id) >= 0 &&
                 componentCount(program_.type(id)) == componentCount(parameter.standard.type))
          source.uniform = program_.uniformIndex(id);
        else
          source.varies = true;
      }
      result.modelParameters.push_back(std::move(source));
    }
    result.glsl = program_.declarations() + functions() +
                  "\nvoid evaluateMaterial(in MaterialInputs i, inout MaterialAttributes m) {\n" +
                  program_.statements() + (program_.keptCount() ? "\n" : "") + assignments +
                  "}\n";
    result.hash = hashText(result.glsl);
    result.name = material_.name;
    result.model = model_.id;
    result.uniforms = program_.uniforms();
    result.blockSize = program_.blockSize();
    result.textures = program_.textures();
    result.stats.statements = program_.keptCount();
    result.stats.folded = program_.folded();
    result.stats.shared = program_.shared();
  }

  // The GLSL of the data nodes in use, each once for each type, after what it includes.
  std::string functions() const {
    const auto used = program_.functions();
    std::string text;
    std::set<std::string> included;
    for (const auto& function : used)
      for (const std::string& name : function.kind->includes)
        if (const std::string* source = context_.nodes.include(name); source && included.insert(name).second)
          text += "\n" + trimmed(*source) + "\n";
    for (const auto& function : used) {
      const bool generic = std::any_of(function.kind->inputs.begin(), function.kind->inputs.end(), [](const Pin& pin) {
        return pin.type.kind == PinType::Kind::Numeric;
      });
      const std::string source = trimmed(function.kind->source);
      text += "\n" + (generic ? withType(source, glslName(function.generic)) : source) + "\n";
    }
    return text;
  }

  static std::string trimmed(const std::string& text) {
    const size_t from = text.find_first_not_of(" \t\r\n");
    if (from == text.npos) return {};
    return text.substr(from, text.find_last_not_of(" \t\r\n") + 1 - from);
  }

  // The text with the word T replaced.
  static std::string withType(const std::string& text, std::string_view type) {
    std::string out;
    const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (size_t i = 0; i < text.size(); ++i) {
      const bool word = text[i] == 'T' && (i == 0 || !part(text[i - 1])) && (i + 1 == text.size() || !part(text[i + 1]));
      if (word)
        out += type;
      else
        out += text[i];
    }
    return out;
  }

  const Material& material_;
  const ShadingModel& model_;
  const GraphContext& context_;
  const CompileOptions& options_;
  std::vector<Pin> pins_;
  std::map<std::string, size_t, std::less<>> pinIndex_;
  std::map<const Material*, std::pair<MaterialPtr, std::shared_ptr<const GraphAnalysis>>> analyses_;
  std::map<std::string, ValueId> constantParameters_;  // of the model, without a pin
  GlslProgram program_;
  NormalVariances variances_{program_};
  int instances_ = 0, liveValues_ = 0;
};

}  // namespace

Result<CompiledMaterial> compileMaterial(const Material& material, const ShadingModel& model,
                                         const NodeRegistry& registry, const FunctionLibrary& functions,
                                         const CompileOptions& options, Diagnostics* warnings) {
  const auto start = std::chrono::steady_clock::now();
  const GraphContext context{registry, &model, &functions};
  Diagnostics problems = validate(material, context);
  if (material.kind != DocumentKind::Material)
    problems.push_back(error(material.place(), fmt::format("is {}, not a material", withArticle(name(material.kind))),
                             "use it in a material"));
  if (warnings)
    for (const Diagnostic& d : problems)
      if (d.severity == Severity::Warning) warnings->push_back(d);
  if (hasErrors(problems)) {
    std::erase_if(problems, [](const Diagnostic& d) { return d.severity != Severity::Error; });
    return problems;
  }
  Compiler compiler(material, model, context, options);
  compiler.run();
  if (!compiler.problems.empty()) return std::move(compiler.problems);
  compiler.result.stats.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return std::move(compiler.result);
}

}  // namespace glint
