#include "renderer/passes/lighting_pass.h"

#include <algorithm>

namespace glint {

void LightLists::bind(const Frame& frame, const ReadyView& r, const LightGroup& group) {
  frame.targets.bindGbuffer();
  frame.uploads.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
  frame.uploads.bind(GL_UNIFORM_BUFFER, 2, r.directional, kMostDirectionalLights * sizeof(DirectionalBlock));
  if (r.view.points.empty() && r.view.placed.empty()) return;
  if (!tileLights_) {
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
    tileLights_ = gl::Texture(id);
  }
  glTextureBufferRange(tileLights_.id(), GL_RGBA32F, frame.uploads.id(), static_cast<GLintptr>(group.tileLights),
                       static_cast<GLsizeiptr>(std::max<size_t>(group.tileLightTexels, 1) * 16));
  glBindTextureUnit(8, tileLights_.id());
}

void LightingPass::draw(Frame& frame, LightLists& lists) {
  for (const ReadyView& r : frame.views)
    for (size_t g = 0; g < r.groups.size(); ++g) {
      if (r.groups[g].tileCount == 0) continue;
      // A plugin that compiles by itself may still clash with a name of a pass.
      const Diagnostics faults = r.groups[g].broken ? Diagnostics{} : drawGroup(frame, lists, r, g);
      for (const Diagnostic& fault : faults) frame.report(fault);
      if (r.groups[g].ground == Ground::None && (r.groups[g].broken || !faults.empty())) background_.drawBroken(frame, r, static_cast<int>(g));
    }
}

Diagnostics LightingPass::drawGroup(Frame& frame, LightLists& lists, const ReadyView& r, size_t index) {
  const LightGroup& group = r.groups[index];
  const ShadingModel& model = *group.setting.shader->model;
  const bool furnace = frame.isFurnace(), surrounded = furnace || r.view.scene->environment;
  std::vector<std::string> defines = frame.outputDefines();
  if (!furnace && !r.view.points.empty()) defines.push_back("POINT_LIGHTS");
  if (!furnace && !r.view.placed.empty()) defines.push_back(fmt::format("PLACED_LIGHTS {}", static_cast<int>(frame.settings.areaLights)));
  for (const auto& [kind, define] : {std::pair{LightKind::Spot, "SPOT_LIGHTS"}, {LightKind::Sphere, "SPHERE_LIGHTS"}, {LightKind::Tube, "TUBE_LIGHTS"}, {LightKind::Rectangle, "RECTANGLE_LIGHTS"}})
    if (!furnace && r.view.kinds >> static_cast<unsigned>(kind) & 1) defines.push_back(define);
  if (!furnace && frame.optional.emissive) defines.push_back("EMISSIVE");
  if (furnace) defines.push_back("FURNACE");
  if (frame.optional.parameters) defines.push_back("READS_PARAMETERS");
  if (group.compensate) defines.push_back("COMPENSATE");
  if (group.ground != Ground::None) defines.push_back(fmt::format("GROUND {}", static_cast<int>(group.ground)));
  if (!r.shadows.empty()) defines.push_back("SHADOWS");
  if (frame.hasScreenOcclusion() && surrounded) defines.push_back("SCREEN_OCCLUSION");
  if (!frame.settings.materialOcclusion) defines.push_back("NO_MATERIAL_OCCLUSION");
  Surroundings around;
  if (surrounded) {
    auto made = surroundings(frame, r.view.scene->environment, group.setting);
    if (!made) return modelErrors(model, made.diagnostics()[0].what);
    around = *made;
    reportInvalidTables(frame, group.setting);
    defines.push_back("ENVIRONMENT");
    if (around.brdf.colored) defines.push_back("COLORED_BRDF");
  }
  const auto found = programs_.get(Rectangles::vertexShader(), {"shaders/passes/lighting.frag", defines, {{"model", group.setting.shader->glsl}}});
  if (!found) return modelErrors(model, found.diagnostics()[0].what);
  const gl::Program& program = **found;
  GLuint areaTable = 0;
  if (program.location("areaLightTable") >= 0) {
    const auto table = areaLights_.of(group.setting);
    if (!table) return modelErrors(model, table.diagnostics()[0].what);
    areaTable = *table;
  }
  const Diagnostics faults = lighting_.tables().apply(group.setting, program);
  GLINT_CHECK(faults.empty(), "a sound shader has tables");
  BackgroundPass::Backdrop behind;
  if (group.ground != Ground::None) behind = background_.backdrop(frame, r);
  // Building tables changed the state.
  frame.beginRectangles();
  lists.bind(frame, r, group);
  if (surrounded) bind(around, model, program);
  if (areaTable) glBindTextureUnit(10, areaTable);
  if (frame.visibility) glBindTextureUnit(16, frame.visibility);
  if (group.ground != Ground::None) behind.bind(program);
  frame.drawGroup(program, r, static_cast<int>(index));
  return {};
}

Result<LightingPass::Surroundings> LightingPass::surroundings(const Frame& frame, const EnvironmentPtr& environment, const ModelSetting& setting) {
  const bool furnace = frame.isFurnace();
  const ShadingModel& model = *setting.shader->model;
  const TableQuality quality = frame.settings.coarse ? TableQuality::Coarse : TableQuality::Fine;
  Surroundings around;
  const auto ask = [&](Lobe lobe, GLuint& cube, EnvironmentLighting::BrdfTable& table) -> Diagnostics {
    // White light averages to white under any lobe.
    const auto prefiltered = furnace ? Result<GLuint>(lighting_.uniformCube(1)) : lighting_.prefiltered(environment, setting, lobe, quality);
    if (!prefiltered) return prefiltered.diagnostics();
    const auto brdf = lighting_.brdf(setting, lobe, quality);
    if (!brdf) return brdf.diagnostics();
    cube = *prefiltered;
    table = *brdf;
    return {};
  };
  if (Diagnostics faults = ask(Lobe::Base, around.cube, around.brdf); !faults.empty()) return faults;
  if (model.definesCoat)
    if (Diagnostics faults = ask(Lobe::Coat, around.coatCube, around.coatBrdf); !faults.empty()) return faults;
  if (model.usesTangent && !furnace) around.stretch = lighting_.stretch(setting);
  if (furnace) {
    around.harmonics = lighting_.whiteIrradiance();
  } else {
    const EnvironmentMaps& maps = lighting_.maps(environment);
    around.harmonics = maps.harmonics.id();
    if (maps.irradianceCube) around.irradianceCube = maps.irradianceCube.id();
  }
  return around;
}

void LightingPass::bind(const Surroundings& around, const ShadingModel& model, const gl::Program& program) {
  glBindTextureUnit(6, around.cube);
  glBindTextureUnit(7, around.brdf.texture);
  glBindBufferBase(GL_UNIFORM_BUFFER, 3, around.harmonics);
  glBindTextureUnit(18, around.irradianceCube ? around.irradianceCube : lighting_.uniformCube(0));
  if (model.definesCoat) {
    glBindTextureUnit(11, around.coatCube);
    glBindTextureUnit(12, around.coatBrdf.texture);
  }
  if (model.usesTangent)
    glProgramUniform2fv(program.id(), program.location("lobeStretch"), static_cast<GLsizei>(around.stretch.size()), &around.stretch[0].x);
}

void LightingPass::reportInvalidTables(Frame& frame, const ModelSetting& setting) {
  const auto [brdf, lobe] = lighting_.invalid(setting);
  const auto report = [&](int count, const char* table) {
    if (count > 0)
      frame.report(warning(setting.shader->model->file.string(), fmt::format("{} values of its {} were not finite and are black", count, table),
                           "the shading model returns NaN or infinity there"));
  };
  report(brdf, "environment BRDF");
  report(lobe, "lobe over the environment");
}

}  // namespace glint
