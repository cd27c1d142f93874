// The editor's frame around the panels: menu, shortcuts, status bar, questions.
#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "app/editor/editor.h"
#include "app/editor/keys.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

bool item(const char* label, const char* keys = nullptr, bool enabled = true, bool checked = false) {
  const bool chosen = ImGui::MenuItem(label, keys, checked, enabled);
  ui::mark(label);
  return chosen;
}

bool menu(const char* label) {
  const bool open = ImGui::BeginMenu(label);
  if (!open) ui::mark(label);
  return open;
}

}  // namespace

// Escape closes the topmost menu, list or picker; questions and dialogs look for it themselves.
static void closePopupOnEscape() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!keyPressed(Key::Escape) || context.OpenPopupStack.empty()) return;
  const ImGuiWindow* top = context.OpenPopupStack.back().Window;
  if (top && !(top->Flags & ImGuiWindowFlags_Modal)) ImGui::ClosePopupToLevel(context.OpenPopupStack.Size - 1, true);
}

void Editor::handleShortcuts() {
  closePopupOnEscape();
  if (files_.isOpen()) return;
  if (shortcut(kControl, Key::Z, true)) document_->undo();
  if (shortcut(kControlShift, Key::Z, true) || shortcut(kControl, Key::Y, true)) document_->redo();
  if (fileShortcut(kControl, Key::S)) save();
  if (fileShortcut(kControlShift, Key::S)) saveAs(document_->isProject());
  if (fileShortcut(kControl, Key::O)) openDocument();
  if (fileShortcut(kControl, Key::N)) newDocument();
  if (fileShortcut(kControl, Key::Q)) requestQuit();
  if (shortcut(kNoModifiers, Key::F1)) keysOpen_ = true;
}

void Editor::drawMenu() {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme::px(14), theme::px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ui::pushScope("Menu");
  if (ImGui::BeginMainMenuBar()) {
    if (menu("File")) {
      if (item("New", "Ctrl+N")) newDocument();
      if (item("Open\u2026", "Ctrl+O")) openDocument();
      if (ImGui::BeginMenu("Open recent", !session_.recent.empty())) {
        std::string chosen;
        for (const std::string& file : session_.recent)
          if (ImGui::MenuItem(file.c_str())) chosen = file;
        ImGui::EndMenu();
        if (!chosen.empty()) openFile(chosen);
      }
      ImGui::Separator();
      if (item("Save", "Ctrl+S")) save();
      if (item("Save as\u2026", "Ctrl+Shift+S")) saveAs(false);
      if (item("Save project as\u2026")) saveAs(true);
      ImGui::Separator();
      if (item("Recover unsaved work\u2026")) offerRecovery(true);
      ImGui::Separator();
      if (item("Load mesh\u2026")) browseMesh();
      if (item("Load environment\u2026")) browseEnvironment();
      ImGui::Separator();
      if (item("Quit", "Ctrl+Q")) requestQuit();
      ImGui::EndMenu();
    }
    if (menu("Edit")) {
      const auto& steps = document_->steps();
      const size_t at = document_->position();
      const std::string undo = at ? "Undo " + steps[at - 1].label : "Undo", redo = at < steps.size() ? "Redo " + steps[at].label : "Redo";
      if (ImGui::MenuItem((undo + "###undo").c_str(), "Ctrl+Z", false, document_->canUndo())) document_->undo();
      ui::mark("Undo");
      if (ImGui::MenuItem((redo + "###redo").c_str(), "Ctrl+Shift+Z", false, document_->canRedo())) document_->redo();
      ui::mark("Redo");
      ImGui::EndMenu();
    }
    if (menu("View")) {
      for (const PanelInfo& info : panelTable()) {
        const bool on = layout_.shown(info.title);
        if (item(info.title, nullptr, true, on)) {
          if (on && layout_.visible(info.title)) layout_.hide(info.title);
          else layout_.show(info.title);
        }
      }
      ImGui::Separator();
      if (item("Frame subject", "F")) frameSubject();
      if (item("Frame lights", "Shift+F")) frameLights();
      if (item("Lights in the viewport", "L", true, session_.lightGizmos)) showLights(!session_.lightGizmos);
      if (item("Reset layout")) layout_.reset();
      ImGui::EndMenu();
    }
    if (menu("Help")) {
      if (item("Keys and mouse", "F1")) keysOpen_ = true;
      if (item("About Glint")) aboutOpen_ = true;
      ImGui::EndMenu();
    }
    // The document's name in the middle, where a glance finds it.
    const std::string title = document_->title();
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    const float x = std::round((ImGui::GetIO().DisplaySize.x - width) / 2);
    if (x > ImGui::GetCursorPosX()) {
      ImGui::SetCursorPosX(x);
      ui::textDim(title);
    }
    ImGui::EndMainMenuBar();
  }
  ui::popScope();
  ImGui::PopStyleVar(2);
}

