// From the values of the scene options to a scene: everything is found, loaded and compiled here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene_options.h"
#include "materials/function_library.h"
#include "materials/material_library.h"
#include "materials/model_registry.h"
#include "materials/node_registry.h"
#include "renderer/material_settings.h"
#include "renderer/scene.h"

namespace glint {

// Everything that materials are made of, read once.
struct Libraries {
  explicit Libraries(const std::vector<std::filesystem::path>& modelFolders) : models(modelFolders) {}

  ModelRegistry models;
  NodeRegistry nodes;
  FunctionLibrary functions;
  TextureCache textures;

  MaterialSources sources() { return {nodes, functions, textures}; }
  // A model as a user names it: by id, as a mix, or by the path of its file. `place` is the option that named it.
  Result<ModelPtr> namedModel(const std::string& idOrFile, const std::string& place) const;
  // An unknown id names the nearest; when files of models are broken, their errors come with it.
  Result<ModelPtr> model(const std::string& id, const std::string& place) const;
  // A material of the library or of a file; `place` is the option that named it.
  Result<MaterialPtr> material(const std::string& nameOrFile, const std::string& place, Diagnostics& warnings) const;
};

// The lights and the environment, without any instance.
Result<Scene> loadStage(const SceneOptions&, Diagnostics& warnings);

// The whole scene of `render`: mesh, materials with the model and settings of the options, lights, environment.
// Every error at once where one does not hide another.
Result<Scene> loadScene(const SceneOptions&, Libraries&, Diagnostics& warnings);

// The shape or file of --mesh as instances with their own materials (empty for shapes).
struct LoadedMesh {
  std::vector<Instance> instances;
  std::vector<MaterialPtr> materials;  // of a glTF file
  std::vector<bool> doubleSided;       // for each of them
  std::vector<float> opacityCutoff;
};
Result<LoadedMesh> loadMesh(const std::string& shapeOrFile, const std::string& place, TextureCache&, Diagnostics& warnings);

}  // namespace glint
