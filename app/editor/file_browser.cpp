#include "app/editor/file_browser.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/editor/keys.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string sizeText(uintmax_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + " B";
  if (bytes < 1024 * 1024) return std::to_string((bytes + 512) / 1024) + " KiB";
  return std::to_string((bytes + 524288) / 1048576) + " MiB";
}

}  // namespace

void FileBrowser::open(Request request) {
  request_ = std::move(request);
  name_ = request_.name;
  filter_.clear();
  overwrite_.clear();
  open_ = appearing_ = true;
  list();
}

void FileBrowser::setFolder(const fs::path& folder) {
  std::error_code problem;
  if (!fs::is_directory(folder, problem)) return;
  const fs::path whole = fs::canonical(folder, problem);
  if (!problem) folder_ = whole;
  list();
}

void FileBrowser::list() {
  entries_.clear();
  problem_.clear();
  path_ = folder_.string();
  std::error_code problem;
  for (fs::directory_iterator it(folder_, fs::directory_options::skip_permission_denied, problem), end;
       !problem && it != end; it.increment(problem)) {
    if (entries_.size() >= 20000) {
      problem_ = "only the first 20000 entries are listed";
      break;
    }
    std::error_code ignored;
    Entry entry{.name = it->path().filename().string(), .folder = it->is_directory(ignored)};
    if (entry.name.empty() || entry.name[0] == '.') continue;
    if (!entry.folder) {
      const std::string extension = lower(it->path().extension().string());
      if (!request_.extensions.empty() &&
          std::find(request_.extensions.begin(), request_.extensions.end(), extension) == request_.extensions.end())
        continue;
      entry.size = it->file_size(ignored);
      if (ignored) entry.size = 0;
    }
    entries_.push_back(std::move(entry));
  }
  if (problem) problem_ = problem.message();
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    if (a.folder != b.folder) return a.folder;
    return lower(a.name) < lower(b.name);
  });
}

void FileBrowser::choose(const fs::path& file) {
  fs::path target = file;
  std::error_code ignored;
  if (request_.saving) {
    if (target.extension().empty() && !request_.extensions.empty()) target += request_.extensions.front();
    if (fs::exists(target, ignored) && overwrite_ != target) {
      overwrite_ = target;
      return;
    }
  } else if (!fs::is_regular_file(target, ignored)) {
    problem_ = "no such file: " + target.filename().string();
    return;
  }
  open_ = false;
  ImGui::CloseCurrentPopup();
  request_.chosen(target);
}

void FileBrowser::draw() {
  if (!open_) return;
  const std::string id = request_.title + "###file-browser";
  const bool appearing = std::exchange(appearing_, false);
  if (appearing) ImGui::OpenPopup(id.c_str());
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 size = {std::min(theme::px(720), display.x * 0.92f), std::min(theme::px(500), display.y * 0.9f)};
  ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos({(display.x - size.x) / 2, (display.y - size.y) / 2}, ImGuiCond_Appearing);
  bool keep = true;
  if (!ImGui::BeginPopupModal(id.c_str(), &keep, ImGuiWindowFlags_NoSavedSettings)) {
    open_ = false;
    return;
  }
  ui::pushScope("Files");
  if (ui::button("Up")) setFolder(folder_.parent_path());
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - theme::px(170));
  if (ImGui::InputText("##folder", &path_, ImGuiInputTextFlags_EnterReturnsTrue)) {
    std::error_code ignored;
    if (fs::is_directory(path_, ignored)) setFolder(path_);
    else if (!request_.saving) choose(path_);
  }
  ui::mark("folder");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::InputTextWithHint("##filter", "Filter", &filter_);
  ui::mark("filter");

  const float below = ImGui::GetFrameHeightWithSpacing() * (request_.saving ? 2.0f : 1.0f) + theme::px(8) +
                      (problem_.empty() && overwrite_.empty() ? 0 : ImGui::GetTextLineHeightWithSpacing());
  ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kField);
  ImGui::BeginChild("entries", {0, -below});
  const std::string wanted = lower(filter_);
  fs::path enter, pick;
  for (const Entry& entry : entries_) {
    if (!wanted.empty() && lower(entry.name).find(wanted) == std::string::npos) continue;
    const bool selected = !entry.folder && entry.name == name_;
    if (ui::row(entry.name, entry.folder ? entry.name + "/" : entry.name, entry.folder ? "folder" : sizeText(entry.size),
                selected)) {
      if (entry.folder) {
        if (ImGui::IsMouseDoubleClicked(0)) enter = folder_ / entry.name;
      } else {
        name_ = entry.name;
        overwrite_.clear();
        if (ImGui::IsMouseDoubleClicked(0)) pick = folder_ / entry.name;
      }
    }
  }
  if (entries_.empty() && problem_.empty()) ui::textDim("Nothing to open here.");
  ImGui::EndChild();
  ImGui::PopStyleColor();
  if (!enter.empty()) setFolder(enter);

  if (!overwrite_.empty())
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(theme::kWarning), "%s exists: save again to replace it",
                       overwrite_.filename().string().c_str());
  else if (!problem_.empty())
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(theme::kWarning), "%s", problem_.c_str());
  bool done = false;
  if (request_.saving) {
    ImGui::AlignTextToFramePadding();
    ui::textDim("Name");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    // What is suggested is typed over, or taken with Enter.
    if (appearing) ImGui::SetKeyboardFocusHere();
    done = ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ui::mark("name");
  }
  const float width = theme::px(96);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * width - ImGui::GetStyle().ItemSpacing.x -
                       ImGui::GetStyle().WindowPadding.x);
  if (ui::button("Cancel", false, width) || keyPressed(Key::Escape)) keep = false;
  ImGui::SameLine();
  ImGui::BeginDisabled(name_.empty());
  done |= ui::button(request_.saving ? (overwrite_.empty() ? "Save" : "Replace") : "Open", true, width);
  ImGui::EndDisabled();
  // Enter outside of the fields, as after the question whether to replace.
  done |= !appearing && !ImGui::GetIO().WantTextInput && keyPressed(Key::Enter);
  if (!pick.empty()) choose(pick);
  else if (done && !name_.empty()) choose(folder_ / name_);
  if (!keep) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  ui::popScope();
  ImGui::EndPopup();
}

}  // namespace glint
