#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/environment.h"
#include "renderer/environment_lighting.h"
#include "renderer/model_integrals.h"
#include "renderer/renderer.h"
#include "shaders/shipped_files.h"
#include "tests/support/program.h"
#include "tests/support/renderer_fixture.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

class RendererTest : public test::RendererFixture<RendererTest> {
 protected:
  static Scene sphereScene(const std::string& model, const test::Look& look) {
    Scene scene;
    scene.materials.push_back(test::material(models->find(model), look));
    scene.instances.push_back({sphere, glm::mat4(1), 0});
    return scene;
  }
  static Camera orthographic() {
    Camera camera;
    camera.orthoHeight = 2.5f;
    return camera;
  }
  static ImageF linear(const Scene& scene, const Camera& camera, int side = 64, RenderSettings settings = {}) {
    const View view{&scene, camera, {0, 0, side, side}};
    return renderer->linear(std::span(&view, 1), {side, side}, settings);
  }
  static float center(const ImageF& image) { return image.at(image.width / 2, image.height / 2)[0]; }
};

// product.md 1: a white Lambert surface facing pi lux shows 1 at exposure 0.
TEST_F(RendererTest, WhiteLambertFacingPiLuxShowsOne) {
  Scene scene = sphereScene("blinn-phong", {.baseColor = glm::vec3(1), .roughness = 0.7f, .specular = 0});
  scene.lights.push_back({.kind = LightKind::Directional, .direction = {0, 0, 1}, .lux = 3.14159265f});
  EXPECT_NEAR(center(linear(scene, orthographic())), 1.0f, 5e-3f);
}

// Karis 2013, eq. 9.
TEST_F(RendererTest, PointLightFollowsTheWindowedInverseSquare) {
  Scene scene = sphereScene("blinn-phong", {.baseColor = glm::vec3(1), .roughness = 0.7f, .specular = 0});
  for (const float distance : {0.5f, 1.0f, 3.0f, 7.9f, 8.5f}) {
    scene.lights = {{.kind = LightKind::Point, .position = {0, 0, 1 + distance}, .candela = 10, .radius = 8}};
    const float ratio = distance / 8;
    const float window = std::pow(std::clamp(1 - ratio * ratio * ratio * ratio, 0.0f, 1.0f), 2.0f);
    const float expected = 10 * window / (distance * distance + 1) / 3.14159265f;
    EXPECT_NEAR(center(linear(scene, orthographic())), expected, 0.01f * expected + 1e-4f) << distance;
  }
}

// A light list must not change what is drawn: many lights, each in view of few tiles, against their sum one by one.
TEST_F(RendererTest, ManyLightsAreTheSumOfEach) {
  Scene scene = sphereScene("ggx", {.baseColor = glm::vec3(0.6f), .roughness = 0.4f});
  std::vector<Light> lights;
  for (int i = 0; i < 20; ++i) {
    const float a = static_cast<float>(i) * 0.9f;
    lights.push_back({.kind = LightKind::Point, .position = {1.6f * std::cos(a), 1.6f * std::sin(a), 0.3f * static_cast<float>(i % 5)}, .candela = 2, .radius = 1.2f});
  }
  scene.lights = lights;
  const ImageF together = linear(scene, Camera{}, 96);
  ImageF sum(96, 96, 3);
  for (const Light& light : lights) {
    scene.lights = {light};
    const ImageF one = linear(scene, Camera{}, 96);
    for (size_t i = 0; i < sum.data.size(); ++i) sum.data[i] += one.data[i];
  }
  float brightest = 0;
  for (size_t i = 0; i < sum.data.size(); ++i) {
    brightest = std::max(brightest, sum.data[i]);
    ASSERT_NEAR(together.data[i], sum.data[i], 1e-3f * (1 + sum.data[i])) << i;
  }
  EXPECT_GT(brightest, 0.5f);
}

// White furnace, diffuse part: a white Lambert surface under light from everywhere reflects all of it.
TEST_F(RendererTest, WhiteDiffuseVanishesInTheFurnace) {
  Scene scene = sphereScene("blinn-phong", {.baseColor = glm::vec3(1), .roughness = 0.5f, .specular = 0});
  scene.environment = test::uniformEnvironment(1);
  const ImageF image = linear(scene, orthographic());
  EXPECT_NEAR(center(image), 1.0f, 0.02f);
  EXPECT_NEAR(image.at(2, 2)[0], 1.0f, 2e-3f) << "background";
}

