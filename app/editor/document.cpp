#include "app/editor/document.h"

#include <algorithm>

#include "app/material_files.h"
#include "materials/base/files.h"
#include "materials/material_json.h"

namespace glint {

Document::Document(const NodeRegistry& nodes, const std::filesystem::path& folder)
    : nodes_(nodes), graph_(std::make_unique<GraphEditor>()), journal_(folder.empty() ? folder : folder / "journal"),
      scenes_(folder.empty() ? folder : folder / "scenes") {
  savedPreview_ = preview_;
}

Document::~Document() { leave(); }

Diagnostics Document::edit(const std::string& label, const std::function<Diagnostics(GraphEditor&)>& change) {
  if (held_ && !gesture_) {
    gesture_ = true;
    gestureLabel_ = label;
    gesturePreview_ = preview_;
  }
  if (gesture_ && !graph_->inGesture()) graph_->beginGesture(gestureLabel_);
  Diagnostics refused = change(*graph_);
  if (!gesture_) syncSteps(label);
  return refused;
}

void Document::setPreview(const std::string& label, Preview preview) {
  if (preview_.sameSettings(preview)) {
    preview_ = std::move(preview);
    ++previewRevision_;
    return;
  }
  if (held_ && !gesture_) {
    gesture_ = true;
    gestureLabel_ = label;
    gesturePreview_ = preview_;
  }
  Preview before = std::exchange(preview_, std::move(preview));
  ++previewRevision_;
  if (gesture_) previewTouched_ = true;
  else addStep({.label = label, .ofGraph = false, .before = std::move(before), .after = preview_});
}

void Document::setOrbit(const Orbit& orbit) {
  Orbit& now = preview_.subject == Preview::Subject::Mesh ? preview_.orbit : preview_.comparisonOrbit;
  if (now == orbit) return;
  now = orbit;
  ++previewRevision_;
}

void Document::hold(bool held) {
  held_ = held;
  if (held || !gesture_) return;
  gesture_ = false;
  if (graph_->inGesture()) graph_->endGesture();
  syncSteps(gestureLabel_);
  if (std::exchange(previewTouched_, false) && !gesturePreview_.sameSettings(preview_))
    addStep({.label = gestureLabel_, .ofGraph = false, .before = gesturePreview_, .after = preview_});
}

void Document::syncSteps(const std::string& label) {
  const size_t now = graph_->position();
  for (size_t i = graphPosition_; i < now; ++i) {
    const std::string& given = graph_->history()[i].label;
    addStep({.label = given.empty() ? label : given, .ofGraph = true});
  }
  graphPosition_ = now;
}

void Document::addStep(Step step) {
  steps_.resize(position_);
  steps_.push_back(std::move(step));
  ++position_;
  record();
}

void Document::undo() {
  if (!canUndo()) return;
  const Step& step = steps_[--position_];
  if (step.ofGraph) {
    graph_->undo();
    graphPosition_ = graph_->position();
  } else {
    Preview before = step.before;
    before.orbit = preview_.orbit;
    before.comparisonOrbit = preview_.comparisonOrbit;
    preview_ = std::move(before);
    ++previewRevision_;
  }
  record();
}

void Document::redo() {
  if (!canRedo()) return;
  const Step& step = steps_[position_++];
  if (step.ofGraph) {
    graph_->redo();
    graphPosition_ = graph_->position();
  } else {
    Preview after = step.after;
    after.orbit = preview_.orbit;
    after.comparisonOrbit = preview_.comparisonOrbit;
    preview_ = std::move(after);
    ++previewRevision_;
  }
  record();
}

void Document::goTo(size_t position) {
  position = std::min(position, steps_.size());
  while (position_ > position && canUndo()) undo();
  while (position_ < position && canRedo()) redo();
}

void Document::keepScene() {
  if (file_.empty() || project_) return;
  keptPreview_ = preview_;
  note(scenes_.write(file_, preview_));
}

void Document::leave() {
  const bool kept = keptPreview_ && keptPreview_->sameSettings(preview_) && keptPreview_->orbit == preview_.orbit &&
                    keptPreview_->comparisonOrbit == preview_.comparisonOrbit;
  if (!kept) keepScene();
}

void Document::record() {
  if (!keptPreview_ || !keptPreview_->sameSettings(preview_)) keepScene();
  if (!modified()) return journal_.clear();
  std::vector<std::string> named;
  for (const auto& file : named_) named.push_back(file.string());
  note(journal_.append({.file = file_.string(), .name = material().name,
                   .label = position_ ? steps_[position_ - 1].label : "", .steps = int(position_),
                   .material = materialText(material()), .preview = writeJson(previewJson(preview_)),
                   .named = std::move(named)}));
}

void Document::note(const Diagnostics& problems) {
  for (const Diagnostic& d : problems)
    if (std::find(problems_.begin(), problems_.end(), d) == problems_.end()) problems_.push_back(d);
}

bool Document::modified() const {
  return graph_->modified() || !savedMaterialKnown_ || ((project_ || file_.empty()) && !savedPreview_.sameSettings(preview_));
}

std::string Document::name() const {
  return file_.empty() ? material().name + " (unsaved)" : file_.filename().string();
}

std::string Document::title() const { return modified() ? name() + " *" : name(); }

void Document::reset(Material material, const Preview& preview, const std::filesystem::path& file, bool project) {
  leave();
  ++identity_;
  graphBase_ += graph_->revision() + 1;
  graph_ = std::make_unique<GraphEditor>(std::move(material));
  preview_ = preview;
  savedPreview_ = preview;
  ++previewRevision_;
  steps_.clear();
  position_ = graphPosition_ = 0;
  gesture_ = previewTouched_ = false;
  savedMaterialKnown_ = true;
  file_ = file;
  project_ = project;
  keptPreview_.reset();
  problems_.clear();
  saveProblems_.clear();
  named_.clear();
  journal_.clear();
}

void Document::startNew(Material material, const Preview& preview) { reset(std::move(material), preview, {}, false); }

std::filesystem::path Document::nameFile(const std::filesystem::path& path) {
  std::error_code ignored;
  return *named_.insert(std::filesystem::absolute(path, ignored).lexically_normal()).first;
}

Diagnostics Document::open(const std::filesystem::path& path, Diagnostics& warnings) {
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::absolute(path, ignored);
  auto bytes = readFile(file, kLargestMaterialFile);
  if (!bytes) return bytes.diagnostics();
  const auto json = parseJson(bytes.value(), path.string());
  if (!json) return json.diagnostics();
  const Json* kind = json->find("glint");
  if (!kind || kind->text != "project") {
    auto material = parseMaterial(bytes.value(), file, nodes_, &warnings);
    if (!material) return material.diagnostics();
    material->file = file;
    leave();  // the same file may be opened again
    Diagnostics damage;
    const auto kept = scenes_.read(file, damage);
    reset(std::move(*material), kept.value_or(preview_), file, false);
    keptPreview_ = kept;
    note(damage);
    return {};
  }
  const Json *inner = json->find("material"), *preview = json->find("preview");
  if (!inner || !inner->isObject()) return {error(path.string(), "a project needs its 'material', an object", "open the material's own file")};
  auto material = parseMaterial(writeJson(*inner), file, nodes_, &warnings);
  if (!material) return material.diagnostics();
  material->file = file;
  Preview look = preview ? previewFrom(*preview, path.string(), warnings) : Preview{};
  reset(std::move(*material), look, file, true);
  return {};
}

std::string Document::projectText(const Material& material) const {
  Json json = Json::object();
  json.set("glint", Json::of("project"));
  json.set("version", Json::of(1));
  auto inner = parseJson(materialText(material), "material");
  json.set("material", std::move(*inner));
  json.set("preview", previewJson(preview_));
  return writeJson(json);
}

Diagnostics Document::save() { return saveAs(file_, project_); }

Diagnostics Document::saveAs(const std::filesystem::path& path, bool project) {
  hold(false);
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::absolute(path, ignored);
  saveProblems_ = write(file, project);
  if (!saveProblems_.empty()) return saveProblems_;
  graph_->markSaved(file);
  savedMaterialKnown_ = true;
  savedPreview_ = preview_;
  file_ = file;
  project_ = project;
  keptPreview_.reset();
  leave();
  journal_.clear();
  return {};
}

Diagnostics Document::write(const std::filesystem::path& file, bool project) {
  // A model that is shown has been named as much as one whose material was taken.
  std::set<std::filesystem::path> named = named_;
  if (const std::filesystem::path mesh = preview_.mesh; mesh.is_absolute()) named.insert(mesh.lexically_normal());
  MaterialFiles files(nodes_, std::move(named));
  const auto moved = files.gather(material(), file);
  if (!moved) return moved.diagnostics();
  // What only undo or redo brings back has to be found from the new place as well.
  std::vector<const Node*> past;
  for (const Edit& edit : graph_->history())
    for (const auto& [id, change] : edit.nodes)
      for (const auto* node : {&change.before, &change.after})
        if (*node) past.push_back(&**node);
  files.gatherPast(past);
  Diagnostics problems = writeFileAtomic(file, project ? projectText(*moved) : materialText(*moved));
  if (!problems.empty()) return problems;
  files.keep();
  for (const auto& outside : files.leftOutside()) nameFile(outside);
  if (files.movesAny()) graph_->rewriteNodes([&](Node& node) { files.rewrite(node); });
  return {};
}

Diagnostics Document::recover(const Journal::Record& record) {
  Diagnostics warnings;
  auto material = parseMaterial(record.material, record.file.empty() ? "journal" : record.file, nodes_, &warnings);
  if (!material) return material.diagnostics();
  // The file may have gone; what the journal kept is whole without it.
  const bool based = !record.file.empty() && open(record.file, warnings).empty();
  const auto name = [&] {
    for (const std::string& file : record.named) nameFile(file);
  };
  if (based) {
    material->file = file_;
    name();
    edit("Recover", [&](GraphEditor& graph) { return graph.replaceAll(*material, "Recover"); });
  } else {
    reset(std::move(*material), preview_, {}, false);
    name();
  }
  savedMaterialKnown_ = false;
  if (const auto json = parseJson(record.preview, "journal")) preview_ = previewFrom(*json, "journal", warnings);
  ++previewRevision_;
  this->record();
  return {};
}

}  // namespace glint
