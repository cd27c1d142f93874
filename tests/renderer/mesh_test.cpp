#include "renderer/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "renderer/scene.h"

namespace glint {
namespace {

struct Corner {
  const Vertex* v[3];
};

std::vector<Corner> triangles(const Mesh& mesh) {
  std::vector<Corner> out;
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    out.push_back({{&mesh.vertices[mesh.indices[i]], &mesh.vertices[mesh.indices[i + 1]], &mesh.vertices[mesh.indices[i + 2]]}});
  return out;
}

class Shape : public testing::TestWithParam<std::string> {
 protected:
  const MeshPtr mesh_ = shapeMesh(GetParam());
};

TEST_P(Shape, IndicesAreInRangeAndTrianglesHaveAreaAndFaceOutwards) {
  ASSERT_TRUE(mesh_);
  EXPECT_EQ(mesh_->name, GetParam());
  ASSERT_EQ(mesh_->indices.size() % 3, 0u);
  for (const uint32_t i : mesh_->indices) ASSERT_LT(i, mesh_->vertices.size());
  for (const Corner& t : triangles(*mesh_)) {
    const glm::vec3 normal = glm::cross(t.v[1]->position - t.v[0]->position, t.v[2]->position - t.v[0]->position);
    ASSERT_GT(glm::length(normal), 1e-9f);
    for (const Vertex* v : t.v) ASSERT_GT(glm::dot(glm::normalize(normal), v->normal), 0.3f);
  }
}

TEST_P(Shape, FramesAreOrthonormal) {
  for (const Vertex& v : mesh_->vertices) {
    ASSERT_NEAR(glm::length(v.normal), 1, 1e-4);
    ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-4);
    ASSERT_NEAR(glm::dot(v.normal, glm::vec3(v.tangent)), 0, 1e-4);
    ASSERT_EQ(std::abs(v.tangent.w), 1);
  }
}

TEST_P(Shape, TangentsAreThoseOfItsUv) {
  Mesh copy = *mesh_;
  computeTangents(copy);
  for (size_t i = 0; i < mesh_->vertices.size(); ++i) {
    const glm::vec4 made = mesh_->vertices[i].tangent, computed = copy.vertices[i].tangent;
    ASSERT_EQ(made.w, computed.w);
    ASSERT_GT(glm::dot(glm::vec3(made), glm::vec3(computed)), 0.9f) << i;
  }
}

TEST_P(Shape, LiesWithinOneMetre) {
  glm::vec3 low, high;
  mesh_->bounds(low, high);
  for (int c = 0; c < 3; ++c) {
    EXPECT_GE(low[c], -1.0001f);
    EXPECT_LE(high[c], 1.0001f);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Shape, testing::ValuesIn(shapeNames()), [](const auto& shape) { return shape.param; });

TEST(Shapes, ASphereIsOne) {
  const MeshPtr mesh = sphereMesh(16, 8);
  // Poles give one triangle for each segment, the rings between two.
  EXPECT_EQ(mesh->indices.size() / 3, 16u * 2 + 16 * 6 * 2);
  for (const Vertex& v : mesh->vertices) {
    EXPECT_NEAR(glm::length(v.position), 1, 1e-5);
    EXPECT_NEAR(v.uv0.y, std::acos(glm::clamp(v.position.y, -1.0f, 1.0f)) / M_PI, 1e-3);  // v from the top
  }
}

// Every edge belongs to two triangles (by place: seams have two vertices for one).
TEST(Shapes, SphereCubeAndShaderballAreClosed) {
  for (const char* name : {"sphere", "cube", "shaderball"}) {
    const MeshPtr mesh = shapeMesh(name);
    const auto key = [](const glm::vec3& p) {
      return std::array<int, 3>{int(std::round(p.x * 1e4f)), int(std::round(p.y * 1e4f)), int(std::round(p.z * 1e4f))};
    };
    std::map<std::pair<std::array<int, 3>, std::array<int, 3>>, int> edges;
    for (const Corner& t : triangles(*mesh))
      for (int k = 0; k < 3; ++k) {
        const auto a = key(t.v[k]->position), b = key(t.v[(k + 1) % 3]->position);
        edges[{a, b}]++;
        edges[{b, a}]--;
      }
    int open = 0;
    for (const auto& [edge, count] : edges) open += count != 0;
    // The foot's top is open, inside the shell.
    EXPECT_EQ(open, std::string(name) == "shaderball" ? 2 * 72 : 0) << name;
  }
}

TEST(Shapes, UnknownNamesAreNull) { EXPECT_EQ(shapeMesh("teapot"), nullptr); }

// Two triangles that share an edge along x = 0; the left one's uv is the right one's mirror image.
Mesh mirroredPair() {
  Mesh mesh;
  const auto add = [&](glm::vec3 p, glm::vec2 uv) {
    Vertex v;
    v.position = p;
    v.uv0 = uv;
    mesh.vertices.push_back(v);
  };
  add({0, 0, 0}, {0, 1});
  add({0, 1, 0}, {0, 0});
  add({1, 0, 0}, {1, 1});
  add({-1, 0, 0}, {1, 1});
  mesh.indices = {0, 2, 1, 0, 1, 3};
  return mesh;
}

TEST(Tangents, MirroredUvSplitsTheSharedVertices) {
  Mesh mesh = mirroredPair();
  computeTangents(mesh);
  EXPECT_EQ(mesh.vertices.size(), 6u);
  for (int k = 0; k < 3; ++k) {
    const Vertex& right = mesh.vertices[mesh.indices[size_t(k)]];
    const Vertex& left = mesh.vertices[mesh.indices[size_t(3 + k)]];
    EXPECT_EQ(right.tangent, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(left.tangent, glm::vec4(-1, 0, 0, -1));
  }
}

// The bitangent cross(N, T) w points up the picture: a normal map's green is +Y up (product.md 2).
TEST(Tangents, BitangentPointsUpThePicture) {
  const MeshPtr plane = planeMesh();
  for (const Vertex& v : plane->vertices)
    EXPECT_EQ(glm::cross(v.normal, glm::vec3(v.tangent)) * v.tangent.w, glm::vec3(0, 1, 0));
  EXPECT_EQ(plane->vertices[0].uv0, glm::vec2(0, 0));
  EXPECT_EQ(plane->vertices[0].position, glm::vec3(-1, 1, 0));
}

TEST(Tangents, WithoutUvTheyArePerpendicular) {
  Mesh mesh = *sphereMesh(8, 4);
  for (Vertex& v : mesh.vertices) v.uv0 = {};
  computeTangents(mesh);
  for (const Vertex& v : mesh.vertices) {
    EXPECT_NEAR(glm::dot(v.normal, glm::vec3(v.tangent)), 0, 1e-5);
    EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-5);
  }
}

TEST(Normals, AreWeightedByArea) {
  Mesh mesh;
  mesh.vertices.resize(4);
  mesh.vertices[1].position = {2, 0, 0};
  mesh.vertices[2].position = {0, 2, 0};
  mesh.vertices[3].position = {0, 0, 1};
  mesh.indices = {0, 1, 2, 0, 2, 3};  // areas 2 and 1, facing +Z and +X
  computeNormals(mesh);
  EXPECT_NEAR(glm::length(mesh.vertices[0].normal - glm::normalize(glm::vec3(1, 0, 2))), 0, 1e-6);
  EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0, 1));
}

