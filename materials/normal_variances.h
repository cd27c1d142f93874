// What the graph compiler knows of normals that are averages: by how much the slopes of a normal map vary within a pixel. The
// renderer widens roughness by it (shaders/common/specular_antialiasing.glsl).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "materials/glsl_program.h"
#include "materials/graph_analysis.h"

namespace glint {

class NormalVariances {
 public:
  explicit NormalVariances(GlslProgram& program) : program_(program) {}

  // The variance, along one axis, of the slopes of a normal, or of the colour that is to become one; negative: it has none.
  ValueId of(ValueId normal) const;

  // The colour of a texture whose alpha holds the variance (renderer/normal_variance.h).
  void sampled(const GlslProgram::Origin&, ValueId color, ValueId alpha);
  // A normal that a data node has made, as its head says.
  void made(const GlslProgram::Origin&, const NodeKind&, const std::vector<ValueId>& arguments, ValueId normal);
  // A blend of two layers.
  void blended(const GlslProgram::Origin&, ValueId a, ValueId b, ValueId mask, ValueId normal);

 private:
  void keep(const GlslProgram::Origin&, ValueId normal, std::string text, std::vector<ValueId> arguments);

  GlslProgram& program_;
  std::map<ValueId, ValueId> variances_;
};

// Whether the picture that a node samples is only ever made into normals, by nodes that tell their variance.
bool holdsNormals(const Material&, const GraphAnalysis&, const NodeId&);

}  // namespace glint
