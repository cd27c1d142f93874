// The shaderball: a thick shell with a round opening that shows a core inside, a recessed ring around it, on a
// flared foot. Made of three bodies of revolution.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/mesh.h"

namespace glint {
namespace {

constexpr float degrees(float d) { return d * glm::pi<float>() / 180; }

// A curve in the half plane (distance from the axis, height along it). It travels with its outside on the left:
// down the outside of a ball. Arcs that turn clockwise are convex, those that turn counter-clockwise concave.
class Profile {
 public:
  struct Point {
    glm::vec2 place, normal;
    float length;  // along the curve so far, metres
  };

  void arc(const glm::vec2& center, float radius, float from, float to, int steps) {
    const float sign = to > from ? 1.0f : -1.0f;
    for (int i = 0; i <= steps; ++i) {
      const float a = from + (to - from) * float(i) / float(steps);
      const glm::vec2 spoke{std::cos(a), std::sin(a)};
      add(center + radius * spoke, -sign * spoke);
    }
  }
  void line(const glm::vec2& from, const glm::vec2& to) {
    const glm::vec2 along = glm::normalize(to - from);
    add(from, {-along.y, along.x});
    add(to, {-along.y, along.x});
  }
  const std::vector<Point>& points() const { return points_; }

 private:
  void add(const glm::vec2& place, const glm::vec2& normal) {
    const float length = points_.empty() ? 0 : points_.back().length + glm::length(place - points_.back().place);
    // Where two smooth pieces meet, one point serves both.
    if (!points_.empty() && length - points_.back().length < 1e-5f && glm::dot(normal, points_.back().normal) > 0.999f)
      return;
    points_.push_back({{std::max(place.x, 0.0f), place.y}, normal, length});
  }
  std::vector<Point> points_;
};

// Turns the profile about an axis through `center`. One unit of uv is `texture` metres both along the curve and,
// at its widest, around.
void addRevolution(Mesh& mesh, const Profile& profile, const glm::vec3& center, const glm::vec3& axis, int segments,
                   float texture) {
  const glm::vec3 side = glm::normalize(glm::cross(axis, glm::vec3(0, 0, 1)));
  const glm::vec3 back = glm::cross(side, axis);
  const auto& points = profile.points();
  float widest = 0;
  for (const auto& p : points) widest = std::max(widest, p.place.x);
  // Whole repeats, so that the seam does not show.
  const float repeats = std::max(1.0f, std::round(glm::two_pi<float>() * widest / texture));
  constexpr float kOnAxis = 1e-5f;

  std::vector<uint32_t> firsts;
  for (const auto& p : points) {
    firsts.push_back(uint32_t(mesh.vertices.size()));
    const bool pole = p.place.x < kOnAxis;
    for (int i = 0; i < segments + (pole ? 0 : 1); ++i) {
      const float u = (float(i) + (pole ? 0.5f : 0.0f)) / float(segments);
      const float around = glm::two_pi<float>() * u;
      const glm::vec3 out = -side * std::sin(around) - back * std::cos(around);
      Vertex v;
      v.position = center + axis * p.place.y + out * p.place.x;
      v.normal = glm::normalize(axis * p.normal.y + out * p.normal.x);
      v.tangent = glm::vec4(back * std::sin(around) - side * std::cos(around), 1);
      v.uv0 = {u * repeats, p.length / texture};
      v.uv1 = {u, p.length / points.back().length};
      mesh.vertices.push_back(v);
    }
  }
  for (size_t k = 0; k + 1 < points.size(); ++k) {
    if (glm::length(points[k].place - points[k + 1].place) < kOnAxis) continue;  // a crease: two normals, no area
    const bool top = points[k].place.x < kOnAxis, bottom = points[k + 1].place.x < kOnAxis;
    for (uint32_t i = 0; i < uint32_t(segments); ++i) {
      const uint32_t a = firsts[k] + i, b = firsts[k + 1] + i;
      if (!bottom) mesh.indices.insert(mesh.indices.end(), {a, b, b + 1});
      if (!top) mesh.indices.insert(mesh.indices.end(), bottom ? std::initializer_list<uint32_t>{a, b, a + 1}
                                                               : std::initializer_list<uint32_t>{a, b + 1, a + 1});
    }
  }
}

glm::vec2 polar(float radius, float angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

// The shell about its opening (up, in the profile's plane). Its edges are rounded: circles of radius `round` that
// touch a sphere and a cone through the centre.
Profile shell(float outer, float inner, float opening) {
  const float round = 0.03f * outer;
  const float cone = degrees(90) - opening;  // angle of the opening's wall from the horizontal
  Profile p;
  // Inside, from its depth to the wall of the opening, and out over the rim.
  const float innerTurn = cone - std::asin(round / (inner + round));
  const float outerTurn = cone - std::asin(round / (outer - round));
  p.arc({0, 0}, inner, degrees(-90), innerTurn, 24);
  p.arc(polar(inner + round, innerTurn), round, innerTurn + degrees(180), cone + degrees(90), 5);
  p.line(polar(std::sqrt((inner + round) * (inner + round) - round * round), cone),
         polar(std::sqrt((outer - round) * (outer - round) - round * round), cone));
  p.arc(polar(outer - round, outerTurn), round, cone + degrees(90), outerTurn, 5);

  // The outside, down to the recessed ring, through it, and on to the bottom.
  const float above = degrees(-4), below = degrees(-15), floor = 0.9f * outer;
  const float edge = 0.018f * outer, corner = 0.03f * outer;
  const float edgeTurn = std::asin(edge / (outer - edge)), cornerTurn = std::asin(corner / (floor + corner));
  const float edgeReach = std::sqrt((outer - edge) * (outer - edge) - edge * edge);
  const float cornerReach = std::sqrt((floor + corner) * (floor + corner) - corner * corner);
  p.arc({0, 0}, outer, outerTurn, above + edgeTurn, 18);
  p.arc(polar(outer - edge, above + edgeTurn), edge, above + edgeTurn, above - degrees(90), 4);
  p.line(polar(edgeReach, above), polar(cornerReach, above));
  p.arc(polar(floor + corner, above - cornerTurn), corner, above + degrees(90), above - cornerTurn + degrees(180), 4);
  p.arc({0, 0}, floor, above - cornerTurn, below + cornerTurn, 3);
  p.arc(polar(floor + corner, below + cornerTurn), corner, below + cornerTurn + degrees(180), below + degrees(270), 4);
  p.line(polar(cornerReach, below), polar(edgeReach, below));
  p.arc(polar(outer - edge, below - edgeTurn), edge, below + degrees(90), below - edgeTurn, 4);
  p.arc({0, 0}, outer, below - edgeTurn, degrees(-90), 26);
  return p;
}

// From inside the shell down to the floor at -1.
Profile foot() {
  Profile p;
  p.line({0.30f, -0.50f}, {0.30f, -0.64f});
  p.arc({0.56f, -0.64f}, 0.26f, degrees(180), degrees(270), 10);
  p.line({0.56f, -0.90f}, {0.64f, -0.90f});
  p.arc({0.64f, -0.93f}, 0.03f, degrees(90), degrees(0), 4);
  p.line({0.67f, -0.93f}, {0.67f, -0.98f});
  p.arc({0.65f, -0.98f}, 0.02f, degrees(0), degrees(-90), 4);
  p.line({0.65f, -1.0f}, {0, -1.0f});
  return p;
}

void addBall(Mesh& mesh, const glm::vec3& center, float radius, float texture) {
  Profile p;
  p.arc({0, 0}, radius, degrees(90), degrees(-90), 28);
  addRevolution(mesh, p, center, {0, 1, 0}, 56, texture);
}

}  // namespace

MeshPtr shaderballMesh() {
  auto mesh = std::make_shared<Mesh>();
  mesh->name = "shaderball";
  constexpr float kOuter = 0.84f, kTexture = 1.3f;
  const glm::vec3 center{0, 1 - kOuter, 0};
  // The opening looks up and towards the viewer, a little to the left of the usual three-quarter view.
  const glm::vec3 axis = glm::normalize(glm::vec3(-0.18f, 0.62f, 0.76f));
  addRevolution(*mesh, shell(kOuter, 0.66f * kOuter, degrees(40)), center, axis, 88, kTexture);
  addBall(*mesh, center, 0.52f * kOuter, kTexture);
  addRevolution(*mesh, foot(), {0, 0, 0}, {0, 1, 0}, 72, kTexture);
  return mesh;
}

}  // namespace glint
