#include "app/editor/node_menu.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/editor/keys.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"

namespace glint {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

// 0: no match; more is better.
int score(const NodeKind& kind, const std::string& wanted) {
  const std::string title = lower(kind.title);
  if (title == wanted || kind.id == wanted) return 6;
  if (title.rfind(wanted, 0) == 0) return 5;
  for (const std::string& word : kind.keywords)
    if (lower(word).rfind(wanted, 0) == 0) return 4;
  if (title.find(wanted) != std::string::npos) return 3;
  if (kind.id.find(wanted) != std::string::npos) return 2;
  if (lower(kind.category).find(wanted) != std::string::npos) return 1;
  return 0;
}

}  // namespace

void NodeMenu::open(std::function<bool(const NodeKind&)> fits) {
  fits_ = std::move(fits);
  search_.clear();
  at_ = 0;
  open_ = appearing_ = true;
}

const NodeKind* NodeMenu::draw(const NodeRegistry& registry) {
  if (!open_) return nullptr;
  const bool appearing = std::exchange(appearing_, false);
  if (appearing) ImGui::OpenPopup("add-node");
  ImGui::SetNextWindowSize({theme::px(270), theme::px(380)});
  if (!ImGui::BeginPopup("add-node")) {
    open_ = false;
    return nullptr;
  }
  ui::pushScope("Add");
  if (appearing) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (ImGui::InputTextWithHint("##search", "Search nodes", &search_)) at_ = 0;
  ui::mark("search");

  const std::string wanted = lower(search_);
  std::vector<std::pair<int, const NodeKind*>> found;
  for (const NodeKind* kind : registry.all()) {
    if (kind->builtin == Builtin::Output || (fits_ && !fits_(*kind))) continue;
    const int s = wanted.empty() ? 1 : score(*kind, wanted);
    if (s) found.emplace_back(s, kind);
  }
  if (!wanted.empty())
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });

  const int count = int(found.size());
  if (keyPressed(Key::Down, true)) at_ = std::min(at_ + 1, count - 1);
  if (keyPressed(Key::Up, true)) at_ = std::max(at_ - 1, 0);
  const bool moved = keyPressed(Key::Down, true) || keyPressed(Key::Up, true);
  const NodeKind* chosen = nullptr;
  ImGui::BeginChild("kinds");
  std::string category;
  for (int i = 0; i < count; ++i) {
    const NodeKind& kind = *found[size_t(i)].second;
    if (wanted.empty() && kind.category != category) {
      category = kind.category;
      ImGui::Dummy({0, theme::px(3)});
      ui::textSmall(category);
    }
    if (ui::row(kind.id, kind.title, wanted.empty() ? "" : kind.category, i == at_)) chosen = &kind;
    ui::tooltip(kind.doc);
    if (moved && i == at_) ImGui::SetScrollHereY();
  }
  if (found.empty()) ui::textDim("No such node.");
  ImGui::EndChild();
  if (!chosen && count > 0 && keyPressed(Key::Enter)) chosen = found[size_t(std::clamp(at_, 0, count - 1))].second;
  if (chosen || keyPressed(Key::Escape)) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  ui::popScope();
  ImGui::EndPopup();
  return chosen;
}

}  // namespace glint
