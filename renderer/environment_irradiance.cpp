#include "renderer/environment_irradiance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/environment.h"
#include "renderer/environment_lighting.h"
#include "renderer/environment_spots.h"
#include "renderer/parallel.h"

namespace glint {
namespace {

using std::numbers::pi;

// Some pixels as one light in the middle of their light: a sun stays where it is.
struct Cell {
  glm::dvec3 direction{0};
  glm::dvec3 light{0};   // radiance times solid angle
};

std::vector<Cell> cellsOf(const ImageF& image) {
  constexpr int kColumns = 128, kRows = 64;
  const int columns = std::min(kColumns, image.width), rows = std::min(kRows, image.height);
  std::vector<Cell> cells(static_cast<size_t>(columns) * static_cast<size_t>(rows));
  std::vector<glm::dvec2> turns;
  for (int x = 0; x < image.width; ++x) {
    const double phi = ((x + 0.5) / image.width - 0.5) * 2 * pi;
    turns.emplace_back(std::cos(phi), std::sin(phi));
  }
  parallelFor(static_cast<size_t>(rows), [&](size_t row) {
    for (int y = 0; y < image.height; ++y) {
      if (static_cast<size_t>(y) * static_cast<size_t>(rows) / static_cast<size_t>(image.height) != row) continue;
      const double theta = (y + 0.5) / image.height * pi, solid = solidAngle(y, image.width, image.height);
      for (int x = 0; x < image.width; ++x) {
        Cell& cell = cells[row * static_cast<size_t>(columns) + static_cast<size_t>(x) * static_cast<size_t>(columns) / static_cast<size_t>(image.width)];
        const float* p = image.at(x, y);
        const glm::dvec3 light = glm::dvec3(p[0], p[1], p[2]) * solid;
        const glm::dvec2 turn = turns[static_cast<size_t>(x)];
        cell.light += light;
        // As environmentDirection().
        cell.direction += glm::dvec3(std::sin(theta) * turn.x, std::cos(theta), std::sin(theta) * turn.y) * (light.r + light.g + light.b);
      }
    }
  }, image.data.size() > 100000);
  std::erase_if(cells, [](const Cell& cell) { return !(glm::dot(cell.direction, cell.direction) > 0); });
  for (Cell& cell : cells) cell.direction = glm::normalize(cell.direction);
  return cells;
}

std::array<double, 9> basis(const glm::dvec3& d) {
  return {1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3 * d.z * d.z - 1, d.x * d.z, d.x * d.x - d.y * d.y};
}

std::array<glm::vec4, 9> harmonicsOf(const std::vector<Cell>& cells) {
  std::array<glm::dvec3, 9> sum{};
  for (const Cell& cell : cells) {
    const std::array<double, 9> at = basis(cell.direction);
    for (size_t i = 0; i < 9; ++i) sum[i] += cell.light * at[i];
  }
  // Y_lm's constant squared, times A_l / pi: A_0 = pi, A_1 = 2 pi / 3, A_2 = pi / 4.
  const double c0 = 1 / (4 * pi), c1 = 3 / (4 * pi) * (2.0 / 3), c2 = 15 / (4 * pi) * 0.25;
  const double scale[9] = {c0, c1, c1, c1, c2, c2, 5 / (16 * pi) * 0.25, c2, 15 / (16 * pi) * 0.25};
  std::array<glm::vec4, 9> result;
  for (size_t i = 0; i < 9; ++i) result[i] = glm::vec4(glm::vec3(sum[i] * scale[i]), 0);
  return result;
}

glm::vec3 shownByWhite(const std::vector<Cell>& cells, const glm::dvec3& normal) {
  glm::dvec3 sum(0);
  for (const Cell& cell : cells) sum += cell.light * std::max(0.0, glm::dot(cell.direction, normal));
  return sum / pi;
}

}  // namespace

DiffuseLight diffuseLight(const ImageF& image) {
  constexpr size_t kSize = DiffuseLight::kMapSize;
  const std::vector<Cell> cells = cellsOf(image);
  DiffuseLight light{harmonicsOf(cells), 0, std::vector<glm::vec4>(6 * kSize * kSize)};
  std::vector<glm::vec3> byHarmonics(light.map.size());
  parallelFor(light.map.size() / kSize, [&](size_t row) {
    for (size_t x = 0; x < kSize; ++x) {
      const size_t texel = row * kSize + x;
      const glm::vec2 place = (glm::vec2(x, row % kSize) + 0.5f) / static_cast<float>(kSize);
      const glm::dvec3 normal = glm::normalize(cubeDirection(static_cast<int>(row / kSize), place));
      light.map[texel] = glm::vec4(shownByWhite(cells, normal), 1);
      const std::array<double, 9> at = basis(normal);
      glm::dvec3 sum(0);
      for (size_t i = 0; i < 9; ++i) sum += glm::dvec3(light.harmonics[i]) * at[i];
      byHarmonics[texel] = glm::max(sum, 0.0);
    }
  });
  double difference = 0, whole = 0;
  for (size_t i = 0; i < light.map.size(); ++i) {
    const glm::dvec3 exact = light.map[i], off = glm::dvec3(byHarmonics[i]) - exact;
    difference += glm::dot(off, off);
    whole += glm::dot(exact, exact);
  }
  light.harmonicsError = whole > 0 ? std::sqrt(difference / whole) : 0;
  return light;
}

}  // namespace glint