void Editor::drawStatus(ImVec2 low, ImVec2 high) {
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize({high.x - low.x, high.y - low.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(10), theme::px(3)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::kHeader);
  ImGui::Begin("##status", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(4);
  ImGui::PushFont(fonts_.small());

  const auto progress = render_->progress();
  const bool told = !message_.empty() && time_ < messageUntil_;
  if (progress && render_->working() && !(told && messageWrong_)) {
    const float width = theme::px(120), height = theme::px(4);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + ImGui::GetFontSize() / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x, y - height / 2}, {at.x + width, y + height / 2}, theme::kField, height / 2);
    list.AddRectFilled({at.x, y - height / 2}, {at.x + width * float(std::clamp(progress->fraction, 0.02, 1.0)), y + height / 2},
                       theme::kAccent, height / 2);
    ImGui::Dummy({width + theme::px(8), ImGui::GetFontSize()});
    ImGui::SameLine(0, 0);
    ui::textDim(progress->what);
  } else if (told) {
    ImGui::PushStyleColor(ImGuiCol_Text, messageWrong_ ? theme::kError : theme::kText);
    ImGui::TextUnformatted(message_.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemClicked()) message_.clear();
    ui::mark("message");
  } else {
    ui::textDim(selection_.empty() ? "Ready" : std::to_string(selection_.size()) + (selection_.size() == 1 ? " node selected" : " nodes selected"));
  }

  const FrameResult& frame = shown();
  char facts[256];
  std::snprintf(facts, sizeof facts, "%d \u00d7 %d    %d triangles    %.0f ms    %d sample%s    %s", frame.size.x, frame.size.y,
                frame.statistics.triangles, frame.milliseconds, frame.samples, frame.samples == 1 ? "" : "s",
                context_.info().renderer.c_str());
  const float width = ImGui::CalcTextSize(facts).x;
  const float x = ImGui::GetWindowWidth() - width - theme::px(10);
  ImGui::SameLine();
  if (frame.serial && x > ImGui::GetCursorPosX() + theme::px(12)) {
    ImGui::SetCursorPosX(x);
    ui::textDim(facts);
  }
  ImGui::PopFont();
  ImGui::End();
}

// What ended without saving, newest first; each is decided by itself, and what is not decided is asked again later.
void Editor::drawRecoverable() {
  const float width = theme::px(84), gap = ImGui::GetStyle().ItemSpacing.x;
  ui::textDim("Glint ended without saving this. What is not recovered or discarded now is offered again at the next start, and under File.");
  ImGui::Dummy({0, theme::px(4)});
  const float each = 3 * ImGui::GetTextLineHeightWithSpacing() + theme::px(6);
  const float room = std::min(each * float(recoverable_.size()), ImGui::GetIO().DisplaySize.y * 0.45f);
  ImGui::BeginChild("records", {0, room});
  std::optional<size_t> decided;
  for (size_t i = 0; i < recoverable_.size(); ++i) {
    const Journal::Record& record = recoverable_[i];
    const std::string number = std::to_string(i);
    ImGui::PushID(int(i));
    const ImVec2 at = ImGui::GetCursorPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    ImGui::PushTextWrapPos(right - 2 * width - 2 * gap);
    ImGui::TextUnformatted(record.name.c_str());
    const std::time_t time = std::chrono::system_clock::to_time_t(record.time);
    std::tm local{};
    localtime_r(&time, &local);
    char when[32] = "";
    std::strftime(when, sizeof when, "%Y-%m-%d %H:%M", &local);
    const std::string file = record.file.empty() ? "never saved" : std::filesystem::path(record.file).filename().string();
    ImGui::PushStyleColor(ImGuiCol_Text, theme::kTextDim);
    ImGui::TextUnformatted((std::string(when) + "  \u00b7  " + file).c_str());
    if (!record.file.empty()) ui::tooltip(record.file);
    const std::string edits = std::to_string(record.steps) + (record.steps == 1 ? " edit" : " edits");
    ImGui::TextUnformatted((record.label.empty() ? edits : edits + ", the last \u201c" + record.label + "\u201d").c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    const ImVec2 below = ImGui::GetCursorPos();
    ImGui::SetCursorPos({right - 2 * width - gap, at.y});
    const bool discarded = ui::button("Discard##" + number, false, width);
    ui::mark("Discard " + number);
    if (discarded) {
      Journal::discard(record.journal);
      decided = i;
    }
    ImGui::SameLine();
    const bool recovered = ui::button("Recover##" + number, true, width);
    ui::mark("Recover " + number);
    if (recovered) {
      afterAsking([this, record] { recover(record); });
      decided = i;
    }
    ImGui::SetCursorPos({below.x, std::max(below.y, at.y + each)});
    ImGui::PopID();
    if (decided) break;
  }
  ImGui::EndChild();
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width - theme::px(18));
  bool done = ui::button("Later", false, width) || keyPressed(Key::Escape);
  if (decided) {
    done |= pendingAction_ != nullptr || document_->modified();
    recoverable_.erase(recoverable_.begin() + std::ptrdiff_t(*decided));
  }
  if (done || recoverable_.empty()) ImGui::CloseCurrentPopup();
}

