#include "tests/support/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

extern char** environ;

namespace glint::testing_support {
namespace fs = std::filesystem;
namespace {

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

std::vector<std::string> Ran::errorLines() const {
  std::vector<std::string> lines;
  std::istringstream in(err);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

nlohmann::json Ran::json() const { return nlohmann::json::parse(out, nullptr, false); }

WithVariable::WithVariable(const char* name, const std::string& value) : name_(name) {
  if (const char* before = std::getenv(name)) before_ = before;
  ::setenv(name, value.c_str(), 1);
}

WithVariable::~WithVariable() {
  if (before_) ::setenv(name_, before_->c_str(), 1);
  else ::unsetenv(name_);
}

fs::path scratch() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const fs::path folder = fs::path(GLINT_TESTS_OUT) / name;
  static std::string cleaned;
  if (cleaned != name) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    cleaned = name;
  }
  return folder;
}

std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

Ran glint(const std::vector<std::string>& arguments, const fs::path& folder) {
  const fs::path where = folder.empty() ? scratch() : folder;
  // Beside the scratch folder, which tests list.
  const std::string base = scratch().string();
  const std::string outFile = base + ".stdout", errFile = base + ".stderr";
  std::vector<char*> argv = {const_cast<char*>(GLINT_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, where.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, outFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_addopen(&actions, 2, errFile.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t child = 0;
  Ran ran;
  const int failed = posix_spawn(&child, GLINT_PROGRAM, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed) {
    ADD_FAILURE() << "cannot start " << GLINT_PROGRAM;
    return ran;
  }
  int status = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(100);
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      ran.code = -1000;
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (ran.code != -1000) ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  ran.out = contents(outFile);
  ran.err = contents(errFile);
  // OpenGL's complaints fail a test in the program as they do in this process (test_main.cpp).
  EXPECT_EQ(ran.err.find("error: OpenGL: "), std::string::npos) << ran.err;
  return ran;
}

}  // namespace glint::testing_support
