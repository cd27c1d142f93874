// What the editor does with shading models: plugins that come and change, rows of the comparison, and mixes.
#include <algorithm>
#include <cstdlib>
#include <map>

#include "app/editor/editor.h"
#include "app/editor/model_row.h"
#include "materials/base/files.h"
#include "materials/graph_compile.h"
#include "materials/model_file.h"

namespace glint {
namespace fs = std::filesystem;

void Editor::checkModels() {
  const auto now = std::chrono::steady_clock::now();
  if (now - lastModelCheck_ < std::chrono::milliseconds(240)) return;
  lastModelCheck_ = now;
  if (!models_->refresh()) return;
  modelsRead();
}

void Editor::modelsRead() {
  ++modelsRevision_;
  modelsChanged_ = true;
  terms_ = glint::terms();
}

// Those that are looked at first, then all others.
void Editor::wantHealth() {
  std::vector<ModelPtr> wanted;
  const auto want = [&](const ModelPtr& model) {
    if (model && std::find(wanted.begin(), wanted.end(), model) == wanted.end()) wanted.push_back(model);
  };
  want(models_->find(document_->material().model));
  for (const std::string& row : document_->preview().models) want(models_->find(modelRow(row).id));
  for (const ModelPtr& model : models_->all()) want(model);
  health_->want(wanted, std::exchange(healthRevision_, modelsRevision_) != modelsRevision_);
}

void Editor::installModel(const fs::path& file) {
  Diagnostics warnings;
  auto model = readModelFile(file, warnings);
  if (!model) return say(model.diagnostics().front().text(), true);
  std::error_code ignored;
  if (const ModelPtr known = models_->find(model->id); known && fs::equivalent(known->file, file, ignored)) {
    addRow(model->id);
    return say("Comparing " + model->id + ", from " + file.string());
  }
  if (options_.configFolder.empty()) return say("this editor has no folder for models; start it with --models-dir", true);
  const fs::path folder = options_.configFolder / "models", target = folder / file.filename();
  std::error_code problem;
  fs::create_directories(folder, problem);
  std::vector<fs::path> files = {file};
  if (!model->sourceFile.empty()) files.insert(files.begin(), model->sourceFile);
  for (const fs::path& source : files) {
    const auto text = readFile(source, kLargestModelFile);
    if (!text) return say(text.diagnostics().front().text(), true);
    const fs::path copy = folder / fs::relative(source, fs::absolute(file, problem).parent_path(), problem);
    fs::create_directories(copy.parent_path(), problem);
    const Diagnostics problems = writeFileAtomic(copy, text.value());
    if (!problems.empty()) return say(problems.front().text(), true);
  }
  if (models_->refresh()) modelsRead();
  addRow(model->id);
  say(warnings.empty() ? "Installed model " + model->id + " to " + target.string() : warnings.front().text(), !warnings.empty());
}

void Editor::addRow(const std::string& row) {
  Preview preview = document_->preview();
  if (std::find(preview.models.begin(), preview.models.end(), row) != preview.models.end()) return;
  preview.models.push_back(row);
  document_->setPreview("Compare " + row, preview);
}

void Editor::removeRow(const std::string& row) {
  Preview preview = document_->preview();
  std::erase(preview.models, row);
  document_->setPreview("Leave out " + row, preview);
}

void Editor::changeRow(const std::string& row, const std::string& to) {
  Preview preview = document_->preview();
  const auto at = std::find(preview.models.begin(), preview.models.end(), row);
  if (at == preview.models.end() || row == to) return;
  // Two equal rows compare nothing.
  if (std::find(preview.models.begin(), preview.models.end(), to) != preview.models.end()) preview.models.erase(at);
  else *at = to;
  document_->setPreview("Compare " + to, preview);
}

void Editor::useModel(const std::string& id) {
  refused(document_->edit("Model " + id, [&](GraphEditor& graph) { return graph.setModel(id); }));
}

void Editor::saveMix(const ModelMix& mix, std::optional<std::string> row) {
  savedMix_ = mix;
  savedRow_ = std::move(row);
  // With the values that its parameters have: in the material, or on the row.
  std::map<std::string, float> values;
  const Material& material = document_->material();
  const ModelPtr model = models_->find(mix.id());
  if (savedRow_) {
    for (const Setting& setting : modelRow(*savedRow_).parameters) values[setting.name] = std::strtof(setting.text.c_str(), nullptr);
  } else if (model && material.model == mix.id()) {
    if (const auto compiled = compileMaterial(material, *model, nodes_, functions_)) {
      const std::vector<Value> now = compiled->modelParameterValues();
      for (size_t i = 0; i < now.size(); ++i)
        if (!compiled->modelParameters[i].varies) values[compiled->modelParameters[i].name] = now[i].v[0];
    }
  }
  pluginSaver_.open(mix, values, *models_);
}

void Editor::drawPluginSaver() {
  const auto id = pluginSaver_.draw(*models_);
  if (!id) return;
  if (models_->refresh()) modelsRead();
  const ModelPtr saved = models_->find(*id);
  if (!saved) return;
  if (savedRow_) {
    ModelRow row = modelRow(*savedRow_);
    row.id = *id;
    changeRow(*savedRow_, row.text());
  } else if (document_->material().model == savedMix_.id()) {
    useModel(*id);
  }
  say("Saved " + *id + " to " + saved->file.string());
}

}  // namespace glint
