#include "app/panels/plot_canvas.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/fonts.h"
#include "app/editor/imgui_renderer.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"

namespace glint {
namespace {

ImU32 color(PlotColor c) { return IM_COL32(c.r, c.g, c.b, c.a); }
PlotColor color(ImU32 c) {
  return {uint8_t(c >> IM_COL32_R_SHIFT), uint8_t(c >> IM_COL32_G_SHIFT), uint8_t(c >> IM_COL32_B_SHIFT), 255};
}

// The face that was rasterised nearest to the size, so that text stays sharp.
ImFont* fontFor(float size, bool bold) {
  Fonts& fonts = ui::fonts();
  std::vector<ImFont*> faces = bold ? std::vector<ImFont*>{fonts.bold(), fonts.heading()} : std::vector<ImFont*>{fonts.regular(), fonts.small()};
  for (const Fonts::CanvasFaces& canvas : fonts.canvas()) faces.push_back(bold ? canvas.bold : canvas.regular);
  return *std::min_element(faces.begin(), faces.end(), [&](const ImFont* a, const ImFont* b) { return std::abs(a->FontSize - size) < std::abs(b->FontSize - size); });
}

float measured(const std::string& text, float size, bool bold) {
  const ImFont* font = fontFor(size, bold);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

void drawText(ImDrawList& list, ImVec2 low, const PlotText& text) {
  float x = text.at.x;
  if (text.align != TextAlign::Left) x -= textWidth(text.text, text.size, text.bold, measured) * (text.align == TextAlign::Center ? 0.5f : 1.0f);
  for (const PlotTextRun& run : textRuns(text.text)) {
    const float size = run.level ? text.size * kRunSize : text.size;
    const ImFont* font = fontFor(size, text.bold);
    const float baseline = text.at.y + (run.level < 0 ? kLowered : run.level > 0 ? kRaised : 0) * text.size;
    list.AddText(font, font->FontSize, {low.x + std::round(x), low.y + std::round(baseline - font->Ascent)}, color(text.color), run.text.c_str());
    x += measured(run.text, size, text.bold);
  }
}

void drawLine(ImDrawList& list, ImVec2 low, const PlotLine& line) {
  std::vector<ImVec2> points;
  for (const auto& part : dashes(line)) {
    points.clear();
    // Points much closer than a pixel have no direction to join at.
    for (const glm::vec2& p : part)
      if (points.empty() || std::hypot(points.back().x - low.x - p.x, points.back().y - low.y - p.y) > 0.3f) points.push_back({low.x + p.x, low.y + p.y});
    if (points.size() == 1) list.AddCircleFilled(points[0], line.width * 0.5f, color(line.color));
    else list.AddPolyline(points.data(), int(points.size()), color(line.color), 0, line.width);
  }
}

gl::Texture upload(const Image8& image) {
  gl::Texture texture = gl::createTexture2D(GL_RGBA8, image.width, image.height);
  std::vector<uint8_t> rgba;
  for (size_t i = 0; i < image.data.size(); i += 3) rgba.insert(rgba.end(), {image.data[i], image.data[i + 1], image.data[i + 2], 255});
  glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return texture;
}

}  // namespace

void PlotCanvas::draw(const std::shared_ptr<const PlotData>& data, ImVec2 low, ImVec2 size, std::set<size_t>& hidden) {
  if (!data || size.x < theme::px(120) || size.y < theme::px(90)) return;
  if (data_ && data_->settings.kind != data->settings.kind) showAll();
  const bool fresh = data_ != data;
  data_ = data;
  PlotView view{{int(size.x), int(size.y)}, theme::scale(), x_, y_, hidden, false, color(theme::kPanel)};
  const auto key = [](const PlotView& v) {
    return std::tuple(v.size.x, v.size.y, v.unit, v.x ? v.x->low : 0, v.x ? v.x->high : 0, v.y ? v.y->low : 0, v.y ? v.y->high : 0, v.hidden);
  };
  if (fresh || key(view) != key(view_)) {
    view_ = view;
    layOut();
  }
  ImGui::SetCursorScreenPos(low);
  // The legend's entries lie on top and are asked first.
  legend(low, hidden);
  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton("plot", size);
  ui::mark("plot");
  paint(low);
  navigate(low);
  if (ImGui::IsItemHovered()) read(low, hidden);
}

void PlotCanvas::layOut() {
  drawing_ = layOutPlot(*data_, view_, measured);
  textures_.clear();
  for (const PlotItem& item : drawing_.items)
    if (const auto* bitmap = std::get_if<PlotBitmap>(&item)) textures_.push_back(upload(bitmap->pixels));
}

void PlotCanvas::paint(ImVec2 low) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  size_t bitmaps = 0;
  for (const PlotItem& item : drawing_.items) {
    if (const auto* line = std::get_if<PlotLine>(&item)) drawLine(list, low, *line);
    else if (const auto* text = std::get_if<PlotText>(&item)) drawText(list, low, *text);
    else if (const auto* rect = std::get_if<PlotRect>(&item)) list.AddRectFilled({low.x + rect->low.x, low.y + rect->low.y}, {low.x + rect->high.x, low.y + rect->high.y}, color(rect->color));
    else if (const auto* bitmap = std::get_if<PlotBitmap>(&item))
      list.AddImage(imguiTexture(textures_[bitmaps++].id()), {low.x + bitmap->low.x, low.y + bitmap->low.y}, {low.x + bitmap->high.x, low.y + bitmap->high.y});
  }
}

void PlotCanvas::legend(ImVec2 low, std::set<size_t>& hidden) {
  for (const PlotLegendEntry& entry : drawing_.legend) {
    const ImVec2 from{low.x + entry.low.x, low.y + entry.low.y}, to{low.x + entry.high.x, low.y + entry.high.y};
    ImGui::SetCursorScreenPos(from);
    ImGui::PushID(int(entry.subject));
    if (ImGui::InvisibleButton("legend", {to.x - from.x, to.y - from.y}) && !hidden.erase(entry.subject)) hidden.insert(entry.subject);
    ui::mark("legend:" + data_->titles[entry.subject]);
    if (ImGui::IsItemHovered()) ImGui::GetWindowDrawList()->AddRectFilled(from, to, theme::grey(46), theme::px(3));
    ui::tooltip(hidden.count(entry.subject) ? "Click to show" : "Click to hide");
    ImGui::PopID();
  }
}

void PlotCanvas::navigate(ImVec2 low) {
  if (drawing_.frames.empty() || drawing_.frames[0].kind == PlotFrame::Slice) return;
  const PlotFrame& frame = drawing_.frames[0];
  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 mouse{io.MousePos.x - low.x, io.MousePos.y - low.y};
  const bool over = ImGui::IsItemHovered() && frame.holds(mouse), polar = frame.kind == PlotFrame::Polar;
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) return showAll();
  if (over && io.MouseWheel != 0) {
    const double factor = std::pow(1.25, double(io.MouseWheel));
    const double u = (mouse.x - frame.low.x) / (frame.high.x - frame.low.x), v = (frame.high.y - mouse.y) / (frame.high.y - frame.low.y);
    const auto sound = [](const PlotAxis& axis) {
      return std::isfinite(axis.low) && std::isfinite(axis.high) && axis.high - axis.low > 1e-7 * std::max(1.0, std::abs(axis.high)) && axis.high - axis.low < 1e9;
    };
    const PlotAxis x = frame.x.zoomed(u, factor), y = frame.y.zoomed(polar ? 0 : v, factor);
    if (!polar && sound(x)) x_ = x;
    if (sound(y)) y_ = y;
  }
  if (ImGui::IsItemActivated()) held_ = frame;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, theme::px(3)) && !polar) {
    const ImVec2 by = ImGui::GetMouseDragDelta(0, 0);
    x_ = held_.x.moved(-by.x / (held_.high.x - held_.low.x));
    y_ = held_.y.moved(by.y / (held_.high.y - held_.low.y));
  }
}

