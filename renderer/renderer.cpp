#include "renderer/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "materials/base/hash.h"
#include "renderer/environment_lighting.h"
#include "renderer/model_shaders.h"
#include "renderer/passes/background_pass.h"
#include "renderer/passes/buffer_view_pass.h"
#include "renderer/passes/gbuffer_pass.h"
#include "renderer/passes/lighting_pass.h"
#include "renderer/passes/occlusion_pass.h"
#include "renderer/passes/reference_pass.h"
#include "renderer/passes/shadow_pass.h"
#include "renderer/passes/temporal_pass.h"
#include "renderer/program_cache.h"

namespace glint {
namespace {

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

// Radiance behind the surfaces of an error view: so far below any error that a pixel with a share of it is told.
constexpr float kNoSurface = -1e6f;

}  // namespace

struct Renderer::State {
  // -- Preparation -------------------------------------------------------------------------------------------------
  void prepare(std::span<const View> views, const RenderSettings& settings, glm::vec2 jitter) {
    frame.views.clear();
    frame.uploads.clear();
    frame.problems.clear();
    frame.settings = settings;
    frame.jitter = jitter;
    frame.optional = {};
    rested = false;
    meshes.forgetUnused();
    gbufferPass.forgetUnused();
    lightingPass.forgetUnused();
    programs.forgetUnused();
    lighting.forgetUnused();
    referencePass.forgetUnused();
    statistics = {};
    for (const View& view : views) {
      GLINT_CHECK(view.scene != nullptr && view.rectangle.z > 0 && view.rectangle.w > 0);
      for (const SurfaceMaterial& material : view.scene->materials) {
        frame.optional.emissive |= material.compiled->writesEmissive;
        frame.optional.parameters |= material.compiled->writesModelParameters;
        frame.optional.tangent |= material.model->usesTangent;
        // A coat's roughness is widened pixel by pixel too.
        frame.optional.parameters |= frame.widensLobes() && material.model->coatRoughnessSlot() >= 0;
      }
    }
    for (const View& view : views) frame.views.push_back(ready(view, jitter));
    frame.uploads.upload();
  }

  ReadyView ready(const View& view, glm::vec2 jitter) {
    ReadyView r;
    FrameUploads& uploads = frame.uploads;
    for (const SurfaceMaterial& material : view.scene->materials) {
      r.groupOfMaterial.push_back(isDrawn(material) ? groupOf(material, r.groups) : -1);
      r.materialBlocks.push_back(uploads.append(material.block));
    }
    if (frame.hasShadows() || frame.hasScreenOcclusion()) r.casters = castersOf(*view.scene);
    std::vector<int> shadows(view.scene->lights.size());
    if (frame.hasShadows()) {
      Diagnostics problems;
      shadows = shadowNumbers(view.scene->lights, r.casters, problems);
      for (const Diagnostic& problem : problems) frame.report(problem);
      for (size_t i = 0; i < shadows.size(); ++i) {
        if (shadows[i] == 0) continue;
        r.shadows.resize(std::max(r.shadows.size(), static_cast<size_t>(shadows[i])));
        r.shadows[static_cast<size_t>(shadows[i]) - 1] = *shadowView(view.scene->lights[i], r.casters, kShadowMapSide);
      }
    }
    r.view = prepareView(view, meshes, r.groupOfMaterial, r.groups.size(), shadows, std::exp2(frame.settings.exposure),
                         EnvironmentLighting::kLevels - 1, jitter);
    if (view.scene->environment) r.view.block.environmentIntensity /= lighting.maps(view.scene->environment).scale;
    if (r.view.tooManyDirectional)
      frame.problems.push_back(warning("lights", fmt::format("more than {} directional lights", kMostDirectionalLights), "the others are not drawn"));
    if (frame.isFurnace()) {
      r.view.block.environmentIntensity = 1;
      r.view.block.directionalCount = 0;
    }
    r.viewBlock = uploads.append(std::as_bytes(std::span(&r.view.block, 1)));
    std::vector<DirectionalBlock> directional = r.view.directional;
    directional.resize(kMostDirectionalLights);
    r.directional = uploads.append(std::as_bytes(std::span(directional)));
    for (size_t g = 0; g < r.groups.size(); ++g) {
      const LightTiles& tiles = r.view.tiles[g];
      std::vector<std::byte> lights;
      lights.reserve(tiles.texels * 16);
      const auto append = [&](const auto& block) {
        const auto bytes = std::as_bytes(std::span(&block, 1));
        lights.insert(lights.end(), bytes.begin(), bytes.end());
      };
      const size_t points = r.view.points.size();
      for (uint32_t light : tiles.list)
        if (light < points) append(r.view.points[light]);
        else append(r.view.placed[light - points]);
      r.groups[g].tileLights = uploads.append(lights);
      r.groups[g].tileLightTexels = tiles.texels;
      r.groups[g].tiles = uploads.append(std::as_bytes(std::span(tiles.tiles)));
      r.groups[g].tileCount = tiles.tiles.size();
      statistics.lightBytes += lights.size() + tiles.tiles.size() * sizeof(Tile);
    }
    statistics.triangles += r.view.triangles;
    statistics.lightGroups += static_cast<int>(r.groups.size());
    statistics.lights += static_cast<int>(r.view.directional.size() + r.view.points.size() + r.view.placed.size());
    return r;
  }

