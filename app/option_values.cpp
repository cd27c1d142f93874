#include "app/option_values.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "materials/value.h"

namespace glint {

std::optional<double> finiteNumber(std::string_view text) {
  double value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string> splitText(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (size_t at = 0;;) {
    const size_t next = text.find(separator, at);
    parts.push_back(text.substr(at, next - at));
    if (next == std::string::npos) return parts;
    at = next + 1;
  }
}

Result<float> parseNumber(const std::string& text, float low, float high, const std::string& place) {
  const auto value = finiteNumber(text);
  if (!value) return error(place, fmt::format("'{}' is not a number", text), fmt::format("write a number from {:g} to {:g}", low, high));
  const float number = static_cast<float>(*value);
  if (!(number >= low && number <= high))
    return error(place, fmt::format("{} is out of range", text), fmt::format("{:g} to {:g} are allowed", low, high));
  return number;
}

Result<int> parseWhole(const std::string& text, int low, int high, const std::string& place) {
  const auto value = finiteNumber(text);
  if (!value || *value != std::floor(*value))
    return error(place, fmt::format("'{}' is not a whole number", text), fmt::format("{} to {} are allowed", low, high));
  if (*value < low || *value > high)
    return error(place, fmt::format("{} is out of range", text), fmt::format("{} to {} are allowed", low, high));
  return static_cast<int>(*value);
}

Result<glm::ivec2> parseSize(const std::string& text, const std::string& place) {
  const size_t x = text.find('x');
  const auto width = finiteNumber(std::string_view(text).substr(0, x));
  const auto height = x == std::string::npos ? std::nullopt : finiteNumber(std::string_view(text).substr(x + 1));
  if (!width || !height || *width != std::floor(*width) || *height != std::floor(*height))
    return error(place, fmt::format("'{}' is not a size", text), "write WIDTHxHEIGHT, for example 1280x720");
  if (std::min(*width, *height) < 1 || std::max(*width, *height) > kLargestPictureSide)
    return error(place, fmt::format("{} is out of range", text), fmt::format("each side may be 1 to {} pixels", kLargestPictureSide));
  return glm::ivec2(static_cast<int>(*width), static_cast<int>(*height));
}

Result<std::vector<std::string>> parseNameList(const std::string& text, const std::string& place) {
  std::vector<std::string> names = splitText(text, ',');
  if (std::find(names.begin(), names.end(), "") != names.end())
    return error(place, fmt::format("'{}' has an empty name", text), "write A,B,C without spaces");
  return names;
}

Result<glm::vec3> parseColor(const std::string& text, const std::string& place) {
  const auto value = parseValue(ValueType::Color, text);
  if (!value || *std::min_element(value->v.begin(), value->v.begin() + 3) < 0)
    return error(place, fmt::format("'{}' is not a colour", text), "write r/g/b (linear), one grey number, or #rrggbb (sRGB)");
  return glm::vec3(value->v[0], value->v[1], value->v[2]);
}

Result<std::vector<KeyValue>> parseKeys(const std::string& text, const std::string& place, const std::vector<std::string>& known) {
  std::vector<KeyValue> result;
  Diagnostics problems;
  for (const std::string& part : splitText(text, ',')) {
    const size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems.push_back(error(place, fmt::format("'{}' is not key=value", part), "known keys: " + fmt::format("{}", fmt::join(known, ", "))));
      continue;
    }
    const std::string key = part.substr(0, equals);
    if (std::find(known.begin(), known.end(), key) == known.end())
      problems.push_back(error(place, fmt::format("unknown key '{}'", key), suggestion(key, known)));
    else if (std::any_of(result.begin(), result.end(), [&](const KeyValue& r) { return r.key == key; }))
      problems.push_back(error(place, fmt::format("'{}' is given twice", key), "give it once"));
    else
      result.push_back({key, part.substr(equals + 1)});
  }
  if (!problems.empty()) return problems;
  return result;
}

}  // namespace glint
