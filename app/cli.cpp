// The only file that knows CLI11: it parses and prints help; what is said about mistakes is said here, in
// Glint's own form.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/command.h"
#include "materials/base/log.h"

namespace glint {
namespace {

constexpr const char* kPlace = "command line";

const std::vector<Option>& commonOptions() {
  static const std::vector<Option> options = {
      {"--backend", "NAME", "where OpenGL comes from: auto, glfw, egl or osmesa"},
      {"--models-dir", "DIR", "a folder of shading models beside the shipped ones (repeatable)", true},
      {"--json", "", "exactly one JSON document on stdout, nothing else"},
      {"--quiet", "", "errors only"},
  };
  return options;
}

// "-o,--output" -> "output"; "files" -> "files".
std::string keyOf(const std::string& name) {
  const size_t comma = name.rfind(',');
  std::string longest = comma == std::string::npos ? name : name.substr(comma + 1);
  longest.erase(0, longest.find_first_not_of('-'));
  return longest;
}

bool isPositional(const Option& option) { return option.name[0] != '-'; }

// "-o,--output" -> {"-o", "--output"}.
std::vector<std::string> spellings(const Option& option) {
  std::vector<std::string> result;
  for (size_t at = 0; at != std::string::npos;) {
    const size_t comma = option.name.find(',', at);
    result.push_back(option.name.substr(at, comma - at));
    at = comma == std::string::npos ? comma : comma + 1;
  }
  return result;
}

// How a person would name it: "--output", or "FILE" for a positional.
std::string shownName(const Option& option) {
  return isPositional(option) ? option.argument : spellings(option).back();
}

// Quoted where a shell would need it, so that a picture's note can be pasted and run.
std::string shellWord(const std::string& word) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || std::strchr("-_./=,:+@%", c); };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> commandNames() {
  std::vector<std::string> names;
  for (const Command* command : commands()) names.push_back(command->name);
  return names;
}

const Command* findCommand(const std::string& name) {
  for (const Command* command : commands())
    if (command->name == name) return command;
  return nullptr;
}

// The index of the first word that is not a common option or its value, or of a `--`, after which all are files; the count
// when there is none.
size_t firstWord(const std::vector<std::string>& words) {
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--") return i;
    if (words[i].empty() || words[i][0] != '-') return i;
    for (const Option& option : commonOptions())
      if (!option.argument.empty() && words[i] == option.name) ++i;
  }
  return words.size();
}

bool isOptionOf(const std::vector<Option>& options, const std::string& word) {
  const std::string given = word.substr(0, word.find('='));
  return std::any_of(options.begin(), options.end(), [&](const Option& option) {
    const auto names = spellings(option);
    return std::find(names.begin(), names.end(), given) != names.end();
  });
}

bool isHelpOrVersion(const std::string& word) { return word == "--version" || word == "--help" || word == "-h"; }

bool looksLikeFile(const std::string& word) {
  std::error_code ignored;
  return word.find_first_of("./") != std::string::npos || std::filesystem::exists(word, ignored);
}

Diagnostic unknownOption(const std::string& word, const Command* command) {
  const std::string given = word.substr(0, word.find('='));
  std::vector<std::string> names = {"--help", "--version"};
  const auto add = [&](const Option& option) {
    for (const std::string& spelling : spellings(option))
      if (spelling.starts_with("--")) names.push_back(spelling);
  };
  for (const Option& option : commonOptions()) add(option);
  if (command)
    for (const Option& option : command->options) add(option);
  const std::string whose = command ? "glint " + command->name : "glint";
  const std::string near = nearest(given, names);
  return error(given, fmt::format("'{}' has no such option", whose),
               near.empty() ? fmt::format("{} --help lists what it has", whose)
                            : fmt::format("did you mean '{}'?", near));
}

struct Parsed {
  const Command* command = nullptr;
  Arguments arguments;
  std::string backend = "auto";
  std::string help;  // to print instead of running
};

std::string footerOf(const Command& command) {
  std::string footer = "Common options, before or after the command:\n";
  for (const Option& option : commonOptions())
    footer += fmt::format("  {:<27} {}\n", option.name + (option.argument.empty() ? "" : " " + option.argument), option.help);
  footer += "\nExamples:\n";
  for (const std::string& example : command.examples) footer += "  " + example + "\n";
  return footer;
}

