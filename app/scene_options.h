// The options that `render` and `compare` share, from words to values. Nothing is loaded here: see
// app/scene_loader.h.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/command.h"
#include "app/option_values.h"
#include "materials/base/diagnostic.h"
#include "renderer/material_settings.h"
#include "renderer/renderer.h"

namespace glint {

inline constexpr int kMostSamples = 1024;

// "ggx" or "burley:gamma=2".
struct ModelChoice {
  std::string id;
  std::vector<Setting> parameters;
};

// What --camera gave; the rest frames the scene.
struct CameraChoice {
  std::optional<glm::vec3> eye, target;
  std::optional<float> fovY;         // radians
  std::optional<float> orthoHeight;  // metres

  bool any() const { return eye || target || fovY || orthoHeight; }
  void apply(Camera&) const;
};

struct SceneOptions {
  std::string mesh;                  // a shape or a glTF file; empty: the command's own
  std::string material;              // a library name or a .json file; empty: the mesh's own, or the default
  std::optional<ModelChoice> model;
  std::vector<Setting> settings;   // --set, in order
  std::string environment = "studio";
  float environmentRotation = 0;     // radians
  float environmentIntensity = 1;
  std::vector<Light> lights;
  CameraChoice camera;
  Ground ground = Ground::None;
  bool backgroundGiven = false;
  glm::ivec2 size{1280, 720};
  RenderSettings render;
};

// --mesh to --view, to append to a command's own options.
std::vector<Option> sceneOptionTable();

// Every fault of every option, each with the option as its place.
Result<SceneOptions> parseSceneOptions(const Arguments&);

// "A:p=v,q=w,B": a word with '=' and no ':' before it belongs to the model on its left.
Result<std::vector<ModelChoice>> parseModelList(const std::string& text, const std::string& place);
// One light, "directional:dir=1/1/1,lux=3.14" or "point:pos=0/2/1,lumens=800,radius=10".
Result<Light> parseLight(const std::string& text);
}  // namespace glint
