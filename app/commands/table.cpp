// Every command of `glint`, in the order of its help.
#include "app/command.h"

namespace glint {

extern const Command kCompileCommand;
extern const Command kDiffCommand;
extern const Command kInfoCommand;
extern const Command kModelsCommand;
extern const Command kNewModelCommand;
extern const Command kNodesCommand;

std::span<const Command* const> commands() {
  static const Command* const table[] = {
      &kDiffCommand,
      &kModelsCommand,
      &kNodesCommand,
      &kNewModelCommand,
      &kCompileCommand,
      &kInfoCommand,
  };
  return table;
}

}  // namespace glint
