#include "materials/graph_analysis.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "materials/front_matter.h"
#include "materials/function_library.h"
#include "materials/graph_validate.h"
#include "materials/model.h"
#include "materials/node_registry.h"

namespace glint {
namespace {

std::vector<std::string> namesOf(const std::vector<Pin>& pins) {
  std::vector<std::string> names;
  for (const Pin& pin : pins) names.push_back(pin.name);
  return names;
}

class Analyser {
 public:
  Analyser(const Material& material, const GraphContext& context)
      : material_(material), context_(context), folder_(material.file.parent_path()) {}

  GraphAnalysis run() {
    std::vector<NodeId> cycle;
    result_.order = topologicalOrder(material_, &cycle);
    if (!cycle.empty()) {
      std::string path;
      for (size_t i = 0; i < cycle.size() && i < 12; ++i) path += cycle[i] + " -> ";
      fail(cycle.front(), {}, "is part of a cycle: " + path + (cycle.size() > 12 ? "..." : cycle.front()),
           "a node cannot depend on its own result; remove one of these wires");
    }
    const std::set<NodeId> used = usedNodes();
    for (const auto& [id, node] : material_.nodes) {
      NodeInfo& info = result_.nodes[id];
      info.node = &node;
      info.kind = context_.nodes.find(node.kind);
      if (!info.kind) {
        // A later version's node that feeds nothing does no harm: it is kept, and the rest is drawn.
        const std::string what = fmt::format("unknown kind '{}'", node.kind.substr(0, 80));
        const std::string hint = suggestion(node.kind, context_.nodes.ids());
        if (used.count(id)) fail(id, {}, what, hint);
        else warn(id, {}, what + "; nothing uses it, it is kept", hint);
      }
      info.pins = pinsOf(node, context_, folder_);
      if (info.kind) checkSettings(id, info);
    }
    for (const NodeId& id : result_.order) settleTypes(id, result_.nodes.at(id));
    // Nodes of a cycle have no types; their other wires are still judged.
    if (!cycle.empty())
      for (auto& [id, info] : result_.nodes)
        if (std::find(result_.order.begin(), result_.order.end(), id) == result_.order.end())
          for (const auto& [pin, input] : info.node->inputs) checkEnds(id, info, pin, input);
    checkDocument();
    return std::move(result_);
  }

 private:
  void fail(const NodeId& node, std::string_view pin, std::string what, std::string hint = {}) {
    result_.problems.push_back(error(material_.place(node, pin), std::move(what), std::move(hint)));
  }
  void warn(const NodeId& node, std::string_view pin, std::string what, std::string hint = {}) {
    result_.problems.push_back(warning(material_.place(node, pin), std::move(what), std::move(hint)));
  }

  // What the document's results depend on, as far as wires go.
  std::set<NodeId> usedNodes() const {
    std::vector<NodeId> todo;
    for (const auto& [id, node] : material_.nodes)
      if (const NodeKind* kind = context_.nodes.find(node.kind);
          kind && (kind->builtin == Builtin::Output || kind->builtin == Builtin::FunctionOutput))
        todo.push_back(id);
    std::set<NodeId> used(todo.begin(), todo.end());
    while (!todo.empty()) {
      const Node* node = material_.node(todo.back());
      todo.pop_back();
      if (!node) continue;
      for (const auto& [pin, input] : node->inputs)
        if (input.from && used.insert(input.from->node).second) todo.push_back(input.from->node);
    }
    return used;
  }

  // Whether both ends of an input's wire exist. Reports those that do not.
  bool checkEnds(const NodeId& id, const NodeInfo& info, const std::string& pin, const Input& input) {
    if (!info.kind) return false;
    if (!info.pins->input(pin)) {
      if (!unresolvedCall(info))
        warn(id, pin, fmt::format("{} node has no such input now; it is kept and does nothing", withArticle("'" + info.kind->id + "'")),
             suggestion(pin, namesOf(info.pins->inputs)));
      return false;
    }
    if (!input.from) return true;
    const auto source = result_.nodes.find(input.from->node);
    if (source == result_.nodes.end()) {
      std::vector<std::string> ids;
      for (const auto& [known, node] : material_.nodes) ids.push_back(known);
      fail(id, pin, fmt::format("wire from a node '{}' that is not there", input.from->node),
           suggestion(input.from->node, ids));
      return false;
    }
    const NodeInfo& from = source->second;
    if (from.kind && !from.pins->output(input.from->pin)) {
      if (!unresolvedCall(from))
        fail(id, pin, fmt::format("wire from '{}', but {} node has no output '{}'", input.from->node,
                                  withArticle("'" + from.kind->id + "'"), input.from->pin.substr(0, 80)),
             suggestion(input.from->pin, namesOf(from.pins->outputs)));
      return false;
    }
    return true;
  }

