// The kinds of node that GLSL text alone cannot express: those whose pins depend on the shading model, on the
// node or on another document.
#include <algorithm>

#include "materials/attributes.h"
#include "materials/function_library.h"
#include "materials/model.h"
#include "materials/node.h"
#include "materials/node_registry.h"

namespace glint {
namespace {

const std::vector<std::string> kValueTypes = {"float", "color", "vec2", "vec3", "vec4", "bool", "int"};
const std::vector<std::string> kPortTypes = {"float", "color", "vec2", "vec3",       "vec4",
                                             "bool",  "int",   "texture", "attributes"};

Pin pin(std::string name, std::string title, PinType type, std::string doc = {}) {
  Pin p;
  p.name = std::move(name);
  p.title = std::move(title);
  p.type = type;
  p.doc = std::move(doc);
  if (type.kind == PinType::Kind::Exact) p.standard.type = type.type;
  return p;
}

Pin attributesPin(std::string name, std::string title, bool optional, std::string doc) {
  Pin p = pin(std::move(name), std::move(title), PinType::exact(ValueType::Attributes), std::move(doc));
  p.optional = optional;
  return p;
}

SettingInfo choice(std::string name, std::string title, std::vector<std::string> values, std::string standard,
                   std::string doc) {
  SettingInfo s{.name = std::move(name), .title = std::move(title), .doc = std::move(doc),
                .type = SettingInfo::Type::Choice, .values = std::move(values)};
  s.standard = Json::of(std::move(standard));
  return s;
}

SettingInfo setting(SettingInfo::Type type, std::string name, std::string title, Json standard,
                    std::string doc, float minimum = 0, float maximum = 1) {
  return {.name = std::move(name), .title = std::move(title), .doc = std::move(doc), .type = type,
          .values = {}, .standard = std::move(standard), .minimum = minimum, .maximum = maximum};
}

std::vector<SettingInfo> textureSettings() {
  using Type = SettingInfo::Type;
  return {
      setting(Type::File, "file", "File", Json::of(""), "A picture, relative to the material's folder"),
      choice("colorSpace", "Colour space", {"srgb", "linear"}, "srgb",
             "srgb for colours; linear for data such as roughness, masks and normals"),
      choice("wrap", "Wrap", {"repeat", "clamp", "mirror"}, "repeat", "What lies outside 0..1"),
      choice("wrapV", "Wrap V", {"same", "repeat", "clamp", "mirror"}, "same", "Where it differs up and down from across"),
      choice("filter", "Filter", {"linear", "nearest"}, "linear", "Between texels"),
  };
}

std::vector<SettingInfo> valueSettings(bool parameter) {
  using Type = SettingInfo::Type;
  std::vector<SettingInfo> settings;
  if (parameter)
    settings.push_back(setting(Type::Text, "name", "Name", Json::of(""),
                               "What the slider is called; parameters of one name are one"));
  settings.push_back(choice("type", "Type", kValueTypes, "float", "What it carries"));
  settings.push_back(setting(Type::Value, "value", "Value", Json::of(0), "The value"));
  if (parameter) {
    settings.push_back(setting(Type::Number, "min", "Least", Json::of(0), "Left end of the slider", -1e6f, 1e6f));
    settings.push_back(setting(Type::Number, "max", "Most", Json::of(1), "Right end of the slider", -1e6f, 1e6f));
    settings.push_back(setting(Type::Text, "doc", "Description", Json::of(""), "Shown beside the slider"));
  }
  return settings;
}

std::vector<SettingInfo> portSettings(bool input) {
  using Type = SettingInfo::Type;
  std::vector<SettingInfo> settings = {
      setting(Type::Text, "name", "Name", Json::of(""), "Name of the pin on the node that calls"),
      choice("type", "Type", kPortTypes, "float", "What it carries"),
      setting(Type::Number, "order", "Order", Json::of(0), "Pins are sorted by this, then by name", -1000, 1000),
      setting(Type::Text, "doc", "Description", Json::of(""), "Shown with the pin"),
  };
  if (input) {
    settings.push_back(setting(Type::Value, "value", "Default", Json::of(0), "While nothing is connected"));
    settings.push_back(choice("surface", "Default of the surface",
                              {"none", "uv0", "uv1", "position", "localPosition", "normal", "view"}, "none",
                              "What the surface has, instead of the default: uv0 and uv1 for a vec2, others for a vec3"));
    settings.push_back(setting(Type::Number, "min", "Least", Json::of(0), "Left end of the slider", -1e6f, 1e6f));
    settings.push_back(setting(Type::Number, "max", "Most", Json::of(1), "Right end of the slider", -1e6f, 1e6f));
  }
  return settings;
}

NodeKind kind(Builtin builtin, std::string id, std::string title, std::string category, std::string doc,
              std::vector<std::string> keywords = {}) {
  NodeKind k;
  k.builtin = builtin;
  k.id = std::move(id);
  k.title = std::move(title);
  k.category = std::move(category);
  k.doc = std::move(doc);
  k.keywords = std::move(keywords);
  return k;
}

}  // namespace

std::vector<NodeKind> builtinNodeKinds() {
  using Type = SettingInfo::Type;
  std::vector<NodeKind> kinds;
  const auto add = [&](NodeKind k) -> NodeKind& { return kinds.emplace_back(std::move(k)); };

  add(kind(Builtin::Output, "output", "Material output", "Attributes",
           "The material's attributes: those on the wire, then each pin that is connected or set",
           {"result", "main", "root"}));
  add(kind(Builtin::MakeAttributes, "make-attributes", "Make attributes", "Attributes",
           "One bundle from single attributes; what is not given is standard", {"material", "bundle"}));
  add(kind(Builtin::SetAttributes, "set-attributes", "Set attributes", "Attributes",
           "Replaces the attributes that are connected or set, and passes the others", {"override"}));
  add(kind(Builtin::BreakAttributes, "break-attributes", "Break attributes", "Attributes",
           "The single attributes of a bundle", {"get", "split"}));
  add(kind(Builtin::BlendAttributes, "blend-attributes", "Blend attributes", "Attributes",
           "Lays B over A by a mask: the attributes are mixed, not the shaded results",
           {"layer", "mix", "lerp", "mask"}));

  add(kind(Builtin::Parameter, "parameter", "Parameter", "Input",
           "A value with a name that changes without a compile", {"uniform", "slider", "scalar", "color"}))
      .settings = valueSettings(true);
  add(kind(Builtin::Constant, "constant", "Constant", "Input", "A fixed value",
           {"value", "number", "color", "vector"}))
      .settings = valueSettings(false);

  NodeKind& texture = add(kind(Builtin::Texture, "texture", "Texture", "Texture",
                               "A picture to be sampled, for several samples or a layer's input", {"image"}));
  texture.settings = textureSettings();
  texture.outputs = {pin("texture", "Texture", PinType::exact(ValueType::Texture))};
  NodeKind& sample = add(kind(Builtin::TextureSample, "texture-sample", "Texture sample", "Texture",
                              "A picture at a texture coordinate; its own file while no texture is connected",
                              {"image", "map", "bitmap"}));
  sample.settings = textureSettings();
  sample.inputs = {pin("texture", "Texture", PinType::exact(ValueType::Texture)),
                   pin("uv", "UV", PinType::exact(ValueType::Vec2), "Texture coordinate; v grows downwards")};
  sample.inputs[0].optional = true;
  sample.inputs[1].surface = "uv0";
  sample.outputs = {pin("color", "Color", PinType::exact(ValueType::Color)),
                    pin("r", "R", PinType::exact(ValueType::Float)),
                    pin("g", "G", PinType::exact(ValueType::Float)),
                    pin("b", "B", PinType::exact(ValueType::Float)),
                    pin("a", "A", PinType::exact(ValueType::Float))};

  add(kind(Builtin::FunctionInput, "function-input", "Function input", "Function",
           "An input pin of the function that this graph is"))
      .settings = portSettings(true);
  add(kind(Builtin::FunctionOutput, "function-output", "Function output", "Function",
           "An output pin of the function that this graph is"))
      .settings = portSettings(false);
  add(kind(Builtin::Function, "function", "Function", "Function", "Calls another graph", {"call", "subgraph"}))
      .settings = {setting(Type::Function, "function", "Function", Json::of(""),
                           "A shipped function's name, or a file relative to the material's folder")};
  add(kind(Builtin::Layer, "layer", "Layer", "Attributes",
           "A function that yields a bundle of attributes, to be blended with others", {"material", "call"}))
      .settings = {setting(Type::Function, "function", "Layer", Json::of(""),
                           "A shipped layer's name, or a file relative to the material's folder")};

  NodeKind& reroute = add(kind(Builtin::Reroute, "reroute", "Reroute", "Organisation",
                               "A bend in a wire", {"dot", "knot"}));
  reroute.inputs = {pin("in", "", PinType::any())};
  reroute.outputs = {pin("out", "", PinType::any())};
  add(kind(Builtin::Comment, "comment", "Comment", "Organisation", "A frame with a text, behind the nodes",
           {"frame", "note", "group"}))
      .settings = {setting(Type::Text, "text", "Text", Json::of(""), "What it says"),
                   setting(Type::Number, "width", "Width", Json::of(320), "Of the frame", 40, 10000),
                   setting(Type::Number, "height", "Height", Json::of(200), "Of the frame", 40, 10000),
                   setting(Type::Value, "color", "Color", Json::of("#3a4a5a"), "Of the frame")};
  return kinds;
}

std::vector<Pin> attributePins(const ShadingModel* model) {
  std::vector<Pin> pins;
  for (const Attribute& attribute : attributes()) {
    Pin p = pin(std::string(attribute.name), std::string(attribute.title),
                PinType::exact(attribute.standard.type), std::string(attribute.doc));
    p.standard = attribute.standard;
    p.minimum = attribute.minimum;
    p.maximum = attribute.maximum;
    p.most = attribute.most;
    p.optional = true;
    pins.push_back(std::move(p));
  }
  if (model)
    for (const ModelParameter& parameter : model->parameters) {
      if (parameter.slot < 0) continue;
      Pin p = pin(parameter.name, parameter.title.empty() ? parameter.name : parameter.title,
                  PinType::exact(parameter.standard.type), parameter.doc);
      p.standard = parameter.standard;
      p.minimum = parameter.minimum;
      p.maximum = p.most.emplace(parameter.maximum);
      p.optional = true;
      pins.push_back(std::move(p));
    }
  return pins;
}

// The pins of the nodes that take bundles apart and put them together, for one shading model.
struct AttributeNodePins {
  NodePinsPtr output, make, set, breakUp, blend;

