#include "renderer/environment_lighting.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "materials/base/hash.h"
#include "renderer/disk_cache.h"
#include "renderer/environment_irradiance.h"
#include "renderer/lobe.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr int kLobeWidth = 1024, kAzimuths = 8;
// Part of every key on disk: raise it when what is stored changes its meaning.
constexpr uint64_t kCacheVersion = 6;

// Also part of them: the recipe, so that a changed shader or number of samples never meets old results.
uint64_t recipeHash() {
  static const uint64_t hash = [] {
    uint64_t h = kCacheVersion;
    for (const char* file : {"shaders/passes/prefilter.frag", "shaders/passes/lobe.frag", "shaders/passes/environment_brdf.frag", "shaders/passes/cube_from_equirect.frag",
                             "shaders/common/shading.glsl", "shaders/common/floor_light.glsl"})
      h = hashText(shipped::read(file).value_or(""), h);
    for (int level = 0; level < EnvironmentLighting::kLevels; ++level) {
      const int samples = EnvironmentLighting::levelSamples(level);
      h = hashBytes(&samples, sizeof samples, h);
    }
    return h;
  }();
  return hash;
}

}  // namespace

uint64_t EnvironmentLighting::keyOf(const ModelSetting& setting, Lobe lobe) { return setting.key() ^ recipeHash() ^ static_cast<uint64_t>(lobe); }

float EnvironmentLighting::levelRoughness(int level) {
  const double t = static_cast<double>(level) / (kLevels - 1);
  // 0.7 r^2 - 1.7 r + t = 0
  return static_cast<float>((1.7 - std::sqrt(1.7 * 1.7 - 4 * 0.7 * t)) / 1.4);
}

int EnvironmentLighting::levelSamples(int level) {
  constexpr int kSamples[kLevels] = {1, 96, 224, 400, 768, 1536};
  return kSamples[level];
}

EnvironmentLighting::EnvironmentLighting(ProgramCache& programs, const Rectangles& rectangles, bool diskCache)
    : programs_(programs), rectangles_(rectangles), diskCache_(diskCache), tables_(diskCache) {}

void EnvironmentLighting::setProgress(Progress progress) {
  tables_.setProgress(progress);
  progress_ = std::move(progress);
}

void EnvironmentLighting::forgetUnused() {
  constexpr size_t kSpareMaps = 1, kSpareTables = 8;
  coarse_.clear();
  maps_.nextFrame(kSpareMaps);
  rests_.nextFrame(kSpareMaps);
  prefiltered_.nextFrame(kSpareTables);
  brdf_.nextFrame(kSpareTables);
  tables_.forgetUnused();
}