  static bool isCall(const NodeInfo& info) {
    return info.kind && (info.kind->builtin == Builtin::Function || info.kind->builtin == Builtin::Layer);
  }
  // A call whose function was not found has been reported; its wires are no news.
  bool unresolvedCall(const NodeInfo& info) const {
    return isCall(info) && (wrongCalls_.count(info.node) || (info.pins->inputs.empty() && info.pins->outputs.empty()));
  }

  void settleTypes(const NodeId& id, NodeInfo& info) {
    if (!info.kind) return;
    bool known = true;
    std::optional<ValueType> generic;
    std::string widest;  // the pin that decided it
    const auto widen = [&](const Pin& pin, ValueType type) {
      if (pin.type.kind == PinType::Kind::Any || !generic) {
        generic = pin.type.kind == PinType::Kind::Any ? type : promote(type, ValueType::Float);
        if (!generic) {
          fail(id, pin.name, fmt::format("{} is no number", type == ValueType::Attributes ? "a bundle of attributes" : described(type)),
               type == ValueType::Attributes ? "use 'break-attributes'" : "connect a number, vector or colour");
          known = false;
        }
        widest = pin.name;
        return;
      }
      const auto both = promote(*generic, type);
      if (!both) {
        fail(id, pin.name, fmt::format("{} {} not go with the {} of pin '{}'", described(type), type == ValueType::Attributes ? "do" : "does", name(*generic), widest),
             componentCount(type) == 0 ? "connect a number, vector or colour"
                                       : "a float is promoted; of others, 'split' takes single components");
        known = false;
      } else if (*both != *generic) {
        generic = both;
        widest = pin.name;
      }
    };

    for (const auto& [name, input] : info.node->inputs) {
      if (!checkEnds(id, info, name, input)) {
        // An input that does not exist does nothing; a wire that does not spoils what follows.
        known = known && !info.pins->input(name);
        continue;
      }
      const Pin& pin = *info.pins->input(name);
      if (input.from) {
        const auto type = result_.outputs.find(*input.from);
        if (type == result_.outputs.end()) {
          if (pin.type.kind != PinType::Kind::Exact) known = false;
          continue;
        }
        if (pin.type.kind != PinType::Kind::Exact)
          widen(pin, type->second);
        else if (!converts(type->second, pin.type.type))
          fail(id, name, fmt::format("{} cannot go into {}", described(type->second), described(pin.type.type)),
               conversionHint(type->second, pin.type.type));
      } else if (input.value) {
        if (pin.type.kind != PinType::Kind::Exact)
          widen(pin, input.value->type);
        else if (!coerced(*input.value, pin.type.type))
          fail(id, name, fmt::format("a constant of type {} at a pin of type {}", glint::name(input.value->type),
                                     glint::name(pin.type)), constantHint(pin.type.type));
        else if (pin.most && !inRange(*input.value, pin.minimum, *pin.most))
          warn(id, name, fmt::format("{} is outside {} to {}; the nearest is used", valueText(*input.value), pin.minimum, *pin.most));
      }
    }
    bool usesGeneric = false;
    for (const Pin& pin : info.pins->inputs) {
      if (pin.type.kind != PinType::Kind::Numeric) {
        usesGeneric = usesGeneric || pin.type.kind == PinType::Kind::Any;
        continue;
      }
      // Defaults count too: an unconnected pin may be a vector by itself.
      const auto input = info.node->inputs.find(pin.name);
      if (input == info.node->inputs.end() || input->second.empty()) widen(pin, defaultType(pin));
    }
    if (!generic && !usesGeneric) generic = ValueType::Float;
    if (!known) generic.reset();
    info.generic = generic;
    for (const Pin& pin : info.pins->outputs) {
      if (pin.type.kind == PinType::Kind::Exact)
        result_.outputs[{id, pin.name}] = pin.type.type;
      else if (generic)
        result_.outputs[{id, pin.name}] = *generic;
    }
  }

