// The functions that a plugin may have beside its terms, each seen in a picture: models are written here, none is named.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/renderer.h"
#include "tests/support/renderer_fixture.h"

namespace glint {
namespace {

class ModelFunctions : public test::RendererFixture<ModelFunctions> {
 protected:
  // A model with these keys in its head that has neither D nor diffuse part of its own.
  static ModelPtr model(const std::string& keys, const std::string& body) {
    const std::string nothing = body.find("specular(") == body.npos ? "vec3 specular(Shading s, Parameters p) { return vec3(0.0); }\n" : "";
    auto parsed = parseModel("m.glsl", "/*glint {\"id\": \"m\"" + keys + "} */\n" + nothing +
                                           (body.find(" diffuse(") == body.npos ? "vec3 diffuse(Shading s, Parameters p) { return vec3(0.0); }\n" : "") + body);
    EXPECT_TRUE(parsed) << (parsed ? "" : parsed.diagnostics()[0].text());
    return parsed ? std::make_shared<const ShadingModel>(std::move(*parsed)) : nullptr;
  }

  // A unit square facing +Z and the viewer; its tangent is +X.
  static Scene square(const ModelPtr& model, const test::Look& look = {.baseColor = glm::vec3(1), .metallic = 1}) {
    Scene scene;
    scene.materials.push_back(test::material(model, look));
    scene.instances.push_back({planeMesh(), glm::mat4(1), 0});
    return scene;
  }
  static Light fromDirection(const glm::vec3& d) { return {.kind = LightKind::Directional, .direction = glm::normalize(d), .lux = 1}; }

  static glm::vec3 color(const Scene& scene) {
    Camera camera;
    camera.orthoHeight = 1;
    const View view{&scene, camera, {0, 0, 8, 8}};
    const ImageF image = renderer->linear(std::span(&view, 1), {8, 8}, {});
    EXPECT_TRUE(renderer->problems().empty()) << renderer->problems()[0].text();
    return {image.at(4, 4)[0], image.at(4, 4)[1], image.at(4, 4)[2]};
  }
  static void expectNear(const glm::vec3& got, const glm::vec3& wanted, float tolerance = 2e-3f) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], tolerance) << "channel " << c;
  }
};

TEST_F(ModelFunctions, SeeTheSurfacesOwnTangent) {
  const std::string body = "vec3 diffuse(Shading s, Parameters p) { return s.T * 0.5 + 0.5; }\n";
  Scene scene = square(model("", body));
  scene.lights = {fromDirection({0, 0, 1})};
  expectNear(color(scene), {1, 0.5f, 0.5f});
  scene.instances[0].worldFromModel = glm::rotate(glm::mat4(1), glm::radians(30.f), glm::vec3(0, 0, 1));
  expectNear(color(scene), {0.5f + 0.5f * 0.8660f, 0.75f, 0.5f});
}

TEST_F(ModelFunctions, TheTangentTurnsByTheParameterThatTheHeadNames) {
  const std::string keys = R"(, "tangentRotation": "turn", "parameters": [{"name": "turn", "type": "float", "min": 0, "max": 360, "default": 90}])";
  Scene scene = square(model(keys, "vec3 diffuse(Shading s, Parameters p) { return vec3(s.T.xy, -s.B.x) * 0.5 + 0.5; }\n"));
  scene.lights = {fromDirection({0, 0, 1})};
  expectNear(color(scene), {0.5f, 1, 1});
}