gl::Texture EnvironmentLighting::drawCube(const ImageF& image, int size, float scale, const std::string& name) {
  gl::Texture cube = gl::createTextureCube(GL_RGBA16F, size, std::bit_width(static_cast<unsigned>(size)));

  // Level 0 only: a level per source pixel would blur, so a large panorama is sampled several times a texel.
  gl::Texture equirect = gl::createTexture2D(GL_RGB32F, image.width, image.height);
  glTextureParameteri(equirect.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  // Row 0 is the top, which is v = 0 here as well: the shader counts v from the top.
  glTextureSubImage2D(equirect.id(), 0, 0, 0, image.width, image.height, GL_RGB, GL_FLOAT, image.data.data());
  const gl::Program& program = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/cube_from_equirect.frag", {}, {}});
  program.set("size", static_cast<float>(size));
  program.set("scale", scale);
  program.set("perSide", std::clamp(image.width / (4 * size) * 2, 2, 8));
  glBindTextureUnit(0, equirect.id());
  gl::Framebuffer framebuffer = gl::createFramebuffer({});
  const GLenum buffer = GL_COLOR_ATTACHMENT0;
  glNamedFramebufferDrawBuffers(framebuffer.id(), 1, &buffer);
  for (int face = 0; face < 6; ++face) {
    glNamedFramebufferTextureLayer(framebuffer.id(), GL_COLOR_ATTACHMENT0, cube.id(), 0, face);
    program.set("face", face);
    rectangles_.drawWhole(program, framebuffer.id(), {size, size});
    if (progress_) progress_("environment " + name, (face + 1) / 7.0);
  }
  glGenerateTextureMipmap(cube.id());
  return cube;
}

const EnvironmentMaps& EnvironmentLighting::maps(const EnvironmentPtr& environment) {
  if (const EnvironmentMaps* found = maps_.find(environment->hash)) return *found;

  const ImageF& image = environment->pixels;
  EnvironmentMaps maps;
  // A face covers a quarter of the panorama's width.
  maps.size = std::clamp(static_cast<int>(std::bit_ceil(static_cast<unsigned>(image.width) / 4)), 16, 1024);
  // Halfs end at 65504; the sun is brighter than that, the sky a million times darker.
  constexpr float kBrightest = 30000;
  const float peak = *std::max_element(image.data.begin(), image.data.end());
  maps.scale = peak > kBrightest ? kBrightest / peak : 1;
  maps.cube = drawCube(image, maps.size, maps.scale, environment->name);
  DiffuseLight diffuse = diffuseLight(image);
  for (glm::vec4& coefficient : diffuse.harmonics) coefficient *= maps.scale;
  // The shader asks the first one where the light is.
  diffuse.harmonics[0].w = diffuse.needsMap() ? 1 : 0;
  maps.harmonics = gl::createBuffer(std::as_bytes(std::span(diffuse.harmonics)));
  if (diffuse.needsMap()) {
    constexpr int kSide = DiffuseLight::kMapSize;
    for (glm::vec4& texel : diffuse.map) texel *= maps.scale;
    maps.irradianceCube = gl::createTextureCube(GL_RGBA16F, kSide, 1);
    glTextureSubImage3D(maps.irradianceCube.id(), 0, 0, 0, 0, kSide, kSide, 6, GL_RGBA, GL_FLOAT, diffuse.map.data());
  }
  if (progress_) progress_("environment " + environment->name, 1);
  return maps_.put(environment->hash, std::move(maps));
}

GLuint EnvironmentLighting::uniformCube(int value) {
  gl::Texture& cube = value ? whiteCube_ : blackCube_;
  if (!cube) {
    cube = gl::createTextureCube(GL_RGBA16F, 1, 1);
    const float color[4] = {float(value), float(value), float(value), float(value)};
    glClearTexImage(cube.id(), 0, GL_RGBA, GL_FLOAT, color);
  }
  return cube.id();
}

GLuint EnvironmentLighting::whiteIrradiance() {
  if (!whiteHarmonics_) {
    std::array<glm::vec4, 9> harmonics{};
    harmonics[0] = glm::vec4(1, 1, 1, 0);
    whiteHarmonics_ = gl::createBuffer(std::as_bytes(std::span(harmonics)));
  }
  return whiteHarmonics_.id();
}

std::vector<std::string> definesOf(Lobe lobe) { return lobe == Lobe::Coat ? std::vector<std::string>{"COAT"} : std::vector<std::string>{}; }

Result<std::vector<std::vector<float>>> EnvironmentLighting::lobe(const ModelSetting& setting, Lobe which) {
  const auto program = programs_.get(
      Rectangles::vertexShader(), {"shaders/passes/lobe.frag", definesOf(which), {{"model", setting.shader->glsl}}});
  if (!program) return program.diagnostics();
  float roughnesses[16] = {};
  for (int level = 0; level < kLevels; ++level) roughnesses[level] = levelRoughness(level);
  glProgramUniform1fv((*program)->id(), (*program)->location("roughnesses"), 16, roughnesses);
  const bool round = !setting.shader->model->usesTangent || which == Lobe::Coat;
  const int azimuths = round ? 1 : kAzimuths, height = kLevels * azimuths;
  (*program)->set("width", static_cast<float>(kLobeWidth));
  (*program)->set("roughnessCount", kLevels);
  (*program)->set("azimuthCount", azimuths);
  if (Diagnostics faults = tables_.apply(setting, **program); !faults.empty()) return faults;
  const gl::Texture target = gl::createTexture2D(GL_R32F, kLobeWidth, height);
  const GLuint color = target.id();
  const gl::Framebuffer framebuffer = gl::createFramebuffer(std::span(&color, 1));
  rectangles_.drawWhole(**program, framebuffer.id(), {kLobeWidth, height});
  std::vector<float> values(static_cast<size_t>(kLobeWidth * height));
  glGetTextureImage(color, 0, GL_RED, GL_FLOAT, static_cast<GLsizei>(values.size() * 4), values.data());
  if (const auto bad = std::count_if(values.begin(), values.end(), [](float v) { return !(v >= 0); })) {
    int& told = invalid_[keyOf(setting)].lobe;
    told = std::max(told, static_cast<int>(bad));
    for (float& v : values) v = v >= 0 ? v : 0;
  }
  const auto row = [&](int azimuth, int level) {
    const auto begin = values.begin() + (azimuth * kLevels + level) * kLobeWidth;
    return std::vector<float>(begin, begin + kLobeWidth);
  };
  std::vector<std::vector<float>> rows;
  std::array<glm::vec2, kLevels> stretch{};
  for (int level = 0; level < kLevels; ++level) {
    std::vector<std::vector<float>> around;
    for (int azimuth = 0; azimuth < azimuths; ++azimuth) around.push_back(row(azimuth, level));
    const StretchedLobe lobe = round ? StretchedLobe{} : stretchedLobe(around);
    stretch[static_cast<size_t>(level)] = level == 0 ? glm::vec2(0) : lobe.stretch;
    rows.push_back(std::move(around[lobe.narrowest]));
  }
  if (!round) stretches_[keyOf(setting)] = stretch;
  return rows;
}

const std::array<glm::vec2, EnvironmentLighting::kLevels>& EnvironmentLighting::stretch(const ModelSetting& setting) {
  const uint64_t key = keyOf(setting);
  if (!stretches_.contains(key)) {
    if (stretches_.size() > 1000) stretches_.clear();
    const auto rows = lobe(setting);
    GLINT_CHECK(rows.ok() && stretches_.contains(key), "the model uses the tangent and compiles");
  }
  return stretches_.at(key);
}

Result<const LobeWidths*> EnvironmentLighting::widths(const ModelSetting& setting) {
  const uint64_t key = keyOf(setting);
  if (const auto found = widths_.find(key); found != widths_.end()) return found->second.get();
  auto made = std::make_unique<LobeWidths>();
  const auto measure = [&](Lobe which, std::array<float, kLevels>& roots) -> Diagnostics {
    const auto rows = lobe(setting, which);
    if (!rows) return rows.diagnostics();
    for (size_t level = 0; level < roots.size(); ++level) {
      // A lobe of nothing: any width will do.
      const double slope = medianSlope((*rows)[level]);
      roots[level] = static_cast<float>(std::sqrt(slope > 0 ? slope : 1));
    }
    return {};
  };
  if (Diagnostics faults = measure(Lobe::Base, made->base); !faults.empty()) return faults;
  if (setting.shader->model->definesCoat)
    if (Diagnostics faults = measure(Lobe::Coat, made->coat); !faults.empty()) return faults;
  if (setting.shader->model->usesTangent) made->stretch = stretch(setting);
  if (widths_.size() > 1000) widths_.clear();
  return (widths_[key] = std::move(made)).get();
}

void LobeWidths::apply(const gl::Program& program) const {
  glProgramUniform1fv(program.id(), program.location("lobeRoots"), static_cast<GLsizei>(base.size()), base.data());
  glProgramUniform1fv(program.id(), program.location("coatRoots"), static_cast<GLsizei>(coat.size()), coat.data());
  glProgramUniform2fv(program.id(), program.location("lobeStretch"), static_cast<GLsizei>(stretch.size()), &stretch[0].x);
}

bool EnvironmentLighting::refineOne() {
  if (coarse_.empty()) return false;
  const Coarse one = std::move(coarse_.back());
  coarse_.pop_back();
  // Whatever is wrong is said when it is drawn.
  if (one.environment) (void)prefiltered(one.environment, one.setting, one.lobe);
  else (void)brdf(one.setting, one.lobe);
  return true;
}

namespace {

// The tables of drawBrdf().
constexpr size_t tableBytes(int size) { return static_cast<size_t>(size * size) * 8; }

glm::vec4 texelOf(const std::string& halfs, int size, size_t table, size_t texel) {
  uint64_t bits;
  std::memcpy(&bits, halfs.data() + table * tableBytes(size) + texel * 8, 8);
  return glm::unpackHalf4x16(bits);
}

bool isGrey(const std::string& halfs, int size) {
  for (size_t table = 0; table < 3; ++table)
    for (size_t i = 0; i < static_cast<size_t>(size * size); ++i) {
      const glm::vec4 c = texelOf(halfs, size, table, i);
      if (std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) > 2e-3f * (1 + std::abs(c.g))) return false;
    }
  return true;
}

// With more texels, between the old ones; the outermost stay where they are.
std::string enlarged(const std::string& halfs, int from, int to) {
  std::string result;
  result.reserve(3 * tableBytes(to));
  for (size_t table = 0; table < 3; ++table)
    for (int y = 0; y < to; ++y)
      for (int x = 0; x < to; ++x) {
        const glm::vec2 at = glm::vec2(x, y) * static_cast<float>(from - 1) / static_cast<float>(to - 1);
        const glm::ivec2 a = glm::min(glm::ivec2(at), from - 2);
        const glm::vec2 t = at - glm::vec2(a);
        const auto texel = [&](int dx, int dy) { return texelOf(halfs, from, table, static_cast<size_t>((a.y + dy) * from + a.x + dx)); };
        const uint64_t bits = glm::packHalf4x16(glm::mix(glm::mix(texel(0, 0), texel(1, 0), t.x), glm::mix(texel(0, 1), texel(1, 1), t.x), t.y));
        result.append(reinterpret_cast<const char*>(&bits), 8);
      }
  return result;
}

}  // namespace

