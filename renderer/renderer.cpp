#include "renderer/renderer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

#include "materials/base/hash.h"
#include "renderer/device_textures.h"
#include "renderer/environment_lighting.h"
#include "renderer/frame_targets.h"
#include "renderer/model_speed.h"
#include "renderer/prepared_view.h"
#include "renderer/program_cache.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

// What a lighting pass leaves in its target.
enum class Output {
  Picture,     // display-referred, into an sRGB target
  Display,     // display-referred linear, added up: averages of samples
  Radiance,    // scene-referred, added up
};

// Views that the shading models draw; the others show a buffer.
constexpr const char* kLitViews[] = {"lit", kFurnaceView};
bool isFurnace(const RenderSettings& settings) { return settings.view == kFurnaceView; }
bool isLit(const RenderSettings& settings) {
  return std::any_of(std::begin(kLitViews), std::end(kLitViews), [&](const char* view) { return settings.view == view; });
}

constexpr int kMostGroups = 254;   // the stencil's values but 0, which is the background

// Low-discrepancy offsets within a pixel (Halton 1960, bases 2 and 3), centred on 0; the first is the centre itself.
glm::vec2 jitterOf(int sample) {
  if (sample == 0) return glm::vec2(0);
  const auto halton = [](int i, int base) {
    float f = 1, r = 0;
    for (; i > 0; i /= base) {
      f /= static_cast<float>(base);
      r += f * static_cast<float>(i % base);
    }
    return r;
  };
  return {halton(sample, 2) - 0.5f, halton(sample, 3) - 0.5f};
}

float linearOf(float srgb) { return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f); }

// Bytes gathered for one upload a frame: uniform blocks, light lists and tiles together.
class FrameBuffer {
 public:
  // The offset at which the bytes will lie, aligned for any binding.
  size_t append(std::span<const std::byte> bytes) {
    const size_t offset = (bytes_.size() + kAlignment - 1) / kAlignment * kAlignment;
    bytes_.resize(offset + std::max<size_t>(bytes.size(), 16));
    if (!bytes.empty()) std::memcpy(bytes_.data() + offset, bytes.data(), bytes.size());
    return offset;
  }
  void upload() {
    if (bytes_.size() > capacity_) {
      capacity_ = std::bit_ceil(bytes_.size());
      buffer_ = gl::createBuffer(std::vector<std::byte>(capacity_));
    }
    glNamedBufferSubData(buffer_.id(), 0, static_cast<GLsizeiptr>(bytes_.size()), bytes_.data());
  }
  void clear() { bytes_.clear(); }
  void bind(GLenum target, GLuint binding, size_t offset, size_t size) const {
    glBindBufferRange(target, binding, buffer_.id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(std::max<size_t>(size, 16)));
  }
  GLuint id() const { return buffer_.id(); }

 private:
  static constexpr size_t kAlignment = 256;
  std::vector<std::byte> bytes_;
  gl::Buffer buffer_;
  size_t capacity_ = 0;
};

// Pixels lit by one model with one set of constants: one stencil value.
struct LightGroup {
  ModelSetting setting;
  size_t tileLights = 0, tiles = 0;     // offsets in the frame buffer
  size_t tileLightCount = 0, tileCount = 0;
  bool compensate = false;
  bool broken = false;                  // no version of the plugin ever compiled
  uint64_t key = 0;
};

// A view with what it needs on the device.
struct ReadyView {
  PreparedView view;
  std::vector<LightGroup> groups;
  std::vector<int> groupOfMaterial;     // -1: too many groups
  std::vector<size_t> materialBlocks;   // offsets in the frame buffer
  size_t viewBlock = 0, directional = 0;
};

}  // namespace

struct Renderer::State {
  State() : lighting(programs, true) {
    tileArray = gl::createVertexArray();
    for (GLuint i = 0; i < 2; ++i) {
      glEnableVertexArrayAttrib(tileArray.id(), i);
      glVertexArrayAttribIFormat(tileArray.id(), i, i == 0 ? 4 : 2, GL_INT, i == 0 ? 0 : 16);
      glVertexArrayAttribBinding(tileArray.id(), i, 0);
    }
    glVertexArrayBindingDivisor(tileArray.id(), 0, 1);
  }

  // -- Models ------------------------------------------------------------------------------------------------------
  std::shared_ptr<const ModelShader> shaderOf(const std::shared_ptr<const ShadingModel>& model) {
    auto& entry = shaders[model.get()];
    if (!entry || entry->model != model) entry = std::make_shared<ModelShader>(model);
    return entry;
  }

