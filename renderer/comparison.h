// A comparison: models (rows) on materials or parameter values (columns), one sphere each, as values. Each
// cell is a scene of its own seen by the same camera, so that cells can be compared pixel by pixel.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/model_registry.h"
#include "renderer/material_settings.h"
#include "renderer/renderer.h"
#include "renderer/scene.h"

namespace glint {

// "roughness=0..1:5": COUNT values evenly from FROM to TO, both included.
struct Sweep {
  std::string name;
  float from = 0, to = 1;
  int count = 5;                          // 1..kMostSweepValues

  float value(int index) const;           // of 0..count-1; FROM where count is 1
  std::string title(int index) const;     // "0.25"
};
inline constexpr int kMostSweepValues = 64;
Result<Sweep> parseSweep(const std::string& text, const std::string& place);

struct ComparisonRow {
  std::string title;
  ModelPtr model;
  std::vector<Setting> settings;          // of the model's parameters, or a second sweep's value
};
struct ComparisonColumn {
  std::string title;
  MaterialPtr material;                   // compiled for each row's model
  std::vector<Setting> settings;          // a sweep's value
};

struct Comparison {
  std::vector<std::string> rowTitles, columnTitles;
  std::vector<Scene> scenes;              // row by row
  Camera camera;

  int rows() const { return static_cast<int>(rowTitles.size()); }
  int columns() const { return static_cast<int>(columnTitles.size()); }
  const Scene& scene(int row, int column) const { return scenes[size_t(row * columns() + column)]; }
};

// `stage` has what every cell shares: instances (all drawn with the cell's material), lights, environment.
// A stage without instances gets a sphere of radius 1 m at the origin. A setting that some cell's material and
// model do not have is left out there; one that none has is an error, as is all that surfaceWith() refuses.
// `place` names the source of the settings; `problems` is as for surfaceWith().
Result<Comparison> makeComparison(const Scene& stage, std::span<const ComparisonRow>,
                                  std::span<const ComparisonColumn>, const std::string& place,
                                  const MaterialSources&, Diagnostics& problems);

// A camera that leaves a thin margin round the unit sphere in a square cell.
Camera comparisonCamera();

// Square cells of one size in a picture, the first row on top.
struct CellGrid {
  int rows = 0, columns = 0;
  int cell = 256, gapX = 8, gapY = 8;     // pixels
  glm::ivec2 origin{0};                   // bottom left of the grid in the picture

  glm::ivec2 size() const;
  glm::ivec4 rectangle(int row, int column) const;  // as View::rectangle: from the bottom left
};
// The views of a comparison's cells in one picture. They point into `comparison`.
std::vector<View> comparisonViews(const Comparison& comparison, const CellGrid&);

}  // namespace glint
