#include "renderer/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "materials/base/check.h"
#include "materials/base/hash.h"

namespace glint {

void Mesh::bounds(glm::vec3& low, glm::vec3& high) const {
  low = high = vertices.empty() ? glm::vec3(0) : vertices.front().position;
  for (const Vertex& v : vertices) {
    low = glm::min(low, v.position);
    high = glm::max(high, v.position);
  }
}

void computeNormals(Mesh& mesh) {
  for (Vertex& v : mesh.vertices) v.normal = glm::vec3(0);
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Vertex& a = mesh.vertices[mesh.indices[i]];
    Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    // The cross product's length is twice the area: the weight.
    const glm::vec3 normal = glm::cross(b.position - a.position, c.position - a.position);
    a.normal += normal;
    b.normal += normal;
    c.normal += normal;
  }
  for (Vertex& v : mesh.vertices) {
    // Scaled first: the squares of a millimetre mesh's areas would underflow.
    const float largest = std::max({std::abs(v.normal.x), std::abs(v.normal.y), std::abs(v.normal.z)});
    const bool usable = largest > 0 && std::isfinite(largest);
    v.normal = usable ? glm::normalize(v.normal / largest) : glm::vec3(0, 0, 1);
  }
}

namespace {

glm::vec3 anyPerpendicular(const glm::vec3& n) {
  const glm::vec3 axis = std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(axis - n * glm::dot(n, axis));
}

// A vector's direction, or zero when it has none.
glm::vec3 direction(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : glm::vec3(0);
}

// Vertices that agree in place, normal and uv share their tangent, however the file split them.
std::vector<uint32_t> weld(const std::vector<Vertex>& vertices, glm::vec2 Vertex::*uv) {
  struct Key {
    std::array<float, 8> v;
    bool operator==(const Key& other) const { return std::memcmp(v.data(), other.v.data(), sizeof v) == 0; }
  };
  struct Hash {
    size_t operator()(const Key& key) const { return hashBytes(key.v.data(), sizeof key.v); }
  };
  std::unordered_map<Key, uint32_t, Hash> first;
  first.reserve(vertices.size());
  std::vector<uint32_t> group(vertices.size());
  for (uint32_t i = 0; i < vertices.size(); ++i) {
    const Vertex& v = vertices[i];
    const Key key{{v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, (v.*uv).x, (v.*uv).y}};
    group[i] = first.try_emplace(key, i).first->second;
  }
  return group;
}

}  // namespace

void computeTangents(Mesh& mesh, glm::vec2 Vertex::*uv) {
  // Sums of the triangles whose uv keep their handedness, and of those that mirror it.
  struct Sum {
    glm::vec3 kept{0}, mirrored{0};
    bool usesKept = false, usesMirrored = false;
  };
  const std::vector<uint32_t> group = weld(mesh.vertices, uv);
  std::vector<Sum> sums(mesh.vertices.size());
  std::vector<bool> mirrored(mesh.indices.size() / 3);

  for (size_t t = 0; t < mirrored.size(); ++t) {
    const uint32_t* corner = &mesh.indices[3 * t];
    const Vertex* v[3] = {&mesh.vertices[corner[0]], &mesh.vertices[corner[1]], &mesh.vertices[corner[2]]};
    const glm::vec3 e1 = v[1]->position - v[0]->position, e2 = v[2]->position - v[0]->position;
    const glm::vec2 d1 = v[1]->*uv - v[0]->*uv, d2 = v[2]->*uv - v[0]->*uv;
    const float area = d1.x * d2.y - d2.x * d1.y;
    // Counter-clockwise in space and, as v counts from the top, clockwise in uv: not mirrored.
    mirrored[t] = area > 0;
    if (area == 0 || !std::isfinite(area)) continue;
    const glm::vec3 gradient = (e1 * d2.y - e2 * d1.y) * (area > 0 ? 1.0f : -1.0f);
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& n = v[k]->normal;
      const auto inPlane = [&](const glm::vec3& x) { return direction(x - n * glm::dot(n, x)); };
      const glm::vec3 toNext = inPlane(v[(k + 1) % 3]->position - v[k]->position);
      const glm::vec3 toLast = inPlane(v[(k + 2) % 3]->position - v[k]->position);
      const float angle = std::acos(glm::clamp(glm::dot(toNext, toLast), -1.0f, 1.0f));
      Sum& sum = sums[group[corner[k]]];
      (mirrored[t] ? sum.mirrored : sum.kept) += inPlane(gradient) * angle;
      (mirrored[t] ? sum.usesMirrored : sum.usesKept) = true;
    }
  }

  const auto tangent = [](const Vertex& v, const glm::vec3& sum, float sign) {
    const glm::vec3 t = direction(sum - v.normal * glm::dot(v.normal, sum));
    return glm::vec4(t == glm::vec3(0) ? anyPerpendicular(v.normal) : t, sign);
  };
  const size_t count = mesh.vertices.size();
  // Where both meet, the mirrored triangles get a vertex of their own: one vertex has but one sign.
  std::unordered_map<uint32_t, uint32_t> twins;
  for (uint32_t i = 0; i < count; ++i) {
    const Sum& sum = sums[group[i]];
    Vertex& v = mesh.vertices[i];
    v.tangent = !sum.usesMirrored || sum.usesKept ? tangent(v, sum.kept, 1) : tangent(v, sum.mirrored, -1);
  }
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const uint32_t original = mesh.indices[i];
    const Sum& sum = sums[group[original]];
    if (i / 3 >= mirrored.size() || !mirrored[i / 3] || !sum.usesKept || !sum.usesMirrored) continue;
    const auto [twin, isNew] = twins.try_emplace(original, uint32_t(mesh.vertices.size()));
    if (isNew) {
      Vertex copy = mesh.vertices[original];
      copy.tangent = tangent(copy, sum.mirrored, -1);
      mesh.vertices.push_back(copy);
    }
    mesh.indices[i] = twin->second;
  }
}

}  // namespace glint
