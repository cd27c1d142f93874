#include "materials/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace glint {

void contractBroken(const char* expression, const char* file, int line, const std::string& values) {
  std::fprintf(stderr, "glint: contract broken: %s at %s:%d%s%s\n", expression, file, line,
               values.empty() ? "" : ": ", values.c_str());
  std::fflush(stderr);
  std::abort();
}

}  // namespace glint
