// Shadows and occlusion, against geometry.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numbers>

#include "app/scene_options.h"
#include "materials/model_registry.h"
#include "renderer/ground.h"
#include "renderer/renderer.h"
#include "tests/support/renderer_fixture.h"

namespace glint {
namespace {

constexpr double kPi = std::numbers::pi;

class ShadowsTest : public test::RendererFixture<ShadowsTest> {
 protected:
  static SurfaceMaterial white() { return test::material(models->find("ggx"), {.baseColor = glm::vec3(1), .roughness = 1, .specular = 0}); }
  // A plane of 8 x 8 m in xy that faces +Z, and a sphere of 0.25 m, a metre above it.
  static Scene sphereOverPlane(const std::vector<Light>& lights) {
    Scene scene;
    scene.materials.push_back(white());
    scene.instances.push_back({planeMesh(), glm::scale(glm::mat4(1), glm::vec3(4)), 0});
    scene.instances.push_back({sphere, glm::scale(glm::translate(glm::mat4(1), {0, 0, 1}), glm::vec3(0.25f)), 0});
    scene.lights = lights;
    return scene;
  }
  static Light sun(float degrees) { return {.kind = LightKind::Directional, .direction = glm::normalize(glm::vec3(1, 0, 1)), .angle = glm::radians(degrees)}; }
  // From straight above: 4 m across.
  static Camera above() {
    Camera camera;
    camera.eye = {0, 0, 5};
    camera.orthoHeight = 4;
    return camera;
  }
  static ImageF draw(const Scene& scene, const RenderSettings& settings, const Camera& camera = above(), int side = 128) {
    const View view{&scene, camera, {0, 0, side, side}};
    return renderer->linear(std::span(&view, 1), {side, side}, settings);
  }
  static RenderSettings shadows(Shadows kind, int samples = 4) {
    RenderSettings settings;
    settings.background = Background::None;
    settings.shadows = kind;
    settings.samples = samples;
    return settings;
  }
  // The share of light that arrives, where any would.
  static Pixels<double> share(const ImageF& with, const ImageF& without) {
    Pixels<double> share(with.width, with.height, 1);
    for (int y = 0; y < with.height; ++y)
      for (int x = 0; x < with.width; ++x) *share.at(x, y) = without.at(x, y)[0] > 1e-4 ? with.at(x, y)[0] / without.at(x, y)[0] : 1;
    return share;
  }
};

// A sphere of radius r in parallel light at 45 degrees leaves an ellipse of half axes r sqrt(2) and r, a height beside it.
TEST_F(ShadowsTest, OfASphereLieWhereGeometrySays) {
  const Scene scene = sphereOverPlane({sun(0)});
  const ImageF without = draw(scene, shadows(Shadows::Off));
  for (const Shadows kind : {Shadows::Maps, Shadows::Contact}) {
    const Pixels<double> lit = share(draw(scene, shadows(kind)), without);
    double area = 0, x = 0, y = 0;
    for (int j = 0; j < 128; ++j)
      for (int i = 0; i < 60; ++i) {   // left of the sphere itself
        const double dark = 1 - *lit.at(i, j);
        area += dark / (32.0 * 32.0);
        x += dark / (32.0 * 32.0) * ((i + 0.5) / 32 - 2);
        y += dark / (32.0 * 32.0) * (2 - (j + 0.5) / 32);
      }
    EXPECT_NEAR(area, kPi * 0.25 * 0.25 * std::numbers::sqrt2, 0.02);
    EXPECT_NEAR(x / area, -1, 0.02);   // a texel of the map is 0.011
    EXPECT_NEAR(y / area, 0, 0.01);
    EXPECT_NEAR(*lit.at(32, 64), 0, 1e-3);
    EXPECT_NEAR(*lit.at(110, 20), 1, 1e-3);
  }
}

// A thing of a centimetre and one of a hundred metres look the same.
TEST_F(ShadowsTest, AndOcclusionKnowNoSize) {
  const auto at = [&](float size) {
    Scene scene = sphereOverPlane({sun(5), *parseLight("rectangle:pos=-1/1/2,to=0/0/0,width=0.5,height=0.5,cd=4,constant=0,radius=100")});
    scene.environment = test::uniformEnvironment(0.5f);
    for (Instance& instance : scene.instances) instance.worldFromModel = glm::scale(glm::mat4(1), glm::vec3(size)) * instance.worldFromModel;
    Light& light = scene.lights[1];
    light.position *= size;
    light.radius *= size;
    light.width *= size;
    light.height *= size;
    light.candela *= size * size;
    Camera camera = above();
    camera.eye = glm::vec3(0, 2, 5) * size;
    camera.orthoHeight *= size;
    camera.nearPlane *= size;
    camera.farPlane *= size;
    RenderSettings settings = shadows(Shadows::Contact, 1);
    settings.screenOcclusion = true;
    return draw(scene, settings, camera, 96);
  };
  const ImageF metre = at(1);
  for (const float size : {0.01f, 100.0f}) {
    const ImageF other = at(size);
    double difference = 0;
    for (size_t i = 0; i < metre.data.size(); ++i) difference += std::abs(metre.data[i] - other.data[i]);
    EXPECT_LT(difference / static_cast<double>(metre.data.size()), 2e-3) << size;
  }
}

// The light of a disc that an edge crosses goes from a tenth to nine over 0.687 of its width.
TEST_F(ShadowsTest, GrowSofterWithTheLight) {
  const auto width = [](const Scene& scene) {
    const Pixels<double> lit = share(draw(scene, shadows(Shadows::Maps, 16)), draw(scene, shadows(Shadows::Off, 1)));
    // From the middle of the shadow upwards.
    double low = 0, high = 0;
    for (int j = 63; j > 0; --j) {
      const double a = 0.25 * (*lit.at(31, j) + *lit.at(32, j) + *lit.at(31, 127 - j) + *lit.at(32, 127 - j));
      const double b = 0.25 * (*lit.at(31, j - 1) + *lit.at(32, j - 1) + *lit.at(31, 128 - j) + *lit.at(32, 128 - j));
      if (a <= 0.1 && b > 0.1) low = 63 - j + (0.1 - a) / (b - a);
      if (a <= 0.9 && b > 0.9) high = 63 - j + (0.9 - a) / (b - a);
    }
    return (high - low) / 32;
  };
  for (const double degrees : {6.0, 12.0}) {
    const double expected = 0.687 * 2 * std::tan(0.5 * degrees * kPi / 180) * std::numbers::sqrt2;
    EXPECT_NEAR(width(sphereOverPlane({sun(static_cast<float>(degrees))})), expected, 0.15 * expected + 0.02) << degrees;   // and two texels of the map
  }
  // A spot straight above the ground, half as far from the sphere as that is from the ground.
  Light spot{.kind = LightKind::Spot, .position = {-1, 0, 3}, .candela = 30, .axis = {0, 0, -1}, .innerAngle = 1, .outerAngle = 1.2f, .size = 0.1f};
  Scene scene = sphereOverPlane({spot});
  scene.instances[1].worldFromModel = glm::scale(glm::translate(glm::mat4(1), {-1, 0, 1}), glm::vec3(0.25f));
  const Scene small = [&] {
    Scene s = scene;
    s.lights[0].size = 0.01f;
    return s;
  }();
  Camera below = above();
  below.eye.z = 0.5f;   // sees the shadow under the sphere
  const auto dark = [&](const Scene& s) {
    const Pixels<double> lit = share(draw(s, shadows(Shadows::Maps, 8), below), draw(s, shadows(Shadows::Off, 1), below));
    int umbra = 0, part = 0;
    for (const double l : lit.data) umbra += l < 0.02;
    for (int i = 0; i < 128; ++i) part += *lit.at(i, 64) >= 0.02 && *lit.at(i, 64) < 0.98;
    return std::pair(umbra, part);
  };
  const auto hard = dark(small), soft = dark(scene);
  // The umbra's radius: of the sphere's outline from the light, 0.25 at 2 m, at 3 m; less what the light's size takes.
  const double whole = 0.25 / std::sqrt(1 - 0.125 * 0.125) * 1.5;
  EXPECT_NEAR(std::sqrt(hard.first / kPi) / 32, whole, 0.03);
  EXPECT_NEAR(std::sqrt(soft.first / kPi) / 32, whole - 0.05, 0.04);
  EXPECT_LE(hard.second, 4) << "two edges of two pixels";
  EXPECT_GE(soft.second, 7) << "of 0.1 m, which are more than three";
}

// What a material cuts out lets light through.
TEST_F(ShadowsTest, OfHolesAreBright) {
  Scene scene = sphereOverPlane({sun(0)});
  scene.materials.push_back(white());
  auto compiled = std::make_shared<CompiledMaterial>(*scene.materials[1].compiled);
  const std::string solid = "m.opacityMask = 1.0;";
  compiled->glsl.replace(compiled->glsl.find(solid), solid.size(), "m.opacityMask = length(i.uv0 - 0.5) - 0.1;");   // against 0.15: a disc of half the width
  compiled->hash = hashText(compiled->glsl);
  compiled->writesOpacityMask = true;
  scene.materials[1].compiled = compiled;
  scene.materials[1].opacityCutoff = 0.15f;
  scene.instances[1] = {planeMesh(), glm::scale(glm::translate(glm::mat4(1), {0, 0, 1}), glm::vec3(0.4f)), 1};
  const ImageF without = draw(scene, shadows(Shadows::Off));
  const auto dark = [&] {
    const Pixels<double> lit = share(draw(scene, shadows(Shadows::Maps)), without);
    double area = 0;
    for (int j = 0; j < 128; ++j)
      for (int i = 0; i < 50; ++i) area += (1 - *lit.at(i, j)) / (32.0 * 32.0);
    return area;
  };
  EXPECT_NEAR(dark(), 0.8 * 0.8 - kPi * 0.2 * 0.2, 0.03);
  EXPECT_EQ(renderer->statistics().shadowMaps, 0) << "of the last sample";
  scene.materials[1].opacityCutoff = -1;
  EXPECT_NEAR(dark(), 0.8 * 0.8, 0.03);
}

TEST_F(ShadowsTest, OffAndWithoutCastersNothingChanges) {
  std::vector<Light> lights = {sun(0.5f)};
  for (const char* text : {"sphere:pos=1/1/3,size=0.2,cd=5", "spot:pos=-1/1/3,to=0/0/0,cd=5", "point:pos=0/2/2,cd=3"}) lights.push_back(*parseLight(text));
  Scene scene = sphereOverPlane(lights);
  const ImageF plain = draw(scene, shadows(Shadows::Off));
  EXPECT_NE(draw(scene, shadows(Shadows::Contact)).data, plain.data);
  EXPECT_EQ(draw(scene, shadows(Shadows::Off)).data, plain.data);
  for (Light& light : scene.lights) light.shadow = false;
  EXPECT_EQ(draw(scene, shadows(Shadows::Contact)).data, plain.data) << "no light has one";
  // A sphere alone: what is turned away is dark by its shading, and nothing else is in the way.
  Scene alone = sphereOverPlane(lights);
  alone.instances.erase(alone.instances.begin());
  for (const float roughness : {0.1f, 1.0f}) {
    alone.materials[0] = test::material(models->find("ggx"), {.baseColor = glm::vec3(0.8f), .roughness = roughness});
    Camera near = above();
    near.orthoHeight = 0.55f;
    near.target.z = 1;
    const ImageF off = draw(alone, shadows(Shadows::Off), near), on = draw(alone, shadows(Shadows::Contact), near);
    double largest = 0;
    for (size_t i = 0; i < off.data.size(); ++i) largest = std::max(largest, static_cast<double>(std::abs(off.data[i] - on.data[i])));
    EXPECT_LT(largest, 0.01) << roughness;
  }
  // The reference and the furnace know none of it.
  RenderSettings furnace = shadows(Shadows::Contact);
  furnace.view = kFurnaceView;
  furnace.screenOcclusion = true;
  RenderSettings bare = shadows(Shadows::Off);
  bare.view = kFurnaceView;
  EXPECT_EQ(draw(scene, furnace).data, draw(scene, bare).data);
}

// A map is drawn when something in it moved, a picture is the same however it came about.
TEST_F(ShadowsTest, AreKeptWhileNothingMoves) {
  Scene scene = sphereOverPlane({sun(2)});
  Renderer fresh(*context);
  const auto look = [&](Renderer& r, const Camera& camera) {
    const View view{&scene, camera, {0, 0, 64, 64}};
    RenderSettings settings = shadows(Shadows::Contact, 1);
    settings.screenOcclusion = true;
    return r.picture(std::span(&view, 1), {64, 64}, settings);
  };
  const Image8 first = look(fresh, above());
  EXPECT_EQ(fresh.statistics().shadowMaps, 1);
  EXPECT_EQ(look(fresh, above()), first);
  EXPECT_EQ(fresh.statistics().shadowMaps, 0);
  Camera turned = above();
  turned.eye.x = 1;
  const Image8 beside = look(fresh, turned);
  EXPECT_EQ(fresh.statistics().shadowMaps, 0);
  EXPECT_NE(beside, first);
  scene.instances[1].worldFromModel = glm::translate(glm::mat4(1), {0.5f, 0, 0}) * scene.instances[1].worldFromModel;
  const Image8 moved = look(fresh, turned);
  EXPECT_EQ(fresh.statistics().shadowMaps, 1);
  Renderer other(*context);
  EXPECT_EQ(look(other, turned), moved);
}

// More views than there are maps: each looks as it does alone.
TEST_F(ShadowsTest, OfManyViewsAreThoseOfEach) {
  constexpr int kViews = 12, kSide = 32;
  std::vector<Scene> scenes;
  for (int i = 0; i < kViews; ++i) {
    scenes.push_back(sphereOverPlane({sun(1)}));
    scenes.back().lights[0].direction = glm::normalize(glm::vec3(std::cos(i), std::sin(i), 1));
  }
  std::vector<View> views;
  for (int i = 0; i < kViews; ++i) views.push_back({&scenes[static_cast<size_t>(i)], above(), {i * kSide, 0, kSide, kSide}});
  RenderSettings settings = shadows(Shadows::Contact, 1);
  settings.screenOcclusion = true;
  const ImageF together = renderer->linear(views, {kViews * kSide, kSide}, settings);
  EXPECT_EQ(renderer->statistics().shadowMaps, kViews);
  for (int i = 0; i < kViews; ++i) {
    const ImageF alone = draw(scenes[static_cast<size_t>(i)], settings, above(), kSide);
    double difference = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) difference += std::abs(alone.at(x, y)[0] - together.at(i * kSide + x, y)[0]);
    // The noise of a pixel follows its place.
    EXPECT_LT(difference / (kSide * kSide), 0.01) << i;
  }
}

TEST_F(ShadowsTest, BeyondTheirNumberAreTold) {
  std::vector<Light> lights;
  for (int i = 0; i < 12; ++i) {
    lights.push_back(sun(1));
    lights.back().lux = static_cast<float>(i + 1);
  }
  lights.push_back(*parseLight("sphere:pos=0/0/0.9,size=0.1,cd=1"));
  draw(sphereOverPlane(lights), shadows(Shadows::Maps, 1));
  ASSERT_EQ(renderer->problems().size(), 2u);
  EXPECT_EQ(renderer->problems()[0].what, "no shadow of sphere light 13");
  // The weakest.
  EXPECT_EQ(renderer->problems()[1].what, "no shadow of directional light 4, directional light 3, directional light 2, directional light 1");
  EXPECT_EQ(renderer->problems()[1].severity, Severity::Warning);
}

// The hemisphere over a plane is open; in a corner with a wall of height h and great length, at a distance x, half of the
// cosine of the angle up to its top is lost.
TEST_F(ShadowsTest, OcclusionOfAPlaneAndOfACorner) {
  Scene scene;
  scene.materials.push_back(white());
  const glm::mat4 floor = glm::rotate(glm::mat4(1), -0.5f * static_cast<float>(kPi), glm::vec3(1, 0, 0));   // xz, facing +Y
  scene.instances.push_back({planeMesh(), glm::translate(glm::mat4(1), {1, 0, 0}) * glm::scale(glm::mat4(1), {1, 1, 8}) * floor, 0});
  scene.environment = test::uniformEnvironment(1);
  Camera camera;
  camera.eye = {3, 3, 0};
  camera.target = {0.5f, 0.5f, 0};
  camera.orthoHeight = 3;
  RenderSettings settings = shadows(Shadows::Off, 1), open = settings;
  settings.screenOcclusion = true;
  settings.occlusionRadius = 20;
  settings.samples = open.samples = 16;
  constexpr int kSide = 129;
  const auto at = [&](const ImageF& image, glm::vec3 world) {
    const glm::vec4 clip = camera.clipFromView(1) * camera.viewFromWorld() * glm::vec4(world, 1);
    return image.at(static_cast<int>((clip.x / clip.w * 0.5f + 0.5f) * kSide), static_cast<int>((0.5f - clip.y / clip.w * 0.5f) * kSide))[0];
  };
  const ImageF flat = draw(scene, settings, camera, kSide), bare = draw(scene, open, camera, kSide);
  for (size_t i = 0; i < flat.data.size(); ++i) ASSERT_NEAR(flat.data[i], bare.data[i], 2e-3f);
  const glm::mat4 wall = glm::rotate(glm::mat4(1), 0.5f * static_cast<float>(kPi), glm::vec3(0, 1, 0));      // yz, facing +X
  scene.instances.push_back({planeMesh(), glm::translate(glm::mat4(1), {0, 0.5f, 0}) * glm::scale(glm::mat4(1), {1, 0.5f, 8}) * wall, 0});
  const ImageF corner = draw(scene, settings, camera, kSide), plain = draw(scene, open, camera, kSide);
  for (const float x : {0.04f, 0.1f, 0.2f, 0.4f, 0.6f}) {
    const auto expected = [&](float height) { return 0.5 * (1 + x / std::sqrt(x * x + height * height)); };
    // So few steps along a slice miss some of the height.
    const double tolerance = x < 0.3f ? 0.05 : 0.08;
    EXPECT_NEAR(at(corner, {x, 0, 0}) / at(plain, {x, 0, 0}), expected(1), tolerance) << x;
    if (x < 0.5f) {   // or the floor is farther than is looked
      EXPECT_NEAR(at(corner, {0, x, 0}) / at(plain, {0, x, 0}), expected(2), tolerance) << x;
    }
  }
  // Each of the two occlusions by itself.
  settings.screenOcclusion = false;
  settings.materialOcclusion = false;
  EXPECT_EQ(draw(scene, settings, camera, kSide).data, plain.data) << "the material has none";
}

// On a ground the background is darker where the subject keeps light away, and as it was elsewhere.
TEST_F(ShadowsTest, AGroundShowsThem) {
  Scene scene;
  scene.materials.push_back(white());
  scene.instances.push_back({sphere, glm::mat4(1), 0});
  scene.lights = {sun(1)};
  scene.lights[0].direction = glm::normalize(glm::vec3(1, 1, 0));
  Camera camera = frameScene(scene, 1);
  RenderSettings settings = shadows(Shadows::Maps);
  settings.background = Background::Color;
  settings.backgroundColor = glm::vec3(0.5f);
  camera.eye = glm::vec3(0, 6, 12);
  camera.farPlane = 30;
  settings.shadows = Shadows::Off;
  const ImageF alone = draw(scene, settings, camera);
  settings.shadows = Shadows::Maps;
  addGround(scene, Ground::Shadow, models->find("ggx"));
  includeGround(camera, scene);
  const ImageF ground = draw(scene, settings, camera);
  const auto at = [&](const ImageF& image, glm::vec3 world) {
    const glm::vec4 clip = camera.clipFromView(1) * camera.viewFromWorld() * glm::vec4(world, 1);
    return image.at(static_cast<int>((clip.x / clip.w * 0.5f + 0.5f) * 128), static_cast<int>((0.5f - clip.y / clip.w * 0.5f) * 128))[0];
  };
  EXPECT_NEAR(at(ground, {-1.8f, -1, 0.6f}), 0, 0.01);      // the middle of the shadow is at (-1, -1, 0)
  EXPECT_NEAR(at(ground, {2, -1, 1}), 0.5, 1e-3);
  EXPECT_NEAR(at(ground, {-1.8f, -1, 2}), 0.5, 1e-3);
  EXPECT_NEAR(at(ground, {0, 0, 1}), at(alone, {0, 0, 1}), 0.01) << "the subject is what it was";
  // Behind all that casts shadows these are soft as well.
  const auto partly = [&](float degrees) {
    scene.lights[0].angle = glm::radians(degrees);
    const ImageF image = draw(scene, settings, camera);
    int count = 0;
    for (int j = 0; j < 128; ++j)
      for (int i = 0; i < 64; ++i)
        count += image.at(i, j)[0] > 0.1f && image.at(i, j)[0] < 0.4f && alone.at(i, j)[0] == 0.5f;
    return count;
  };
  const int hard = partly(0), soft = partly(12);
  EXPECT_GT(hard, 0);
  EXPECT_GT(soft, 4 * hard);
  settings.shadows = Shadows::Off;
  EXPECT_EQ(draw(scene, settings, camera).data, alone.data) << "nothing to show";
}

TEST_F(ShadowsTest, OfOddLightsLeaveNothingInvalid) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  std::vector<Light> odd(8, sun(1));
  odd[0].direction = glm::vec3(nan);
  odd[1].direction = glm::vec3(0);
  odd[2].angle = infinity;
  odd[3].direction = {0, 0, 1};
  odd[3].angle = 0;
  odd[4].direction = {0, 0, -1};
  odd[5].lux = nan;
  odd[6].direction = {1, 0, 0};    // along the plane
  odd[7].angle = 3;
  std::vector<Light> placed;
  for (const char* text : {"spot:pos=0/0/0.5,to=0/0/1,outer=90,cd=5", "spot:pos=0/0/3,to=0/0/0,outer=0,cd=5", "spot:pos=0/0/1,to=0/0/0,cd=5,size=0",
                           "point:pos=0/0/1.3,cd=1", "sphere:pos=0/0/30,size=50,cd=90", "tube:from=0/0/5,to=0/0/9,size=0", "rectangle:pos=0/0/8,to=0/0/0,width=0,height=0,cd=9",
                           "rectangle:pos=1e6/0/1e6,to=0/0/0,width=1e5,height=1e5,cd=1e9,radius=1e9"})
    placed.push_back(*parseLight(text));
  placed.push_back({.kind = LightKind::Spot, .position = glm::vec3(nan)});
  RenderSettings settings = shadows(Shadows::Contact, 2);
  settings.screenOcclusion = true;
  for (const auto& lights : {odd, placed}) {
    Scene scene = sphereOverPlane(lights);
    scene.environment = test::uniformEnvironment(1);
    draw(scene, settings, above(), 48);
    EXPECT_EQ(renderer->statistics().invalidPixels, 0);
    addGround(scene, Ground::Shadow, models->find("ggx"));
    draw(scene, settings, frameScene(scene, 1), 48);
    EXPECT_EQ(renderer->statistics().invalidPixels, 0);
  }
}

}  // namespace
}  // namespace glint
