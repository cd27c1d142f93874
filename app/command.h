// A command of `glint`: its name, words and work. One file each in app/commands/, one line each in
// app/commands/table.cpp; app/cli.cpp turns them into the command line, so nothing else knows CLI11.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "renderer/gl/context.h"

namespace glint {

// Exit codes (product.md 4).
inline constexpr int kDone = 0, kVerdictNo = 1, kBadInput = 2, kNoContext = 3;

struct Option {
  std::string name;        // "--size"; "-o" is written "-o,--output"; a positional has no dashes
  std::string argument;    // "WxH"; empty for a flag
  std::string help;
  bool repeatable = false;
  bool required = false;
};

// What the user gave: by the option's long name without dashes ("size", "output", "files").
struct Arguments {
  std::map<std::string, std::vector<std::string>> values;
  std::string commandLine;                 // "glint ...", quoted for a shell: for pictures' notes
  gl::Backend backend = gl::Backend::Auto;
  std::vector<std::filesystem::path> modelFolders;
  bool json = false, quiet = false;

  bool has(const std::string& name) const { return values.count(name) != 0; }
  std::string get(const std::string& name, const std::string& fallback = {}) const {
    const auto found = values.find(name);
    return found == values.end() || found->second.empty() ? fallback : found->second.back();
  }
  std::vector<std::string> all(const std::string& name) const {
    const auto found = values.find(name);
    return found == values.end() ? std::vector<std::string>{} : found->second;
  }
};

struct Command {
  std::string name;
  std::string summary;
  std::vector<Option> options;
  std::vector<std::string> examples;       // whole command lines
  // An exit code; has reported its own errors. One that returns kBadInput or kNoContext has printed nothing
  // on stdout: with --json its errors become the document.
  int (*run)(const Arguments&);
};

std::span<const Command* const> commands();  // app/commands/table.cpp

int runCommandLine(int argc, char** argv);   // app/cli.cpp

// Reports and gives the exit code for bad input.
int badInput(const Diagnostics&);

}  // namespace glint
