// glint render: one picture of one scene.
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/health_text.h"
#include "app/picture_file.h"
#include "app/scene_loader.h"
#include "app/scene_options.h"
#include "materials/base/log.h"
#include "renderer/ground.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

void append(Diagnostics& to, const Diagnostics& from) { to.insert(to.end(), from.begin(), from.end()); }

// FILE is a mesh or a material by its extension; --mesh and --material say the same at length.
void takeFile(const std::string& file, SceneOptions& options, Diagnostics& problems) {
  const std::filesystem::path path = file;
  const bool mesh = path.extension() == ".glb" || path.extension() == ".gltf";
  if (!mesh && path.extension() != ".json") {
    problems.push_back(error(file, "is neither a mesh nor a material by its name", "give a .glb, .gltf or .json file"));
    return;
  }
  std::string& to = mesh ? options.mesh : options.material;
  if (!to.empty())
    problems.push_back(error(file, fmt::format("--{} names '{}' already", mesh ? "mesh" : "material", to), "give one of them"));
  to = file;
}

int run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  Diagnostics problems, warnings;
  auto options = parseSceneOptions(arguments);
  if (!options) append(problems, options.diagnostics());
  const std::filesystem::path output = arguments.get("output");
  const auto kind = checkOutput(output, "--output");
  if (!kind) append(problems, kind.diagnostics());
  if (options && arguments.has("file")) takeFile(arguments.get("file"), *options, problems);
  if (!problems.empty()) return badInput(problems);

  Libraries libraries(arguments.modelFolders);
  log::report(libraries.models.warnings());
  log::report(tonemapWarning(arguments, output, *kind));
  auto scene = loadScene(*options, libraries, warnings);
  log::report(warnings);
  if (!scene) return badInput(scene.diagnostics());

  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  Renderer renderer(**context);
  renderer.setProgress(log::progress);
  Camera camera = frameScene(*scene, float(options->size.x) / float(options->size.y));
  options->camera.apply(camera);
  if (options->ground != Ground::None) {
    const auto plain = libraries.model(newMaterial("ground").model, "--ground");
    if (!plain) return badInput(plain.diagnostics());
    addGround(*scene, options->ground, *plain);
    includeGround(camera, *scene);
    if (options->ground == Ground::Shadow && options->render.shadows == Shadows::Off && !options->render.screenOcclusion)
      log::report(warning("--ground", "shadow shows nothing", "without --shadows or --occlusion screen nothing is kept from it"));
  }
  const View view{&*scene, camera, {0, 0, options->size.x, options->size.y}};
  const ImageNotes notes = pictureNotes(arguments, **context, {&*scene, 1});
  Image8 picture;
  ImageF linear;
  if (*kind == PictureKind::Display) picture = renderer.picture({&view, 1}, options->size, options->render);
  else linear = renderer.linear({&view, 1}, options->size, options->render);
  ReferenceError off;
  if (options->render.view == kErrorView) off = renderer.referenceErrors({&view, 1}, options->size).front();
  // A plugin that does not compile leaves nothing to show.
  if (hasErrors(renderer.problems())) return badInput(renderer.problems());
  log::report(renderer.problems());
  const Diagnostics faults = *kind == PictureKind::Display ? writeImage8(output, picture, notes) : writeImageF(output, linear, notes);
  if (!faults.empty()) return badInput(faults);

  const Renderer::Statistics& statistics = renderer.statistics();
  if (statistics.invalidPixels > 0)
    log::report(invalidPixelsWarning(output, statistics.invalidPixels));
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  if (arguments.json) {
    nlohmann::ordered_json document;
    document["file"] = output.string();
    document["width"] = options->size.x;
    document["height"] = options->size.y;
    document["triangles"] = statistics.triangles;
    document["lights"] = statistics.lights;
    document["invalidPixels"] = statistics.invalidPixels;
    document["milliseconds"] = ms;
    if (options->render.view == kErrorView) document["error"] = {{"mean", off.mean}, {"noise", off.noise}, {"light", off.light}};
    document["notes"] = notes;
    fmt::print("{}\n", document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!arguments.quiet) {
    fmt::print("{}\n", output.string());
    if (options->render.view == kErrorView) fmt::print("{}, of {} samples a pixel; {}\n", errorText(off), options->render.reference, errorScaleText(options->render.errorScale));
  }
  return kDone;
}

std::vector<Option> options() {
  std::vector<Option> all = {{"file", "FILE", "a mesh (.glb, .gltf) or a material (.json); a sphere with the default material otherwise"},
                             {"-o,--output", "OUT", ".png (display-referred), or .exr, .hdr, .pfm (linear)", false, true}};
  for (Option& option : sceneOptionTable()) all.push_back(std::move(option));
  return all;
}

}  // namespace

extern const Command kRenderCommand;
const Command kRenderCommand = {
    .name = "render",
    .summary = "Render one picture of a mesh or a material",
    .options = options(),
    .examples = {"glint render -o sphere.png",
                 "glint render helmet.glb --env sky --background blur --tonemap aces -o helmet.png",
                 "glint render --mesh shaderball --material painted-metal --model ggx --samples 16 -o ball.png",
                 "glint render --set roughness=0.2 --set metallic=1 --light directional:dir=1/1/1,lux=3.14 --env none -o lit.exr"},
    .run = run,
};

}  // namespace glint