  static ValueType defaultType(const Pin& pin) {
    if (pin.surface.empty()) return pin.standard.type;
    return pin.surface.starts_with("uv") ? ValueType::Vec2 : ValueType::Vec3;
  }

  static std::string constantHint(ValueType type) {
    if (type == ValueType::Texture) return "connect a 'texture' node";
    if (type == ValueType::Attributes) return "connect a bundle of attributes, for example of 'make-attributes'";
    return jsonHint(type);
  }

  static std::string conversionHint(ValueType from, ValueType to) {
    if (to == ValueType::Attributes) return "use 'make-attributes'";
    if (from == ValueType::Attributes) return "use 'break-attributes'";
    if (to == ValueType::Texture) return "connect a 'texture' node";
    if (from == ValueType::Texture) return "use 'texture-sample'";
    if (to == ValueType::Bool) return "compare it with 'step' or choose with 'mix'";
    if (componentCount(from) > componentCount(to))
      return to == ValueType::Float ? "take one component with 'split', or 'luminance' of a colour"
                                    : "take components with 'split' and put them together again";
    return "put it together with a 'combine' node";
  }

  void checkSettings(const NodeId& id, const NodeInfo& info) {
    using Type = SettingInfo::Type;
    for (const SettingInfo& setting : info.kind->settings) {
      const auto found = info.node->settings.find(setting.name);
      if (found == info.node->settings.end()) {
        if (setting.type == Type::Function) checkCall(id, *info.node, info);
        continue;
      }
      const Json& value = found->second;
      const std::string wantedKind = writtenAs(setting.type == Type::Int || setting.type == Type::Number ? Json::Kind::Number
                                               : setting.type == Type::Bool                             ? Json::Kind::Bool
                                                                                                        : Json::Kind::String);
      const auto wrong = [&](std::string_view wanted) {
        fail(id, {}, fmt::format("'{}' must be {}, not {}", setting.name, wanted, name(value.kind)), wantedKind);
      };
      switch (setting.type) {
        case Type::Choice:
          if (!value.isString())
            wrong("a string");
          else if (std::find(setting.values.begin(), setting.values.end(), value.text) == setting.values.end())
            fail(id, {}, fmt::format("'{}' cannot be '{}'", setting.name, value.text.substr(0, 80)),
                 suggestion(value.text, setting.values));
          break;
        case Type::Int:
          if (!value.isNumber() || value.number != std::floor(value.number))
            wrong("a whole number");
          else if (value.number < setting.minimum || value.number > setting.maximum)
            warn(id, {}, fmt::format("'{}' is {}, outside {} to {}; the nearest is used", setting.name, value.text,
                                     setting.minimum, setting.maximum));
          break;
        case Type::Number:
          if (!value.isNumber()) wrong("a number");
          break;
        case Type::Bool:
          if (!value.isBool()) wrong("true or false");
          break;
        case Type::Text:
        case Type::File:
          if (!value.isString()) wrong("a string");
          break;
        case Type::Function:
          if (!value.isString())
            wrong("a string");
          else
            checkCall(id, *info.node, info);
          break;
        case Type::Value: checkValue(id, info, setting); break;
      }
    }
  }

  void checkValue(const NodeId& id, const NodeInfo& info, const SettingInfo& setting) {
    if (info.kind->builtin == Builtin::Comment) return;
    const auto type = valueType(settingText(*info.node, "type", "float"));
    if (!type || componentCount(*type) == 0) return;
    if (!settingValue(*info.node, setting.name, *type))
      fail(id, {}, fmt::format("'{}' is not {}", setting.name, described(*type)), jsonHint(*type));
  }

  void checkCall(const NodeId& id, const Node& node, const NodeInfo& info) {
    if (!context_.functions) return;
    const std::string function = settingText(node, "function");
    if (function.empty()) {
      fail(id, {}, fmt::format("no {} is chosen", info.kind->id),
           suggestion("", context_.functions->names()));
      return;
    }
    const auto found = context_.functions->find(function, folder_);
    if (!found) {
      for (const Diagnostic& d : found.diagnostics())
        fail(id, {}, fmt::format("cannot call '{}': {}: {}", function, d.place, d.what), d.hint);
      return;
    }
    if (info.kind->builtin == Builtin::Layer && (*found)->kind != DocumentKind::Layer) {
      wrongCalls_.insert(info.node);
      fail(id, {}, fmt::format("'{}' is a function, not a layer", function), "call it with a 'function' node");
    }
  }

