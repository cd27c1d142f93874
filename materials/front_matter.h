// The JSON head of a GLSL file that is data to Glint: a shading model (materials/model.h) or a graph's
// node (materials/node.h). It is the first comment that starts with the word `glint`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/base/json.h"
#include "materials/value.h"

namespace glint {

struct FrontMatter {
  Json head;         // an object; its lines are lines of the file
  std::string body;  // the file's text with the head blanked, so that lines keep their numbers
};

// Errors: no head, a head that never ends, is not JSON, is no object or is deeper than a dozen levels.
Result<FrontMatter> readFrontMatter(const std::string& file, std::string_view text);

// Reads the members of one JSON object and says what is wrong with each: wrong types, missing keys and, at
// finish(), keys that nobody asked for (with the nearest name that somebody did).
class ObjectReader {
 public:
  // `where` says which object this is ("parameter 'gamma'") and may be empty. `json` must outlive this; one
  // that is no object is reported here and then reads as empty.
  ObjectReader(const Json& json, std::string file, std::string where, Diagnostics& problems);

  // Each gives nothing when the key is absent or has the wrong type; the latter is reported, the former when
  // `required`.
  std::optional<std::string> text(std::string_view key, bool required = false);
  std::optional<float> number(std::string_view key, bool required = false);
  std::optional<bool> boolean(std::string_view key, bool required = false);
  std::optional<std::vector<std::string>> texts(std::string_view key);
  // A number, an array of as many numbers as `type` has components, true or false for a Bool; for a Color
  // also "#rrggbb" in sRGB; one number fills a vector or colour.
  std::optional<Value> value(std::string_view key, ValueType type, bool required = false);
  const Json* object(std::string_view key, bool required = false);
  const Json* array(std::string_view key, bool required = false);
  const Json* any(std::string_view key);

  bool has(std::string_view key) const { return json_.find(key) != nullptr; }
  void problem(const Json& at, std::string what, std::string hint = {});  // an error at that value's line
  void problem(std::string what, std::string hint = {});                  // at the object's own line
  std::string place(const Json& at) const;                                // "file:line"
  // Reports the keys that were not read.
  void finish();

 private:
  const Json* take(std::string_view key, bool required);
  const Json* take(std::string_view key, bool required, Json::Kind kind);
  const Json& json_;
  std::string file_, where_;
  Diagnostics& problems_;
  std::vector<std::string> known_;
};

// As ObjectReader::value, of a bare value: nothing when it is not a finite value of that type.
std::optional<Value> valueFromJson(const Json&, ValueType);
// How JSON has such a value, for hints: "an array of 3 numbers".
std::string jsonHint(ValueType);
Json valueToJson(const Value&);

}  // namespace glint
