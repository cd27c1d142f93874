#include <CLI/CLI.hpp>

#include "app/command.h"
#include "materials/base/log.h"

namespace glint {
namespace {

std::string keyOf(const std::string& name) {
  const size_t comma = name.rfind(',');
  std::string longest = comma == std::string::npos ? name : name.substr(comma + 1);
  longest.erase(0, longest.find_first_not_of('-'));
  return longest;
}

}  // namespace

int badInput(const Diagnostics& diagnostics) {
  log::report(diagnostics);
  return kBadInput;
}

int runCommandLine(int argc, char** argv) {
  Arguments arguments;
  for (int i = 0; i < argc; ++i) arguments.commandLine += (i ? " " : "") + std::string(argv[i]);

  CLI::App app("Glint: author materials, compare and judge shading models", "glint");
  app.set_version_flag("--version", "glint " GLINT_VERSION);
  std::string backendName = "auto";
  std::vector<std::string> folders;
  const Command* chosen = nullptr;
  for (const Command* command : commands()) {
    CLI::App* sub = app.add_subcommand(command->name, command->summary);
    std::string footer = "Examples:\n";
    for (const std::string& example : command->examples) footer += "  " + example + "\n";
    sub->footer(footer);
    for (const Option& option : command->options) {
      std::vector<std::string>* values = &arguments.values[keyOf(option.name)];
      CLI::Option* added;
      if (option.argument.empty()) {
        added = sub->add_flag_callback(option.name, [values] { values->push_back("true"); }, option.help);
      } else {
        added = sub->add_option(option.name, *values, option.help)->type_name(option.argument);
        if (!option.repeatable) added->expected(1);
        else if (option.name[0] == '-') added->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
      }
      if (option.required) added->required();
    }
    sub->add_option("--backend", backendName, "auto, glfw, egl or osmesa");
    sub->add_option("--models-dir", folders, "a folder of shading models (repeatable)");
    sub->add_flag("--json", arguments.json, "exactly one JSON document on stdout");
    sub->add_flag("--quiet", arguments.quiet, "errors only");
    sub->callback([command, &chosen] { chosen = command; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e), kDone;
    return badInput({error("command line", e.what(), "glint --help lists what there is")});
  }
  log::setQuiet(arguments.quiet);
  std::erase_if(arguments.values, [](const auto& item) { return item.second.empty(); });
  const auto backend = gl::backend(backendName);
  if (!backend)
    return badInput({error("--backend", "unknown back end '" + backendName + "'", "auto, glfw, egl or osmesa")});
  arguments.backend = *backend;
  arguments.modelFolders.assign(folders.begin(), folders.end());
  if (!chosen) return badInput({error("command line", "no command", "glint --help lists them")});
  return chosen->run(arguments);
}

}  // namespace glint
