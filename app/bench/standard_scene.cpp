#include "app/bench/standard_scene.h"

#include <cmath>
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "renderer/mesh.h"

namespace glint {
namespace {

// The i-th point of van der Corput's sequence, i from 1.
double halton(int i, int base) {
  double f = 1, r = 0;
  for (; i > 0; i /= base) {
    f /= base;
    r += f * (i % base);
  }
  return r;
}

// A pure hue, 0..1, with `floor` for its smallest component.
glm::vec3 hueColor(double hue, double floor) {
  glm::vec3 color;
  const double offsets[3] = {0, 4, 2};
  for (int k = 0; k < 3; ++k) {
    const double part = std::abs(std::fmod(offsets[k] + hue * 6, 6) - 3) - 1;
    color[k] = static_cast<float>(floor + (1 - floor) * std::clamp(part, 0.0, 1.0));
  }
  return color;
}

}  // namespace

std::vector<StandardSphere> standardSpheres() {
  struct Row {
    const char* name;
    glm::vec3 color;
    float metallic;
  };
  static const Row rows[kStandardRows] = {{"dielectric-black", {0, 0, 0}, 0},
                                          {"dielectric-red", {0.8f, 0.05f, 0.05f}, 0},
                                          {"gold", {1, 0.766f, 0.336f}, 1},
                                          {"aluminium", {0.913f, 0.921f, 0.925f}, 1}};
  std::vector<StandardSphere> spheres;
  for (int row = 0; row < kStandardRows; ++row)
    for (int column = 0; column < kStandardColumns; ++column)
      spheres.push_back({row, column, {2.4f * float(column - 2), 2.4f * (1.5f - float(row)), 0}, rows[row].name, rows[row].color,
                         rows[row].metallic, 0.1f + 0.9f * float(column) / float(kStandardColumns - 1)});
  return spheres;
}

Light standardSun() {
  Light sun;
  sun.kind = LightKind::Directional;
  sun.direction = glm::normalize(glm::vec3(1, 1, 1));
  sun.lux = std::numbers::pi_v<float>;
  return sun;
}

std::vector<Light> standardPointLights(int count) {
  const bool few = count <= 16, many = count > 128;
  std::vector<Light> lights;
  for (int i = 0; i < count; ++i) {
    Light light;
    light.kind = LightKind::Point;
    light.position = {6 * (2 * halton(i + 1, 2) - 1), 5 * (2 * halton(i + 1, 3) - 1), 2};
    light.candela = few ? 2.0f : many ? 0.15f : 0.5f;
    light.radius = few ? 8.0f : many ? 1.8f : 3.0f;
    light.color = hueColor(std::fmod(i * 0.61803398875, 1), 0.35);  // the golden ratio apart
    lights.push_back(light);
  }
  return lights;
}

std::vector<Light> standardLights(LightKind kind, int count) {
  std::vector<Light> lights = standardPointLights(count);
  for (Light& light : lights) {
    light.kind = kind;
    light.axis = kind == LightKind::Tube ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, -1);
    light.size = kind == LightKind::Tube ? 0.05f : 0.3f;
    light.outerAngle = 1;
  }
  return lights;
}

Camera standardCamera() {
  Camera camera;
  camera.eye = {0, 0, 19};
  camera.target = {0, 0, 0};
  camera.fovY = glm::radians(30.f);
  camera.nearPlane = 1;
  camera.farPlane = 100;
  return camera;
}

Result<Scene> standardScene(const std::vector<ModelPtr>& rowModels, Libraries& libraries) {
  GLINT_CHECK(!rowModels.empty());
  Scene scene;
  const MeshPtr sphere = sphereMesh(64, 32);
  Diagnostics problems;
  for (const StandardSphere& s : standardSpheres()) {
    const std::vector<Setting> settings = {{"baseColor", fmt::format("{}/{}/{}", s.color.r, s.color.g, s.color.b)},
                                           {"metallic", fmt::format("{}", s.metallic)},
                                           {"roughness", fmt::format("{}", s.roughness)}};
    auto surface = surfaceWith(newMaterial("standard"), rowModels[size_t(s.row) % rowModels.size()], settings, "standard scene", libraries.sources(), problems);
    if (!surface) return surface.diagnostics();
    scene.instances.push_back({sphere, glm::translate(glm::mat4(1), s.center), static_cast<int>(scene.materials.size())});
    scene.materials.push_back(std::move(*surface));
  }
  return scene;
}

}  // namespace glint
