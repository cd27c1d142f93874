#include "renderer/gltf_geometry.h"

#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <optional>

namespace glint {
namespace {

constexpr const char* kHint = "export the file again";

template <class T>
const T* at(const std::vector<T>& list, int index) {
  return index >= 0 && size_t(index) < list.size() ? &list[size_t(index)] : nullptr;
}

// Elements of up to four components in a buffer.
struct Span {
  const unsigned char* first = nullptr;
  size_t stride = 0, count = 0;
  int component = 0, components = 0;
  bool normalized = false;

  const unsigned char* element(size_t i) const { return first + i * stride; }

  template <class T>
  static T load(const unsigned char* p) {
    T value;
    std::memcpy(&value, p, sizeof value);
    return value;
  }
  // glTF 2.0, 3.6.2.2: normalised integers stand for 0..1 or -1..1.
  float number(size_t i, int c) const {
    const unsigned char* p = element(i);
    switch (component) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT: return load<float>(p + 4 * c);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return float(p[c]) / (normalized ? 255.0f : 1.0f);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return float(load<uint16_t>(p + 2 * c)) / (normalized ? 65535.0f : 1.0f);
      case TINYGLTF_COMPONENT_TYPE_BYTE: {
        const auto v = float(static_cast<signed char>(p[c]));
        return normalized ? std::max(v / 127.0f, -1.0f) : v;
      }
      case TINYGLTF_COMPONENT_TYPE_SHORT: {
        const float v = load<int16_t>(p + 2 * c);
        return normalized ? std::max(v / 32767.0f, -1.0f) : v;
      }
      default: return 0;
    }
  }
  uint32_t whole(size_t i) const {
    const unsigned char* p = element(i);
    switch (component) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return *p;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load<uint16_t>(p);
      default: return load<uint32_t>(p);
    }
  }
};

// `count` elements from `offset` of a buffer view; nothing when they do not lie within it.
std::optional<Span> span(const tinygltf::Model& model, int viewIndex, size_t offset, size_t count, int component,
                         int components, bool tight) {
  const auto* view = at(model.bufferViews, viewIndex);
  const auto* buffer = view ? at(model.buffers, view->buffer) : nullptr;
  const int size = tinygltf::GetComponentSizeInBytes(uint32_t(component));
  if (!buffer || size <= 0 || components < 1 || components > 4 || count == 0) return {};
  const size_t element = size_t(size) * size_t(components);
  const size_t stride = tight || view->byteStride == 0 ? element : view->byteStride;
  const size_t bytes = buffer->data.size();
  if (view->byteOffset > bytes || view->byteLength > bytes - view->byteOffset || offset > view->byteLength || stride < element) return {};
  const size_t room = view->byteLength - offset;
  if (room < element || (count - 1) > (room - element) / stride) return {};
  return Span{buffer->data.data() + view->byteOffset + offset, stride, count, component, components, false};
}

// Reads the accessors of one primitive. Every function gives false, or nothing, after it has said what is wrong.
class Reader {
 public:
  Reader(const tinygltf::Model& model, std::string place) : model_(model), place_(std::move(place)) {}
  Diagnostics problems;

