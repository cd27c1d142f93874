#include "app/editor/editor.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/keys.h"
#include "app/editor/light_handles.h"
#include "app/editor/model_row.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"
#include "materials/base/files.h"
#include "materials/material_json.h"
#include "materials/material_library.h"
#include "materials/model_file.h"
#include "renderer/environment.h"
#include "renderer/gl/gl.h"
#include "renderer/mesh.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string extensionOf(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

std::vector<fs::path> modelFolders(const EditorOptions& options) {
  std::vector<fs::path> folders = options.modelFolders;
  if (!options.configFolder.empty()) folders.push_back(options.configFolder / "models");
  return folders;
}

}  // namespace

Editor::Editor(gl::Context& context, EditorOptions options) : context_(context), options_(std::move(options)) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the layout is ours to remember
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  setUpKeyMap();
  renderer_ = std::make_unique<ImGuiRenderer>();
  models_ = std::make_unique<ModelRegistry>(modelFolders(options_), options_.modelFiles);
  terms_ = glint::terms();
  const bool remembers = !options_.configFolder.empty();
  document_ = std::make_unique<Document>(nodes_, options_.configFolder);
  for (const PanelInfo& info : panelTable()) panels_.push_back(info.make());
  if (remembers) {
    session_ = Session::read(options_.configFolder / "editor.json");
    offerRecovery(false);
  }
  restoreSession();
  loadStandard();
  const auto wake = [this] {
    if (options_.wake) options_.wake();
  };
  render_ = std::make_unique<RenderThread>(std::move(*context_.createShared()), nodes_, functions_, wake);
  health_ = std::make_unique<HealthWorker>(std::move(*context_.createShared()), [this] { return render_->working(); }, wake);
  environmentThumbnails_ = std::make_unique<EnvironmentThumbnails>(wake);
}

Editor::~Editor() {
  storeSession();
  environmentThumbnails_.reset();
  health_.reset();
  render_.reset();
  context_.makeCurrent();
  panels_.clear();
  renderer_.reset();
  ImGui::DestroyContext();
}

void Editor::restoreSession() {
  std::vector<std::string> known;
  for (const PanelInfo& info : panelTable()) known.emplace_back(info.title);
  if (session_.layout.isObject()) layout_.fromJson(session_.layout, known);
  if (!session_.folder.empty()) files_.setFolder(session_.folder);
}

void Editor::storeSession() {
  if (options_.configFolder.empty()) return;
  session_.layout = layout_.toJson();
  session_.folder = files_.folder().string();
  session_.write(options_.configFolder / "editor.json");
}

void Editor::loadStandard() {
  const auto names = libraryMaterialNames();
  const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  Preview preview;
  Material material = newMaterial("material");
  const char* first = has("painted-metal") ? "painted-metal" : "aluminium";
  if (has(first))
    if (auto loaded = loadMaterial(first, nodes_)) material = std::move(*loaded);
  material.file.clear();
  std::erase_if(preview.materials, [&](const std::string& name) { return !has(name.c_str()); });
  if (std::string_view(first) != "aluminium" && has("aluminium"))
    preview.materials.insert(preview.materials.begin(), "aluminium");
  std::erase_if(preview.models, [&](const std::string& row) { return !models_->find(modelRow(row).id); });
  document_->startNew(std::move(material), preview);
}

GraphContext Editor::graphContext() const {
  const ModelPtr model = models_->find(document_->material().model);
  return {nodes_, model.get(), &functions_};
}

void Editor::setScale(float scale) { options_.scale = scale; }

bool Editor::hasNews() {
  checkModels();
  const auto progress = render_->progress();
  const std::string text = progress ? progress->what + std::to_string(int(progress->fraction * 100)) : "";
  bool news = std::exchange(modelsChanged_, false) || render_->hasFinished();
  news |= health_->takeNews();
  news |= environmentThumbnails_->takeNews();
  // Not with every step: on software GL each frame of the window takes its time from the work it reports on.
  constexpr auto kLook = std::chrono::milliseconds(200);
  if (const auto now = std::chrono::steady_clock::now(); text != progressShown_ && (text.empty() || now - progressAt_ > kLook)) {
    news = true;
    progressShown_ = text;
    progressAt_ = now;
  }
  // A message that has had its time.
  if (!message_.empty() && !messageWrong_ && time_ > messageUntil_) news = true;
  return news;
}

