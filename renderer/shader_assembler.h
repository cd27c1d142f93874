// Shader texts from shipped files: `#include "shaders/..."` is expanded once each, `#pragma glint NAME` is replaced
// by a text the caller gives, defines follow #version, and #line keeps the driver's errors readable.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace glint {

struct ShaderText {
  std::string path;                             // "shaders/passes/lighting.frag"
  std::vector<std::string> defines;             // "ENVIRONMENT" or "TONEMAP 2"
  std::map<std::string, std::string> inserts;   // by the pragma's name
};

// The whole text. A shipped file that is missing breaks a contract: it is part of the program.
std::string assembleShader(const ShaderText&);

}  // namespace glint
