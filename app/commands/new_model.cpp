// glint new-model: a shading model to start from, as one commented file.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "materials/base/files.h"
#include "materials/base/log.h"
#include "materials/model_registry.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

void replaceAll(std::string& text, std::string_view what, const std::string& with) {
  for (size_t at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

// "two-lobe_ggx" -> "Two lobe ggx"
std::string titleOf(std::string id) {
  for (char& c : id)
    if (c == '-' || c == '_') c = ' ';
  id[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(id[0])));
  return id;
}

int run(const Arguments& arguments) {
  const std::string id = arguments.get("id");
  if (!isModelId(id))
    return badInput({error("'" + id + "'", "is no id for a shading model", kModelIdRule)});
  const ModelRegistry registry(arguments.modelFolders);
  if (const ModelPtr other = registry.find(id))
    return badInput({error("'" + id + "'", "is taken by " + other->file.string(), "choose another id")});
  const std::filesystem::path folder =
      arguments.modelFolders.empty() ? configFolder() / "models" : arguments.modelFolders.front();
  const std::filesystem::path file = folder / (id + ".glsl");
  std::error_code code;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, code)))
    return badInput({error(file.string(), "is there already", "choose another id, or remove the file")});
  std::filesystem::create_directories(folder, code);
  if (code) return badInput({error(folder.string(), "cannot be made: " + code.message(), "check its permissions")});
  auto text = shipped::read("shaders/templates/model.glsl");
  if (!text) return badInput({error("shaders/templates/model.glsl", "is missing", "reinstall Glint")});
  replaceAll(*text, "@ID@", id);
  replaceAll(*text, "@TITLE@", titleOf(id));
  if (const Diagnostics failed = writeFileAtomic(file, *text); !failed.empty()) return badInput(failed);
  if (arguments.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"id", id}, {"file", file.string()}}.dump(2));
  } else {
    fmt::print("{}\n", file.string());
    log::info(fmt::format("edit that file, then: glint compare --models ggx,{} -o {}.png", id, id));
  }
  return kDone;
}

}  // namespace

extern const Command kNewModelCommand;
const Command kNewModelCommand = {
    .name = "new-model",
    .summary = "Write a commented shading model to start from",
    .options = {{"id", "ID", "its id, which is also the file's name", false, true}},
    .examples = {"glint new-model two-lobe", "glint new-model two-lobe --models-dir my-models"},
    .run = run,
};

}  // namespace glint