  const tinygltf::Accessor* accessor(const tinygltf::Primitive& primitive, const char* name) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return nullptr;
    const auto* accessor = at(model_.accessors, found->second);
    if (!accessor) fault(fmt::format("attribute {} names no accessor", name));
    return accessor;
  }

  // Calls set(i, numbers) for every element, with four numbers (those that the file lacks are `rest`), all finite.
  template <class Set>
  bool each(const tinygltf::Accessor& accessor, const char* name, size_t expected, const glm::vec4& rest, Set&& set) {
    const int components = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
    if (components < 1 || components > 4 || accessor.count != expected) return fault(fmt::format("{} is malformed", name));
    const auto value = [&](const Span& from, size_t i) {
      glm::vec4 v = rest;
      for (int c = 0; c < from.components; ++c) v[c] = from.number(i, c);
      return v;
    };
    std::optional<Span> base;
    if (accessor.bufferView >= 0) {
      base = span(model_, accessor.bufferView, accessor.byteOffset, accessor.count, accessor.componentType, components, false);
      if (!base) return fault(fmt::format("{} reaches over the end of its buffer", name));
      base->normalized = accessor.normalized;
    }
    glm::vec4 zero = rest;
    for (int c = 0; c < components; ++c) zero[c] = 0;
    for (size_t i = 0; i < expected; ++i) {
      const glm::vec4 v = base ? value(*base, i) : zero;
      if (!finite(v)) return fault(fmt::format("{} of vertex {} is not finite", name, i));
      set(i, v);
    }
    return !accessor.sparse.isSparse || eachSparse(accessor, name, components, value, set);
  }

  bool indices(const tinygltf::Primitive& primitive, size_t vertices, std::vector<uint32_t>& out) {
    if (primitive.indices < 0) {
      for (uint32_t i = 0; i < vertices; ++i) out.push_back(i);
      return true;
    }
    const auto* accessor = at(model_.accessors, primitive.indices);
    const bool type = accessor && accessor->type == TINYGLTF_TYPE_SCALAR && isUnsigned(accessor->componentType);
    if (!type) return fault("the indices are malformed");
    out.assign(accessor->count, 0);
    if (accessor->bufferView >= 0) {
      const auto from = span(model_, accessor->bufferView, accessor->byteOffset, accessor->count, accessor->componentType, 1, true);
      if (!from) return fault("the indices reach over the end of their buffer");
      for (size_t i = 0; i < out.size(); ++i) out[i] = from->whole(i);
    }
    if (accessor->sparse.isSparse &&
        !eachSparse(*accessor, "indices", 1, [](const Span& from, size_t i) { return from.whole(i); },
                    [&](size_t i, uint32_t v) { out[i] = v; }))
      return false;
    for (size_t i = 0; i < out.size(); ++i)
      if (out[i] >= vertices) return fault(fmt::format("index {} is {}, but there are {} vertices", i, out[i], vertices));
    return true;
  }

  bool fault(const std::string& what) {
    problems.push_back(error(place_, what, kHint));
    return false;
  }

 private:
  static bool isUnsigned(int component) {
    return component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  }
  static bool finite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
  }
  static bool finite(uint32_t) { return true; }

  template <class ValueOf, class Set>
  bool eachSparse(const tinygltf::Accessor& accessor, const char* name, int components, ValueOf&& value, Set&& set) {
    const auto& sparse = accessor.sparse;
    const bool sane = sparse.count > 0 && size_t(sparse.count) <= accessor.count && sparse.indices.byteOffset >= 0 &&
                      sparse.values.byteOffset >= 0 && isUnsigned(sparse.indices.componentType);
    const auto where = sane ? span(model_, sparse.indices.bufferView, size_t(sparse.indices.byteOffset), size_t(sparse.count), sparse.indices.componentType, 1, true) : std::nullopt;
    auto what = sane ? span(model_, sparse.values.bufferView, size_t(sparse.values.byteOffset), size_t(sparse.count), accessor.componentType, components, true) : std::nullopt;
    if (!where || !what) return fault(fmt::format("the sparse part of {} is malformed", name));
    what->normalized = accessor.normalized;
    for (size_t k = 0; k < where->count; ++k) {
      const uint32_t i = where->whole(k);
      if (i >= accessor.count) return fault(fmt::format("the sparse part of {} replaces element {} of {}", name, i, accessor.count));
      const auto v = value(*what, k);
      if (!finite(v)) return fault(fmt::format("{} of vertex {} is not finite", name, i));
      set(size_t(i), v);
    }
    return true;
  }

  const tinygltf::Model& model_;
  std::string place_;
};

