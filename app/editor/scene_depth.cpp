#include "app/editor/scene_depth.h"

#include <cmath>

#include "materials/base/check.h"

namespace glint {

SceneDepth::SceneDepth(glm::ivec2 size, std::vector<float> metres) : size_(size), metres_(std::move(metres)) {
  GLINT_CHECK(metres_.size() == size_t(size.x) * size_t(size.y));
}

std::optional<float> SceneDepth::at(glm::ivec2 texel) const {
  if (texel.x < 0 || texel.y < 0 || texel.x >= size_.x || texel.y >= size_.y) return {};
  const float metres = metres_[size_t(texel.y) * size_t(size_.x) + size_t(texel.x)];
  if (!std::isfinite(metres)) return {};
  return metres;
}

glm::ivec2 SceneDepth::texelOf(const HandleView& view, glm::vec2 pixel) const {
  const glm::vec2 p = pixel / view.size * glm::vec2(size_);
  return {int(std::floor(p.x)), size_.y - 1 - int(std::floor(p.y))};   // rows from the bottom
}

bool SceneDepth::hides(const HandleView& view, glm::vec3 point) const {
  const auto pixel = view.project(point);
  if (!pixel) return false;
  const auto surface = at(texelOf(view, *pixel));
  return surface && *surface < view.depth(point) * 0.998f;
}

std::optional<SceneDepth::Surface> SceneDepth::under(const HandleView& view, glm::vec2 pixel) const {
  const glm::ivec2 texel = texelOf(view, pixel);
  const auto middle = at(texel);
  if (!middle) return {};
  const auto place = [&](glm::ivec2 t, float depth) {
    const glm::vec2 p(float(t.x) + 0.5f, float(size_.y - 1 - t.y) + 0.5f);
    const glm::vec3 ray = view.ray(p / glm::vec2(size_) * view.size);
    return view.eye + ray * (depth / glm::dot(ray, view.forward));
  };
  const glm::vec3 here = place(texel, *middle);
  // Of both ways along a row and a column the one that stays on the surface; some pixels, so that facets and the depth's
  // rounding do not count.
  const auto along = [&](glm::ivec2 way) {
    constexpr int kFar = 3;
    glm::vec3 best(0);
    float least = INFINITY;
    for (const int sign : {1, -1}) {
      const glm::ivec2 there = texel + sign * kFar * way;
      const auto depth = at(there);
      if (!depth || std::abs(*depth - *middle) >= least) continue;
      least = std::abs(*depth - *middle);
      best = float(sign) * (place(there, *depth) - here);
    }
    return best;
  };
  const glm::vec3 normal = glm::cross(along({1, 0}), along({0, 1}));
  if (!(glm::length(normal) > 0)) return {};
  const glm::vec3 unit = glm::normalize(normal);
  return Surface{here, glm::dot(unit, view.eye - here) < 0 ? -unit : unit};
}

}  // namespace glint
