// The mixer: models made of any three or four terms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "materials/model_mix.h"
#include "materials/model_registry.h"
#include "materials/terms.h"
#include "renderer/gl/context.h"
#include "renderer/model_probe.h"

namespace glint {
namespace {

using testing::HasSubstr;

std::string faults(std::string_view id) {
  const auto model = mixModel(id);
  EXPECT_FALSE(model) << id;
  std::string all;
  if (!model)
    for (const Diagnostic& d : model.diagnostics()) all += d.text() + "\n";
  return all;
}

TEST(Mix, IsNamedByWhatItIsMadeOf) {
  const auto model = mixModel("GGX * SmithGGX*Schlick*Lambert");
  ASSERT_TRUE(model);
  EXPECT_EQ(model->id, "GGX*SmithGGX*Schlick") << "Lambert goes without saying";
  EXPECT_EQ(model->termD, "GGX");
  EXPECT_EQ(model->termDiffuse, "Lambert");
  EXPECT_EQ(mixModel("Blinn*SmithBeckmann*None*EON")->id, "Blinn*SmithBeckmann*None*EON");
}

TEST(Mix, HasTheParametersOfItsTerms) {
  const auto model = mixModel("GTR*SmithGGX*Schlick");
  ASSERT_TRUE(model);
  ASSERT_EQ(model->parameters.size(), 1u);
  EXPECT_EQ(model->parameters[0].name, "gamma");
  EXPECT_EQ(model->parameters[0].slot, 0) << "a pin";
  const auto both = mixModel("GGXaniso*SmithGGXCorrelatedAniso*Schlick");
  ASSERT_TRUE(both);
  EXPECT_EQ(both->parameters.size(), 1u) << "one anisotropy for both";
}

TEST(Mix, BadInput) {
  EXPECT_THAT(faults("GGX*SmithGGX"), HasSubstr("mixes 2 terms, not three or four; write D*V*F"));
  EXPECT_THAT(faults("GGX*SmithGGX*Shlick"), HasSubstr("unknown F term 'Shlick'; did you mean 'Schlick'"));
  EXPECT_THAT(faults("*SmithGGX*Schlick"), HasSubstr("unknown D term ''"));
  EXPECT_THAT(faults("GGX*SmithGGX*Schlick*Lambert*Lambert"), HasSubstr("mixes 5 terms"));
}

// Every pair of D and V, with each F: they all are models, and each is the product of its terms.
TEST(Mix, AnyOfThemIsTheProductOfItsTerms) {
  auto context = gl::Context::create({.backend = gl::Backend::Egl});
  ASSERT_TRUE(context);
  ProbePoint p = ProbePoint::at(glm::normalize(glm::dvec3(0.5, 0.3, 0.7)), glm::normalize(glm::dvec3(-0.4, 0.2, 0.8)));
  p.roughness = 0.4f;
  p.fromDirections = true;
  p.a = glm::vec4(0.5f);
  const ProbePoint points[] = {p};
  std::vector<Term> all = terms();
  std::erase_if(all, [](const Term& t) { return t.ofOwnD; });  // has no value without a D: own_smith_test.cpp
  const auto values = ModelProbe::ofTerms(all)->evaluate(points);
  const auto value = [&](TermKind kind, const std::string& name) {
    for (size_t i = 0; i < all.size(); ++i)
      if (all[i].kind == kind && all[i].name == name) return values[i].r;
    return -1.f;
  };
  const ModelRegistry registry;
  const auto names = [&](TermKind kind) {
    std::vector<std::string> found;
    for (const Term& t : all)
      if (t.kind == kind) found.push_back(t.name);
    return found;
  };
  const std::vector<std::string> Ds = names(TermKind::D), Vs = names(TermKind::V), Fs = names(TermKind::F);
  for (size_t i = 0; i < std::max(Ds.size(), Vs.size()); ++i) {
    const std::string D = Ds[i % Ds.size()], V = Vs[i % Vs.size()], F = Fs[i % Fs.size()];
    const auto model = registry.get(D + "*" + V + "*" + F);
    ASSERT_TRUE(model);
    auto probe = ModelProbe::ofModel(**model);
    ASSERT_TRUE(probe) << probe.diagnostics()[0].text();
    for (const char* parameter : {"gamma", "anisotropy"})
      if ((*model)->parameter(parameter)) probe->set(parameter, Value::scalar(0.5f));
    const float product = value(TermKind::D, D) * value(TermKind::V, V) * value(TermKind::F, F);
    EXPECT_NEAR(probe->evaluate(points)[0].r, product, 1e-5f * product) << (*model)->id;
  }
}

TEST(Mix, SavedAsAPluginItIsTheSameModel) {
  auto mix = parseModelMix("GTR*SmithGGXCorrelated*CookTorrance*Burley");
  ASSERT_TRUE(mix);
  // A parameter that was turned is so in the plugin.
  const auto free = parseModelMix("GTR*SmithGGX*Schlick*Burley");
  ASSERT_TRUE(free);
  const auto turned = parseModel("turned.glsl", pluginOfMix(*free, "turned", {{"gamma", 3.977f}}));
  ASSERT_TRUE(turned);
  ASSERT_NE(turned->parameter("gamma"), nullptr);
  EXPECT_FLOAT_EQ(turned->parameter("gamma")->standard.v[0], 3.977f);
  const std::string text = pluginOfMix(*mix, "my-mix");
  const auto plugin = parseModel("my-mix.glsl", text);
  ASSERT_TRUE(plugin) << plugin.diagnostics()[0].text();
  EXPECT_EQ(plugin->id, "my-mix");
  const auto made = mixModel(mix->id());
  ASSERT_TRUE(made);
  EXPECT_EQ(plugin->termD, made->termD);
  EXPECT_EQ(plugin->termV, made->termV);
  EXPECT_EQ(plugin->termF, made->termF);
  EXPECT_EQ(plugin->termDiffuse, made->termDiffuse);
  EXPECT_EQ(plugin->parameters.size(), made->parameters.size());
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 30) << text;
}

}  // namespace
}  // namespace glint
