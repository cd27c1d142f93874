// The attributes of every material (product.md 2): one table, from which the GLSL struct, the pins, the
// command line and the editor's widgets are made.
#pragma once

#include <span>
#include <string_view>
#include <vector>
#include <string>

#include "materials/value.h"

namespace glint {

struct Attribute {
  std::string_view name;   // "baseColor": JSON key, pin, GLSL field and command-line word
  std::string_view title;  // "Base color"
  Value standard;          // the default
  float minimum, maximum;  // per component, of sliders
  std::string_view doc;
  float most = maximum;    // what it can be; `minimum` is also the least
};

// In their fixed order: baseColor, metallic, specular, roughness, cavity, ambientOcclusion, normal,
// emissive, opacityMask.
std::span<const Attribute> attributes();
const Attribute* findAttribute(std::string_view name);
std::vector<std::string> attributeNames();

}  // namespace glint
