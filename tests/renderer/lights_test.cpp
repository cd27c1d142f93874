// Lights with a shape, as they are drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "app/scene_options.h"
#include "materials/model_registry.h"
#include "renderer/cosine_fit.h"
#include "renderer/renderer.h"
#include "tests/support/renderer_fixture.h"

namespace glint {
namespace {

constexpr double kPi = std::numbers::pi;

class LightsTest : public test::RendererFixture<LightsTest> {
 protected:
  static Scene scene(const char* model, const test::Look& look, const std::vector<Light>& lights) {
    Scene scene;
    scene.materials.push_back(test::material(models->find(model), look));
    scene.instances.push_back({sphere, glm::mat4(1), 0});
    scene.lights = lights;
    return scene;
  }
  static ImageF draw(const Scene& scene, AreaLights method = AreaLights::Unreal, int reference = 0) {
    constexpr int kSide = 48;
    Camera camera;
    camera.orthoHeight = 2.2f;
    const View view{&scene, camera, {0, 0, kSide, kSide}};
    RenderSettings settings;
    settings.areaLights = method;
    settings.reference = reference;
    return renderer->linear(std::span(&view, 1), {kSide, kSide}, settings);
  }
  static double center(const ImageF& image) { return image.at(image.width / 2, image.height / 2)[0]; }
};

// product.md: a light of zero size equals the point light.
TEST_F(LightsTest, WithoutASizeTheyArePoints) {
  const Light point{.kind = LightKind::Point, .color = {1, 0.5f, 0.2f}, .position = {1, 1, 2}, .candela = 3, .radius = 6};
  Light ball = point, tube = point;
  ball.kind = LightKind::Sphere;
  ball.size = 0;
  tube.kind = LightKind::Tube;
  tube.size = tube.length = 0;
  const test::Look look{.baseColor = glm::vec3(0.5f), .roughness = 0.3f};
  const ImageF expected = draw(scene("ggx", look, {point}));
  EXPECT_EQ(draw(scene("ggx", look, {ball})).data, expected.data);
  EXPECT_EQ(draw(scene("ggx", look, {tube})).data, expected.data);
  // And as they get small they come near to it.
  ball.size = tube.size = tube.length = 1e-3f;
  for (const Light& light : {ball, tube}) {
    const ImageF small = draw(scene("ggx", look, {light}));
    for (size_t i = 0; i < small.data.size(); ++i) ASSERT_NEAR(small.data[i], expected.data[i], 0.02 * expected.data[i] + 1e-4);
  }
}

// The irradiance of a Lambert surface that faces the light, against closed forms; without the constant of eq. 9, and far
// inside the window.
TEST_F(LightsTest, IrradianceIsThatOfTheShape) {
  const test::Look white{.baseColor = glm::vec3(1), .roughness = 0.7f, .specular = 0};
  const auto light = [](LightKind kind, double distance) {
    return Light{.kind = kind, .position = {0, 0, 1 + distance}, .candela = 10, .radius = 1e4f, .constant = 0, .axis = {0, 0, -1}};
  };
  for (const double d : {0.6, 1.5, 4.0}) {
    // A sphere is a point light above the horizon.
    Light ball = light(LightKind::Sphere, d);
    ball.size = static_cast<float>(0.5 * d);
    EXPECT_NEAR(center(draw(scene("blinn-phong", white, {ball}))), 10 / (d * d) / kPi, 0.01 * 10 / (d * d)) << d;
    // A line of points across the normal: the integral of d / (d^2 + x^2)^(3/2).
    Light tube = light(LightKind::Tube, d);
    tube.axis = {1, 0, 0};
    tube.length = 2;
    tube.size = 0.01f;
    const double line = 10 / (d * std::sqrt(d * d + 1)) / kPi;
    EXPECT_NEAR(center(draw(scene("blinn-phong", white, {tube}))), line, 0.01 * line) << d;
  }
  // A small rectangle that shines straight at it: four times the point light of its power.
  Light rectangle = light(LightKind::Rectangle, 4);
  rectangle.width = rectangle.height = 0.1f;
  EXPECT_NEAR(center(draw(scene("blinn-phong", white, {rectangle}))), 4 * 10 / 16.0 / kPi, 0.01);
  rectangle.axis = {0, 0, 1};
  EXPECT_EQ(center(draw(scene("blinn-phong", white, {rectangle}))), 0) << "it shines to one side";
  // A spot is full inside, and sends out the lumens it was given.
  const auto spot = parseLight("spot:pos=0/0/5,to=0/0/0,lumens=100,inner=20,outer=30,radius=10000,constant=0");
  ASSERT_TRUE(spot);
  double flux = 0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = (i + 0.5) / kSteps * kPi / 2;
    const double x = std::clamp((std::cos(angle) - std::cos(kPi / 6)) / (std::cos(kPi / 9) - std::cos(kPi / 6)), 0.0, 1.0);
    flux += spot->candela * x * x * 2 * kPi * std::sin(angle) * kPi / 2 / kSteps;
  }
  EXPECT_NEAR(flux, 100, 0.1);
  EXPECT_NEAR(center(draw(scene("blinn-phong", white, {*spot}))), spot->candela / 16 / kPi, 0.01 * spot->candela / 16);
}

// A lobe that is a turned cosine is found again, also where a part of it is below the horizon.
TEST(CosineFit, FindsWhatItWasMadeFrom) {
  const auto density = [](const glm::dmat3& m, const glm::dvec3& w) {
    const glm::dvec3 c = glm::inverse(m) * w;
    return std::max(c.z, 0.0) / kPi / (std::abs(glm::determinant(m)) * std::pow(glm::length(c), 4));
  };
  for (const double angle : {0.2, 1.2}) {
    const glm::dvec3 Z(std::sin(angle), 0, std::cos(angle)), X(Z.z, 0, -Z.x);
    const glm::dmat3 made(0.3 * X, glm::dvec3(0, 0.4, 0), Z + 0.1 * X);
    std::vector<LobeSample> samples;
    double above = 0;
    constexpr int kRings = 200;
    for (int i = 0; i < kRings; ++i)
      for (int j = 0; j < kRings; ++j) {
        const double z = (i + 0.5) / kRings, phi = (j + 0.5) / kRings * kPi, r = std::sqrt(1 - z * z);
        samples.push_back({{r * std::cos(phi), r * std::sin(phi), z}, 2 * kPi / (kRings * kRings), 0});
        samples.back().sent = 0.7 * density(made, samples.back().direction);
        above += density(made, samples.back().direction) * samples.back().solidAngle;
      }
    const CosineFit fit = fitCosine(samples);
    ASSERT_TRUE(fit.known);
    EXPECT_LT(fit.distance2, 1e-5);
    EXPECT_NEAR(fit.above, above, 2e-3);
    for (const LobeSample& s : samples) ASSERT_NEAR(density(fit.matrix, s.direction), s.sent / 0.7, 0.02 * density(made, Z)) << angle;
    // The next search finds it where it starts.
    const CosineFit close = fitCosine(samples, &fit);
    EXPECT_LE(close.distance2, fit.distance2);
  }
  EXPECT_FALSE(fitCosine({{{0, 0, 1}, 1, 0}}).known);
}

// What the standard makes of every shape, against the reference: dielectrics and metals, small, large and cut by the horizon.
TEST_F(LightsTest, CosinesAreNearTheReference) {
  struct Case {
    const char* light;
    double dielectric, metal;   // of the light, as a mean of all pixels
  };
  const Case cases[] = {{"sphere:pos=1/2/2,cd=10,size=0.5", 0.02, 0.06},
                        {"sphere:pos=0.6/0.8/1.5,cd=10,size=0.6", 0.025, 0.06},
                        {"tube:from=-1.5/1/1.5,to=1.5/1.5/1.5,cd=10,size=0.05", 0.035, 0.09},
                        {"tube:from=-0.5/1/1.5,to=0.8/1.2/1,cd=10,size=0.25", 0.05, 0.08},
                        {"rectangle:pos=1/2/2,to=0/0/0,cd=10,width=2,height=1", 0.025, 0.06},
                        {"rectangle:pos=0/1.8/0,to=0/0/0,cd=10,width=3,height=3", 0.08, 0.06}};
  for (const Case& c : cases) {
    const auto light = parseLight(c.light);
    ASSERT_TRUE(light);
    for (const float metallic : {0.0f, 1.0f})
      for (const float roughness : {0.1f, 0.4f, 0.8f}) {
        const Scene s = scene("ggx", {.baseColor = glm::vec3(0.9f), .metallic = metallic, .roughness = roughness}, {*light});
        const ImageF fast = draw(s, AreaLights::Cosines), truth = draw(s, AreaLights::Cosines, 256);
        double off = 0, all = 0;
        for (size_t i = 0; i < truth.data.size(); i += 3) {
          off += std::abs(fast.data[i] - truth.data[i]);
          all += truth.data[i];
        }
        EXPECT_LT(off / all, metallic > 0 ? c.metal : c.dielectric) << c.light << ", roughness " << roughness << ", metallic " << metallic;
      }
  }
}

// They are lit two at a time: an odd one out counts once, wherever it stands among its kind.
TEST_F(LightsTest, OfAnyNumberAddUp) {
  const char* texts[] = {"sphere:pos=1/2/2,cd=3,size=0.5", "tube:from=-1/1/2,to=1/1/2,cd=2,size=0.1", "rectangle:pos=-1/-1/2,to=0/0/0,cd=4"};
  const test::Look look{.baseColor = glm::vec3(0.7f), .metallic = 0.5f, .roughness = 0.4f};
  for (const char* model : {"ggx", "clear-coat", "subsurface"}) {
    std::vector<float> sum;
    std::vector<Light> lights;
    for (const char* text : texts)
      for (int i = 0; i < 3; ++i) {
        Light light = *parseLight(text);
        light.position.x += 0.3f * float(i);
        light.color = {1, 0.5f * float(i), 0.2f};
        lights.push_back(light);
        const ImageF one = draw(scene(model, look, {light}), AreaLights::Cosines);
        sum.resize(one.data.size());
        for (size_t k = 0; k < sum.size(); ++k) sum[k] += one.data[k];
      }
    const ImageF all = draw(scene(model, look, lights), AreaLights::Cosines);
    for (size_t k = 0; k < all.data.size(); ++k) ASSERT_NEAR(all.data[k], sum[k], 1e-4 * sum[k] + 1e-6) << model;
  }
}

// The view of lights per tile: a spot is there where its cone is, and the picture is the same as of one in a larger cone.
TEST_F(LightsTest, SpotsReachTheirConeAlone) {
  Scene s;
  s.materials.push_back(test::material(models->find("ggx"), {}));
  const MeshPtr plane = planeMesh();
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) s.instances.push_back({plane, glm::scale(glm::translate(glm::mat4(1), {i - 3.5f, j - 3.5f, 0}), glm::vec3(0.5f)), 0});
  s.lights = {Light{.kind = LightKind::Spot, .position = {-2, -2, 3}, .candela = 20, .radius = 30, .axis = {0, 0, -1}, .innerAngle = 0.1f, .outerAngle = 0.25f}};
  Camera camera;
  camera.orthoHeight = 8;
  constexpr int kSide = 512;
  const View view{&s, camera, {0, 0, kSide, kSide}};
  RenderSettings settings;
  settings.view = "lightCount";
  const ImageF counts = renderer->linear(std::span(&view, 1), {kSide, kSide}, settings);
  settings.view = "lit";
  const ImageF lit = renderer->linear(std::span(&view, 1), {kSide, kSide}, settings);
  int counted = 0;
  for (size_t i = 0; i < lit.data.size(); i += 3) {
    counted += counts.data[i + 2] > 0;
    if (lit.data[i] > 0) {
      ASSERT_GT(counts.data[i + 2], 0) << "lit without a light, pixel " << i / 3;
    }
  }
  // It lights a disc of 0.77 m. Of the picture's 64 tiles that is 36 at most, with half a plane and a pixel around it, while its
  // sphere reaches all.
  EXPECT_GT(counted, 64 * 64);
  EXPECT_LE(counted, 36 * 64 * 64);
  // One that looks away reaches nothing.
  s.lights[0].axis = {0, 0, 1};
  settings.view = "lightCount";
  for (const float value : renderer->linear(std::span(&view, 1), {kSide, kSide}, settings).data) ASSERT_EQ(value, 0);
  // Nor does a rectangle, and one that stands across the middle reaches half.
  s.lights[0].kind = LightKind::Rectangle;
  for (const float value : renderer->linear(std::span(&view, 1), {kSide, kSide}, settings).data) ASSERT_EQ(value, 0);
  s.lights[0].position = {0, 0, 1};
  s.lights[0].axis = {1, 0, 0};
  const ImageF half = renderer->linear(std::span(&view, 1), {kSide, kSide}, settings);
  EXPECT_EQ(half.at(kSide / 8, kSide / 2)[2], 0);
  EXPECT_GT(half.at(kSide * 7 / 8, kSide / 2)[2], 0);
}