  // What a compiler says of a model, by the smallest program that holds all of it.
  const Diagnostics& verdictOn(const ModelShader& shader) {
    auto verdict = verdicts.find(shader.hash);
    if (verdict == verdicts.end()) {
      const auto program = programs.get(tileVertex(), {"shaders/passes/lobe.frag", {}, {{"model", shader.glsl}}});
      Diagnostics faults = program ? slowness(*shader.model, **program) : modelErrors(*shader.model, program.diagnostics()[0].what);
      verdict = verdicts.emplace(shader.hash, std::move(faults)).first;
    }
    return verdict->second;
  }

  // A model that would take hours is not drawn: a few values show it.
  Diagnostics slowness(const ShadingModel& model, const gl::Program& lobe) {
    constexpr int kRows = 4, kFloorEvaluations = 121;  // modelFloor() of shaders/common/floor_light.glsl, and the value
    const auto fault = faultOfSpeed(model, [&](int count) {
      const gl::Texture target = gl::createTexture2D(GL_R32F, count / kRows, kRows);
      const GLuint color = target.id();
      const gl::Framebuffer framebuffer = gl::createFramebuffer(std::span(&color, 1));
      lobe.set("width", static_cast<float>(count / kRows));
      lobe.set("roughnessCount", kRows);
      lobe.set("azimuthCount", 1);
      lighting.drawFullTarget(lobe, framebuffer.id(), count / kRows, kRows);
      glFinish();
    }, model.isWhole() ? kFloorEvaluations : 1);
    return fault ? Diagnostics{*fault} : Diagnostics{};
  }

  // The shader to draw a model with: its own when it compiles, else its last good version, else none.
  std::shared_ptr<const ModelShader> soundShaderOf(const std::shared_ptr<const ShadingModel>& model) {
    auto shader = shaderOf(model);
    const Diagnostics& verdict = verdictOn(*shader);
    if (verdict.empty()) {
      lastGood[model->id] = shader;
      return shader;
    }
    problems.insert(problems.end(), verdict.begin(), verdict.end());
    const auto good = lastGood.find(model->id);
    return good == lastGood.end() ? nullptr : good->second;
  }

  static ShaderText tileVertex() { return {"shaders/passes/tiles.vert", {}, {}}; }

  void reloadModels() {
    std::erase_if(shaders, [](const auto& entry) { return entry.second->model.use_count() == 1; });
    std::erase_if(verdicts, [](const auto& entry) { return !entry.second.empty(); });
    const uint64_t now = shippedShaders();
    if (std::exchange(shippedHash, now) == now) return;
    programs.forget();
    shaders.clear();
    verdicts.clear();
  }

  // Of the shaders that programs include by their path, as they lie on disk: which, how long, and written when.
  static uint64_t shippedShaders() {
    uint64_t hash = 0;
    for (const char* folder : {"shaders/common", "shaders/passes", "shaders/terms"})
      for (const char* extension : {".glsl", ".vert", ".frag"})
        for (const std::string& path : shipped::list(folder, extension)) {
          std::error_code gone;
          const std::filesystem::path file = shipped::onDisk(path);
          hash = hashText(fmt::format("{} {} {}", path, std::filesystem::file_size(file, gone),
                                      std::filesystem::last_write_time(file, gone).time_since_epoch().count()), hash);
        }
    return hash;
  }

