// What is being edited: a material, how it is looked at, and one history over both.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editor/journal.h"
#include "app/editor/preview.h"
#include "app/editor/scene_store.h"
#include "materials/graph_edit.h"
#include "materials/node_registry.h"

namespace glint {

class Document {
 public:
  // Keeps journals and the scenes of materials in folders below `folder`; an empty path keeps none.
  Document(const NodeRegistry&, const std::filesystem::path& folder);
  ~Document();               // leaves: see leave()

  const Material& material() const { return graph_->material(); }
  const GraphEditor& graph() const { return *graph_; }
  const Preview& preview() const { return preview_; }

  // Edits. While something is held (a mouse button, a widget), they become one step, named `label`; otherwise each is
  // a step of its own. A refusal comes back as diagnostics, is kept as refusal(), and changes nothing.
  Diagnostics edit(const std::string& label, const std::function<Diagnostics(GraphEditor&)>&);
  void setPreview(const std::string& label, Preview);
  // Looking around is no step.
  void setOrbit(const Orbit&);

  // Once a frame: whether the user still holds what he edits with. The step ends when nothing is held.
  void hold(bool held);

  bool canUndo() const { return !gesture_ && position_ > 0; }
  bool canRedo() const { return !gesture_ && position_ < steps_.size(); }
  void undo();
  void redo();
  // Steps back or forth until `position` steps are in force.
  void goTo(size_t position);
  struct Step {
    std::string label;
    bool ofGraph = true;
    Preview before, after;   // when not of the graph
  };
  const std::vector<Step>& steps() const { return steps_; }
  size_t position() const { return position_; }

  // Grow with what they name; the render thread and the panels compare them.
  uint64_t meaningRevision() const { return graphBase_ + graph_->meaningRevision(); }
  uint64_t graphRevision() const { return graphBase_ + graph_->revision(); }
  uint64_t previewRevision() const { return previewRevision_; }
  // Another number for each document that was started or opened.
  uint64_t identity() const { return identity_; }

  // Files. A project (any JSON of "glint": "project") is a material and a preview. A plain material's file holds the
  // graph only: its preview is kept beside the session with every step, so it needs no saving and no question. What has
  // no file yet has nowhere to keep it, and counts as modified by it.
  bool modified() const;
  const std::filesystem::path& file() const { return file_; }   // empty when never saved
  bool isProject() const { return project_; }
  std::string name() const;                                      // "aluminium.json"
  std::string title() const;                                     // the same, with a star when modified
  void startNew(Material, const Preview&);                       // unsaved
  // Files that the user chose or dropped, and models whose material he took: the material may use them wherever they
  // lie, until saving takes them along. To be told before the edit that brings them in, which spells them as this
  // gives them back.
  std::filesystem::path nameFile(const std::filesystem::path&);
  const std::set<std::filesystem::path>& namedFiles() const { return named_; }
  Diagnostics open(const std::filesystem::path&, Diagnostics& warnings);
  // To file(). The pictures and functions that the material uses go along (app/material_files.h), and the document goes
  // on with them, in all its history. When anything fails, nothing is written and nothing changes; see saveProblems().
  Diagnostics save();
  Diagnostics saveAs(const std::filesystem::path&, bool project);
  const Diagnostics& saveProblems() const { return saveProblems_; }   // of the last save, while it failed
  // Keeps where the viewer stood, which is no step; to be called before the document is let go.
  void leave();
  // Replaces the material by what a journal kept, as one undoable step on top of the file it belongs to.
  Diagnostics recover(const Journal::Record&);

  Journal& journal() { return journal_; }
  // What could not be kept beside the file, or read back.
  const Diagnostics& problems() const { return problems_; }

 private:
  void syncSteps(const std::string& label);
  void addStep(Step);
  void record();
  void keepScene();
  void note(const Diagnostics&);
  void reset(Material, const Preview&, const std::filesystem::path& file, bool project);
  Diagnostics write(const std::filesystem::path& file, bool project);
  std::string projectText(const Material&) const;

  const NodeRegistry& nodes_;
  std::unique_ptr<GraphEditor> graph_;
  Preview preview_;
  std::vector<Step> steps_;
  size_t position_ = 0;
  size_t graphPosition_ = 0;    // of graph_ when it was last looked at
  bool held_ = false, gesture_ = false;
  std::string gestureLabel_;
  Preview gesturePreview_;
  bool previewTouched_ = false;
  Preview savedPreview_;
  bool savedMaterialKnown_ = true;   // false after recovery, so that it counts as modified
  uint64_t graphBase_ = 0, previewRevision_ = 1, identity_ = 1;
  std::filesystem::path file_;
  bool project_ = false;
  Journal journal_;
  SceneStore scenes_;
  Diagnostics problems_, saveProblems_;
  std::set<std::filesystem::path> named_;
  std::optional<Preview> keptPreview_;   // as it is kept for file_
};

}  // namespace glint