Result<EnvironmentLighting::BrdfTable> EnvironmentLighting::brdf(const ModelSetting& setting, Lobe which, TableQuality quality) {
  constexpr int kCoarseSize = 16;
  uint64_t key = keyOf(setting, which);
  if (const StoredBrdf* found = brdf_.find(key)) return BrdfTable{found->texture.id(), found->colored};
  auto stored = diskCache_ ? readCache("environment-brdf", key) : std::nullopt;
  std::string halfs;
  if (stored && stored->size() == 3 * tableBytes(kBrdfSize)) {
    halfs = std::move(*stored);
  } else {
    const bool coarse = quality == TableQuality::Coarse;
    if (coarse) {
      coarse_.push_back({nullptr, setting, which});
      key ^= kCoarseKey;
      if (const StoredBrdf* found = brdf_.find(key)) return BrdfTable{found->texture.id(), found->colored};
    }
    auto drawn = drawBrdf(setting, which, coarse ? kCoarseSize : kBrdfSize);
    if (!drawn) return drawn.diagnostics();
    halfs = coarse ? enlarged(*drawn, kCoarseSize, kBrdfSize) : std::move(*drawn);
    if (!coarse && diskCache_) writeCache("environment-brdf", key, halfs);
  }
  StoredBrdf made;
  made.colored = which == Lobe::Coat || !isGrey(halfs, kBrdfSize);
  int bad = 0;
  std::vector<glm::vec4> grey;
  for (size_t i = 0; i < static_cast<size_t>(kBrdfSize * kBrdfSize); ++i) {
    const auto texel = [&](size_t table) { return texelOf(halfs, kBrdfSize, table, i); };
    bad += texel(0).a == 0;
    grey.emplace_back(texel(0).g, texel(1).g, texel(2).g, texel(1).a);
  }
  if (bad) invalid_[keyOf(setting)].brdf = bad;
  made.texture = gl::createTexture2D(GL_RGBA16F, kBrdfSize, made.colored ? 3 * kBrdfSize : kBrdfSize);
  if (made.colored) glTextureSubImage2D(made.texture.id(), 0, 0, 0, kBrdfSize, 3 * kBrdfSize, GL_RGBA, GL_HALF_FLOAT, halfs.data());
  else glTextureSubImage2D(made.texture.id(), 0, 0, 0, kBrdfSize, kBrdfSize, GL_RGBA, GL_FLOAT, grey.data());
  const StoredBrdf& kept = brdf_.put(key, std::move(made));
  return BrdfTable{kept.texture.id(), kept.colored};
}