  // -- Preparation -------------------------------------------------------------------------------------------------
  void prepare(std::span<const View> views, const RenderSettings& settings, glm::vec2 jitter) {
    ready.clear();
    frame.clear();
    meshes.forgetUnused();
    textures.forgetUnused();
    programs.forgetUnused();
    lighting.forgetUnused();
    problems.clear();
    statistics = {};
    optional = {};
    for (const View& view : views) {
      GLINT_CHECK(view.scene != nullptr && view.rectangle.z > 0 && view.rectangle.w > 0);
      for (const SurfaceMaterial& material : view.scene->materials) {
        optional.emissive |= material.compiled->writesEmissive;
        optional.parameters |= material.compiled->writesModelParameters;
        optional.tangent |= material.model->usesTangent;
      }
    }
    for (const View& view : views) {
      ReadyView r;
      for (const SurfaceMaterial& material : view.scene->materials) {
        r.groupOfMaterial.push_back(groupOf(material, settings.compensate, r.groups));
        r.materialBlocks.push_back(frame.append(material.block));
      }
      r.view = prepareView(view, meshes, r.groupOfMaterial, r.groups.size(), std::exp2(settings.exposure),
                           EnvironmentLighting::kLevels - 1, jitter);
      if (view.scene->environment) r.view.block.environmentIntensity /= lighting.maps(view.scene->environment).scale;
      if (r.view.tooManyDirectional)
        problems.push_back(warning("lights", fmt::format("more than {} directional lights", kMostDirectionalLights), "the others are not drawn"));
      if (isFurnace(settings)) {
        r.view.block.environmentIntensity = 1;
        r.view.block.directionalCount = 0;
      }
      r.viewBlock = frame.append(std::as_bytes(std::span(&r.view.block, 1)));
      std::vector<DirectionalBlock> directional = r.view.directional;
      directional.resize(kMostDirectionalLights);
      r.directional = frame.append(std::as_bytes(std::span(directional)));
      for (size_t g = 0; g < r.groups.size(); ++g) {
        const LightTiles& tiles = r.view.tiles[g];
        std::vector<PointBlock> lights;
        lights.reserve(tiles.list.size());
        for (uint32_t light : tiles.list) lights.push_back(r.view.points[light]);
        r.groups[g].tileLights = frame.append(std::as_bytes(std::span(lights)));
        r.groups[g].tileLightCount = lights.size();
        r.groups[g].tiles = frame.append(std::as_bytes(std::span(tiles.tiles)));
        r.groups[g].tileCount = tiles.tiles.size();
      }
      statistics.triangles += r.view.triangles;
      statistics.lightGroups += static_cast<int>(r.groups.size());
      statistics.lights += static_cast<int>(r.view.directional.size() + r.view.points.size());
      ready.push_back(std::move(r));
    }
    frame.upload();
  }

  int groupOf(const SurfaceMaterial& material, bool compensate, std::vector<LightGroup>& groups) {
    LightGroup group;
    const auto sound = soundShaderOf(material.model);
    group.broken = !sound;
    group.setting = modelSetting(sound ? sound : shaderOf(material.model), material.modelParameters, material.compiled->plainNonmetal);
    group.compensate = (compensate || group.setting.shader->model->compensate) && !group.setting.shader->model->isWhole();  // it has no facets to bounce among
    group.key = group.setting.key() ^ (group.compensate ? 1 : 0);
    for (size_t i = 0; i < groups.size(); ++i)
      if (groups[i].key == group.key) return static_cast<int>(i);
    if (groups.size() == kMostGroups) {
      problems.push_back(error("shading models", fmt::format("more than {} settings of models in one view", kMostGroups), "the others are not drawn"));
      return -1;
    }
    groups.push_back(std::move(group));
    return static_cast<int>(groups.size()) - 1;
  }

  // -- Passes ------------------------------------------------------------------------------------------------------
  std::vector<std::string> surfaceDefines(const CompiledMaterial& material) const {
    std::vector<std::string> defines;
    if (optional.emissive) defines.push_back("WRITES_EMISSIVE");
    if (optional.parameters) defines.push_back("WRITES_PARAMETERS");
    if (optional.tangent) defines.push_back("WRITES_TANGENT");
    if (material.writesNormal) defines.push_back("WRITES_NORMAL");
    if (material.writesOpacityMask) defines.push_back("WRITES_OPACITY_MASK");
    return defines;
  }

  const gl::Program* surfaceProgram(const CompiledMaterial& material) {
    const auto program = programs.get({"shaders/passes/gbuffer.vert", {}, {}},
                                      {"shaders/passes/gbuffer.frag", surfaceDefines(material), {{"material", material.glsl}}});
    if (!program) {
      // The graph compiler's fault, not the user's: say so, and draw the rest.
      problems.push_back(error(material.name.empty() ? "material" : material.name, "its generated shader does not compile: " + program.diagnostics()[0].what,
                               "please report it with the material's file"));
      return nullptr;
    }
    return *program;
  }

