// A row of the comparison as the command line writes it: "burley", or "GTR*SmithGGX*Schlick:gamma=3".
#pragma once

#include <string>
#include <vector>

#include "materials/model.h"
#include "renderer/material_settings.h"

namespace glint {

struct ModelRow {
  std::string id;
  std::vector<Setting> parameters;   // what they are not said for is as the material has it

  std::string text() const;
  std::string note() const;          // "gamma 3", for a label; empty without parameters
  // The value in force for a parameter of its model: its own, or the standard one.
  Value value(const ModelParameter&) const;
  void set(const ModelParameter&, const Value&);
};

// A text that cannot be read is taken for an id, which no model has.
ModelRow modelRow(const std::string& text);

}  // namespace glint