// White furnace, specular part: a metal with F0 = 1 shows the model's directional albedo at n = v.
// physics.md 3: E(r = 1, nv = 1) of GGX is 1 - ln 2, of the thesis' Blinn-Phong .2688, of its Cook-Torrance .4534.
TEST_F(RendererTest, MetalInTheFurnaceShowsTheAlbedo) {
  const struct {
    const char* model;
    float albedo;
  } cases[] = {{"ggx", 0.30685f}, {"blinn-phong", 0.2688f}, {"cook-torrance", 0.4534f}, {"burley", 0.3069f}, {"ue4-2013", 0.3069f}};
  for (const auto& c : cases) {
    Scene scene = sphereScene(c.model, {.baseColor = glm::vec3(1), .metallic = 1, .roughness = 1});
    scene.environment = test::uniformEnvironment(1);
    EXPECT_NEAR(center(linear(scene, orthographic())), c.albedo, 4e-3f) << c.model;
  }
}

// The view of it takes only roughness and the model's parameters from the scene.
TEST_F(RendererTest, TheFurnaceViewIsAWhiteMetalInWhiteLight) {
  Scene scene = sphereScene("ggx", {.baseColor = {0.6f, 0.1f, 0.1f}, .metallic = 0, .roughness = 1, .specular = 0.2f});
  scene.lights = {{.kind = LightKind::Point, .position = {0, 0, 2}, .candela = 100}, {.kind = LightKind::Directional, .direction = {0, 0, 1}, .lux = 9}};
  RenderSettings settings;
  settings.view = kFurnaceView;
  const ImageF image = linear(scene, orthographic(), 64, settings);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(32, 32)[c], 0.30685f, 4e-3f);
  EXPECT_EQ(image.at(1, 1)[0], 1) << "the same white behind";
  scene.environment = test::uniformEnvironment(7);
  EXPECT_EQ(linear(scene, orthographic(), 64, settings).data, image.data);

  // The mean over a sphere that is seen in parallel is the average albedo.
  const View view{&scene, orthographic(), {0, 0, 64, 64}};
  const auto shares = renderer->furnaceShares(std::span(&view, 1), {64, 64}, false);
  ASSERT_EQ(shares.size(), 1u);
  const auto integrals = ModelIntegrals::of(*models->find("ggx"));
  ASSERT_TRUE(integrals);
  EXPECT_NEAR(shares[0].mean, integrals->averageAlbedo(1, false), 5e-3);
  EXPECT_NEAR(shares[0].least, 0.30685, 4e-3);
  EXPECT_LT(shares[0].most, 1);
  EXPECT_EQ(shares[0].extreme(), shares[0].least);
  EXPECT_NEAR(renderer->furnaceShares(std::span(&view, 1), {64, 64}, true)[0].extreme(), 1, 0.01) << "with all its bounces";
}

TEST_F(RendererTest, WhatKeepsItsEnergyVanishesInTheFurnace) {
  const auto sphereOf = [&](const std::string& f) {
    auto model = parseModel("m.glsl", "/*glint {\"id\": \"m\"} */\nvec3 specular(Shading s, Parameters p) { return s.F0 * " + f + " / kPi; }\n");
    EXPECT_TRUE(model);
    Scene scene;
    scene.materials.push_back(test::material(std::make_shared<const ShadingModel>(std::move(*model)), {}));
    scene.instances.push_back({sphere, glm::mat4(1), 0});
    return scene;
  };
  RenderSettings settings;
  settings.view = kFurnaceView;
  const Scene whole = sphereOf("1.0");
  for (const float v : linear(whole, orthographic(), 64, settings).data) ASSERT_NEAR(v, 1, 4e-3f);
  // One that gains some is seen too, although a display ends at 1.
  const Scene bright = sphereOf("1.5");
  EXPECT_NEAR(center(linear(bright, orthographic(), 64, settings)), 1.5f, 3e-3f);
  const View view{&bright, orthographic(), {0, 0, 64, 64}};
  const Image8 picture = renderer->picture(std::span(&view, 1), {64, 64}, settings);
  EXPECT_EQ(picture.at(32, 32)[0], 255);
  EXPECT_LT(picture.at(32, 32)[2], 220);
  EXPECT_NEAR(renderer->furnaceShares(std::span(&view, 1), {64, 64}, false)[0].extreme(), 1.5, 3e-3);
}

