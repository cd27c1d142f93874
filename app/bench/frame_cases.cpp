#include "app/bench/cases.h"
#include "app/bench/standard_scene.h"
#include "renderer/calibration.h"
#include "renderer/environment.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

RenderSettings plainSettings(Shadows shadows = Shadows::Off) {
  RenderSettings settings;
  settings.shadows = shadows;
  settings.screenOcclusion = shadows != Shadows::Off;
  settings.background = Background::None;  // the spheres are what is measured
  return settings;
}

View standardView(const Scene& scene) { return {&scene, standardCamera(), {0, 0, kStandardSize.x, kStandardSize.y}}; }

// One frame at 1280x720, to its last pixel.
void draw(BenchSetup& setup, const Scene& scene) {
  const View view = standardView(scene);
  setup.renderer().drawToTexture({&view, 1}, kStandardSize, plainSettings());
}

// The same with all shadows and occlusion; a camera that turns leaves nothing of the frame before but the maps, one that does
// not the shadows themselves.
BenchCase shadowCase(const std::string& name, const std::string& doc, bool turning) {
  return {name, doc, [=](BenchSetup& setup) -> Result<Measurement> {
            const auto model = plainModel(setup.libraries);
            if (!model) return model.diagnostics();
            auto scene = standardScene({*model}, setup.libraries);
            if (!scene) return scene.diagnostics();
            scene->lights.push_back(standardSun());
            View view = standardView(*scene);
            float turn = 0;
            Measurement result = measure(name, setup.effort, [&] {
              if (turning) view.camera.eye.x = 0.01f * ++turn;
              setup.renderer().drawToTexture({&view, 1}, kStandardSize, plainSettings(Shadows::Contact));
            });
            if (hasErrors(setup.renderer().problems())) return setup.renderer().problems();
            return result;
          }};
}

// frame.dir with antialiasing: of highlights, or of the edges of a view that turns.
BenchCase antialiasingCase(const std::string& name, const std::string& doc, bool turning) {
  return {name, doc, [=](BenchSetup& setup) -> Result<Measurement> {
            const auto model = plainModel(setup.libraries);
            if (!model) return model.diagnostics();
            auto scene = standardScene({*model}, setup.libraries);
            if (!scene) return scene.diagnostics();
            scene->lights.push_back(standardSun());
            View view = standardView(*scene);
            RenderSettings settings = plainSettings();
            settings.specularAntialiasing = !turning;
            settings.temporal = turning;
            float turn = 0;
            Measurement result = measure(name, setup.effort, [&] {
              if (turning) view.camera.eye.x = 0.01f * ++turn;
              setup.renderer().drawToTexture({&view, 1}, kStandardSize, settings);
            });
            if (hasErrors(setup.renderer().problems())) return setup.renderer().problems();
            return result;
          }};
}

Result<Scene> litScene(BenchSetup& setup, const std::vector<ModelPtr>& models, bool sun, bool environment, int points, LightKind kind = LightKind::Point) {
  auto scene = standardScene(models, setup.libraries);
  if (!scene) return scene;
  if (sun) scene->lights.push_back(standardSun());
  for (const Light& light : standardLights(kind, points)) scene->lights.push_back(light);
  if (environment) {
    auto studio = loadEnvironment("studio");
    if (!studio) return studio.diagnostics();
    scene->environment = *studio;
  }
  return scene;
}

BenchCase frameCase(const std::string& name, const std::string& doc, bool sun, bool environment, int points, LightKind kind = LightKind::Point) {
  return {name, doc, [=](BenchSetup& setup) -> Result<Measurement> {
            const auto model = plainModel(setup.libraries);
            if (!model) return model.diagnostics();
            const auto scene = litScene(setup, {*model}, sun, environment, points, kind);
            if (!scene) return scene.diagnostics();
            Measurement result = measure(name, setup.effort, [&] { draw(setup, *scene); });
            if (hasErrors(setup.renderer().problems())) return setup.renderer().problems();
            if (points > 0) result.note = fmt::format("lists of lights {:.2f} MiB", double(setup.renderer().statistics().lightBytes) / (1 << 20));
            return result;
          }};
}

