#include "app/editor/model_row.h"

#include <algorithm>

#include "app/scene_options.h"

namespace glint {

std::string ModelRow::text() const {
  std::string text = id;
  for (const Setting& p : parameters) text += (&p == &parameters.front() ? ":" : ",") + p.name + "=" + p.text;
  return text;
}

std::string ModelRow::note() const {
  std::string note;
  for (const Setting& p : parameters) note += (note.empty() ? "" : ", ") + p.name + " " + p.text;
  return note;
}

Value ModelRow::value(const ModelParameter& parameter) const {
  for (const Setting& p : parameters)
    if (p.name == parameter.name)
      if (const auto value = parseValue(parameter.standard.type, p.text)) return *value;
  return parameter.standard;
}

void ModelRow::set(const ModelParameter& parameter, const Value& value) {
  std::string text = valueText(value);
  std::replace(text.begin(), text.end(), ',', '/');  // commas part parameters
  for (Setting& p : parameters)
    if (p.name == parameter.name) {
      p.text = text;
      return;
    }
  parameters.push_back({parameter.name, text});
}

ModelRow modelRow(const std::string& text) {
  if (const auto read = parseModelList(text, "row"); read && read->size() == 1) return {read->front().id, read->front().parameters};
  return {text, {}};
}

}  // namespace glint