// Exact integrals (tests/data/environment_brdf.json, mpmath and two quadratures). The table's own 64 cells a side
// limit it where the albedo is steep: below roughness 0.1 near grazing.
TEST_F(RendererTest, EnvironmentBrdfMatchesTheExactIntegrals) {
  const auto cases = nlohmann::json::parse(std::ifstream(GLINT_TESTS_DIR "/data/environment_brdf.json"));
  constexpr int n = EnvironmentLighting::kBrdfSize;
  std::map<std::string, std::vector<float>> tables;
  for (const auto& c : cases) {
    const std::string id = c["model"];
    auto& table = tables[id];
    if (table.empty()) {
      const auto texture = renderer->environmentLighting().brdf(modelSetting(std::make_shared<ModelShader>(models->find(id)), {}));
      ASSERT_TRUE(texture) << id;
      table.resize(size_t{n} * n * 4);
      EXPECT_FALSE(texture->colored) << id;
      glGetTextureImage(texture->texture, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(table.size() * 4), table.data());
    }
    const double x = c["NoV"].get<double>() * (n - 1), y = c["roughness"].get<double>() * (n - 1);
    const int i = std::min(n - 2, static_cast<int>(x)), j = std::min(n - 2, static_cast<int>(y));
    const auto at = [&](int channel) {
      const auto texel = [&](int a, int b) { return double(table[static_cast<size_t>((b * n + a) * 4 + channel)]); };
      return std::lerp(std::lerp(texel(i, j), texel(i + 1, j), x - i), std::lerp(texel(i, j + 1), texel(i + 1, j + 1), x - i), y - j);
    };
    const bool steep = c["roughness"] < 0.1 && c["NoV"] < 0.2;
    EXPECT_NEAR(at(0), c["A"], steep ? 2e-2 : 4e-3) << c;
    EXPECT_NEAR(at(1), c["B"], 4e-3) << c;
    EXPECT_NEAR(at(2), 1, 2e-3) << c << " Lambert reflects all";
  }
}

TEST_F(RendererTest, ViewsOfOnePictureAreWhatEachIsAlone) {
  Scene left = sphereScene("ggx", {.baseColor = {0.8f, 0.1f, 0.1f}, .roughness = 0.3f});
  Scene right = sphereScene("burley", {.baseColor = {0.1f, 0.1f, 0.8f}, .metallic = 1, .roughness = 0.5f});
  left.lights = right.lights = {{.kind = LightKind::Directional, .direction = glm::normalize(glm::vec3(1, 1, 1))}};
  left.environment = right.environment = test::uniformEnvironment(0.5f);
  const View views[] = {{&left, Camera{}, {0, 0, 64, 64}}, {&right, Camera{}, {64, 0, 64, 64}}};
  const ImageF both = renderer->linear(views, {128, 64}, {});
  const ImageF alone = linear(right, Camera{});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(both.at(64 + x, y)[c], alone.at(x, y)[c], 2e-3f * (1 + alone.at(x, y)[c])) << x << "," << y;
}

// Turning the environment by +90 degrees about +Y brings what was at +X to -Z (right-handed).
TEST_F(RendererTest, EnvironmentTurnsRightHanded) {
  auto environment = std::make_shared<Environment>(*test::uniformEnvironment(0));
  // u = 0.5 is +X: a bright spot there.
  for (int y = 14; y < 18; ++y)
    for (int x = 30; x < 34; ++x) environment->pixels.at(x, y)[0] = 10;
  environment->hash = 77;
  Scene scene;
  scene.environment = environment;
  Camera camera;
  camera.eye = glm::vec3(0);
  camera.target = {1, 0, 0};
  EXPECT_GT(center(linear(scene, camera)), 5.0f);
  scene.environmentRotation = 1.57079633f;
  camera.target = {0, 0, -1};
  EXPECT_GT(center(linear(scene, camera)), 5.0f);
}

