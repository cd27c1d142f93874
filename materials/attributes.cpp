#include "materials/attributes.h"

namespace glint {
namespace {

const Attribute kAttributes[] = {
    {"baseColor", "Base color", Value::color(0.8f, 0.8f, 0.8f), 0, 1,
     "Colour of the diffuse part of a nonmetal, and of a metal's reflection"},
    {"metallic", "Metallic", Value::scalar(0), 0, 1, "0 for nonmetals, 1 for metals"},
    {"specular", "Specular", Value::scalar(0.5f), 0, 1,
     "Reflectance of a nonmetal at normal incidence: F0 = 0.08 specular"},
    {"roughness", "Roughness", Value::scalar(0.5f), 0, 1, "0 is a mirror, 1 is fully rough; alpha is its square"},
    {"cavity", "Cavity", Value::scalar(1), 0, 1, "Small-scale shadowing; darkens specular and diffuse"},
    {"ambientOcclusion", "Ambient occlusion", Value::scalar(1), 0, 1, "Darkens indirect light only"},
    {"normal", "Normal", Value{ValueType::Vec3, {0, 0, 1, 0}}, -1, 1, "Tangent space, +Y up"},
    {"emissive", "Emissive", Value::color(0, 0, 0), 0, 10, "Light that the surface sends out, in nits", 65000},
    {"opacityMask", "Opacity mask", Value::scalar(1), 0, 1, "Below 0.5 the surface has a hole"},
};

}  // namespace

std::span<const Attribute> attributes() { return kAttributes; }

const Attribute* findAttribute(std::string_view name) {
  for (const Attribute& attribute : kAttributes)
    if (attribute.name == name) return &attribute;
  return nullptr;
}

std::vector<std::string> attributeNames() {
  std::vector<std::string> names;
  for (const Attribute& attribute : kAttributes) names.emplace_back(attribute.name);
  return names;
}

}  // namespace glint
