// One context, renderer, set of models and sphere for all tests of a suite that draw. Suite is the class that inherits it.
#pragma once

#include <gtest/gtest.h>

#include "materials/model_registry.h"
#include "renderer/mesh.h"
#include "renderer/renderer.h"
#include "tests/support/simple_scene.h"

namespace glint::test {

template <class Suite>
class RendererFixture : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::Context::create({.backend = gl::Backend::Egl});
    ASSERT_TRUE(made);
    context = std::move(*made).release();
    models = new ModelRegistry();
    renderer = new Renderer(*context);
    sphere = sphereMesh(48, 24);
  }
  static void TearDownTestSuite() {
    delete renderer;
    delete models;
    delete context;
    sphere.reset();
  }

  static inline gl::Context* context = nullptr;
  static inline Renderer* renderer = nullptr;
  static inline ModelRegistry* models = nullptr;
  static inline MeshPtr sphere;
};

}  // namespace glint::test
