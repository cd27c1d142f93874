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

// Enough places on every instance, in world space, to frame them by. Empty scenes give the unit box.
std::vector<glm::vec3> outline(const Scene& scene) {
  constexpr size_t kMostPoints = 100'000;
  size_t vertices = 0;
  for (const Instance& instance : scene.instances)
    if (instance.mesh) vertices += instance.mesh->vertices.size();
  const size_t step = vertices / kMostPoints + 1;
  std::vector<glm::vec3> points;
  for (const Instance& instance : scene.instances) {
    if (!instance.mesh) continue;
    const auto& all = instance.mesh->vertices;
    for (size_t i = 0; i < all.size(); i += step)
      points.emplace_back(instance.worldFromModel * glm::vec4(all[i].position, 1));
  }
  if (points.empty())
    for (int corner = 0; corner < 8; ++corner)
      points.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  return points;
}

}  // namespace

Camera frameScene(const Scene& scene, float aspect) {
  const std::vector<glm::vec3> points = outline(scene);
  glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
  for (const glm::vec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Camera camera;
  camera.target = (low + high) * 0.5f;
  // A little to the right and above: three sides of a box show.
  const glm::vec3 toEye = glm::normalize(glm::vec3(0.45f, 0.28f, 1.0f));
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), toEye)), up = glm::cross(toEye, right);
  // The distance at which every point lies inside the frustum with a margin.
  constexpr float kMargin = 0.90f;
  const float tanY = std::tan(camera.fovY / 2) * kMargin, tanX = tanY * aspect;
  const float radius = std::max(glm::length(high - low) * 0.5f, 1e-6f);
  float distance = radius;
  for (const glm::vec3& point : points) {
    const glm::vec3 p = point - camera.target;
    const float across = std::max(std::abs(glm::dot(p, right)) / tanX, std::abs(glm::dot(p, up)) / tanY);
    distance = std::max(distance, across + glm::dot(p, toEye));
  }
  camera.eye = camera.target + toEye * distance;
  camera.nearPlane = std::max(distance - radius * 1.05f, distance * 0.01f);
  camera.farPlane = distance + radius * 4;
  return camera;
}

}  // namespace glint