void Editor::frame(glm::ivec2 framebuffer, float deltaSeconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {float(framebuffer.x), float(framebuffer.y)};
  io.DisplayFramebufferScale = {1, 1};
  io.DeltaTime = std::max(deltaSeconds, 1e-4f);
  time_ += io.DeltaTime;
  if (fonts_.build(options_.scale)) {
    theme::apply(fonts_.scale());
    renderer_->uploadFonts();
  }
  checkModels();
  render_->takePlot();
  if (render_->take() && shown().subject != framedSubject_) {
    framedSubject_ = shown().subject;
    if (shown().subject != "comparison") frameSubject();
  }
  if (!adoptMesh_.empty() && shown().subject == adoptMesh_) {
    adoptMesh_.clear();
    takeMeshMaterial(0);
  }
  ImGui::NewFrame();
  ui::beginFrame(fonts_);
  const bool held = ImGui::IsAnyMouseDown() || ImGui::IsAnyItemActive() || std::exchange(editing_, false);
  document_->hold(held);
  // What is selected may be gone after undo.
  std::erase_if(selection_, [&](const NodeId& id) { return !document_->material().node(id); });
  if (std::exchange(lightsOf_, document_->identity()) != document_->identity() || selectedLight_ >= int(document_->preview().lights.size())) selectedLight_ = -1;
  wantCode_ = false;
  collectProblems();
  handleShortcuts();

  drawMenu();
  const float top = ImGui::GetFrameHeight(), bottom = theme::px(24);
  layout_.draw({0, top}, {io.DisplaySize.x, io.DisplaySize.y - bottom}, [this](const std::string& title) {
    const auto table = panelTable();
    for (size_t i = 0; i < table.size(); ++i)
      if (title == table[i].title) panels_[i]->draw(*this);
  });
  drawStatus({0, io.DisplaySize.y - bottom}, io.DisplaySize);
  drawDialogs();
  postRequest();

  ImGui::Render();
  glClearColor(17 / 255.0f, 17 / 255.0f, 17 / 255.0f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  renderer_->draw(*ImGui::GetDrawData());
  if (!held && layout_.takeChanged()) storeSession();
}

void Editor::postRequest() {
  if (viewportSize_.x < 8 || viewportSize_.y < 8) return;
  const bool held = ImGui::IsAnyMouseDown() || editing_;
  Posted now{.meaning = document_->meaningRevision(), .preview = document_->previewRevision(), .models = modelsRevision_,
             .size = viewportSize_, .dragging = posted_.dragging, .code = wantCode_};
  if (now == posted_ && !(posted_.dragging && !held)) return;
  now.dragging = held;
  if (!postedMaterial_ || posted_.meaning != now.meaning) {
    postedMaterial_ = std::make_shared<const Material>(document_->material());
    ++materialRevision_;
  }
  posted_ = now;
  std::map<std::string, ModelPtr> named;
  const auto ask = [&](const std::string& id) {
    if (ModelPtr found = models_->find(id)) named[id] = std::move(found);
  };
  for (const std::string& row : document_->preview().models) ask(modelRow(row).id);
  ask(document_->material().model);
  wantHealth();
  render_->post({.serial = ++serial_, .material = postedMaterial_, .document = document_->identity(), .materialRevision = materialRevision_,
                 .preview = document_->preview(), .namedFiles = document_->namedFiles(),
                 .models = models_->all(), .named = std::move(named), .modelsRevision = modelsRevision_,
                 .size = viewportSize_, .scale = theme::scale(), .dragging = held, .wantCode = wantCode_});
}

void Editor::collectProblems() {
  problems_.clear();
  const auto add = [&](const Diagnostics& more) {
    for (const Diagnostic& d : more)
      if (std::find(problems_.begin(), problems_.end(), d) == problems_.end()) problems_.push_back(d);
  };
  add(models_->problems());
  add(nodes_.problems());
  add(document_->problems());
  add(document_->saveProblems());
  add(recoveryProblems_);
  add(shown().modelProblems);
  add(shown().problems);
  std::stable_sort(problems_.begin(), problems_.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.severity < b.severity; });
  layout_.setBadge("Problems", problems_.empty() ? "" : std::to_string(problems_.size()));
}

void Editor::say(const std::string& text, bool wrong) {
  message_ = text;
  messageWrong_ = wrong;
  messageUntil_ = time_ + (wrong ? 1e9 : 6);
}

