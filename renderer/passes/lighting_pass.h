// Lights the G-buffer: for each view and light group one program, which holds that group's shading model.
#pragma once

#include "renderer/area_light_tables.h"
#include "renderer/environment_lighting.h"
#include "renderer/passes/background_pass.h"
#include "renderer/passes/frame.h"

namespace glint {

// Binds the G-buffer with a view's lights, and a group's lists of those that reach its tiles.
class LightLists {
 public:
  void bind(const Frame&, const ReadyView&, const LightGroup&);

 private:
  gl::Texture tileLights_;
};

class LightingPass {
 public:
  LightingPass(ProgramCache& programs, const Rectangles& rectangles, EnvironmentLighting& lighting, BackgroundPass& background)
      : programs_(programs), lighting_(lighting), background_(background), areaLights_(programs, rectangles, lighting.tables(), true) {}
  void draw(Frame&, LightLists&);
  void forgetUnused() { areaLights_.forgetUnused(); }

 private:
  // What an environment, or the white furnace, gives a group.
  struct Surroundings {
    GLuint cube = 0, harmonics = 0, irradianceCube = 0, coatCube = 0;
    EnvironmentLighting::BrdfTable brdf, coatBrdf;
    std::array<glm::vec2, EnvironmentLighting::kLevels> stretch{};
  };
  Result<Surroundings> surroundings(const Frame&, const EnvironmentPtr&, const ModelSetting&);
  void bind(const Surroundings&, const ShadingModel&, const gl::Program&);
  void reportInvalidTables(Frame&, const ModelSetting&);
  Diagnostics drawGroup(Frame&, LightLists&, const ReadyView&, size_t group);

  ProgramCache& programs_;
  EnvironmentLighting& lighting_;
  BackgroundPass& background_;
  AreaLightTables areaLights_;
};

}  // namespace glint
