// How much a driver's compiler has to take in for a GLSL function: drivers put every call in its place before they
// leave anything out, so their time and memory go with this count and not with the length of the text.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "materials/glsl_scan.h"

namespace glint {

// Operators, calls of built-in functions and constructors in `function`, with those of each function of `text` that it
// calls at every call; at least 1. A function that is not in `text` counts 1. A loop counts once: its length is not known
// from the text. Never more than 10^9, whatever the text.
int64_t glslOperations(std::string_view text, std::string_view function);

// A fault at the first function of `text` that grows beyond what a compiler survives: functions that each call the one
// before twice double with every one of them. The text must be free of recursion.
std::vector<GlslFault> growthFaults(std::string_view text);

}  // namespace glint
