#include "app/editor/imgui_renderer.h"

#include <cstring>

#include "renderer/gl/objects.h"

namespace glint {
namespace {

constexpr const char* kVertex = R"(#version 450 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
uniform vec4 scaleOffset;
out vec2 vUv;
out vec4 vColor;
void main() {
  vUv = uv;
  vColor = color;
  gl_Position = vec4(position * scaleOffset.xy + scaleOffset.zw, 0.0, 1.0);
}
)";

constexpr const char* kFragment = R"(#version 450 core
layout(binding = 0) uniform sampler2D image;
in vec2 vUv;
in vec4 vColor;
layout(location = 0) out vec4 color;
void main() { color = vColor * texture(image, vUv); }
)";

}  // namespace

struct ImGuiRenderer::State {
  gl::Program program;
  gl::VertexArray array;
  gl::Sampler sampler;
  gl::Texture font;
  gl::Buffer vertices, indices;
  size_t vertexBytes = 0, indexBytes = 0;

  // Grows the buffers; a frame's lists go up in one piece each.
  static void fit(gl::Buffer& buffer, size_t& capacity, size_t wanted) {
    if (wanted <= capacity) return;
    capacity = wanted + wanted / 2 + 65536;
    GLuint id = 0;
    glCreateBuffers(1, &id);
    buffer = gl::Buffer(id);
    glNamedBufferStorage(id, static_cast<GLsizeiptr>(capacity), nullptr, GL_DYNAMIC_STORAGE_BIT);
  }
};

ImGuiRenderer::ImGuiRenderer() : state_(std::make_unique<State>()) {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendRendererName = "glint";
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  auto program = gl::buildProgram("editor", {{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, kFragment}});
  state_->program = std::move(*program);
  state_->array = gl::createVertexArray();
  const GLuint array = state_->array.id();
  const auto attribute = [&](GLuint index, GLint count, GLenum type, GLboolean normalised, size_t offset) {
    glEnableVertexArrayAttrib(array, index);
    glVertexArrayAttribFormat(array, index, count, type, normalised, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, index, 0);
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
  state_->sampler = gl::createSampler(GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE);
}

ImGuiRenderer::~ImGuiRenderer() = default;

void ImGuiRenderer::uploadFonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
  state_->font = gl::createTexture2D(GL_R8, width, height, 1);
  glTextureSubImage2D(state_->font.id(), 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, pixels);
  const GLint white[] = {GL_ONE, GL_ONE, GL_ONE, GL_RED};
  glTextureParameteriv(state_->font.id(), GL_TEXTURE_SWIZZLE_RGBA, white);
  atlas.SetTexID(imguiTexture(state_->font.id()));
  atlas.ClearTexData();
}

void ImGuiRenderer::draw(const ImDrawData& data) {
  const ImVec2 scale = data.FramebufferScale;
  const int width = static_cast<int>(data.DisplaySize.x * scale.x);
  const int height = static_cast<int>(data.DisplaySize.y * scale.y);
  if (width <= 0 || height <= 0 || data.TotalVtxCount == 0) return;

  State& s = *state_;
  State::fit(s.vertices, s.vertexBytes, size_t(data.TotalVtxCount) * sizeof(ImDrawVert));
  State::fit(s.indices, s.indexBytes, size_t(data.TotalIdxCount) * sizeof(ImDrawIdx));
  glVertexArrayVertexBuffer(s.array.id(), 0, s.vertices.id(), 0, sizeof(ImDrawVert));
  glVertexArrayElementBuffer(s.array.id(), s.indices.id());
  size_t vertexAt = 0, indexAt = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    const size_t vertexBytes = size_t(list.VtxBuffer.Size) * sizeof(ImDrawVert);
    const size_t indexBytes = size_t(list.IdxBuffer.Size) * sizeof(ImDrawIdx);
    if (vertexBytes == 0 || indexBytes == 0) continue;
    glNamedBufferSubData(s.vertices.id(), static_cast<GLintptr>(vertexAt), static_cast<GLsizeiptr>(vertexBytes),
                         list.VtxBuffer.Data);
    glNamedBufferSubData(s.indices.id(), static_cast<GLintptr>(indexAt), static_cast<GLsizeiptr>(indexBytes),
                         list.IdxBuffer.Data);
    vertexAt += vertexBytes;
    indexAt += indexBytes;
  }

  glViewport(0, 0, width, height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_FRAMEBUFFER_SRGB);  // every colour of the editor is display-referred already
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindSampler(0, s.sampler.id());
  s.program.use();
  const ImVec2 size = data.DisplaySize, origin = data.DisplayPos;
  const float transform[4] = {2 / size.x, -2 / size.y, -1 - 2 * origin.x / size.x, 1 + 2 * origin.y / size.y};
  s.program.set4("scaleOffset", transform);
  glBindVertexArray(s.array.id());

  size_t vertexBase = 0, indexBase = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback) {
        if (command.UserCallback != ImDrawCallback_ResetRenderState) command.UserCallback(&list, &command);
        continue;
      }
      const float x0 = (command.ClipRect.x - origin.x) * scale.x, y0 = (command.ClipRect.y - origin.y) * scale.y;
      const float x1 = (command.ClipRect.z - origin.x) * scale.x, y1 = (command.ClipRect.w - origin.y) * scale.y;
      if (x1 <= x0 || y1 <= y0) continue;
      glScissor(static_cast<int>(x0), static_cast<int>(static_cast<float>(height) - y1), static_cast<int>(x1 - x0),
                static_cast<int>(y1 - y0));
      glBindTextureUnit(0, static_cast<GLuint>((intptr_t)command.GetTexID()));  // NOLINT
      glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                               sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                               reinterpret_cast<const void*>((indexBase + command.IdxOffset) * sizeof(ImDrawIdx)),
                               static_cast<GLint>(vertexBase + command.VtxOffset));
    }
    vertexBase += size_t(list.VtxBuffer.Size);
    indexBase += size_t(list.IdxBuffer.Size);
  }
  glDisable(GL_SCISSOR_TEST);
  glBindSampler(0, 0);
}

}  // namespace glint
