// Triangles in memory.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"

namespace glint {

struct Vertex {
  glm::vec3 position{0};          // metres
  glm::vec3 normal{0, 0, 1};      // unit
  glm::vec4 tangent{1, 0, 0, 1};  // unit, w the sign of the bitangent (glTF)
  glm::vec2 uv0{0}, uv1{0};       // v from the top, as in glTF
  glm::vec4 color{1};             // linear
};

struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // three a triangle, counter-clockwise seen from outside

  void bounds(glm::vec3& low, glm::vec3& high) const;  // of an empty mesh: both zero
};
using MeshPtr = std::shared_ptr<const Mesh>;

// Fills normals (area-weighted) or tangents (MikkTSpace's conventions: per-triangle gradients of uv, angle-
// weighted, orthogonalised) from what is there. Without usable uv, any tangent perpendicular to the normal.
void computeNormals(Mesh&);
// Where triangles that mirror their uv meet others, vertices are split: one has but one sign.
void computeTangents(Mesh&, glm::vec2 Vertex::*uv = &Vertex::uv0);

// The shapes of --mesh, centred on the origin, radius or half side 1 m; uv covers each face or the sphere.
MeshPtr sphereMesh(int segments = 64, int rings = 32);
MeshPtr planeMesh();       // in xy, facing +Z
MeshPtr cubeMesh();
MeshPtr shaderballMesh();  // a sphere with a recessed band on a foot: flat, curved and concave parts
// "sphere", "plane", "cube" or "shaderball"; null for any other name.
MeshPtr shapeMesh(const std::string& name);
std::vector<std::string> shapeNames();

}  // namespace glint
