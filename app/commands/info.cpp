// glint info: what OpenGL this machine gave, and the folders in use.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "materials/base/files.h"
#include "materials/base/log.h"

namespace glint {
namespace {

int run(const Arguments& arguments) {
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  const gl::Context::Info& info = (*context)->info();
  const std::vector<std::pair<std::string, std::string>> facts = {
      {"glint", GLINT_VERSION},
      {"backend", std::string(gl::name((*context)->backend()))},
      {"vendor", info.vendor},
      {"renderer", info.renderer},
      {"version", info.version},
      {"glsl", info.glsl},
      {"software", info.software ? "yes" : "no"},
      {"maxTextureSize", std::to_string(info.maxTextureSize)},
      {"cache", cacheFolder().string()},
      {"configuration", configFolder().string()},
  };
  if (arguments.json) {
    nlohmann::ordered_json document;
    for (const auto& [key, value] : facts) document[key] = value;
    fmt::print("{}\n", document.dump(2));
  } else {
    for (const auto& [key, value] : facts) fmt::print("{:<16}{}\n", key, value);
  }
  return kDone;
}

}  // namespace

extern const Command kInfoCommand;
const Command kInfoCommand = {
    .name = "info",
    .summary = "Print what OpenGL gave: vendor, renderer, versions, limits, folders used",
    .options = {},
    .examples = {"glint info", "glint info --backend osmesa --json"},
    .run = run,
};

}  // namespace glint
