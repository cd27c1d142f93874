#include "renderer/prepared_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace glint {
namespace {

struct Basis {
  glm::vec3 eye, right, up, forward;
};

Basis basisOf(const Camera& camera) {
  Basis b;
  b.eye = camera.eye;
  const glm::vec3 d = camera.target - camera.eye;
  b.forward = glm::length(d) > 0 ? glm::normalize(d) : glm::vec3(0, 0, -1);
  // Looking along `up` leaves the roll open: any will do.
  glm::vec3 side = glm::cross(b.forward, camera.up);
  if (glm::length(side) < 1e-5f) side = glm::cross(b.forward, glm::vec3(0, 0, -1));
  if (glm::length(side) < 1e-5f) side = glm::vec3(1, 0, 0);
  b.right = glm::normalize(side);
  b.up = glm::cross(b.right, b.forward);
  return b;
}

struct WorldSphere {
  glm::vec3 center;
  float radius;
};

// Everything about the projection of one view.
class Projection {
 public:
  Projection(const View& view, float nearPlane, float farPlane, glm::vec2 jitter)
      : basis_(basisOf(view.camera)), camera_(view.camera), rectangle_(view.rectangle), near_(nearPlane), far_(farPlane) {
    const float aspect = static_cast<float>(rectangle_.z) / static_cast<float>(rectangle_.w);
    half_.y = orthographic() ? 0.5f * camera_.orthoHeight : std::tan(0.5f * camera_.fovY);
    half_.x = half_.y * aspect;
    jitter_ = jitter;
  }

  bool orthographic() const { return camera_.orthoHeight > 0; }
  const Basis& basis() const { return basis_; }

  glm::mat4 clipFromWorld() const {
    const Basis& b = basis_;
    const glm::mat4 viewFromWorld(glm::vec4(b.right.x, b.up.x, -b.forward.x, 0), glm::vec4(b.right.y, b.up.y, -b.forward.y, 0),
                                  glm::vec4(b.right.z, b.up.z, -b.forward.z, 0),
                                  glm::vec4(-glm::dot(b.right, b.eye), -glm::dot(b.up, b.eye), glm::dot(b.forward, b.eye), 1));
    glm::mat4 clipFromView(0);
    clipFromView[0][0] = 1 / half_.x;
    clipFromView[1][1] = 1 / half_.y;
    if (orthographic()) {
      clipFromView[2][2] = -2 / (far_ - near_);
      clipFromView[3][2] = -(far_ + near_) / (far_ - near_);
      clipFromView[3][3] = 1;
    } else {
      clipFromView[2][2] = -(far_ + near_) / (far_ - near_);
      clipFromView[2][3] = -1;
      clipFromView[3][2] = -2 * far_ * near_ / (far_ - near_);
    }
    glm::mat4 shift(1);
    shift[3][0] = -2 * jitter_.x / static_cast<float>(rectangle_.z);
    shift[3][1] = -2 * jitter_.y / static_cast<float>(rectangle_.w);
    return shift * clipFromView * viewFromWorld;
  }

  void fillRays(ViewBlock& block) const {
    // Per pixel, in units of the half extents; `corner` is the window position (0, 0).
    const glm::vec2 step(2.0f * half_.x / static_cast<float>(rectangle_.z), 2.0f * half_.y / static_cast<float>(rectangle_.w));
    const glm::vec2 corner = -half_ + step * (jitter_ - glm::vec2(rectangle_.x, rectangle_.y));
    const glm::vec3 atCorner = basis_.right * corner.x + basis_.up * corner.y;
    const glm::vec3 alongX = basis_.right * step.x, alongY = basis_.up * step.y;
    if (orthographic()) {
      block.rayOrigin = glm::vec4(basis_.eye + atCorner, 0);
      block.originX = glm::vec4(alongX, 0);
      block.originY = glm::vec4(alongY, 0);
      block.rayDirection = glm::vec4(basis_.forward, 0);
      block.depthTerms = glm::vec4(near_, far_ - near_, 1, 0);
    } else {
      block.rayOrigin = glm::vec4(basis_.eye, 0);
      block.rayDirection = glm::vec4(basis_.forward + atCorner, 0);
      block.rayX = glm::vec4(alongX, 0);
      block.rayY = glm::vec4(alongY, 0);
      block.depthTerms = glm::vec4(near_ * far_, 0, far_, near_ - far_);
    }
  }

