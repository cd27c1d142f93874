#include "app/editor/plugin_saver.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/editor/keys.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "materials/base/files.h"

namespace glint {
namespace fs = std::filesystem;
namespace {

// "GGX*SmithGGX*Schlick" -> "ggx-smithggx-schlick", with a number when that is taken.
std::string suggestedId(const ModelMix& mix, const ModelRegistry& registry) {
  std::string id = mix.id();
  std::transform(id.begin(), id.end(), id.begin(), [](unsigned char c) { return c == '*' ? '-' : char(std::tolower(c)); });
  std::string free = id;
  for (int i = 2; registry.find(free); ++i) free = id + "-" + std::to_string(i);
  return free;
}

}  // namespace

std::string pluginRefusal(const std::string& id, const fs::path& folder, const ModelRegistry& registry) {
  if (id.empty()) return "Give it an id: " + std::string(kModelIdRule);
  if (!isModelId(id)) return "No id for a model; it may have " + std::string(kModelIdRule);
  if (const ModelPtr taken = registry.find(id)) return "Taken by " + taken->title + (taken->file.has_parent_path() ? ", " + taken->file.string() : "");
  const fs::path file = folder / (id + ".glsl");
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored))) return file.string() + " is there already";
  return {};
}

void PluginSaver::open(const ModelMix& mix, const std::map<std::string, float>& values, const ModelRegistry& registry) {
  mix_ = mix;
  values_ = values;
  id_ = suggestedId(mix, registry);
  problem_.clear();
  folders_.clear();
  for (const fs::path& folder : registry.folders()) folders_.push_back(folder.string());
  folder_ = int(folders_.size()) - 1;  // the user's own
  asked_ = appearing_ = true;
}

std::optional<std::string> PluginSaver::draw(const ModelRegistry& registry) {
  std::optional<std::string> written;
  if (!ui::beginQuestion("Save as plugin", asked_)) return written;
  const float width = theme::px(104);
  ui::textDim("A short file that names the terms. It is listed like any other model; verify says which laws it keeps.");
  ImGui::Dummy({0, theme::px(6)});
  ui::beginProperty("Id", "What files, materials and command lines call it");
  if (std::exchange(appearing_, false)) ImGui::SetKeyboardFocusHere();
  if (ImGui::InputText("##id", &id_, ImGuiInputTextFlags_AutoSelectAll)) problem_.clear();
  ui::mark("plugin id");
  ui::endProperty();
  ui::beginProperty("Folder", "The folders that plugins are read from");
  ui::choice("plugin folder", folder_, folders_);
  ui::tooltip(folders_[size_t(folder_)]);
  ui::endProperty();
  const fs::path folder = folders_[size_t(folder_)];
  const std::string refusal = pluginRefusal(id_, folder, registry);
  ImGui::Dummy({0, theme::px(2)});
  ImGui::PushStyleColor(ImGuiCol_Text, refusal.empty() && problem_.empty() ? theme::kTextDim : theme::kError);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(!problem_.empty() ? problem_.c_str() : !refusal.empty() ? refusal.c_str() : (folder / (id_ + ".glsl")).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  if (!refusal.empty()) ui::mark("plugin refused");
  ImGui::Dummy({0, theme::px(8)});
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ImGui::GetStyle().ItemSpacing.x - theme::px(18));
  if (ui::button("Cancel", false, width) || keyPressed(Key::Escape)) ImGui::CloseCurrentPopup();
  ImGui::SameLine();
  ImGui::BeginDisabled(!refusal.empty());
  const bool save = ui::button("Save", true, width) || (keyPressed(Key::Enter) && refusal.empty());
  ImGui::EndDisabled();
  if (save) {
    std::error_code code;
    fs::create_directories(folder, code);
    const Diagnostics faults = code ? Diagnostics{error(folder.string(), "cannot be made: " + code.message())}
                                    : writeFileAtomic(folder / (id_ + ".glsl"), pluginOfMix(mix_, id_, values_));
    if (faults.empty()) {
      written = id_;
      ImGui::CloseCurrentPopup();
    } else {
      problem_ = faults[0].text();
    }
  }
  ImGui::EndPopup();
  return written;
}

}  // namespace glint
