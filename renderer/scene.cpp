#include "renderer/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace glint {

glm::mat4 Camera::viewFromWorld() const {
  const glm::vec3 forward = target - eye;
  // An up that is parallel to the view (looking straight down) has no right-hand side; any other axis will do.
  const bool parallel = glm::length(glm::cross(forward, up)) < 1e-5f * glm::length(forward) * glm::length(up);
  return glm::lookAt(eye, target, parallel ? glm::vec3(0, 0, up.y > 0.5f ? -1 : 1) : up);
}

glm::mat4 Camera::clipFromView(float aspect) const {
  if (orthoHeight > 0) {
    const float halfHeight = orthoHeight / 2, halfWidth = halfHeight * aspect;
    return glm::ortho(-halfWidth, halfWidth, -halfHeight, halfHeight, nearPlane, farPlane);
  }
  return glm::perspective(fovY, aspect, nearPlane, farPlane);
}

namespace {

// Smallest box around every instance, in world space. Empty scenes give the unit box.
void sceneBounds(const Scene& scene, glm::vec3& low, glm::vec3& high) {
  low = glm::vec3(std::numeric_limits<float>::max());
  high = -low;
  for (const Instance& instance : scene.instances) {
    if (!instance.mesh || instance.mesh->vertices.empty()) continue;
    glm::vec3 meshLow, meshHigh;
    instance.mesh->bounds(meshLow, meshHigh);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 p{corner & 1 ? meshHigh.x : meshLow.x, corner & 2 ? meshHigh.y : meshLow.y,
                        corner & 4 ? meshHigh.z : meshLow.z};
      const glm::vec3 world = instance.worldFromModel * glm::vec4(p, 1);
      low = glm::min(low, world);
      high = glm::max(high, world);
    }
  }
  if (low.x > high.x) {
    low = glm::vec3(-1);
    high = glm::vec3(1);
  }
}

}  // namespace

Camera frameScene(const Scene& scene, float aspect) {
  glm::vec3 low, high;
  sceneBounds(scene, low, high);
  Camera camera;
  camera.target = (low + high) * 0.5f;
  // A little to the right and above: three sides of a box show.
  const glm::vec3 toEye = glm::normalize(glm::vec3(0.45f, 0.28f, 1.0f));
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), toEye)), up = glm::cross(toEye, right);
  const glm::vec3 half = glm::max((high - low) * 0.5f, glm::vec3(1e-6f));
  // The distance at which every corner of the box lies inside the frustum with a margin.
  const float margin = 0.94f;
  const float tanY = std::tan(camera.fovY / 2) * margin, tanX = tanY * aspect;
  float distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p = half * glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const float across = std::max(std::abs(glm::dot(p, right)) / tanX, std::abs(glm::dot(p, up)) / tanY);
    distance = std::max(distance, across + glm::dot(p, toEye));
  }
  const float radius = glm::length(half);
  camera.eye = camera.target + toEye * distance;
  camera.nearPlane = std::max(distance - radius * 1.05f, distance * 0.01f);
  camera.farPlane = distance + radius * 4;
  return camera;
}

}  // namespace glint