  // A ground shows light that is kept away, where any is.
  bool isDrawn(const SurfaceMaterial& material) const {
    if (material.ground == Ground::None) return true;
    return frame.approximates() && (material.ground == Ground::Matte || frame.hasShadows() || frame.hasScreenOcclusion());
  }

  CasterBounds castersOf(const Scene& scene) {
    CasterBounds box;
    for (const Instance& instance : scene.instances) {
      if (scene.materials[static_cast<size_t>(instance.material)].ground != Ground::None) continue;
      const DeviceMesh& mesh = meshes.get(instance.mesh);
      for (int i = 0; i < 8; ++i)
        box.add(instance.worldFromModel * glm::vec4(i & 1 ? mesh.high.x : mesh.low.x, i & 2 ? mesh.high.y : mesh.low.y, i & 4 ? mesh.high.z : mesh.low.z, 1));
    }
    return box;
  }

  int groupOf(const SurfaceMaterial& material, std::vector<LightGroup>& groups) {
    LightGroup group;
    group.ground = material.ground;
    const auto sound = shaders.sound(material.model, frame.problems);
    group.broken = !sound;
    group.setting = modelSetting(sound ? sound : shaders.of(material.model), material.modelParameters, material.compiled->plainNonmetal);
    const ShadingModel& model = *group.setting.shader->model;
    group.compensate = (frame.settings.compensate || model.compensate) && !model.isWhole();  // it has no facets to bounce among
    group.key = group.setting.key() ^ (group.compensate ? 1 : 0) ^ static_cast<uint64_t>(group.ground) << 1;
    for (size_t i = 0; i < groups.size(); ++i)
      if (groups[i].key == group.key) return static_cast<int>(i);
    if (groups.size() == kMostGroups) {
      frame.problems.push_back(error("shading models", fmt::format("more than {} settings of models in one view", kMostGroups), "the others are not drawn"));
      return -1;
    }
    groups.push_back(std::move(group));
    return static_cast<int>(groups.size()) - 1;
  }

