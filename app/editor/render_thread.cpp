#include "app/editor/render_thread.h"

#include <algorithm>
#include <chrono>

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Pictures averaged when nothing changes any more.
constexpr int kSamples = 16, kSamplesInSoftware = 8;
// Pictures of a reference, and the samples of a pixel in each: where the processor draws, one takes some tenths of a second.
constexpr int kReferenceFrames = 256, kReferenceSamples = 16, kReferenceSamplesInSoftware = 2;
// Over this, a picture is drawn at half the size while something is being dragged.
constexpr double kSlowMilliseconds = 45;

// Whether the same views look from elsewhere.
bool movedFrom(const std::vector<Camera>& before, const std::vector<View>& views) {
  const auto same = [](const View& view, const Camera& b) {
    const Camera& a = view.camera;
    return a.eye == b.eye && a.target == b.target && a.fovY == b.fovY && a.orthoHeight == b.orthoHeight;
  };
  return before.size() == views.size() && !std::equal(views.begin(), views.end(), before.begin(), same);
}

}  // namespace

RenderThread::RenderThread(std::unique_ptr<gl::Context> shared, const NodeRegistry& nodes,
                           const FunctionLibrary& functions, std::function<void()> wake)
    : context_(std::move(shared)), nodes_(nodes), functions_(functions), wake_(std::move(wake)) {
  thread_ = std::thread([this] { run(); });
}

RenderThread::~RenderThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void RenderThread::post(FrameRequest request) {
  {
    const std::lock_guard lock(mutex_);
    pending_ = std::move(request);
  }
  changed_.notify_all();
}

bool RenderThread::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!finished_) return false;
    shown_ = std::move(*finished_);
    finished_.reset();
  }
  changed_.notify_all();
  return true;
}

bool RenderThread::hasFinished() const {
  const std::lock_guard lock(mutex_);
  return finished_.has_value() || finishedPlot_;
}

void RenderThread::postPlot(PlotRequest request) {
  {
    const std::lock_guard lock(mutex_);
    pendingPlot_ = std::move(request);
  }
  changed_.notify_all();
}

bool RenderThread::takePlot() {
  const std::lock_guard lock(mutex_);
  if (!finishedPlot_) return false;
  plot_ = std::move(finishedPlot_);
  finishedPlot_.reset();
  return true;
}

std::optional<RenderThread::Progress> RenderThread::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

bool RenderThread::working() const {
  const std::lock_guard lock(mutex_);
  return pending_.has_value() || busy_;
}

bool RenderThread::settled() const {
  const std::lock_guard lock(mutex_);
  return !pending_ && !busy_ && !refining_ && !checking_ && !finished_ && !pendingPlot_ && !plotting_ && !finishedPlot_;
}

void RenderThread::publish(FrameResult result) {
  {
    const std::lock_guard lock(mutex_);
    finished_ = std::move(result);
  }
  wake_();
}

unsigned RenderThread::keep(unsigned drawn, glm::ivec2 size) {
  keptAt_ = (keptAt_ + 1) % int(std::size(kept_));
  Kept& kept = kept_[keptAt_];
  if (kept.size != size) {
    kept.texture = gl::createTexture2D(GL_RGBA8, size.x, size.y);
    kept.size = size;
  }
  glCopyImageSubData(drawn, GL_TEXTURE_2D, 0, 0, 0, 0, kept.texture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, size.x, size.y, 1);
  glFinish();
  return kept.texture.id();
}