void Editor::refused(const Diagnostics& why) {
  if (!why.empty()) say(why.front().what + (why.front().hint.empty() ? "" : "; " + why.front().hint), true);
}

void Editor::frameSubject() {
  const Preview& preview = document_->preview();
  if (preview.subject == Preview::Subject::Comparison) return document_->setOrbit(Preview{}.comparisonOrbit);
  Orbit orbit = preview.orbit;
  orbit.target = shown().center;
  orbit.distance = shown().radius / std::sin(glm::radians(orbit.fov) / 2) * 1.02f;
  document_->setOrbit(orbit);
}

void Editor::frameLights() {
  if (document_->preview().subject != Preview::Subject::Mesh) return;
  frameSubject();
  Orbit orbit = document_->preview().orbit;
  orbit.distance = distanceToSee(document_->preview().lights, orbit.camera(shown().radius), glm::max(glm::vec2(viewportSize_), glm::vec2(8)), orbit.distance);
  document_->setOrbit(orbit);
}

void Editor::selectLight(int index, bool reveal) {
  selectedLight_ = index;
  revealLight_ = reveal && index >= 0;
  if (revealLight_ && layout_.shown("Scene") && !layout_.visible("Scene")) layout_.show("Scene");
}

void Editor::showLights(bool on) {
  session_.lightGizmos = on;
  storeSession();
}

void Editor::openFile(const fs::path& file) {
  const std::string extension = extensionOf(file);
  const std::string name = file.filename().string();
  std::error_code ignored;
  const std::string whole = fs::absolute(file, ignored).string();
  if (extension == ".json") {
    afterAsking([this, file] { openDocumentFile(file); });
  } else if (extension == ".glb" || extension == ".gltf") {
    Preview preview = document_->preview();
    preview.subject = Preview::Subject::Mesh;
    preview.mesh = whole;
    preview.ownMaterials = true;
    preview.editedSlot = -1;
    // Who opens a mesh before anything else comes to edit its material.
    adoptMesh_ = document_->file().empty() && document_->steps().empty() ? whole : std::string();
    document_->setPreview("Show " + name, preview);
    layout_.show("Viewport");
  } else if (extension == ".hdr" || extension == ".exr" || extension == ".pfm") {
    Preview preview = document_->preview();
    preview.environment = whole;
    document_->setPreview("Environment " + name, preview);
  } else if (extension == ".png" || extension == ".jpg" || extension == ".jpeg") {
    addTexture(whole, std::nullopt);
  } else if (isModelFile("a" + extension)) {
    installModel(file);
  } else {
    say(name + ": not a kind of file that Glint opens; it takes .json, .glb, .gltf, .hdr, .exr, .png, .jpg, .glsl and .brdf", true);
  }
}

void Editor::openFiles(std::vector<fs::path> files) {
  std::stable_partition(files.begin(), files.end(), [](const fs::path& file) { return extensionOf(file) == ".json"; });
  for (const fs::path& file : files) openFile(file);
}

void Editor::openDocumentFile(const fs::path& file) {
  Diagnostics warnings;
  const Diagnostics problems = document_->open(file, warnings);
  if (!problems.empty()) return say(problems.front().text(), true);
  selection_.clear();
  session_.addRecent(file);
  storeSession();
  say(warnings.empty() ? "Opened " + file.filename().string() : warnings.front().text(), !warnings.empty());
}

void Editor::addTexture(const fs::path& file, std::optional<Position> at) {
  const Material& material = document_->material();
  Position where = at.value_or(Position{-420, 0});
  if (!at) {
    // The free place nearest to the left of the output; sizes are the canvas's to know, so about those of a node.
    constexpr float kWidth = 220, kHeight = 190, kOutputHeight = 380, kStep = 24;
    const NodeId output = material.outputNode();
    if (const auto found = material.layout.find(output); found != material.layout.end()) where = {found->second.x - 260, found->second.y};
    const auto covered = [&](Position p) {
      return std::any_of(material.layout.begin(), material.layout.end(), [&](const auto& item) {
        const float below = p.y - item.second.y;
        return std::abs(item.second.x - p.x) < kWidth && below > -kHeight && below < (item.first == output ? kOutputHeight : kHeight);
      });
    };
    Position best = where;
    float nearest = FLT_MAX;
    for (int x = -20; x <= 10; ++x)
      for (int y = -40; y <= 40; ++y) {
        const Position place{where.x + float(x) * kStep, where.y + float(y) * kStep};
        const float distance = std::hypot(float(x), float(y));
        if (distance >= nearest || covered(place)) continue;
        nearest = distance;
        best = place;
      }
    where = best;
  }
  NodeId made;
  const std::string named = document_->nameFile(file).string();
  refused(document_->edit("Add texture", [&](GraphEditor& graph) {
    graph.beginGesture("Add texture " + file.filename().string());
    Diagnostics refusal = graph.addNode("texture-sample", where, &made);
    if (refusal.empty()) refusal = graph.setSetting(made, "file", Json::of(named));
    if (refusal.empty()) graph.endGesture();
    else graph.cancelGesture();
    return refusal;
  }));
  if (!made.empty()) {
    selection_ = {made};
    revealed_ = made;
  }
  layout_.show("Graph");
}

