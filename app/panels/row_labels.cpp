#include "app/panels/row_labels.h"

#include <algorithm>
#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/health_badge.h"
#include "app/editor/model_row.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"

namespace glint {

void RowLabels::draw(Editor& editor, const FrameResult& frame, ImVec2 low) {
  labels_.clear();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const CellGrid& grid = frame.layout.grid;
  const float height = float(frame.layoutSize.y);
  ImFont *regular = ImGui::GetFont(), *small = ui::fonts().small();
  const auto widthIn = [](ImFont* font, const std::string& text) { return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x; };
  const float radius = healthSignRadius(), sign = 2 * radius + theme::px(6);
  for (int row = 0; row < grid.rows && row < int(frame.rowTitles.size()) && row < int(frame.rows.size()); ++row) {
    const glm::ivec4 cell = grid.rectangle(row, 0);
    const std::string& title = frame.rowTitles[size_t(row)];
    const RowInfo& info = frame.rows[size_t(row)];
    const bool own = row == frame.ownRow;
    const float right = low.x + float(cell.x) - theme::px(10), room = right - low.x - theme::px(6) - sign;
    if (room < theme::px(8)) continue;
    const float middle = low.y + height - float(cell.y) - float(cell.w) / 2;
    // A second line where there is one: parameters of its own, or that the material is made for it.
    const std::string note = own ? "this material\u2019s" : info.note;
    const bool two = !note.empty() && float(cell.w) > regular->FontSize + small->FontSize + theme::px(2);
    const float tall = regular->FontSize + (two ? small->FontSize + theme::px(1) : 0), top = std::round(middle - tall / 2);
    const float titleWidth = std::min(room, widthIn(regular, title)), noteWidth = two ? std::min(room, widthIn(small, note)) : 0;
    const ImVec2 from = {right - std::max(titleWidth + sign, noteWidth), top}, to = {right, top + tall};
    const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && ImGui::IsMouseHoveringRect(from, to);
    if (over) list.AddRectFilled({from.x - theme::px(4), from.y - theme::px(3)}, {to.x + theme::px(4), to.y + theme::px(3)}, theme::grey(255, 18), theme::px(3));
    ui::elidedText({right - titleWidth, top}, titleWidth + 1, own || over ? theme::kText : theme::grey(190), title, regular);
    if (info.model)
      drawHealthSign(list, {right - titleWidth - sign + radius, top + regular->FontSize * 0.54f}, radius, editor.health().card(info.model).get());
    if (two) ui::elidedText({right - noteWidth, top + regular->FontSize + theme::px(1)}, noteWidth + 1, own ? theme::kAccent : theme::kTextDim, note, small);
    if (own) {
      const float x = low.x + float(cell.x) - theme::px(4), y = low.y + height - float(cell.y);
      list.AddRectFilled({x, y - float(cell.w)}, {x + theme::px(2), y}, theme::kAccent);
    }
    ui::markRect((own ? "own row:" : "row:") + title, from, to);
    labels_.push_back({from, to, info, own});
  }
}

bool RowLabels::control(Editor& editor, bool hovered) {
  bool taken = false;
  const bool pressed = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1), released = ImGui::IsMouseReleased(0) || ImGui::IsMouseReleased(1);
  for (const Label& label : labels_) {
    if (!hovered || !ImGui::IsMouseHoveringRect(label.low, label.high)) continue;
    const bool sign = ImGui::GetIO().MousePos.x < label.low.x + 2 * healthSignRadius() + theme::px(4);
    if (pressed) {
      held_ = label.row.text;
      taken = true;
    } else if (released && held_ == label.row.text) {
      chosen_ = label;
      cardWanted_ = sign && ImGui::IsMouseReleased(0) && label.row.model;
      if (!cardWanted_) ImGui::OpenPopup("row menu");
    } else if (sign && label.row.model && !ImGui::IsAnyMouseDown()) {
      healthTooltip(label.row.model, editor.health().card(label.row.model).get(), true);
    }
  }
  if (pressed && !taken) held_.clear();
  menu(editor);
  return taken;
}

void RowLabels::menu(Editor& editor) {
  const RowInfo& row = chosen_.row;
  if (ImGui::BeginPopup("row menu")) {
    if (row.model) {
      const ModelHealthPtr card = editor.health().card(row.model);
      const std::string verdict = !card ? "Being checked\u2026" : card->verdict() == Verdict::Green ? "Keeps every law" : card->reason();
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float radius = healthSignRadius();
      drawHealthSign(*ImGui::GetWindowDrawList(), {at.x + radius, at.y + ImGui::GetFontSize() * 0.54f}, radius, card.get());
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 2 * radius + theme::px(6));
      ImGui::BeginGroup();
      ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + theme::px(260));
      ImGui::TextUnformatted(verdict.c_str());
      ImGui::PopTextWrapPos();
      ImGui::EndGroup();
      ImGui::Separator();
    }
    const auto item = [](const char* label, bool enabled = true) {
      const bool chosen = ImGui::MenuItem(label, nullptr, false, enabled);
      ui::mark(label);
      return chosen;
    };
    if (item("Health card\u2026", row.model != nullptr)) cardWanted_ = true;
    if (item("Use for this material", row.model && !chosen_.own)) editor.useModel(row.model->id);
    if (row.model && isModelMix(row.model->id) && item("Save as plugin\u2026"))
      if (const auto mix = parseModelMix(row.model->id)) editor.saveMix(*mix, chosen_.own ? std::nullopt : std::optional(row.text));
    const auto& rows = editor.document().preview().models;
    if (item("Leave out", std::find(rows.begin(), rows.end(), row.text) != rows.end() && !chosen_.own)) editor.removeRow(row.text);
    ImGui::EndPopup();
  }
  if (std::exchange(cardWanted_, false)) ImGui::OpenPopup("row card");
  ImGui::SetNextWindowSize({theme::px(440), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(14), theme::px(12)});
  if (ImGui::BeginPopup("row card")) {
    if (row.model) healthCard(row.model, editor.health().card(row.model).get());
    ui::markRect("row card", ImGui::GetWindowPos(), {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace glint
