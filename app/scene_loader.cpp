#include "app/scene_loader.h"

#include <algorithm>
#include <set>

#include "materials/base/log.h"
#include "materials/model_file.h"
#include "materials/model_mix.h"
#include "renderer/environment.h"
#include "renderer/gltf_loader.h"
#include "renderer/gltf_material.h"
#include "renderer/mesh.h"

namespace glint {
namespace {

void append(Diagnostics& to, const Diagnostics& from) {
  for (const Diagnostic& d : from)
    if (std::find(to.begin(), to.end(), d) == to.end()) to.push_back(d);
}

bool isGltf(const std::string& name) {
  const auto extension = std::filesystem::path(name).extension();
  return extension == ".glb" || extension == ".gltf";
}

}  // namespace

Result<ModelPtr> Libraries::namedModel(const std::string& idOrFile, const std::string& place) const {
  if (!isModelFile(idOrFile)) return model(idOrFile, place);
  Diagnostics warnings;
  auto found = models.named(idOrFile, &warnings);
  log::report(warnings);
  return found;
}

Result<ModelPtr> Libraries::model(const std::string& id, const std::string& place) const {
  auto found = models.get(id);
  if (found) return found;
  if (isModelMix(id)) {
    Diagnostics faults = found.diagnostics();
    for (Diagnostic& d : faults) d.place = place;
    return faults;
  }
  // A model that is not there may be one whose file is broken: then that is what is wrong.
  if (found.diagnostics()[0].place != unknownModelPlace(id)) return found;
  return error(place, fmt::format("unknown shading model '{}'", id), found.diagnostics()[0].hint);
}

Result<MaterialPtr> Libraries::material(const std::string& nameOrFile, const std::string& place, Diagnostics& warnings) const {
  auto loaded = loadMaterial(nameOrFile, nodes, &warnings);
  if (loaded) return MaterialPtr(std::make_shared<Material>(std::move(*loaded)));
  Diagnostics all = loaded.diagnostics();
  for (Diagnostic& d : all)
    if (d.place == fmt::format("material '{}'", nameOrFile)) d.place = place;
  return all;
}

Result<Scene> loadStage(const SceneOptions& options, Diagnostics& warnings) {
  Scene scene;
  scene.lights = options.lights;
  auto environment = loadEnvironment(options.environment, &warnings);
  if (!environment) return environment.diagnostics();
  scene.environment = std::move(*environment);
  scene.environmentRotation = options.environmentRotation;
  scene.environmentIntensity = options.environmentIntensity;
  return scene;
}

Result<LoadedMesh> loadMesh(const std::string& shapeOrFile, const std::string& place, TextureCache& textures, Diagnostics& warnings) {
  LoadedMesh loaded;
  if (const MeshPtr shape = shapeMesh(shapeOrFile)) {
    loaded.instances.push_back({shape, glm::mat4(1), 0});
    return loaded;
  }
  if (!isGltf(shapeOrFile))
    return error(place, fmt::format("unknown shape '{}'", shapeOrFile),
                 suggestion(shapeOrFile, shapeNames()) + ", or a .glb or .gltf file");
  auto file = loadGltf(shapeOrFile, warnings);
  if (!file) return file.diagnostics();
  for (const GltfNode& node : file->nodes) loaded.instances.push_back({node.mesh, node.worldFromModel, node.material});
  putPictures(*file, textures);
  for (const GltfMaterial& material : file->materials) {
    SurfaceMaterial state;
    setSurfaceState(material, state);
    loaded.materials.push_back(std::make_shared<Material>(gltfMaterialGraph(material, *file)));
    loaded.doubleSided.push_back(state.doubleSided);
    loaded.opacityCutoff.push_back(state.opacityCutoff);
  }
  if (loaded.instances.empty()) return error(shapeOrFile, "its scene has no mesh", "export it with its geometry");
  return loaded;
}

Result<Scene> loadScene(const SceneOptions& options, Libraries& libraries, Diagnostics& warnings) {
  Diagnostics faults;
  auto stage = loadStage(options, warnings);
  if (!stage) append(faults, stage.diagnostics());
  auto mesh = loadMesh(options.mesh.empty() ? "sphere" : options.mesh, "--mesh", libraries.textures, warnings);
  if (!mesh) append(faults, mesh.diagnostics());

  ModelPtr model;  // null: the material's own
  if (options.model) {
    auto found = libraries.namedModel(options.model->id, "--model");
    if (found) model = *found;
    else append(faults, found.diagnostics());
  }
  MaterialPtr given;
  if (!options.material.empty()) {
    auto found = libraries.material(options.material, "--material", warnings);
    if (found) given = *found;
    else append(faults, found.diagnostics());
  }
  if (!faults.empty()) return faults;

  std::vector<MaterialPtr> materials = mesh->materials;
  if (given || materials.empty()) {
    materials.assign(1, given ? given : std::make_shared<Material>(newMaterial("default")));
    for (Instance& instance : mesh->instances) instance.material = 0;
  }
  struct Pair {
    MaterialPtr material;
    ModelPtr model;
  };
  std::vector<Pair> pairs;
  for (const MaterialPtr& material : materials) {
    if (model) {
      pairs.push_back({material, model});
      continue;
    }
    auto own = libraries.model(material->model, material->modelPlace());
    if (own) pairs.push_back({material, *own});
    else append(faults, own.diagnostics());
  }
  if (!faults.empty()) return faults;

  std::vector<Setting> settings = options.settings;
  if (options.model) settings.insert(settings.begin(), options.model->parameters.begin(), options.model->parameters.end());
  // Among several materials a setting need not suit all; one that suits none is given to all, to be refused.
  const auto taken = [&](const Pair& pair, const Setting& setting) { return takesSetting(*pair.material, *pair.model, setting.name); };
  Scene scene = std::move(*stage);
  for (size_t i = 0; i < pairs.size(); ++i) {
    std::vector<Setting> own;
    for (const Setting& setting : settings)
      if (taken(pairs[i], setting) || std::none_of(pairs.begin(), pairs.end(), [&](const Pair& p) { return taken(p, setting); }))
        own.push_back(setting);
    Diagnostics problems;
    auto surface = surfaceWith(*pairs[i].material, pairs[i].model, own, "--set", libraries.sources(), problems);
    append(warnings, problems);
    if (!surface) {
      append(faults, surface.diagnostics());
      continue;
    }
    if (!given && !mesh->materials.empty()) {
      surface->doubleSided = mesh->doubleSided[i];
      surface->opacityCutoff = mesh->opacityCutoff[i];
    }
    scene.materials.push_back(std::move(*surface));
  }
  // What a file names must be there: a missing texture is bad input here, where the editor would show it.
  for (const Diagnostic& d : warnings)
    if (d.severity == Severity::Error) faults.push_back(d);
  std::erase_if(warnings, [](const Diagnostic& d) { return d.severity == Severity::Error; });
  if (!faults.empty()) return faults;
  scene.instances = std::move(mesh->instances);
  return scene;
}

}  // namespace glint
