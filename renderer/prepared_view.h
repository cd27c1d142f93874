// A view made ready to draw: what is visible, in which light groups, with which lights where. No OpenGL calls.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/device_mesh.h"
#include "renderer/light_tiles.h"
#include "renderer/renderer.h"

namespace glint {

// The block of shaders/common/view.glsl, std140.
struct ViewBlock {
  glm::mat4 clipFromWorld;
  glm::vec4 rayOrigin, originX, originY;
  glm::vec4 rayDirection, rayX, rayY;
  glm::vec4 depthTerms;
  glm::vec4 environmentX, environmentZ;
  float environmentIntensity, exposureScale, environmentLevels;
  int32_t directionalCount;
};
static_assert(sizeof(ViewBlock) == 64 + 9 * 16 + 16);

struct DirectionalBlock {
  glm::vec4 direction, radiance;   // direction.w: the number of its shadow, 0 without
};
inline constexpr size_t kMostDirectionalLights = 16;

struct PointBlock {
  glm::vec4 position, intensity;   // w: 1 / radius^2, and the falloff's constant
};
static_assert(sizeof(PointBlock) == kPointTexels * 16);

// PlacedLight of shaders/common/lights.glsl.
struct PlacedBlock {
  glm::vec4 position, intensity;   // as of a point light
  glm::vec4 along;                 // w: extent.x
  glm::vec4 up;                    // w: the number of its shadow, 0 without; of a spot x is extent.y
};
static_assert(sizeof(PlacedBlock) == kPlacedTexels * 16);
// Of a light that has a place and is none of points.
PlacedBlock placedBlock(const Light&);

// The visible part of one instance, as ranges of its mesh's indices.
struct PreparedInstance {
  const DeviceMesh* mesh = nullptr;
  glm::mat4 worldFromModel{1}, normalFromModel{1};
  int material = 0;                // index into Scene::materials
  bool mirrored = false;           // the transform turns triangles inside out
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;  // bytes, as glMultiDrawElements takes them
};

struct PreparedView {
  const Scene* scene = nullptr;
  glm::ivec4 rectangle{0};
  ViewBlock block{};
  std::vector<PreparedInstance> instances;
  std::vector<DirectionalBlock> directional;
  std::vector<PointBlock> points;
  std::vector<PlacedBlock> placed;   // by kind
  uint32_t kinds = 0;                // bits by LightKind of those with a place
  // By light group: where its surfaces may be, with the lights that reach them: indices into the points, and then the
  // placed. Without such lights one rectangle each.
  std::vector<LightTiles> tiles;
  int triangles = 0;
  bool tooManyDirectional = false;
};

// `jitter` moves the samples by a fraction of a pixel (-0.5 .. 0.5).
// `groupOfMaterial` names the light group of each of the scene's materials, 0 .. groups - 1 or -1 for not drawn.
// `shadows` has the number of each light's shadow, 0 without.
PreparedView prepareView(const View&, DeviceMeshes&, const std::vector<int>& groupOfMaterial, size_t groups, const std::vector<int>& shadows,
                         float exposureScale, int environmentLevels, glm::vec2 jitter);

}  // namespace glint
