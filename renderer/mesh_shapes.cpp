// The plain shapes of --mesh.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "materials/base/check.h"
#include "renderer/mesh.h"

namespace glint {

MeshPtr sphereMesh(int segments, int rings) {
  GLINT_CHECK(segments >= 3 && rings >= 2, "{} x {}", segments, rings);
  auto mesh = std::make_shared<Mesh>();
  mesh->name = "sphere";
  const auto vertex = [&](float u, float v) {
    const float around = glm::two_pi<float>() * u, down = glm::pi<float>() * v;
    Vertex out;
    // u = 0.5 faces +Z and grows to the right as seen from there.
    out.position = {-std::sin(around) * std::sin(down), std::cos(down), -std::cos(around) * std::sin(down)};
    out.normal = out.position;
    out.tangent = {-std::cos(around), 0, std::sin(around), 1};
    out.uv0 = out.uv1 = {u, v};
    mesh->vertices.push_back(out);
  };
  // Every segment has pole vertices of its own, in its middle, so that no triangle there is degenerate.
  for (int ring = 0; ring <= rings; ++ring) {
    const bool pole = ring == 0 || ring == rings;
    for (int i = 0; i < segments + (pole ? 0 : 1); ++i)
      vertex((float(i) + (pole ? 0.5f : 0.0f)) / float(segments), float(ring) / float(rings));
  }
  const auto index = [&](int ring, int i) {
    return uint32_t(ring == 0 ? i : segments + (ring - 1) * (segments + 1) + i);
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < segments; ++i) {
      const uint32_t a = index(ring, i), b = index(ring + 1, i);
      if (ring + 1 == rings)
        mesh->indices.insert(mesh->indices.end(), {a, b, a + 1});
      else if (ring == 0)
        mesh->indices.insert(mesh->indices.end(), {a, b, b + 1});
      else
        mesh->indices.insert(mesh->indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  return mesh;
}

namespace {

// A square of half side 1 at distance `offset` along its normal.
void addSquare(Mesh& mesh, const glm::vec3& normal, const glm::vec3& right, float offset) {
  const glm::vec3 up = glm::cross(normal, right);
  const auto first = uint32_t(mesh.vertices.size());
  for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0)}) {
    Vertex v;
    v.position = normal * offset + right * (2 * uv.x - 1) + up * (1 - 2 * uv.y);
    v.normal = normal;
    v.tangent = glm::vec4(right, 1);
    v.uv0 = v.uv1 = uv;
    mesh.vertices.push_back(v);
  }
  for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

}  // namespace

MeshPtr planeMesh() {
  auto mesh = std::make_shared<Mesh>();
  mesh->name = "plane";
  addSquare(*mesh, {0, 0, 1}, {1, 0, 0}, 0);
  return mesh;
}

MeshPtr cubeMesh() {
  auto mesh = std::make_shared<Mesh>();
  mesh->name = "cube";
  addSquare(*mesh, {0, 0, 1}, {1, 0, 0}, 1);
  addSquare(*mesh, {1, 0, 0}, {0, 0, -1}, 1);
  addSquare(*mesh, {0, 0, -1}, {-1, 0, 0}, 1);
  addSquare(*mesh, {-1, 0, 0}, {0, 0, 1}, 1);
  addSquare(*mesh, {0, 1, 0}, {1, 0, 0}, 1);
  addSquare(*mesh, {0, -1, 0}, {1, 0, 0}, 1);
  return mesh;
}

MeshPtr shapeMesh(const std::string& name) {
  // Alone it fills the picture: a side of its outline bends away by 0.1 pixels at 720 lines.
  if (name == "sphere") return sphereMesh(128, 64);
  if (name == "plane") return planeMesh();
  if (name == "cube") return cubeMesh();
  if (name == "shaderball") return shaderballMesh();
  return nullptr;
}

std::vector<std::string> shapeNames() { return {"sphere", "plane", "cube", "shaderball"}; }

}  // namespace glint
