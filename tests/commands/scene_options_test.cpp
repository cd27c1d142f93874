// From the words of options to values: every fault, each at its option.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "app/scene_options.h"
#include "renderer/comparison.h"

namespace glint {
namespace {

Arguments given(std::map<std::string, std::vector<std::string>> values) {
  Arguments arguments;
  arguments.values = std::move(values);
  return arguments;
}

// The place and words of the only fault.
void expectFault(const std::string& option, const std::string& value, const std::string& words) {
  const auto options = parseSceneOptions(given({{option, {value}}}));
  ASSERT_FALSE(options) << option << " " << value;
  ASSERT_EQ(options.diagnostics().size(), 1u) << option << " " << value;
  EXPECT_EQ(options.diagnostics()[0].place, "--" + option);
  EXPECT_THAT(options.diagnostics()[0].text(), testing::HasSubstr(words));
}

TEST(SceneOptions, DefaultsAndValues) {
  const auto standard = parseSceneOptions(given({}));
  ASSERT_TRUE(standard);
  EXPECT_EQ(standard->environment, "studio");
  EXPECT_EQ(standard->render.view, "lit");
  EXPECT_EQ(standard->render.samples, 8);
  EXPECT_FALSE(standard->render.specularAntialiasing) << "comparisons stay honest";
  EXPECT_TRUE(parseSceneOptions(given({{"specular-aa", {""}}}))->render.specularAntialiasing);
  const auto options = parseSceneOptions(given({{"size", {"64x32"}},
                                                {"env-rotation", {"90"}},
                                                {"exposure", {"-1.5"}},
                                                {"tonemap", {"agx"}},
                                                {"background", {"0.5/0.25/1"}},
                                                {"model", {"burley:gamma=2"}},
                                                {"set", {"roughness=0.2", "baseColor=0.8/0.1/0.1"}},
                                                {"camera", {"eye=0/1/5,target=0/1/0,fov=35"}}}));
  ASSERT_TRUE(options) << options.diagnostics()[0].text();
  EXPECT_EQ(options->size, glm::ivec2(64, 32));
  EXPECT_FLOAT_EQ(options->environmentRotation, std::numbers::pi_v<float> / 2);
  EXPECT_EQ(options->render.exposure, -1.5f);
  EXPECT_EQ(options->render.tonemap, Tonemap::AgX);
  EXPECT_EQ(options->render.background, Background::Color);
  EXPECT_EQ(options->render.backgroundColor, glm::vec3(0.5f, 0.25f, 1));
  EXPECT_EQ(options->model->parameters.at(0).text, "2");
  EXPECT_EQ(options->settings.at(1).name, "baseColor");
  Camera camera;
  options->camera.apply(camera);
  EXPECT_EQ(camera.eye, glm::vec3(0, 1, 5));
  EXPECT_FLOAT_EQ(camera.fovY, glm::radians(35.f));
}

TEST(SceneOptions, LightsHaveTheUnitsOfTheContract) {
  const auto point = parseLight("point:pos=0/2/1,lumens=1256.6370614,radius=7,color=1/0.5/0.25");
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->candela, 100, 1e-3);  // lumens / 4 pi
  EXPECT_EQ(point->position, glm::vec3(0, 2, 1));
  EXPECT_EQ(point->radius, 7);
  EXPECT_EQ(point->color, glm::vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(parseLight("point:pos=0/0/1,cd=3")->candela, 3);
  const auto sun = parseLight("directional:dir=0/3/4,lux=2");
  ASSERT_TRUE(sun);
  EXPECT_NEAR(glm::distance(sun->direction, glm::vec3(0, 0.6f, 0.8f)), 0, 1e-6);
  EXPECT_EQ(sun->lux, 2);
  EXPECT_TRUE(sun->shadow);
  EXPECT_NEAR(glm::degrees(sun->angle), 0.53, 1e-3);
  const auto soft = parseLight("directional:dir=0/3/4,angle=5,shadow=off");
  ASSERT_TRUE(soft);
  EXPECT_NEAR(glm::degrees(soft->angle), 5, 1e-5);
  EXPECT_FALSE(soft->shadow);
}

TEST(SceneOptions, EveryFaultIsReportedAtItsOption) {
  expectFault("size", "0x10", "each side may be 1 to 8192");
  expectFault("size", "100000x10", "each side may be 1 to 8192");
  expectFault("size", "10", "WIDTHxHEIGHT");
  expectFault("size", "1e2x-3", "each side");
  expectFault("size", "nanxnan", "not a size");
  expectFault("exposure", "bright", "not a number");
  expectFault("exposure", "inf", "not a number");
  expectFault("samples", "0", "1 to 1024");
  expectFault("samples", "2.5", "whole number");
  expectFault("env-intensity", "-1", "out of range");
  expectFault("tonemap", "asec", "did you mean 'aces'?");
  expectFault("view", "basecolour", "did you mean 'baseColor'?");
  expectFault("background", "nothing", "env, blur, none");
  expectFault("camera", "eye=1/2", "not a vector");
  expectFault("camera", "eyes=1/2/3", "did you mean 'eye'?");
  expectFault("camera", "fov=30,ortho=2", "exclude");
  expectFault("camera", "eye=0/0/0", "same point");
  expectFault("light", "disk:pos=1/1/1", "unknown kind of light");
  expectFault("light", "sphere:pos=1/1/1,size=-1", "out of range");
  expectFault("light", "sphere:pos=1/1/1,size=0,nits=5", "no luminance");
  expectFault("light", "sphere:pos=1/1/1,length=1", "length");
  expectFault("light", "tube:from=0/1/0", "from and to");
  expectFault("light", "tube:from=0/1/0,to=1/1/0,pos=1/1/1", "from and to");
  expectFault("light", "spot:pos=0/1/0,to=0/1/0", "where the light is");
  expectFault("light", "spot:pos=0/1/0,inner=40,outer=30", "inner is larger");
  expectFault("light", "spot:pos=0/1/0,outer=100", "out of range");
  expectFault("light", "rectangle:pos=0/1/0,cd=1,nits=2", "give one of them");
  expectFault("light", "spot:pos=0/1/0,shadow=maybe", "write on or off");
  expectFault("light", "directional:dir=0/1/0,angle=90", "out of range");
  expectFault("shadows", "contacts", "did you mean 'contact'?");
  expectFault("occlusion", "screens", "did you mean 'screen'?");
  expectFault("ground", "mate", "did you mean 'matte'?");
  expectFault("area-lights", "nots", "did you mean 'notes'?");
  expectFault("light", "point:cd=1", "needs its pos");
  expectFault("light", "directional", "needs its dir");
  expectFault("light", "directional:dir=0/0/0", "no length");
  expectFault("light", "point:pos=1/1/1,lumens=1,cd=1", "give one of them");
  expectFault("light", "point:pos=1/1/1,lumen=1", "did you mean 'lumens'?");
  expectFault("light", "point:pos=1/1/1,pos=1/1/1", "twice");
  expectFault("light", "point:pos=1/1/1,cd=-4", "out of range");
  expectFault("set", "roughness", "NAME=VALUE");
  expectFault("model", "ggx,burley", "2 models");
  for (const char* bad : {"0", "65537", "-1"}) expectFault("reference", bad, "out of range");
  expectFault("reference", "2.5", "whole");
}

TEST(SceneOptions, FaultsComeTogether) {
  const auto options = parseSceneOptions(given({{"size", {"0x0"}}, {"tonemap", {"no"}}, {"light", {"moon:", "point:cd=1"}}}));
  ASSERT_FALSE(options);
  EXPECT_EQ(options.diagnostics().size(), 4u);
}

TEST(ModelList, ParametersBelongToTheModelOnTheirLeft) {
  const auto models = parseModelList("burley:gamma=1,other=2,ggx,burley:gamma=3", "--models");
  ASSERT_TRUE(models);
  ASSERT_EQ(models->size(), 3u);
  EXPECT_EQ(models->at(0).parameters.size(), 2u);
  EXPECT_EQ(models->at(1).id, "ggx");
  EXPECT_EQ(models->at(2).parameters.at(0).text, "3");
  EXPECT_FALSE(parseModelList("gamma=1,ggx", "--models"));
  EXPECT_FALSE(parseModelList("ggx,,burley", "--models"));
  EXPECT_FALSE(parseModelList("", "--models"));
}

TEST(Sweep, ValuesIncludeBothEnds) {
  const auto sweep = parseSweep("roughness=0..1:5", "--sweep");
  ASSERT_TRUE(sweep);
  EXPECT_EQ(sweep->name, "roughness");
  EXPECT_EQ(sweep->value(0), 0);
  EXPECT_EQ(sweep->value(4), 1);
  EXPECT_EQ(sweep->title(1), "0.25");
  EXPECT_EQ(parseSweep("x=-1.5..-0.5:1", "")->value(0), -1.5f);
  for (const char* bad : {"", "roughness", "roughness=0..1", "=0..1:3", "r=0..1:0", "r=0..1:65", "r=0..1:2.5", "r=0.1:3", "r=a..b:3", "r=0..inf:3", "r:3=0..1"})
    EXPECT_FALSE(parseSweep(bad, "--sweep")) << bad;
}

TEST(CellGrid, RowsGoDownAndRectanglesCountFromTheBottom) {
  CellGrid grid{2, 3, 100, 10, 20};
  EXPECT_EQ(grid.size(), glm::ivec2(320, 220));
  EXPECT_EQ(grid.rectangle(0, 0), glm::ivec4(0, 120, 100, 100));
  EXPECT_EQ(grid.rectangle(1, 2), glm::ivec4(220, 0, 100, 100));
}

}  // namespace
}  // namespace glint
