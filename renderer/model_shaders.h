// The models that a renderer draws with: the GLSL of each, what the compiler says of it, and the last version that was
// sound, which is drawn while a newer one is not.
#pragma once

#include <map>
#include <memory>

#include "renderer/model_setting.h"
#include "renderer/program_cache.h"
#include "renderer/rectangles.h"

namespace glint {

class ModelShaders {
 public:
  ModelShaders(ProgramCache&, const Rectangles&);

  std::shared_ptr<const ModelShader> of(const std::shared_ptr<const ShadingModel>&);
  // What a compiler says of a model, drawn or not, and whether it takes too long; remembered. Errors are at the plugin's
  // own lines. Lives until reload().
  const Diagnostics& verdict(const ModelShader&);
  // The shader to draw a model with: its own when it is sound, else its last good version, else none. Adds to
  // `problems` what is wrong.
  std::shared_ptr<const ModelShader> sound(const std::shared_ptr<const ShadingModel>&, Diagnostics& problems);

  // After plugins changed: lets go of those that nobody holds any more, and looks again at those with faults. Programs
  // stay, as they are kept by their text; all are dropped only when a shipped shader on disk is not what it was.
  void reload();

 private:
  Diagnostics slowness(const ShadingModel&, const gl::Program& lobe);

  ProgramCache& programs_;
  const Rectangles& rectangles_;
  uint64_t shippedHash_;                       // when programs were last known to be made from them
  std::map<const ShadingModel*, std::shared_ptr<const ModelShader>> shaders_;
  std::map<uint64_t, Diagnostics> verdicts_;   // by the hash of a model's GLSL
  std::map<std::string, std::shared_ptr<const ModelShader>> lastGood_;
};

}  // namespace glint