void RenderThread::run() {
  context_->makeCurrent();
  {
    Renderer renderer(*context_);
    PreviewScene scene(nodes_, functions_);
    PlotComputer plots;
    auto lastWake = Clock::now();
    renderer.setProgress([&](const std::string& what, double fraction) {
      {
        const std::lock_guard lock(mutex_);
        if (fraction >= 1) progress_.reset();
        else progress_ = Progress{what, fraction};
      }
      // Not more often: on software GL each frame of the window takes its time from the work it reports on.
      if (since(lastWake) < 200 && fraction < 1) return;
      lastWake = Clock::now();
      wake_();
    });
    for (;;) {
      FrameRequest request;
      std::optional<PlotRequest> plot;
      bool fresh = false;
      {
        std::unique_lock lock(mutex_);
        // A texture is drawn again only after the window has gone over to the next one, so each picture waits until
        // the one before has been taken.
        changed_.wait(lock, [&] { return stop_ || pendingPlot_ || (!finished_ && (pending_ || refining_ || checking_)); });
        if (stop_) break;
        if (pending_ && !finished_) {
          request = std::move(*pending_);
          pending_.reset();
          busy_ = fresh = true;
          refining_ = false;
        }
        plot = std::exchange(pendingPlot_, std::nullopt);
        plotting_ = plot.has_value();
      }
      // Between two pictures one model is looked at: a fault is known in a moment and no picture waits for it.
      const bool drawn = fresh || !plot;
      bool more = true;
      if (fresh) draw(renderer, scene, request);
      else if (!plot && !unchecked_.empty()) checkModel(renderer);
      else if (!plot) more = refine(renderer, scene);
      if (plot) computePlot(plots, std::move(*plot));
      const std::lock_guard lock(mutex_);
      busy_ = last_.coarse && more && !pending_;
      plotting_ = false;
      progress_.reset();
      if (drawn) refining_ = more && !pending_;
      checking_ = !unchecked_.empty();
    }
  }
  for (Kept& kept : kept_) kept = {};
  context_->release();
}

void RenderThread::draw(Renderer& renderer, PreviewScene& scene, const FrameRequest& request) {
  const auto start = Clock::now();
  current_ = request;
  if (modelsRevision_ != request.modelsRevision) {
    renderer.reloadModels();
    modelsRevision_ = request.modelsRevision;
    unchecked_ = request.models;
    last_.modelProblems.clear();
  }
  {
    const std::lock_guard lock(mutex_);
    progress_ = Progress{"Preparing the scene", 0};
  }
  scene.update(request);

  const Preview& preview = request.preview;
  settings_ = {.view = preview.view, .exposure = preview.exposure, .tonemap = preview.tonemap,
               .background = preview.background, .backgroundColor = preview.backgroundColor, .compensate = preview.compensate, .areaLights = preview.areaLights,
               .samples = !preview.antialiasing ? 1 : context_->info().software ? kSamplesInSoftware : kSamples, .coarse = true};
  if (preview.view == kErrorView || (preview.reference && (preview.view == "lit" || preview.view == kFurnaceView))) {
    settings_.samples = kReferenceFrames;
    settings_.reference = kReferenceFrames * (context_->info().software ? kReferenceSamplesInSoftware : kReferenceSamples);
    settings_.errorScale = preview.errorScale;
    settings_.splitSum = preview.splitSum;
  }
  if (!scene.comparison) {
    settings_.shadows = preview.shadows;
    settings_.materialOcclusion = preview.materialOcclusion;
    settings_.screenOcclusion = preview.screenOcclusion;
    settings_.specularAntialiasing = preview.specularAntialiasing && preview.view == "lit";   // buffers show what the material says
  }
  const int divisor = request.dragging && smoothedCost_ > kSlowMilliseconds ? 2 : 1;
  const glm::ivec2 size = glm::max(request.size / divisor, glm::ivec2(1));
  views_.clear();
  FrameResult result;
  if (scene.comparison) {
    result.layout = comparisonLayout(request.size, scene.cells.rows(), scene.cells.columnTitles, request.scale);
    if (scene.cells.rows() > 0 && scene.cells.columns() > 0) views_ = comparisonViews(scene.cells, result.layout.grid);
    for (View& view : views_) view.rectangle /= divisor;
  } else {
    views_.push_back({&scene.scene, preview.orbit.camera(scene.radius + glm::length(scene.center - preview.orbit.target)),
                      {0, 0, size.x, size.y}});
  }
  // A view that moves, and the picture after, where it comes to rest, have the smooth edges of those before.
  const bool moves = movedFrom(cameras_, views_);
  follows_ = preview.antialiasing && settings_.reference == 0 && (moves || (follows_ && !request.dragging));
  settings_.temporal = follows_;
  cameras_.clear();
  for (const View& view : views_) cameras_.push_back(view.camera);
  result.serial = request.serial;
  if (settings_.view == kFurnaceView && !request.dragging) result.furnace = renderer.furnaceShares(views_, size, settings_.compensate);
  result.texture = keep(renderer.drawToTexture(views_, size, settings_), size);
  if (!scene.comparison) {
    result.camera = views_.front().camera;
    result.depth = std::make_shared<const SceneDepth>(size, renderer.depths(size));
  }
  result.size = size;
  result.layoutSize = request.size;
  result.comparison = scene.comparison;
  result.rowTitles = scene.cells.rowTitles;
  result.columnTitles = scene.cells.columnTitles;
  result.rows = scene.rows;
  result.ownRow = scene.ownRow;
  result.states = scene.states;
  result.center = scene.center;
  result.radius = scene.radius;
  result.subject = scene.subject;
  result.problems = scene.problems;
  result.problems.insert(result.problems.end(), renderer.problems().begin(), renderer.problems().end());
  result.modelProblems = last_.modelProblems;
  result.graphOk = scene.graphOk;
  result.meshMaterials = scene.meshMaterials;
  result.code = scene.code;
  result.stats = scene.stats;
  result.statistics = renderer.statistics();
  result.samples = 1;
  measureReference(renderer, result);
  result.coarse = result.statistics.coarseTables > 0;
  result.milliseconds = since(start);
  if (divisor == 1) smoothedCost_ = smoothedCost_ == 0 ? 0 : 0.5 * (smoothedCost_ + result.milliseconds);
  if (smoothedCost_ == 0 && divisor == 1) smoothedCost_ = 1;  // the first picture pays for compiling: not its cost
  last_ = result;
  publish(std::move(result));
}

