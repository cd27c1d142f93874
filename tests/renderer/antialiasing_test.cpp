// Edges and highlights against many samples of the same scene.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>
#include <random>

#include "renderer/environment.h"
#include "renderer/gl/gl.h"
#include "renderer/normal_variance.h"
#include "tests/support/renderer_fixture.h"

namespace glint {
namespace {

// A square of 2 m, seen from straight ahead, pixels shifted by parts of one.
Camera ahead(int side, glm::vec2 shift = glm::vec2(0), float height = 2.2f) {
  Camera camera;
  const glm::vec2 at = shift * height / static_cast<float>(side);
  camera.eye = {at, 4};
  camera.target = {at, 0};
  camera.orthoHeight = height;
  return camera;
}

double total(const ImageF& image) { return std::accumulate(image.data.begin(), image.data.end(), 0.0); }

// Root of the mean square of the difference, over the mean of the second.
double distance(const ImageF& a, const ImageF& b) {
  double sum = 0;
  for (size_t i = 0; i < a.data.size(); ++i) sum += std::pow(double(a.data[i]) - b.data[i], 2);
  return std::sqrt(sum / static_cast<double>(a.data.size())) / (total(b) / static_cast<double>(b.data.size()));
}

double distance(const Image8& a, const Image8& b) {
  double sum = 0;
  for (size_t i = 0; i < a.data.size(); ++i) sum += std::pow(double(a.data[i]) - b.data[i], 2);
  return std::sqrt(sum / static_cast<double>(a.data.size()));
}

// The mean of squares of side x side pixels.
ImageF reduced(const ImageF& image, int side) {
  ImageF small(image.width / side, image.height / side, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) small.at(x / side, y / side)[c] += image.at(x, y)[c] / static_cast<float>(side * side);
  return small;
}

class AntialiasingTest : public test::RendererFixture<AntialiasingTest> {
 protected:
  static ImageF draw(const Scene& scene, const Camera& camera, int side, const RenderSettings& settings) {
    const View view{&scene, camera, {0, 0, side, side}};
    return renderer->linear(std::span(&view, 1), {side, side}, settings);
  }
  static RenderSettings widened(bool on = true, int samples = 1) {
    RenderSettings settings;
    settings.background = Background::None;
    settings.specularAntialiasing = on;
    settings.samples = samples;
    return settings;
  }
  static Scene sphereOf(const char* model, float roughness, std::vector<Value> parameters = {}) {
    Scene scene;
    scene.materials.push_back(test::material(models->find(model), {.baseColor = glm::vec3(1), .metallic = 1, .roughness = roughness}));
    scene.materials[0].modelParameters = std::move(parameters);
    scene.instances.push_back({sphereMesh(64, 32), glm::mat4(1), 0});
    scene.lights = {{.kind = LightKind::Directional, .direction = glm::normalize(glm::vec3(1, 1, 1)), .lux = 3}};
    return scene;
  }

  // Of the light of a picture, as the camera moves by parts of a pixel: the mean, and the deviation as a part of the mean of
  // `of`. Where the highlight is less than a pixel it is there or not.
  struct Flicker {
    double mean = 0, deviation = 0;
  };
  static Flicker flicker(const Scene& scene, int side, const RenderSettings& settings) {
    std::vector<double> totals;
    for (int i = 0; i < 16; ++i)
      totals.push_back(total(draw(scene, ahead(side, glm::vec2(i % 4, i / 4) / 4.0f), side, settings)));
    Flicker f;
    f.mean = std::accumulate(totals.begin(), totals.end(), 0.0) / 16;
    for (const double t : totals) f.deviation += (t - f.mean) * (t - f.mean) / 16;
    f.deviation = std::sqrt(f.deviation) / f.mean;
    return f;
  }