  void gbufferPass() {
    glBindFramebuffer(GL_FRAMEBUFFER, targets.gbuffer());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glCullFace(GL_BACK);
    // The stencil tells which pixels hold anything: the colours need no clearing.
    const GLfloat depth = 1;
    glClearNamedFramebufferfi(targets.gbuffer(), GL_DEPTH_STENCIL, 0, depth, 0);
    for (const ReadyView& r : ready) {
      const glm::ivec4 rect = r.view.rectangle;
      glViewport(rect.x, rect.y, rect.z, rect.w);
      frame.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
      // By material, so that programs and textures change little.
      std::vector<const PreparedInstance*> order;
      for (const PreparedInstance& instance : r.view.instances) order.push_back(&instance);
      std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->material < b->material; });
      int bound = -1;
      const gl::Program* program = nullptr;
      for (const PreparedInstance* instance : order) {
        const size_t m = static_cast<size_t>(instance->material);
        const SurfaceMaterial& material = r.view.scene->materials[m];
        const int group = r.groupOfMaterial[m];
        if (group < 0) continue;
        if (bound != instance->material) {
          bound = instance->material;
          program = surfaceProgram(*material.compiled);
          if (program) bindMaterial(*program, material, r, m, group);
        }
        if (!program) continue;
        program->setMatrix4("worldFromModel", &instance->worldFromModel[0][0]);
        program->setMatrix4("normalFromModel", &instance->normalFromModel[0][0]);
        material.doubleSided ? glDisable(GL_CULL_FACE) : glEnable(GL_CULL_FACE);
        glFrontFace(instance->mirrored ? GL_CW : GL_CCW);
        glBindVertexArray(instance->mesh->array.id());
        glMultiDrawElements(GL_TRIANGLES, instance->counts.data(), GL_UNSIGNED_INT, instance->offsets.data(), static_cast<GLsizei>(instance->counts.size()));
      }
    }
    glFrontFace(GL_CCW);
    glDisable(GL_CULL_FACE);
    // Depth is read in lighting while it stays attached for its stencil; nothing writes it then.
    glTextureBarrier();
  }

  void bindMaterial(const gl::Program& program, const SurfaceMaterial& material, const ReadyView& r, size_t index, int group) {
    program.use();
    program.set("lightGroup", static_cast<float>(group) / 255.0f);
    program.set("opacityCutoff", material.opacityCutoff);
    program.set4("standardParameters", r.groups[static_cast<size_t>(group)].setting.slots.data());
    glStencilFunc(GL_ALWAYS, group + 1, 0xff);
    if (material.compiled->blockSize > 0)
      frame.bind(GL_UNIFORM_BUFFER, kMaterialParametersBinding, r.materialBlocks[index], material.block.size());
    const auto& slots = material.compiled->textures;
    for (size_t i = 0; i < slots.size(); ++i)
      textures.bind(static_cast<GLuint>(kFirstMaterialTexture + static_cast<int>(i)), i < material.textures.size() ? material.textures[i] : nullptr, slots[i]);
  }

  // The state of every pass that draws rectangles under the stencil.
  void beginRectangles(GLuint framebuffer, Output output) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, targets.width(), targets.height());
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(0);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    if (output == Output::Picture) {
      glDisable(GL_BLEND);
      glEnable(GL_FRAMEBUFFER_SRGB);
    } else {
      glEnable(GL_BLEND);
      glBlendFunc(GL_ONE, GL_ONE);
      glDisable(GL_FRAMEBUFFER_SRGB);
    }
    glBindVertexArray(tileArray.id());
  }

  void drawRectangles(const gl::Program& program, const LightGroup& group) {
    program.set2("targetSize", static_cast<float>(targets.width()), static_cast<float>(targets.height()));
    program.use();
    glVertexArrayVertexBuffer(tileArray.id(), 0, frame.id(), static_cast<GLintptr>(group.tiles), sizeof(Tile));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(group.tileCount));
  }

  std::vector<std::string> outputDefines(const RenderSettings& settings, Output output) const {
    if (output == Output::Radiance) return {"SCENE_REFERRED"};
    return {fmt::format("TONEMAP {}", static_cast<int>(settings.tonemap))};
  }

  void lightingPass(const RenderSettings& settings, GLuint framebuffer, Output output) {
    beginRectangles(framebuffer, output);
    const bool furnace = isFurnace(settings);
    for (ReadyView& r : ready) {
      const EnvironmentPtr& environment = r.view.scene->environment;
      const bool surrounded = furnace || environment;
      // White light averages to white under any lobe.
      const auto cubeOf = [&](const ModelSetting& setting, Lobe lobe) {
        return furnace ? Result<GLuint>(uniformCube(whiteCube, 1)) : lighting.prefiltered(environment, setting, lobe);
      };
      for (size_t g = 0; g < r.groups.size(); ++g) {
        const LightGroup& group = r.groups[g];
        if (group.tileCount == 0) continue;
        if (group.broken) {
          brokenGroup(r, g, settings, output);
          continue;
        }
        std::vector<std::string> defines = outputDefines(settings, output);
        if (!furnace && !r.view.points.empty()) defines.push_back("POINT_LIGHTS");
        if (!furnace && optional.emissive) defines.push_back("EMISSIVE");
        if (furnace) defines.push_back("FURNACE");
        if (optional.parameters) defines.push_back("READS_PARAMETERS");
        if (group.compensate) defines.push_back("COMPENSATE");
        GLuint cube = 0, irradiance = 0, coatCube = 0;
        EnvironmentLighting::BrdfTable table, coatTable;
        const bool coated = surrounded && group.setting.shader->model->definesCoat;
        const bool usesTangent = surrounded && group.setting.shader->model->usesTangent;
        std::array<glm::vec2, EnvironmentLighting::kLevels> stretch{};
        if (surrounded) {
          // Building tables changes the state; the pass begins anew after it.
          const auto prefiltered = cubeOf(group.setting, Lobe::Base);
          const auto brdf = lighting.brdf(group.setting);
          if (!prefiltered || !brdf) {
            failedGroup(r, g, settings, framebuffer, output, !prefiltered ? prefiltered.diagnostics() : brdf.diagnostics());
            continue;
          }
          cube = *prefiltered;
          table = *brdf;
          irradiance = furnace ? whiteIrradiance() : lighting.maps(environment).irradianceBuffer.id();
          if (coated) {
            const auto coat = cubeOf(group.setting, Lobe::Coat);
            const auto coatBrdf = lighting.brdf(group.setting, Lobe::Coat);
            if (!coat || !coatBrdf) {
              failedGroup(r, g, settings, framebuffer, output, !coat ? coat.diagnostics() : coatBrdf.diagnostics());
              continue;
            }
            coatCube = *coat;
            coatTable = *coatBrdf;
          }
          if (usesTangent && !furnace) stretch = lighting.stretch(group.setting);
          reportInvalidTables(group.setting);
          defines.push_back("ENVIRONMENT");
          if (table.colored) defines.push_back("COLORED_BRDF");
        }
        const auto found = programs.get(tileVertex(), {"shaders/passes/lighting.frag", defines, {{"model", group.setting.shader->glsl}}});
        if (!found) {
          failedGroup(r, g, settings, framebuffer, output, found.diagnostics());
          continue;
        }
        const gl::Program& program = **found;
        beginRectangles(framebuffer, output);
        bindLighting(r, group);
        if (surrounded) {
          glBindTextureUnit(6, cube);
          glBindTextureUnit(7, table.texture);
          glBindBufferBase(GL_UNIFORM_BUFFER, 3, irradiance);
          if (coated) {
            glBindTextureUnit(11, coatCube);
            glBindTextureUnit(12, coatTable.texture);
          }
          if (usesTangent)
            glProgramUniform2fv(program.id(), program.location("lobeStretch"), static_cast<GLsizei>(stretch.size()), &stretch[0].x);
        }
        const Diagnostics faults = lighting.tables().apply(group.setting, program);
        GLINT_CHECK(faults.empty(), "a sound shader has tables");
        glStencilFunc(GL_EQUAL, static_cast<GLint>(g) + 1, 0xff);
        drawRectangles(program, group);
      }
    }
  }

  void reportInvalidTables(const ModelSetting& setting) {
    const auto [brdf, lobe] = lighting.invalid(setting);
    const auto report = [&](int count, const char* table) {
      const Diagnostic said = warning(setting.shader->model->file.string(), fmt::format("{} values of its {} were not finite and are black", count, table),
                                      "the shading model returns NaN or infinity there");
      if (count > 0 && std::find(problems.begin(), problems.end(), said) == problems.end()) problems.push_back(said);
    };
    report(brdf, "environment BRDF");
    report(lobe, "lobe over the environment");
  }

  void bindLighting(const ReadyView& r, const LightGroup& group) {
    targets.bindGbuffer();
    frame.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
    frame.bind(GL_UNIFORM_BUFFER, 2, r.directional, kMostDirectionalLights * sizeof(DirectionalBlock));
    if (!r.view.points.empty()) {
      if (!tileLights) {
        GLuint id = 0;
        glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
        tileLights = gl::Texture(id);
      }
      glTextureBufferRange(tileLights.id(), GL_RGBA32F, frame.id(), static_cast<GLintptr>(group.tileLights),
                           static_cast<GLsizeiptr>(std::max<size_t>(group.tileLightCount, 1) * sizeof(PointBlock)));
      glBindTextureUnit(8, tileLights.id());
    }
  }

  // A plugin that compiles by itself may still clash with a name of a pass.
  void failedGroup(const ReadyView& r, size_t index, const RenderSettings& settings, GLuint framebuffer, Output output, const Diagnostics& faults) {
    const Diagnostics said = modelErrors(*r.groups[index].setting.shader->model, faults[0].what);
    for (const Diagnostic& d : said)
      if (std::find(problems.begin(), problems.end(), d) == problems.end()) problems.push_back(d);
    beginRectangles(framebuffer, output);
    brokenGroup(r, index, settings, output);
  }

  // A plugin that never compiled shows as a flat magenta, which no light makes by itself.
  void brokenGroup(const ReadyView& r, size_t index, const RenderSettings& settings, Output output) {
    const float magenta[4] = {1, 0, 0.5f, 1};
    backgroundRectangles(r, static_cast<int>(index) + 1, settings, output, magenta, 0);
  }

  void backgroundPass(const RenderSettings& settings, GLuint framebuffer, Output output) {
    beginRectangles(framebuffer, output);
    for (const ReadyView& r : ready) {
      const EnvironmentPtr& environment = r.view.scene->environment;
      const bool sky = settings.view == "lit" && environment &&
                       (settings.background == Background::Environment || settings.background == Background::Blur);
      float color[4] = {0, 0, 0, 1};
      if (isFurnace(settings)) std::fill_n(color, 3, furnaceGround);
      else if (settings.view == "lit" && settings.background == Background::Color)
        for (int i = 0; i < 3; ++i) color[i] = settings.backgroundColor[i];
      float level = 0;
      if (sky) {
        const EnvironmentMaps& maps = lighting.maps(environment);
        color[3] = 0;
        if (settings.background == Background::Blur) level = std::max(0.0f, std::log2(static_cast<float>(maps.size)) - 4.0f);
        beginRectangles(framebuffer, output);
        glBindTextureUnit(6, maps.cube.id());
      }
      backgroundRectangles(r, 0, settings, output, color, level);
    }
  }

  void backgroundRectangles(const ReadyView& r, int stencil, const RenderSettings& settings, Output output, const float* color, float level) {
    const gl::Program& program = programs.shipped(tileVertex(), {"shaders/passes/background.frag", outputDefines(settings, output), {}});
    if (color[3] > 0) glBindTextureUnit(6, uniformCube(blackCube, 0));
    program.set4("background", color);
    program.set("level", level);
    frame.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
    glStencilFunc(GL_EQUAL, stencil, 0xff);
    // The whole rectangle, also where no tile has geometry.
    const glm::ivec4 rect = r.view.rectangle;
    const Tile whole{rect.x, rect.y, rect.x + rect.z, rect.y + rect.w, 0, 0};
    if (!wholeTile) wholeTile = gl::createBuffer(std::as_bytes(std::span(&whole, 1)));
    glNamedBufferSubData(wholeTile.id(), 0, sizeof whole, &whole);
    program.set2("targetSize", static_cast<float>(targets.width()), static_cast<float>(targets.height()));
    program.use();
    glVertexArrayVertexBuffer(tileArray.id(), 0, wholeTile.id(), 0, sizeof(Tile));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 1);
  }

  static GLuint uniformCube(gl::Texture& cube, float value) {
    if (!cube) {
      cube = gl::createTextureCube(GL_RGBA16F, 1, 1);
      const float color[4] = {value, value, value, value};
      glClearTexImage(cube.id(), 0, GL_RGBA, GL_FLOAT, color);
    }
    return cube.id();
  }

  // Of white light from all sides: EnvironmentMaps::irradiance.
  GLuint whiteIrradiance() {
    if (!whiteHarmonics) {
      std::array<glm::vec4, 9> harmonics{};
      harmonics[0] = glm::vec4(1);
      whiteHarmonics = gl::createBuffer(std::as_bytes(std::span(harmonics)));
    }
    return whiteHarmonics.id();
  }

  void bufferViewPass(const RenderSettings& settings, GLuint framebuffer, Output output) {
    beginRectangles(framebuffer, output);
    const int mode = static_cast<int>(findViewMode(settings.view) - viewModes().data()) - static_cast<int>(std::size(kLitViews));
    std::vector<std::string> defines = outputDefines(settings, output);
    if (optional.emissive) defines.push_back("EMISSIVE");
    if (optional.parameters) defines.push_back("READS_PARAMETERS");
    const gl::Program& program = programs.shipped(tileVertex(), {"shaders/passes/buffer_view.frag", defines, {}});
    for (const ReadyView& r : ready) {
      std::array<glm::vec4, 256> colors{};
      for (size_t g = 0; g < r.groups.size(); ++g) {
        const auto& c = r.groups[g].setting.shader->model->color;
        colors[g] = glm::vec4(linearOf(c[0]), linearOf(c[1]), linearOf(c[2]), 1);
      }
      program.set4("groupColors", &colors[0].x, 256);
      program.set("mode", mode);  // 0 is the first buffer
      for (size_t g = 0; g < r.groups.size(); ++g) {
        bindLighting(r, r.groups[g]);
        glStencilFunc(GL_EQUAL, static_cast<GLint>(g) + 1, 0xff);
        drawRectangles(program, r.groups[g]);
      }
    }
  }

  // -- Frames ------------------------------------------------------------------------------------------------------
  // True when the background is only black, which a clear gives for less than a pass.
  bool blackBackground(const RenderSettings& settings) const {
    if (isFurnace(settings)) return false;
    if (settings.view != "lit" || settings.background == Background::None) return true;
    if (settings.background == Background::Color) return settings.backgroundColor == glm::vec3(0);
    return std::none_of(ready.begin(), ready.end(), [](const ReadyView& r) { return r.view.scene->environment != nullptr; });
  }

  void drawSample(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings, int sample, GLuint framebuffer, Output output) {
    prepare(views, settings, jitterOf(sample));
    targets.resize(size.x, size.y, optional);
    gbufferPass();
    if (isLit(settings))
      lightingPass(settings, framebuffer, output);
    else
      bufferViewPass(settings, framebuffer, output);
    // In an average every pixel must count its samples, so a black background is drawn there too.
    if (output != Output::Picture || !blackBackground(settings)) backgroundPass(settings, framebuffer, output);
  }

  // Black, and sound (alpha 1) as often as samples will be added.
  void clear(GLuint framebuffer, float alpha) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    const GLfloat black[4] = {0, 0, 0, alpha};
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, black);
  }

  // The pixels that no pass writes are cleared; those of the background pass need none.
  void drawPicture(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings) {
    // The optional attachments decide the targets, so they are settled before a target is chosen.
    targets.resize(size.x, size.y, optional);
    picture = &targets.nextPicture();
    clear(picture->framebuffer.id(), 1);
    drawSample(views, size, settings, 0, picture->framebuffer.id(), Output::Picture);
    lastFramebuffer = picture->framebuffer.id();
    lastSettings = settings;
  }

  void accumulate(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings, int sample, Output output) {
    targets.resize(size.x, size.y, optional);
    const GLuint framebuffer = targets.accumulation();
    if (sample == 0) {
      clear(framebuffer, 0);
      accumulated = 0;
    }
    drawSample(views, size, settings, sample, framebuffer, output);
    ++accumulated;
  }

  // The average so far into the next picture. Pixels without any pass have no alpha; with a black background they
  // are sound all the same.
  void resolve() {
    picture = &targets.nextPicture();
    clear(picture->framebuffer.id(), 1);
    glBindFramebuffer(GL_FRAMEBUFFER, picture->framebuffer.id());
    glViewport(0, 0, targets.width(), targets.height());
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBindVertexArray(tileArray.id());
    const gl::Program& program = programs.shipped(tileVertex(), {"shaders/passes/resolve.frag", {}, {}});
    program.set("scale", 1.0f / static_cast<float>(accumulated));
    glBindTextureUnit(0, targets.accumulationTexture());
    const Tile whole{0, 0, targets.width(), targets.height(), 0, 0};
    if (!wholeTile) wholeTile = gl::createBuffer(std::as_bytes(std::span(&whole, 1)));
    glNamedBufferSubData(wholeTile.id(), 0, sizeof whole, &whole);
    program.set2("targetSize", static_cast<float>(targets.width()), static_cast<float>(targets.height()));
    program.use();
    glVertexArrayVertexBuffer(tileArray.id(), 0, wholeTile.id(), 0, sizeof(Tile));
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 1);
  }

  ProgramCache programs;
  EnvironmentLighting lighting;
  DeviceMeshes meshes;
  DeviceTextures textures;
  FrameTargets targets;
  FrameBuffer frame;
  gl::VertexArray tileArray;
  gl::Buffer wholeTile;
  gl::Texture blackCube, whiteCube, tileLights;
  gl::Buffer whiteHarmonics;
  std::vector<ReadyView> ready;
  OptionalAttachments optional;         // of the frame
  int accumulated = 0;
  float furnaceGround = 1;              // radiance behind the surfaces of the white furnace
  FrameTargets::Picture* picture = nullptr;
  GLuint lastFramebuffer = 0;
  RenderSettings lastSettings;
  Diagnostics problems;
  Statistics statistics;
  uint64_t shippedHash = shippedShaders();    // when programs were last known to be made from them
  std::map<const ShadingModel*, std::shared_ptr<const ModelShader>> shaders;
  std::map<uint64_t, Diagnostics> verdicts;   // by the hash of a model's GLSL
  std::map<std::string, std::shared_ptr<const ModelShader>> lastGood;
};

