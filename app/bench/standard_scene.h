// The scene of the frame cases, the same numbers for every program that draws it: 20 spheres of 64x32 segments,
// roughness over the columns and four materials over the rows; one directional light; point lights in candela
// with a range, at Halton's points in front of the spheres.
#pragma once

#include <string>
#include <vector>

#include "app/scene_loader.h"
#include "renderer/scene.h"

namespace glint {

inline constexpr int kStandardRows = 4, kStandardColumns = 5;
inline constexpr glm::ivec2 kStandardSize{1280, 720};

// What one sphere is: its material's name says the row.
struct StandardSphere {
  int row = 0, column = 0;
  glm::vec3 center{0};
  std::string name;
  glm::vec3 color{0};
  float metallic = 0, roughness = 0;
};
std::vector<StandardSphere> standardSpheres();

Light standardSun();
// 16, 128 or 1024 of them: brighter and wider when they are few.
std::vector<Light> standardPointLights(int count);
// The same places, power and range as lights of another kind, which shine at the spheres.
std::vector<Light> standardLights(LightKind, int count);

Camera standardCamera();

// The spheres, each row drawn by rowModels[row % size]; neither lights nor environment. Errors: a model that does
// not compile with the plain material.
Result<Scene> standardScene(const std::vector<ModelPtr>& rowModels, Libraries&);

}  // namespace glint