  // A plane of metal with bumps of a texel, of slopes up to `slope`, whose colour is the base colour.
  static Scene bumps(float roughness, float slope, const Image8Ptr& map) {
    Scene scene;
    SurfaceMaterial material = test::material(models->find("ggx"), {.baseColor = glm::vec3(1), .metallic = 1, .roughness = roughness});
    auto compiled = std::make_shared<CompiledMaterial>(*material.compiled);
    compiled->glsl =
        "layout(std140, binding = 1) uniform MaterialParameters { vec4 colorAndMetallic; vec4 rest; };\n"
        "layout(binding = 8) uniform sampler2D t_bumps;\n"
        "void evaluateMaterial(in MaterialInputs i, inout MaterialAttributes m) {\n"
        "  vec4 t = texture(t_bumps, i.uv0); vec2 xy = t.xy * 2.0 - 1.0;\n"
        "  m.baseColor = colorAndMetallic.rgb; m.metallic = colorAndMetallic.a;\n"
        "  m.specular = rest.y; m.roughness = rest.x; m.cavity = 1.0; m.ambientOcclusion = 1.0;\n"
        "  m.normal = normalize(vec3(xy, sqrt(max(1.0 - dot(xy, xy), 1e-6)))); m.normalVariance = (1.0 - t.a) * (1.0 - t.a);\n"
        "  m.emissive = vec3(0.0); m.opacityMask = 1.0;\n}\n";
    compiled->hash = hashText(compiled->glsl);
    compiled->writesNormal = true;
    TextureSlot slot;
    slot.sampler = "t_bumps";
    slot.colorSpace = ColorSpace::Linear;
    slot.normals = true;
    compiled->textures.push_back(slot);
    material.compiled = compiled;
    material.textures.push_back(map);
    scene.materials.push_back(material);
    scene.instances.push_back({planeMesh(), glm::mat4(1), 0});
    // All around the mirror direction, as many as there is solid angle: what tilted normals reflect, whatever the shape of D.
    for (int k = 1; k <= 12; ++k) {
      const float tilt = 4 * slope * static_cast<float>(k) / 12, around = 2.4f * static_cast<float>(k);
      const glm::vec3 half(tilt * std::cos(around), tilt * std::sin(around), 1);
      scene.lights.push_back({.kind = LightKind::Directional, .direction = glm::reflect(glm::vec3(0, 0, -1), glm::normalize(half)), .lux = tilt});
    }
    return scene;
  }
  static Image8Ptr bumpMap(int side, float slope, unsigned seed = 1) {
    auto image = std::make_shared<Image8>(side, side, 3);
    std::mt19937 random(seed);
    std::normal_distribution<float> normal(0, slope);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const glm::vec3 n = glm::normalize(glm::vec3(normal(random), normal(random), 1));
        for (int c = 0; c < 3; ++c) image->at(x, y)[c] = static_cast<uint8_t>(std::lround((n[c] * 0.5f + 0.5f) * 255));
      }
    return image;
  }
};

TEST_F(AntialiasingTest, AHighlightSmallerThanAPixelDoesNotFlicker) {
  const Scene scene = sphereOf("ggx", 0.1f);
  const double truth = total(draw(scene, ahead(24), 24, widened(false, 1024)));
  const Flicker aliased = flicker(scene, 24, widened(false)), smooth = flicker(scene, 24, widened());
  // Measured: 3.03 and 0.14, means 1.34 and 1.006.
  EXPECT_GT(aliased.deviation, 1);
  EXPECT_LT(smooth.deviation, 0.3);
  EXPECT_NEAR(smooth.mean / truth, 1, 0.05);
  // Of four pictures each has a quarter of the pixel, and none is wider than it must be.
  const Flicker four = flicker(scene, 24, widened(true, 4));
  EXPECT_LT(four.deviation, 0.6);
  EXPECT_NEAR(four.mean / truth, 1, 0.05);
}

// Where nothing glitters nothing is lost.
TEST_F(AntialiasingTest, UnderAnEnvironmentASphereIsNoFartherFromTheReference) {
  Scene scene = sphereOf("ggx", 0.3f);
  scene.lights.clear();
  const auto studio = loadEnvironment("studio");
  ASSERT_TRUE(studio);
  scene.environment = *studio;
  const auto picture = [&](bool on, int samples) {
    const View view{&scene, ahead(64), {0, 0, 64, 64}};
    RenderSettings settings = widened(on, samples);
    settings.background = Background::Environment;   // which hides how rough the edge is
    return renderer->picture(std::span(&view, 1), {64, 64}, settings);
  };
  const Image8 truth = picture(false, 256);
  // Measured, of 255: 2.2 and 2.3.
  EXPECT_LT(distance(picture(true, 1), truth), distance(picture(false, 1), truth));
}

TEST_F(AntialiasingTest, BothWidthsOfALobeAndACoatAreWidened) {
  const Scene stretched = sphereOf("ggx-anisotropic", 0.1f);
  const double before = flicker(stretched, 24, widened(false)).deviation, after = flicker(stretched, 24, widened()).deviation;
  EXPECT_LT(after, 0.5 * before);
  Scene coated = sphereOf("clear-coat", 1, {Value::scalar(1), Value::scalar(0.1f)});
  coated.materials[0].block = test::material(models->find("ggx"), {.baseColor = glm::vec3(0), .roughness = 1, .specular = 0}).block;
  const double bare = flicker(coated, 24, widened(false)).deviation, wide = flicker(coated, 24, widened()).deviation;
  EXPECT_LT(wide, 0.3 * bare);
}

// 8 x 8 bumps under each pixel: the pixel is the mean of 16 x 16 of a picture that has two for each.
TEST_F(AntialiasingTest, ANormalMapFarAwayKeepsTheWidthOfItsLobe) {
  const Image8Ptr map = bumpMap(512, 0.15f);
  const Scene scene = bumps(0.25f, 0.15f, map);
  const Camera camera = ahead(64, glm::vec2(0), 2);
  const ImageF truth = reduced(draw(scene, camera, 1024, widened(false)), 16);
  const ImageF aliased = draw(scene, camera, 64, widened(false)), smooth = draw(scene, camera, 64, widened());
  // Measured: 0.071 and 0.255, means 0.96 and 0.83.
  EXPECT_LT(distance(smooth, truth), 0.6 * distance(aliased, truth));
  EXPECT_NEAR(total(smooth) / total(truth), 1, 0.1);
  // Of several pictures each sees finer bumps, and together they show what one cannot: which pixels have the steep ones.
  const ImageF sixteen = draw(scene, camera, 64, widened(true, 16));
  EXPECT_LT(distance(sixteen, truth), distance(smooth, truth));
  EXPECT_NEAR(total(sixteen) / total(truth), 1, 0.1);
  // Near by there is nothing to add.
  EXPECT_EQ(draw(scene, camera, 1024, widened()).data, draw(scene, camera, 1024, widened(false)).data);
}

TEST_F(AntialiasingTest, VarianceOfNormalsIsInTheSmallerLevels) {
  const auto levels = encodedNormalVariance(*bumpMap(64, 0.2f));
  ASSERT_EQ(levels.size(), 7u);
  EXPECT_EQ(levels[0].width, 64);
  for (const uint8_t a : levels[0].data) EXPECT_EQ(a, 255);
  const auto variance = [&](size_t level) { return std::pow(1 - levels[level].data[0] / 255.0, 2); };
  // Of slopes of deviation 0.2; the average of normals is a little less than that of slopes.
  EXPECT_NEAR(variance(6), 0.04, 0.006);
  Image8 flat(5, 3, 3);
  for (size_t i = 0; i < flat.data.size(); ++i) flat.data[i] = i % 3 == 2 ? 255 : 128;
  const auto none = encodedNormalVariance(flat);
  ASSERT_EQ(none.size(), 3u);
  for (const auto& level : none)
    for (const uint8_t a : level.data) EXPECT_EQ(a, 255);
  EXPECT_EQ(none[1].width, 2);
  EXPECT_EQ(none[1].height, 1);
  EXPECT_EQ(encodedNormalVariance(Image8(4, 4, 1)).size(), 3u);
}

TEST_F(AntialiasingTest, ReferencesAndTheFurnaceHaveTheRoughnessAsItIs) {
  Scene scene = sphereOf("ggx", 0.1f);
  RenderSettings on = widened(), off = widened(false);
  on.reference = off.reference = 4;
  EXPECT_EQ(draw(scene, ahead(24), 24, on).data, draw(scene, ahead(24), 24, off).data);
  on.view = off.view = kErrorView;
  EXPECT_EQ(draw(scene, ahead(24), 24, on).data, draw(scene, ahead(24), 24, off).data);
  on = widened(), off = widened(false);
  on.view = off.view = kFurnaceView;
  EXPECT_EQ(draw(scene, ahead(24), 24, on).data, draw(scene, ahead(24), 24, off).data);
}

TEST_F(AntialiasingTest, NothingIsEverNotANumber) {
  for (const char* model : {"ggx", "clear-coat", "ggx-anisotropic"})
    for (const float roughness : {0.0f, 1.0f}) {
      Scene scene = sphereOf(model, roughness);
      scene.instances.push_back({sphere, glm::scale(glm::translate(glm::mat4(1), {1, 1, 0}), glm::vec3(1e-3f)), 0});
      scene.instances.push_back({sphere, glm::scale(glm::translate(glm::mat4(1), {-1, 1, 0}), glm::vec3(0.2f, 0, 0.2f)), 0});
      (void)draw(scene, ahead(32), 32, widened());
      EXPECT_EQ(renderer->statistics().invalidPixels, 0) << model << " " << roughness;
    }
}

// -- Edges ---------------------------------------------------------------------------------------------------------------

class EdgesTest : public AntialiasingTest {
 protected:
  static constexpr int kSide = 128;
  static Scene cubes() {
    Scene scene;
    scene.materials.push_back(test::material(models->find("ggx"), {.baseColor = {0.9f, 0.5f, 0.1f}, .roughness = 0.6f}));
    scene.materials.push_back(test::material(models->find("ggx"), {.baseColor = {0.1f, 0.3f, 0.8f}, .roughness = 0.6f}));
    scene.instances.push_back({cubeMesh(), glm::scale(glm::mat4(1), glm::vec3(0.5f)), 0});
    scene.instances.push_back({cubeMesh(), glm::scale(glm::translate(glm::mat4(1), {0.7f, 0, -1.5f}), glm::vec3(0.5f)), 1});
    scene.lights = {{.kind = LightKind::Directional, .direction = glm::normalize(glm::vec3(1, 2, 3)), .lux = 4}};
    return scene;
  }
  static Camera orbit(float degrees) {
    Camera camera;
    const float a = glm::radians(degrees);
    camera.eye = 4.0f * glm::vec3(std::sin(a), 0.3f, std::cos(a));
    return camera;
  }
  static RenderSettings settings(int samples = 1) {
    RenderSettings s;
    s.background = Background::Color;
    s.backgroundColor = glm::vec3(0.02f);
    s.samples = samples;
    return s;
  }
  static RenderSettings following() {
    RenderSettings s = settings();
    s.temporal = true;
    return s;
  }
  static Image8 picture(const Scene& scene, const Camera& camera, int samples) {
    const View view{&scene, camera, {0, 0, kSide, kSide}};
    return renderer->picture(std::span(&view, 1), {kSide, kSide}, settings(samples));
  }
  // What a window would show.
  static Image8 shown(unsigned texture) {
    std::vector<uint8_t> pixels(size_t{kSide} * kSide * 4);
    glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()), pixels.data());
    Image8 image(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) std::copy_n(&pixels[(size_t(kSide - 1 - y) * kSide + size_t(x)) * 4], 3, image.at(x, y));
    return image;
  }
  static Image8 next(const Scene& scene, const Camera& camera, const RenderSettings& s = following()) {
    const View view{&scene, camera, {0, 0, kSide, kSide}};
    return shown(renderer->drawToTexture(std::span(&view, 1), {kSide, kSide}, s));
  }
  // A picture of another size has none before it.
  static void forget(const Scene& scene) {
    const View view{&scene, orbit(0), {0, 0, 8, 8}};
    (void)renderer->drawToTexture(std::span(&view, 1), {8, 8}, following());
  }
  static Image8 refined(const Scene& scene, const Camera& camera, int sample, const RenderSettings& s) {
    const View view{&scene, camera, {0, 0, kSide, kSide}};
    return shown(renderer->refineTexture(std::span(&view, 1), {kSide, kSide}, s, sample));
  }
};