  // -- Frames ------------------------------------------------------------------------------------------------------
  // Samples of a reference for each pixel.
  struct ReferenceSamples {
    int first, count;
  };
  void drawSample(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings, int sample, GLuint framebuffer, Output output, ReferenceSamples samples = ReferenceSamples{0, 0}) {
    prepare(views, settings, jitterOf(sample));
    frame.framebuffer = framebuffer;
    frame.output = output;
    frame.sample = sample;
    frame.targets.resize(size.x, size.y, frame.optional);
    gbufferPass.draw(frame);
    drawVisibility();
    if (frame.isLit() && settings.reference > 0) referencePass.draw(frame, lists, samples.first, samples.count);
    else if (frame.isLit()) lightingPass.draw(frame, lists);
    else bufferViewPass.draw(frame, lists);
    // In an average every pixel must count its samples, so a black background is drawn there too.
    if (output != Output::Picture || !BackgroundPass::isBlack(frame)) backgroundPass.draw(frame);
    statistics.coarseTables = static_cast<int>(lighting.coarseCount());
  }

  // What keeps light away; again only when it may be another than in the last frame.
  void drawVisibility() {
    size_t shadows = 0;
    for (const ReadyView& r : frame.views) shadows = std::max(shadows, r.shadows.size());
    frame.visibility = 0;
    if (shadows == 0 && !frame.hasScreenOcclusion()) return;
    const FrameTargets::Visibility& visibility = frame.targets.visibility(static_cast<int>(shadows) + 1);
    frame.visibility = visibility.texture.id();
    std::vector<Image8Ptr> images;
    uint64_t key = visibility.made;
    const auto add = [&key](const auto& value) { key = hashBytes(&value, sizeof value, key); };
    add(frame.sample);
    add(frame.settings.shadows);
    add(frame.settings.occlusionRadius);
    add(frame.hasScreenOcclusion());
    for (const ReadyView& r : frame.views) {
      add(r.view.rectangle);
      key = hashBytes(&r.view.block, offsetof(ViewBlock, environmentX), key);   // where it looks from
      add(shadowPass.castersKey(r));
      for (const ShadowView& shadow : r.shadows) add(shadow);
      for (const SurfaceMaterial& material : r.view.scene->materials) {
        add(isDrawn(material));
        add(material.doubleSided);
        if (!material.compiled->writesNormal && !material.compiled->writesOpacityMask) continue;
        add(material.compiled->hash);
        key = hashBytes(material.block.data(), material.block.size(), key);
        images.insert(images.end(), material.textures.begin(), material.textures.end());
      }
    }
    for (const Image8Ptr& image : images) {
      const Image8* address = image.get();
      add(address);
    }
    if (key == visibilityKey) return;
    visibilityKey = key;
    visibilityImages = std::move(images);
    if (shadows > 0) statistics.shadowMaps += shadowPass.draw(frame, visibility);
    if (frame.hasScreenOcclusion()) occlusionPass.draw(frame, visibility);
    // The lighting reads what was drawn here, with the same depth attached.
    glTextureBarrier();
  }