// Strips and fans as separate triangles (glTF 2.0, 3.7.2.1).
std::vector<uint32_t> triangles(std::vector<uint32_t> in, int mode) {
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    in.resize(in.size() / 3 * 3);
    return in;
  }
  std::vector<uint32_t> out;
  for (size_t i = 0; i + 2 < in.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
      out.insert(out.end(), {in[i + 1], in[i + 2], in[0]});
    else
      out.insert(out.end(), {in[i], in[i + 1 + i % 2], in[i + 2 - i % 2]});
  }
  return out;
}

// Every triangle with vertices of its own, so that its normal is its own too.
void separate(Mesh& mesh) {
  std::vector<Vertex> vertices;
  vertices.reserve(mesh.indices.size());
  for (uint32_t& i : mesh.indices) {
    vertices.push_back(mesh.vertices[i]);
    i = uint32_t(vertices.size() - 1);
  }
  mesh.vertices = std::move(vertices);
}

}  // namespace

bool hasTriangles(const tinygltf::Primitive& primitive) {
  // An absent mode is -1 here, and means triangles.
  return primitive.mode == -1 || primitive.mode == TINYGLTF_MODE_TRIANGLES ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP || primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

Result<Mesh> gltfMesh(const tinygltf::Model& model, const tinygltf::Primitive& primitive, int normalMapTexCoord,
                      const std::string& place) {
  Reader reader(model, place);
  Mesh mesh;
  const auto* positions = reader.accessor(primitive, "POSITION");
  if (!positions) {
    if (reader.problems.empty()) reader.fault("has no POSITION");
    return reader.problems;
  }
  const size_t count = positions->count;
  mesh.vertices.resize(count);
  auto& v = mesh.vertices;
  const auto read = [&](const char* name, const glm::vec4& rest, auto&& set) {
    const auto* accessor = reader.accessor(primitive, name);
    return accessor && reader.each(*accessor, name, count, rest, set);
  };
  read("POSITION", {0, 0, 0, 1}, [&](size_t i, const glm::vec4& x) { v[i].position = x; });
  const bool normals = read("NORMAL", {0, 0, 1, 0}, [&](size_t i, const glm::vec4& x) { v[i].normal = x; });
  const bool tangents = read("TANGENT", {1, 0, 0, 1}, [&](size_t i, const glm::vec4& x) { v[i].tangent = x; });
  read("TEXCOORD_0", {}, [&](size_t i, const glm::vec4& x) { v[i].uv0 = x; });
  if (!read("TEXCOORD_1", {}, [&](size_t i, const glm::vec4& x) { v[i].uv1 = x; }))
    for (Vertex& vertex : v) vertex.uv1 = vertex.uv0;
  read("COLOR_0", {1, 1, 1, 1}, [&](size_t i, const glm::vec4& x) { v[i].color = x; });
  std::vector<uint32_t> indices;
  reader.indices(primitive, count, indices);
  if (!reader.problems.empty()) return reader.problems;

  mesh.indices = triangles(std::move(indices), primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode);
  if (normals) {
    for (Vertex& vertex : v) {
      // Quantized and careless files have normals that are not quite unit, or zero.
      const float length = glm::length(vertex.normal);
      vertex.normal = length > 1e-12f && std::isfinite(length) ? vertex.normal / length : glm::vec3(0, 0, 1);
    }
  } else {
    separate(mesh);
    computeNormals(mesh);
  }
  if (normals && tangents) {
    for (Vertex& vertex : v) {
      const float length = glm::length(glm::vec3(vertex.tangent));
      vertex.tangent = length > 1e-12f && std::isfinite(length)
                           ? glm::vec4(glm::vec3(vertex.tangent) / length, vertex.tangent.w < 0 ? -1.0f : 1.0f)
                           : glm::vec4(1, 0, 0, 1);
    }
  } else {
    computeTangents(mesh, normalMapTexCoord == 1 ? &Vertex::uv1 : &Vertex::uv0);
  }
  return mesh;
}

}  // namespace glint