TEST_F(EdgesTest, OfAnAverageAreNearerTheReference) {
  const Scene scene = cubes();
  const Image8 truth = picture(scene, orbit(20), 256);
  const double one = distance(picture(scene, orbit(20), 1), truth), eight = distance(picture(scene, orbit(20), 8), truth), sixteen = distance(picture(scene, orbit(20), 16), truth);
  // Measured, of 255: 2.1 and 6.6.
  EXPECT_LT(eight, 0.4 * one);
  EXPECT_LT(sixteen, eight);
}

TEST_F(EdgesTest, OfAViewThatMovesAreNearerTheReference) {
  const Scene scene = cubes();
  Image8 moving;
  for (int i = 0; i <= 12; ++i) moving = next(scene, orbit(20 + 0.7f * static_cast<float>(i)));
  const Camera last = orbit(20 + 0.7f * 12);
  const Image8 truth = picture(scene, last, 256);
  const double aliased = distance(picture(scene, last, 1), truth), smooth = distance(moving, truth);
  EXPECT_LT(smooth, 0.7 * aliased);
  // A view that stays is as good as many pictures.
  for (int i = 0; i < 24; ++i) moving = next(scene, last);
  EXPECT_LT(distance(moving, truth), 0.4 * aliased);
}

// Each view of a picture has a past of its own, in either projection, with the surroundings behind it.
TEST_F(EdgesTest, OfSeveralViewsThatMoveAreEachItsOwn) {
  Scene scene = cubes();
  scene.environment = test::uniformEnvironment(0.2f);
  const auto views = [&](float degrees) {
    Camera far = orbit(degrees + 15);
    far.orthoHeight = 2.5f;
    return std::array{View{&scene, orbit(degrees), {0, 0, kSide / 2, kSide}}, View{&scene, far, {kSide / 2, 0, kSide / 2, kSide}}};
  };
  RenderSettings s = following();
  s.background = Background::Environment;
  Image8 moving;
  for (int i = 0; i <= 12; ++i) moving = shown(renderer->drawToTexture(views(20 + 0.4f * static_cast<float>(i)), {kSide, kSide}, s));
  const auto last = views(20 + 0.4f * 12);
  s.samples = 256;
  const Image8 truth = renderer->picture(last, {kSide, kSide}, s);
  s.samples = 1;
  const Image8 aliased = renderer->picture(last, {kSide, kSide}, s);
  const auto half = [](const Image8& image, int x0) {
    Image8 part(kSide / 2, kSide, 3);
    for (int y = 0; y < kSide; ++y) std::copy_n(image.at(x0, y), 3 * kSide / 2, part.at(0, y));
    return part;
  };
  for (const int x0 : {0, kSide / 2}) {
    EXPECT_LT(distance(half(moving, x0), half(truth, x0)), 0.7 * distance(half(aliased, x0), half(truth, x0)));
  }
}