namespace {

// How many pixels of the views, rows from the bottom, are so; between views nothing is drawn.
template <class IsSo>
int countInViews(std::span<const View> views, glm::ivec2 size, const IsSo& isSo) {
  int count = 0;
  for (const View& view : views) {
    const glm::ivec4 r = view.rectangle;
    for (int y = std::max(r.y, 0); y < std::min(r.y + r.w, size.y); ++y)
      for (int x = std::max(r.x, 0); x < std::min(r.x + r.z, size.x); ++x)
        count += isSo(static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(x));
  }
  return count;
}

}  // namespace

Renderer::Renderer(const gl::Context&) : state_(std::make_unique<State>()) {}
Renderer::~Renderer() = default;

void Renderer::setProgress(Progress progress) { state_->lighting.setProgress(std::move(progress)); }
const Diagnostics& Renderer::problems() const { return state_->problems; }
const Renderer::Statistics& Renderer::statistics() const { return state_->statistics; }
EnvironmentLighting& Renderer::environmentLighting() { return state_->lighting; }

Image8 Renderer::picture(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings) {
  State& s = *state_;
  if (settings.samples <= 1) {
    s.drawPicture(views, size, settings);
  } else {
    for (int i = 0; i < settings.samples; ++i) s.accumulate(views, size, settings, i, Output::Display);
    s.resolve();
  }
  std::vector<uint8_t> pixels(static_cast<size_t>(size.x) * static_cast<size_t>(size.y) * 4);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, s.picture->framebuffer.id());
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  Image8 image(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const uint8_t* p = &pixels[(static_cast<size_t>(size.y - 1 - y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)) * 4];
      std::copy(p, p + 3, image.at(x, y));
    }
  s.statistics.invalidPixels = countInViews(views, size, [&](size_t pixel) { return pixels[pixel * 4 + 3] != 255; });
  return image;
}

