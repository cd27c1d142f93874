// The values of options, from words: numbers, sizes, lists. Each error has the option as its place and says what
// would do.
#pragma once

#include <glm/glm.hpp>
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

}  // namespace glint
