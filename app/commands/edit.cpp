// glint edit: the editor, in a window; without a display, the standard comparison as a picture instead.
#include <filesystem>

#include "app/command.h"
#include "app/editor/ui_driver.h"
#include "app/editor/window.h"
#include "app/picture_file.h"
#include "app/scene_options.h"
#include "app/standard_comparison.h"
#include "materials/base/files.h"
#include "materials/base/log.h"
#include "materials/model_file.h"
#include "renderer/image_io.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

// What cannot be opened is refused before a window appears.
Diagnostics unreadable(const std::vector<fs::path>& files) {
  Diagnostics problems;
  for (const fs::path& file : files) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) problems.push_back(error(file.string(), "no such file", "check the path"));
    else if (!fs::is_regular_file(file, ignored)) problems.push_back(error(file.string(), "not a file", "name a material, mesh, environment, picture or plugin"));
  }
  return problems;
}

int takeScreenshot(const Arguments& arguments, const std::vector<fs::path>& files, EditorOptions options) {
  const std::string out = arguments.get("screenshot");
  if (const Diagnostics problems = checkOutput(out, "--screenshot", "picture", {".png"}); !problems.empty()) return badInput(problems);
  const auto size = parseSize(arguments.get("size", "1600x960"), "--size");
  if (!size) return badInput(size.diagnostics());
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  // A picture for a page must not depend on what the last session left; the user's models are no session.
  options.configFolder.clear();
  UiDriver driver(**context, std::move(options), *size);
  driver.editor().openFiles(files);
  if (!driver.settle(120)) log::report(warning("--screenshot", "the picture was still being drawn after two minutes", "choose a smaller size or fewer cells"));
  driver.awaitHealth(120);  // else badges say that they are being measured
  const Image8 picture = driver.screenshot();
  const ImageNotes notes = {{"Command", arguments.commandLine}, {"Software", "Glint " GLINT_VERSION}, {"OpenGL renderer", (*context)->info().renderer}};
  const Diagnostics problems = writeImage8(out, picture, notes);
  if (!problems.empty()) return badInput(problems);
  log::info("wrote " + out);
  return kDone;
}

int run(const Arguments& arguments) {
  const auto given = arguments.all("file");
  const std::vector<fs::path> files(given.begin(), given.end());
  if (const Diagnostics problems = unreadable(files); !problems.empty()) return badInput(problems);
  EditorOptions options{.modelFolders = arguments.modelFolders, .configFolder = configFolder()};
  // A plugin named here is used where it lies, so that what is written to it next is seen.
  for (const fs::path& file : files)
    if (isModelFile(file)) options.modelFiles.push_back(fs::absolute(file));
  if (arguments.has("screenshot")) return takeScreenshot(arguments, files, std::move(options));

  const Session session = Session::read(options.configFolder / "editor.json");
  auto context = arguments.backend == gl::Backend::Auto || arguments.backend == gl::Backend::Glfw
                     ? gl::Context::create({.backend = gl::Backend::Glfw, .window = true, .width = session.width, .height = session.height})
                     : Result<std::unique_ptr<gl::Context>>(error("--backend", "the editor needs a window", "leave --backend out, or use glfw"));
  if (context) return runWindow(**context, std::move(options), files);
  if (arguments.backend == gl::Backend::Glfw) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  // The comparison stands in for an editor that was only looked for, not for one that was to open something.
  if (!files.empty()) {
    log::report(error(files.front().string(), "no display to open it on: " + context.diagnostics().front().what,
                      "glint render draws it, glint edit --screenshot OUT.png shows the editor on it"));
    return kNoContext;
  }
  log::info("no display for the editor (" + context.diagnostics().front().what + "): rendering the standard comparison instead");
  return renderStandardComparison(arguments);
}

}  // namespace

extern const Command kEditCommand;
const Command kEditCommand = {
    .name = "edit",
    .summary = "Open the editor on a material, a mesh or a project",
    .options = {{"file", "FILE", "material or project (.json), mesh (.glb, .gltf), environment or plugin", true},
                {"--screenshot", "OUT.png", "draw the editor without a window, write its picture and leave"},
                {"--size", "WxH", "of the screenshot (1600x960)"}},
    .examples = {"glint edit materials/library/painted-metal.json", "glint edit model.glb", "glint edit --screenshot editor.png --size 1920x1080"},
    .run = run,
};

}  // namespace glint