  // Black, and sound (alpha 1) as often as samples will be added.
  void clear(GLuint framebuffer, float alpha) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    const GLfloat black[4] = {0, 0, 0, alpha};
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, black);
  }

  // The frames of a picture, and into what they are added up.
  static int framesOf(const RenderSettings& settings) {
    const int frames = std::max(1, settings.samples);
    if (settings.reference == 0) return frames;
    // Each has a sample, and in the error view one for each of its two references.
    return std::min(frames, isError(settings) ? std::max(1, settings.reference / 2) : settings.reference);
  }
  static bool isError(const RenderSettings& settings) { return settings.view == kErrorView; }
  static Output outputOf(const RenderSettings& settings) { return settings.reference > 0 ? Output::Radiance : Output::Display; }
  // Of a frame: each has its share, and of those beyond the picture's as many again.
  static int firstReferenceSample(const RenderSettings& settings, int frame) {
    return static_cast<int>(int64_t{settings.reference} * frame / framesOf(settings));
  }

  // The pixels that no pass writes are cleared; those of the background pass need none.
  void drawPicture(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings) {
    // The optional attachments decide the targets, so they are settled before a target is chosen.
    frame.targets.resize(size.x, size.y, frame.optional);
    picture = &frame.targets.nextPicture();
    clear(picture->framebuffer.id(), 1);
    drawSample(views, size, settings, 0, picture->framebuffer.id(), Output::Picture);
    followed = false;
  }

  // As drawPicture(), averaged with the pictures before.
  void drawTemporal(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings) {
    if (rested) temporalPass.remember(frame, frame.targets.accumulationTexture(), accumulated);
    frame.targets.resize(size.x, size.y, frame.optional);
    const GLuint framebuffer = frame.targets.accumulation(kSecondReference);
    clear(framebuffer, 0);
    drawSample(views, size, settings, temporalPass.nextSample(), framebuffer, Output::Display);
    picture = &frame.targets.nextPicture();
    clear(picture->framebuffer.id(), 1);
    temporalPass.draw(frame, frame.targets.accumulationTexture(kSecondReference), *picture);
    followed = temporalPass.age() >= kEnoughSamples;
  }

  // What the accumulations hold in the error view; else all is in the first of them.
  enum : size_t { kFirstReference, kSecondReference, kApproximation };

  void accumulate(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings, int sample, Output output) {
    FrameTargets& targets = frame.targets;
    targets.resize(size.x, size.y, frame.optional);
    if (sample == 0) {
      for (size_t i = 0; i < (isError(settings) ? FrameTargets::kAccumulations : 1); ++i) clear(targets.accumulation(i), 0);
      accumulated = 0;
    }
    const int first = firstReferenceSample(settings, sample), end = firstReferenceSample(settings, sample + 1);
    if (isError(settings)) {
      GLINT_CHECK(end - first >= 2, "an error needs two samples of its reference in each frame, not {}", end - first);
      const int middle = (first + end) / 2;
      RenderSettings lit = settings;
      lit.view = "lit";
      lit.background = Background::Color;
      lit.backgroundColor = glm::vec3(kNoSurface / std::exp2(settings.exposure));
      lit.shadows = Shadows::Off;   // a reference has none
      lit.screenOcclusion = false;
      lit.specularAntialiasing = false;
      lit.splitSum = false;
      drawSample(views, size, lit, sample, targets.accumulation(kFirstReference), Output::Radiance, {first, middle - first});
      drawSample(views, size, lit, sample, targets.accumulation(kSecondReference), Output::Radiance, {middle, end - middle});
      // Last, as its statistics are the picture's.
      lit.splitSum = settings.splitSum;
      if (!settings.splitSum) lit.reference = 0;
      drawSample(views, size, lit, sample, targets.accumulation(kApproximation), Output::Radiance, {first, end - first});
    } else {
      drawSample(views, size, settings, sample, targets.accumulation(), output, {first, end - first});
    }
    ++accumulated;
  }

  // The average so far into the next picture. Pixels without any pass have no alpha; with a black background they
  // are sound all the same.
  void resolve(const RenderSettings& settings) {
    picture = &frame.targets.nextPicture();
    clear(picture->framebuffer.id(), 1);
    const bool error = isError(settings);
    // A few samples are rougher than what was shown while the view moved, and give way to it.
    const bool following = followed && !error && settings.reference == 0 && accumulated < kEnoughSamples;
    std::vector<std::string> defines;
    if (settings.reference > 0 && !error) defines = frame.displayDefines();
    if (following) defines.push_back("FOLLOWING");
    const gl::Program& program = programs.shipped(Rectangles::vertexShader(), {error ? "shaders/passes/error.frag" : "shaders/passes/resolve.frag", defines, {}});
    program.set("scale", 1.0f / static_cast<float>(accumulated));
    if (following) {
      program.set("share", static_cast<float>(accumulated) / kEnoughSamples);
      glBindTextureUnit(1, temporalPass.average());
      glBindSampler(1, 0);
    }
    glBindTextureUnit(0, frame.targets.accumulationTexture(error ? kApproximation : kFirstReference));
    if (error) {
      glBindTextureUnit(1, frame.targets.accumulationTexture(kFirstReference));
      glBindTextureUnit(2, frame.targets.accumulationTexture(kSecondReference));
      program.set("errorScale", settings.errorScale);
      program.set("errorFloor", kErrorFloor);
      program.set3("less", &kErrorColors.less.x);
      program.set3("none", &kErrorColors.none.x);
      program.set3("more", &kErrorColors.more.x);
      program.set3("noSurface", &kErrorColors.noSurface.x);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, picture->framebuffer.id());
    glViewport(0, 0, frame.size().x, frame.size().y);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glEnable(GL_FRAMEBUFFER_SRGB);
    frame.rectangles.draw(program, frame.size(), Tile{0, 0, frame.size().x, frame.size().y, 0, 0, 0, 0});
  }

  // The average so far, RGBA, rows from the bottom.
  std::vector<glm::vec4> readAverage(glm::ivec2 size, size_t which = 0) {
    std::vector<glm::vec4> pixels(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.targets.accumulation(which));
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, pixels.data());
    for (glm::vec4& pixel : pixels) pixel /= static_cast<float>(accumulated);
    return pixels;
  }

  Frame frame;
  ProgramCache programs;
  EnvironmentLighting lighting{programs, frame.rectangles, true};
  ModelShaders shaders{programs, frame.rectangles};
  DeviceMeshes meshes;
  LightLists lists;
  GbufferPass gbufferPass{programs};
  BackgroundPass backgroundPass{programs, lighting};
  LightingPass lightingPass{programs, frame.rectangles, lighting, backgroundPass};
  ReferencePass referencePass{programs, lighting, backgroundPass};
  BufferViewPass bufferViewPass{programs};
  ShadowPass shadowPass{programs, meshes, gbufferPass};
  OcclusionPass occlusionPass{programs};
  TemporalPass temporalPass{programs};
  static constexpr int kEnoughSamples = 4;
  bool followed = false;   // drawToTexture() drew with the pictures before
  bool rested = false;     // the frame is the last of an average that refineTexture() made
  // Of what FrameTargets::visibility holds, and its pictures, so that none of the same address takes their place.
  uint64_t visibilityKey = 0;
  std::vector<Image8Ptr> visibilityImages;
  int accumulated = 0;
  FrameTargets::Picture* picture = nullptr;
  Statistics statistics;
};

