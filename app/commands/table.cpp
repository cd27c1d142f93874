// Every command of `glint`, in the order of its help.
#include "app/command.h"

namespace glint {

extern const Command kDiffCommand;
extern const Command kInfoCommand;
extern const Command kModelsCommand;
extern const Command kNewModelCommand;

std::span<const Command* const> commands() {
  static const Command* const table[] = {
      &kDiffCommand,
      &kModelsCommand,
      &kNewModelCommand,
      &kInfoCommand,
  };
  return table;
}

}  // namespace glint
