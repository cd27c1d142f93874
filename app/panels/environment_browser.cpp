#include "app/panels/environment_browser.h"

#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "renderer/environment.h"
#include "renderer/gl/gl.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 4;   // the generated ones are one row
constexpr float kPictureWidth = 128, kPictureHeight = 64, kPadding = 5;   // UI units

bool isFile(const std::string& environment) {
  const auto names = environmentNames();
  return std::find(names.begin(), names.end(), environment) == names.end();
}

// "studio" as "Studio"; a file by its name.
std::string titleOf(const std::string& environment) {
  if (isFile(environment)) return fs::path(environment).filename().string();
  std::string title = environment;
  title[0] = char(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::string detailOf(const std::string& name, const EnvironmentThumbnailPtr& thumbnail) {
  if (!isFile(name)) return name == "none" ? "Lights only" : "Generated";
  if (!thumbnail) return "Loading\u2026";
  if (!thumbnail->fault.empty()) return "Cannot be read";
  return fmt::format("{} \u00d7 {}", thumbnail->inFile.width, thumbnail->inFile.height);
}

void enlarged(const std::string& name, const EnvironmentThumbnailPtr& thumbnail, unsigned texture) {
  const float width = theme::px(float(EnvironmentThumbnails::kWidth));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(9), theme::px(8)});
  ImGui::BeginTooltip();
  if (texture) ImGui::Image(imguiTexture(texture), {width, width / 2});
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::TextUnformatted(titleOf(name).c_str());
  if (thumbnail && !thumbnail->fault.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kError);
    ImGui::TextUnformatted(thumbnail->fault.c_str());
    ImGui::PopStyleColor();
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextDim);
    ImGui::TextUnformatted(detailOf(name, thumbnail).c_str());
    ImGui::PopStyleColor();
    if (thumbnail && !thumbnail->notes.empty()) {
      ImGui::PushStyleColor(ImGuiCol_Text, theme::kWarning);
      ImGui::TextUnformatted(thumbnail->notes.c_str());
      ImGui::PopStyleColor();
    }
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace

void EnvironmentBrowser::opened(Editor& editor, const std::string& environment) {
  std::string& remembered = editor.session().environmentFolder;
  if (isFile(environment)) remembered = fs::path(environment).parent_path().string();
  std::vector<fs::path> folders;
  if (!remembered.empty()) folders.emplace_back(remembered);
  if (!editor.configFolder().empty()) folders.push_back(editor.configFolder() / "environments");
  editor.environmentThumbnails().open(std::move(folders));
}

