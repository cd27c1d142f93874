#include "materials/material_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "materials/base/files.h"
#include "materials/graph_validate.h"
#include "materials/material_library.h"
#include "shaders/shipped_files.h"
#include "tests/materials/support/graphs.h"

namespace glint {
namespace {

using testing::HasSubstr;

const char* const kUnknown = R"({
  "glint": "material",
  "version": 1,
  "name": "future",
  "model": "ggx",
  "grain": {
    "film": [1, 2, 0.50]
  },
  "nodes": {
    "a": {
      "kind": "nois",
      "octaves": 3,
      "strange": {
        "deep": [true, null]
      },
      "inputs": {
        "scale": 2.5,
        "wobble": [0.1, 0.2]
      }
    },
    "output": {
      "kind": "output",
      "inputs": {
        "gamma": {
          "from": "a.value",
          "value": 2
        },
        "roughness": "a.value"
      }
    }
  },
  "layout": {
    "a": [-240, 12.5],
    "output": [0, 0]
  }
}
)";

TEST(MaterialJson, UnknownThingsAreReportedAndKept) {
  Diagnostics warnings;
  const auto material = parseMaterial(kUnknown, "f.json", test::nodes(), &warnings);
  ASSERT_TRUE(material) << test::texts(material.diagnostics());
  EXPECT_THAT(test::texts(warnings), HasSubstr("f.json:6: unknown key 'grain'"));
  EXPECT_EQ(materialText(*material), kUnknown);
}

TEST(MaterialJson, UnknownSettingsNameTheNearest) {
  Diagnostics warnings;
  const auto material = parseMaterial(R"({"glint": "material", "version": 1, "nodes": {
    "a": {"kind": "noise", "octavs": 3}}})", "f.json", test::nodes(), &warnings);
  ASSERT_TRUE(material);
  EXPECT_THAT(test::texts(warnings), HasSubstr("f.json:2: node 'a': unknown key 'octavs' is kept; did you mean 'octaves'?"));
}

void expectErrors(const std::string& text, const std::vector<std::string>& wanted) {
  const auto material = parseMaterial(text, "f.json", test::nodes());
  ASSERT_FALSE(material) << text;
  EXPECT_EQ(material.diagnostics().size(), wanted.size()) << test::texts(material.diagnostics());
  for (const std::string& want : wanted) EXPECT_THAT(test::texts(material.diagnostics()), HasSubstr(want));
}

TEST(MaterialJson, EveryFaultIsReportedAtOnceAtItsLine) {
  expectErrors(R"({"glint": "material", "version": 1,
    "model": 5,
    "nodes": {
      "a b": {"kind": "add"},
      "b": {"inputs": {}},
      "c": {"kind": 7},
      "d": {"kind": "add", "inputs": {"a": "nodot",
         "b": null}},
      "e": []
    },
    "layout": {"x": [1]},
    "modelParameters": {"gamma": "high"}})",
               {"f.json:2: 'model' must be a string, not a number", "f.json:4: 'a b' is no node id",
                "f.json:5: node 'b' has no 'kind'", "f.json:6: 'kind' must be a string",
                "f.json:7: node 'd' pin 'a': 'nodot' is no wire", "f.json:8: node 'd' pin 'b' must be a constant",
                "f.json:9: node 'e' must be an object", "f.json:11: layout of 'x' must be [x, y]",
                "f.json:12: model parameter 'gamma'"});
}

TEST(MaterialJson, WhatIsNoMaterialIsSaidSo) {
  expectErrors("[]", {"f.json:1: is an array, not a material"});
  expectErrors("{}", {"\"glint\": \"material\" is missing"});
  expectErrors(R"({"glint": "materal", "version": 1})", {"did you mean 'material'?"});
  expectErrors(R"({"glint": "material"})", {"'version' is missing"});
  expectErrors(R"({"glint": "material", "version": 9})", {"newer than this program"});
  expectErrors(R"({"glint": "material", "version": 1.5})", {"whole number"});
  expectErrors("{\"glint\": ", {"not valid JSON"});
  expectErrors("", {"not valid JSON"});
}

