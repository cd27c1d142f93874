// The deferred renderer: scene in, pictures out. One Renderer belongs to one thread and one context.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "renderer/gl/context.h"
#include "renderer/image.h"
#include "renderer/reference_error.h"
#include "renderer/scene.h"

namespace glint {

class EnvironmentLighting;

enum class Tonemap { None, Aces, AgX, PbrNeutral };
// How lights with a surface are drawn (shaders/common/lights.glsl): by representative points whose lobe is made weaker with
// the notes' factor 3 (Karis 2013, eq. 10 and 14) or Unreal's 2, with D widened instead ("Specular D modification"), or as
// it is; or by linearly transformed cosines (renderer/area_light_tables.h), where a model's lobe is the same all around and
// apart from its diffuse part, else as Unreal's.
enum class AreaLights { Notes = 1, Unreal, SpecularD, Plain, Cosines };
struct AreaLightsInfo {
  AreaLights method;
  const char* id;        // "notes"
  const char* title;
  const char* doc;
};
std::span<const AreaLightsInfo> areaLightMethods();
inline constexpr int kMostReferenceSamples = 65536;
// Which shadows lights cast (those whose Light::shadow is set; renderer/light_shadow.h says which of them can): none, those of
// shadow maps with soft edges, or those and the short ones where things touch, that a map is too coarse for, found in the
// depth of the picture. The reference has none.
enum class Shadows { Off, Maps, Contact };
// A choice by its name, title and explanation: of Shadows and of Ground, in their order.
struct ChoiceInfo {
  const char* id;        // "contact"
  const char* title;
  const char* doc;
};
std::span<const ChoiceInfo> shadowChoices();
std::span<const ChoiceInfo> groundChoices();
enum class Background { Environment, Blur, None, Color };

// A picture's view of the scene: the lit one, the white furnace, the error against the reference, or one of the buffers.
struct ViewMode {
  const char* id;      // "lit", "furnace", "baseColor", "normal", "modelId", ...
  const char* title;
  const char* doc;
};
std::span<const ViewMode> viewModes();
const ViewMode* findViewMode(const std::string& id);
// Of a view that shows a buffer: its number in shaders/passes/buffer_view.frag, from 0.
int bufferViewIndex(const std::string& id);
// The white furnace: whatever the scene's light and the materials' colours, every surface is a white metal (F0 = 1, no
// cavity, occlusion or emission) under white light of radiance 1 from all sides, before the same white. With its own
// roughness and parameters it shows the share of that light which its model sends back to the viewer, from the model's
// own environment BRDF, which is the integral of its f: one that keeps its energy cannot be seen. Display-referred
// pictures show what is over 1 in orange.
inline constexpr const char* kFurnaceView = "furnace";

struct RenderSettings {
  std::string view = "lit";
  float exposure = 0;                          // EV: the picture is multiplied by 2^exposure
  Tonemap tonemap = Tonemap::None;
  Background background = Background::Environment;
  glm::vec3 backgroundColor{0};                // linear
  // What bounces among facets more than once is given back (renderer/model_tables.h), also by models that do not ask for it.
  bool compensate = false;
  AreaLights areaLights = AreaLights::Cosines;
  Shadows shadows = Shadows::Off;
  // What keeps the light of the surroundings from a surface: the material's ambientOcclusion, and what is near it on the
  // screen (shaders/passes/occlusion.frag), within `occlusionRadius` metres; 0: half the radius of what is drawn.
  bool materialOcclusion = true, screenOcclusion = false;
  float occlusionRadius = 0;
  // Roughness is widened by how much the normal varies within a pixel, on bent surfaces and in normal maps
  // (shaders/common/specular_antialiasing.glsl). Not with a reference, in the error view or in the furnace, which measure.
  // Of several pictures averaged each widens for its share of the pixel.
  bool specularAntialiasing = false;
  // drawToTexture() alone, and only of what is lit without a reference: jittered, and averaged with the pictures before, which
  // are brought to where the view has moved (renderer/passes/temporal_pass.h).
  bool temporal = false;
  int samples = 1;                             // jittered frames averaged, >= 1
  // Monte Carlo samples of each pixel, over all of those frames together; 0: lights and environment are approximated. The
  // truth is an average of radiance, which is tone mapped as a whole.
  int reference = 0;
  // Of a reference: reflections of the environment by the split sum itself (Karis 2013, eq. 7), at the true direction of
  // view. What is drawn without a reference assumes n = v = r as well. In the error view it is what is compared.
  bool splitSum = false;
  // The relative error that the error view, which needs a reference of at least 2, shows in its strongest colours.
  float errorScale = 0.25f;
  // What an environment does to a model may be coarse where it would have to be made first: for a picture now. See
  // Renderer::refineTable().
  bool coarse = false;
};

// One camera on one scene in a rectangle (pixels from the bottom left) of the picture. A comparison is many
// views of one picture; each sees what it would see alone.
struct View {
  const Scene* scene = nullptr;
  Camera camera;
  glm::ivec4 rectangle{0};                     // x, y, width, height
};

class Renderer {
 public:
  using Progress = std::function<void(const std::string& what, double fraction)>;

