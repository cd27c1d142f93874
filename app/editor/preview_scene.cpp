#include "app/editor/preview_scene.h"

#include <algorithm>
#include <cmath>

#include "app/editor/model_row.h"
#include "materials/graph_compile.h"
#include "materials/material_library.h"
#include "renderer/environment.h"
#include "renderer/ground.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

void append(Diagnostics& to, const Diagnostics& from) {
  for (const Diagnostic& d : from)
    if (std::find(to.begin(), to.end(), d) == to.end()) to.push_back(d);
}

std::string firstFault(const Diagnostics& problems) {
  for (const Diagnostic& d : problems)
    if (d.severity == Severity::Error) return d.what;
  return {};
}

// Slots of surfaces that are the edited material's.
constexpr const char *kEdited = "edited", *kSweep = "sweep";

fs::file_time_type timeOf(const std::string& file) {
  std::error_code ignored;
  const auto time = fs::last_write_time(file, ignored);
  return ignored ? fs::file_time_type{} : time;
}

void boundsOf(const Scene& scene, glm::vec3& center, float& radius) {
  glm::vec3 low(0), high(0);
  bool any = false;
  for (const Instance& instance : scene.instances) {
    glm::vec3 a, b;
    instance.mesh->bounds(a, b);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 p(corner & 1 ? b.x : a.x, corner & 2 ? b.y : a.y, corner & 4 ? b.z : a.z);
      const glm::vec3 world = instance.worldFromModel * glm::vec4(p, 1);
      low = any ? glm::min(low, world) : world;
      high = any ? glm::max(high, world) : world;
      any = true;
    }
  }
  center = (low + high) * 0.5f;
  radius = std::max(1e-4f, glm::length(high - low) * 0.5f);
}

}  // namespace

ComparisonLayout comparisonLayout(glm::ivec2 size, int rows, const std::vector<std::string>& titles, float scale) {
  const int columns = int(titles.size());
  ComparisonLayout layout;
  layout.titleHeight = std::round(30 * scale);
  layout.titleWidth = std::round(108 * scale);
  const int margin = int(std::round(12 * scale)), gap = int(std::round(6 * scale));
  const int width = size.x - int(layout.titleWidth) - margin, height = size.y - int(layout.titleHeight) - margin;
  CellGrid& grid = layout.grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.gapX = grid.gapY = gap;
  const int n = std::max(1, columns), m = std::max(1, rows);
  grid.cell = std::max(8, std::min((width - gap * (n - 1)) / n, (height - gap * (m - 1)) / m));
  // Where cells are small and there is room, they stand apart so that their titles can be read: at some 8 units a letter.
  size_t letters = 0;
  for (const std::string& title : titles) letters = std::max(letters, title.size());
  const int wanted = int(std::round((8.0f * float(std::min<size_t>(letters, 24)) + 12) * scale)) - grid.cell;
  if (n > 1) grid.gapX = std::max(gap, std::min(wanted, (width - grid.cell * n) / (n - 1)));
  const glm::ivec2 whole = grid.size();
  // The titles and the cells together lie in the middle.
  grid.origin.x = int(layout.titleWidth) + std::max(0, (size.x - int(layout.titleWidth) - margin - whole.x) / 2);
  grid.origin.y = margin + std::max(0, (height - whole.y) / 2);
  return layout;
}

std::vector<std::string> distinctTitles(const std::vector<ColumnName>& columns) {
  std::vector<std::string> titles;
  for (const ColumnName& column : columns) {
    const auto alike = std::count_if(columns.begin(), columns.end(), [&](const ColumnName& c) { return c.name == column.name; });
    std::string title = alike > 1 && !column.particular.empty() ? column.name + " (" + column.particular + ")" : column.name;
    const std::string base = title;
    for (int i = 2; std::find(titles.begin(), titles.end(), title) != titles.end(); ++i) title = base + " " + std::to_string(i);
    titles.push_back(std::move(title));
  }
  return titles;
}

