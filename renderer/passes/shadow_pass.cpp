#include "renderer/passes/shadow_pass.h"

#include <algorithm>

#include "materials/base/hash.h"

namespace glint {
namespace {

// From 0 .. 1 to clip space.
const glm::mat4 kClipFromUnit(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, -1, -1, 1);

template <class T>
uint64_t hashOf(const T& value, uint64_t seed) {
  return hashBytes(&value, sizeof value, seed);
}

gl::Sampler borderedSampler(bool test) {
  gl::Sampler sampler = gl::createSampler(test ? GL_LINEAR : GL_NEAREST, test ? GL_LINEAR : GL_NEAREST, GL_CLAMP_TO_BORDER, GL_CLAMP_TO_BORDER);
  const GLfloat empty[4] = {1, 1, 1, 1};
  glSamplerParameterfv(sampler.id(), GL_TEXTURE_BORDER_COLOR, empty);
  if (test) {
    glSamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
  return sampler;
}

bool casts(const SurfaceMaterial& material) { return material.ground == Ground::None; }

}  // namespace

uint64_t ShadowPass::castersKey(const ReadyView& r) {
  const Scene& scene = *r.view.scene;
  uint64_t key = 1;
  for (const Instance& instance : scene.instances) {
    const SurfaceMaterial& material = scene.materials[static_cast<size_t>(instance.material)];
    if (!casts(material)) continue;
    key = hashOf(instance.worldFromModel, hashOf(meshes_.get(instance.mesh).serial, key));
    if (!material.compiled->writesOpacityMask) continue;
    key = hashOf(material.opacityCutoff, hashOf(material.compiled->hash, key));
    key = hashBytes(material.block.data(), material.block.size(), key);
    for (const Image8Ptr& image : material.textures) key = hashOf(static_cast<const void*>(image.get()), key);
  }
  return key;
}

void ShadowPass::drawMap(Frame& frame, const ReadyView& r, const ShadowView& shadow, const Map& map) {
  const Scene& scene = *r.view.scene;
  const glm::mat4 clipFromWorld = kClipFromUnit * shadow.mapFromWorld;
  const GLfloat empty = 1;
  glDepthMask(GL_TRUE);
  glClearNamedFramebufferfv(map.framebuffer.id(), GL_DEPTH, 0, &empty);
  glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer.id());
  glViewport(0, 0, kShadowMapSide, kShadowMapSide);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  // What is before the near plane of a light among its casters still casts.
  glEnable(GL_DEPTH_CLAMP);
  for (size_t m = 0; m < scene.materials.size(); ++m) {
    const SurfaceMaterial& material = scene.materials[m];
    if (!casts(material)) continue;
    const int group = r.groupOfMaterial[m];
    // A material whose program does not compile, which the G-buffer's pass tells, casts the shadow of its whole surface.
    const gl::Program* masked = nullptr;
    if (material.compiled->writesOpacityMask && group >= 0)
      if (const auto made = programs_.get({"shaders/passes/gbuffer.vert", {"SHADOW_MAP"}, {}},
                                          {"shaders/passes/shadow_mask.frag", {}, {{"material", material.compiled->glsl}}}))
        masked = *made;
    const gl::Program& program = masked ? *masked : programs_.shipped({"shaders/passes/shadow.vert", {}, {}}, {"shaders/passes/shadow.frag", {}, {}});
    program.use();
    if (masked) {
      frame.uploads.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
      gbuffer_.bindMaterial(frame, r, program, m, group);
      program.setMatrix4("mapFromWorld", &clipFromWorld[0][0]);
    }
    for (const Instance& instance : scene.instances) {
      if (instance.material != static_cast<int>(m)) continue;
      const DeviceMesh& mesh = meshes_.get(instance.mesh);
      const glm::mat4 clipFromModel = clipFromWorld * instance.worldFromModel;
      program.setMatrix4("mapFromModel", &clipFromModel[0][0]);
      program.setMatrix4("worldFromModel", &instance.worldFromModel[0][0]);
      program.setMatrix4("normalFromModel", &instance.worldFromModel[0][0]);   // a mask reads no normal, or nearly none
      glBindVertexArray(mesh.array.id());
      glDrawElements(GL_TRIANGLES, mesh.indexCount, GL_UNSIGNED_INT, nullptr);
    }
  }
  glDisable(GL_DEPTH_CLAMP);
  ++drawn_;
}

const ShadowPass::Map& ShadowPass::map(Frame& frame, const ReadyView& r, const ShadowView& shadow, uint64_t casters) {
  const uint64_t key = hashOf(shadow.mapFromWorld, casters);
  auto found = std::find_if(maps_.begin(), maps_.end(), [&](const Map& m) { return m.depth && m.key == key; });
  if (found == maps_.end()) {
    found = std::min_element(maps_.begin(), maps_.end(), [](const Map& a, const Map& b) { return a.used < b.used; });
    if (!found->depth) {
      found->depth = gl::createTexture2D(GL_DEPTH_COMPONENT32F, kShadowMapSide, kShadowMapSide);
      GLuint framebuffer = 0;
      glCreateFramebuffers(1, &framebuffer);
      glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, found->depth.id(), 0);
      glNamedFramebufferDrawBuffer(framebuffer, GL_NONE);
      found->framebuffer = gl::Framebuffer(framebuffer);
    }
    found->key = key;
    drawMap(frame, r, shadow, *found);
  }
  found->used = ++uses_;
  return *found;
}

int ShadowPass::draw(Frame& frame, const FrameTargets::Visibility& visibility) {
  if (!nearest_) {
    nearest_ = borderedSampler(false);
    test_ = borderedSampler(true);
  }
  const int before = drawn_;
  std::vector<std::string> defines;
  if (frame.settings.shadows == Shadows::Contact) defines.push_back("CONTACT");
  for (const ReadyView& r : frame.views) {
    if (r.shadows.empty()) continue;
    const uint64_t casters = castersKey(r);
    for (size_t i = 0; i < r.shadows.size(); ++i) {
      const ShadowView& shadow = r.shadows[i];
      const Map& light = map(frame, r, shadow, casters);
      const gl::Program& program = programs_.shipped(Rectangles::vertexShader(), {"shaders/passes/visibility.frag", defines, {}});
      frame.beginSurfaces(visibility.layers[i + 1].id());
      frame.targets.bindGbuffer();
      frame.uploads.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
      glBindTextureUnit(16, light.depth.id());
      glBindTextureUnit(17, light.depth.id());
      glBindSampler(16, nearest_.id());
      glBindSampler(17, test_.id());
      frame.setScreen(program, r);
      const glm::mat4 worldFromMap(glm::inverse(glm::dmat4(shadow.mapFromWorld)));
      program.setMatrix4("mapFromWorld", &shadow.mapFromWorld[0][0]);
      program.setMatrix4("worldFromMap", &worldFromMap[0][0]);
      program.set4("source", &shadow.source.x);
      program.set4("towards", &shadow.towards.x);
      program.set2("texel", shadow.texel, 1.0f / static_cast<float>(kShadowMapSide));
      program.set("sine", shadow.sine);
      program.set("contactLength", 0.1f * r.casters.radius());
      frame.drawSurfaces(program, r);
    }
  }
  glBindSampler(16, 0);
  glBindSampler(17, 0);
  return drawn_ - before;
}

}  // namespace glint
