// One context and one editor for all tests of a process: each begins with a document of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <functional>
#include <thread>

#include "app/editor/ui_driver.h"

namespace glint::testing_support {

class EditorTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::filesystem::remove_all(folder());
    std::filesystem::create_directories(folder() / "config" / "models");
    auto made = gl::Context::create({.backend = gl::Backend::OsMesa});
    ASSERT_TRUE(made) << made.diagnostics()[0].text();
    context_ = std::move(*made);
    driver_ = std::make_unique<UiDriver>(*context_, EditorOptions{.configFolder = folder() / "config"}, glm::ivec2(1280, 1100));
  }
  static void TearDownTestSuite() {
    driver_.reset();
    context_.reset();
  }
  // Of this process alone: several executables have such tests, and run at once.
  static std::filesystem::path folder() { return std::filesystem::path(GLINT_TESTS_OUT) / program_invocation_short_name; }

  UiDriver& ui() { return *driver_; }
  Document& document() { return driver_->editor().document(); }
  // A new material that looks at one small sphere, so that frames are quick.
  void begin() {
    Preview preview;
    preview.subject = Preview::Subject::Mesh;
    preview.mesh = "sphere";
    preview.environment = "none";
    preview.lights.push_back({});
    document().startNew(newMaterial("trial"), preview);
    driver_->editor().selection().clear();
    driver_->editor().layout().reset();
    ui().frames(4);
  }
  // The same with a comparison: this row, and that of the material's own model.
  void beginComparison(const std::string& row) {
    begin();
    Preview preview = document().preview();
    preview.subject = Preview::Subject::Comparison;
    preview.models = {row};
    preview.materials.clear();
    document().startNew(newMaterial("trial"), preview);
    ui().frames(4);
  }
  // All of the right side is the list of models, so that nothing of it is out of sight.
  void showModels() {
    Layout& layout = ui().editor().layout();
    layout.show("Models");
    layout.hide("Properties");
    layout.hide("Library");
    ui().frames(3);
  }
  void addNode(const std::string& search) {
    ui().click("Graph/Add node");
    ui().type(search);
    ui().key(Key::Enter);
    ui().frames(3);
  }
  NodeId only(const std::string& kind) {
    for (const auto& [id, node] : document().material().nodes)
      if (node.kind == kind) return id;
    ADD_FAILURE() << "no node of kind " << kind;
    return "";
  }
  // As the window does, which draws when there is something new, until it is so; false after a minute.
  bool until(const std::function<bool()>& so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!so()) {
      if (std::chrono::steady_clock::now() > end) return false;
      if (ui().editor().hasNews()) ui().frames(2);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }

  static inline std::unique_ptr<gl::Context> context_;
  static inline std::unique_ptr<UiDriver> driver_;
};

}  // namespace glint::testing_support