TEST(MaterialJson, HugeAndDeepFilesAreRefusedFast) {
  expectErrors(std::string(200000, '{'), {"not valid JSON"});
  std::string deep = R"({"glint": "material", "version": 1, "x": )";
  expectErrors(deep + std::string(100000, '['), {"nested deeper than"});
  std::string many = R"({"glint": "material", "version": 1, "nodes": {)";
  for (size_t i = 0; i <= kMostNodes; ++i) many += fmt::format("{}\"n{}\": {{\"kind\": \"add\"}}", i ? "," : "", i);
  expectErrors(many + "}}", {"more than the 20000 that fit"});
  expectErrors(std::string(kLargestMaterialFile + 1, ' '), {"more than the"});
}

TEST(MaterialJson, FilesAreWrittenWhole) {
  const std::filesystem::path folder = std::filesystem::path(GLINT_TESTS_OUT) / "material_json";
  std::filesystem::create_directories(folder);
  Material material = newMaterial("written", "burley");
  material.modelParameters["gamma"] = Value::scalar(2);
  ASSERT_TRUE(writeMaterial(folder / "written.json", material).empty());
  EXPECT_EQ(material.file, folder / "written.json");
  const auto back = readMaterial(folder / "written.json", test::nodes());
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, material);
  EXPECT_FALSE(readMaterial(folder / "missing.json", test::nodes()));
  EXPECT_FALSE(readMaterial(folder, test::nodes()));
}

TEST(MaterialJson, AClipIsNoMaterialAndTheReverse) {
  EXPECT_FALSE(parseClip(materialText(newMaterial("m")), test::nodes()));
  EXPECT_FALSE(parseClip("some text from elsewhere", test::nodes()));
  EXPECT_FALSE(parseClip(R"({"glint": "clip"})", test::nodes()));
  EXPECT_FALSE(parseMaterial(clipText({}), "f.json", test::nodes()));
}

// Bytes and tokens of the shipped files, changed at random: every outcome is a material or diagnostics with a place,
// and a material goes through the validator and the compiler.
TEST(MaterialJson, MutatedFilesGiveMaterialsOrDiagnostics) {
  std::vector<std::string> seeds;
  for (const std::string& name : libraryMaterialNames()) seeds.push_back(*shipped::read("materials/library/" + name + ".json"));
  for (const std::string& path : shipped::list("materials/functions", ".json")) seeds.push_back(*shipped::read(path));
  const std::vector<std::string> tokens = {"{", "}", "[", "]", ",", ":", "null", "true", "-1", "1e38", "1e999",
                                           "\"output.attributes\"", "\"layer\"", "\"kind\"", "\"\\u0000\"", "{}",
                                           "\"../../etc/passwd\"", "\"function\": \"layer-rust\"", "99999999999999999999"};
  std::mt19937 random(7);
  int good = 0, compiled = 0;
  for (int i = 0; i < 10000; ++i) {
    std::string text = seeds[random() % seeds.size()];
    for (unsigned n = random() % 4 + 1; n > 0; --n) {
      const size_t at = random() % text.size();
      switch (random() % 8) {
        case 0: text[at] = static_cast<char>(random() % 256); break;
        case 1: text.erase(at, random() % 20); break;
        case 2: text.insert(at, tokens[random() % tokens.size()]); break;
        case 3: text.insert(at, text.substr(random() % text.size(), random() % 60)); break;
        case 4:
        case 5:
        case 6: {  // one string for another: wires, kinds and settings that exist, in the wrong places
          const auto quoted = [&](size_t from) {
            const size_t open = text.find('"', from), close = open == text.npos ? open : text.find('"', open + 1);
            return std::pair(open, close == text.npos ? 0 : close - open + 1);
          };
          const auto [a, aSize] = quoted(at);
          const auto [b, bSize] = quoted(random() % text.size());
          if (aSize && bSize) text.replace(a, aSize, text.substr(b, bSize));
          break;
        }
        default: text.resize(at); break;
      }
      if (text.empty()) text = " ";
    }
    Diagnostics warnings;
    const auto material = parseMaterial(text, "f.json", test::nodes(), &warnings);
    if (!material) {
      ASSERT_FALSE(material.diagnostics().empty());
      for (const Diagnostic& d : material.diagnostics()) ASSERT_THAT(d.place, HasSubstr("f.json"));
      continue;
    }
    ++good;
    const std::string written = materialText(*material);
    const auto again = parseMaterial(written, "f.json", test::nodes());
    ASSERT_TRUE(again) << written;
    ASSERT_EQ(materialText(*again), written);
    if (material->kind == DocumentKind::Material) compiled += test::compile(*material).ok();
  }
  EXPECT_GT(good, 400);
  EXPECT_GT(compiled, 50);
}

}  // namespace
}  // namespace glint