// A lobe that is longer along one axis takes from an environment what lies along that axis: as its integral says.
TEST_F(ModelFunctions, AStretchedLobeGathersAlongItsLongAxis) {
  constexpr float kBand = 0.45f, kAlpha = 0.2f;  // |x| of the bright directions; of roughness 0.447
  const auto lobe = [](const char* axis) {
    return std::string("vec3 specular(Shading s, Parameters p) { float x = dot(s.H, s.") + axis +
           "), y2 = max(s.sinH2 - x * x, 0.0), a = s.alpha;\n"
           "  return vec3(exp(-x * x / (a * a * 6.0) - y2 / (a * a)) / (a * a)); }\n";
  };
  auto band = std::make_shared<Environment>();
  band->name = "band";
  band->pixels = ImageF(256, 128, 3);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) {
      const float phi = ((static_cast<float>(x) + 0.5f) / 256 - 0.5f) * 6.2831853f, theta = (static_cast<float>(y) + 0.5f) / 128 * 3.14159265f;
      for (int c = 0; c < 3; ++c) band->pixels.at(x, y)[c] = std::abs(std::sin(theta) * std::cos(phi)) < kBand ? 1.f : 0.f;
    }
  band->hash = 77;
  const auto share = [](bool across) {
    double inside = 0, all = 0;
    for (int i = 0; i < 400; ++i)
      for (int j = 0; j < 400; ++j) {
        const double z = (i + 0.5) / 400, phi = (j + 0.5) / 400 * 6.283185307, r = std::sqrt(1 - z * z);
        const glm::dvec3 l(r * std::cos(phi), r * std::sin(phi), z), h = glm::normalize(l + glm::dvec3(0, 0, 1));
        const double x = across ? h.x : h.y, y = across ? h.y : h.x, a2 = kAlpha * kAlpha;
        const double f = std::exp(-x * x / (a2 * 6) - y * y / a2) * z;
        all += f;
        if (std::abs(l.x) < kBand) inside += f;
      }
    return static_cast<float>(inside / all);
  };
  const auto lit = [&](const char* axis) {
    Scene scene = square(model("", lobe(axis)), {.baseColor = glm::vec3(1), .metallic = 1, .roughness = std::sqrt(kAlpha)});
    scene.environment = test::uniformEnvironment(1);
    const float everywhere = color(scene).g;
    scene.environment = band;
    return color(scene).g / everywhere;
  };
  ASSERT_GT(share(false) - share(true), 0.2f);
  EXPECT_NEAR(lit("T"), share(true), 0.06f);
  EXPECT_NEAR(lit("B"), share(false), 0.06f);
}

TEST_F(ModelFunctions, ColorsReplaceWhatFollowsFromTheAttributes) {
  Scene scene = square(model("", "void colors(inout Shading s, Parameters p) { s.diffuseColor = s.baseColor.bgr; }\n"
                                 "vec3 diffuse(Shading s, Parameters p) { return s.diffuseColor / kPi; }\n"),
                       {.baseColor = {0.2f, 0.4f, 0.8f}, .metallic = 1});
  scene.lights = {fromDirection({0, 0, 1})};
  scene.lights[0].lux = 3.14159265f;
  expectNear(color(scene), {0.8f, 0.4f, 0.2f});
  scene.lights.clear();
  scene.environment = test::uniformEnvironment(1);
  expectNear(color(scene), {0.8f, 0.4f, 0.2f}, 5e-3f);
}

TEST_F(ModelFunctions, EnvironmentTakesThePlaceOfTheTable) {
  Scene scene = square(model("", "vec3 environment(Shading s, Parameters p) { return vec3(0.25, s.NoV * 0.5, s.analyticLight ? 1.0 : 0.125); }\n"));
  scene.environment = test::uniformEnvironment(2);
  expectNear(color(scene), {0.5f, 1.0f, 0.25f});
}

const char* const kCoat = R"(, "coat": {"roughness": "coatRoughness", "strength": "coat"}, "parameters": [
  {"name": "coatRoughness", "type": "float", "default": 0.25}, {"name": "coat", "type": "float", "default": 0.5}])";

// The coat's function is evaluated with its own roughness, and shows by its strength.
TEST_F(ModelFunctions, CoatHasItsOwnRoughnessUnderLightsAndEnvironments) {
  const ModelPtr coated = model(kCoat, "vec3 coat(Shading s, Parameters p) { return vec3(s.roughness, 1.0, 0.5) / kPi; }\n");
  Scene scene = square(coated, {.baseColor = glm::vec3(1), .metallic = 1, .roughness = 0.9f});
  scene.lights = {fromDirection({0, 0, 1})};
  scene.lights[0].lux = 3.14159265f;
  expectNear(color(scene), {0.125f, 0.5f, 0.25f});
  scene.lights.clear();
  scene.environment = test::uniformEnvironment(1);
  expectNear(color(scene), {0.125f, 0.5f, 0.25f}, 5e-3f);
}

