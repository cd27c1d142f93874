// The Monte Carlo reference, against what is known exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/scene_options.h"
#include "materials/model_registry.h"
#include "renderer/environment.h"
#include "renderer/environment_sampler.h"
#include "renderer/model_integrals.h"
#include "renderer/renderer.h"
#include "tests/support/renderer_fixture.h"

namespace glint {
namespace {

constexpr double kPi = std::numbers::pi;

class ReferenceTest : public test::RendererFixture<ReferenceTest> {
 protected:
  static Scene scene(const ModelPtr& model, const test::Look& look, const std::vector<const char*>& lights) {
    Scene scene;
    scene.materials.push_back(test::material(model, look));
    scene.instances.push_back({sphere, glm::mat4(1), 0});
    for (const char* text : lights) {
      const auto light = parseLight(text);
      EXPECT_TRUE(light) << text;
      scene.lights.push_back(*light);
    }
    return scene;
  }
  static ImageF draw(const Scene& scene, int reference, int side = 24) {
    Camera camera;
    camera.orthoHeight = 2.2f;
    const View view{&scene, camera, {0, 0, side, side}};
    RenderSettings settings;
    settings.background = Background::None;
    settings.reference = reference;
    ImageF image = renderer->linear(std::span(&view, 1), {side, side}, settings);
    EXPECT_TRUE(renderer->problems().empty());
    return image;
  }
  // Where the normal is towards the camera, the middle of an odd number of pixels.
  static double center(const ImageF& image) { return image.at(image.width / 2, image.height / 2)[1]; }
};

TEST_F(ReferenceTest, LightsWithoutASurfaceAreExact) {
  for (const char* model : {"ggx", "subsurface", "clear-coat"}) {
    const Scene s = scene(models->find(model), {.baseColor = glm::vec3(0.6f, 0.4f, 0.2f), .roughness = 0.3f},
                          {"directional:dir=1/1/1,lux=2", "point:pos=1/1/2,cd=3", "spot:pos=-1/1/3,to=0/0/0,cd=20"});
    const ImageF fast = draw(s, 0);
    for (const int samples : {1, 3}) {
      const ImageF truth = draw(s, samples);
      double largest = 0;
      for (size_t i = 0; i < fast.data.size(); ++i)
        largest = std::max(largest, std::abs(double(truth.data[i]) - double(fast.data[i])) / (1e-3 + double(fast.data[i])));
      EXPECT_LT(largest, 1e-4) << model << " " << samples;
    }
  }
}

// The error view, against the difference of two pictures drawn one by one.
TEST_F(ReferenceTest, TheErrorViewComparesTheTwo) {
  const test::Look metal{.baseColor = glm::vec3(1, 0.8f, 0.6f), .metallic = 1, .roughness = 0.4f};
  constexpr int kSide = 32;
  Camera camera;
  camera.orthoHeight = 2.2f;
  RenderSettings settings;
  settings.background = Background::None;
  settings.areaLights = AreaLights::Plain;
  const auto luminance = [](const float* p) { return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]; };
  const auto drawn = [&](const Scene& s, const std::string& about, int reference) {
    const View view{&s, camera, {0, 0, kSide, kSide}};
    settings.view = about;
    settings.reference = reference;
    return renderer->linear(std::span(&view, 1), {kSide, kSide}, settings);
  };
  const auto errorOf = [&](const Scene& s, int reference) {
    const View view{&s, camera, {0, 0, kSide, kSide}};
    settings.view = kErrorView;
    settings.reference = reference;
    const Image8 picture = renderer->picture(std::span(&view, 1), {kSide, kSide}, settings);
    EXPECT_EQ(renderer->statistics().invalidPixels, 0);
    return std::pair(renderer->referenceErrors(std::span(&view, 1), {kSide, kSide}).front(), picture);
  };

