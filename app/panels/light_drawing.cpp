#include "app/panels/light_drawing.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/fonts.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "renderer/image_io.h"

namespace glint {
namespace {

// As everywhere: red, green and blue for x, y and z.
constexpr ImU32 kAxisColors[] = {IM_COL32(232, 92, 84, 255), IM_COL32(128, 192, 84, 255), IM_COL32(88, 146, 240, 255)};
constexpr float kHidden = 0.32f, kBack = 0.55f;   // opacity behind a surface, and behind the light's own middle

ImU32 faded(ImU32 color, float alpha) {
  const auto a = ImU32(float(color >> IM_COL32_A_SHIFT & 0xff) * alpha);
  return (color & ~IM_COL32_A_MASK) | a << IM_COL32_A_SHIFT;
}
float alphaOf(ImU32 color) { return float(color >> IM_COL32_A_SHIFT & 0xff) / 255; }

// What a light looks like: its hue, at full brightness.
ImU32 colorOf(const Light& light, float alpha = 1) {
  const float peak = std::max({light.color.x, light.color.y, light.color.z, 1e-6f});
  const auto channel = [&](float c) { return srgbFromLinear(std::clamp(c / peak, 0.0f, 1.0f)); };
  return ImGui::ColorConvertFloat4ToU32({channel(light.color.x), channel(light.color.y), channel(light.color.z), alpha});
}

// Everything twice, first wider and dark, so that it is seen on any picture.
class Pen {
 public:
  explicit Pen(const LightCanvas& canvas) : list_(canvas.list), view_(canvas.view), depth_(canvas.depth), low_(canvas.low) {}

  float opacity(glm::vec3 p) const { return depth_ && depth_->hides(view_, p) ? kHidden : 1; }

  // In pieces, as some of them may be hidden.
  void line(const std::vector<glm::vec3>& points, glm::vec3 middle, ImU32 color, float width) {
    std::vector<ImVec2> run;
    float shown = 1;
    const auto flush = [&] {
      if (run.size() > 1) stroke(run, faded(color, shown), width);
      run.clear();
    };
    const float own = view_.depth(middle);
    const auto piece = [&](glm::vec3 a, glm::vec3 b) {
      const auto p = view_.project(a), q = view_.project(b);
      if (!p || !q) return flush();
      const glm::vec3 half = 0.5f * (a + b);
      const float now = std::min(opacity(half), view_.depth(half) > own * 1.002f ? kBack : 1.0f);
      if (now != shown) flush();
      shown = now;
      if (run.empty()) run.push_back(on(*p));
      run.push_back(on(*q));
    };
    for (size_t i = 1; i < points.size(); ++i) {
      const auto p = view_.project(points[i - 1]), q = view_.project(points[i]);
      const int pieces = p && q ? std::clamp(int(glm::length(*q - *p) / theme::px(8)), 1, 200) : 64;
      for (int k = 0; k < pieces; ++k) piece(glm::mix(points[i - 1], points[i], float(k) / float(pieces)), glm::mix(points[i - 1], points[i], float(k + 1) / float(pieces)));
    }
    flush();
  }
  void dot(glm::vec2 at, float radius, ImU32 fill, ImU32 rim, float rimWidth) {
    const ImVec2 p = on(at);
    list_.AddCircleFilled(p, theme::px(radius + rimWidth + 1), casing(rim), 24);
    list_.AddCircleFilled(p, theme::px(radius + rimWidth), rim, 24);
    list_.AddCircleFilled(p, theme::px(radius), fill, 24);
  }
  void ring(glm::vec2 at, float radius, ImU32 color, float width) {
    list_.AddCircle(on(at), theme::px(radius), casing(color), 32, theme::px(width + 2));
    list_.AddCircle(on(at), theme::px(radius), color, 32, theme::px(width));
  }
  void arrowHead(glm::vec2 tail, glm::vec2 tip, float size, ImU32 color) {
    glm::vec2 way = tip - tail;
    if (glm::length(way) < theme::px(3)) return;
    way = glm::normalize(way) * theme::px(size);
    const glm::vec2 side(-way.y, way.x), back = tip - way;
    const ImVec2 a = on(tip), b = on(back + 0.5f * side), c = on(back - 0.5f * side);
    list_.AddTriangle(a, b, c, casing(color), theme::px(2));
    list_.AddTriangleFilled(a, b, c, color);
  }
  void diamond(glm::vec2 at, float radius, ImU32 fill, ImU32 rim) {
    for (const auto& [grow, color] : {std::pair(2.4f, casing(rim)), {1.4f, rim}, {0.0f, fill}}) {
      const float r = theme::px(radius + grow);
      const ImVec2 p = on(at);
      list_.AddQuadFilled({p.x, p.y - r}, {p.x + r, p.y}, {p.x, p.y + r}, {p.x - r, p.y}, color);
    }
  }
  void cross(glm::vec2 at, float radius, ImU32 color, float width) {
    ring(at, radius, color, width);
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < 4; ++i) {
        const glm::vec2 d(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0);
        list_.AddLine(on(at + d * theme::px(radius - 2.5f)), on(at + d * theme::px(radius + 4)), pass ? color : casing(color), theme::px(pass ? width : width + 2));
      }
  }
  // Short strokes all around: a sun.
  void rays(glm::vec2 at, float from, float to, ImU32 color) {
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < 8; ++i) {
        const float a = float(i) * 0.785398f;
        const glm::vec2 d(std::cos(a), std::sin(a));
        list_.AddLine(on(at + d * theme::px(from)), on(at + d * theme::px(to)), pass ? color : casing(color), theme::px(pass ? 1.5f : 3.5f));
      }
  }
  void fill(const std::vector<glm::vec3>& points, ImU32 color, bool edge = false) {
    std::vector<ImVec2> flat;
    for (const glm::vec3& p : points) {
      const auto seen = view_.project(p);
      if (!seen) return;
      flat.push_back(on(*seen));
    }
    list_.AddConvexPolyFilled(flat.data(), int(flat.size()), color);
    if (edge) list_.AddPolyline(flat.data(), int(flat.size()), faded(color, 1.0f / std::max(alphaOf(color), 0.01f)), ImDrawFlags_Closed, theme::px(1));
  }