TEST_F(RendererTest, PictureIsUprightAndEncoded) {
  // Light from above: the top of the sphere is bright, the bottom dark.
  Scene scene = sphereScene("ggx", {.baseColor = glm::vec3(0.5f), .roughness = 0.8f});
  scene.lights.push_back({.kind = LightKind::Directional, .direction = {0, 1, 0}});
  RenderSettings settings;
  settings.background = Background::Color;
  settings.backgroundColor = glm::vec3(0.21404114f);  // 50 % grey in sRGB
  const View view{&scene, orthographic(), {0, 0, 64, 64}};
  const Image8 image = renderer->picture(std::span(&view, 1), {64, 64}, settings);
  EXPECT_GT(image.at(32, 12)[0], 100);
  EXPECT_LT(image.at(32, 52)[0], 10);
  EXPECT_NEAR(image.at(1, 1)[0], 128, 1);
  settings.samples = 4;
  const Image8 smooth = renderer->picture(std::span(&view, 1), {64, 64}, settings);
  EXPECT_NEAR(smooth.at(1, 1)[0], 128, 1);
  EXPECT_NEAR(smooth.at(32, 12)[0], image.at(32, 12)[0], 12);
  EXPECT_EQ(renderer->statistics().invalidPixels, 0);
}

// Pixels that no surface covers are sound, however the background is drawn and however many samples there are.
TEST_F(RendererTest, BackgroundsAreSoundPixels) {
  Scene scene = sphereScene("ggx", {});
  const View view{&scene, orthographic(), {0, 0, 32, 32}};
  for (const char* mode : {"lit", "modelId"})
    for (const int samples : {1, 3}) {
      RenderSettings settings;
      settings.view = mode;
      settings.samples = samples;
      settings.background = Background::None;
      (void)renderer->picture(std::span(&view, 1), {32, 32}, settings);
      EXPECT_EQ(renderer->statistics().invalidPixels, 0) << mode << " " << samples;
      (void)renderer->linear(std::span(&view, 1), {32, 32}, settings);
      EXPECT_EQ(renderer->statistics().invalidPixels, 0) << mode << " " << samples;
    }
}

// A negative scale turns triangles inside out, and the renderer turns them back: one-sided surfaces stay visible from
// the side they face.
TEST_F(RendererTest, MirroredInstancesFaceTheSameWay) {
  auto quad = std::make_shared<Mesh>();
  for (const glm::vec2 p : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) quad->vertices.push_back({.position = {p, 0}});
  quad->indices = {0, 1, 2, 0, 2, 3};
  Scene scene;
  scene.materials.push_back(test::material(models->find("ggx"), {}));
  scene.lights.push_back({.direction = glm::normalize(glm::vec3(0.3f, 0.2f, 1))});
  scene.instances.push_back({quad, glm::mat4(1), 0});
  const float plain = center(linear(scene, orthographic()));
  EXPECT_GT(plain, 0.1f);
  for (const glm::vec3 scale : {glm::vec3(-1, 1, 1), {1, -1, 1}, {-1, -1, 1}}) {
    for (int i = 0; i < 3; ++i) scene.instances[0].worldFromModel[i][i] = scale[i];
    for (const bool doubleSided : {false, true}) {
      scene.materials[0].doubleSided = doubleSided;
      EXPECT_NEAR(center(linear(scene, orthographic())), plain, 1e-4f) << scale.x << scale.y << doubleSided;
    }
  }
}

// Data is its number in a linear picture; only a display needs it encoded.
TEST_F(RendererTest, LinearPicturesOfDataHoldTheNumbers) {
  Scene scene = sphereScene("ggx", {.metallic = 0.25f, .roughness = 0.5f});
  RenderSettings settings;
  settings.view = "roughness";
  EXPECT_NEAR(center(linear(scene, orthographic(), 32, settings)), 0.5f, 1e-3f);
  settings.view = "metallic";
  EXPECT_NEAR(center(linear(scene, orthographic(), 32, settings)), 0.25f, 1e-3f);
}

// Whoever shows a texture may do so until the second next call, also while a window is being resized.
TEST_F(RendererTest, ATextureOutlivesAChangeOfSize) {
  Scene scene = sphereScene("ggx", {});
  const auto draw = [&](int side) {
    const View view{&scene, orthographic(), {0, 0, side, side}};
    return renderer->drawToTexture(std::span(&view, 1), {side, side}, {});
  };
  const auto width = [](unsigned texture) {
    GLint w = 0;
    if (glIsTexture(texture)) glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &w);
    return w;
  };
  const unsigned first = draw(40), second = draw(48);
  EXPECT_EQ(width(first), 40);
  const unsigned third = draw(56);
  EXPECT_EQ(width(second), 48);
  EXPECT_EQ(width(third), 56);
  const unsigned fourth = draw(40);
  EXPECT_EQ(width(fourth), 40);
  EXPECT_EQ(width(third), 56);
}