Result<Parsed> parse(std::vector<std::string> words) {
  Parsed parsed;
  Arguments& arguments = parsed.arguments;

  CLI::App app("Glint: author materials, compare and judge shading models.\n"
               "`glint` alone, or with a file, opens the editor.", "glint");
  app.set_version_flag("--version", "glint " GLINT_VERSION);
  app.allow_extras();
  app.require_subcommand(0, 1);  // a later word that is also a command's name is an argument
  app.footer("`glint COMMAND --help` has each command's options and examples.\n\nExamples:\n"
             "  glint\n"
             "  glint render helmet.glb --env studio -o helmet.png\n"
             "  glint compare --models blinn-phong,cook-torrance,burley,ggx --materials aluminium,rubber,black -o models.png\n"
             "\nExit codes: 0 done; 1 done, and the verdict is no; 2 bad usage or input; 3 no OpenGL context.");
  std::map<std::string, std::vector<std::string>> common;
  const auto add = [](CLI::App& to, const Option& option, std::vector<std::string>& values) {
    if (option.argument.empty()) {
      to.add_flag_callback(option.name, [&values] { values.push_back("true"); }, option.help);
      return;
    }
    CLI::Option* added = to.add_option(option.name, values, option.help)->type_name(option.argument);
    // A repeatable positional takes all the words there are; an option one at a time.
    if (!isPositional(option) || !option.repeatable) added->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->allow_extra_args(false);
  };
  for (const Option& option : commonOptions()) add(app, option, common[keyOf(option.name)]);
  for (const Command* command : commands()) {
    CLI::App* sub = app.add_subcommand(command->name, command->summary)->fallthrough();
    sub->footer(footerOf(*command));
    for (const Option& option : command->options) add(*sub, option, arguments.values[keyOf(option.name)]);
    sub->callback([command, &parsed] { parsed.command = command; });
  }

  // No command: the editor, unless the word can only be a misspelt command.
  const bool asksAboutGlint = std::any_of(words.begin(), words.end(), isHelpOrVersion);
  const size_t first = firstWord(words);
  const bool named = first < words.size() && findCommand(words[first]);
  if (!named && first < words.size() && words[first] != "--" && !looksLikeFile(words[first])) {
    // After a misspelt option its value looks like a command.
    for (size_t i = 0; i < first; ++i)
      if (words[i][0] == '-' && !isOptionOf(commonOptions(), words[i]) && !isHelpOrVersion(words[i]))
        return unknownOption(words[i], findCommand("edit"));
    return error(words[first], "no such command", suggestion(words[first], commandNames()));
  }
  if (!named && !(asksAboutGlint && first == words.size()) && findCommand("edit"))
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(first), "edit");

  const Command* command = first < words.size() ? findCommand(words[first]) : nullptr;
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(words);
  } catch (const CLI::CallForHelp&) {
    parsed.help = app.help();
    return parsed;
  } catch (const CLI::CallForVersion& e) {
    parsed.help = std::string(e.what()) + "\n";
    return parsed;
  } catch (const CLI::ArgumentMismatch& e) {
    const std::string name = std::string(e.what()).substr(0, std::string(e.what()).find(':'));
    const auto wants = [&](const std::vector<Option>& options) -> const Option* {
      for (const Option& option : options)
        for (const std::string& spelling : spellings(option))
          if (spelling == name) return &option;
      return nullptr;
    };
    const Option* option = wants(commonOptions());
    if (!option && command) option = wants(command->options);
    if (option) return error(shownName(*option), "its value is missing", fmt::format("write {} {}", shownName(*option), option->argument));
    return error(kPlace, e.what(), "glint --help lists what there is");
  } catch (const CLI::ParseError& e) {
    return error(kPlace, e.what(), "glint --help lists what there is");
  }

  // Unknown options come before missing ones: a misspelt `--ouput` is both.
  for (const std::string& extra : app.remaining(true)) {
    if (extra == "--") continue;
    if (extra.size() > 1 && extra[0] == '-') return unknownOption(extra, parsed.command);
    return error(extra, fmt::format("'glint {}' takes no such argument", parsed.command ? parsed.command->name : ""),
                 fmt::format("glint {} --help lists what it takes", parsed.command ? parsed.command->name : ""));
  }
  if (!parsed.command) return error(kPlace, "no command", "glint --help lists them");
  Diagnostics problems;
  const auto count = [&](const Option& option, const std::vector<std::string>& values) {
    if (option.required && values.empty()) {
      const bool output = keyOf(option.name) == "output";
      problems.push_back(error(shownName(option), "is missing",
                               isPositional(option) ? fmt::format("glint {} --help has examples", parsed.command->name)
                                                    : fmt::format("give {} {}", output ? "-o" : shownName(option), option.argument)));
    }
    if (!option.repeatable && !option.argument.empty() && values.size() > 1)
      problems.push_back(error(shownName(option), fmt::format("is given {} times", values.size()), "give it once"));
  };
  for (const Option& option : parsed.command->options) count(option, arguments.values[keyOf(option.name)]);
  for (const Option& option : commonOptions()) count(option, common[keyOf(option.name)]);
  if (!problems.empty()) return problems;

  std::erase_if(arguments.values, [](const auto& item) { return item.second.empty(); });
  if (!common["backend"].empty()) parsed.backend = common["backend"].back();
  const auto backend = gl::backend(parsed.backend);
  if (!backend)
    return error("--backend", fmt::format("unknown back end '{}'", parsed.backend),
                 suggestion(parsed.backend, {"auto", "glfw", "egl", "osmesa"}));
  arguments.backend = *backend;
  arguments.modelFolders.assign(common["models-dir"].begin(), common["models-dir"].end());
  for (const auto& folder : arguments.modelFolders) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
      problems.push_back(error("--models-dir", fmt::format("'{}' is not a folder", folder.string()), "check the path"));
  }
  if (!problems.empty()) return problems;
  arguments.json = !common["json"].empty();
  arguments.quiet = !common["quiet"].empty();
  return parsed;
}

