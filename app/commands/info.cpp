// glint info: what OpenGL this machine gave, and the folders in use.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "materials/base/files.h"
#include "materials/base/log.h"
#include "renderer/gl/gl.h"

namespace glint {
namespace {

using nlohmann::ordered_json;

struct Limit {
  const char* name;
  GLenum query;
};
// What bounds the pictures, graphs and models that can be drawn here.
constexpr Limit kLimits[] = {
    {"maxTextureSize", GL_MAX_TEXTURE_SIZE},
    {"maxCubeMapSize", GL_MAX_CUBE_MAP_TEXTURE_SIZE},
    {"maxFramebufferWidth", GL_MAX_FRAMEBUFFER_WIDTH},
    {"maxColorAttachments", GL_MAX_COLOR_ATTACHMENTS},
    {"maxTextureUnits", GL_MAX_TEXTURE_IMAGE_UNITS},
    {"maxUniformBlockBytes", GL_MAX_UNIFORM_BLOCK_SIZE},
    {"maxTextureBufferTexels", GL_MAX_TEXTURE_BUFFER_SIZE},
    {"maxComputeGroupSize", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS},
};

ordered_json limits() {
  ordered_json found = ordered_json::object();
  for (const Limit& limit : kLimits) {
    GLint value = 0;
    glGetIntegerv(limit.query, &value);
    found[limit.name] = value;
  }
  return found;
}

// What is done otherwise than on a GPU, or for all because some driver needs it, and why.
ordered_json workarounds(const gl::Context::Info& info) {
  ordered_json list = {"lists of lights are read from texture buffers: software rasterisers read storage buffers pixel by pixel",
                       "patterns have no loops: a dozen in one shader keep LLVM from ending"};
  if (info.software) list.push_back("the editor stops refining a still picture early: every sample is paid by the processor");
  return list;
}

int run(const Arguments& arguments) {
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  const gl::Context::Info& info = (*context)->info();
  const ordered_json document = {{"glint", GLINT_VERSION},
                                 {"backend", gl::name((*context)->backend())},
                                 {"vendor", info.vendor},
                                 {"renderer", info.renderer},
                                 {"version", info.version},
                                 {"glsl", info.glsl},
                                 {"software", info.software},
                                 {"limits", limits()},
                                 {"workarounds", workarounds(info)},
                                 {"cache", cacheFolder().string()},
                                 {"configuration", configFolder().string()}};
  if (arguments.json) {
    fmt::print("{}\n", document.dump(2, ' ', false, ordered_json::error_handler_t::replace));
    return kDone;
  }
  const auto text = [](const ordered_json& value) { return value.is_string() ? value.get<std::string>() : value.is_boolean() ? (value.get<bool>() ? "yes" : "no") : value.dump(); };
  for (const auto& [key, value] : document.items()) {
    if (!value.is_structured()) fmt::print("{:<24}{}\n", key, text(value));
    else
      for (const auto& [name, part] : value.items()) fmt::print("{:<24}{}\n", value.is_array() ? key : name, text(part));
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
