// glint eval against exact values: every kind of entry of the tables, and requests that cannot be met.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

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

// Every value of an entry that a name with dots leads to.
void compareAll(const json& entry, const json& measured, double exactly, double approximately) {
  for (const auto& [name, value] : measured.items()) {
    const json* truth = &entry;
    for (size_t at = 0; at <= name.size();) {
      const size_t end = std::min(name.find('.', at), name.size());
      const auto found = truth->find(name.substr(at, end - at));
      ASSERT_NE(found, truth->end()) << entry["id"] << " has no " << name;
      truth = &*found;
      at = end + 1;
    }
    const double tolerance = name.starts_with("approx.") ? approximately : exactly;
    EXPECT_NEAR(value.get<double>(), truth->get<double>(), 1e-6 + tolerance * std::abs(truth->get<double>())) << entry["id"] << " " << name;
  }
}

// By Monte Carlo: spheres and tubes, beside what representative points make of them, and environments with their split sums.
TEST(EvalCommand, MatchesTheExactLight) {
  for (const auto& [name, exactly, values] : {std::tuple{"area_lights.json", 5e-3, 43u}, {"environment_light.json", 1e-3, 44u}}) {
    const auto file = std::filesystem::path(GLINT_TESTS_DIR) / "data" / name;
    const auto ran = glint({"eval", file.string()});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    const json table = json::parse(*readFile(file)), measured = json::parse(ran.out);
    ASSERT_EQ(measured.size(), table["entries"].size());
    for (size_t i = 0; i < measured.size(); ++i) {
      EXPECT_GE(measured[i]["value"].size(), values) << "all that is listed";
      compareAll(table["entries"][i], measured[i]["value"], exactly, 1e-4);
    }
  }
}

TEST(EvalCommand, LightsThatCannotBeAreNamed) {
  write("work.json", R"({"environments": {"odd": {"constant": "bright"}, "dim": {"constant": 0.1, "linear": [0, 0, 0], "sg": []}}, "entries": [
    {"id": "a", "kind": "sphere", "r": 0.5, "v": [0, 0, 1], "center": [0, 0, 1], "radius": 0},
    {"id": "b", "kind": "sphere", "r": 0.5, "v": [0, 0, 2], "center": [0, 0, 1], "radius": 0.1}]})");
  auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_THAT(ran.err, HasSubstr("environment 'odd': is not described"));
  EXPECT_THAT(ran.err, HasSubstr("radius 0 is out of range"));
  EXPECT_THAT(ran.err, HasSubstr("'v' is 2 long"));
  write("work.json", R"({"entries": [
    {"id": "a", "kind": "tube", "r": 0.5, "v": [0, 0, 1], "L0": [0, 0, 1], "L1": [0, 0, 1], "radius": 0.1},
    {"id": "b", "env": "none such", "args": {"r": 0.5, "NoV": 1}, "v": [0, 0, 1]},
    {"id": "c", "kind": "sphere", "r": 0.5, "v": [0, 0, 1], "center": [0, 0], "radius": 0.1},
    {"id": "d", "kind": "sphere", "r": 1, "v": [0, 0, 1], "center": [0, 0, 2], "radius": 0.5}]})");
  ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_THAT(ran.err, HasSubstr("the tube has no length"));
  EXPECT_THAT(ran.err, HasSubstr("no environment of that name"));
  EXPECT_THAT(ran.err, HasSubstr("needs 'center' as 3 numbers"));
  const json values = json::parse(ran.out);
  ASSERT_EQ(values.size(), 1u);
  EXPECT_NEAR(values[0]["value"]["reference.irradiance"].get<double>(), 0.25, 1e-3) << "an entry that lists nothing has everything";
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

