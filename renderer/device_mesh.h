// Meshes on the device.
#pragma once

#include <unordered_map>

#include "renderer/gl/objects.h"
#include "renderer/mesh_clusters.h"
#include "renderer/scene.h"

namespace glint {

struct DeviceMesh {
  gl::Buffer vertices, indices;
  gl::VertexArray array;         // attributes of shaders/passes/gbuffer.vert
  std::vector<Cluster> clusters;
  uint64_t serial = 0;           // of no other mesh, ever
  GLsizei indexCount = 0;
  glm::vec3 low{0}, high{0};     // bounding box, model space
  glm::vec3 center{0};           // bounding sphere, model space
  float radius = 0;
};

// Uploads each mesh once, for as long as somebody holds it.
class DeviceMeshes {
 public:
  const DeviceMesh& get(const MeshPtr&);
  void forgetUnused();

 private:
  struct Entry {
    std::weak_ptr<const Mesh> source;
    DeviceMesh mesh;
  };
  std::unordered_map<const Mesh*, Entry> meshes_;
  uint64_t uploaded_ = 0;
};

}  // namespace glint