  void checkDocument() {
    std::map<std::string, std::pair<NodeId, std::string>> parameters;
    std::vector<NodeId> outputs;
    std::map<std::string, NodeId> inputPorts, outputPorts;
    for (const auto& [id, info] : result_.nodes) {
      if (!info.kind) continue;
      switch (info.kind->builtin) {
        case Builtin::Output: outputs.push_back(id); break;
        case Builtin::Parameter: {
          std::string name = settingText(*info.node, "name");
          if (name.empty()) name = id;
          const std::string type = settingText(*info.node, "type", "float");
          const auto [at, fresh] = parameters.try_emplace(name, id, type);
          if (!fresh && at->second.second != type)
            fail(id, {}, fmt::format("parameter '{}' is {} here and {} in node '{}'", name, withArticle(type),
                                     withArticle(at->second.second), at->second.first),
                 "parameters of one name are one; rename one of them");
          break;
        }
        case Builtin::FunctionInput:
        case Builtin::FunctionOutput: {
          const bool input = info.kind->builtin == Builtin::FunctionInput;
          if (material_.kind == DocumentKind::Material) {
            fail(id, {}, "a material has no inputs or outputs of its own", "use it in a function or layer");
            break;
          }
          std::string name = settingText(*info.node, "name");
          if (name.empty()) name = id;
          auto& ports = input ? inputPorts : outputPorts;
          if (const auto [at, fresh] = ports.try_emplace(name, id); !fresh)
            fail(id, {}, fmt::format("{} '{}' is node '{}' already", input ? "input" : "output", name, at->second), "rename one of them");
          break;
        }
        default: break;
      }
    }
    if (material_.kind == DocumentKind::Material) {
      if (outputs.empty())
        result_.problems.push_back(error(material_.place(), "has no output node", "add a node of kind 'output'"));
      for (size_t i = 1; i < outputs.size(); ++i)
        fail(outputs[i], {}, fmt::format("is a second output beside '{}'", outputs[0]), "remove one");
      return;
    }
    for (const NodeId& id : outputs) fail(id, {}, "a function has no material output", "use 'function-output'");
    const FunctionSignature signature = signatureOf(material_);
    if (signature.outputs.empty())
      result_.problems.push_back(error(material_.place(), "has no output", "add a node of kind 'function-output'"));
    else if (material_.kind == DocumentKind::Layer &&
             (signature.outputs.size() != 1 || signature.outputs[0].type != ValueType::Attributes))
      result_.problems.push_back(error(material_.place(), "is a layer whose result is not one bundle of attributes",
                                       "give it one 'function-output' of type attributes"));
  }

  const Material& material_;
  const GraphContext& context_;
  std::filesystem::path folder_;
  std::set<const Node*> wrongCalls_;  // of what cannot be called so: reported
  GraphAnalysis result_;
};

}  // namespace

GraphAnalysis analyse(const Material& material, const GraphContext& context) {
  return Analyser(material, context).run();
}

std::optional<Value> coerced(const Value& value, ValueType type) {
  if (value.type == type) return value;
  const int count = componentCount(type);
  if (count == 0 || componentCount(value.type) == 0) return std::nullopt;
  Value result{type, value.v};
  if (componentCount(value.type) == 1) {
    if (type == ValueType::Bool) return std::nullopt;
    if (type == ValueType::Int && value.v[0] != std::floor(value.v[0])) return std::nullopt;
    for (int i = 0; i < 4; ++i) result.v[i] = i < count ? value.v[0] : 0;
    return result;
  }
  if (converts(value.type, type)) return result;
  return std::nullopt;
}

std::optional<Value> settingValue(const Node& node, std::string_view key, ValueType type) {
  const auto found = node.settings.find(std::string(key));
  if (found == node.settings.end()) return Value{type, {}};
  return valueFromJson(found->second, type);
}

}  // namespace glint