  // The pixels that a sphere may cover, clipped to the view; empty (z <= x) when it is outside.
  glm::ivec4 pixels(const WorldSphere& s) const {
    const glm::vec3 d = s.center - basis_.eye;
    const float x = glm::dot(d, basis_.right), y = glm::dot(d, basis_.up), z = glm::dot(d, basis_.forward);
    const float r = s.radius;
    if (z + r < near_ || z - r > far_) return glm::ivec4(0);
    glm::vec2 low(-1), high(1);
    if (orthographic()) {
      low = glm::vec2(x - r, y - r) / half_;
      high = glm::vec2(x + r, y + r) / half_;
    } else if (z - r > 1e-4f * r) {
      // The smallest and largest quotients of the sphere's box.
      const float close = 1 / (z - r), away = 1 / (z + r);
      low = glm::vec2(std::min((x - r) * close, (x - r) * away), std::min((y - r) * close, (y - r) * away)) / half_;
      high = glm::vec2(std::max((x + r) * close, (x + r) * away), std::max((y + r) * close, (y + r) * away)) / half_;
    }
    // One pixel of slack for the jitter.
    const auto pixel = [&](float ndc, int start, int size) {
      return static_cast<float>(start) + (std::clamp(ndc, -2.0f, 2.0f) + 1) * 0.5f * static_cast<float>(size);
    };
    const glm::ivec4 p(static_cast<int>(std::floor(pixel(low.x, rectangle_.x, rectangle_.z))) - 1,
                       static_cast<int>(std::floor(pixel(low.y, rectangle_.y, rectangle_.w))) - 1,
                       static_cast<int>(std::ceil(pixel(high.x, rectangle_.x, rectangle_.z))) + 1,
                       static_cast<int>(std::ceil(pixel(high.y, rectangle_.y, rectangle_.w))) + 1);
    const glm::ivec4 clipped(std::max(p.x, rectangle_.x), std::max(p.y, rectangle_.y), std::min(p.z, rectangle_.x + rectangle_.z),
                             std::min(p.w, rectangle_.y + rectangle_.w));
    return clipped.z > clipped.x && clipped.w > clipped.y ? clipped : glm::ivec4(0);
  }

 private:
  Basis basis_;
  const Camera& camera_;
  glm::ivec4 rectangle_;
  float near_, far_;
  glm::vec2 half_, jitter_{0};
};

// Uniform scale of a transform, or 0 when it has none.
float uniformScale(const glm::mat4& m) {
  const float x = glm::length(glm::vec3(m[0])), y = glm::length(glm::vec3(m[1])), z = glm::length(glm::vec3(m[2]));
  const float longest = std::max({x, y, z}), shortest = std::min({x, y, z});
  if (longest - shortest > 1e-4f * longest) return 0;
  const bool square = std::abs(glm::dot(glm::vec3(m[0]), glm::vec3(m[1]))) < 1e-4f * x * y &&
                      std::abs(glm::dot(glm::vec3(m[1]), glm::vec3(m[2]))) < 1e-4f * y * z &&
                      std::abs(glm::dot(glm::vec3(m[2]), glm::vec3(m[0]))) < 1e-4f * z * x;
  return square ? longest : 0;
}

float longestAxis(const glm::mat4& m) {
  // An upper bound of the largest stretch, also for sheared transforms.
  float sum = 0;
  for (int i = 0; i < 3; ++i) sum += glm::dot(glm::vec3(m[i]), glm::vec3(m[i]));
  return std::sqrt(sum);
}

// Below this a source is a point, metres: no eye and no float tells the difference.
constexpr float kSmallest = 1e-4f;

// What a light is drawn as: one without a size is a point, a tube without a length a sphere.
LightKind shapeOf(const Light& light) {
  if (light.kind == LightKind::Tube && light.length < kSmallest) return light.size < kSmallest ? LightKind::Point : LightKind::Sphere;
  if (light.kind == LightKind::Sphere && light.size < kSmallest) return LightKind::Point;
  return light.kind;
}

PointBlock pointBlock(const Light& light) {
  return {glm::vec4(light.position, 1 / (light.radius * light.radius)), glm::vec4(light.color * light.candela, light.constant)};
}

}  // namespace

