#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <string>

#include "renderer/gl/context.h"

// Every test of every executable ends with the same question: did OpenGL complain?
namespace {

class NoGlErrors : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo&) override {
    EXPECT_EQ(glint::gl::errorCount(), 0) << "OpenGL reported errors: see the log above";
  }
};

}  // namespace

int main(int argc, char** argv) {
  // The same everywhere, and nothing of the user's is read or written; the program under test inherits it. Each executable
  // has a configuration of its own: a model that one of them installs is seen at once by every editor that shares it.
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("XDG_CACHE_HOME", GLINT_TESTS_OUT "/../cache", 1);
  setenv("XDG_CONFIG_HOME", (std::string(GLINT_TESTS_OUT "/../config/") + program_invocation_short_name).c_str(), 1);
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new NoGlErrors);
  return RUN_ALL_TESTS();
}
