#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "app/bench/cases.h"
#include "app/bench/temporary_folder.h"

extern char** environ;

namespace glint {
namespace fs = std::filesystem;
namespace {

// Starts this program for its first frame, with caches of its own: the milliseconds until it says that the frame is
// there. The child is gone when this returns; its ending is not part of the time.
Result<double> firstFrame(const fs::path& caches, gl::Backend backend) {
  const auto start = std::chrono::steady_clock::now();
  const auto failed = [](const std::string& what) { return error("startup", what, "see what the child said above"); };
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return failed(std::strerror(errno));
  std::vector<std::string> variables;
  for (char** v = environ; *v; ++v)
    if (std::strncmp(*v, "XDG_CACHE_HOME=", 15) && std::strncmp(*v, "MESA_SHADER_CACHE_DIR=", 22)) variables.emplace_back(*v);
  variables.push_back("XDG_CACHE_HOME=" + caches.string());
  variables.push_back("MESA_SHADER_CACHE_DIR=" + (caches / "mesa").string());
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  const std::string program = fs::read_symlink("/proc/self/exe").string();
  std::string words[] = {"glint", "bench", "--first-frame", "--quiet", "--backend", std::string(gl::name(backend))};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  pid_t child = 0;
  const int code = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (code != 0) {
    ::close(ends[0]);
    return failed(std::strerror(code));
  }
  char byte = 0;
  ssize_t got = 0;
  while ((got = ::read(ends[0], &byte, 1)) < 0 && errno == EINTR) {}
  const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  ::close(ends[0]);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {}
  if (got != 1) return failed("the child drew no frame");
  return ms;
}

Result<Measurement> startup(BenchSetup& setup, const std::string& name, bool warm) {
  const int runs = (setup.quick ? 1 : warm ? 7 : 3) + (warm ? 1 : 0);
  std::vector<double> times;
  TemporaryFolder kept;
  for (int i = 0; i < runs; ++i) {
    TemporaryFolder fresh;
    const auto ms = firstFrame(warm ? kept.path() : fresh.path(), setup.context.backend());
    if (!ms) return ms.diagnostics();
    if (!warm || i > 0) times.push_back(*ms);  // the first one fills the caches
  }
  return summarize(name, times, "process start to the first finished frame of 1280x720");
}

}  // namespace

std::vector<BenchCase> startupCases() {
  return {{"startup.cold", "process start to first frame, every cache empty", [](BenchSetup& s) { return startup(s, "startup.cold", false); }},
          {"startup.warm", "process start to first frame, from the second time on", [](BenchSetup& s) { return startup(s, "startup.warm", true); }}};
}

}  // namespace glint
