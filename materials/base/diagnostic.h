// What is wrong with an input, where, and what to do about it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "materials/base/check.h"

namespace glint {

enum class Severity { Error, Warning };

// One finding about an input. Printed as `glint: error: PLACE: WHAT; HINT`.
struct Diagnostic {
  Severity severity = Severity::Error;
  std::string place;  // file, file:line, or file: node 'n' pin 'p'; never empty
  std::string what;   // one clause, lower case, without a full stop
  std::string hint;   // what the user can do; may be empty

  std::string text() const;  // "PLACE: WHAT; HINT"
  bool operator==(const Diagnostic&) const = default;
};
using Diagnostics = std::vector<Diagnostic>;

bool hasErrors(const Diagnostics&);

inline Diagnostic error(std::string place, std::string what, std::string hint = {}) {
  return {Severity::Error, std::move(place), std::move(what), std::move(hint)};
}
inline Diagnostic warning(std::string place, std::string what, std::string hint = {}) {
  return {Severity::Warning, std::move(place), std::move(what), std::move(hint)};
}

// A value, or all the errors that kept it from being made. Warnings beside a value travel through an
// extra `Diagnostics&` parameter of the function that returns it.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}                      // NOLINT: implicit by intent
  Result(Diagnostic d) : state_(Diagnostics{std::move(d)}) {}        // NOLINT
  Result(Diagnostics d) : state_(std::move(d)) {                     // NOLINT
    GLINT_CHECK(!diagnostics().empty(), "a failed Result must say why");
  }

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }
  T& value() {
    GLINT_CHECK(ok(), "{}", diagnostics().front().text());
    return std::get<T>(state_);
  }
  const T& value() const { return const_cast<Result*>(this)->value(); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Diagnostics& diagnostics() const { return std::get<Diagnostics>(state_); }

 private:
  std::variant<T, Diagnostics> state_;
};

// A noun with its article, "an 'output'": quotes are looked through. For names of kinds and types.
std::string withArticle(std::string_view noun);

// The member of `names` nearest to `name` by edit distance, or "" when none is near: for hints.
std::string nearest(const std::string& name, const std::vector<std::string>& names);
// "did you mean 'x'?" or, when nothing is near, "known: a, b, c" (cut after a dozen).
std::string suggestion(const std::string& name, const std::vector<std::string>& names);

}  // namespace glint