// Far from the normal, where 1 - sin^2 has no digits left; exact values by logarithms in double precision.
TEST(EvalCommand, DistributionsFarFromTheNormal) {
  write("work.json", R"([
    {"id": "a", "term": "D_Blinn", "args": {"r": 0.9, "NoH": 0.02}}, {"id": "b", "term": "D_Blinn", "args": {"r": 0.8, "NoH": 0.01}},
    {"id": "c", "term": "D_Blinn", "args": {"r": 0.95, "NoH": 1e-4}}, {"id": "d", "term": "D_Beckmann", "args": {"r": 1, "NoH": 0.15}}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const json values = json::parse(ran.out);
  const auto blinn = [](double r, double NoH) { return std::pow(NoH, 2 / std::pow(r, 4) - 2) / (3.14159265358979 * std::pow(r, 4)); };
  const auto near = [&](size_t i, double exact) { EXPECT_NEAR(values[i]["value"].get<double>(), exact, 1e-5 * exact) << i; };
  near(0, blinn(0.9, 0.02));
  near(1, blinn(0.8, 0.01));
  near(2, blinn(0.95, 1e-4));
  near(3, std::exp(-(1 - 0.0225) / 0.0225) / (3.14159265358979 * 0.0225 * 0.0225));
}

// The diffuse part of the model that is named, also by a list of its terms, and none invented where there is none.
TEST(EvalCommand, DiffuseAlbedoOfAModel) {
  write("work.json", R"([
    {"id": "a", "quantity": "diffuse_directional_albedo", "model": "GGX*SmithGGX*Schlick*EON", "args": {"r": 0.5, "NoV": 0.1}},
    {"id": "b", "quantity": "diffuse_directional_albedo", "model": ["GGX", "SmithGGX", "Schlick", "Burley"], "args": {"r": 0.5, "NoV": 0.1}},
    {"id": "c", "quantity": "diffuse_directional_albedo", "args": {"r": 0.5, "NoV": 0.1}},
    {"id": "d", "quantity": "diffuse_directional_albedo", "model": "nope", "args": {"r": 0.5, "NoV": 0.1}}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_NE(ran.code, 0);
  EXPECT_THAT(ran.err, HasSubstr("unknown shading model"));
  write("work.json", R"([
    {"id": "a", "quantity": "diffuse_directional_albedo", "model": "GGX*SmithGGX*Schlick*EON", "args": {"r": 0.5, "NoV": 0.1}},
    {"id": "b", "quantity": "diffuse_directional_albedo", "model": ["GGX", "SmithGGX", "Schlick", "Burley"], "args": {"r": 0.5, "NoV": 0.1}},
    {"id": "c", "quantity": "diffuse_directional_albedo", "args": {"r": 0.5, "NoV": 0.1}}])");
  const json values = json::parse(glint({"eval", "work.json"}).out);
  EXPECT_NEAR(values[0]["value"].get<double>(), 1, 2e-3) << "a white EON keeps its energy";
  EXPECT_EQ(values[1]["value"], values[2]["value"]);
  EXPECT_GT(values[1]["value"].get<double>(), 1.01);
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
  EXPECT_THAT(ran.err, HasSubstr("work.json:3: entry 2 'typo': is not evaluated: 'D_GGGX' is nothing that can be evaluated; did you mean 'D_GGX'"));
  EXPECT_THAT(ran.err, HasSubstr("'short': is not evaluated: 'D_GGX' needs the argument 'NoH'"));
  EXPECT_THAT(ran.err, HasSubstr("'model': is not evaluated: unknown shading model"));
  EXPECT_THAT(ran.err, HasSubstr("'nothing': is not evaluated"));
}

// Pictures have a floor of alpha, numbers have it only where they are made as pictures are, and then say so.
TEST(EvalCommand, SmallAlphasAreThoseAskedFor) {
  write("work.json", R"([
    {"id": "peak", "term": "D_GGX", "args": {"NoH": 1, "r": 0.01}},
    {"id": "model", "term": "f_ggx", "args": {"r": 0.01, "F0": 1, "l": [0, 0, 1], "v": [0, 0, 1]}},
    {"id": "tail", "term": "D_GTR", "args": {"gamma": 6, "r": 0.01, "NoH": 1}},
    {"id": "mobile", "term": "D_Approx", "args": {"roughness": 0.01, "RoL": 1}},
    {"id": "tables", "term": "f_GGX*Smith*None", "args": {"r": 0.01, "F0": 1, "l": [0, 0, 1], "v": [0, 0, 1]}},
    {"id": "albedo", "term": "directional_albedo", "model": "ggx", "args": {"r": 0.01, "NoV": 0.5}},
    {"id": "diffuse", "term": "diffuse_directional_albedo", "args": {"r": 0, "NoV": 0.5}},
    {"id": "mirror", "term": "D_GGX", "args": {"NoH": 1, "r": 0}}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 1) << ran.err;
  const json values = json::parse(ran.out);
  ASSERT_EQ(values.size(), 7u);
  const auto near = [&](size_t i, double exact) { EXPECT_NEAR(values[i]["value"].get<double>(), exact, 1e-5 * exact) << values[i]["id"]; };
  near(0, 1e8 / 3.14159265359);
  near(1, 0.25e8 / 3.14159265359);
  near(2, 5e8 / 3.14159265359);
  near(3, 1e8);
  near(4, 1 / (4 * 3.14159265359 * 5e-4 * 5e-4));
  EXPECT_EQ(ran.errorLines().size(), 3u) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("entry 5 'tables': is computed with alpha 0.0005 (roughness 0.0224), the smallest that pictures have, instead of 0.0001"));
  EXPECT_THAT(ran.err, HasSubstr("entry 6 'albedo': is computed with alpha 0.0005"));
  EXPECT_THAT(ran.err, HasSubstr("entry 8 'mirror': is not evaluated: 'value' is not finite there"));
}