  // One that is not made weaker is far too bright.
  const Scene plain = scene(models->find("ggx"), metal, {"sphere:pos=1/1/2,size=0.7,cd=10"});
  const ImageF about = drawn(plain, "lit", 0), truth = drawn(plain, "lit", 4096);
  double light = 0, absolute = 0, difference = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double a = luminance(&about.data[size_t(i) * 3]), r = luminance(&truth.data[size_t(i) * 3]);
    light += r;
    absolute += std::abs(a - r);
    difference += a - r;
  }
  const auto [error, picture] = errorOf(plain, 4096);
  EXPECT_NEAR(error.mean, absolute / light, 0.01 * absolute / light);
  EXPECT_NEAR(error.light, difference / light, 0.01 * absolute / light);
  EXPECT_GT(error.light, 0.3);
  EXPECT_LT(error.noise, 0.03);
  EXPECT_NEAR(error.pixels, kSide * kSide * kPi / (2.2 * 2.2), 12) << "all of the sphere and nothing else";
  // Where it faces the light the picture is orange, and the values are the errors.
  const int x = 22, y = 9;
  EXPECT_GT(picture.at(x, y)[0], picture.at(x, y)[2] + 100);
  const ImageF values = drawn(plain, kErrorView, 4096);
  EXPECT_NEAR(values.at(x, y)[1], about.at(x, y)[1] / truth.at(x, y)[1] - 1, 0.05);
  EXPECT_EQ(values.at(0, 0)[1], 0) << "no surface";

  // Without anything that is approximated there is no error; nor anything orange or blue.
  const auto [none, grey] = errorOf(scene(models->find("ggx"), metal, {"point:pos=1/1/2,cd=10", "directional:dir=1/0/1,lux=1"}), 2);
  EXPECT_LT(none.mean, 1e-5);
  EXPECT_LT(none.noise, 1e-5);
  for (size_t i = 0; i < grey.data.size(); i += 3) EXPECT_LE(std::abs(int(grey.data[i]) - int(grey.data[i + 2])), 1);
  // The same with several frames of one picture.
  settings.samples = 4;
  EXPECT_NEAR(errorOf(plain, 4096).first.light, error.light, 0.02);
}

// Under white light from all sides a white metal sends back its directional albedo.
TEST_F(ReferenceTest, FurnaceIsTheDirectionalAlbedo) {
  for (const char* id : {"ggx", "blinn-phong", "ggx-multiscatter"})
    for (const float roughness : {0.1f, 0.9f}) {
      Scene s = scene(models->find(id), {.baseColor = glm::vec3(1), .metallic = 1, .roughness = roughness}, {});
      s.environment = test::uniformEnvironment(1);
      auto integrals = ModelIntegrals::of(*models->find(id));
      ASSERT_TRUE(integrals);
      const IntegralQuery query{.roughness = roughness, .NoV = 1, .analyticLight = false};
      EXPECT_NEAR(center(draw(s, 2048, 9)), integrals->evaluate(std::span(&query, 1))[0].specular.g, 4e-3) << id << " " << roughness;
    }
}

