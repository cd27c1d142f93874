#include "materials/base/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint {
namespace {

using testing::HasSubstr;

TEST(Json, EveryValueKnowsItsLine) {
  const auto json = parseJson("\n{ \"a\": 1,\n  \"b\": [2,\n3\n],\n \"c\": {\"d\": null},\n\"e\": \"x\"}", "f", 10);
  ASSERT_TRUE(json);
  EXPECT_EQ(json->line, 11);
  EXPECT_EQ(json->find("a")->line, 11);
  EXPECT_EQ(json->find("b")->line, 12);
  EXPECT_EQ(json->find("b")->items[0].line, 12);
  EXPECT_EQ(json->find("b")->items[1].line, 13);
  EXPECT_EQ(json->find("c")->find("d")->line, 15);
  EXPECT_EQ(json->find("e")->line, 16);
}

TEST(Json, NumbersKeepTheirSpellingWhenWrittenBack) {
  const std::string text =
      "{\n  \"a\": 0.10,\n  \"b\": 12345678901234567890,\n  \"c\": [1, 2.5, 1e-3],\n  \"d\": \"\\u0001\\\"é\"\n}\n";
  const auto json = parseJson(text, "f");
  ASSERT_TRUE(json);
  EXPECT_EQ(writeJson(*json), text);
}

TEST(Json, FloatsAreSpeltShort) {
  EXPECT_EQ(Json::of(0.1f).text, "0.1");
  EXPECT_EQ(Json::of(3.f).text, "3");
  EXPECT_EQ(Json::of(-0.f).text, "0");
  EXPECT_EQ(Json::of(1e-7f).text, "1e-07");
}

void expectError(const std::string& text, const std::string& place, const std::string& what) {
  const auto json = parseJson(text, "f");
  ASSERT_FALSE(json) << text;
  EXPECT_EQ(json.diagnostics()[0].place, place) << text;
  EXPECT_THAT(json.diagnostics()[0].what, HasSubstr(what)) << text;
}

TEST(Json, FaultsNameTheirLine) {
  expectError("{\n\"a\": 1,\n\"b\": }", "f:3", "not valid JSON");
  expectError("{\"a\": 1,\n\n \"a\": 2}", "f:3", "'a' twice");
  expectError("[1,\n1e999]", "f:2", "out of range");
  expectError("", "f:1", "not valid JSON");
  expectError("[1] x", "f:1", "not valid JSON");
  expectError("\"\xff\"", "f:1", "not valid JSON");
  expectError(std::string(100000, '['), "f:1", "deeper than 64");
  expectError(std::string(100000, '[') + "\n", "f:1", "deeper than 64");
}

TEST(Json, LimitsHold) {
  EXPECT_FALSE(parseJson("[1,2,3,4]", "f", 1, {.values = 4}));
  EXPECT_TRUE(parseJson("[1,2,3]", "f", 1, {.values = 4}));
  EXPECT_FALSE(parseJson("[1,2,3]", "f", 1, {.bytes = 4}));
}

}  // namespace
}  // namespace glint
