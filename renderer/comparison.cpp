#include "renderer/comparison.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "renderer/mesh.h"

namespace glint {
namespace {

std::optional<float> number(std::string_view text) {
  float value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// A scalar given for a colour or vector fills it; other types must agree in their number of components.
std::optional<Value> fitted(const Value& value, ValueType type) {
  Value result = value;
  result.type = type;
  const int have = componentCount(value.type), want = componentCount(type);
  if (have == 0 || want == 0) return std::nullopt;
  if (have == 1)
    std::fill(result.v.begin(), result.v.begin() + want, value.v[0]);
  else if (have != want)
    return std::nullopt;
  if (type == ValueType::Bool) result.v[0] = value.v[0] != 0;
  if (type == ValueType::Int) result.v[0] = std::round(value.v[0]);
  return result;
}

}  // namespace

Diagnostics applySetting(SurfaceMaterial& material, const Setting& setting, const std::string& place) {
  const auto misfit = [&](ValueType wanted) {
    return Diagnostics{error(place, fmt::format("'{}' is a {}, not a {}", setting.name, name(wanted),
                                                name(setting.value.type)))};
  };
  if (material.compiled) {
    auto changed = std::make_shared<CompiledMaterial>(*material.compiled);
    if (UniformField* field = changed->uniform(setting.name)) {
      const auto value = fitted(setting.value, field->value.type);
      if (!value) return misfit(field->value.type);
      field->value = *value;
      // Only this member is copied: the block may hold values newer than the compiled ones.
      const std::vector<std::byte> block = changed->block();
      material.block.resize(block.size());
      const size_t bytes = 4 * size_t(componentCount(field->value.type));
      std::memcpy(&material.block[size_t(field->offset)], &block[size_t(field->offset)], bytes);
      material.compiled = std::move(changed);
      return {};
    }
  }
  if (material.model) {
    const auto& parameters = material.model->parameters;
    if (material.modelParameters.size() != parameters.size()) {
      material.modelParameters.clear();
      for (const ModelParameter& parameter : parameters) material.modelParameters.push_back(parameter.standard);
    }
    for (size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name != setting.name) continue;
      const auto value = fitted(setting.value, parameters[i].standard.type);
      if (!value) return misfit(parameters[i].standard.type);
      material.modelParameters[i] = *value;
      return {};
    }
  }
  std::vector<std::string> known;
  if (material.compiled)
    for (const UniformField& field : material.compiled->uniforms) known.push_back(field.name);
  if (material.model)
    for (const ModelParameter& parameter : material.model->parameters) known.push_back(parameter.name);
  return {error(place, fmt::format("nothing is named '{}'", setting.name), suggestion(setting.name, known))};
}

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
                                  std::span<const ComparisonColumn> columns) {
  Comparison comparison;
  comparison.camera = comparisonCamera();
  for (const ComparisonRow& row : rows) comparison.rowTitles.push_back(row.title);
  for (const ComparisonColumn& column : columns) comparison.columnTitles.push_back(column.title);
  const MeshPtr sphere = stage.instances.empty() ? sphereMesh() : nullptr;
  // A setting counts as unknown only when no cell has it: a model parameter belongs to some rows only.
  Diagnostics first;
  std::vector<std::string> known, failed;
  for (const ComparisonRow& row : rows) {
    for (const ComparisonColumn& column : columns) {
      Scene scene = stage;
      SurfaceMaterial material = column.material;
      if (row.model != material.model) material.modelParameters.clear();
      material.model = row.model;
      for (const auto* settings : {&row.settings, &column.settings}) {
        for (const Setting& setting : *settings) {
          const Diagnostics problems = applySetting(material, setting, "comparison");
          if (problems.empty()) {
            known.push_back(setting.name);
          } else {
            failed.push_back(setting.name);
            first.push_back(problems.front());
          }
        }
      }
      scene.materials.assign(1, std::move(material));
      if (sphere) scene.instances.push_back({sphere, glm::mat4(1), 0});
      for (Instance& instance : scene.instances) instance.material = 0;
      comparison.scenes.push_back(std::move(scene));
    }
  }
  Diagnostics problems;
  for (size_t i = 0; i < failed.size(); ++i)
    if (std::find(known.begin(), known.end(), failed[i]) == known.end()) {
      known.push_back(failed[i]);  // once
      problems.push_back(first[i]);
    }
  if (!problems.empty()) return problems;
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