TEST_F(ModelFunctions, ACoatMayHaveAColor) {
  const ModelPtr coated = model(R"(, "coat": {"roughness": "r", "strength": "c"}, "parameters": [
    {"name": "r", "type": "float", "default": 0.5}, {"name": "c", "type": "color", "default": [0.25, 0.5, 0.75]}])",
                                "vec3 coat(Shading s, Parameters p) { return vec3(1.0) / kPi; }\n");
  Scene scene = square(coated);
  scene.environment = test::uniformEnvironment(1);
  expectNear(color(scene), {0.25f, 0.5f, 0.75f}, 5e-3f);
}

TEST_F(ModelFunctions, ThroughTheCoatComesWhatItLets) {
  const ModelPtr coated = model(kCoat, "vec3 coat(Shading s, Parameters p) { return vec3(0.0); }\n"
                                       "vec3 throughCoat(Shading s, Parameters p) { return vec3(1.0 - p.coat, 1.0, 0.0); }\n"
                                       "vec3 diffuse(Shading s, Parameters p) { return s.diffuseColor / kPi; }\n");
  Scene scene = square(coated, {.baseColor = glm::vec3(1), .metallic = 0, .specular = 0});
  scene.lights = {fromDirection({0, 0, 1})};
  scene.lights[0].lux = 3.14159265f;
  expectNear(color(scene), {0.5f, 1, 0});
  scene.lights.clear();
  scene.environment = test::uniformEnvironment(1);
  expectNear(color(scene), {0.5f, 1, 0}, 5e-3f);
}

TEST_F(ModelFunctions, ScatteredLightComesFromBehindToo) {
  const ModelPtr ice = model("", "vec3 scattered(Shading s, Parameters p) { return vec3(1.0, 1.0 - dot(s.N, s.L), 0.5) / (4.0 * kPi); }\n");
  Scene scene = square(ice);
  const float one = 1 / (4 * 3.14159265f);
  scene.lights = {fromDirection({0.3f, 0, 1})};
  expectNear(color(scene), {one, one * (1 - 0.9578f), 0.5f * one});
  scene.lights = {fromDirection({0.3f, 0, -1})};
  expectNear(color(scene), {one, one * (1 + 0.9578f), 0.5f * one});
  scene.lights.clear();
  scene.environment = test::uniformEnvironment(1);
  expectNear(color(scene), {1, 1, 0.5f}, 5e-3f);
}

// The material says nothing of metal: a model may take that for granted.
TEST_F(ModelFunctions, PlainNonmetalsAreTold) {
  const ModelPtr asking = model("", "vec3 environment(Shading s, Parameters p) { return vec3(s.plainNonmetal ? 0.25 : 0.75); }\n");
  EXPECT_TRUE(asking->usesPlainNonmetal);
  Scene scene = square(asking);
  scene.environment = test::uniformEnvironment(1);
  expectNear(color(scene), glm::vec3(0.75f));
  auto plain = std::make_shared<CompiledMaterial>(*scene.materials[0].compiled);
  plain->plainNonmetal = true;
  scene.materials[0].compiled = plain;
  expectNear(color(scene), glm::vec3(0.25f));
}

// A name that only some pass has is no reason to stop: the model is drawn as broken, and the fault is named.
TEST_F(ModelFunctions, NamesThatClashWithAPassAreReported) {
  Scene scene = square(model("", "float levelOf(float roughness) { return roughness; }\n"
                                 "vec3 environment(Shading s, Parameters p) { return vec3(levelOf(s.roughness)); }\n"));
  scene.environment = test::uniformEnvironment(1);
  const View view{&scene, Camera{}, {0, 0, 8, 8}};
  renderer->linear(std::span(&view, 1), {8, 8}, {});
  ASSERT_FALSE(renderer->problems().empty());
  EXPECT_NE(renderer->problems()[0].text().find("levelOf"), std::string::npos) << renderer->problems()[0].text();
}

}  // namespace
}  // namespace glint
