#include "app/editor/handle_view.h"

#include <algorithm>
#include <cmath>

namespace glint {

HandleView::HandleView(const Camera& camera, glm::vec2 pixels, float uiScale)
    : eye(camera.eye), target(camera.target), size(pixels), scale(uiScale), focal_(pixels.y / (2 * std::tan(camera.fovY / 2))) {
  const glm::mat4 m = camera.viewFromWorld();
  right = {m[0][0], m[1][0], m[2][0]};
  up = {m[0][1], m[1][1], m[2][1]};
  forward = -glm::vec3(m[0][2], m[1][2], m[2][2]);
}

std::optional<glm::vec2> HandleView::project(glm::vec3 p) const {
  const glm::vec3 d = p - eye;
  const float deep = glm::dot(d, forward);
  if (!(deep > 1e-3f * glm::length(target - eye))) return {};
  return size / 2.0f + glm::vec2(glm::dot(d, right), -glm::dot(d, up)) * (focal_ / deep);
}

glm::vec3 HandleView::ray(glm::vec2 pixel) const {
  const glm::vec2 d = (pixel - size / 2.0f) / focal_;
  return glm::normalize(forward + right * d.x - up * d.y);
}

float HandleView::metres(float units, glm::vec3 at) const {
  const float least = 1e-3f * glm::length(target - eye);
  return units * scale * std::max(least, depth(at)) / focal_;
}

glm::vec3 HandleView::onPlane(glm::vec2 pixel, glm::vec3 at) const {
  const glm::vec3 r = ray(pixel);
  return eye + r * (depth(at) / glm::dot(r, forward));
}

std::optional<glm::vec3> HandleView::onPlane(glm::vec2 pixel, glm::vec3 at, glm::vec3 normal) const {
  const glm::vec3 r = ray(pixel);
  const float slope = glm::dot(r, normal);
  if (std::abs(slope) < 0.02f) return {};
  const float far = glm::dot(at - eye, normal) / slope;
  if (!(far > 0)) return {};
  return eye + r * far;
}

std::optional<float> HandleView::alongLine(glm::vec2 pixel, glm::vec3 origin, glm::vec3 unit) const {
  const glm::vec3 r = ray(pixel), w = origin - eye;
  const float b = glm::dot(unit, r), across = 1 - b * b;
  if (across < 1e-3f) return {};
  return (b * glm::dot(r, w) - glm::dot(unit, w)) / across;
}

glm::vec2 HandleView::edge(glm::vec3 p, float inset) const {
  const glm::vec3 d = p - eye;
  glm::vec2 way(glm::dot(d, right), -glm::dot(d, up));
  if (glm::length(way) < 1e-6f) way = {0, 1};
  const glm::vec2 room = glm::max(size / 2.0f - inset * scale, glm::vec2(1));
  const glm::vec2 away = glm::abs(way);
  return size / 2.0f + way * std::min(room.x / std::max(away.x, 1e-9f), room.y / std::max(away.y, 1e-9f));
}

bool HandleView::inside(glm::vec2 p, float inset) const {
  inset *= scale;
  return p.x > inset && p.y > inset && p.x < size.x - inset && p.y < size.y - inset;
}

}  // namespace glint