void PlotCanvas::read(ImVec2 low, const std::set<size_t>& hidden) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto reading = readPlot(*data_, drawing_, {mouse.x - low.x, mouse.y - low.y}, hidden);
  if (!reading) return;
  const PlotFrame& frame = drawing_.frames[reading->frame];
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 from{low.x + frame.low.x, low.y + frame.low.y}, to{low.x + frame.high.x, low.y + frame.high.y};
  const ImU32 hair = theme::grey(150, 150);
  if (frame.kind == PlotFrame::Polar) {
    const glm::vec2 a = frame.place(reading->x, frame.y.low), b = frame.place(reading->x, frame.y.high);
    list.AddLine({low.x + a.x, low.y + a.y}, {low.x + b.x, low.y + b.y}, hair);
  } else {
    list.AddLine({mouse.x, from.y}, {mouse.x, to.y}, hair);
    if (frame.kind == PlotFrame::Slice) list.AddLine({from.x, mouse.y}, {to.x, mouse.y}, hair);
  }
  if (frame.kind == PlotFrame::Slice)
    for (const PlotFrame& other : drawing_.frames) {
      // The same place in every model's picture.
      const glm::vec2 at = other.place(reading->x, reading->y);
      list.AddCircle({low.x + at.x, low.y + at.y}, theme::px(4), theme::grey(235), 0, theme::px(1));
    }
  for (const PlotReading::Line& line : reading->lines)
    if (frame.kind != PlotFrame::Slice && frame.holds(line.dot)) {
      list.AddCircleFilled({low.x + line.dot.x, low.y + line.dot.y}, theme::px(4), theme::kPanel);
      list.AddCircleFilled({low.x + line.dot.x, low.y + line.dot.y}, theme::px(3), color(line.color));
    }

  // The table, beside the pointer and within the canvas.
  constexpr size_t kMost = 14;
  ImFont* font = ui::fonts().small();
  const float lineHeight = std::round(font->FontSize * 1.4f), pad = theme::px(8), swatch = frame.kind == PlotFrame::Slice ? 0 : theme::px(14);
  const size_t count = std::min(reading->lines.size(), kMost);
  const auto wide = [&](const std::string& text) { return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x; };
  float titles = 0, values = 0;
  for (size_t i = 0; i < count; ++i) {
    titles = std::max(titles, std::min(wide(reading->lines[i].title), theme::px(230)));
    values = std::max(values, wide(readable(reading->lines[i].value)));
  }
  const PlotText head{{}, font->FontSize, false, color(theme::kTextDim), TextAlign::Left, reading->place};
  const float width = std::max(swatch + titles + theme::px(16) + values, textWidth(head.text, head.size, false, measured)) + 2 * pad;
  const float height = lineHeight * float(count + 1 + (reading->lines.size() > kMost)) + 2 * theme::px(5);
  ImVec2 at{mouse.x + theme::px(14), mouse.y + theme::px(10)};
  if (at.x + width > low.x + float(view_.size.x)) at.x = mouse.x - theme::px(14) - width;
  at.y = std::min(at.y, low.y + float(view_.size.y) - height - theme::px(4));
  at = {std::round(at.x), std::round(at.y)};
  ImDrawList& front = *ImGui::GetForegroundDrawList();
  front.AddRectFilled(at, {at.x + width, at.y + height}, theme::grey(22, 238), theme::px(4));
  front.AddRect(at, {at.x + width, at.y + height}, theme::grey(70), theme::px(4));
  float y = at.y + theme::px(5);
  PlotText placed = head;
  placed.at = {pad, font->Ascent};
  drawText(front, {at.x, y}, placed);
  y += lineHeight;
  for (size_t i = 0; i < count; ++i, y += lineHeight) {
    const PlotReading::Line& line = reading->lines[i];
    if (swatch > 0) front.AddRectFilled({at.x + pad, y + theme::px(4)}, {at.x + pad + theme::px(8), y + theme::px(12)}, color(line.color), theme::px(2));
    const std::string title = ui::elided(line.title, titles + 1, font), value = readable(line.value);
    front.AddText(font, font->FontSize, {at.x + pad + swatch, y}, theme::kText, title.c_str());
    front.AddText(font, font->FontSize, {at.x + width - pad - wide(value), y}, theme::kText, value.c_str());
    ui::markRect("reading:" + line.title + "=" + value, {at.x, y}, {at.x + width, y + lineHeight});
  }
  if (reading->lines.size() > kMost)
    front.AddText(font, font->FontSize, {at.x + pad, y}, theme::kTextDim, ("and " + std::to_string(reading->lines.size() - kMost) + " more").c_str());
}

}  // namespace glint
