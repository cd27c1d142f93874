// glint eval against exact values: every kind of entry of the tables, and requests that cannot be met.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "materials/base/files.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing_support::glint;
using testing_support::scratch;

void write(const std::string& name, const std::string& text) { ASSERT_TRUE(writeFileAtomic(scratch() / name, text).empty()); }

// Compares a value, by name where an entry has several: within the entry's own tolerance (terms), or 5e-4 of it.
void compare(const json& entry, const std::string& name, const json& measured) {
  const json& exact = entry.at(name);
  if (exact.is_array()) {
    ASSERT_EQ(measured.size(), exact.size()) << entry["id"] << " " << name;
    for (size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(measured[i].get<double>(), exact[i].get<double>(), 1e-4) << entry["id"] << " " << name;
    return;
  }
  const double value = exact, tolerance = entry.contains("tol32") ? entry["tol32"].get<double>() : 5e-4;
  const double floor = entry.contains("tol32") ? 1e-37 : 1e-6;
  EXPECT_NEAR(measured.get<double>(), value, floor + tolerance * std::abs(value)) << entry["id"] << " " << name;
}

TEST(EvalCommand, MatchesTheExactValues) {
  const auto file = std::filesystem::path(GLINT_TESTS_DIR) / "data/exact_values.json";
  const auto ran = glint({"eval", file.string(), "-o", "values.json", "--quiet"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  const json table = json::parse(*readFile(file)), values = json::parse(*readFile(scratch() / "values.json"));
  ASSERT_EQ(values.size(), table["entries"].size());
  size_t compared = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    const json& entry = table["entries"][i];
    ASSERT_EQ(values[i]["id"], entry["id"]);
    if (!values[i]["value"].is_object()) compare(entry, "value", values[i]["value"]);
    else
      for (const auto& [name, measured] : values[i]["value"].items()) compare(entry, name, measured);
    compared += values[i]["value"].is_object() ? values[i]["value"].size() : 1;
  }
  EXPECT_GT(compared, values.size()) << "entries with several values have them all";
}

TEST(EvalCommand, TakesAListOfItsOwn) {
  write("work.json", R"([
    {"id": "a", "term": "D_GGX", "args": {"r": 1, "NoH": 0.3}},
    {"id": "b", "term": "f_ggx", "args": {"r": 1, "F0": 1, "l": [0, 0, 1], "v": [0, 0, 1]}},
    {"id": "c", "term": "directional_albedo", "model": "GGX*SmithGGX*Schlick", "args": {"roughness": 1, "NoV": 1}},
    {"id": "d", "term": "D_GTR", "args": {"alpha": 1, "NoH": 0.3, "gamma": 3}}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const json values = json::parse(ran.out);
  EXPECT_NEAR(values[0]["value"].get<double>(), 1 / 3.14159265, 1e-6);
  EXPECT_NEAR(values[1]["value"].get<double>(), 0.25 / 3.14159265, 1e-6);
  EXPECT_NEAR(values[2]["value"].get<double>(), 1 - std::log(2.0), 1e-4);
  EXPECT_NEAR(values[3]["value"].get<double>(), 1 / 3.14159265, 1e-6) << "alpha 1 is uniform for every gamma";
}

// "compensate" asks for the model with all bounces; what is made for a model's own D is asked of a model.
TEST(EvalCommand, CompensatedModelsAndOwnTerms) {
  write("work.json", R"([
    {"id": "a", "term": "directional_albedo", "model": "GGX*SmithGGX*Schlick", "args": {"r": 0.9, "NoV": 0.4, "compensate": 1}},
    {"id": "b", "term": "f_GGX*Smith*None", "args": {"r": 0.5, "F0": 1, "l": [0.6, 0, 0.8], "v": [-0.6, 0, 0.8]}},
    {"id": "c", "term": "f_GGX*SmithGGX*None", "args": {"r": 0.5, "F0": 1, "l": [0.6, 0, 0.8], "v": [-0.6, 0, 0.8]}},
    {"id": "d", "term": "V_Smith", "args": {"r": 1, "NoL": 0.3, "NoV": 0.3}}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.err, HasSubstr("'V_Smith' is made for the D of a model"));
  const json values = json::parse(ran.out);
  ASSERT_EQ(values.size(), 3u);
  EXPECT_NEAR(values[0]["value"].get<double>(), 1, 5e-3);
  EXPECT_NEAR(values[1]["value"].get<double>(), values[2]["value"].get<double>(), 2e-3 * values[2]["value"].get<double>());
}

TEST(EvalCommand, WhatCannotBeEvaluatedIsSaidAndNotInvented) {
  write("work.json", R"([
    {"id": "good", "term": "F_Schlick", "args": {"F0": 0.04, "VoH": 1}},
    {"id": "typo", "term": "D_GGGX", "args": {"r": 0.5, "NoH": 1}},
    {"id": "short", "term": "D_GGX", "args": {"r": 0.5}},
    {"id": "model", "term": "f_nothing", "args": {"r": 0.5, "F0": 1, "NoL": 1, "NoV": 1, "NoH": 1, "VoH": 1}},
    {"id": "nothing"}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(json::parse(ran.out).size(), 1u);
  EXPECT_THAT(ran.err, HasSubstr("work.json:3: 'typo' is not evaluated: 'D_GGGX' is nothing that can be evaluated; did you mean 'D_GGX'"));
  EXPECT_THAT(ran.err, HasSubstr("'short' is not evaluated: 'D_GGX' needs the argument 'NoH'"));
  EXPECT_THAT(ran.err, HasSubstr("'model' is not evaluated: unknown shading model"));
  EXPECT_THAT(ran.err, HasSubstr("'nothing' is not evaluated"));
}

TEST(EvalCommand, BadInput) {
  write("noise.json", "][");
  write("object.json", "{\"entries\": 3}");
  write("entry.json", "[1, {\"term\": \"D_GGX\"}]");
  EXPECT_BAD_INPUT(glint({"eval", "missing.json"}), "missing.json", "");
  EXPECT_BAD_INPUT(glint({"eval", "noise.json"}), "noise.json:1", "");
  EXPECT_BAD_INPUT(glint({"eval", "object.json"}), "object.json", "holds no list of entries");
  EXPECT_BAD_INPUT(glint({"eval", "noise.json", "-o", "out.png"}), "--output", ".json");
  const auto ran = glint({"eval", "entry.json"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.errorLines().size(), 2u) << "all faults at once: " << ran.err;
}

}  // namespace
}  // namespace glint
