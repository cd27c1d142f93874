// JSON as Glint reads and writes it: every value knows its line, numbers keep their spelling and objects
// their order, so that a file can be judged with its places and written back unchanged.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "materials/base/diagnostic.h"

namespace glint {

struct Json {
  enum class Kind { Null, Bool, Number, String, Array, Object };

  Kind kind = Kind::Null;
  bool boolean = false;
  double number = 0;             // finite
  std::string text;              // a String's contents (UTF-8), or a Number as it was spelt
  std::vector<Json> items;       // of an Array, or the values of an Object
  std::vector<std::string> keys; // of an Object, beside items; unique
  int line = 0;                  // in the file, from 1; 0 when not read from one

  static Json null() { return {}; }
  static Json of(bool);
  static Json of(double);        // spelt as the shortest float or double that reads back the same
  static Json of(float);
  static Json of(int);
  static Json of(std::string);
  static Json of(const char* s) { return of(std::string(s)); }
  static Json array() { return {.kind = Kind::Array}; }
  static Json object() { return {.kind = Kind::Object}; }

  bool isObject() const { return kind == Kind::Object; }
  bool isArray() const { return kind == Kind::Array; }
  bool isString() const { return kind == Kind::String; }
  bool isNumber() const { return kind == Kind::Number; }
  bool isBool() const { return kind == Kind::Bool; }

  const Json* find(std::string_view key) const;   // null when not an object or absent
  Json& set(std::string key, Json value);         // replaces or appends; gives the stored value
  Json& push(Json value);

  // Same meaning and order; lines are ignored, numbers compare by spelling.
  bool operator==(const Json&) const;
};

std::string_view name(Json::Kind);  // "an object", "a number": for diagnostics

// How a value of that kind is written, for hints: "write a number, for example 0.5".
std::string writtenAs(Json::Kind);

struct JsonLimits {
  size_t bytes = size_t{16} << 20;
  size_t values = 2'000'000;
  int depth = 64;
};

// Errors: not JSON, over a limit, a key twice in one object; each at `file`:line, where the first line of
// `text` counts as `firstLine`.
Result<Json> parseJson(std::string_view text, const std::string& file, int firstLine = 1,
                       const JsonLimits& = {});

// Two spaces of indent, one key a line; arrays of numbers or short strings stay on one line. Ends with a
// line feed. The same value gives the same bytes.
std::string writeJson(const Json&);

}  // namespace glint