 private:
  ImVec2 on(glm::vec2 p) const { return {low_.x + p.x, low_.y + p.y}; }
  static ImU32 casing(ImU32 color) { return faded(theme::grey(0, 150), alphaOf(color)); }
  void stroke(const std::vector<ImVec2>& points, ImU32 color, float width) {
    list_.AddPolyline(points.data(), int(points.size()), casing(color), 0, theme::px(width + 2));
    list_.AddPolyline(points.data(), int(points.size()), color, 0, theme::px(width));
  }

  ImDrawList& list_;
  const HandleView& view_;
  const SceneDepth* depth_;
  ImVec2 low_;
};

void drawHandles(Pen& pen, const LightCanvas& canvas, const Light& light, const std::vector<LightHandle>& handles, const LightLook& look) {
  const HandleView& view = canvas.view;
  const glm::vec3 middle = handles.front().at;
  const auto at = view.project(middle);
  for (size_t i = handles.size(); i-- > 1;) {   // axes below
    const auto& [grip, place] = handles[i];
    const bool hot = look.grip == grip;
    if (look.held && !hot) continue;
    const auto p = view.project(place);
    if (!p || !at) continue;
    const float opacity = hot ? 1 : pen.opacity(place);
    const ImU32 line = faded(hot ? theme::grey(255) : theme::kAccent, opacity);
    if (const int axis = axisOf(grip); axis >= 0) {
      const ImU32 color = hot ? theme::grey(255) : kAxisColors[axis];
      const glm::vec3 way = place - middle;
      if (look.held) pen.line({middle - 40.0f * way, middle + 40.0f * way}, middle - 1e3f * view.forward, faded(kAxisColors[axis], 0.7f), 1);
      pen.line({middle + 0.3f * way, place}, place + 1e3f * view.forward, color, hot ? 2.4f : 1.7f);
      pen.arrowHead(*at, *p + glm::normalize(*p - *at) * theme::px(5), 9, faded(color, opacity));
    } else if (const int plane = planeOf(grip); plane >= 0) {
      pen.fill(planeCorners(light, view, plane), faded(kAxisColors[plane], opacity * (hot ? 0.85f : 0.4f)), true);
    } else if (grip == LightGrip::Turn) {
      pen.arrowHead(*at, *p + (glm::length(*p - *at) > 1 ? glm::normalize(*p - *at) : glm::vec2(0)) * theme::px(4), 12, line);
      if (glm::length(*p - *at) < theme::px(14)) pen.dot(*p, 3.2f, theme::grey(32), line, 1.4f);
    } else if (grip == LightGrip::Aim) {
      pen.line({middle, place}, middle, faded(theme::kAccent, 0.5f), 1);
      pen.cross(*p, 6, line, hot ? 2 : 1.4f);
    } else if (grip == LightGrip::Reach) {
      if (hot) {
        const LightLine end = reachOutline(light, view);
        pen.line(end.points, middle - 1e3f * view.forward, theme::kAccentDim, 1.2f);
      }
      pen.diamond(*p, hot ? 4.5f : 3.2f, hot ? theme::grey(255) : theme::grey(32), line);
    } else {
      pen.dot(*p, hot ? 4.4f : 3.3f, faded(hot ? theme::grey(255) : theme::grey(32), opacity), line, 1.4f);
    }
  }
}

}  // namespace