void Editor::drawDialogs() {
  ui::pushScope("Dialog");
  const float width = theme::px(104);
  if (ui::beginQuestion("Save your changes?", askOpen_)) {
    ui::textDim("\u201c" + document_->name() + "\u201d has changes that are not saved. They are lost if you go on without saving.");
    ImGui::Dummy({0, theme::px(8)});
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 3 * width - 2 * ImGui::GetStyle().ItemSpacing.x - theme::px(18));
    if (ui::button("Cancel", false, width) || keyPressed(Key::Escape)) {
      pendingAction_ = nullptr;
      ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ui::button("Don\u2019t save", false, width)) {
      ImGui::CloseCurrentPopup();
      if (auto action = std::exchange(pendingAction_, nullptr)) action();
    }
    ImGui::SameLine();
    if (ui::button("Save", true, width)) {
      ImGui::CloseCurrentPopup();
      save(std::exchange(pendingAction_, nullptr));
    }
    ImGui::EndPopup();
  }

  if (ui::beginQuestion("Recover unsaved work?", recoverOpen_)) {
    drawRecoverable();
    ImGui::EndPopup();
  }

  if (ui::beginQuestion("Keys and mouse", keysOpen_)) {
    static constexpr std::pair<const char*, const char*> kKeys[] = {
        {"Undo, redo", "Ctrl+Z, Ctrl+Shift+Z or Ctrl+Y"},
        {"New, open, save, save as", "Ctrl+N, Ctrl+O, Ctrl+S, Ctrl+Shift+S"},
        {"Orbit", "drag with the left or middle button"},
        {"Pan", "drag with the right button, or Shift and middle"},
        {"Move closer, field of view", "wheel (over a comparison: about the pointer), Ctrl+wheel"},
        {"Turn the environment", "Shift and right button, or Ctrl and left"},
        {"Frame the subject, the graph", "F over the viewport, F or Home over the graph"},
        {"Frame lights, show or hide them", "Shift+F, L over the viewport"},
        {"Move, aim, size a light", "click it, drag its handles; Ctrl: round numbers, Shift: along one axis, Esc: back"},
        {"The same without a button", "G moves (then X, Y, Z), R turns, S sizes; a click or Enter ends it"},
        {"Aim, put its highlight", "T, H: where the pointer is on a surface"},
        {"Add a node", "Tab, Space or a right click on the canvas; drop a wire"},
        {"Connect", "drag from pin to pin"},
        {"Disconnect", "Alt+click a pin or wire; Ctrl and right button cuts"},
        {"Reroute", "double-click a wire"},
        {"Delete, duplicate", "Del or X, Ctrl+D: nodes, or the light over the viewport"},
        {"Cut, copy, paste", "Ctrl+X, Ctrl+C, Ctrl+V"},
        {"Select all, comment", "Ctrl+A, C"},
        {"Type into a slider", "Ctrl+click; double-click its name to reset"},
    };
    if (ImGui::BeginTable("keys", 2)) {
      for (const auto& [what, how] : kKeys) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(what);
        ImGui::TableNextColumn();
        ui::textDim(how);
      }
      ImGui::EndTable();
    }
    ImGui::Dummy({0, theme::px(6)});
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width - theme::px(18));
    if (ui::button("Close", true, width) || keyPressed(Key::Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }

  if (ui::beginQuestion("About Glint", aboutOpen_)) {
    ui::textDim("A material editor that shows the difference between shading models.");
    ImGui::Dummy({0, theme::px(4)});
    ui::textSmall("Version " GLINT_VERSION "\nOpenGL " + context_.info().version + "\n" + context_.info().renderer);
    ImGui::Dummy({0, theme::px(6)});
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width - theme::px(18));
    if (ui::button("Close", true, width) || keyPressed(Key::Escape)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  files_.draw();
  drawPluginSaver();
  ui::popScope();
}

}  // namespace glint
