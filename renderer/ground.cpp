#include "renderer/ground.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "materials/base/hash.h"

namespace glint {
namespace {

constexpr float kRadii = 4;   // of the ground, in radii of what stands on it

// A disc in xz, facing +Y.
MeshPtr discMesh() {
  static const MeshPtr disc = [] {
    constexpr uint32_t kSegments = 64;
    auto mesh = std::make_shared<Mesh>();
    mesh->name = "ground";
    const auto add = [&](glm::vec3 position) { mesh->vertices.push_back({.position = position, .normal = {0, 1, 0}, .tangent = {1, 0, 0, 1}, .uv0 = {}, .uv1 = {}, .color = glm::vec4(1)}); };
    add(glm::vec3(0));
    for (uint32_t i = 0; i < kSegments; ++i) {
      const float angle = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(kSegments);
      add({std::sin(angle), 0, std::cos(angle)});
      mesh->indices.insert(mesh->indices.end(), {0, i + 1, (i + 1) % kSegments + 1});
    }
    return mesh;
  }();
  return disc;
}

// Its cavity ends towards the rim: shaders/passes/lighting.frag fades it out by that.
std::shared_ptr<const CompiledMaterial> groundMaterial() {
  static const std::shared_ptr<const CompiledMaterial> material = [] {
    auto compiled = std::make_shared<CompiledMaterial>();
    compiled->name = "ground";
    compiled->glsl =
        "void evaluateMaterial(in MaterialInputs i, inout MaterialAttributes m) {\n"
        "  m.baseColor = vec3(0.18); m.metallic = 0.0; m.specular = 0.0; m.roughness = 1.0; m.ambientOcclusion = 1.0;\n"
        "  m.cavity = 1.0 - smoothstep(0.25, 0.95, length(i.localPosition.xz));\n"
        "  m.normal = vec3(0.0, 0.0, 1.0); m.emissive = vec3(0.0); m.opacityMask = 1.0;\n}\n";
    compiled->hash = hashText(compiled->glsl);
    return compiled;
  }();
  return material;
}

}  // namespace

void addGround(Scene& scene, Ground ground, const std::shared_ptr<const ShadingModel>& model) {
  if (ground == Ground::None || !model) return;
  glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
  for (const Instance& instance : scene.instances) {
    if (!instance.mesh) continue;
    for (const Vertex& vertex : instance.mesh->vertices) {
      const glm::vec3 p = instance.worldFromModel * glm::vec4(vertex.position, 1);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  if (low.x > high.x) return;
  const glm::vec3 middle = 0.5f * (low + high);
  const float size = std::max(0.5f * glm::length(high - low), 1e-6f), radius = kRadii * size;
  SurfaceMaterial material;
  material.compiled = groundMaterial();
  material.model = model;
  material.ground = ground;
  // A little lower, so that a flat foot does not share its depth.
  const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1), glm::vec3(middle.x, low.y - 1e-4f * size, middle.z)), glm::vec3(radius));
  scene.instances.push_back({discMesh(), place, static_cast<int>(scene.materials.size())});
  scene.materials.push_back(std::move(material));
}

void includeGround(Camera& camera, const Scene& scene) {
  for (const Instance& instance : scene.instances) {
    if (scene.materials[static_cast<size_t>(instance.material)].ground == Ground::None) continue;
    const float distance = glm::length(camera.eye - glm::vec3(instance.worldFromModel[3])), radius = glm::length(glm::vec3(instance.worldFromModel[0]));
    camera.nearPlane = std::min(camera.nearPlane, 0.02f * std::max(distance, radius / kRadii));
    camera.farPlane = std::max(camera.farPlane, distance + 1.2f * radius);
  }
}

}  // namespace glint