void Editor::browse(FileBrowser::Request request) { files_.open(std::move(request)); }

void Editor::browseMesh() {
  browse({.title = "Choose a mesh", .extensions = {".glb", ".gltf"}, .chosen = [this](const fs::path& file) { openFile(file); }});
}

void Editor::browseEnvironment() {
  browse({.title = "Choose an environment", .extensions = {".hdr", ".exr", ".pfm"},
          .chosen = [this](const fs::path& file) { openFile(file); }});
}

void Editor::newDocument() {
  afterAsking([this] {
    document_->startNew(newMaterial("material"), document_->preview());
    selection_.clear();
  });
}

void Editor::openDocument() {
  browse({.title = "Open a material or project", .extensions = {".json"},
          .chosen = [this](const fs::path& file) { openFile(file); }});
}

void Editor::openLibrary(const std::string& name) {
  afterAsking([this, name] {
    auto material = loadMaterial(name, nodes_);
    if (!material) return say(material.diagnostics().front().text(), true);
    material->file.clear();
    document_->startNew(std::move(*material), document_->preview());
    selection_.clear();
  });
}

void Editor::editMeshMaterial(int slot) {
  afterAsking([this, slot] { takeMeshMaterial(slot); });
}

void Editor::takeMeshMaterial(int slot) {
  const auto& own = shown().meshMaterials;
  if (slot < 0 || slot >= static_cast<int>(own.size())) return;
  Material copy = *own[static_cast<size_t>(slot)];
  copy.lines.reset();
  Preview preview = document_->preview();
  preview.ownMaterials = true;
  preview.editedSlot = slot;
  document_->startNew(std::move(copy), preview);
  document_->nameFile(preview.mesh);  // its pictures go along when the material is saved
  selection_.clear();
}

void Editor::save(std::function<void()> then) {
  if (document_->file().empty()) return saveAs(false, std::move(then));
  const Diagnostics problems = document_->save();
  if (!problems.empty()) return say(problems.front().text(), true);
  say("Saved " + document_->file().string());
  if (then) then();
}

void Editor::saveAs(bool project, std::function<void()> then) {
  browse({.title = project ? "Save the project" : "Save the material", .saving = true, .extensions = {".json"},
          .name = document_->material().name + (project ? "-project.json" : ".json"),
          .chosen = [this, project, then = std::move(then)](const fs::path& file) {
            const Diagnostics problems = document_->saveAs(file, project);
            if (!problems.empty()) return say(problems.front().text(), true);
            session_.addRecent(file);
            storeSession();
            say("Saved " + file.string());
            if (then) then();
          }});
}

void Editor::afterAsking(std::function<void()> action) {
  if (!document_->modified()) return action();
  pendingAction_ = std::move(action);
  askOpen_ = true;
}

void Editor::requestQuit() {
  afterAsking([this] {
    document_->journal().clear();
    quitting_ = true;
  });
}

void Editor::offerRecovery(bool asked) {
  if (options_.configFolder.empty()) return;
  recoveryProblems_.clear();
  recoverable_ = Journal::found(options_.configFolder / "journal", recoveryProblems_);
  recoverOpen_ = !recoverable_.empty();
  if (asked && recoverable_.empty()) say("There is no unsaved work to recover");
}

void Editor::recover(const Journal::Record& record) {
  const Diagnostics problems = document_->recover(record);
  if (!problems.empty()) return say(problems.front().text(), true);
  Journal::discard(record.journal);
  selection_.clear();
  say("Recovered " + record.name + ": save it to keep it");
}

std::string Editor::windowTitle() const { return document_->title() + " \u2013 Glint"; }

}  // namespace glint
