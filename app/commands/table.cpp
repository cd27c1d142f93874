// Every command of `glint`, in the order of its help.
#include "app/command.h"

namespace glint {

extern const Command kBenchCommand;
extern const Command kCompareCommand;
extern const Command kCompileCommand;
extern const Command kDiffCommand;
extern const Command kEditCommand;
extern const Command kEvalCommand;
extern const Command kFiguresCommand;
extern const Command kInfoCommand;
extern const Command kModelsCommand;
extern const Command kVerifyCommand;
extern const Command kNewModelCommand;
extern const Command kNodesCommand;
extern const Command kRenderCommand;

std::span<const Command* const> commands() {
  static const Command* const table[] = {
      &kRenderCommand,
      &kCompareCommand,
      &kFiguresCommand,
      &kEditCommand,
      &kDiffCommand,
      &kModelsCommand,
      &kVerifyCommand,
      &kEvalCommand,
      &kNodesCommand,
      &kNewModelCommand,
      &kCompileCommand,
      &kBenchCommand,
      &kInfoCommand,
  };
  return table;
}

}  // namespace glint