TEST(EvalCommand, ParametersOfModelsReachTheirValues) {
  write("work.json", R"([
    {"id": "a", "term": "f_burley", "args": {"r": 0.5, "F0": 1, "gamma": 2, "metallic": 1, "l": [0, 0, 1], "v": [0, 0, 1]}},
    {"id": "b", "term": "f_GGX*SmithGGX*Schlick", "args": {"r": 0.5, "F0": 1, "NoL": 1.0000003, "NoV": 1, "NoH": 1, "VoH": 1}}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const json values = json::parse(ran.out);
  EXPECT_NEAR(values[0]["value"].get<double>(), values[1]["value"].get<double>(), 1e-5);
}

// A .brdf reads no attribute: only its own parameters are asked for, also those with names of attributes and arguments.
TEST(EvalCommand, OnlyWhatAModelReadsIsAskedFor) {
  write("own.brdf", "analytic\n::begin parameters\nfloat roughness 0 1 .5\nfloat alpha 0 9 2\nfloat F0 0 9 3\n::end parameters\n::begin shader\n"
                    "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(roughness + 10 * alpha + 100 * F0); }\n::end shader\n");
  write("work.json", R"([
    {"id": "plain", "term": "f_own.brdf", "args": {"l": [0, 0, 1], "v": [0, 0, 1]}},
    {"id": "given", "term": "f_own.brdf", "args": {"l": [0, 0, 1], "v": [0, 0, 1], "roughness": 0.25, "alpha": 4, "F0": 7}},
    {"id": "albedo", "term": "directional_albedo", "model": "own.brdf", "args": {"NoV": 0.5, "F0": 0, "alpha": 0}},
    {"id": "reads", "term": "f_ggx", "args": {"l": [0, 0, 1], "v": [0, 0, 1], "F0": 1}}])");
  const auto ran = glint({"eval", "work.json"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_EQ(ran.errorLines().size(), 1u) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("entry 4 'reads': is not evaluated: 'f_ggx' needs the argument 'r'"));
  const json values = json::parse(ran.out);
  ASSERT_EQ(values.size(), 3u);
  EXPECT_NEAR(values[0]["value"].get<double>(), 320.5, 1e-3);
  EXPECT_NEAR(values[1]["value"].get<double>(), 740.25, 1e-3);
  EXPECT_NEAR(values[2]["value"].get<double>(), 0.5 * 3.14159265, 1e-3);
  write("far.json", R"([{"id": "far", "term": "f_own.brdf", "args": {"l": [0, 0, 1], "v": [0, 0, 1], "alpha": 10}}])");
  EXPECT_BAD_INPUT(glint({"eval", "far.json"}), "far.json:1: entry 1 'far'", "alpha 10 is out of range; 0 to 9 are allowed");
}

// Each fault at its entry, all at once, and nothing is written.
TEST(EvalCommand, ArgumentsThatCannotBe) {
  write("work.json", R"([
    {"id": "text", "term": "D_GGX", "args": {"NoH": "0.5", "r": 0.5}},
    {"id": "two", "term": "D_GGX", "args": {"NoH": 2, "r": 1.5}},
    {"id": "two", "term": "G_SmithGGX", "args": {"NoL": -0.2, "NoV": 0.5, "r": 0.5}},
    {"id": "below", "term": "D_Approx", "args": {"RoL": -1.5, "r": -0.5}},
    {"id": "typo", "term": "D_GTR", "args": {"NoH": 0.5, "r": 0.5, "gama": 2}},
    {"id": "parameter", "term": "f_burley", "args": {"NoH": 1, "NoL": 1, "NoV": 1, "VoH": 1, "F0": 1, "r": 0.5, "gamma": 99}},
    {"id": "far", "term": "f_ggx", "args": {"r": 0.5, "F0": 1, "l": [0, 0, 2], "v": [0, 0.6, -0.8]}},
    {"id": "kinds", "term": "f_ggx", "args": {"r": 0.5, "alpha": 0.5, "F0": true, "l": [0, 0], "v": "up"}},
    {"id": 3},
    {"id": "good", "term": "F_Schlick", "args": {"F0": 0.04, "VoH": 1}}])");
  const auto ran = glint({"eval", "work.json", "-o", "values.json"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_FALSE(std::filesystem::exists(scratch() / "values.json"));
  for (const char* line : {"work.json:2: entry 1 'text': 'NoH' is a string, not a number; write 0.5 without quotes",
                           "work.json:3: entry 2 'two': NoH 2 is out of range; a cosine above the surface is from 0 to 1",
                           "work.json:3: entry 2 'two': r 1.5 is out of range; a roughness is from 0 to 1",
                           "work.json:4: entry 3 'two': has the id of entry 2 in line 3; give each an id of its own",
                           "work.json:4: entry 3 'two': NoL -0.2 is out of range",
                           "work.json:5: entry 4 'below': RoL -1.5 is out of range; a cosine is from -1 to 1",
                           "work.json:5: entry 4 'below': r -0.5 is out of range",
                           "work.json:6: entry 5 'typo': 'D_GTR' has no argument 'gama'; did you mean 'gamma'?",
                           "work.json:7: entry 6 'parameter': gamma 99 is out of range; 1 to 4 are allowed",
                           "work.json:8: entry 7 'far': the direction 'l' is 2 long; give it the length 1",
                           "work.json:8: entry 7 'far': the direction 'v' points below the surface",
                           "work.json:9: entry 8 'kinds': 'F0' is true or false, not a number",
                           "work.json:9: entry 8 'kinds': 'v' is a string, not a list of numbers",
                           "work.json:9: entry 8 'kinds': 'l' has 2 numbers",
                           "work.json:9: entry 8 'kinds': the roughness is given twice",
                           "work.json:10: entry 9: has an id that is a number; give each a text of its own"})
    EXPECT_THAT(ran.err, HasSubstr(line));
  EXPECT_EQ(ran.errorLines().size(), 16u) << ran.err;
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
