// Owning, move-only OpenGL objects, made with direct state access. Creating one needs a current context;
// so does destroying it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "materials/base/diagnostic.h"
#include "renderer/gl/gl.h"

namespace glint::gl {

template <void (*destroy)(GLuint)>
class Object {
 public:
  Object() = default;
  explicit Object(GLuint id) : id_(id) {}
  Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Object() {
    if (id_) destroy(id_);
  }
  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

void destroyBuffer(GLuint);
void destroyTexture(GLuint);
void destroyFramebuffer(GLuint);
void destroyVertexArray(GLuint);
void destroyProgram(GLuint);
void destroySampler(GLuint);
using Buffer = Object<destroyBuffer>;
using Texture = Object<destroyTexture>;
using Framebuffer = Object<destroyFramebuffer>;
using VertexArray = Object<destroyVertexArray>;
using Sampler = Object<destroySampler>;

Buffer createBuffer(std::span<const std::byte> data, GLbitfield flags = 0);
// Empty immutable storage; levels 0 means a full chain.
Texture createTexture2D(GLenum internalFormat, int width, int height, int levels = 1);
Texture createTextureCube(GLenum internalFormat, int size, int levels);
Framebuffer createFramebuffer(std::span<const GLuint> colorTextures, GLuint depthStencilTexture = 0);
VertexArray createVertexArray();
Sampler createSampler(GLenum minFilter, GLenum magFilter, GLenum wrapS, GLenum wrapT);

// Linked shaders. Uniform locations are looked up by name once.
class Program {
 public:
  Program() = default;
  GLuint id() const { return object_.id(); }
  explicit operator bool() const { return static_cast<bool>(object_); }
  void use() const { glUseProgram(id()); }
  // -1 when the program does not use it; the setters then do nothing.
  GLint location(const char* name) const;
  void set(const char* name, float) const;
  void set(const char* name, int) const;
  void set2(const char* name, float, float) const;
  void set3(const char* name, const float* xyz) const;
  void set4(const char* name, const float* xyzw, int count = 1) const;
  void setMatrix4(const char* name, const float* columns) const;

 private:
  friend struct ProgramBuilder;
  Object<destroyProgram> object_;
  mutable std::unordered_map<std::string, GLint> locations_;
};

struct Stage {
  GLenum kind;             // GL_VERTEX_SHADER, ...
  std::string source;      // whole text, with #version
};
// The driver's log on failure, all stages' together, as the one diagnostic's `what`; `name` is its place.
Result<Program> buildProgram(const std::string& name, const std::vector<Stage>& stages);

}  // namespace glint::gl
