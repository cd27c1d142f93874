// The values of options, from words: numbers, sizes, lists. Each error has the option as its place and says what
// would do.
#pragma once

#include <glm/glm.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/base/diagnostic.h"

namespace glint {

inline constexpr int kLargestPictureSide = 8192;  // pixels

// The whole text as a finite number, or nothing.
std::optional<double> finiteNumber(std::string_view text);
// The parts between separators; one empty part for an empty text.
std::vector<std::string> splitText(const std::string& text, char separator);

// "M1,M2": names, none empty.
Result<std::vector<std::string>> parseNameList(const std::string& text, const std::string& place);
// "512x512"; both sides 1..kLargestPictureSide.
Result<glm::ivec2> parseSize(const std::string& text, const std::string& place);
// A whole number in a range; the error names the range.
Result<int> parseWhole(const std::string& text, int low, int high, const std::string& place);
// A finite number in a range.
Result<float> parseNumber(const std::string& text, float low, float high, const std::string& place);

// Linear Rec.709 from "r/g/b", "#rrggbb" (sRGB) or one number; none negative.
Result<glm::vec3> parseColor(const std::string& text, const std::string& place);

// "key=value,key=value" with each key known and given once.
struct KeyValue {
  std::string key, value;
};
Result<std::vector<KeyValue>> parseKeys(const std::string& text, const std::string& place, const std::vector<std::string>& known);

// Keeps a result's value, or its errors for the end.
template <class T, class To>
bool keep(Diagnostics& problems, Result<T>&& result, To& to) {
  if (result) {
    to = std::move(*result);
    return true;
  }
  for (const Diagnostic& d : result.diagnostics())
    if (std::find(problems.begin(), problems.end(), d) == problems.end()) problems.push_back(d);
  return false;
}

}  // namespace glint