PlacedBlock placedBlock(const Light& light) {
  const PointBlock point = pointBlock(light);
  PlacedBlock block{point.position, point.intensity, {}, {}};
  if (light.kind == LightKind::Sphere) block.along.w = light.size;
  if (light.kind == LightKind::Tube) block.along = glm::vec4(0.5f * light.length * light.axis, std::max(light.size, kSmallest));
  if (light.kind == LightKind::Rectangle) {
    glm::vec3 right, up;
    acrossAxis(light, right, up);
    const float width = std::max(light.width, kSmallest), height = std::max(light.height, kSmallest);
    block.along = glm::vec4(0.5f * width * right, 4 / (width * height));
    block.up = glm::vec4(0.5f * height * up, 0);
  }
  if (light.kind == LightKind::Spot) {
    const float outer = std::cos(light.outerAngle), inner = std::cos(std::min(light.innerAngle, light.outerAngle));
    const float scale = 1 / std::max(inner - outer, 1e-3f);
    block.along = glm::vec4(light.axis, scale);
    block.up.x = -outer * scale;
  }
  return block;
}

PreparedView prepareView(const View& view, DeviceMeshes& meshes, const std::vector<int>& groupOfMaterial, size_t groups, const std::vector<int>& shadows,
                         float exposureScale, int environmentLevels, glm::vec2 jitter) {
  const Scene& scene = *view.scene;
  PreparedView prepared;
  prepared.scene = view.scene;
  prepared.rectangle = view.rectangle;

  // Depth goes from the nearest to the farthest thing, so that its bits are spent where something is.
  const Basis basis = basisOf(view.camera);
  float nearest = view.camera.farPlane, farthest = view.camera.nearPlane;
  std::vector<WorldSphere> spheres;
  for (const Instance& instance : scene.instances) {
    const DeviceMesh& mesh = meshes.get(instance.mesh);
    const float scale = uniformScale(instance.worldFromModel);
    const WorldSphere sphere{glm::vec3(instance.worldFromModel * glm::vec4(mesh.center, 1)),
                             mesh.radius * (scale > 0 ? scale : longestAxis(instance.worldFromModel))};
    spheres.push_back(sphere);
    const float depth = glm::dot(sphere.center - basis.eye, basis.forward);
    nearest = std::min(nearest, depth - sphere.radius);
    farthest = std::max(farthest, depth + sphere.radius);
  }
  const float nearPlane = std::max(view.camera.nearPlane, nearest * 0.999f - 1e-3f);
  const float farPlane = std::clamp(farthest * 1.001f + 1e-3f, nearPlane * 1.01f + 1e-3f, std::max(view.camera.farPlane, nearPlane * 1.02f + 2e-3f));
  const Projection projection(view, nearPlane, farPlane, jitter);

  ViewBlock& block = prepared.block;
  block.clipFromWorld = projection.clipFromWorld();
  projection.fillRays(block);
  // Turning the environment by an angle about +Y looks it up at the direction turned back.
  const float c = std::cos(scene.environmentRotation), s = std::sin(scene.environmentRotation);
  block.environmentX = glm::vec4(c, 0, -s, 0);
  block.environmentZ = glm::vec4(s, 0, c, 0);
  block.environmentIntensity = scene.environmentIntensity;
  block.exposureScale = exposureScale;
  block.environmentLevels = static_cast<float>(environmentLevels);

  struct Reaching {
    Light light;
    int shadow;
  };
  std::vector<Reaching> placed;
  for (size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    const int shadow = shadows[i];
    if (!isSound(light)) continue;
    if (light.kind == LightKind::Directional) {
      if (prepared.directional.size() == kMostDirectionalLights) {
        prepared.tooManyDirectional = true;
        continue;
      }
      prepared.directional.push_back({glm::vec4(glm::normalize(light.direction), shadow), glm::vec4(light.color * light.lux, 0)});
    } else if (light.radius > 0) {
      placed.push_back({light, shadow});
      Light& shape = placed.back().light;
      shape.kind = shapeOf(light);
      if (shape.kind != LightKind::Point || shadow == 0) continue;
      // The blocks of points have no room for a shadow's number; a spot that shines to all sides is the same light.
      shape.kind = LightKind::Spot;
      shape.innerAngle = shape.outerAngle = glm::pi<float>();
    }
  }
  std::stable_sort(placed.begin(), placed.end(), [](const Reaching& a, const Reaching& b) { return a.light.kind < b.light.kind; });
  std::vector<Light> reaching;
  for (const auto& [light, shadow] : placed) {
    reaching.push_back(light);
    prepared.kinds |= 1u << static_cast<unsigned>(light.kind);
    if (light.kind == LightKind::Point) {
      prepared.points.push_back(pointBlock(light));
    } else {
      prepared.placed.push_back(placedBlock(light));
      prepared.placed.back().up.w = static_cast<float>(shadow);
    }
  }
  block.directionalCount = static_cast<int32_t>(prepared.directional.size());

  std::vector<std::vector<VisibleCluster>> visible(groups);
  std::vector<glm::ivec4> covered(groups, glm::ivec4(0));
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const glm::ivec4 whole = projection.pixels(spheres[i]);
    if (whole.z <= whole.x) continue;
    const Instance& instance = scene.instances[i];
    const SurfaceMaterial& material = scene.materials[static_cast<size_t>(instance.material)];
    if (groupOfMaterial[static_cast<size_t>(instance.material)] < 0) continue;
    const size_t group = static_cast<size_t>(groupOfMaterial[static_cast<size_t>(instance.material)]);
    const DeviceMesh& mesh = meshes.get(instance.mesh);
    PreparedInstance out;
    out.mesh = &mesh;
    out.worldFromModel = instance.worldFromModel;
    out.material = instance.material;
    const glm::mat3 linear(instance.worldFromModel);
    const float determinant = glm::determinant(linear);
    out.mirrored = determinant < 0;
    out.normalFromModel = std::abs(determinant) > 1e-20f ? glm::mat4(glm::transpose(glm::inverse(linear))) : glm::mat4(1);
    const float scale = uniformScale(instance.worldFromModel);
    const float stretch = scale > 0 ? scale : longestAxis(instance.worldFromModel);
    const bool cones = scale > 0 && !out.mirrored;
    for (const Cluster& cluster : mesh.clusters) {
      VisibleCluster v;
      v.center = glm::vec3(instance.worldFromModel * glm::vec4(cluster.center, 1));
      v.radius = cluster.radius * stretch;
      if (cones && !material.doubleSided) {
        v.axis = glm::mat3(out.normalFromModel) * cluster.axis * scale;
        v.coneCosine = cluster.coneCosine;
        const bool away = projection.orthographic() ? facesAwayFrom(v.axis, v.coneCosine, -basis.forward)
                                                    : facesAway(v.center, v.radius, v.axis, v.coneCosine, basis.eye);
        if (away) continue;
        if (material.compiled->writesNormal) v.coneCosine = -1;
      }
      v.pixels = projection.pixels({v.center, v.radius});
      if (v.pixels.z <= v.pixels.x) continue;
      // Neighbouring ranges become one.
      const size_t first = size_t{cluster.firstIndex} * sizeof(uint32_t);
      if (!out.counts.empty() && reinterpret_cast<size_t>(out.offsets.back()) + static_cast<size_t>(out.counts.back()) * sizeof(uint32_t) == first) {
        out.counts.back() += static_cast<GLsizei>(cluster.indexCount);
      } else {
        out.counts.push_back(static_cast<GLsizei>(cluster.indexCount));
        out.offsets.push_back(reinterpret_cast<const void*>(first));
      }
      prepared.triangles += static_cast<int>(cluster.indexCount / 3);
      if (!reaching.empty()) visible[group].push_back(v);
    }
    if (out.counts.empty()) continue;
    glm::ivec4& cover = covered[group];
    cover = cover.z <= cover.x ? whole
                               : glm::ivec4(std::min(cover.x, whole.x), std::min(cover.y, whole.y),
                                            std::max(cover.z, whole.z), std::max(cover.w, whole.w));
    prepared.instances.push_back(std::move(out));
  }
  for (size_t g = 0; g < groups; ++g) {
    const glm::ivec4 r = covered[g];
    if (!reaching.empty())
      prepared.tiles.push_back(buildLightTiles(visible[g], reaching, view.rectangle, kMostLightTexels / groups));
    else if (r.z > r.x)
      prepared.tiles.push_back({{{r.x, r.y, r.z, r.w, 0, 0, 0, 0}}, {}, 0});
    else
      prepared.tiles.emplace_back();
  }
  return prepared;
}

}  // namespace glint