namespace {

// Of the error view: whether surfaces cover the pixel in all of its samples.
bool isSurface(const glm::vec4& approximation, const glm::vec4& reference) {
  return approximation.a > 0 && std::min(luminanceOf(&approximation.x), luminanceOf(&reference.x)) > -1;
}

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

void Renderer::setProgress(Progress progress) {
  state_->referencePass.setProgress(progress);
  state_->lighting.setProgress(std::move(progress));
}
const Diagnostics& Renderer::problems() const { return state_->frame.problems; }
const Renderer::Statistics& Renderer::statistics() const { return state_->statistics; }
EnvironmentLighting& Renderer::environmentLighting() { return state_->lighting; }

Image8 Renderer::picture(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings) {
  State& s = *state_;
  if (settings.samples <= 1 && settings.reference == 0) {
    s.drawPicture(views, size, settings);
  } else {
    for (int i = 0; i < State::framesOf(settings); ++i) s.accumulate(views, size, settings, i, State::outputOf(settings));
    s.resolve(settings);
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
  const int samples = State::framesOf(settings);
  for (int i = 0; i < samples; ++i) s.accumulate(views, size, settings, i, Output::Radiance);
  std::vector<glm::vec4> pixels = s.readAverage(size);
  if (State::isError(settings)) {
    const auto second = s.readAverage(size, State::kSecondReference), approximation = s.readAverage(size, State::kApproximation);
    for (size_t i = 0; i < pixels.size(); ++i) {
      const glm::vec4 truth = 0.5f * (pixels[i] + second[i]), about = approximation[i];
      const glm::vec3 error = glm::vec3(about - truth) / glm::max(glm::vec3(truth), glm::vec3(kErrorFloor));
      pixels[i] = glm::vec4(isSurface(about, truth) ? error : glm::vec3(0), std::min(truth.a, about.a));
    }
  }
  ImageF image(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec4& p = pixels[static_cast<size_t>(size.y - 1 - y) * static_cast<size_t>(size.x) + static_cast<size_t>(x)];
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = p[c];
    }
  const float sound = 1 - 0.5f / static_cast<float>(samples);
  s.statistics.invalidPixels = countInViews(views, size, [&](size_t pixel) { return pixels[pixel].a < sound; });
  return image;
}

std::vector<ReferenceError> Renderer::referenceErrors(std::span<const View> views, glm::ivec2 size) {
  State& s = *state_;
  const auto first = s.readAverage(size, State::kFirstReference), second = s.readAverage(size, State::kSecondReference),
             approximation = s.readAverage(size, State::kApproximation);
  std::vector<ReferenceError> errors;
  for (const View& view : views) {
    ReferenceErrorSum sum;
    countInViews({&view, 1}, size, [&](size_t i) {
      if (isSurface(approximation[i], first[i])) sum.add(luminanceOf(&approximation[i].x), luminanceOf(&first[i].x), luminanceOf(&second[i].x));
      return false;
    });
    errors.push_back(sum.error());
  }
  return errors;
}

std::vector<Renderer::FurnaceShare> Renderer::furnaceShares(std::span<const View> views, glm::ivec2 size, bool compensate) {
  State& s = *state_;
  RenderSettings settings;
  settings.view = kFurnaceView;
  settings.compensate = compensate;
  // No surface sends back less than nothing: that is where there is none.
  s.frame.furnaceGround = -1;
  const ImageF image = linear(views, size, settings);
  s.frame.furnaceGround = 1;
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
  State& s = *state_;
  if (settings.reference > 0) {
    s.accumulate(views, size, settings, 0, Output::Radiance);
    s.resolve(settings);
  } else if (settings.temporal && (settings.view == "lit" || settings.view == kFurnaceView)) {
    s.drawTemporal(views, size, settings);
  } else {
    s.drawPicture(views, size, settings);
  }
  glFinish();
  return s.picture->raw.id();
}

unsigned Renderer::refineTexture(std::span<const View> views, glm::ivec2 size, const RenderSettings& settings, int sample) {
  State& s = *state_;
  // The first of a reference is there already.
  if (sample <= 1 && settings.reference == 0) s.accumulate(views, size, settings, 0, Output::Display);
  s.accumulate(views, size, settings, sample, State::outputOf(settings));
  s.resolve(settings);
  s.rested = s.frame.isLit() && settings.reference == 0;
  glFinish();
  return s.picture->raw.id();
}

std::vector<float> Renderer::depths(glm::ivec2 size) {
  std::vector<float> depths(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state_->frame.targets.gbuffer());
  glReadPixels(0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  const glm::vec4 terms = state_->frame.views.front().view.block.depthTerms;   // as shaders/common/screen.glsl
  for (float& depth : depths) depth = depth < 1 ? (terms.x + terms.y * depth) / (terms.z + terms.w * depth) : std::numeric_limits<float>::infinity();
  return depths;
}

void Renderer::relight() {
  State& s = *state_;
  s.lightingPass.draw(s.frame, s.lists);
  glFinish();
}

Diagnostics Renderer::check(const std::shared_ptr<const ShadingModel>& model) { return state_->shaders.verdict(*state_->shaders.of(model)); }

void Renderer::reloadModels() { state_->shaders.reload(); }

bool Renderer::refineTable() { return state_->lighting.refineOne(); }

int Renderer::programsBuilt() const { return state_->programs.built(); }

}  // namespace glint
