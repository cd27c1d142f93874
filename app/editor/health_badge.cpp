#include "app/editor/health_badge.h"

#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/health_text.h"

namespace glint {
namespace {

ImU32 colorOf(Verdict verdict) {
  return verdict == Verdict::Green ? theme::kGood : verdict == Verdict::Amber ? theme::kWarning : theme::kError;
}

constexpr float kCardWidth = 440;  // UI units

void law(const LawResult& result) {
  const float size = ImGui::GetFontSize(), radius = size * 0.36f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = ImGui::GetCursorPosX();
  ModelHealth one;
  one.laws.push_back(result);
  drawHealthSign(*ImGui::GetWindowDrawList(), {at.x + radius, at.y + size * 0.55f}, radius, &one);
  ImGui::SetCursorPosX(left + size * 1.2f);
  ImGui::PushFont(ui::fonts().bold());
  std::string title(name(result.law));
  title[0] = char(std::toupper(static_cast<unsigned char>(title[0])));
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  if (result.claimed) {
    ImGui::SameLine();
    ui::textDim("claimed");
  }
  ImGui::SetCursorPosX(left + size * 1.2f);
  ImGui::BeginGroup();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(finding(result).c_str());
  ImGui::PopTextWrapPos();
  std::string more = result.where;
  if (!result.hint.empty()) more += (more.empty() ? "" : "  \u00b7  ") + result.hint;
  if (!more.empty()) ui::textSmall(more);
  ImGui::EndGroup();
  ImGui::Dummy({0, theme::px(1)});
}

}  // namespace

float healthSignRadius() { return std::floor(ImGui::GetFontSize() * 0.44f) + 0.5f; }

void drawHealthSign(ImDrawList& list, ImVec2 c, float r, const ModelHealth* card) {
  c = {std::floor(c.x) + 0.5f, std::floor(c.y) + 0.5f};
  const float line = std::max(1.0f, r * 0.3f);
  if (!card) {
    list.AddCircle(c, r - line / 2, theme::kTextFaint, 0, std::max(1.0f, line * 0.7f));
    for (int i = -1; i <= 1; ++i) list.AddCircleFilled({c.x + float(i) * r * 0.42f, c.y}, std::max(0.8f, r * 0.13f), theme::kTextFaint);
    return;
  }
  const Verdict verdict = card->verdict();
  constexpr ImU32 kInk = theme::grey(22);
  list.AddCircleFilled(c, r, colorOf(verdict));
  if (verdict == Verdict::Green) {
    const ImVec2 points[] = {{c.x - r * 0.45f, c.y + r * 0.05f}, {c.x - r * 0.1f, c.y + r * 0.4f}, {c.x + r * 0.48f, c.y - r * 0.36f}};
    list.AddPolyline(points, 3, kInk, 0, line);
  } else if (verdict == Verdict::Amber) {
    list.AddLine({c.x, c.y - r * 0.58f}, {c.x, c.y + r * 0.16f}, kInk, line * 1.15f);
    list.AddCircleFilled({c.x, c.y + r * 0.5f}, line * 0.62f, kInk);
  } else {
    const float a = r * 0.38f;
    list.AddLine({c.x - a, c.y - a}, {c.x + a, c.y + a}, kInk, line);
    list.AddLine({c.x - a, c.y + a}, {c.x + a, c.y - a}, kInk, line);
  }
}

void healthCard(const ModelPtr& model, const ModelHealth* card) {
  const float radius = ImGui::GetFontSize() * 0.6f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushFont(ui::fonts().heading());
  const float height = ImGui::GetFontSize();
  drawHealthSign(*ImGui::GetWindowDrawList(), {at.x + radius, at.y + height * 0.55f}, radius, card);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + radius * 2 + theme::px(8));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(model->title.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  if (!card) {
    ui::textDim("Being checked against the laws of light\u2026");
    return;
  }
  if (card->verdict() == Verdict::Green) ui::textDim("Keeps every law that was checked.");
  else if (card->verdict() == Verdict::Amber) ui::textDim("Breaks a law that it does not claim to keep.");
  else ui::textDim("Breaks what it claims, or what no model may break.");
  ImGui::Dummy({0, theme::px(4)});
  for (const LawResult& result : card->laws) law(result);
  ui::textSmall("Claims " + claimsText(*model) + ".  " + card->file);
}

void healthTooltip(const ModelPtr& model, const ModelHealth* card, bool always) {
  if (!always && !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::SetNextWindowSize({theme::px(kCardWidth), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(14), theme::px(12)});
  ImGui::BeginTooltip();
  healthCard(model, card);
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void healthBadge(Editor& editor, const std::string& name, const ModelPtr& model) {
  const ModelHealthPtr card = editor.health().card(model);
  const float radius = healthSignRadius(), height = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string known = "health:" + name;
  ImGui::PushID(known.c_str());
  if (ImGui::InvisibleButton("badge", {radius * 2 + theme::px(2), height})) ImGui::OpenPopup("card");
  const ImVec2 center = {at.x + radius + theme::px(1), at.y + height / 2};
  if (ImGui::IsItemHovered()) ImGui::GetWindowDrawList()->AddCircle(center, radius + theme::px(2), theme::grey(255, 70), 0, theme::px(1));
  drawHealthSign(*ImGui::GetWindowDrawList(), center, radius, card.get());
  ui::mark(known);
  if (card) ui::mark(known + ":" + std::string(glint::name(card->verdict())));
  if (!ImGui::IsPopupOpen("card")) healthTooltip(model, card.get());
  ImGui::SetNextWindowSize({theme::px(kCardWidth), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(14), theme::px(12)});
  if (ImGui::BeginPopup("card")) {
    healthCard(model, card.get());
    ui::markRect(known + ":card", ImGui::GetWindowPos(), {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
}

}  // namespace glint
