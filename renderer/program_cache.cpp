#include "renderer/program_cache.h"

#include "materials/base/hash.h"

namespace glint {

Result<const gl::Program*> ProgramCache::get(const ShaderText& vertex, const ShaderText& fragment) {
  const std::string vertexText = assembleShader(vertex), fragmentText = assembleShader(fragment);
  const uint64_t key = hashText(fragmentText, hashText(vertexText));
  auto found = programs_.find(key);
  if (found == programs_.end())
    found = programs_
                .emplace(key, gl::buildProgram(fragment.path, {{GL_VERTEX_SHADER, vertexText},
                                                               {GL_FRAGMENT_SHADER, fragmentText}}))
                .first;
  if (!found->second) return found->second.diagnostics();
  return &*found->second;
}

const gl::Program& ProgramCache::shipped(const ShaderText& vertex, const ShaderText& fragment) {
  const auto program = get(vertex, fragment);
  GLINT_CHECK(program.ok(), "{}", program.ok() ? "" : program.diagnostics()[0].text());
  return **program;
}

}  // namespace glint