PreviewScene::PreviewScene(const NodeRegistry& nodes, const FunctionLibrary& functions)
    : nodes_(nodes), functions_(functions) {}

void PreviewScene::update(const FrameRequest& request) {
  problems.clear();
  edited_ = request.material;
  namedFiles_ = request.namedFiles;
  graphOk = true;
  meshMaterials.clear();
  usedSurfaces_.clear();
  states.clear();
  rows.clear();
  ownRow = -1;
  if (textures_.refresh()) surfaces_.clear();
  if (document_ != request.document) {
    document_ = request.document;
    std::erase_if(surfaces_, [](const auto& item) { return item.first.starts_with(kEdited) || item.first.starts_with(kSweep); });
    code.clear();
  }
  const Preview& preview = request.preview;
  loadEnvironmentOf(preview);
  Scene stage;
  stage.lights = preview.lights;
  stage.environment = environment_;
  stage.environmentRotation = glm::radians(preview.environmentRotation);
  stage.environmentIntensity = preview.environmentIntensity;
  append(problems, environmentProblems_);

  comparison = preview.subject == Preview::Subject::Comparison;
  if (comparison) buildComparison(request, stage);
  else buildMesh(request, stage);
  std::erase_if(surfaces_, [&](const auto& item) { return !usedSurfaces_.count(item.first); });

  if (request.wantCode) {
    const ModelPtr own = model(request, request.material->model, request.material->modelPlace());
    if (own && (codeRevision_ != request.materialRevision || codeModel_ != own->hash || code.empty())) {
      codeRevision_ = request.materialRevision;
      codeModel_ = own->hash;
      auto compiled = compileMaterial(*request.material, *own, nodes_, functions_, {.valuesAsUniforms = false, .namedFiles = namedFiles_});
      if (compiled) {
        code = compiled->glsl;
        stats = compiled->stats;
      }
    }
  }
}

ModelPtr PreviewScene::model(const FrameRequest& request, const std::string& id, const std::string& place) {
  if (const auto found = request.named.find(id); found != request.named.end()) return found->second;
  std::vector<std::string> known;
  for (const ModelPtr& one : request.models) {
    if (one->id == id) return one;
    known.push_back(one->id);
  }
  append(problems, {error(place, "unknown shading model '" + id + "'", suggestion(id, known))});
  return nullptr;
}

const SurfaceMaterial* PreviewScene::surface(const std::string& slot, const MaterialPtr& material, uint64_t revision,
                                             const ModelPtr& model, const std::vector<Setting>& settings, State& state) {
  usedSurfaces_.insert(slot);
  Surface& kept = surfaces_[slot];
  std::vector<std::pair<std::string, std::string>> given;
  for (const Setting& setting : settings) given.emplace_back(setting.name, setting.text);
  if (kept.revision != revision || kept.modelHash != model->hash || kept.settings != given) {
    kept.revision = revision;
    kept.modelHash = model->hash;
    kept.settings = given;
    kept.problems.clear();
    kept.fault.clear();
    std::vector<Setting> taken;
    for (const Setting& setting : settings)
      if (takesSetting(*material, *model, setting.name)) taken.push_back(setting);
    CompileOptions options{.valuesAsUniforms = true, .namedFiles = {}};
    if (material == edited_) options.namedFiles = namedFiles_;
    auto made = surfaceWith(*material, model, taken, "sweep", {nodes_, functions_, textures_, options}, kept.problems);
    // A material need not suit the models that it is compared on: what it has too much for them is no fault of it.
    if (model->id != material->model) std::erase_if(kept.problems, [](const Diagnostic& d) { return d.severity != Severity::Error; });
    if (made) {
      kept.surface = std::move(*made);
      kept.good = true;
    } else {
      append(kept.problems, made.diagnostics());
      kept.fault = firstFault(made.diagnostics());
      graphOk = false;
    }
  }
  append(problems, kept.problems);
  if (!kept.fault.empty()) state = {kept.good ? State::LastGood : State::NotDrawn, kept.fault};
  return kept.good ? &kept.surface : nullptr;
}

