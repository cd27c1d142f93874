// A mesh in clusters of neighbouring triangles, each with bounds: what lets a frame skip triangles that face away
// and give each part of the picture the lights that reach it.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "renderer/mesh.h"

namespace glint {

struct Cluster {
  uint32_t firstIndex = 0, indexCount = 0;   // into ClusteredMesh::indices
  glm::vec3 center{0};                       // bounding sphere, model space
  float radius = 0;
  glm::vec3 axis{0, 0, 1};                   // all normals (of faces and vertices) lie within the cone about it
  float coneCosine = -1;                     // cosine of the cone's half angle; -1: no useful cone
};

struct ClusteredMesh {
  std::vector<uint32_t> indices;             // the mesh's triangles, reordered
  std::vector<Cluster> clusters;
};

// At most `trianglesEach` triangles a cluster. Time n log^2 n.
ClusteredMesh clusterMesh(const Mesh&, int trianglesEach = 32);

// True when every triangle of a cluster whose cone is (axis, coneCosine) around the sphere (center, radius) faces
// away from `eye`. All in one space.
bool facesAway(glm::vec3 center, float radius, glm::vec3 axis, float coneCosine, glm::vec3 eye);
// The same for a direction towards an eye infinitely far away.
bool facesAwayFrom(glm::vec3 axis, float coneCosine, glm::vec3 towardsEye);

}  // namespace glint
