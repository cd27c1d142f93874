#include "renderer/gl/software.h"

namespace glint::gl {

bool isSoftware(const std::string& renderer) {
  return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
}

}  // namespace glint::gl