Result<std::string> EnvironmentLighting::drawBrdf(const ModelSetting& setting, Lobe which, int size) {
  const std::string what = "environment BRDF of " + setting.shader->model->title;
  if (progress_) progress_(what, 0);
  const auto found = programs_.get(Rectangles::vertexShader(), {"shaders/passes/environment_brdf.frag", definesOf(which),
                                                                {{"model", setting.shader->glsl}}});
  if (!found) return found.diagnostics();
  const gl::Program& program = **found;
  program.set2("size", static_cast<float>(size), static_cast<float>(size));
  if (Diagnostics faults = tables_.apply(setting, program); !faults.empty()) return faults;
  gl::Texture tables[3];
  GLuint colors[3];
  for (size_t i = 0; i < 3; ++i) {
    tables[i] = gl::createTexture2D(GL_RGBA16F, size, size);
    colors[i] = tables[i].id();
  }
  const gl::Framebuffer framebuffer = gl::createFramebuffer(colors);
  rectangles_.drawWhole(program, framebuffer.id(), {size, size});
  std::string halfs(3 * tableBytes(size), '\0');
  for (size_t i = 0; i < 3; ++i)
    glGetTextureImage(colors[i], 0, GL_RGBA, GL_HALF_FLOAT, static_cast<GLsizei>(tableBytes(size)), halfs.data() + i * tableBytes(size));
  if (progress_) progress_(what, 1);
  return halfs;
}

EnvironmentLighting::Invalid EnvironmentLighting::invalid(const ModelSetting& setting) const {
  const auto found = invalid_.find(keyOf(setting));
  return found == invalid_.end() ? Invalid{} : found->second;
}

}  // namespace glint