// The lighting pass alone, on the G-buffer of one frame under 16 point lights.
BenchCase lightingCase(const std::string& name, const std::string& doc, const std::vector<ModelPtr>& models) {
  return {name, doc, [=](BenchSetup& setup) -> Result<Measurement> {
            const auto scene = litScene(setup, models, false, false, 16);
            if (!scene) return scene.diagnostics();
            draw(setup, *scene);
            if (hasErrors(setup.renderer().problems())) return setup.renderer().problems();
            return measure(name, setup.effort, [&] { setup.renderer().relight(); });
          }};
}

}  // namespace

std::vector<BenchCase> frameCases(const ModelRegistry& models) {
  std::vector<BenchCase> cases;
  cases.push_back({"calibrate", "fixed arithmetic, fill and triangles: divide by it to compare machines", [](BenchSetup& setup) -> Result<Measurement> {
                     Calibration calibration;
                     const double arithmetic = measure("", setup.effort, [&] { calibration.arithmetic(); }).median;
                     const double fill = measure("", setup.effort, [&] { calibration.fill(); }).median;
                     const double triangles = measure("", setup.effort, [&] { calibration.triangles(); }).median;
                     return measure("calibrate", setup.effort, [&] { calibration.all(); },
                                    fmt::format("arithmetic {:.1f}, fill {:.1f}, triangles {:.1f} ms", arithmetic, fill, triangles));
                   }});
  cases.push_back(frameCase("frame.dir", "the standard scene at 1280x720 under one directional light", true, false, 0));
  cases.push_back(antialiasingCase("frame.specular-aa", "frame.dir with roughness widened against glitter", false));
  cases.push_back(antialiasingCase("frame.temporal", "frame.dir with a camera that moves, averaged with the pictures before", true));
  cases.push_back(frameCase("frame.env", "under the studio environment", false, true, 0));
  cases.push_back(frameCase("frame.both", "under both", true, true, 0));
  cases.push_back(shadowCase("frame.shadow", "frame.dir with shadows, contact shadows and occlusion, nothing moving", false));
  cases.push_back(shadowCase("frame.shadow.turning", "the same with a camera that moves", true));
  for (const int count : {16, 128, 1024})
    cases.push_back(frameCase(fmt::format("frame.p{}", count), fmt::format("under {} point lights", count), false, false, count));
  for (const LightKind kind : {LightKind::Spot, LightKind::Sphere, LightKind::Tube, LightKind::Rectangle})
    cases.push_back(frameCase(fmt::format("frame.{}16", infoOf(kind).id), fmt::format("under 16 {} lights in the places of frame.p16", infoOf(kind).id), false, false, 16, kind));
  for (const ModelPtr& model : models.all())
    cases.push_back(lightingCase("model." + model->id, "the lighting pass alone with " + model->title + ", 16 point lights", {model}));
  // Of the shipped ones alone, so that the case is the same in every folder.
  std::vector<ModelPtr> four;
  for (const std::string& file : shipped::list("shaders/models", ".glsl"))
    if (const ModelPtr model = models.find(std::filesystem::path(file).stem().string()); model && four.size() < 4) four.push_back(model);
  std::string names;
  for (const ModelPtr& model : four) names += (names.empty() ? "" : ", ") + model->id;
  cases.push_back(lightingCase("models.4", "the same with four models sharing the screen: " + names, four));
  return cases;
}

Diagnostics drawFirstFrame(gl::Context& context, Libraries& libraries) {
  BenchSetup setup(context, libraries, {}, true);
  const auto model = plainModel(libraries);
  if (!model) return model.diagnostics();
  const auto scene = litScene(setup, {*model}, true, true, 0);
  if (!scene) return scene.diagnostics();
  draw(setup, *scene);
  return hasErrors(setup.renderer().problems()) ? setup.renderer().problems() : Diagnostics{};
}

}  // namespace glint
