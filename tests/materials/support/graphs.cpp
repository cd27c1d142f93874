#include "tests/materials/support/graphs.h"

namespace glint::test {
namespace {

PinRef ref(const std::string& text) {
  const size_t dot = text.find('.');
  return {text.substr(0, dot), text.substr(dot + 1)};
}

}  // namespace

const NodeRegistry& nodes() {
  static const NodeRegistry registry;
  return registry;
}

FunctionLibrary& functions() {
  static FunctionLibrary library;
  return library;
}

const ShadingModel& ggx() {
  static const ShadingModel model = [] {
    ShadingModel m;
    m.id = "ggx";
    return m;
  }();
  return model;
}

const ShadingModel& withParameters() {
  static const ShadingModel model = [] {
    ShadingModel m;
    m.id = "special";
    ModelParameter gamma{.name = "gamma", .title = "Tail", .doc = "", .standard = Value::scalar(1.5f)};
    gamma.minimum = 1;
    gamma.maximum = 4;
    gamma.slot = 0;
    ModelParameter tint{.name = "tint", .title = "Tint", .doc = "", .standard = Value::color(1, 1, 1)};
    tint.slot = 1;
    ModelParameter quality{.name = "quality", .title = "Quality", .doc = "", .standard = Value::scalar(0.5f)};
    m.parameters = {gamma, tint, quality};
    return m;
  }();
  return model;
}

std::string texts(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) text += d.text() + "\n";
  return text;
}

Result<CompiledMaterial> compile(const Material& material, const ShadingModel& model) {
  return compileMaterial(material, model, nodes(), functions());
}

Node& add(Material& material, const std::string& id, const std::string& kind) {
  material.layout[id] = {};
  Node& node = material.nodes[id];
  node.kind = kind;
  return node;
}

void wire(Material& material, const std::string& from, const std::string& to) {
  const PinRef end = ref(to);
  material.nodes[end.node].inputs[end.pin].from = ref(from);
}

Material materialOf(const NodeKind& kind, ValueType numeric) {
  Material m = newMaterial(kind.id);
  // Uniforms, so that nothing can be folded.
  const auto parameter = [&](const char* id, ValueType type) {
    Node& source = add(m, id, "parameter");
    source.settings["name"] = Json::of(id);
    source.settings["type"] = Json::of(std::string(name(type)));
    source.settings["value"] = Json::of(0.25);
  };
  parameter("source", numeric);
  parameter("scalar", ValueType::Float);
  add(m, "subject", kind.id);
  for (const Pin& pin : kind.inputs)
    if (pin.type.kind == PinType::Kind::Numeric)
      wire(m, "source.value", "subject." + pin.name);
    else if (pin.type.type == ValueType::Float)
      wire(m, "scalar.value", "subject." + pin.name);
  // The sum over all components of all outputs.
  std::string sum;
  int n = 0;
  const auto plus = [&](const std::string& from) {
    if (sum.empty()) {
      sum = from;
      return;
    }
    const std::string id = "sum" + std::to_string(n++);
    add(m, id, "add");
    wire(m, sum, id + ".a");
    wire(m, from, id + ".b");
    sum = id + ".value";
  };
  for (const Pin& pin : kind.outputs) {
    const std::string split = "split-" + pin.name;
    add(m, split, "split");
    wire(m, "subject." + pin.name, split + ".x");
    for (const char* component : {".x", ".y", ".z", ".w"}) plus(split + component);
  }
  wire(m, sum, "output.roughness");
  return m;
}

Material bigMaterial(int count) {
  Material m = newMaterial("big");
  Node& parameter = add(m, "strength", "parameter");
  parameter.settings["name"] = Json::of("Strength");
  parameter.settings["value"] = Json::of(0.5);
  const char* kinds[] = {"add", "multiply", "mix", "max", "remap"};
  std::string last = "strength.value";
  for (int i = 0; i < count - 2; ++i) {
    const std::string id = "n" + std::to_string(i);
    const std::string kind = kinds[i % 5];
    Node& node = add(m, id, kind);
    if (kind == "remap") {
      node.inputs["toHigh"].value = Value::scalar(1.f + static_cast<float>(i));
      wire(m, last, id + ".x");
    } else {
      wire(m, last, id + ".a");
      node.inputs["b"].value = Value::scalar(0.01f * static_cast<float>(i + 1));
    }
    last = id + ".value";
  }
  wire(m, last, "output.roughness");
  return m;
}

}  // namespace glint::test
