// A light, in the units of product.md: values only.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

enum class LightKind { Directional, Point, Spot, Sphere, Tube, Rectangle };

// Colours are linear Rec.709 factors on the photometric amount. Lengths are in metres, angles in radians.
struct Light {
  LightKind kind = LightKind::Directional;
  glm::vec3 color{1};
  // Directional.
  glm::vec3 direction{0, 1, 0};        // towards the light, unit
  float lux = 3.14159265f;
  float angle = 0.00925025f;           // across, as the shaded surface sees it: how soft its shadow is; the sun's 0.53 degrees
  // All others.
  glm::vec3 position{0};               // of the middle
  // Of a point light; of a spot along its axis; of those with a surface that of a point light of the same power.
  float candela = 1;
  float radius = 10;                   // where the window reaches zero (Karis 2013, eq. 9)
  float constant = 1;                  // m^2, what eq. 9 adds to the squared distance, >= 0
  glm::vec3 axis{0, -1, 0};            // unit; spot and rectangle: the way it shines; tube: along it
  float innerAngle = 0.5f, outerAngle = 0.7f;   // spot: from the axis, to where it is full and where it ends
  float size = 0.1f;                   // sphere and tube: the radius of the source; spot: that of its shadow's source alone
  float length = 1;                    // tube: between the middles of its round ends
  float width = 1, height = 1;         // rectangle
  float roll = 0;                      // rectangle: turned about its axis
  bool shadow = true;                  // whether it casts one where RenderSettings::shadows asks for them

  bool operator==(const Light&) const = default;
};

// Of the emitting surface, m^2; 0 for lights without one.
float surfaceArea(const Light&);
// Lumens for each candela of Light::candela: 4 pi, and of a spot what its cone lets out.
float lumensPerCandela(const Light&);
// Luminance of the surface for each candela, nits; 0 for lights without one (or with one of no area). A rectangle shines to one side.
float nitsPerCandela(const Light&);
// False when a number of it is not finite, or a direction has no length: such a light is not drawn.
bool isSound(const Light&);
// The longest way from `position` to a point of the source, metres.
float extent(const Light&);
// Two unit vectors across the axis: along the width and the height of a rectangle, right-handed with the axis.
void acrossAxis(const Light&, glm::vec3& right, glm::vec3& up);

// What can be set of a kind of light: one list for the command line, project files and the editor.
struct LightProperty {
  enum class Unit { None, Metres, Degrees, Lux, Candela, Color, Position, Direction, Switch };
  const char* key;                     // of project files: "position"
  const char* option;                  // of --light: "pos"
  const char* title;
  const char* doc;
  Unit unit;
  float Light::*number = nullptr;      // one of the three
  glm::vec3 Light::*vector = nullptr;
  float least = 0, most = 1e9f;        // as stored: angles in radians
  bool Light::*flag = nullptr;
};
struct LightKindInfo {
  LightKind kind;
  const char* id;                      // "sphere"
  const char* title;
  const char* example;                 // of --light, after the colon
  std::vector<LightProperty> properties;
};
std::span<const LightKindInfo> lightKinds();
const LightKindInfo& infoOf(LightKind);
const LightKindInfo* findLightKind(std::string_view id);

}  // namespace glint