// What is told of a picture that has a reference.
void RenderThread::measureReference(Renderer& renderer, FrameResult& result) const {
  if (settings_.reference == 0) return;
  result.reference = settings_.reference / settings_.samples * result.samples;
  result.referenceInAll = settings_.reference;
  if (settings_.view == kErrorView && !current_.dragging) result.errors = renderer.referenceErrors(views_, result.size);
}

void RenderThread::checkModel(Renderer& renderer) {
  const Diagnostics faults = renderer.check(unchecked_.back());
  unchecked_.pop_back();
  if (faults.empty()) return;
  last_.modelProblems.insert(last_.modelProblems.end(), faults.begin(), faults.end());
  publish(last_);
}

void RenderThread::computePlot(PlotComputer& plots, PlotRequest request) {
  const auto start = Clock::now();
  // Given up for a newer one, or for a picture, after which it is taken up again.
  const auto stop = [this] {
    const std::lock_guard lock(mutex_);
    return stop_ || pendingPlot_ || (pending_ && !finished_);
  };
  auto data = plots.compute(request.settings, request.subjects, request.dragging ? 0.4 : 1, stop);
  {
    const std::lock_guard lock(mutex_);
    if (!data) {
      if (!pendingPlot_) pendingPlot_ = std::move(request);
      return;
    }
    finishedPlot_ = std::make_shared<PlotResult>(PlotResult{request.serial, std::move(*data), since(start)});
  }
  wake_();
}

// Table by table, so that a new request need not wait for all of them; then the whole picture anew.
bool RenderThread::finish(Renderer& renderer) {
  if (renderer.refineTable()) return true;
  settings_.coarse = settings_.temporal = false;
  const auto start = Clock::now();
  last_.texture = keep(renderer.drawToTexture(views_, last_.size, settings_), last_.size);
  last_.coarse = false;
  measureReference(renderer, last_);
  last_.milliseconds = since(start);
  publish(last_);
  return true;
}

bool RenderThread::refine(Renderer& renderer, PreviewScene&) {
  // What is dragged, or was drawn small, waits for the whole picture.
  if (current_.dragging || (last_.samples >= settings_.samples && !last_.coarse)) return false;
  if (last_.coarse) return finish(renderer);
  const int sample = last_.samples;
  last_.texture = keep(renderer.refineTexture(views_, last_.size, settings_, sample), last_.size);
  ++last_.samples;
  measureReference(renderer, last_);
  publish(last_);
  return last_.samples < settings_.samples;
}

}  // namespace glint
