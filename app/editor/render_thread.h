// Draws the preview on a thread and a context of its own, so that the window never waits for a compile, a load or a
// frame. The latest request wins; the last good picture stays until the next is whole.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/analysis/plot_data.h"
#include "app/editor/preview_scene.h"
#include "app/editor/scene_depth.h"
#include "renderer/gl/objects.h"

namespace glint {

// A finished picture and what was found while making it.
struct FrameResult {
  uint64_t serial = 0;              // of its request; 0: nothing yet
  unsigned texture = 0;             // row 0 at the bottom; display-referred
  glm::ivec2 size{0};
  bool comparison = false;
  ComparisonLayout layout;          // in pixels of the request's size
  glm::ivec2 layoutSize{0};
  std::vector<std::string> rowTitles, columnTitles;
  std::vector<RowInfo> rows;        // PreviewScene::rows
  int ownRow = -1;                  // PreviewScene::ownRow
  std::vector<Renderer::FurnaceShare> furnace;   // of each view, when that is what is shown
  std::vector<ReferenceError> errors;            // likewise
  int reference = 0;                // samples of a reference in the picture so far, and in the end
  int referenceInAll = 0;
  std::vector<PreviewScene::State> states;
  glm::vec3 center{0};
  float radius = 1;
  Camera camera;                    // of a mesh, and where its surfaces are; of a comparison there is no depth
  std::shared_ptr<const SceneDepth> depth;
  std::string subject;
  Diagnostics problems;
  Diagnostics modelProblems;        // what a compiler says of the models, drawn or not, as far as they were looked at
  bool graphOk = true;
  std::vector<MaterialPtr> meshMaterials;
  std::string code;
  CompileStats stats;
  Renderer::Statistics statistics;
  int samples = 0;                  // averaged so far
  bool coarse = false;              // a first picture: the tables of a model or an environment are still being made
  double milliseconds = 0;          // from the request's start to the picture
};

// Curves of models, for the analysis panel.
struct PlotRequest {
  uint64_t serial = 0;
  PlotSettings settings;
  std::vector<PlotSubject> subjects;
  bool dragging = false;            // coarse values now are better than fine ones late
};
struct PlotResult {
  uint64_t serial = 0;              // of its request
  PlotData data;
  double milliseconds = 0;          // that computing it took
};

class RenderThread {
 public:
  // `shared` shares objects with the window's context and is not current anywhere. `wake` is called from the thread
  // when there is something new to show.
  RenderThread(std::unique_ptr<gl::Context> shared, const NodeRegistry&, const FunctionLibrary&,
               std::function<void()> wake);
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;

  void post(FrameRequest);

  // On the window's thread: takes the newest picture; true when it is another than before. Its texture stays as it is
  // until the next one has been taken.
  bool take();
  bool hasFinished() const;                   // take() or takePlot() would

  // Plots go beside pictures: neither waits for the other longer than one model takes.
  void postPlot(PlotRequest);
  bool takePlot();
  const std::shared_ptr<const PlotResult>& plot() const { return plot_; }   // the newest taken; null before the first
  const FrameResult& shown() const { return shown_; }

  struct Progress {
    std::string what;
    double fraction = 0;
  };
  std::optional<Progress> progress() const;   // of long work that is going on
  bool working() const;                       // a request is waiting or being drawn (refinement does not count)
  bool settled() const;                       // nothing left to do, refinement included, and all of it taken

 private:
  void run();
  void draw(Renderer&, PreviewScene&, const FrameRequest&);
  bool refine(Renderer&, PreviewScene&);
  void measureReference(Renderer&, FrameResult&) const;
  bool finish(Renderer&);                     // what was coarse
  void checkModel(Renderer&);                 // the next of those not looked at
  void computePlot(PlotComputer&, PlotRequest);
  void publish(FrameResult);
  unsigned keep(unsigned drawn, glm::ivec2 size);   // a copy that stays while it is shown

  std::unique_ptr<gl::Context> context_;
  const NodeRegistry& nodes_;
  const FunctionLibrary& functions_;
  std::function<void()> wake_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<FrameRequest> pending_;
  std::optional<FrameResult> finished_;       // not yet taken
  std::optional<Progress> progress_;
  std::optional<PlotRequest> pendingPlot_;
  std::shared_ptr<const PlotResult> finishedPlot_;
  bool stop_ = false, busy_ = false, plotting_ = false, refining_ = false, checking_ = false;

  FrameResult shown_;                         // the window's
  std::shared_ptr<const PlotResult> plot_;

  // The render thread's own.
  FrameRequest current_;
  FrameResult last_;
  std::vector<View> views_;
  std::vector<Camera> cameras_;               // of the picture before
  bool follows_ = false;                      // RenderSettings::temporal, of the picture before
  RenderSettings settings_;
  uint64_t modelsRevision_ = 0;
  std::vector<ModelPtr> unchecked_;
  // Copies for the window: one is shown, one is on its way, one is free to be made anew at any size.
  struct Kept {
    gl::Texture texture;
    glm::ivec2 size{0};
  } kept_[3];
  int keptAt_ = 0;
  double smoothedCost_ = 0;                   // of a whole picture, ms
  std::thread thread_;
};

}  // namespace glint