// A surface that faces lights above its horizon, by closed forms.
TEST_F(ReferenceTest, LambertUnderShapes) {
  const test::Look white{.baseColor = glm::vec3(1), .roughness = 0.7f, .specular = 0};
  const ModelPtr lambert = *models->get("GGX*Implicit*Schlick");
  // With F0 = 0 a trace of Schlick's Fresnel is left, at grazing angles alone.
  const auto at = [&](const char* light) { return center(draw(scene(lambert, white, {light}), 8192, 9)) * kPi; };
  EXPECT_NEAR(at("sphere:pos=0/0/2,size=0.5,cd=10,radius=10000,constant=0"), 10, 0.06);
  EXPECT_NEAR(at("sphere:pos=0/0/6,size=0.01,cd=10,radius=10000,constant=0"), 10.0 / 25, 0.003);
  // A thin tube shines by the sine from its axis, unlike a line of points: 4 / pi times as much across it.
  EXPECT_NEAR(at("tube:from=-1/0/2,to=1/0/2,size=0.002,cd=10,radius=10000,constant=0"), 10 * 4 / kPi * (0.25 + kPi / 8), 0.05);
  // A square of side 2 at distance 1: the form factor from a point beneath its middle.
  const double corner = 1 / std::sqrt(2.0), factor = 4 * corner * std::atan(corner) / kPi;
  EXPECT_NEAR(at("rectangle:pos=0/0/2,dir=0/0/-1,width=2,height=2,nits=3,radius=10000,constant=0"), 3 * kPi * factor, 0.05);
  EXPECT_EQ(at("rectangle:pos=0/0/2,dir=0/0/1,width=2,height=2,nits=3,radius=10000,constant=0"), 0) << "it shines to one side";
  // Within a sphere it is all around.
  EXPECT_NEAR(at("sphere:pos=0/0/1.2,size=0.5,cd=1,radius=10000,constant=0"), 1 / 0.25, 0.03);
}

// A light that changes place and is sampled well is the same as one that is not: a sun of one pixel is a directional light.
TEST_F(ReferenceTest, ASmallSunIsADirectionalLight) {
  constexpr int kWidth = 256;
  auto sun = std::make_shared<Environment>();
  sun->name = "sun";
  sun->pixels = ImageF(kWidth, kWidth / 2, 3);
  const int x = 170, y = 40;
  const double solid = 2 * kPi / kWidth * (std::cos(kPi * y / (kWidth / 2)) - std::cos(kPi * (y + 1) / (kWidth / 2)));
  for (int c = 0; c < 3; ++c) sun->pixels.at(x, y)[c] = static_cast<float>(kPi / solid);
  sun->hash = 0x5171;
  const test::Look look{.baseColor = glm::vec3(0.8f), .roughness = 0.6f};
  const float turn = 0.7f;
  Scene lit = scene(models->find("ggx"), look, {"directional:dir=0/0/1,lux=3.14159265"});
  // Turning the environment about +Y by an angle takes its directions along.
  const glm::vec3 d = environmentDirection(x, y, kWidth, kWidth / 2);
  lit.lights[0].direction = {d.x * std::cos(turn) + d.z * std::sin(turn), d.y, d.z * std::cos(turn) - d.x * std::sin(turn)};
  Scene surrounded = scene(models->find("ggx"), look, {});
  surrounded.environment = sun;
  surrounded.environmentRotation = turn;
  const ImageF expected = draw(lit, 0), drawn = draw(surrounded, 1024);
  double sum = 0, off = 0;
  for (size_t i = 0; i < drawn.data.size(); ++i) {
    sum += double(expected.data[i]);
    off += std::abs(double(drawn.data[i]) - double(expected.data[i]));
  }
  EXPECT_GT(sum, 10);
  EXPECT_LT(off / sum, 0.02);
}

TEST_F(ReferenceTest, SharesOfAnEnvironment) {
  ImageF black(16, 8, 3);
  const EnvironmentSampler::Shares even = EnvironmentSampler::sharesOf(black);
  EXPECT_FLOAT_EQ(even.columns[4], 0.25f) << "black all over is drawn evenly";
  ImageF one = black;
  one.at(5, 3)[1] = 7;
  const EnvironmentSampler::Shares shares = EnvironmentSampler::sharesOf(one);
  ASSERT_EQ(shares.columns.size(), 17u * 8);
  ASSERT_EQ(shares.rows.size(), 9u);
  const float* row = &shares.columns[3 * 17];
  EXPECT_FLOAT_EQ(row[4], 0);
  EXPECT_FLOAT_EQ(row[5], 0.125f) << "light reaches half a texel into the neighbours";
  EXPECT_FLOAT_EQ(row[6], 0.875f);
  EXPECT_FLOAT_EQ(row[7], 1);
  EXPECT_FLOAT_EQ(shares.rows[2], 0);
  EXPECT_GT(shares.rows[3], 0.1f);
  EXPECT_FLOAT_EQ(shares.rows[5], 1);
}

