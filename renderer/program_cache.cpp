#include "renderer/program_cache.h"

#include "materials/base/hash.h"

namespace glint {

namespace {

uint64_t requestHash(const ShaderText& text, uint64_t seed) {
  uint64_t h = hashText(text.path, seed);
  for (const std::string& define : text.defines) h = hashText(define, h + 1);
  for (const auto& [name, insert] : text.inserts) h = hashText(insert, hashText(name, h));
  return h;
}

}  // namespace

Result<const gl::Program*> ProgramCache::get(const ShaderText& vertex, const ShaderText& fragment) {
  const uint64_t key = requestHash(fragment, requestHash(vertex, 0));
  const Result<gl::Program>* found = programs_.find(key);
  if (!found) {
    found = &programs_.put(key, gl::buildProgram(fragment.path, {{GL_VERTEX_SHADER, assembleShader(vertex)},
                                                                 {GL_FRAGMENT_SHADER, assembleShader(fragment)}}));
    ++built_;
  }
  if (!*found) return found->diagnostics();
  return &**found;
}

const gl::Program& ProgramCache::shipped(const ShaderText& vertex, const ShaderText& fragment) {
  const auto program = get(vertex, fragment);
  GLINT_CHECK(program.ok(), "{}", program.ok() ? "" : program.diagnostics()[0].text());
  return **program;
}

}  // namespace glint
