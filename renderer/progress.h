// How far long work is: what it does, and the fraction that is done.
#pragma once

#include <functional>
#include <string>

namespace glint {

using Progress = std::function<void(const std::string& what, double fraction)>;

}  // namespace glint