unsigned EnvironmentBrowser::textureOf(const std::string& name, const EnvironmentThumbnailPtr& thumbnail) {
  if (!thumbnail || thumbnail->picture.empty()) return 0;
  Shown& shown = shown_[name];
  if (shown.thumbnail != thumbnail) {
    const Image8& picture = thumbnail->picture;
    shown.thumbnail = thumbnail;
    shown.texture = gl::createTexture2D(GL_RGB8, picture.width, picture.height);
    glTextureParameteri(shown.texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(shown.texture.id(), 0, 0, 0, picture.width, picture.height, GL_RGB, GL_UNSIGNED_BYTE, picture.data.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  }
  return shown.texture.id();
}

bool EnvironmentBrowser::cell(const std::string& name, const EnvironmentThumbnailPtr& thumbnail, bool selected) {
  const float pad = theme::px(kPadding), width = theme::px(kPictureWidth), height = theme::px(kPictureHeight);
  ImFont *regular = ImGui::GetFont(), *small = ui::fonts().small();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size = {width + 2 * pad, height + 3 * pad + regular->FontSize + small->FontSize};
  const bool broken = thumbnail && !thumbnail->fault.empty();
  const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
  const bool hovered = ImGui::IsItemHovered();
  ui::mark("environment:" + (isFile(name) ? fs::path(name).filename().string() : name));
  if (broken) ui::markRect("broken:" + fs::path(name).filename().string(), low, {low.x + size.x, low.y + size.y});
  if (!ImGui::IsRectVisible(low, {low.x + size.x, low.y + size.y})) return false;

  const unsigned texture = textureOf(name, thumbnail);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float round = theme::px(3);
  if (hovered || selected) list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, theme::grey(255, hovered ? 22 : 12), round);
  const ImVec2 from = {low.x + pad, low.y + pad}, to = {from.x + width, from.y + height};
  const ImVec2 middle = {(from.x + to.x) / 2, (from.y + to.y) / 2};
  if (texture) list.AddImageRounded(imguiTexture(texture), from, to, {0, 0}, {1, 1}, IM_COL32_WHITE, round);
  else list.AddRectFilled(from, to, theme::kField, round);
  if (broken) {
    const float r = theme::px(9), line = theme::px(2.5f);
    list.AddLine({middle.x - r, middle.y - r}, {middle.x + r, middle.y + r}, theme::kError, line);
    list.AddLine({middle.x - r, middle.y + r}, {middle.x + r, middle.y - r}, theme::kError, line);
  } else if (!thumbnail) {
    for (int i = -1; i <= 1; ++i) list.AddCircleFilled({middle.x + float(i) * theme::px(9), middle.y}, theme::px(2), theme::kTextFaint);
  }
  if (selected) list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, theme::kAccent, round, 0, theme::px(2));
  if (thumbnail && !thumbnail->notes.empty()) list.AddCircleFilled({to.x - theme::px(8), from.y + theme::px(8)}, theme::px(4), theme::kWarning);
  const float top = to.y + pad;
  const std::string title = ui::elided(titleOf(name), width, regular), detail = detailOf(name, thumbnail);
  list.AddText(regular, regular->FontSize, {from.x, std::round(top)}, selected ? theme::kAccent : theme::kText, title.c_str());
  list.AddText(small, small->FontSize, {from.x, std::round(top + regular->FontSize)}, broken ? theme::kError : theme::kTextDim, detail.c_str());
  if (hovered) enlarged(name, thumbnail, texture);
  return pressed && !broken;
}

bool EnvironmentBrowser::draw(Editor& editor, std::string& environment) {
  const float gap = theme::px(4), cellWidth = theme::px(kPictureWidth + 2 * kPadding);
  const float width = kColumns * cellWidth + (kColumns - 1) * gap + ImGui::GetStyle().ScrollbarSize + 2 * ImGui::GetStyle().WindowPadding.x;
  const float height = std::min(theme::px(480), ImGui::GetIO().DisplaySize.y * 0.6f);
  ImGui::SetNextWindowSizeConstraints({width, height}, {width, height});
  const bool open = ImGui::BeginCombo("##map", titleOf(environment).c_str());
  if (!open) ui::mark("Map");
  if (open != open_) {
    open_ = open;
    if (open) {
      opened(editor, environment);
    } else {
      editor.environmentThumbnails().close();
      shown_.clear();
    }
  }
  if (!open) return false;
  bool changed = false;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  const std::string& folder = editor.session().environmentFolder;
  const float button = theme::px(96);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x - button - theme::px(8);
  ui::elidedText({at.x + theme::px(kPadding), at.y + (ImGui::GetFrameHeight() - ImGui::GetFontSize()) / 2}, room, theme::kTextDim,
                 folder.empty() ? "Load or drop a file to see its folder" : folder);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room + theme::px(8));
  if (ui::button("Load a file\u2026", false, button)) {
    editor.browseEnvironment();
    ImGui::CloseCurrentPopup();
  }
  ImGui::BeginChild("environments");
  const auto names = editor.environmentThumbnails().names();
  int column = 0;
  for (size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    // Files begin a row of their own.
    if (isFile(name) && i > 0 && !isFile(names[i - 1])) {
      column = 0;
      ImGui::Dummy({0, theme::px(2)});
    }
    if (column > 0) ImGui::SameLine();
    column = (column + 1) % kColumns;
    if (cell(name, editor.environmentThumbnails().find(name), name == environment) && name != environment) {
      environment = name;
      changed = true;
      ImGui::CloseCurrentPopup();
    }
  }
  if (const size_t left = editor.environmentThumbnails().left(); left > 0) {
    ImGui::Dummy({0, theme::px(4)});
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + theme::px(kPadding));
    ui::textDim(fmt::format("The first {} files are shown; {} more are in the folder: load or drop one.", EnvironmentThumbnails::kMostFiles, left));
    ui::mark("more files");
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::EndCombo();
  return changed;
}

}  // namespace glint