ImageF Renderer::linear(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings) {
  State& s = *state_;
  const int samples = std::max(1, settings.samples);
  for (int i = 0; i < samples; ++i) s.accumulate(views, size, settings, i, Output::Radiance);
  std::vector<float> pixels(static_cast<size_t>(size.x) * static_cast<size_t>(size.y) * 4);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, s.targets.accumulation());
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, pixels.data());
  ImageF image(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const float* p = &pixels[(static_cast<size_t>(size.y - 1 - y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)) * 4];
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = p[c] / static_cast<float>(samples);
    }
  s.statistics.invalidPixels =
      countInViews(views, size, [&](size_t pixel) { return pixels[pixel * 4 + 3] < static_cast<float>(samples) - 0.5f; });
  return image;
}

std::vector<Renderer::FurnaceShare> Renderer::furnaceShares(std::span<const View> views, glm::ivec2 size, bool compensate) {
  State& s = *state_;
  RenderSettings settings;
  settings.view = kFurnaceView;
  settings.compensate = compensate;
  // No surface sends back less than nothing: that is where there is none.
  s.furnaceGround = -1;
  const ImageF image = linear(views, size, settings);
  s.furnaceGround = 1;
  std::vector<FurnaceShare> shares;
  for (const View& view : views) {
    FurnaceShare share{.least = std::numeric_limits<double>::infinity()};
    const glm::ivec4 r = view.rectangle;
    for (int y = std::max(r.y, 0); y < std::min(r.y + r.w, size.y); ++y)
      for (int x = std::max(r.x, 0); x < std::min(r.x + r.z, size.x); ++x) {
        const float* p = image.at(x, size.y - 1 - y);
        if (p[0] < 0) continue;
        const double value = (double(p[0]) + p[1] + p[2]) / 3;
        share.mean += value;
        share.least = std::min(share.least, value);
        share.most = std::max(share.most, value);
        ++share.pixels;
      }
    if (share.pixels) share.mean /= share.pixels;
    else share = {};
    shares.push_back(share);
  }
  return shares;
}

unsigned Renderer::drawToTexture(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings) {
  state_->drawPicture(views, size, settings);
  glFinish();
  return state_->picture->raw.id();
}

unsigned Renderer::refineTexture(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings, int sample) {
  State& s = *state_;
  if (sample <= 1) s.accumulate(views, size, settings, 0, Output::Display);
  s.accumulate(views, size, settings, sample, Output::Display);
  s.resolve();
  glFinish();
  return s.picture->raw.id();
}

void Renderer::relight() {
  State& s = *state_;
  s.lightingPass(s.lastSettings, s.lastFramebuffer, Output::Picture);
  glFinish();
}

Diagnostics Renderer::check(const std::shared_ptr<const ShadingModel>& model) { return state_->verdictOn(*state_->shaderOf(model)); }

void Renderer::reloadModels() { state_->reloadModels(); }

int Renderer::programsBuilt() const { return state_->programs.built(); }

}  // namespace glint
