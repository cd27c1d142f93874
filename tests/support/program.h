// Runs the built program as a user would, and says what came of it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace glint::testing_support {

struct Ran {
  int code = -1;               // the exit code; -SIGNAL when a signal ended it, -1000 when it took too long
  std::string out, err;

  std::vector<std::string> errorLines() const;  // of stderr
  // stdout as the one JSON document it must be; discarded() when it is not.
  nlohmann::json json() const;
};

// GLINT_PROGRAM with these arguments, from `folder` (the test's scratch folder when empty).
Ran glint(const std::vector<std::string>& arguments, const std::filesystem::path& folder = {});

// An environment variable for as long as this lives; children see it.
class WithVariable {
 public:
  WithVariable(const char* name, const std::string& value);
  ~WithVariable();
  WithVariable(const WithVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

// A folder of this test case's own, empty at its start.
std::filesystem::path scratch();
// The names in a folder, sorted: for "nothing half-written".
std::vector<std::string> filesIn(const std::filesystem::path&);

}  // namespace glint::testing_support

// Exit code 2 and one line "glint: error: PLACE: WHAT; HINT" that contains both texts.
#define EXPECT_BAD_INPUT(ran, place, words)                                                   \
  do {                                                                                        \
    const auto& r_ = (ran);                                                                   \
    EXPECT_EQ(r_.code, 2) << r_.err;                                                          \
    EXPECT_EQ(r_.out, "");                                                                    \
    EXPECT_EQ(r_.errorLines().size(), 1u) << r_.err;                                          \
    EXPECT_EQ(r_.err.rfind(std::string("glint: error: ") + (place) + ": ", 0), 0u) << r_.err; \
    EXPECT_NE(r_.err.find(words), std::string::npos) << r_.err;                               \
  } while (false)