// The same at every call; and as bright, whatever the number of samples.
TEST_F(ReferenceTest, IsDeterministicAndOfOneMean) {
  Scene s = scene(models->find("ggx"), {.baseColor = glm::vec3(0.8f), .roughness = 0.4f}, {"sphere:pos=1/1/2,size=0.5,cd=5"});
  s.environment = test::uniformEnvironment(0.5f);
  const ImageF once = draw(s, 16);
  EXPECT_EQ(once.data, draw(s, 16).data);
  const auto mean = [](const ImageF& image) {
    double sum = 0;
    for (const float v : image.data) sum += double(v);
    return sum / double(image.data.size());
  };
  const double all = mean(draw(s, 2048));
  EXPECT_NEAR(mean(once), all, 0.02 * all);
  EXPECT_NEAR(mean(draw(s, 1)), all, 0.06 * all);
}

// What is refined on screen becomes the picture.
TEST_F(ReferenceTest, RefinesATexture) {
  const Scene s = scene(models->find("ggx"), {.roughness = 0.4f}, {"sphere:pos=1/1/2,size=0.5,cd=5"});
  Camera camera;
  camera.orthoHeight = 2.2f;
  const View view{&s, camera, {0, 0, 16, 16}};
  RenderSettings settings;
  settings.background = Background::None;
  settings.samples = 4;
  settings.reference = 32;
  const Image8 whole = renderer->picture(std::span(&view, 1), {16, 16}, settings);
  unsigned texture = renderer->drawToTexture(std::span(&view, 1), {16, 16}, settings);
  for (int sample = 1; sample < 4; ++sample) texture = renderer->refineTexture(std::span(&view, 1), {16, 16}, settings, sample);
  std::vector<uint8_t> shown(16 * 16 * 4);
  glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(shown.size()), shown.data());
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_EQ(shown[static_cast<size_t>(((15 - y) * 16 + x) * 4 + c)], whole.at(x, y)[c]);
}

// Every model under every kind of light, also where lights cannot be: never a pixel that is not a number.
TEST_F(ReferenceTest, LeavesNothingInvalid) {
  const std::vector<const char*> lights = {
      "directional:dir=0/0/1,lux=1e9", "point:pos=0/0/1,constant=0", "spot:pos=0/0/1,dir=0/0/-1,inner=0,outer=0",
      "sphere:pos=1/1/1.5,size=0.5", "sphere:pos=0/0/0,size=0.5", "sphere:pos=0/0/1,size=2", "sphere:pos=0/1e8/0,size=1e7,cd=1e9,radius=1e9",
      "tube:from=-1/0/1,to=1/0/1,size=0.2", "tube:from=0/0/2,to=0/0/5,size=0", "tube:from=0/0/-3,to=0/0/3,size=0.1",
      "rectangle:pos=0/0/1,dir=0/0/-1,width=0,height=0", "rectangle:pos=0/0/1,dir=1/0/0", "rectangle:pos=0/0/0,dir=0/0/1,width=100,height=100"};
  auto bright = std::make_shared<Environment>(*test::uniformEnvironment(0));
  bright->pixels.at(40, 10)[0] = 1e6f;
  bright->hash = 0xb419;
  for (const ModelPtr& model : models->all())
    for (const float roughness : {0.0f, 1.0f}) {
      Scene s = scene(model, {.baseColor = glm::vec3(1), .metallic = 0.5f, .roughness = roughness}, lights);
      s.environment = bright;
      const ImageF image = draw(s, 3, 12);
      EXPECT_EQ(renderer->statistics().invalidPixels, 0) << model->id << " " << roughness;
      for (const float v : image.data) ASSERT_TRUE(std::isfinite(v)) << model->id;
    }
}

}  // namespace
}  // namespace glint
