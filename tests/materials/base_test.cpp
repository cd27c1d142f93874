#include <gtest/gtest.h>

#include <fstream>

#include "materials/base/diagnostic.h"
#include "materials/base/files.h"
#include "materials/base/utf8.h"

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

TEST(Utf8, WhatIsNoneOfItIsReplaced) {
  const std::string good = "a\xc3\xbc\xe6\x97\xa5\xf0\x9f\x98\x80 \xef\xbf\xbd";
  EXPECT_EQ(validUtf8(good), good);
  const std::string mark = "\xef\xbf\xbd";
  EXPECT_EQ(validUtf8("x\xf6y"), "x" + mark + "y");
  EXPECT_EQ(validUtf8("\xe6\x97"), mark + mark) << "cut off";
  EXPECT_EQ(validUtf8("\xc0\xaf"), mark + mark) << "longer than need be";
  EXPECT_EQ(validUtf8("\xed\xa0\x80"), mark + mark + mark) << "half a pair";
  EXPECT_EQ(validUtf8(std::string_view("\0", 1)), mark);
  EXPECT_EQ(onOneLine("a\nb\\\x1b \x7f"), "a\\nb\\\\\\x1b \\x7f");
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
