// A reading of GLSL that is just deep enough to find what a file defines at its top level, and what in it
// would do harm to the text or the compiler around it. Not a parser: what it lets through may still fail to
// compile.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct GlslCall {
  std::string name;
  size_t arguments = 0;
  int line = 0;
};

struct GlslFunction {
  std::string returnType, name;
  std::vector<std::string> parameterTypes, parameterNames;
  int line = 0;
  std::vector<GlslCall> calls;  // in its body: of functions, constructors and macros
  std::vector<std::string> members;  // in its body: the names after a dot, each once
  int operators = 0;            // in its body: arithmetic, comparisons and assignments, `+=` as one
  std::string comment;   // of `//` lines directly above, without the slashes
  bool takes(const std::vector<std::string>& types) const { return parameterTypes == types; }
};

struct GlslName {
  std::string name;
  int line = 0;
};

// A fault that the compiler would report in somebody else's text, or not survive.
struct GlslFault {
  int line = 0;
  std::string what, hint;
};

struct GlslScan {
  std::vector<GlslFunction> functions;  // definitions, not prototypes
  std::vector<GlslName> names;          // functions, prototypes, structs and the first variable of a statement
  std::vector<std::string> macros;      // defined by the text
  std::vector<GlslFault> faults;
};

// Comments, strings of `#` lines and whatever lies between `#if 0` and its end are not seen.
GlslScan scanGlsl(std::string_view text);

}  // namespace glint