MaterialPtr PreviewScene::material(const std::string& nameOrFile) {
  const auto time = timeOf(nameOrFile);
  auto found = materials_.find(nameOrFile);
  if (found == materials_.end() || found->second.time != time) {
    Loaded loaded{.time = time};
    if (found != materials_.end()) loaded.material = found->second.material;
    auto read = loadMaterial(nameOrFile, nodes_, &loaded.problems);
    if (read) loaded.material = std::make_shared<const Material>(std::move(*read));
    else append(loaded.problems, read.diagnostics());
    found = materials_.insert_or_assign(nameOrFile, std::move(loaded)).first;
  }
  append(problems, found->second.problems);
  return found->second.material;
}

void PreviewScene::loadEnvironmentOf(const Preview& preview) {
  const auto time = timeOf(preview.environment);
  if (environmentName_ == preview.environment && environmentTime_ == time) return;
  environmentName_ = preview.environment;
  environmentTime_ = time;
  environmentProblems_.clear();
  auto loaded = loadEnvironment(preview.environment, &environmentProblems_);
  if (loaded) environment_ = *loaded;
  else append(environmentProblems_, loaded.diagnostics());
}

void PreviewScene::buildComparison(const FrameRequest& request, const Scene& stage) {
  const Preview& preview = request.preview;
  MeshPtr& sphere = shapes_["sphere"];
  if (!sphere) sphere = sphereMesh();

  struct Column {
    ColumnName title;
    MaterialPtr material;
    uint64_t revision;
    std::vector<Setting> settings;
    std::string slot;
  };
  std::vector<Column> columns;
  if (preview.columns == Preview::Columns::Sweep) {
    const Sweep sweep{preview.sweepName, preview.sweepFrom, preview.sweepTo, std::clamp(preview.sweepCount, 1, 16)};
    for (int i = 0; i < sweep.count; ++i)
      columns.push_back({{sweep.name + " " + sweep.title(i), ""}, request.material, request.materialRevision,
                         {{sweep.name, fmt::format("{}", sweep.value(i))}}, kSweep + std::to_string(i)});
  } else {
    columns.push_back({{request.material->name, "edited"}, request.material, request.materialRevision, {}, kEdited});
    for (const std::string& name : preview.materials) {
      const MaterialPtr loaded = material(name);
      if (!loaded) {
        columns.push_back({{fs::path(name).stem().string(), fs::path(name).filename().string()}, nullptr, 0, {}, name});
        continue;
      }
      // Its revision is its identity: a changed file is another object.
      columns.push_back({{loaded->name, name == loaded->name ? "library" : fs::path(name).filename().string()}, loaded, reinterpret_cast<uintptr_t>(loaded.get()), {}, "file " + name});
    }
  }
  // The material as it is, whichever models it is compared in.
  std::vector<std::string> texts = preview.models;
  if (std::find(texts.begin(), texts.end(), request.material->model) == texts.end()) texts.push_back(request.material->model);
  if (preview.columns == Preview::Columns::Sweep) {
    const bool any = std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
      const auto one = request.named.find(modelRow(text).id);
      return one != request.named.end() && takesSetting(*request.material, *one->second, preview.sweepName);
    });
    if (!any)
      append(problems, {error("sweep", "no cell has a parameter '" + preview.sweepName + "'",
                              "choose an attribute, or a parameter of the material or of a model")});
  }

  Comparison made;
  made.camera = preview.comparisonOrbit.camera(1);
  std::vector<ColumnName> names;
  for (const Column& column : columns) names.push_back(column.title);
  made.columnTitles = distinctTitles(names);
  for (const std::string& text : texts) {
    const ModelRow row = modelRow(text);
    const ModelPtr shading = model(request, row.id, text == request.material->model ? request.material->modelPlace() : "comparison");
    if (text == request.material->model) ownRow = made.rows();
    made.rowTitles.push_back(shading ? shading->title : row.id);
    rows.push_back({text, shading, row.note()});
    for (const Column& column : columns) {
      Scene cell = stage;
      State& state = states.emplace_back();
      std::vector<Setting> settings = row.parameters;
      settings.insert(settings.end(), column.settings.begin(), column.settings.end());
      const SurfaceMaterial* drawn = nullptr;
      if (!shading) state = {State::NotDrawn, "unknown shading model '" + row.id + "'"};
      else if (!column.material) state = {State::NotDrawn, firstFault(materials_[column.slot].problems)};
      else drawn = surface(column.slot + " on " + text, column.material, column.revision, shading, settings, state);
      if (drawn) {
        cell.materials.push_back(*drawn);
        cell.instances.push_back({sphere, glm::mat4(1), 0});
      }
      made.scenes.push_back(std::move(cell));
    }
  }
  cells = std::move(made);
  center = glm::vec3(0);
  radius = 1;
  subject = "comparison";
}

