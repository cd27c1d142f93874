// Contracts: GLINT_CHECK(expression, "what", values...) stops the program with the expression, the
// place and the values when the expression is false. For the programmer's mistakes only; bad input is
// a Diagnostic (diagnostic.h).
#pragma once

#include <fmt/format.h>

#include <string>

namespace glint {

[[noreturn]] void contractBroken(const char* expression, const char* file, int line,
                                 const std::string& values);

}  // namespace glint

// The values are given as a fmt format string and its arguments: GLINT_CHECK(i < n, "i {} n {}", i, n).
#define GLINT_CHECK(expression, ...)                                                           \
  do {                                                                                         \
    if (!(expression))                                                                         \
      ::glint::contractBroken(#expression, __FILE__, __LINE__, ::fmt::format("" __VA_ARGS__)); \
  } while (false)
