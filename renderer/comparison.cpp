#include "renderer/comparison.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "renderer/mesh.h"

namespace glint {
namespace {

std::optional<float> number(std::string_view text) {
  float value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

float Sweep::value(int index) const {
  return count < 2 ? from : from + (to - from) * float(index) / float(count - 1);
}

std::string Sweep::title(int index) const { return fmt::format("{:.3g}", value(index)); }

Result<Sweep> parseSweep(const std::string& text, const std::string& place) {
  const auto malformed = [&] {
    return error(place, fmt::format("'{}' is not a sweep", text), "write NAME=FROM..TO:COUNT, for example roughness=0..1:5");
  };
  const size_t equals = text.find('='), colon = text.rfind(':');
  if (equals == std::string::npos || equals == 0 || colon == std::string::npos || colon < equals) return malformed();
  const std::string_view range = std::string_view(text).substr(equals + 1, colon - equals - 1);
  const size_t dots = range.find("..");
  if (dots == std::string_view::npos) return malformed();
  const auto from = number(range.substr(0, dots)), to = number(range.substr(dots + 2));
  const auto count = number(std::string_view(text).substr(colon + 1));
  if (!from || !to || !count || *count != std::floor(*count)) return malformed();
  if (*count < 1 || *count > kMostSweepValues)
    return error(place, fmt::format("a sweep of {:.0f} values", *count),
                 fmt::format("1 to {} are allowed", kMostSweepValues));
  return Sweep{text.substr(0, equals), *from, *to, static_cast<int>(*count)};
}

Camera comparisonCamera() {
  Camera camera;
  camera.eye = {0, 0, 4.3f};
  camera.target = {0, 0, 0};
  camera.fovY = glm::radians(30.f);
  return camera;
}

Result<Comparison> makeComparison(const Scene& stage, std::span<const ComparisonRow> rows,
                                  std::span<const ComparisonColumn> columns, const std::string& place,
                                  const MaterialSources& sources, Diagnostics& problems) {
  Comparison comparison;
  comparison.camera = comparisonCamera();
  for (const ComparisonRow& row : rows) comparison.rowTitles.push_back(row.title);
  for (const ComparisonColumn& column : columns) comparison.columnTitles.push_back(column.title);
  const MeshPtr sphere = stage.instances.empty() ? sphereMesh() : nullptr;

  // A model parameter belongs to some rows only; a name that no cell knows is given to all, to be refused.
  std::set<std::string> known;
  const auto eachSetting = [&](auto&& visit) {
    for (const ComparisonRow& row : rows)
      for (const ComparisonColumn& column : columns)
        for (const auto* settings : {&row.settings, &column.settings})
          for (const Setting& setting : *settings) visit(row, column, setting);
  };
  eachSetting([&](const ComparisonRow& row, const ComparisonColumn& column, const Setting& setting) {
    if (takesSetting(*column.material, *row.model, setting.name)) known.insert(setting.name);
  });

  Diagnostics faults, found;
  const auto addOnce = [](Diagnostics& to, const Diagnostics& from) {
    for (const Diagnostic& d : from)
      if (std::find(to.begin(), to.end(), d) == to.end()) to.push_back(d);
  };
  for (const ComparisonRow& row : rows) {
    for (const ComparisonColumn& column : columns) {
      std::vector<Setting> settings;
      for (const auto* from : {&row.settings, &column.settings})
        for (const Setting& setting : *from)
          if (!known.count(setting.name) || takesSetting(*column.material, *row.model, setting.name))
            settings.push_back(setting);
      Diagnostics cellProblems;
      auto surface = surfaceWith(*column.material, row.model, settings, place, sources, cellProblems);
      addOnce(found, cellProblems);
      if (!surface) {
        addOnce(faults, surface.diagnostics());
        continue;
      }
      Scene scene = stage;
      scene.materials.assign(1, std::move(*surface));
      if (sphere) scene.instances.push_back({sphere, glm::mat4(1), 0});
      for (Instance& instance : scene.instances) instance.material = 0;
      comparison.scenes.push_back(std::move(scene));
    }
  }
  problems.insert(problems.end(), found.begin(), found.end());
  if (!faults.empty()) return faults;
  return comparison;
}

glm::ivec2 CellGrid::size() const {
  return {columns * cell + std::max(0, columns - 1) * gapX, rows * cell + std::max(0, rows - 1) * gapY};
}

glm::ivec4 CellGrid::rectangle(int row, int column) const {
  return {origin.x + column * (cell + gapX), origin.y + (rows - 1 - row) * (cell + gapY), cell, cell};
}

std::vector<View> comparisonViews(const Comparison& comparison, const CellGrid& grid) {
  GLINT_CHECK(grid.rows == comparison.rows() && grid.columns == comparison.columns());
  std::vector<View> views;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      views.push_back({&comparison.scene(row, column), comparison.camera, grid.rectangle(row, column)});
  return views;
}

}  // namespace glint
