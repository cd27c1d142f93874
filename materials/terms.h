// The library of terms (shaders/terms/): found by reading those files, so a new term is one GLSL function
// `float D_Name(Shading s)`, `float V_Name(Shading s)`, `vec3 F_Name(Shading s)` or `vec3 Fd_Name(Shading s)`.
// It may take floats of its own after that, each told in the comment above it:
//   //   gamma from 0.5 to 6, 1.5: how long the tail is
// A model that names such a term has them as parameters. A V that takes `ProjectedAreas` after the Shading is made for
// the model's own D: it has values with a D only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

enum class TermKind { D, V, F, Diffuse };
std::string_view name(TermKind);    // as a head's "terms" has it: "D", "V", "F", "diffuse"
std::string_view prefix(TermKind);  // of the GLSL function: "D_", "V_", "F_", "Fd_"

struct TermParameter {
  std::string name, doc;
  float minimum = 0, maximum = 1, standard = 0;
};

struct Term {
  TermKind kind;
  std::string name;      // without the prefix: "SmithGGXCorrelated"
  std::string doc;       // the comment above the function, without its parameters' lines
  std::vector<TermParameter> parameters;
  bool ofOwnD = false;   // takes the ProjectedAreas of the model's D
  std::string function() const { return std::string(prefix(kind)) + name; }
};

// Every term, in the order of kinds and then of the files. Read from the shipped files at each call.
std::vector<Term> terms();
std::vector<std::string> termNames(TermKind);
std::optional<Term> findTerm(TermKind, std::string_view name);

// The GLSL of all terms, for a program that has shaders/common/shading.glsl before it.
std::string termsGlsl();

}  // namespace glint
