// A kind of node: what the graph can be made of. Most are data, one file each in shaders/nodes/<id>.glsl:
//
//   /*glint
//   { "id": "remap", "title": "Remap", "category": "Math", "doc": "Moves a range onto another.",
//     "inputs": [{"name": "x", "type": "numeric", "default": 0, "doc": "..."},
//                {"name": "uv", "type": "vec2", "default": "uv0"},
//                {"name": "scale", "type": "float", "default": 4, "min": 0, "max": 100}],
//     "outputs": [{"name": "value", "type": "numeric"}],
//     "settings": [{"name": "space", "type": "choice", "values": ["world", "tangent"], "default": "world"},
//                  {"name": "octaves", "type": "int", "min": 1, "max": 8, "default": 4}],
//     "variance": "x * scale", "surface": true, "includes": ["noise"], "keywords": ["fit"] }
//   */
//   T node_remap(MaterialInputs i, T x, vec2 uv, float scale, int space, int octaves) { ... }
//
// The GLSL defines one function, `node_<id>` with '-' as '_'. Its arguments are `MaterialInputs i` when the
// head says "surface", the inputs, then the settings (a choice is its index) as constants; it returns the
// output, or takes one `out` argument for each when there are several. `T` stands for the type that
// "numeric" pins have in the graph at hand: float, vec2, vec3 or vec4; the function is emitted once for each
// that occurs. "default" may name what the surface has instead of a constant: uv0, uv1, position,
// localPosition, normal, view. "variance" is for nodes that make one normal: GLSL for the variance of its slopes within a
// pixel, along one axis, of the inputs' names, where one that is a vec3 stands for its own variance. "includes" are files of shaders/nodes/lib/.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/base/json.h"
#include "materials/graph.h"
#include "materials/value.h"

namespace glint {

struct ShadingModel;
class NodeRegistry;
class FunctionLibrary;
struct AttributeNodePins;

// The type of a pin. Numeric: Float, Vec2, Vec3, Vec4 or Color, the same for all numeric pins of one node:
// the widest that is connected, where a float is promoted to any. Any: whatever is connected.
struct PinType {
  enum class Kind { Exact, Numeric, Any } kind = Kind::Exact;
  ValueType type = ValueType::Float;  // when Exact

  static PinType exact(ValueType t) { return {Kind::Exact, t}; }
  static PinType numeric() { return {Kind::Numeric}; }
  static PinType any() { return {Kind::Any}; }
  bool operator==(const PinType&) const = default;
};
std::string_view name(PinType);  // "numeric", "any" or the type's own
std::optional<PinType> pinType(std::string_view name);

// Whether a wire may carry `from` into a pin of type `to`: the same type, bool and int to float, float to any
// vector or colour, vec3 to colour and back.
bool converts(ValueType from, ValueType to);
// The type that arithmetic between the two has: nothing when neither is promoted to the other.
std::optional<ValueType> promote(ValueType, ValueType);

struct Pin {
  std::string name, title, doc;
  PinType type;
  Value standard;               // of an input that has neither wire nor constant
  std::string surface;          // or the name of what the surface has there; empty: `standard`
  float minimum = 0, maximum = 1;  // of sliders
  std::optional<float> most;    // only what lies in minimum..most means anything; absent: every number does
  bool optional = false;        // an input that does nothing while it has neither wire nor constant
};

// Something chosen in the node rather than fed to it.
struct SettingInfo {
  enum class Type { Choice, Int, Bool, Number, Text, Value, File, Function };
  std::string name, title, doc;
  Type type = Type::Choice;
  std::vector<std::string> values;  // of a Choice
  Json standard;                    // what it is when the node does not say
  float minimum = 0, maximum = 1;
};

// What only C++ can express; see materials/builtin_nodes.cpp.
enum class Builtin {
  None,  // data
  Output, MakeAttributes, BreakAttributes, SetAttributes, BlendAttributes,
  Constant, Parameter, Texture, TextureSample,
  FunctionInput, FunctionOutput, Function, Layer, Reroute, Comment,
};

struct NodeKind {
  std::string id, title, category, doc;
  std::vector<std::string> keywords;    // other names to find it by
  std::vector<Pin> inputs, outputs;     // of builtin kinds whose pins depend on the node, see pinsOf()
  std::vector<SettingInfo> settings;
  bool surface = false;
  std::vector<std::string> includes;
  std::string variance;                 // of the head; may be empty
  Builtin builtin = Builtin::None;
  std::string file;                     // as diagnostics name it; empty when builtin
  std::string source;                   // GLSL with the head blanked
  std::string function;                 // "node_remap"
  int64_t operations = 1;               // of the function, see glslOperations()

  const Pin* input(std::string_view name) const;
  const Pin* output(std::string_view name) const;
  const SettingInfo* setting(std::string_view name) const;
};

// One node file; every fault of the head at its line.
Result<NodeKind> parseNodeKind(const std::string& file, const std::string& text);
// The kinds that are C++.
std::vector<NodeKind> builtinNodeKinds();

struct NodePins {
  std::vector<Pin> inputs, outputs;
  const Pin* input(std::string_view name) const;
  const Pin* output(std::string_view name) const;
};
using NodePinsPtr = std::shared_ptr<const NodePins>;

// What a graph means depends on: which nodes there are, which attributes its model adds, which functions it
// can call.
struct GraphContext {
  const NodeRegistry& nodes;
  const ShadingModel* model = nullptr;     // null: only the attributes that every material has
  const FunctionLibrary* functions = nullptr;
  // Made at the first use: keep a context while its model stays.
  mutable std::shared_ptr<const AttributeNodePins> attributeNodes = nullptr;
};

// The pins of one node. Never null; empty for an unknown kind or a function that cannot be found. Cheap: the
// pins of data nodes are shared, those of attributes are made once for a context.
NodePinsPtr pinsOf(const Node&, const GraphContext&, const std::filesystem::path& folder = {});

// The attributes and the model's per-pixel parameters as pins, in order.
std::vector<Pin> attributePins(const ShadingModel*);

}  // namespace glint
