// What Glint ships: every node, function and material is whole, canonical and compiles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "materials/function_library.h"
#include "materials/graph_compile.h"
#include "materials/graph_validate.h"
#include "materials/material_json.h"
#include "materials/material_library.h"
#include "materials/model_registry.h"
#include "shaders/shipped_files.h"
#include "tests/materials/support/graphs.h"

namespace glint {
namespace {

using testing::HasSubstr;

TEST(ShippedNodes, AllLoad) {
  EXPECT_EQ(test::texts(test::nodes().problems()), "");
  EXPECT_GE(test::nodes().all().size(), 80u);
}

TEST(ShippedNodes, EveryOneSaysWhatItIs) {
  for (const NodeKind* kind : test::nodes().all()) {
    EXPECT_FALSE(kind->title.empty()) << kind->id;
    EXPECT_FALSE(kind->doc.empty()) << kind->id;
    EXPECT_FALSE(kind->doc.ends_with('.')) << kind->id << ": one clause";
    EXPECT_FALSE(kind->category.empty()) << kind->id;
    if (!kind->file.empty()) {
      EXPECT_EQ(kind->file, "shaders/nodes/" + kind->id + ".glsl");
    }
    for (const Pin& pin : kind->inputs)
      for (int i = 0; i < componentCount(pin.standard.type); ++i) {
        EXPECT_LE(pin.minimum, pin.standard.v[i]) << kind->id << "." << pin.name;
        EXPECT_GE(pin.maximum, pin.standard.v[i]) << kind->id << "." << pin.name;
      }
  }
}

// One material for each kind and each type its numeric pins can have, which shows all its outputs.
TEST(ShippedNodes, EveryOneCompilesForEveryType) {
  int count = 0;
  for (const NodeKind* kind : test::nodes().all()) {
    if (kind->builtin != Builtin::None) continue;
    for (const ValueType type : {ValueType::Float, ValueType::Vec2, ValueType::Vec3, ValueType::Vec4}) {
      const Material material = test::materialOf(*kind, type);
      const auto compiled = test::compile(material);
      ASSERT_TRUE(compiled) << kind->id << ": " << test::texts(compiled.diagnostics());
      EXPECT_THAT(compiled->glsl, HasSubstr(kind->function + "(")) << kind->id;
      ++count;
    }
  }
  EXPECT_GT(count, 200);
}

TEST(Library, EveryMaterialCompilesWithoutAWord) {
  const auto names = libraryMaterialNames();
  EXPECT_GE(names.size(), 25u);
  const ModelRegistry models;
  for (const std::string& name : names) {
    Diagnostics warnings;
    const auto material = loadMaterial(name, test::nodes(), &warnings);
    ASSERT_TRUE(material) << test::texts(material.diagnostics());
    EXPECT_EQ(material->name, name);
    EXPECT_FALSE(material->doc.empty()) << name;
    const ModelPtr model = models.find(material->model);
    ASSERT_TRUE(model) << name << " wants " << material->model;
    const auto compiled = compileMaterial(*material, *model, test::nodes(), test::functions(), {}, &warnings);
    ASSERT_TRUE(compiled) << test::texts(compiled.diagnostics());
    EXPECT_EQ(test::texts(warnings), "") << name;
  }
}

TEST(Library, EveryFunctionIsValidAndCanonical) {
  for (const std::string& name : test::functions().names()) {
    const auto function = test::functions().find(name, {});
    ASSERT_TRUE(function) << test::texts(function.diagnostics());
    const GraphContext context{test::nodes(), &test::ggx(), &test::functions()};
    EXPECT_EQ(test::texts(validate(**function, context)), "");
    const std::string path = "materials/functions/" + name + ".json";
    EXPECT_EQ(materialText(**function), *shipped::read(path)) << "rewrite " << path;
  }
}

TEST(Library, EveryFileIsAsGlintWouldWriteIt) {
  for (const std::string& name : libraryMaterialNames()) {
    const auto material = loadMaterial(name, test::nodes());
    ASSERT_TRUE(material);
    const std::string path = "materials/library/" + name + ".json";
    EXPECT_EQ(materialText(*material), *shipped::read(path)) << "rewrite " << path;
    for (const auto& [id, node] : material->nodes) EXPECT_TRUE(material->layout.count(id)) << name << " " << id;
  }
}

TEST(Library, PlainMaterialsShareOneProgram) {
  std::set<uint64_t> programs;
  for (const char* name : {"aluminium", "gold", "black", "plastic", "snow"})
    programs.insert(test::compile(*loadMaterial(name, test::nodes()))->hash);
  EXPECT_EQ(programs.size(), 1u);
}

TEST(Library, TheThesisMaterialsHaveItsValues) {
  const auto black = test::compile(*loadMaterial("black", test::nodes()));
  ASSERT_TRUE(black);
  EXPECT_EQ(const_cast<CompiledMaterial&>(*black).uniform("Specular")->value, Value::scalar(0.5f));
  EXPECT_EQ(const_cast<CompiledMaterial&>(*black).uniform("Base color")->value, Value::color(0, 0, 0));
  EXPECT_TRUE(loadMaterial("rubber", test::nodes()));
  EXPECT_TRUE(loadMaterial("aluminium", test::nodes()));
}

TEST(Library, UnknownNamesNameTheNearest) {
  const auto material = loadMaterial("aluminum", test::nodes());
  ASSERT_FALSE(material);
  EXPECT_THAT(material.diagnostics()[0].hint, HasSubstr("'aluminium'"));
  EXPECT_FALSE(loadMaterial("no/such/file.json", test::nodes()));
  EXPECT_FALSE(loadMaterial("../../etc/passwd", test::nodes()));
  EXPECT_FALSE(loadMaterial("", test::nodes()));
}

}  // namespace
}  // namespace glint
