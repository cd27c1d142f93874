// Scenes for tests of the renderer, made by hand so that they need neither the graph compiler nor files.
#pragma once

#include <cstring>

#include "materials/base/hash.h"
#include "materials/model_registry.h"
#include "renderer/scene.h"

namespace glint::test {

struct Look {
  glm::vec3 baseColor{0.8f};
  float metallic = 0, roughness = 0.5f, specular = 0.5f;
};

// A material whose whole graph is uniforms: every look shares one program.
inline SurfaceMaterial material(const ModelPtr& model, const Look& look) {
  auto compiled = std::make_shared<CompiledMaterial>();
  compiled->name = "test";
  compiled->model = model->id;
  compiled->glsl =
      "layout(std140, binding = 1) uniform MaterialParameters { vec4 colorAndMetallic; vec4 rest; };\n"
      "void evaluateMaterial(in MaterialInputs i, inout MaterialAttributes m) {\n"
      "  m.baseColor = colorAndMetallic.rgb; m.metallic = colorAndMetallic.a;\n"
      "  m.specular = rest.y; m.roughness = rest.x; m.cavity = 1.0; m.ambientOcclusion = 1.0;\n"
      "  m.normal = vec3(0.0, 0.0, 1.0); m.emissive = vec3(0.0); m.opacityMask = 1.0;\n}\n";
  compiled->hash = hashText(compiled->glsl);
  compiled->blockSize = 32;
  SurfaceMaterial surface;
  surface.compiled = compiled;
  surface.model = model;
  surface.block.resize(32);
  const float values[8] = {look.baseColor.x, look.baseColor.y, look.baseColor.z, look.metallic, look.roughness, look.specular, 0, 0};
  std::memcpy(surface.block.data(), values, sizeof values);
  return surface;
}

// One value everywhere.
inline EnvironmentPtr uniformEnvironment(float value, int width = 64) {
  auto environment = std::make_shared<Environment>();
  environment->name = "uniform";
  environment->pixels = ImageF(width, width / 2, 3);
  std::fill(environment->pixels.data.begin(), environment->pixels.data.end(), value);
  environment->hash = hashBytes(environment->pixels.data.data(), environment->pixels.data.size() * 4);
  return environment;
}

}  // namespace glint::test