  // The context must be current, then and in every call.
  explicit Renderer(const gl::Context&);
  ~Renderer();
  Renderer(const Renderer&) = delete;

  // Long work (environment tables, shaders met for the first time) calls this as it goes, on this thread.
  void setProgress(Progress);

  // Draws and reads back. `picture` is display-referred sRGB with the settings' exposure and tone map; `linear`
  // is scene-referred radiance. Never holds NaN: a pixel that would is counted in statistics().
  Image8 picture(std::span<const View>, glm::ivec2 size, const RenderSettings&);
  // In the error view `linear` holds the relative error of each channel, signed.
  ImageF linear(std::span<const View>, glm::ivec2 size, const RenderSettings&);

  // Of each view in the white furnace, over the pixels that its surfaces cover: the share of the light that comes back,
  // the mean of its channels. For a sphere seen from afar `mean` is the average albedo.
  struct FurnaceShare {
    double mean = 0, least = 0, most = 0;
    int pixels = 0;                              // 0: nothing is seen, and the others say nothing
    double extreme() const { return 1 - least > most - 1 ? least : most; }  // the farthest from 1
  };
  std::vector<FurnaceShare> furnaceShares(std::span<const View>, glm::ivec2 size, bool compensate);

  // Of each of the views that were drawn last, as it is so far; that was in the error view.
  std::vector<ReferenceError> referenceErrors(std::span<const View>, glm::ivec2 size);

  // Draws into a texture of this renderer and waits for the device, so that another context may show it. The
  // texture stays unchanged until the second next call.
  unsigned drawToTexture(std::span<const View>, glm::ivec2 size, const RenderSettings&);

  // Adds one more jittered sample to the average shown by drawToTexture; with the same arguments as that call.
  // `sample` counts from 1. With a reference, that call and each of this one draw reference / samples samples a pixel.
  unsigned refineTexture(std::span<const View>, glm::ivec2 size, const RenderSettings&, int sample);

  // Of the picture of one view that was drawn last, pixel by pixel from the bottom: how far its surfaces are in the direction
  // of view, metres; infinity where there is none.
  std::vector<float> depths(glm::ivec2 size);

  // Makes one of the tables that were coarse in the last picture fine, which takes a few tenths of a second; false when
  // there is none left. The next picture has it.
  bool refineTable();

  // Problems of the last frame: plugins that do not compile (their last good version was drawn), and so on.
  const Diagnostics& problems() const;

  struct Statistics {
    int triangles = 0, lightGroups = 0, lights = 0;
    size_t lightBytes = 0;                     // on the device, of the lists of lights and their tiles
    int invalidPixels = 0;                     // NaN or infinite before they were replaced
    int coarseTables = 0;                      // RenderSettings::coarse
    int shadowMaps = 0;                        // that were drawn for it: none while lights and surfaces stay
  };
  const Statistics& statistics() const;

  // What a compiler says of a model's GLSL, drawn or not; remembered. Errors are at the plugin's own lines.
  Diagnostics check(const std::shared_ptr<const ShadingModel>&);

  // After plugins changed: lets go of those that nobody holds any more, and looks again at those with faults. Programs
  // stay, as they are kept by their text; all are dropped only when a shipped shader on disk is not what it was.
  void reloadModels();

  // How many programs this renderer has built so far.
  int programsBuilt() const;

  // Repeats the lighting of the last drawToTexture() or one-sample picture() on its G-buffer and waits for it: what
  // the shading models alone cost.
  void relight();

  EnvironmentLighting& environmentLighting();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace glint
