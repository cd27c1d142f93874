// Every command of `glint`, in the order of its help.
#include "app/command.h"

namespace glint {

extern const Command kDiffCommand;
extern const Command kInfoCommand;

std::span<const Command* const> commands() {
  static const Command* const table[] = {&kDiffCommand, &kInfoCommand};
  return table;
}

}  // namespace glint