void drawLightEdge(const LightCanvas& canvas, const Light& light, glm::vec2 at, const LightLook& look) {
  Pen pen(canvas);
  const ImU32 line = look.selected ? theme::kAccent : look.hovered ? theme::grey(255) : theme::grey(215);
  const glm::vec2 out = glm::normalize(at - canvas.view.size / 2.0f);
  pen.arrowHead(at, at + out * theme::px(13), 7, line);
  pen.dot(at, 3.5f, colorOf(light), line, 1.2f);
}

void drawLight(const LightCanvas& canvas, const Light& light, float aim, const LightLook& look) {
  Pen pen(canvas);
  const HandleView& view = canvas.view;
  const std::vector<LightHandle> handles = lightHandles(light, view, aim);
  const glm::vec3 middle = handles.front().at;
  const auto at = view.project(middle);
  const bool sun = light.kind == LightKind::Directional;
  const ImU32 line = look.selected ? theme::kAccent : look.hovered ? theme::grey(255) : theme::grey(215);
  const float width = look.selected || look.hovered ? 1.6f : 1.2f;
  if (!look.plain) {
    const std::vector<LightLine> outline = lightOutline(light, view, look.selected);
    if (light.kind == LightKind::Rectangle && glm::dot(light.axis, view.eye - light.position) > 0)
      pen.fill(std::vector(outline[0].points.begin(), outline[0].points.end() - 1), colorOf(light, 0.16f));
    for (const LightLine& one : outline) pen.line(one.points, sun ? view.target : middle, faded(line, one.faint ? 0.45f : 1), one.faint ? 1 : width);
    if (sun)
      if (const auto tail = view.project(outline[0].points[0]), tip = view.project(outline[0].points[1]); tail && tip)
        pen.arrowHead(*tail, *tip, 10, faded(line, pen.opacity(outline[0].points[1])));
  }
  const float opacity = look.selected || look.hovered ? 1 : pen.opacity(middle);
  if (look.selected) drawHandles(pen, canvas, light, handles, look);
  else if (at && !look.plain && (light.kind == LightKind::Spot || light.kind == LightKind::Rectangle))
    for (const LightHandle& handle : handles)
      if (const auto tip = handle.grip == LightGrip::Turn ? view.project(handle.at) : std::nullopt) pen.arrowHead(*at, *tip, 9, faded(line, pen.opacity(handle.at)));
  if (!at) return;
  if (!look.plain) {
    if (sun) pen.rays(*at, 9, 13.5f, faded(line, opacity));
    else if (light.kind == LightKind::Point) pen.ring(*at, 10, faded(line, opacity), width);
  }
  const bool hot = look.grip == handles.front().grip;
  pen.dot(*at, sun ? 5.5f : hot ? 4.8f : 3.8f, faded(colorOf(light), opacity), faded(hot && look.selected ? theme::grey(255) : line, opacity), hot || look.selected ? 1.8f : 1.2f);
}

void drawLightLabel(const LightCanvas& canvas, glm::vec2 at, glm::vec2 away, const std::string& title, const std::string& detail, bool selected) {
  const HandleView& view = canvas.view;
  const ImVec2 low = canvas.low;
  ImFont* small = ui::fonts().small();
  const float line = small->FontSize, pad = theme::px(6), gap = theme::px(7);
  const auto width = [&](const std::string& t) { return small->CalcTextSizeA(line, FLT_MAX, 0, t.c_str()).x; };
  const float first = width(title), whole = first + gap + width(detail);
  const float left = low.x + at.x - theme::px(20) - whole, right = low.x + at.x + theme::px(20);
  const float above = low.y + at.y - theme::px(18) - line, below = low.y + at.y + theme::px(14);
  ImVec2 p{away.x < -theme::px(4) ? left : right, away.y < -theme::px(4) ? above : below};
  if (p.x + whole + pad > low.x + view.size.x) p.x = left;
  if (p.x < low.x + pad) p.x = std::min(right, low.x + view.size.x - whole - pad);
  p.x = std::max(p.x, low.x + pad);
  if (p.y + line + theme::px(8) > low.y + view.size.y) p.y = above;
  if (p.y < low.y + theme::px(6)) p.y = below;
  p = {std::round(p.x), std::round(p.y)};
  ImDrawList& list = canvas.list;
  list.AddRectFilled({p.x - pad, p.y - theme::px(4)}, {p.x + whole + pad, p.y + line + theme::px(4)}, theme::grey(20, 225), theme::px(4));
  list.AddText(small, line, p, selected ? theme::kAccent : theme::kText, title.c_str());
  list.AddText(small, line, {p.x + first + gap, p.y}, theme::grey(200), detail.c_str());
  ui::markRect("light label", p, {p.x + whole, p.y + line});
}

}  // namespace glint
