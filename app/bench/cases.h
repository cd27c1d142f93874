// The cases of `glint bench`.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/bench/measure.h"
#include "app/scene_loader.h"
#include "renderer/gl/context.h"
#include "renderer/renderer.h"

namespace glint {

// What the cases share.
struct BenchSetup {
  gl::Context& context;
  Libraries& libraries;
  Effort effort;
  bool quick = false;

  // Made on first use: starting costs belong to `startup`.
  Renderer& renderer();

 private:
  std::unique_ptr<Renderer> renderer_;

 public:
  BenchSetup(gl::Context& c, Libraries& l, Effort e, bool q) : context(c), libraries(l), effort(e), quick(q) {}
};

struct BenchCase {
  std::string name, doc;
  std::function<Result<Measurement>(BenchSetup&)> run;
};

// In the order they are run. The models of the registry give some of them their names.
std::vector<BenchCase> benchCases(const ModelRegistry&);

std::vector<BenchCase> frameCases(const ModelRegistry&);      // calibrate, frame.*, model.*, models.4
std::vector<BenchCase> environmentCases(const ModelRegistry&);  // env.*
std::vector<BenchCase> materialCases();                       // graph.*, edit.*
std::vector<BenchCase> modelCases();                          // verify.*, eval.*, model.drop
std::vector<BenchCase> plotCases();                           // plot.*
std::vector<BenchCase> startupCases();                        // startup.*

// The model of a plain material: what the cases that name none draw.
Result<ModelPtr> plainModel(const Libraries&);

// What `startup` measures in a child: the first frame of the standard scene, under the sun and the studio.
Diagnostics drawFirstFrame(gl::Context&, Libraries&);

}  // namespace glint
