// How the material is looked at: on what, in which light, through which camera. Values only; a project file holds them.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/base/json.h"
#include "renderer/renderer.h"
#include "renderer/scene.h"

namespace glint {

// Where the viewer stands: around a target, angles in degrees.
struct Orbit {
  float yaw = 30, pitch = 15;           // of the eye, seen from the target; yaw about +Y from +Z
  float distance = 4;                   // metres
  glm::vec3 target{0};
  float fov = 30;                       // degrees, vertical
  bool operator==(const Orbit&) const = default;

  Camera camera(float sceneRadius) const;
};

struct Preview {
  enum class Subject { Comparison, Mesh };
  enum class Columns { Materials, Sweep };

  Subject subject = Subject::Comparison;

  // Comparison: sphere rows.
  std::vector<std::string> models{"blinn-phong", "cook-torrance", "burley", "ggx"};
  Columns columns = Columns::Materials;
  // Beside the edited material, which is the first column: names of the library, or files.
  std::vector<std::string> materials{"rubber", "black"};
  std::string sweepName = "roughness";
  float sweepFrom = 0, sweepTo = 1;
  int sweepCount = 5;

  // Mesh: a shape's name, or a glTF file.
  std::string mesh = "shaderball";
  bool ownMaterials = false;            // draw a glTF file with its own materials instead of the edited one
  int editedSlot = -1;                  // but for this one of them, which the edited material stands in for; -1: none

  std::string environment = "studio";   // a name or a file
  float environmentRotation = 0;        // degrees about +Y
  float environmentIntensity = 1;
  std::vector<Light> lights;

  std::string view = "lit";
  float exposure = 0;                   // EV
  Tonemap tonemap = Tonemap::None;
  Background background = Background::Color;
  glm::vec3 backgroundColor{0.02f};     // linear
  // Instead of approximations, as it converges; the error view compares with it.
  bool reference = false;
  bool splitSum = false;                // as RenderSettings, and likewise
  float errorScale = 0.25f;             // as RenderSettings
  bool compensate = false;              // as RenderSettings
  AreaLights areaLights = AreaLights::Cosines;
  // Of a mesh; a comparison of spheres has none of them.
  Shadows shadows = Shadows::Contact;
  bool materialOcclusion = true, screenOcclusion = true;
  Ground ground = Ground::Matte;
  bool specularAntialiasing = true;     // as RenderSettings
  // Edges: the pictures of a view that rests are averaged. Of comparisons too.
  bool antialiasing = true;

  // Not a step of undo: looking around changes nothing.
  Orbit orbit;
  Orbit comparisonOrbit{.yaw = 0, .pitch = 0, .distance = 4.3f, .fov = 30};

  // All but the orbits.
  bool sameSettings(const Preview&) const;
};

// One name for each value, as the command line spells them.
std::string_view name(Tonemap);
std::string_view name(Background);

Json previewJson(const Preview&);
// What is missing or damaged keeps its default; each fault is a warning that names its member.
Preview previewFrom(const Json&, const std::string& place, Diagnostics& warnings);

}  // namespace glint