TEST(Normals, TinyMeshesAndLooseVerticesHaveOne) {
  Mesh mesh = *cubeMesh();
  for (Vertex& v : mesh.vertices) v.position *= 1e-15f;
  mesh.vertices.emplace_back();
  const std::vector<Vertex> before = mesh.vertices;
  computeNormals(mesh);
  for (size_t i = 0; i + 1 < before.size(); ++i) EXPECT_EQ(mesh.vertices[i].normal, before[i].normal);
  EXPECT_EQ(mesh.vertices.back().normal, glm::vec3(0, 0, 1));
}

TEST(Cameras, FrameTheWholeSceneWithLittleToSpare) {
  for (const float aspect : {0.5f, 1.0f, 2.0f}) {
    Scene scene;
    scene.instances.push_back({cubeMesh(), glm::mat4(1), 0});
    scene.instances.push_back({sphereMesh(), glm::mat4(glm::vec4(3, 0, 0, 0), glm::vec4(0, 3, 0, 0), glm::vec4(0, 0, 3, 0), glm::vec4(40, 5, 0, 1)), 0});
    const Camera camera = frameScene(scene, aspect);
    const glm::mat4 clipFromWorld = camera.clipFromView(aspect) * camera.viewFromWorld();
    float furthest = 0;
    for (const Instance& instance : scene.instances)
      for (const Vertex& v : instance.mesh->vertices) {
        const glm::vec4 p = clipFromWorld * instance.worldFromModel * glm::vec4(v.position, 1);
        ASSERT_GT(p.w, 0);
        ASSERT_GT(p.z / p.w, -1);
        ASSERT_LT(p.z / p.w, 1);
        furthest = std::max({furthest, std::abs(p.x / p.w), std::abs(p.y / p.w)});
      }
    EXPECT_LT(furthest, 0.95f);
    EXPECT_GT(furthest, 0.80f);
  }
}

TEST(Cameras, LookingStraightDownIsDefined) {
  Camera camera;
  camera.eye = {0, 5, 0};
  const glm::mat4 view = camera.viewFromWorld();
  const glm::vec4 target = view * glm::vec4(0, 0, 0, 1);
  EXPECT_NEAR(target.z, -5, 1e-5);
  EXPECT_NEAR(target.x, 0, 1e-5);
}

TEST(Cameras, OrthographicHeightIsMetres) {
  Camera camera;
  camera.orthoHeight = 3;
  const glm::vec4 p = camera.clipFromView(2) * glm::vec4(3, 1.5f, -1, 1);
  EXPECT_NEAR(p.x, 1, 1e-5);
  EXPECT_NEAR(p.y, 1, 1e-5);
}

}  // namespace
}  // namespace glint