// Lights where they cannot be, drawn by every model with every method: never a pixel that is not a number.
TEST_F(LightsTest, OddOnesLeaveNothingInvalid) {
  const char* odd[] = {"sphere:pos=0/0/0,size=0.5", "sphere:pos=0/0/1,size=2",  "sphere:pos=0/0/1,size=0", "point:pos=0/0/1,constant=0",
                       "tube:from=0/0/1,to=0/0/1,size=0", "tube:from=0/0/-3,to=0/0/3,size=0.1", "tube:from=0/0/2,to=0/0/5,size=0",
                       "tube:from=-1/0/1,to=1/0/1,size=0.2", "rectangle:pos=0/0/1,dir=0/0/-1,width=0,height=0", "rectangle:pos=0/0/1,dir=1/0/0",
                       "rectangle:pos=0/0/0,dir=0/0/1,width=100,height=100", "spot:pos=0/0/1,dir=0/0/-1,inner=0,outer=0", "spot:pos=0/0/3,dir=0/0/1",
                       "sphere:pos=0/0/1.5,size=0.5,radius=0.001", "sphere:pos=0/1e8/0,size=1e7,cd=1e9,radius=1e9", "directional:dir=0/0/1,lux=1e9"};
  for (const ModelPtr& model : models->all())
    for (const AreaLightsInfo& method : areaLightMethods()) {
      if (method.method != AreaLights::Cosines && model->id != "ggx") continue;
      for (const float roughness : {0.0f, 1.0f}) {
        std::vector<Light> lights;
        for (const char* text : odd) {
          const auto light = parseLight(text);
          ASSERT_TRUE(light) << text;
          lights.push_back(*light);
        }
        Scene s = scene("ggx", {.baseColor = glm::vec3(1), .metallic = 1, .roughness = roughness}, lights);
        s.materials[0].model = model;
        draw(s, method.method);
        EXPECT_EQ(renderer->statistics().invalidPixels, 0) << model->id << " " << method.id << " " << roughness;
      }
    }
}

}  // namespace
}  // namespace glint
