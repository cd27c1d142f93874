// Every term and every shipped model against exact numbers, through the GLSL that draws.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "materials/model_registry.h"
#include "renderer/gl/context.h"
#include "renderer/model_integrals.h"
#include "renderer/model_probe.h"

namespace glint {
namespace {

using nlohmann::json;

// On Mesa all are within 1e-5 and 2e-6. GLSL asks 3 + 2 |x| units in the last place of exp2, so that a
// distribution's far tail may lose a little more elsewhere.
constexpr double kTranscendental = 5e-5;
constexpr double kPlain = 5e-6;

const json& numbers() {
  static const json document = json::parse(std::ifstream(GLINT_TESTS_DIR "/data/model_numbers.json"));
  return document;
}

ProbePoint pointOf(const json& row) {
  ProbePoint p = ProbePoint::cosines(row[2], row[3], row[4], row[5]);
  p.roughness = row[0];
  p.F0 = glm::vec3(row[1].get<float>());
  p.diffuseColor = glm::vec3(1);
  return p;
}

std::vector<ProbePoint> points() {
  std::vector<ProbePoint> result;
  for (const json& row : numbers()["points"]) result.push_back(pointOf(row));
  return result;
}

// The values of one column of the document against those measured. The file's tolerance allows for NoH in single
// precision, which the terms do not use: theirs must be far better.
void compare(const std::string& name, const std::vector<double>& measured, double tolerance) {
  const json& expected = numbers()["terms"][name]["values"];
  const json& allowed = numbers()["terms"][name]["tolerance"];
  ASSERT_EQ(expected.size(), measured.size()) << name;
  for (size_t i = 0; i < measured.size(); ++i) {
    const double exact = expected[i];
    EXPECT_LE(std::abs(measured[i] - exact), std::max(std::min(allowed[i].get<double>(), tolerance), kPlain) * exact + 1e-12)
        << name << " at " << numbers()["points"][i] << ": " << measured[i] << " instead of " << exact;
  }
}

void checkTerms(gl::Backend backend) {
  auto context = gl::Context::create({.backend = backend});
  ASSERT_TRUE(context) << context.diagnostics()[0].text();
  const std::vector<Term> library = terms();
  auto probe = ModelProbe::ofTerms(library);
  ASSERT_TRUE(probe) << probe.diagnostics()[0].text();
  const std::vector<glm::vec4> values = probe->evaluate(points());
  int compared = 0;
  for (size_t t = 0; t < library.size(); ++t) {
    if (!numbers()["terms"].contains(library[t].function())) continue;
    ++compared;
    std::vector<double> column;
    for (size_t i = t; i < values.size(); i += library.size()) column.push_back(values[i].r);
    compare(library[t].function(), column, library[t].kind == TermKind::D ? kTranscendental : kPlain);
  }
  EXPECT_EQ(compared, 21);  // all of the file's D, V and F have their term
}

TEST(TermNumbers, OnEgl) { checkTerms(gl::Backend::Egl); }
TEST(TermNumbers, OnOsMesa) { checkTerms(gl::Backend::OsMesa); }

class ModelNumbers : public testing::Test {
 protected:
  void SetUp() override {
    auto created = gl::Context::create({.backend = gl::Backend::Egl});
    ASSERT_TRUE(created) << created.diagnostics()[0].text();
    context_ = std::move(*created);
  }
  ModelProbe probe(const std::string& id) {
    const ModelRegistry registry;
    auto made = ModelProbe::ofModel(**registry.get(id));
    GLINT_CHECK(made.ok(), "{}", made.diagnostics()[0].text());
    return std::move(*made);
  }
  ModelIntegrals integrals(const std::string& id) {
    auto made = ModelIntegrals::of(**ModelRegistry().get(id));
    GLINT_CHECK(made.ok(), "{}", made.diagnostics()[0].text());
    return std::move(*made);
  }
  std::unique_ptr<gl::Context> context_;
};

struct Known {
  const char* truth;
  const char* id;
  bool analyticLight;
};
const Known kKnown[] = {
    {"thesis_ggx", "ggx", true},        {"thesis_blinn", "blinn-phong", true}, {"thesis_cook", "cook-torrance", true},
    {"thesis_burley", "burley", true},  {"ue4_2013", "ue4-2013", true},        {"ue4_ibl", "ue4-2013", false},
};

TEST_F(ModelNumbers, WholeModels) {
  for (const Known& known : kKnown) {
    std::vector<ProbePoint> where = points();
    for (ProbePoint& p : where) p.analyticLight = known.analyticLight;
    const std::vector<glm::vec4> values = probe(known.id).evaluate(where);
    std::vector<double> specular;
    for (size_t i = 0; i < where.size(); ++i) {
      specular.push_back(values[2 * i].g);
      EXPECT_NEAR(values[2 * i + 1].g, 1 / 3.14159265, 1e-6);
    }
    compare(std::string("f_") + known.truth, specular, kTranscendental);
  }
}

TEST_F(ModelNumbers, DirectionalAlbedo) {
  for (const Known& known : kKnown) {
    std::vector<IntegralQuery> queries;
    const json& rows = numbers()["albedo"][known.truth];
    for (const json& row : rows) queries.push_back({row[0], row[1], known.analyticLight});
    const std::vector<ModelIntegral> measured = integrals(known.id).evaluate(queries);
    for (size_t i = 0; i < queries.size(); ++i)
      EXPECT_NEAR(measured[i].specular.g, rows[i][2].get<double>(), 2e-3 * std::max(1.0, rows[i][2].get<double>()))
          << known.truth << " at " << rows[i];
  }
}

TEST_F(ModelNumbers, DistributionsIntegrateToOne) {
  std::vector<IntegralQuery> queries;
  for (const float roughness : {0.05f, 0.1f, 0.2f, 0.35f, 0.5f, 0.7f, 0.9f, 1.f}) queries.push_back({roughness, 0.5f, true});
  for (const ModelPtr& model : ModelRegistry().all()) {
    if (!model->definesD && model->termD.empty()) continue;
    for (const ModelIntegral& integral : integrals(model->id).evaluate(queries))
      EXPECT_NEAR(integral.distribution, 1, 1e-3) << model->id;
  }
}

// Both limits of GTR are 0/0 as printed: gamma 1 must meet its neighbours, and alpha 1 is 1/pi for every gamma.
TEST_F(ModelNumbers, GtrIsSmoothAtItsLimits) {
  ModelProbe burley = probe("burley");
  const auto D = [&](float gamma, float roughness, double NoH) {
    burley.set("gamma", Value::scalar(gamma));
    ProbePoint p = ProbePoint::cosines(NoH, NoH, NoH, 1);
    p.roughness = roughness;
    const ProbePoint all[] = {p};
    return static_cast<double>(burley.evaluate(all)[0].a);
  };
  for (const float roughness : {0.05f, 0.3f, 0.7f, 0.99f, 0.9999f}) {
    const double below = D(0.9999f, roughness, 0.9), at = D(1, roughness, 0.9), above = D(1.0001f, roughness, 0.9);
    EXPECT_NEAR(at, 0.5 * (below + above), 1e-4 * at) << roughness;
  }
  for (const float gamma : {1.f, 1.00001f, 1.5f, 2.f, 4.f})
    EXPECT_NEAR(D(gamma, 1, 0.6), 1 / 3.14159265, 2e-6) << gamma;
  ProbePoint p = ProbePoint::cosines(0.9, 0.9, 0.9, 1);
  const ProbePoint all[] = {p};
  EXPECT_NEAR(D(2, 0.5f, 0.9), probe("ggx").evaluate(all)[0].a, 1e-4) << "gamma 2 is GGX";
}

TEST_F(ModelNumbers, DiffuseTerms) {
  std::vector<Term> diffuse;
  for (const Term& term : terms())
    if (term.name == "Burley" || term.name == "OrenNayar") diffuse.push_back(term);
  ASSERT_EQ(diffuse.size(), 2u);
  auto probe = ModelProbe::ofTerms(diffuse);
  ASSERT_TRUE(probe);
  for (const json& row : numbers()["diffuse"]) {
    ProbePoint p = ProbePoint::cosines(row[1], row[2], 1, std::sqrt((1 + row[3].get<double>()) / 2));
    p.roughness = row[0];
    p.diffuseColor = glm::vec3(1);
    const ProbePoint all[] = {p};
    const std::vector<glm::vec4> values = probe->evaluate(all);
    EXPECT_NEAR(values[0].r, row[4].get<double>(), 1e-6) << row;
    EXPECT_NEAR(values[1].r, row[5].get<double>(), 1e-6) << row;
  }
}

// Fresnel at its ends: no NaN for a perfect mirror (whose index is infinite) or a medium like air (index 1).
TEST_F(ModelNumbers, FresnelAtItsEnds) {
  std::vector<Term> fresnel;
  for (const Term& term : terms())
    if (term.kind == TermKind::F) fresnel.push_back(term);
  auto probe = ModelProbe::ofTerms(fresnel);
  ASSERT_TRUE(probe);
  std::vector<ProbePoint> where;
  for (const float F0 : {0.f, 1e-6f, 0.04f, 0.9f, 1.f})
    for (const float VoH : {0.f, 1e-4f, 0.5f, 1.f}) {
      where.emplace_back();
      where.back().VoH = VoH;
      where.back().F0 = glm::vec3(F0);
    }
  const std::vector<glm::vec4> values = probe->evaluate(where);
  for (size_t i = 0; i < values.size(); ++i) {
    const ProbePoint& p = where[i / fresnel.size()];
    EXPECT_TRUE(values[i].g >= 0 && values[i].g <= 1.000001f)
        << fresnel[i % fresnel.size()].name << " F0 " << p.F0.g << " VoH " << p.VoH << ": " << values[i].g;
    if (p.F0.g == 1 && p.VoH > 0) {
      EXPECT_NEAR(values[i].g, 1, 1e-5) << fresnel[i % fresnel.size()].name;
    }
  }
}

}  // namespace
}  // namespace glint