void PreviewScene::buildMesh(const FrameRequest& request, const Scene& stage) {
  const Preview& preview = request.preview;
  Scene built = stage;
  if (MeshPtr& shape = shapes_[preview.mesh]; shape || (shape = shapeMesh(preview.mesh))) {
    built.instances.push_back({shape, glm::mat4(1), 0});
  } else {
    shapes_.erase(preview.mesh);
    const auto time = timeOf(preview.mesh);
    if (gltfName_ != preview.mesh || gltfTime_ != time) {
      gltfName_ = preview.mesh;
      gltfTime_ = time;
      gltfProblems_.clear();
      auto read = loadMesh(preview.mesh, "mesh", textures_, gltfProblems_);
      if (read) {
        gltf_ = std::move(*read);
        std::erase_if(surfaces_, [](const auto& item) { return item.first.starts_with("mesh "); });
      } else {
        append(gltfProblems_, read.diagnostics());
      }
    }
    append(problems, gltfProblems_);
    if (gltf_) {
      built.instances = gltf_->instances;
      meshMaterials = gltf_->materials;
    }
  }
  const bool own = preview.ownMaterials && !meshMaterials.empty();
  // The worst of what its materials are is what the picture is.
  State& whole = states.emplace_back();
  const auto draw = [&](const std::string& slot, const MaterialPtr& material, uint64_t revision) {
    State state;
    const SurfaceMaterial* drawn = nullptr;
    if (const ModelPtr shading = model(request, material->model, material->modelPlace())) drawn = surface(slot, material, revision, shading, {}, state);
    else state = {State::NotDrawn, "unknown shading model '" + material->model + "'"};
    if (state.kind > whole.kind) whole = state;
    return drawn;
  };
  for (size_t i = 0; own && i < meshMaterials.size(); ++i) {
    const bool edited = static_cast<int>(i) == preview.editedSlot;
    const MaterialPtr& material = edited ? request.material : meshMaterials[i];
    const uint64_t revision = edited ? request.materialRevision : reinterpret_cast<uintptr_t>(material.get());
    const SurfaceMaterial* drawn = draw(edited ? kEdited : "mesh " + std::to_string(i), material, revision);
    built.materials.push_back(drawn ? *drawn : SurfaceMaterial{});
    if (!drawn) built.instances.clear();
    if (i < gltf_->doubleSided.size()) built.materials.back().doubleSided = gltf_->doubleSided[i];
    if (i < gltf_->opacityCutoff.size()) built.materials.back().opacityCutoff = gltf_->opacityCutoff[i];
  }
  if (!own) {
    for (Instance& instance : built.instances) instance.material = 0;
    const SurfaceMaterial* drawn = draw(kEdited, request.material, request.materialRevision);
    if (drawn) built.materials.push_back(*drawn);
    else built.instances.clear();
  }
  if (built.instances.empty()) built.materials.clear();
  boundsOf(built, center, radius);
  if (preview.ground != Ground::None && !built.instances.empty()) addGround(built, preview.ground, model(request, newMaterial("ground").model, "ground"));
  scene = std::move(built);
  subject = preview.mesh;
}

}  // namespace glint
