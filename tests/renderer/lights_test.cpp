// Lights with a shape, as they are drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "app/scene_options.h"
#include "materials/model_registry.h"
#include "renderer/area_light_tables.h"
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
  static ImageF draw(const Scene& scene, AreaLights method = AreaLights::Unreal) {
    constexpr int kSide = 48;
    Camera camera;
    camera.orthoHeight = 2.2f;
    const View view{&scene, camera, {0, 0, kSide, kSide}};
    RenderSettings settings;
    settings.areaLights = method;
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

// A lobe that is a turned cosine is found again.
TEST(CosineFit, FindsWhatItWasMadeFrom) {
  const glm::dmat3 made(glm::dvec3(0.3, 0, -0.09), glm::dvec3(0, 0.4, 0), glm::dvec3(0.1, 0, 1));
  std::vector<glm::dvec3> directions;
  constexpr int kSide = 200;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double u = (i + 0.5) / kSide, phi = (j + 0.5) / kSide * kPi;
      directions.push_back(glm::normalize(made * glm::dvec3(std::sqrt(u) * std::cos(phi), std::sqrt(u) * std::sin(phi), std::sqrt(1 - u))));
    }
  const CosineFit fit = fitCosine(directions, std::vector<double>(directions.size(), 1.0));
  ASSERT_TRUE(fit.known);
  // The frame may be another; the lobe is the matrix times its transpose up to a scale, on the axis of z.
  const glm::dvec3 a = glm::normalize(made[2]), b = glm::normalize(fit.matrix[2]);
  EXPECT_GT(glm::dot(a, b), 0.99);
  for (const double x : {-0.4, 0.0, 0.5})
    for (const double y : {0.0, 0.3}) {
      const glm::dvec3 w = glm::normalize(glm::dvec3(x, y, 1));
      const auto density = [&](const glm::dmat3& m) {
        const glm::dvec3 c = glm::inverse(m) * w;
        return std::max(c.z, 0.0) / glm::length(c) / (std::abs(glm::determinant(m)) * std::pow(glm::length(c), 3));
      };
      EXPECT_NEAR(density(fit.matrix), density(made), 0.06 * density(made)) << x << " " << y;
    }
  EXPECT_FALSE(fitCosine({{0, 0, 1}}, {0.0}).known);
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
