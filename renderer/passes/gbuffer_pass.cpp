#include "renderer/passes/gbuffer_pass.h"

#include <algorithm>

namespace glint {
namespace {

std::vector<std::string> definesOf(const CompiledMaterial& material, const Frame& frame) {
  const OptionalAttachments& optional = frame.optional;
  std::vector<std::string> defines;
  if (frame.widensLobes()) defines.push_back("SPECULAR_ANTIALIASING");
  if (optional.emissive) defines.push_back("WRITES_EMISSIVE");
  if (optional.parameters) defines.push_back("WRITES_PARAMETERS");
  if (optional.tangent) defines.push_back("WRITES_TANGENT");
  if (material.writesNormal) defines.push_back("WRITES_NORMAL");
  if (material.writesOpacityMask) defines.push_back("WRITES_OPACITY_MASK");
  return defines;
}

}  // namespace

const gl::Program* GbufferPass::program(Frame& frame, const CompiledMaterial& material) {
  const auto program = programs_.get({"shaders/passes/gbuffer.vert", {}, {}},
                                     {"shaders/passes/gbuffer.frag", definesOf(material, frame), {{"material", material.glsl}}});
  if (!program) {
    // The graph compiler's fault, not the user's: say so, and draw the rest.
    frame.problems.push_back(error(material.name.empty() ? "material" : material.name, "its generated shader does not compile: " + program.diagnostics()[0].what,
                                   "please report it with the material's file"));
    return nullptr;
  }
  return *program;
}

void GbufferPass::bindMaterial(const Frame& frame, const ReadyView& r, const gl::Program& program, size_t index, int group) {
  const SurfaceMaterial& material = r.view.scene->materials[index];
  program.use();
  program.set("opacityCutoff", material.opacityCutoff);
  program.set4("standardParameters", r.groups[static_cast<size_t>(group)].setting.slots.data());
  if (material.compiled->blockSize > 0)
    frame.uploads.bind(GL_UNIFORM_BUFFER, kMaterialParametersBinding, r.materialBlocks[index], material.block.size());
  const float share = 1.0f / static_cast<float>(std::max(1, frame.settings.samples));
  program.set("pixelShare", share);
  glm::vec4 chosen(0);
  if (const int slot = material.model->coatRoughnessSlot(); slot >= 0) chosen[slot] = 1;
  program.set4("coatRoughnessSlot", &chosen.x);
  const auto& slots = material.compiled->textures;
  for (size_t i = 0; i < slots.size(); ++i)
    textures_.bind(static_cast<GLuint>(kFirstMaterialTexture + static_cast<int>(i)), i < material.textures.size() ? material.textures[i] : nullptr, slots[i], frame.widensLobes() ? share : 0.0f);
}

void GbufferPass::draw(Frame& frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame.targets.gbuffer());
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
  glClearNamedFramebufferfi(frame.targets.gbuffer(), GL_DEPTH_STENCIL, 0, depth, 0);
  for (const ReadyView& r : frame.views) {
    const glm::ivec4 rect = r.view.rectangle;
    glViewport(rect.x, rect.y, rect.z, rect.w);
    frame.uploads.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
    // By material, so that programs and textures change little.
    std::vector<const PreparedInstance*> order;
    for (const PreparedInstance& instance : r.view.instances) order.push_back(&instance);
    std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->material < b->material; });
    int bound = -1;
    const gl::Program* drawn = nullptr;
    for (const PreparedInstance* instance : order) {
      const size_t m = static_cast<size_t>(instance->material);
      const SurfaceMaterial& material = r.view.scene->materials[m];
      const int group = r.groupOfMaterial[m];
      if (group < 0) continue;
      if (bound != instance->material) {
        bound = instance->material;
        drawn = program(frame, *material.compiled);
        if (drawn) {
          bindMaterial(frame, r, *drawn, m, group);
          drawn->set("lightGroup", static_cast<float>(group) / 255.0f);
          glStencilFunc(GL_ALWAYS, group + 1, 0xff);
        }
      }
      if (!drawn) continue;
      drawn->setMatrix4("worldFromModel", &instance->worldFromModel[0][0]);
      drawn->setMatrix4("normalFromModel", &instance->normalFromModel[0][0]);
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

}  // namespace glint