TEST_F(RendererTest, EveryViewModeDraws) {
  Scene scene = sphereScene("burley", {.baseColor = {0.9f, 0.5f, 0.2f}, .metallic = 1, .roughness = 0.6f});
  scene.environment = test::uniformEnvironment(1);
  scene.lights = {{.kind = LightKind::Point, .position = {0, 0, 2}, .radius = 4}};
  const View view{&scene, orthographic(), {0, 0, 32, 32}};
  for (const ViewMode& mode : viewModes()) {
    RenderSettings settings;
    settings.view = mode.id;
    if (settings.view == kErrorView) settings.reference = 2;
    const Image8 image = renderer->picture(std::span(&view, 1), {32, 32}, settings);
    EXPECT_FALSE(image.empty()) << mode.id;
    if (settings.view == "roughness") {
      EXPECT_NEAR(image.at(16, 16)[0], 153, 1);
    }
    if (settings.view == "metallic") {
      EXPECT_NEAR(image.at(16, 16)[0], 255, 1);
    }
  }
}

// The clusters that face away are skipped: about half of a sphere's triangles, and none that is seen.
TEST_F(RendererTest, TrianglesThatFaceAwayAreNotDrawn) {
  Scene scene = sphereScene("ggx", {});
  (void)linear(scene, Camera{});
  const int all = static_cast<int>(sphere->indices.size() / 3);
  EXPECT_LT(renderer->statistics().triangles, all * 2 / 3);
  scene.materials[0].doubleSided = true;
  scene.environment = test::uniformEnvironment(1);
  const ImageF whole = linear(scene, Camera{});
  EXPECT_EQ(renderer->statistics().triangles, all);
  scene.materials[0].doubleSided = false;
  const ImageF culled = linear(scene, Camera{});
  for (size_t i = 0; i < whole.data.size(); ++i) ASSERT_NEAR(whole.data[i], culled.data[i], 1e-3f);
}

// A plugin that is edited for an hour is hundreds of models: their tables go when they are no longer drawn.
TEST_F(RendererTest, ReloadedModelsLeaveNothingBehind) {
  Renderer own(*context);
  const EnvironmentPtr environment = test::uniformEnvironment(1);
  for (int i = 0; i < 20; ++i) {
    auto model = parseModel("m.glsl", "/*glint {\"id\": \"m\", \"terms\": {\"D\": \"GGX\", \"V\": \"Implicit\", \"F\": \"None\"}} */\n"
                                      "vec3 diffuse(Shading s, Parameters p) { return vec3(0." + std::to_string(10 + i) + "); }\n");
    ASSERT_TRUE(model);
    Scene scene;
    scene.materials.push_back(test::material(std::make_shared<const ShadingModel>(std::move(*model)), {}));
    scene.instances.push_back({sphere, glm::mat4(1), 0});
    scene.environment = environment;
    const View view{&scene, orthographic(), {0, 0, 16, 16}};
    own.picture(std::span(&view, 1), {16, 16}, {});
  }
  EXPECT_LE(own.environmentLighting().cubes(), 10u);
}

// Who edits a pass while the editor runs sees it at the next reload.
TEST_F(RendererTest, AShippedShaderThatChangedIsReadAgain) {
  const test::TempFolder folder;
  std::filesystem::create_directories(folder / "shaders");
  for (const char* part : {"common", "passes", "terms"})
    std::filesystem::copy(shipped::onDisk("shaders/terms/d.glsl").parent_path().parent_path() / part, folder / "shaders" / part);
  const testing_support::WithVariable data("GLINT_DATA_DIR", folder.path().string());
  Renderer own(*context);
  const Scene scene = sphereScene("ggx", {});
  const View view{&scene, orthographic(), {0, 0, 16, 16}};
  own.picture(std::span(&view, 1), {16, 16}, {});
  const int first = own.programsBuilt();
  std::ofstream(folder / "shaders/passes/lighting.frag", std::ios::app) << "// changed\n";
  own.reloadModels();
  own.picture(std::span(&view, 1), {16, 16}, {});
  EXPECT_GT(own.programsBuilt(), first);
}