// A contract broken by an exception of a library is still an answer with a place, never a bare abort.
int runGuarded(const Parsed& parsed) {
  try {
    return parsed.command->run(parsed.arguments);
  } catch (const std::system_error& e) {
    if (e.code().value() == EPIPE) return kDone;  // the reader has what it wanted (glint models | head)
    return badInput({error("glint " + parsed.command->name, e.what(), "check the disk and what else runs")});
  } catch (const std::bad_alloc&) {
    return badInput({error("glint " + parsed.command->name, "there is not enough memory", "ask for a smaller picture or input")});
  }
}

// What is still in stdout's buffer must reach it, or the exit code would lie.
int flushed(int code) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  if (errno == EPIPE) return code;
  return badInput({error("standard output", fmt::format("cannot be written: {}", std::strerror(errno)), "check the disk or the redirection")});
}

void printErrors(const Diagnostics& diagnostics) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Diagnostic& d : diagnostics)
    if (d.severity == Severity::Error) list.push_back({{"place", d.place}, {"what", d.what}, {"hint", d.hint}});
  nlohmann::ordered_json document;
  document["errors"] = std::move(list);
  fmt::print("{}\n", document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace

int badInput(const Diagnostics& diagnostics) {
  log::report(diagnostics);
  return kBadInput;
}

int runCommandLine(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed reader is a failed write, not a death in the middle of a file
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const auto files = std::find(words.begin(), words.end(), "--");
  const bool json = std::find(words.begin(), files, "--json") != files;
  std::string commandLine = "glint";
  for (const std::string& word : words) commandLine += " " + shellWord(word);

  Diagnostics reported;
  if (json) log::setCollector(&reported);
  auto parsed = parse(words);
  int code = kDone;
  if (!parsed) {
    code = badInput(parsed.diagnostics());
  } else if (!parsed->help.empty()) {
    std::fputs(parsed->help.c_str(), stdout);
    return flushed(kDone);
  } else {
    parsed->arguments.commandLine = commandLine;
    log::setQuiet(parsed->arguments.quiet);
    code = runGuarded(*parsed);
  }
  log::setCollector(nullptr);
  try {
    // A command that fails has printed nothing (command.h), so its errors are the document.
    if (json && (code == kBadInput || code == kNoContext)) printErrors(reported);
  } catch (const std::system_error&) {
    return code;
  }
  return flushed(code);
}

}  // namespace glint
