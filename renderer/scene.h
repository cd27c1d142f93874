// What is drawn: values only, no OpenGL. The renderer keeps its own copies on the device by identity of the
// shared pointers, so sharing an object shares its cost.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "materials/compiled_material.h"
#include "materials/model.h"
#include "renderer/image.h"
#include "renderer/light.h"
#include "renderer/mesh.h"

namespace glint {

// A material ready to draw: compiled, with its shading model, parameter values and textures.
// What a surface under the subject (renderer/ground.h) shows, fading out towards its rim: the background, darker where light
// does not arrive; or itself. It casts no shadow, and is there in the lit view only.
enum class Ground { None, Shadow, Matte };

struct SurfaceMaterial {
  std::shared_ptr<const CompiledMaterial> compiled;
  std::shared_ptr<const ShadingModel> model;
  std::vector<std::byte> block;        // std140 parameters, compiled->blockSize bytes
  std::vector<Image8Ptr> textures;     // one per compiled->textures; null is white
  // The model's parameters (by their order in model->parameters) where the material sets them to one value
  // for its whole surface; the lobe tables of the environment are built for these.
  std::vector<Value> modelParameters;
  bool doubleSided = false;
  float opacityCutoff = 0.5f;          // opacityMask below this is a hole
  Ground ground = Ground::None;
};

struct Instance {
  MeshPtr mesh;
  glm::mat4 worldFromModel{1};
  int material = 0;                    // index into Scene::materials
};

// An equirectangular environment in nits, oriented as product.md 1 says.
struct Environment {
  std::string name;                    // "studio", or the file's name
  ImageF pixels;                       // 3 channels, 2:1, finite and non-negative
  uint64_t hash = 0;                   // of the pixels: keys the caches
};
using EnvironmentPtr = std::shared_ptr<const Environment>;

struct Scene {
  std::vector<SurfaceMaterial> materials;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  EnvironmentPtr environment;          // null: none
  float environmentRotation = 0;       // radians about +Y
  float environmentIntensity = 1;
};

// Looks from `eye` to `target`. orthoHeight > 0 makes it orthographic: the height of the view in metres.
struct Camera {
  glm::vec3 eye{0, 0, 4}, target{0}, up{0, 1, 0};
  float fovY = 0.5235988f;             // radians
  float orthoHeight = 0;
  float nearPlane = 0.05f, farPlane = 200;

  glm::mat4 viewFromWorld() const;
  glm::mat4 clipFromView(float aspect) const;
};

// Fits a camera to the bounds of a scene, from a slightly raised three-quarter view.
Camera frameScene(const Scene&, float aspect);

}  // namespace glint
