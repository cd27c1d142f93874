#include "renderer/device_mesh.h"

#include <cstddef>

namespace glint {
namespace {

DeviceMesh upload(const Mesh& mesh) {
  DeviceMesh device;
  ClusteredMesh clustered = clusterMesh(mesh);
  device.vertices = gl::createBuffer(std::as_bytes(std::span(mesh.vertices)));
  device.indices = gl::createBuffer(std::as_bytes(std::span(clustered.indices)));
  device.clusters = std::move(clustered.clusters);
  device.indexCount = static_cast<GLsizei>(clustered.indices.size());
  mesh.bounds(device.low, device.high);
  device.center = 0.5f * (device.low + device.high);
  for (const Vertex& v : mesh.vertices) device.radius = std::max(device.radius, glm::length(v.position - device.center));

  device.array = gl::createVertexArray();
  const GLuint vao = device.array.id();
  glVertexArrayVertexBuffer(vao, 0, device.vertices.id(), 0, sizeof(Vertex));
  glVertexArrayElementBuffer(vao, device.indices.id());
  const struct {
    GLint size;
    size_t offset;
  } attributes[] = {{3, offsetof(Vertex, position)}, {3, offsetof(Vertex, normal)}, {4, offsetof(Vertex, tangent)},
                    {2, offsetof(Vertex, uv0)},      {2, offsetof(Vertex, uv1)},    {4, offsetof(Vertex, color)}};
  for (GLuint i = 0; i < std::size(attributes); ++i) {
    glEnableVertexArrayAttrib(vao, i);
    glVertexArrayAttribFormat(vao, i, attributes[i].size, GL_FLOAT, GL_FALSE, static_cast<GLuint>(attributes[i].offset));
    glVertexArrayAttribBinding(vao, i, 0);
  }
  return device;
}

}  // namespace

const DeviceMesh& DeviceMeshes::get(const MeshPtr& mesh) {
  GLINT_CHECK(mesh != nullptr);
  auto found = meshes_.find(mesh.get());
  // A new mesh may lie where a forgotten one lay.
  if (found != meshes_.end() && found->second.source.lock() != mesh) {
    meshes_.erase(found);
    found = meshes_.end();
  }
  if (found == meshes_.end()) found = meshes_.emplace(mesh.get(), Entry{mesh, upload(*mesh)}).first;
  if (found->second.mesh.serial == 0) found->second.mesh.serial = ++uploaded_;
  return found->second.mesh;
}

void DeviceMeshes::forgetUnused() {
  std::erase_if(meshes_, [](const auto& item) { return item.second.source.expired(); });
}

}  // namespace glint