// After a jump the picture is no worse than one that has nothing before it, of any of the offsets within the pixel.
TEST_F(EdgesTest, NothingIsLeftOfWhatIsGone) {
  Scene other = cubes();
  other.instances.pop_back();
  const Scene scene = cubes();
  const Image8 turned = picture(scene, orbit(75), 256), emptied = picture(other, orbit(20), 256);
  double jump = 0, fresh = 0, gone = 0, without = 0;
  for (int i = 0; i < 16; ++i) {
    for (int k = 0; k < 5; ++k) (void)next(scene, orbit(20));
    jump += distance(next(scene, orbit(75)), turned);
    for (int k = 0; k < 5; ++k) (void)next(scene, orbit(20));
    gone += distance(next(other, orbit(20)), emptied);
    forget(scene);
    fresh += distance(next(scene, orbit(75)), turned);
    forget(scene);
    without += distance(next(other, orbit(20)), emptied);
  }
  EXPECT_LT(jump, 1.35 * fresh);
  EXPECT_LT(gone, without);
}

// Wherever it has been before, a view that rests converges to the same average.
TEST_F(EdgesTest, OfAViewThatRestsAreThoseOfTheAverage) {
  const Scene scene = cubes();
  const Camera camera = orbit(20);
  Image8 still = next(scene, camera, settings());
  EXPECT_EQ(still, picture(scene, camera, 1));
  for (int sample = 1; sample < 8; ++sample) still = refined(scene, camera, sample, settings());
  EXPECT_EQ(still, picture(scene, camera, 8));

  for (int i = 8; i >= 0; --i) (void)next(scene, orbit(20 + static_cast<float>(i)));
  const Image8 truth = picture(scene, camera, 256);
  for (int i = 8; i >= 0; --i) still = next(scene, orbit(20 + static_cast<float>(i)));
  double worst = distance(still, truth);
  const double aliased = distance(picture(scene, camera, 1), truth);
  for (int i = 8; i >= 0; --i) still = next(scene, orbit(20 + static_cast<float>(i)));
  for (int sample = 1; sample < 8; ++sample) {
    still = refined(scene, camera, sample, following());
    worst = std::max(worst, distance(still, truth));
  }
  EXPECT_EQ(still, picture(scene, camera, 8));
  EXPECT_LT(worst, 0.7 * aliased) << "it does not get rough on the way";

  // It starts to move from there, not from nothing.
  for (int sample = 1; sample < 8; ++sample) (void)refined(scene, camera, sample, following());
  const Image8 start = next(scene, orbit(20.3f)), there = picture(scene, orbit(20.3f), 256);
  EXPECT_LT(distance(start, there), 0.6 * distance(picture(scene, orbit(20.3f), 1), there));
}

}  // namespace
}  // namespace glint
