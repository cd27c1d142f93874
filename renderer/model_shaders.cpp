#include "renderer/model_shaders.h"

#include <filesystem>
#include <utility>

#include "materials/base/hash.h"
#include "renderer/loop_faults.h"
#include "renderer/model_speed.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

// Of the shaders that programs include by their path, as they lie on disk: which, how long, and written when.
uint64_t shippedShaders() {
  uint64_t hash = 0;
  for (const char* folder : {"shaders/common", "shaders/passes", "shaders/terms"})
    for (const char* extension : {".glsl", ".vert", ".frag"})
      for (const std::string& path : shipped::list(folder, extension)) {
        std::error_code gone;
        const std::filesystem::path file = shipped::onDisk(path);
        hash = hashText(fmt::format("{} {} {}", path, std::filesystem::file_size(file, gone),
                                    std::filesystem::last_write_time(file, gone).time_since_epoch().count()), hash);
      }
  return hash;
}

}  // namespace

ModelShaders::ModelShaders(ProgramCache& programs, const Rectangles& rectangles)
    : programs_(programs), rectangles_(rectangles), shippedHash_(shippedShaders()) {}

std::shared_ptr<const ModelShader> ModelShaders::of(const std::shared_ptr<const ShadingModel>& model) {
  auto& entry = shaders_[model.get()];
  if (!entry || entry->model != model) entry = std::make_shared<ModelShader>(model);
  return entry;
}

const Diagnostics& ModelShaders::verdict(const ModelShader& shader) {
  auto verdict = verdicts_.find(shader.hash);
  if (verdict == verdicts_.end()) {
    // By the smallest program that holds all of the model.
    const auto program = programs_.get(Rectangles::vertexShader(), {"shaders/passes/lobe.frag", {}, {{"model", shader.glsl}}});
    Diagnostics faults = program ? slowness(*shader.model, **program) : modelErrors(*shader.model, program.diagnostics()[0].what);
    if (faults.empty())
      if (const auto fault = faultOfLoops(*shader.model)) faults.push_back(*fault);
    verdict = verdicts_.emplace(shader.hash, std::move(faults)).first;
  }
  return verdict->second;
}

// A model that would take hours is not drawn: a few values show it.
Diagnostics ModelShaders::slowness(const ShadingModel& model, const gl::Program& lobe) {
  constexpr int kRows = 4, kFloorEvaluations = 121;  // modelFloor() of shaders/common/floor_light.glsl, and the value
  const auto fault = faultOfSpeed(model, [&](int count) {
    const gl::Texture target = gl::createTexture2D(GL_R32F, count / kRows, kRows);
    const GLuint color = target.id();
    const gl::Framebuffer framebuffer = gl::createFramebuffer(std::span(&color, 1));
    lobe.set("width", static_cast<float>(count / kRows));
    lobe.set("roughnessCount", kRows);
    lobe.set("azimuthCount", 1);
    rectangles_.drawWhole(lobe, framebuffer.id(), {count / kRows, kRows});
    glFinish();
  }, model.isWhole() ? kFloorEvaluations : 1);
  return fault ? Diagnostics{*fault} : Diagnostics{};
}

std::shared_ptr<const ModelShader> ModelShaders::sound(const std::shared_ptr<const ShadingModel>& model, Diagnostics& problems) {
  auto shader = of(model);
  const Diagnostics& faults = verdict(*shader);
  if (faults.empty()) {
    lastGood_[model->id] = shader;
    return shader;
  }
  problems.insert(problems.end(), faults.begin(), faults.end());
  const auto good = lastGood_.find(model->id);
  return good == lastGood_.end() ? nullptr : good->second;
}

void ModelShaders::reload() {
  std::erase_if(shaders_, [](const auto& entry) { return entry.second->model.use_count() == 1; });
  std::erase_if(verdicts_, [](const auto& entry) { return !entry.second.empty(); });
  const uint64_t now = shippedShaders();
  if (std::exchange(shippedHash_, now) == now) return;
  programs_.forget();
  shaders_.clear();
  verdicts_.clear();
}

}  // namespace glint
