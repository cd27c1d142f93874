#include <gtest/gtest.h>

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
  testing::InitGoogleTest(&argc, argv);
  testing::UnitTest::GetInstance()->listeners().Append(new NoGlErrors);
  return RUN_ALL_TESTS();
}
