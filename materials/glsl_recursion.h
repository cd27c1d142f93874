// Functions that come back to themselves, which GLSL forbids and drivers report without a line, if at all.
#pragma once

#include "materials/glsl_scan.h"

namespace glint {

// One fault for each circle of calls, at the call that closes it. Calls are told apart by name and number of
// arguments; where several overloads remain, only a compiler knows which is meant, and nothing is said.
std::vector<GlslFault> recursionFaults(const GlslScan&);

}  // namespace glint