// A change to one plugin compiles what that plugin is in, and nothing else that is drawn.
TEST_F(RendererTest, AReloadedModelCompilesAlone) {
  Renderer own(*context);
  Scene scene;
  scene.environment = test::uniformEnvironment(1);
  const auto plugin = [](int version) {
    auto model = parseModel("m.glsl", "/*glint {\"id\": \"m\", \"terms\": {\"D\": \"GGX\", \"V\": \"Implicit\", \"F\": \"None\"}} */\n"
                                      "vec3 diffuse(Shading s, Parameters p) { return vec3(0.3" + std::to_string(version) + "); }\n");
    EXPECT_TRUE(model);
    return test::material(std::make_shared<const ShadingModel>(std::move(*model)), {});
  };
  for (const char* id : {"ggx", "burley", "cook-torrance"}) scene.materials.push_back(test::material(models->find(id), {}));
  scene.materials.push_back(plugin(1));
  for (int i = 0; i < 4; ++i) scene.instances.push_back({sphere, glm::translate(glm::mat4(1), glm::vec3(i - 1.5f, 0, 0)), i});
  const View view{&scene, orthographic(), {0, 0, 32, 32}};
  const auto built = [&] {
    const int before = own.programsBuilt();
    own.picture(std::span(&view, 1), {32, 32}, {});
    return own.programsBuilt() - before;
  };
  const int all = built();
  EXPECT_EQ(built(), 0);
  own.reloadModels();
  EXPECT_EQ(built(), 0) << "the same files";
  scene.materials[3] = plugin(2);
  own.reloadModels();
  const int one = built();
  EXPECT_GT(one, 0);
  EXPECT_LE(one * 3, all);
  scene.materials[3] = plugin(1);
  own.reloadModels();
  EXPECT_EQ(built(), 0) << "undone: remembered";
}

// The first picture of a model never seen before does not wait for its tables, and is much like the one that does.
TEST_F(RendererTest, ACoarsePictureComesBeforeTheFineOne) {
  Scene scene;
  const auto studio = loadEnvironment("studio");
  ASSERT_TRUE(studio);
  scene.environment = *studio;
  const auto now = std::chrono::system_clock::now().time_since_epoch().count() % 1000000;
  const std::string text = fmt::format(
      "/*glint {{\"id\": \"new\", \"terms\": {{\"D\": \"GGX\", \"V\": \"SmithGGXCorrelated\", \"diffuse\": \"Lambert\"}}}} */\n"
      "vec3 F(Shading s, Parameters p) {{ return F_Schlick(s) * {:.9f}; }}\n", 1 - 1e-8 * double(now));
  auto model = parseModel("new.glsl", text);
  ASSERT_TRUE(model);
  const auto shared = std::make_shared<const ShadingModel>(std::move(*model));
  for (int i = 0; i < 4; ++i) {
    scene.materials.push_back(test::material(shared, {.baseColor = glm::vec3(0.8f, 0.5f, 0.3f), .metallic = float(i & 1), .roughness = 0.15f + 0.25f * float(i)}));
    scene.instances.push_back({sphere, glm::translate(glm::mat4(1), glm::vec3(2.2f * float(i) - 3.3f, 0, 0)), i});
  }
  Camera camera = orthographic();
  const View view{&scene, camera, {0, 0, 256, 64}};
  const auto draw = [&](bool coarse) { return renderer->picture(std::span(&view, 1), {256, 64}, {.coarse = coarse}); };
  const Image8 coarse = draw(true);
  EXPECT_EQ(renderer->statistics().coarseTables, 2) << "the lobe over the environment and the environment BRDF";
  int made = 0;
  while (renderer->refineTable()) ++made;
  EXPECT_EQ(made, 2);
  const Image8 refined = draw(true);
  EXPECT_EQ(renderer->statistics().coarseTables, 0);
  const Image8 fine = draw(false);
  EXPECT_EQ(refined.data, fine.data);
  double mean = 0, most = 0;
  for (size_t i = 0; i < fine.data.size(); ++i) {
    const double difference = std::abs(double(fine.data[i]) - coarse.data[i]);
    mean += difference / double(fine.data.size());
    most = std::max(most, difference);
  }
  EXPECT_GT(mean, 0);
  EXPECT_LT(mean, 1);
  EXPECT_LT(most, 16);
  RecordProperty("mean", std::to_string(mean));
  RecordProperty("most", std::to_string(most));
}

}  // namespace
}  // namespace glint
