#include "renderer/gl/objects.h"

#include <algorithm>
#include <bit>

namespace glint::gl {

void destroyBuffer(GLuint id) { glDeleteBuffers(1, &id); }
void destroyTexture(GLuint id) { glDeleteTextures(1, &id); }
void destroyFramebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
void destroyVertexArray(GLuint id) { glDeleteVertexArrays(1, &id); }
void destroyProgram(GLuint id) { glDeleteProgram(id); }
void destroySampler(GLuint id) { glDeleteSamplers(1, &id); }

Buffer createBuffer(std::span<const std::byte> data, GLbitfield flags) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  // A zero-sized store is an error in GL; an empty buffer is not one here.
  glNamedBufferStorage(id, std::max<GLsizeiptr>(static_cast<GLsizeiptr>(data.size()), 16),
                       nullptr, flags | GL_DYNAMIC_STORAGE_BIT);
  if (!data.empty()) glNamedBufferSubData(id, 0, static_cast<GLsizeiptr>(data.size()), data.data());
  return Buffer(id);
}

Texture createTexture2D(GLenum internalFormat, int width, int height, int levels) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  if (levels == 0) levels = std::bit_width(static_cast<unsigned>(std::max(width, height)));
  glTextureStorage2D(id, levels, internalFormat, width, height);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return Texture(id);
}

Texture createTextureCube(GLenum internalFormat, int size, int levels) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &id);
  glTextureStorage2D(id, levels, internalFormat, size, size);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  return Texture(id);
}

Framebuffer createFramebuffer(std::span<const GLuint> colorTextures, GLuint depthStencilTexture) {
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  std::vector<GLenum> buffers;
  for (size_t i = 0; i < colorTextures.size(); ++i) {
    glNamedFramebufferTexture(id, static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i), colorTextures[i], 0);
    buffers.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i));
  }
  if (depthStencilTexture) glNamedFramebufferTexture(id, GL_DEPTH_STENCIL_ATTACHMENT, depthStencilTexture, 0);
  glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
  // Without textures yet: the caller attaches layers one after the other.
  const GLenum status = colorTextures.empty() ? GL_FRAMEBUFFER_COMPLETE : glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
  GLINT_CHECK(status == GL_FRAMEBUFFER_COMPLETE, "framebuffer status {:#x}", status);
  return Framebuffer(id);
}

VertexArray createVertexArray() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return VertexArray(id);
}

Sampler createSampler(GLenum minFilter, GLenum magFilter, GLenum wrapS, GLenum wrapT) {
  GLuint id = 0;
  glCreateSamplers(1, &id);
  glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minFilter));
  glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magFilter));
  glSamplerParameteri(id, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrapS));
  glSamplerParameteri(id, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrapT));
  return Sampler(id);
}

GLint Program::location(const char* name) const {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  return locations_[name] = glGetUniformLocation(id(), name);
}
void Program::set(const char* name, float x) const { glProgramUniform1f(id(), location(name), x); }
void Program::set(const char* name, int x) const { glProgramUniform1i(id(), location(name), x); }
void Program::set2(const char* name, float x, float y) const { glProgramUniform2f(id(), location(name), x, y); }
void Program::set3(const char* name, const float* v) const { glProgramUniform3fv(id(), location(name), 1, v); }
void Program::set4(const char* name, const float* v, int count) const {
  glProgramUniform4fv(id(), location(name), count, v);
}
void Program::setMatrix4(const char* name, const float* columns) const {
  glProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, columns);
}

struct ProgramBuilder {
  static Program make(GLuint id) {
    Program program;
    program.object_ = Object<destroyProgram>(id);
    return program;
  }
};

Result<Program> buildProgram(const std::string& name, const std::vector<Stage>& stages) {
  std::string log;
  const GLuint program = glCreateProgram();
  std::vector<GLuint> shaders;
  for (const Stage& stage : stages) {
    const GLuint shader = glCreateShader(stage.kind);
    shaders.push_back(shader);
    const char* text = stage.source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
      std::string part(16384, '\0');
      GLsizei length = 0;
      glGetShaderInfoLog(shader, static_cast<GLsizei>(part.size()), &length, part.data());
      log += part.substr(0, static_cast<size_t>(length));
    } else {
      glAttachShader(program, shader);
    }
  }
  if (log.empty()) {
    glLinkProgram(program);
    GLint ok = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok) {
      std::string part(16384, '\0');
      GLsizei length = 0;
      glGetProgramInfoLog(program, static_cast<GLsizei>(part.size()), &length, part.data());
      log = length ? part.substr(0, static_cast<size_t>(length)) : "link failed";
    }
  }
  for (GLuint shader : shaders) glDeleteShader(shader);
  if (!log.empty()) {
    glDeleteProgram(program);
    return error(name, log);
  }
  return ProgramBuilder::make(program);
}

}  // namespace glint::gl
