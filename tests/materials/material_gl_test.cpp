// The generated GLSL on a GL device: every node for every type and every library material links; what C++ folds is
// what the GLSL computes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "materials/glsl_program.h"
#include "materials/graph_compile.h"
#include "materials/material_library.h"
#include "renderer/gl/context.h"
#include "renderer/gl/objects.h"
#include "shaders/shipped_files.h"
#include "tests/materials/support/graphs.h"

namespace glint {
namespace {

const char* const kVertex = R"(#version 450 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";

class MaterialGl : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::Context::create({});
    ASSERT_TRUE(made) << made.diagnostics()[0].text();
    context_ = std::move(*made);
  }
  static void TearDownTestSuite() {
    EXPECT_EQ(gl::errorCount(), 0);
    context_.reset();
  }

  // A fragment shader that shows all that the material writes.
  static Result<gl::Program> build(const std::string& name, const std::string& material) {
    std::string text = "#version 450 core\n" + shipped::read("shaders/common/material.glsl").value();
    text += material;
    text += R"(
layout(location = 0) out vec4 color;
void main() {
  MaterialInputs i;
  i.uv0 = i.uv1 = gl_FragCoord.xy;
  i.vertexColor = vec4(1.0);
  i.position = i.localPosition = gl_FragCoord.xyz;
  i.normal = vec3(0.0, 0.0, 1.0);
  i.tangent = vec3(1.0, 0.0, 0.0);
  i.bitangent = vec3(0.0, 1.0, 0.0);
  i.view = vec3(0.0, 0.0, 1.0);
  MaterialAttributes m;
  m.model = vec4(0.0);
  evaluateMaterial(i, m);
  color = vec4(m.baseColor + m.normal + m.emissive, m.metallic + m.specular + m.roughness + m.cavity +
               m.ambientOcclusion + m.opacityMask) + m.model;
}
)";
    return gl::buildProgram(name, {{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, text}});
  }

  static inline std::unique_ptr<gl::Context> context_;
};

TEST_F(MaterialGl, EveryNodeLinksForEveryType) {
  for (const NodeKind* kind : test::nodes().all()) {
    if (kind->builtin != Builtin::None) continue;
    const bool numeric = std::any_of(kind->inputs.begin(), kind->inputs.end(), [](const Pin& pin) {
      return pin.type.kind == PinType::Kind::Numeric;
    });
    for (const ValueType type : {ValueType::Float, ValueType::Vec2, ValueType::Vec3, ValueType::Vec4}) {
      if (!numeric && type != ValueType::Float) break;
      const auto compiled = test::compile(test::materialOf(*kind, type));
      ASSERT_TRUE(compiled);
      const auto program = build(kind->id, compiled->glsl);
      EXPECT_TRUE(program) << kind->id << " " << name(type) << ": " << test::texts(program.diagnostics());
    }
  }
}

TEST_F(MaterialGl, EveryLibraryMaterialLinks) {
  for (const std::string& name : libraryMaterialNames())
    for (const bool live : {false, true}) {
      const auto compiled = compileMaterial(*loadMaterial(name, test::nodes()), test::ggx(), test::nodes(),
                                            test::functions(), {.valuesAsUniforms = live, .namedFiles = {}});
      ASSERT_TRUE(compiled);
      const auto program = build(name, compiled->glsl);
      EXPECT_TRUE(program) << name << ": " << test::texts(program.diagnostics());
    }
}

// One pixel for each node that C++ folds: the GLSL of its call against foldCall().
TEST_F(MaterialGl, FoldingEqualsTheGlsl) {
  struct Case {
    std::string id;
    float expected;
  };
  std::vector<Case> cases;
  std::string functions, calls;
  const float samples[][3] = {{0.3f, 0.7f, 0.25f}, {-1.25f, 2.5f, 0.5f}, {0, 0, 0}, {2, -3, 1}};
  std::set<std::string> included;
  for (const NodeKind* kind : test::nodes().all()) {
    if (kind->builtin != Builtin::None || !kind->settings.empty() || kind->surface || kind->outputs.size() != 1) continue;
    if (kind->outputs[0].type.kind != PinType::Kind::Numeric) continue;
    bool used = false;
    for (const auto& sample : samples) {
      std::vector<Value> arguments;
      std::string list;
      for (size_t i = 0; i < kind->inputs.size() && i < 3; ++i) {
        arguments.push_back(Value::scalar(sample[i]));
        list += (i ? ", p.x * " : "p.x * ") + glslLiteral(arguments.back());  // kept from the compiler's own folding
      }
      if (arguments.size() != kind->inputs.size()) continue;
      const auto folded = foldCall(*kind, ValueType::Float, arguments);
      if (!folded) continue;
      used = true;
      calls += fmt::format("  if (index == {}) value = {}({});\n", cases.size(), kind->function, list);
      cases.push_back({kind->id, folded->v[0]});
    }
    if (!used) continue;
    for (const std::string& name : kind->includes)
      if (included.insert(name).second) functions += *test::nodes().include(name);
    functions += "#define T float\n" + kind->source + "\n#undef T\n";
  }
  ASSERT_GT(cases.size(), 50u);
  const auto program = gl::buildProgram(
      "fold", {{GL_VERTEX_SHADER, kVertex},
               {GL_FRAGMENT_SHADER, "#version 450 core\n" + functions +
                                        "uniform vec2 p;\nlayout(location = 0) out vec4 color;\nvoid main() {\n"
                                        "  int index = int(gl_FragCoord.x);\n  float value = 0.0;\n" + calls +
                                        "  color = vec4(value);\n}\n"}});
  ASSERT_TRUE(program) << test::texts(program.diagnostics());
  const int width = static_cast<int>(cases.size());
  const gl::Texture target = gl::createTexture2D(GL_RGBA32F, width, 1);
  const GLuint targets[] = {target.id()};
  const gl::Framebuffer framebuffer = gl::createFramebuffer(targets);
  const gl::VertexArray vertices = gl::createVertexArray();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glViewport(0, 0, width, 1);
  program->use();
  program->set2("p", 1, 0);
  glBindVertexArray(vertices.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<float> pixels(static_cast<size_t>(width) * 4);
  glReadPixels(0, 0, width, 1, GL_RGBA, GL_FLOAT, pixels.data());
  for (size_t i = 0; i < cases.size(); ++i)
    EXPECT_NEAR(pixels[i * 4], cases[i].expected, 1e-5f * (1 + std::abs(cases[i].expected))) << cases[i].id << " " << i;
}

}  // namespace
}  // namespace glint
