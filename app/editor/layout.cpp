#include "app/editor/layout.h"

#include <algorithm>
#include <cmath>

#include "app/editor/fonts.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"

namespace glint {
namespace {

using Node = Layout::Node;

std::unique_ptr<Node> leaf(std::vector<std::string> panels) {
  auto node = std::make_unique<Node>();
  node->panels = std::move(panels);
  return node;
}

std::unique_ptr<Node> split(bool stacked, float ratio, std::unique_ptr<Node> first, std::unique_ptr<Node> second) {
  auto node = std::make_unique<Node>();
  node->stacked = stacked;
  node->ratio = ratio;
  node->first = std::move(first);
  node->second = std::move(second);
  return node;
}

Node* leafOf(Node* node, const std::string& panel) {
  if (!node) return nullptr;
  if (node->leaf())
    return std::find(node->panels.begin(), node->panels.end(), panel) == node->panels.end() ? nullptr : node;
  Node* found = leafOf(node->first.get(), panel);
  return found ? found : leafOf(node->second.get(), panel);
}

void removePanel(Node& leaf, const std::string& panel) {
  std::erase(leaf.panels, panel);
  leaf.active = std::clamp(leaf.active, 0, std::max(0, int(leaf.panels.size()) - 1));
}

// The node without its empty leaves; null when nothing is left.
std::unique_ptr<Node> pruned(std::unique_ptr<Node> node) {
  if (!node) return nullptr;
  if (node->leaf()) return node->panels.empty() ? nullptr : std::move(node);
  node->first = pruned(std::move(node->first));
  node->second = pruned(std::move(node->second));
  if (!node->first) return std::move(node->second);
  if (!node->second) return std::move(node->first);
  return node;
}

Json nodeJson(const Node& node) {
  Json json = Json::object();
  if (node.leaf()) {
    Json& panels = json.set("panels", Json::array());
    for (const std::string& panel : node.panels) panels.push(Json::of(panel));
    json.set("active", Json::of(node.active));
  } else {
    json.set("stacked", Json::of(node.stacked));
    json.set("ratio", Json::of(node.ratio));
    json.set("first", nodeJson(*node.first));
    json.set("second", nodeJson(*node.second));
  }
  return json;
}

std::unique_ptr<Node> nodeFrom(const Json& json, const std::vector<std::string>& known, std::vector<std::string>& seen,
                               int depth) {
  if (depth > 12) return nullptr;
  auto node = std::make_unique<Node>();
  if (const Json* panels = json.find("panels")) {
    for (const Json& panel : panels->items) {
      if (std::find(known.begin(), known.end(), panel.text) == known.end()) continue;
      if (std::find(seen.begin(), seen.end(), panel.text) != seen.end()) continue;
      seen.push_back(panel.text);
      node->panels.push_back(panel.text);
    }
    const Json* active = json.find("active");
    if (active && !node->panels.empty())
      node->active = std::clamp(int(active->number), 0, int(node->panels.size()) - 1);
    return node;
  }
  const Json *first = json.find("first"), *second = json.find("second");
  if (!first || !second) return nullptr;
  node->first = nodeFrom(*first, known, seen, depth + 1);
  node->second = nodeFrom(*second, known, seen, depth + 1);
  if (!node->first || !node->second) return nullptr;
  if (const Json* stacked = json.find("stacked")) node->stacked = stacked->boolean;
  if (const Json* ratio = json.find("ratio")) node->ratio = std::clamp(float(ratio->number), 0.05f, 0.95f);
  return node;
}

}  // namespace

Layout::Layout() : root_(standard()) {}

std::unique_ptr<Node> Layout::standard() {
  return split(false, 0.765f,
               split(true, 0.5f, leaf({"Viewport"}), leaf({"Graph", "Analysis", "Shader code"})),
               split(true, 0.56f, leaf({"Properties", "Library"}),
                     leaf({"Scene", "Views", "Models", "History", "Problems"})));
}

bool Layout::shown(const std::string& panel) const { return leafOf(root_.get(), panel) != nullptr; }

bool Layout::visible(const std::string& panel) const {
  const Node* node = leafOf(root_.get(), panel);
  return node && node->panels[size_t(node->active)] == panel;
}

void Layout::show(const std::string& panel) {
  Node* node = leafOf(root_.get(), panel);
  if (!node) {
    // Beside its neighbours of the standard arrangement, else in the last leaf.
    const auto arrangement = standard();
    if (Node* usual = leafOf(arrangement.get(), panel))
      for (const std::string& neighbour : usual->panels)
        if (!node) node = leafOf(root_.get(), neighbour);
    if (!node && !root_) root_ = leaf({});
    if (!node)
      for (node = root_.get(); !node->leaf();) node = node->second.get();
    node->panels.push_back(panel);
  }
  node->active = int(std::find(node->panels.begin(), node->panels.end(), panel) - node->panels.begin());
  changed_ = true;
}

void Layout::hide(const std::string& panel) {
  if (Node* node = leafOf(root_.get(), panel)) removePanel(*node, panel);
  prune();
  changed_ = true;
}

void Layout::prune() {
  root_ = pruned(std::move(root_));
  if (!root_) root_ = standard();
}

void Layout::setBadge(const std::string& panel, const std::string& badge) {
  std::erase_if(badges_, [&](const auto& item) { return item.first == panel; });
  if (!badge.empty()) badges_.emplace_back(panel, badge);
}

void Layout::place(const std::string& panel, Node& target, Side side) {
  Node* from = leafOf(root_.get(), panel);
  if (!from || (from == &target && (side == Side::Center || from->panels.size() == 1))) return;
  removePanel(*from, panel);
  if (side == Side::Center) {
    target.panels.push_back(panel);
    target.active = int(target.panels.size()) - 1;
  } else {
    auto old = std::make_unique<Node>(std::move(target));
    target = Node{};
    target.stacked = side == Side::Top || side == Side::Bottom;
    auto added = leaf({panel});
    const bool before = side == Side::Left || side == Side::Top;
    target.ratio = before ? 0.4f : 0.6f;
    target.first = before ? std::move(added) : std::move(old);
    target.second = before ? std::move(old) : std::move(added);
  }
  prune();
  changed_ = true;
}

void Layout::draw(ImVec2 low, ImVec2 high, const std::function<void(const std::string&)>& drawPanel) {
  splitterId_ = leafId_ = 0;
  drawNode(*root_, low, high, drawPanel);
  if (!ImGui::IsMouseDown(0)) dragged_.clear();
  if (!dropPanel_.empty() && dropTarget_) place(dropPanel_, *dropTarget_, dropSide_);
  dropPanel_.clear();
  dropTarget_ = nullptr;
  if (!hide_.empty()) hide(std::exchange(hide_, {}));
}

void Layout::drawNode(Node& node, ImVec2 low, ImVec2 high, const std::function<void(const std::string&)>& drawPanel) {
  if (node.leaf()) return drawLeaf(node, low, high, drawPanel);
  const float bar = theme::px(4), from = node.stacked ? low.y : low.x, to = node.stacked ? high.y : high.x;
  // Beside one another, as wide as labels with their fields need, while there is room for that.
  const float least = node.stacked ? theme::px(90) : std::min(theme::px(230), (to - from) * 0.38f);
  float at = std::round(from + (to - from) * node.ratio);
  if (to - from > 2 * least) at = std::clamp(at, from + least, to - least);
  const ImVec2 barLow = node.stacked ? ImVec2{low.x, at - bar / 2} : ImVec2{at - bar / 2, low.y};
  const ImVec2 barHigh = node.stacked ? ImVec2{high.x, at + bar / 2} : ImVec2{at + bar / 2, high.y};

  const std::string name = "splitter" + std::to_string(splitterId_++);
  ImGui::SetNextWindowPos(barLow);
  ImGui::SetNextWindowSize({barHigh.x - barLow.x, barHigh.y - barLow.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::kGap);
  ImGui::Begin(("##" + name).c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
  ImGui::InvisibleButton("bar", {barHigh.x - barLow.x, barHigh.y - barLow.y});
  ui::mark(name);
  const bool held = ImGui::IsItemActive();
  if (held || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(node.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled(barLow, barHigh, held ? theme::kAccent : theme::grey(80));
  }
  if (held) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    node.ratio = std::clamp(((node.stacked ? mouse.y : mouse.x) - from) / std::max(1.0f, to - from), 0.05f, 0.95f);
    changed_ = true;
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(4);

  drawNode(*node.first, low, node.stacked ? ImVec2{high.x, barLow.y} : ImVec2{barLow.x, high.y}, drawPanel);
  drawNode(*node.second, node.stacked ? ImVec2{low.x, barHigh.y} : ImVec2{barHigh.x, low.y}, high, drawPanel);
}

void Layout::drawLeaf(Node& node, ImVec2 low, ImVec2 high, const std::function<void(const std::string&)>& drawPanel) {
  const float strip = theme::px(28);
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize({std::max(1.0f, high.x - low.x), std::max(1.0f, high.y - low.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  // The window's name must follow the leaf, not its panels, or a tab switch would lose the focus.
  const std::string name = "##leaf" + std::to_string(leafId_++);
  ImGui::Begin(name.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse |
                   ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar(4);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {high.x, low.y + strip}, theme::kHeader);

  drawTabs(node, low, high.x - low.x, strip);

  if (!node.panels.empty()) {
    ImGui::SetCursorScreenPos({low.x, low.y + strip});
    ImGui::BeginChild("content", {high.x - low.x, std::max(1.0f, high.y - low.y - strip)}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    const std::string shown = node.panels[size_t(node.active)];
    ui::pushScope(shown);
    drawPanel(shown);
    ui::popScope();
    ImGui::EndChild();
  }

  // A tab held over this leaf shows where it would land.
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (!dragged_.empty() && mouse.x >= low.x && mouse.x < high.x && mouse.y >= low.y && mouse.y < high.y) {
    const float u = (mouse.x - low.x) / (high.x - low.x), v = (mouse.y - low.y) / (high.y - low.y);
    Side side = Side::Center;
    if (mouse.y > low.y + strip) {
      if (u < 0.25f) side = Side::Left;
      else if (u > 0.75f) side = Side::Right;
      else if (v > 0.7f) side = Side::Bottom;
      else if (v < 0.3f) side = Side::Top;
    }
    ImVec2 a = low, b = high;
    if (side == Side::Left) b.x = low.x + (high.x - low.x) * 0.4f;
    if (side == Side::Right) a.x = low.x + (high.x - low.x) * 0.6f;
    if (side == Side::Top) b.y = low.y + (high.y - low.y) * 0.4f;
    if (side == Side::Bottom) a.y = low.y + (high.y - low.y) * 0.6f;
    ImDrawList& front = *ImGui::GetForegroundDrawList();
    front.AddRectFilled(a, b, IM_COL32(226, 146, 74, 40), theme::px(4));
    front.AddRect(a, b, theme::kAccent, theme::px(4), 0, theme::px(1.5f));
    if (ImGui::IsMouseReleased(0)) {
      dropPanel_ = dragged_;
      dropTarget_ = &node;
      dropSide_ = side;
    }
  }
  ImGui::End();
}

std::string Layout::badgeOf(const std::string& panel) const {
  const auto found = std::find_if(badges_.begin(), badges_.end(), [&](const auto& badge) { return badge.first == panel; });
  return found == badges_.end() ? "" : found->second;
}

float Layout::tabWidth(const std::string& panel) const {
  const std::string badge = badgeOf(panel);
  return ImGui::CalcTextSize(panel.c_str()).x + theme::px(20) +
         (badge.empty() ? 0 : ImGui::CalcTextSize(badge.c_str()).x + theme::px(14));
}

void Layout::drawTabs(Node& node, ImVec2 low, float width, float strip) {
  // What finds no room goes under a menu at the end of the strip; the active one always has its tab.
  const float more = theme::px(26);
  float all = theme::px(4);
  for (const std::string& panel : node.panels) all += tabWidth(panel);
  float room = width - theme::px(4) - (all > width ? more : 0);
  if (!node.panels.empty()) room -= tabWidth(node.panels[size_t(node.active)]);
  std::vector<std::string> hidden;
  float x = low.x + theme::px(4);
  for (int i = 0; i < int(node.panels.size()); ++i) {
    const float natural = tabWidth(node.panels[size_t(i)]);
    if (i != node.active) {
      if (!hidden.empty() || natural > room) {
        hidden.push_back(node.panels[size_t(i)]);
        continue;
      }
      room -= natural;
    }
    const float tab = std::min(natural, low.x + width - x - (all > width ? more : 0));
    drawTab(node, i, {x, low.y + theme::px(3)}, {x + tab, low.y + strip});
    x += tab;
  }
  if (hidden.empty()) return;
  const bool wrong = std::any_of(hidden.begin(), hidden.end(), [&](const std::string& panel) { return !badgeOf(panel).empty(); });
  ImGui::SetCursorScreenPos({low.x + width - more, low.y + theme::px(3)});
  if (ImGui::InvisibleButton("more", {more, strip - theme::px(3)})) ImGui::OpenPopup("more tabs");
  ui::mark("more tabs:" + hidden.front());
  const std::string sign = "\u00bb";
  const ImVec2 text = ImGui::CalcTextSize(sign.c_str());
  ImGui::GetWindowDrawList()->AddText({std::round(low.x + width - (more + text.x) / 2), std::round(low.y + (strip - text.y) / 2)},
                                      wrong ? theme::kError : ImGui::IsItemHovered() ? theme::kText : theme::kTextDim, sign.c_str());
  if (!ImGui::BeginPopup("more tabs")) return;
  for (const std::string& panel : hidden) {
    const std::string badge = badgeOf(panel);
    if (ImGui::MenuItem(panel.c_str(), badge.empty() ? nullptr : badge.c_str())) show(panel);
    ui::mark("tab:" + panel);
  }
  ImGui::EndPopup();
}

void Layout::drawTab(Node& node, int index, ImVec2 low, ImVec2 high) {
  const std::string panel = node.panels[size_t(index)], badge = badgeOf(panel);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::SetCursorScreenPos(low);
  ImGui::PushID(panel.c_str());
  ImGui::InvisibleButton("tab", {std::max(1.0f, high.x - low.x), high.y - low.y});
  ui::mark("tab:" + panel);
  const bool active = index == node.active, over = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated() && !active) {
    node.active = index;
    changed_ = true;
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, theme::px(12))) dragged_ = panel;
  if (ImGui::BeginPopupContextItem("menu")) {
    if (ImGui::MenuItem("Close panel")) hide_ = panel;
    ImGui::EndPopup();
  }
  ImGui::PopID();
  if (active) list.AddRectFilled(low, high, theme::kPanel, theme::px(4), ImDrawFlags_RoundCornersTop);
  const float badgeWidth = badge.empty() ? 0 : ImGui::CalcTextSize(badge.c_str()).x + theme::px(8);
  const float y = std::round((low.y + high.y - ImGui::GetFontSize()) / 2), room = high.x - low.x - theme::px(20) - (badge.empty() ? 0 : badgeWidth + theme::px(6));
  ui::elidedText({low.x + theme::px(10), y}, room + 1, active ? theme::kText : over ? theme::grey(190) : theme::kTextDim, panel);
  if (badge.empty()) return;
  const ImVec2 b = {high.x - badgeWidth - theme::px(8), low.y + theme::px(5)};
  list.AddRectFilled(b, {b.x + badgeWidth, high.y - theme::px(5)}, theme::kError, theme::px(7));
  list.AddText({b.x + theme::px(4), y}, theme::grey(20), badge.c_str());
}

Json Layout::toJson() const { return nodeJson(*root_); }

void Layout::fromJson(const Json& json, const std::vector<std::string>& known) {
  std::vector<std::string> seen;
  auto read = pruned(nodeFrom(json, known, seen, 0));
  root_ = read ? std::move(read) : standard();
}

}  // namespace glint
