#include <gtest/gtest.h>

#include <fstream>

#include "materials/base/diagnostic.h"
#include "materials/base/files.h"

namespace glint {
namespace {

TEST(Diagnostic, TextHasPlaceWhatAndHint) {
  EXPECT_EQ(error("a.json:3", "is wrong", "mend it").text(), "a.json:3: is wrong; mend it");
  EXPECT_EQ(error("a.json:3", "is wrong").text(), "a.json:3: is wrong");
}

TEST(Diagnostic, SuggestionNamesTheNearest) {
  EXPECT_EQ(suggestion("burly", {"ggx", "burley"}), "did you mean 'burley'?");
  EXPECT_EQ(suggestion("zzzzzzzz", {"ggx", "burley"}), "known: ggx, burley");
}

TEST(Files, AtomicWriteRoundTripsAndReplaces) {
  const auto path = std::filesystem::temp_directory_path() / "glint_files_test.txt";
  EXPECT_TRUE(writeFileAtomic(path, "one").empty());
  EXPECT_TRUE(writeFileAtomic(path, "two").empty());
  EXPECT_EQ(*readFile(path), "two");
  std::filesystem::remove(path);
}

TEST(Files, ErrorsNameThePath) {
  EXPECT_EQ(readFile("/nowhere/at/all").diagnostics()[0].place, "/nowhere/at/all");
  EXPECT_FALSE(readFile("/tmp"));
  const Diagnostics failed = writeFileAtomic("/nowhere/at/all", "x");
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_EQ(failed[0].place, "/nowhere/at/all");
}

TEST(Files, CapIsKept) {
  const auto path = std::filesystem::temp_directory_path() / "glint_cap_test.txt";
  ASSERT_TRUE(writeFileAtomic(path, "12345").empty());
  EXPECT_FALSE(readFile(path, 4));
  EXPECT_TRUE(readFile(path, 5));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace glint
