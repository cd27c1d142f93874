// A frame that is made ready: what its passes (the other files of this folder) read, and where they draw.
#pragma once

#include <string>
#include <vector>

#include "renderer/frame_targets.h"
#include "renderer/frame_uploads.h"
#include "renderer/light_shadow.h"
#include "renderer/model_setting.h"
#include "renderer/prepared_view.h"
#include "renderer/rectangles.h"
#include "renderer/renderer.h"

namespace glint {

// What a pass leaves in its target.
enum class Output {
  Picture,     // display-referred, into an sRGB target
  Display,     // display-referred linear, added up: averages of samples
  Radiance,    // scene-referred, added up
};

// Pixels lit by one model with one set of constants: one stencil value.
struct LightGroup {
  ModelSetting setting;
  size_t tileLights = 0, tiles = 0;     // offsets in the uploads
  size_t tileLightTexels = 0, tileCount = 0;
  bool compensate = false;
  Ground ground = Ground::None;
  bool broken = false;                  // no version of the plugin ever compiled
  uint64_t key = 0;
};
inline constexpr int kMostGroups = 254;   // the stencil's values but 0, which is the background

// A view with what it needs on the device.
struct ReadyView {
  PreparedView view;
  std::vector<LightGroup> groups;
  std::vector<int> groupOfMaterial;     // -1: too many groups
  std::vector<size_t> materialBlocks;   // offsets in the uploads
  CasterBounds casters;
  std::vector<ShadowView> shadows;      // by their number, from 1
  size_t viewBlock = 0, directional = 0;
};

struct Frame {
  std::vector<ReadyView> views;
  FrameUploads uploads;
  FrameTargets targets;
  OptionalAttachments optional;
  RenderSettings settings;
  int sample = 0;                       // of those averaged
  glm::vec2 jitter{0};                  // of that sample within the pixel
  Output output = Output::Picture;
  GLuint visibility = 0;                // FrameTargets::visibility, where something is drawn into it
  GLuint framebuffer = 0;               // of light, with the G-buffer's depth and stencil
  float furnaceGround = 1;              // radiance behind the surfaces of the white furnace
  Rectangles rectangles;
  Diagnostics problems;

  bool isFurnace() const { return settings.view == kFurnaceView; }
  // Whether the shading models draw it; the other views show a buffer.
  bool isLit() const { return settings.view == "lit" || isFurnace(); }
  // Whether shadows and occlusion are drawn: by the approximations of light, which the reference and the furnace are none of.
  bool approximates() const { return settings.view == "lit" && settings.reference == 0; }
  bool hasShadows() const { return approximates() && settings.shadows != Shadows::Off; }
  bool hasScreenOcclusion() const { return approximates() && settings.screenOcclusion; }
  // Specular antialiasing. The truth, and what is measured against it or against white, is of the roughness as it is.
  bool widensLobes() const { return settings.specularAntialiasing && settings.reference == 0 && !isFurnace(); }
  // Of programs that end in outputColor() of shaders/common/output.glsl.
  std::vector<std::string> outputDefines() const;
  std::vector<std::string> displayDefines() const;   // and in displayed() of shaders/common/tonemap.glsl

  glm::ivec2 size() const { return {targets.width(), targets.height()}; }
  // Into another framebuffer with the frame's depth and stencil: without blending, where any surface is.
  void beginSurfaces(GLuint framebuffer) const;
  void drawSurfaces(const gl::Program&, const ReadyView&) const;
  // What shaders/common/screen.glsl reads.
  void setScreen(const gl::Program&, const ReadyView&) const;
  // The state of every pass that draws rectangles where the stencil is right.
  void beginRectangles() const;
  // The pixels of the view where the stencil is `group` + 1; -1: where no surface is.
  void drawGroup(const gl::Program&, const ReadyView&, int group) const;
  // All of the view with that stencil, also where no tile has geometry.
  void drawRectangle(const gl::Program&, const ReadyView&, int group) const;
  // Adds a problem that is not yet told.
  void report(const Diagnostic&);
};

}  // namespace glint
