#include <gtest/gtest.h>

#include "renderer/gl/context.h"
#include "renderer/gl/objects.h"

namespace glint {
namespace {

void drawsAndShares(gl::Backend backend) {
  auto context = gl::Context::create({.backend = backend});
  ASSERT_TRUE(context) << context.diagnostics()[0].text();
  EXPECT_EQ((*context)->backend(), backend);
  EXPECT_EQ((*context)->info().version.substr(0, 3), "4.5");
  auto shared = (*context)->createShared();
  ASSERT_TRUE(shared);
  // What drawing counts on holds in every context, also in a worker's.
  (*context)->release();
  (*shared)->makeCurrent();
  EXPECT_TRUE(glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS));
  EXPECT_TRUE(glIsEnabled(GL_DEBUG_OUTPUT));
  GLint alignment = 0;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  EXPECT_EQ(alignment, 1);
  (*shared)->release();
  (*context)->makeCurrent();
  // The program lives no longer than the context that is current.
  const auto broken = gl::buildProgram("broken", {{GL_VERTEX_SHADER, "#version 450 core\nvoid main() { nonsense; }"}});
  ASSERT_FALSE(broken);
  EXPECT_NE(broken.diagnostics()[0].what.find("nonsense"), std::string::npos);
}

TEST(Context, OsMesa) { drawsAndShares(gl::Backend::OsMesa); }
TEST(Context, Egl) { drawsAndShares(gl::Backend::Egl); }

}  // namespace
}  // namespace glint
