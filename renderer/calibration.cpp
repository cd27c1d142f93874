#include "renderer/calibration.h"

namespace glint {
namespace {

constexpr int kWidth = 1280, kHeight = 720, kTriangles = 50'000;

constexpr const char* kScreen = R"(#version 450 core
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.5, 1.0); })";

constexpr const char* kArithmetic = R"(#version 450 core
out vec4 color;
void main() {
  vec4 x = fract(gl_FragCoord.xyxy * vec4(0.37, 0.41, 0.43, 0.47));
  for (int i = 0; i < 64; ++i) x = x * (3.9 - 3.9 * x);
  color = x;
})";

constexpr const char* kFill = R"(#version 450 core
out vec4 color;
void main() { color = vec4(0.25, 0.5, 0.75, 0.1); })";

// A grid of triangles of about nine pixels, in a fixed order of depths.
constexpr const char* kTriangleVertex = R"(#version 450 core
flat out vec3 tint;
void main() {
  int triangle = gl_VertexID / 3, corner = gl_VertexID % 3;
  vec2 cell = vec2(triangle % 250, triangle / 250);
  vec2 at = (cell + vec2(corner & 1, corner >> 1)) / vec2(250.0, 200.0);
  float depth = fract(float(triangle) * 0.618034);
  tint = vec3(cell / 250.0, depth);
  gl_Position = vec4(at * 2.0 - 1.0, depth, 1.0);
})";
constexpr const char* kTriangleFragment = R"(#version 450 core
flat in vec3 tint;
out vec4 color;
void main() { color = vec4(tint, 1.0); })";

gl::Program program(const char* name, const char* vertex, const char* fragment) {
  auto built = gl::buildProgram(name, {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}});
  GLINT_CHECK(built.ok(), "{}", built.diagnostics()[0].what);
  return std::move(*built);
}

}  // namespace

Calibration::Calibration()
    : arithmetic_(program("arithmetic", kScreen, kArithmetic)),
      fill_(program("fill", kScreen, kFill)),
      triangles_(program("triangles", kTriangleVertex, kTriangleFragment)),
      color_(gl::createTexture2D(GL_RGBA8, kWidth, kHeight)),
      depth_(gl::createTexture2D(GL_DEPTH24_STENCIL8, kWidth, kHeight)),
      empty_(gl::createVertexArray()) {
  const GLuint colors[] = {color_.id()};
  target_ = gl::createFramebuffer(colors, depth_.id());
}

void Calibration::arithmetic() {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, kWidth, kHeight);
  glBindVertexArray(empty_.id());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  arithmetic_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glFinish();
}

void Calibration::fill() {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, kWidth, kHeight);
  glBindVertexArray(empty_.id());
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  fill_.use();
  for (int i = 0; i < 16; ++i) glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  glFinish();
}

void Calibration::triangles() {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  glViewport(0, 0, kWidth, kHeight);
  glBindVertexArray(empty_.id());
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glClear(GL_DEPTH_BUFFER_BIT);
  triangles_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3 * kTriangles);
  glDisable(GL_DEPTH_TEST);
  glFinish();
}

}  // namespace glint
