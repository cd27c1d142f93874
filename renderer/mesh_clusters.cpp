#include "renderer/mesh_clusters.h"

#include <algorithm>
#include <numeric>

namespace glint {
namespace {

struct Triangle {
  uint32_t index;          // of the triangle in the mesh
  glm::vec3 centroid;
  glm::vec3 normal;        // unit, of the face
};

class Builder {
 public:
  Builder(const Mesh& mesh, int trianglesEach) : mesh_(mesh), most_(static_cast<size_t>(trianglesEach)) {
    glm::vec3 low, high;
    mesh.bounds(low, high);
    // Turning from one side of a body to the other counts as much as crossing it.
    normalWeight_ = 0.5f * glm::length(high - low);
    triangles_.resize(mesh.indices.size() / 3);
    for (size_t i = 0; i < triangles_.size(); ++i) {
      const glm::vec3 a = position(3 * i), b = position(3 * i + 1), c = position(3 * i + 2);
      const glm::vec3 n = glm::cross(b - a, c - a);
      const float length = glm::length(n);
      triangles_[i] = {static_cast<uint32_t>(i), (a + b + c) / 3.0f,
                       length > 0 ? n / length : mesh.vertices[mesh.indices[3 * i]].normal};
    }
  }

  ClusteredMesh run() {
    out_.indices.reserve(mesh_.indices.size());
    if (!triangles_.empty()) split(0, triangles_.size());
    return std::move(out_);
  }

 private:
  glm::vec3 position(size_t index) const { return mesh_.vertices[mesh_.indices[index]].position; }

  // Halves the range across its longest extent in position and normal until it is small enough.
  void split(size_t begin, size_t end) {
    if (end - begin <= most_) return emit(begin, end);
    glm::vec3 lowP = triangles_[begin].centroid, highP = lowP, lowN = triangles_[begin].normal, highN = lowN;
    for (size_t i = begin; i < end; ++i) {
      lowP = glm::min(lowP, triangles_[i].centroid);
      highP = glm::max(highP, triangles_[i].centroid);
      lowN = glm::min(lowN, triangles_[i].normal);
      highN = glm::max(highN, triangles_[i].normal);
    }
    const glm::vec3 extentP = highP - lowP, extentN = (highN - lowN) * normalWeight_ * 0.5f;
    int axis = 0;
    float longest = -1;
    for (int i = 0; i < 6; ++i) {
      const float extent = i < 3 ? extentP[i] : extentN[i - 3];
      if (extent > longest) longest = extent, axis = i;
    }
    const size_t middle = (begin + end) / 2;
    std::nth_element(triangles_.begin() + static_cast<ptrdiff_t>(begin), triangles_.begin() + static_cast<ptrdiff_t>(middle),
                     triangles_.begin() + static_cast<ptrdiff_t>(end), [axis](const Triangle& a, const Triangle& b) {
                       const float x = axis < 3 ? a.centroid[axis] : a.normal[axis - 3];
                       const float y = axis < 3 ? b.centroid[axis] : b.normal[axis - 3];
                       return x != y ? x < y : a.index < b.index;
                     });
    split(begin, middle);
    split(middle, end);
  }

  void emit(size_t begin, size_t end) {
    Cluster cluster;
    cluster.firstIndex = static_cast<uint32_t>(out_.indices.size());
    // The mesh's own order within a cluster: it shares vertices well.
    std::sort(triangles_.begin() + static_cast<ptrdiff_t>(begin), triangles_.begin() + static_cast<ptrdiff_t>(end),
              [](const Triangle& a, const Triangle& b) { return a.index < b.index; });
    glm::vec3 low(1e30f), high(-1e30f), axis(0);
    for (size_t i = begin; i < end; ++i) {
      for (size_t corner = 0; corner < 3; ++corner) {
        const uint32_t index = mesh_.indices[3 * triangles_[i].index + corner];
        out_.indices.push_back(index);
        low = glm::min(low, mesh_.vertices[index].position);
        high = glm::max(high, mesh_.vertices[index].position);
        axis += mesh_.vertices[index].normal;
      }
      axis += triangles_[i].normal;
    }
    cluster.indexCount = static_cast<uint32_t>(out_.indices.size()) - cluster.firstIndex;
    cluster.center = 0.5f * (low + high);
    const float length = glm::length(axis);
    if (length > 1e-6f) cluster.axis = axis / length;
    cluster.coneCosine = length > 1e-6f ? 1.0f : -1.0f;
    for (uint32_t i = cluster.firstIndex; i < cluster.firstIndex + cluster.indexCount; ++i) {
      const Vertex& v = mesh_.vertices[out_.indices[i]];
      cluster.radius = std::max(cluster.radius, glm::length(v.position - cluster.center));
      cluster.coneCosine = std::min(cluster.coneCosine, glm::dot(v.normal, cluster.axis));
    }
    for (size_t i = begin; i < end; ++i)
      cluster.coneCosine = std::min(cluster.coneCosine, glm::dot(triangles_[i].normal, cluster.axis));
    // Rounding must not cull what is seen exactly edge on.
    cluster.coneCosine = std::max(-1.0f, cluster.coneCosine - 1e-4f);
    out_.clusters.push_back(cluster);
  }

  const Mesh& mesh_;
  size_t most_;
  float normalWeight_ = 0;
  std::vector<Triangle> triangles_;
  ClusteredMesh out_;
};

}  // namespace

ClusteredMesh clusterMesh(const Mesh& mesh, int trianglesEach) { return Builder(mesh, trianglesEach).run(); }

bool facesAway(glm::vec3 center, float radius, glm::vec3 axis, float coneCosine, glm::vec3 eye) {
  if (coneCosine <= 0) return false;
  const glm::vec3 d = center - eye;
  const float distance = glm::length(d);
  // Directions from the eye into the sphere lie within asin(radius / distance) of d, normals within the cone of the
  // axis: all face away when the angle between d and the axis plus both half angles stays under 90 degrees.
  if (distance <= radius) return false;
  const float sine = radius / distance, cosine = std::sqrt(1 - sine * sine);
  const float coneSine = std::sqrt(std::max(0.0f, 1 - coneCosine * coneCosine));
  // cos(90 - cone - spread) = sin(cone + spread); over 90 degrees together nothing can be said.
  if (coneCosine * cosine - coneSine * sine <= 0) return false;
  return glm::dot(d, axis) > distance * (coneSine * cosine + coneCosine * sine);
}

bool facesAwayFrom(glm::vec3 axis, float coneCosine, glm::vec3 towardsEye) {
  if (coneCosine <= 0) return false;
  return glm::dot(axis, towardsEye) < -std::sqrt(std::max(0.0f, 1 - coneCosine * coneCosine));
}

}  // namespace glint