  explicit AttributeNodePins(const ShadingModel* model) {
    const std::vector<Pin> each = attributePins(model);
    const Pin bundle = attributesPin("attributes", "Attributes", true, "What the pins below start from");
    const Pin result = attributesPin("attributes", "Attributes", false, "The bundle");
    std::vector<Pin> bundleAndEach = {bundle};
    bundleAndEach.insert(bundleAndEach.end(), each.begin(), each.end());
    output = std::make_shared<NodePins>(NodePins{bundleAndEach, {}});
    set = std::make_shared<NodePins>(NodePins{bundleAndEach, {result}});
    make = std::make_shared<NodePins>(NodePins{each, {result}});
    breakUp = std::make_shared<NodePins>(NodePins{{bundle}, each});
    Pin mask = pin("mask", "Mask", PinType::exact(ValueType::Float), "0 shows A, 1 shows B");
    mask.standard = Value::scalar(0.5f);
    blend = std::make_shared<NodePins>(
        NodePins{{attributesPin("a", "A", true, "The lower bundle"),
                  attributesPin("b", "B", true, "The upper bundle"), mask},
                 {result}});
  }
};

namespace {

NodePinsPtr valuePins(const Node& node) {
  Pin p = pin("value", "Value",
              PinType::exact(valueType(settingText(node, "type", "float")).value_or(ValueType::Float)));
  return std::make_shared<NodePins>(NodePins{{}, {std::move(p)}});
}

Pin portPin(const FunctionSignature::Port& port) {
  Pin p = pin(port.name, port.name, PinType::exact(port.type), port.doc);
  if (componentCount(port.type) > 0) p.standard = port.standard;
  p.surface = port.surface;
  p.optional = componentCount(port.type) == 0;
  p.minimum = port.minimum;
  p.maximum = port.maximum;
  return p;
}

NodePinsPtr functionPins(const Node& node, const GraphContext& context, const std::filesystem::path& folder) {
  NodePins pins;
  if (context.functions)
    if (const auto found = context.functions->find(settingText(node, "function"), folder)) {
      const FunctionSignature signature = signatureOf(**found);
      for (const auto& port : signature.inputs) pins.inputs.push_back(portPin(port));
      for (const auto& port : signature.outputs) pins.outputs.push_back(portPin(port));
    }
  return std::make_shared<NodePins>(std::move(pins));
}

}  // namespace

NodePinsPtr pinsOf(const Node& node, const GraphContext& context, const std::filesystem::path& folder) {
  static const NodePinsPtr none = std::make_shared<NodePins>();
  const NodeKind* kind = context.nodes.find(node.kind);
  if (!kind) return none;
  const auto attributeNodes = [&]() -> const AttributeNodePins& {
    if (!context.attributeNodes)
      context.attributeNodes = std::make_shared<const AttributeNodePins>(context.model);
    return *context.attributeNodes;
  };
  switch (kind->builtin) {
    case Builtin::Output: return attributeNodes().output;
    case Builtin::MakeAttributes: return attributeNodes().make;
    case Builtin::SetAttributes: return attributeNodes().set;
    case Builtin::BreakAttributes: return attributeNodes().breakUp;
    case Builtin::BlendAttributes: return attributeNodes().blend;
    case Builtin::Constant:
    case Builtin::Parameter:
    case Builtin::FunctionInput: return valuePins(node);
    case Builtin::FunctionOutput: {
      NodePins pins = *valuePins(node);
      std::swap(pins.inputs, pins.outputs);
      return std::make_shared<NodePins>(std::move(pins));
    }
    case Builtin::Function:
    case Builtin::Layer: return functionPins(node, context, folder);
    case Builtin::None:
    case Builtin::Texture:
    case Builtin::TextureSample:
    case Builtin::Reroute:
    case Builtin::Comment: break;
  }
  return context.nodes.pins(*kind);
}

}  // namespace glint
