#include "app/panels/light_gizmos.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/keys.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "renderer/image_io.h"

namespace glint {
namespace {

// UI units.
constexpr float kReach = 9, kLineReach = 5, kStill = 3, kEdge = 16;
// Beyond so many, lights that are not selected are dots.
constexpr size_t kMostOutlined = 64;

ImVec2 on(ImVec2 low, glm::vec2 p) { return {low.x + p.x, low.y + p.y}; }

bool inside(const HandleView& view, glm::vec2 p) {
  const float inset = 6 * view.scale;
  return p.x > inset && p.y > inset && p.x < view.size.x - inset && p.y < view.size.y - inset;
}

// Where the sign of a light is: by its place in the picture, or on the edge.
struct Place {
  glm::vec2 at{0};
  bool edge = false;
};
Place placeOf(const Light& light, const HandleView& view) {
  const glm::vec3 anchor = lightHandles(light, view).front().at;
  const auto seen = view.project(anchor);
  if (seen && inside(view, *seen)) return {*seen, false};
  return {view.edge(anchor, kEdge), true};
}

float distanceTo(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 d = b - a;
  const float length = glm::dot(d, d), t = length > 0 ? std::clamp(glm::dot(p - a, d) / length, 0.0f, 1.0f) : 0;
  return glm::length(p - (a + t * d));
}

ImU32 faded(ImU32 color, float alpha) {
  const auto a = ImU32(float(color >> IM_COL32_A_SHIFT & 0xff) * alpha);
  return (color & ~IM_COL32_A_MASK) | a << IM_COL32_A_SHIFT;
}

// What a light looks like: its hue, at full brightness.
ImU32 colorOf(const Light& light, float alpha = 1) {
  const float peak = std::max({light.color.x, light.color.y, light.color.z, 1e-6f});
  const auto channel = [&](float c) { return srgbFromLinear(std::clamp(c / peak, 0.0f, 1.0f)); };
  return ImGui::ColorConvertFloat4ToU32({channel(light.color.x), channel(light.color.y), channel(light.color.z), alpha});
}

std::string titleOf(const Light& light, size_t index) { return fmt::format("{} {}", infoOf(light.kind).title, index + 1); }

// One light's lines and signs: everything twice, first wider and dark, so that it is seen on any picture.
class Pen {
 public:
  Pen(ImDrawList& list, const HandleView& view, ImVec2 low) : list_(list), view_(view), low_(low) {}

  void line(const std::vector<glm::vec3>& points, glm::vec3 middle, ImU32 color, float width) {
    // What lies behind the light's own middle is dimmer.
    std::vector<ImVec2> run;
    bool runBehind = false;
    const auto flush = [&] {
      if (run.size() > 1) stroke(run, faded(color, runBehind ? 0.45f : 1), width);
      run.clear();
    };
    const float depth = glm::dot(middle - view_.eye, view_.forward);
    for (size_t i = 0; i < points.size(); ++i) {
      const auto p = view_.project(points[i]);
      if (!p) {
        flush();
        continue;
      }
      const glm::vec3 ahead = i + 1 < points.size() ? 0.5f * (points[i] + points[i + 1]) : points[i];
      const bool behind = glm::dot(ahead - view_.eye, view_.forward) > depth * 1.002f;
      run.push_back(on(low_, *p));
      if (run.size() > 1 && behind != runBehind) {
        const ImVec2 last = run.back();
        flush();
        run.push_back(last);
      }
      runBehind = behind;
    }
    flush();
  }
  void stroke(const std::vector<ImVec2>& points, ImU32 color, float width) {
    const float alpha = float(color >> IM_COL32_A_SHIFT & 0xff) / 255;
    list_.AddPolyline(points.data(), int(points.size()), faded(theme::grey(0, 150), alpha), 0, theme::px(width + 2));
    list_.AddPolyline(points.data(), int(points.size()), color, 0, theme::px(width));
  }
  void dot(glm::vec2 at, float radius, ImU32 fill, ImU32 rim, float rimWidth) {
    const ImVec2 p = on(low_, at);
    list_.AddCircleFilled(p, theme::px(radius + rimWidth + 1), theme::grey(0, 150), 24);
    list_.AddCircleFilled(p, theme::px(radius + rimWidth), rim, 24);
    list_.AddCircleFilled(p, theme::px(radius), fill, 24);
  }
  void ring(glm::vec2 at, float radius, ImU32 color, float width) {
    list_.AddCircle(on(low_, at), theme::px(radius), theme::grey(0, 150), 32, theme::px(width + 2));
    list_.AddCircle(on(low_, at), theme::px(radius), color, 32, theme::px(width));
  }
  void arrowHead(glm::vec2 tail, glm::vec2 tip, float size, ImU32 color) {
    glm::vec2 way = tip - tail;
    if (glm::length(way) < theme::px(3)) return;
    way = glm::normalize(way) * theme::px(size);
    const glm::vec2 side(-way.y, way.x), back = tip - way;
    const ImVec2 a = on(low_, tip), b = on(low_, back + 0.55f * side), c = on(low_, back - 0.55f * side);
    list_.AddTriangle(a, b, c, theme::grey(0, 150), theme::px(2));
    list_.AddTriangleFilled(a, b, c, color);
  }
  // Short strokes all around: a sun.
  void rays(glm::vec2 at, float from, float to, ImU32 color) {
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < 8; ++i) {
        const float a = float(i) * 0.785398f;
        const glm::vec2 d(std::cos(a), std::sin(a));
        list_.AddLine(on(low_, at + d * theme::px(from)), on(low_, at + d * theme::px(to)), pass ? color : theme::grey(0, 150), theme::px(pass ? 1.5f : 3.5f));
      }
  }
  void fill(const std::vector<glm::vec3>& points, ImU32 color) {
    std::vector<ImVec2> flat;
    for (const glm::vec3& p : points) {
      const auto seen = view_.project(p);
      if (!seen) return;
      flat.push_back(on(low_, *seen));
    }
    list_.AddConvexPolyFilled(flat.data(), int(flat.size()), color);
  }

 private:
  ImDrawList& list_;
  const HandleView& view_;
  ImVec2 low_;
};

struct Look {
  bool selected = false, hovered = false, plain = false;
  std::optional<LightGrip> grip;   // under the pointer, or held
};

void drawEdge(Pen& pen, const Light& light, const HandleView& view, glm::vec2 at, const Look& look) {
  const ImU32 line = look.selected ? theme::kAccent : look.hovered ? theme::grey(255) : theme::grey(215);
  const glm::vec2 out = glm::normalize(at - view.size / 2.0f);
  pen.arrowHead(at, at + out * theme::px(13), 7, line);
  pen.dot(at, 3.5f, colorOf(light), line, 1.2f);
}

void drawLight(Pen& pen, const Light& light, const HandleView& view, const Look& look) {
  const std::vector<LightHandle> handles = lightHandles(light, view);
  const glm::vec3 middle = handles.front().at;
  const auto at = view.project(middle);
  const bool sun = light.kind == LightKind::Directional;
  // A sun behind the subject.
  const bool behind = sun && glm::dot(light.direction, view.forward) > 0.05f;
  const ImU32 line = faded(look.selected ? theme::kAccent : look.hovered ? theme::grey(255) : theme::grey(215), behind && !look.selected ? 0.6f : 1);
  const float width = look.selected || look.hovered ? 1.6f : 1.2f;
  if (!look.plain) {
    const std::vector<LightLine> outline = lightOutline(light, view, look.selected);
    if (light.kind == LightKind::Rectangle && glm::dot(light.axis, view.eye - light.position) > 0) pen.fill(std::vector(outline[0].points.begin(), outline[0].points.end() - 1), colorOf(light, 0.14f));
    for (const LightLine& one : outline) pen.line(one.points, sun ? view.target : middle, faded(line, one.faint ? 0.45f : 1), one.faint ? 1 : width);
    if (sun)
      if (const auto tail = view.project(outline[0].points[0]), tip = view.project(outline[0].points[1]); tail && tip) pen.arrowHead(*tail, *tip, 9, line);
  }
  if (!at) return;
  const ImU32 color = colorOf(light);
  if (!look.plain) {
    if (sun) pen.rays(*at, 9, 13.5f, line);
    else if (light.kind == LightKind::Point) pen.ring(*at, 10, line, width);
  }
  if (look.selected)
    for (const LightHandle& handle : handles) {
      const auto p = view.project(handle.at);
      if (!p || &handle == &handles.front()) continue;
      const bool hot = look.grip == handle.grip;
      if (handle.grip == LightGrip::Aim) pen.arrowHead(*at, *p, 10, hot ? theme::grey(255) : line);
      if (handle.grip != LightGrip::Aim || glm::length(*p - *at) < theme::px(12)) pen.dot(*p, hot ? 4.2f : 3.2f, hot ? theme::grey(255) : theme::grey(32), line, 1.4f);
    }
  else if (!look.plain && (light.kind == LightKind::Spot || light.kind == LightKind::Rectangle))
    if (const auto tip = view.project(handles.back().at)) pen.arrowHead(*at, *tip, 8, line);
  const bool hot = look.grip == handles.front().grip;
  pen.dot(*at, sun ? 5.5f : hot ? 4.5f : 3.8f, color, line, hot || look.selected ? 1.8f : 1.2f);
}

// The light's name and its light, or what is being set.
void drawLabel(ImDrawList& list, const HandleView& view, ImVec2 low, glm::vec2 at, const std::string& title, const std::string& detail, bool selected) {
  ImFont* small = ui::fonts().small();
  const float line = small->FontSize, pad = theme::px(6), gap = theme::px(7);
  const auto width = [&](const std::string& t) { return small->CalcTextSizeA(line, FLT_MAX, 0, t.c_str()).x; };
  const float first = width(title), whole = first + gap + width(detail);
  ImVec2 p = on(low, at + glm::vec2(theme::px(18), -theme::px(30)));
  if (p.x + whole + pad > low.x + view.size.x) p.x = low.x + at.x - theme::px(18) - whole;
  p.x = std::max(p.x, low.x + pad + theme::px(2));
  if (p.y - theme::px(4) < low.y) p.y = low.y + at.y + theme::px(20);
  p.y = std::min(p.y, low.y + view.size.y - line - theme::px(6));
  p = {std::round(p.x), std::round(p.y)};
  list.AddRectFilled({p.x - pad, p.y - theme::px(4)}, {p.x + whole + pad, p.y + line + theme::px(4)}, theme::grey(20, 225), theme::px(4));
  list.AddText(small, line, p, selected ? theme::kAccent : theme::kText, title.c_str());
  list.AddText(small, line, {p.x + first + gap, p.y}, theme::grey(190), detail.c_str());
  ui::markRect("light label", p, {p.x + whole, p.y + line});
}

}  // namespace

std::optional<LightGizmos::Hit> LightGizmos::under(const std::vector<Light>& lights, int selected, const HandleView& view, glm::vec2 pointer) const {
  std::optional<Hit> found;
  float nearest = FLT_MAX;
  const auto take = [&](float distance, float reach, const Hit& hit) {
    if (distance > theme::px(reach) || distance >= nearest) return;
    nearest = distance;
    found = hit;
  };
  // Those of the selected light lie on top.
  if (selected >= 0 && size_t(selected) < lights.size() && isSound(lights[size_t(selected)]))
    for (const LightHandle& handle : lightHandles(lights[size_t(selected)], view))
      if (const auto p = view.project(handle.at); p && inside(view, *p)) take(glm::length(pointer - *p), kReach, {size_t(selected), handle.grip});
  if (found) return found;
  for (size_t i = 0; i < lights.size(); ++i) {
    if (!isSound(lights[i])) continue;
    const Place place = placeOf(lights[i], view);
    const LightGrip whole = lights[i].kind == LightKind::Directional ? LightGrip::Aim : LightGrip::Move;
    take(glm::length(pointer - place.at), kReach + (lights[i].kind == LightKind::Directional ? 4 : 0), {i, whole, place.edge});
  }
  if (found || lights.size() > kMostOutlined) return found;
  for (size_t i = 0; i < lights.size(); ++i) {
    if (!isSound(lights[i]) || placeOf(lights[i], view).edge) continue;
    const LightGrip whole = lights[i].kind == LightKind::Directional ? LightGrip::Aim : LightGrip::Move;
    for (const LightLine& line : lightOutline(lights[i], view, false))
      for (size_t k = 1; k < line.points.size(); ++k) {
        const auto a = view.project(line.points[k - 1]), b = view.project(line.points[k]);
        if (a && b) take(distanceTo(pointer, *a, *b), kLineReach, {i, whole});
      }
  }
  return found;
}

void LightGizmos::press(Editor& editor, const std::vector<Light>& lights, const Hit& hit, glm::vec2 pointer) {
  if (hit.edge && ImGui::IsMouseDoubleClicked(0)) editor.frameLights();
  editor.selectLight(int(hit.light), true);
  held_ = hit;
  start_ = lights[hit.light];
  from_ = pointer;
  moved_ = false;
}

void LightGizmos::drag(Editor& editor, const HandleView& view, glm::vec2 pointer) {
  Preview preview = editor.document().preview();
  if (held_->edge || held_->light >= preview.lights.size()) return;
  moved_ |= glm::length(pointer - from_) > theme::px(kStill);
  if (!moved_) return;
  Light& light = preview.lights[held_->light];
  const Light before = light;
  light = dragged(start_, held_->grip, view, from_, pointer, ImGui::GetIO().KeyShift);
  if (light != before) editor.document().setPreview(stepLabel(held_->grip), preview);
}

void LightGizmos::keys(Editor& editor, const HandleView& view, bool hovered) {
  // The graph has the same keys: they are the viewport's when it was clicked last and the pointer is still over it.
  if (!hovered || !ImGui::IsWindowFocused() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
  const int selected = editor.selectedLight();
  Preview preview = editor.document().preview();
  if (selected < 0 || size_t(selected) >= preview.lights.size()) return;
  if (shortcut(kNoModifiers, Key::Delete)) {
    preview.lights.erase(preview.lights.begin() + selected);
    editor.document().setPreview("Remove light", preview);
    editor.selectLight(-1);
  } else if (shortcut(kControl, Key::D)) {
    preview.lights.push_back(placedBeside(preview.lights[size_t(selected)], view));
    editor.document().setPreview("Copy light", preview);
    editor.selectLight(int(preview.lights.size()) - 1, true);
  } else if (shortcut(kNoModifiers, Key::Escape)) {
    editor.selectLight(-1);
  }
}

bool LightGizmos::draw(Editor& editor, ImVec2 low, ImVec2 size, bool hovered) {
  const Preview& preview = editor.document().preview();
  const FrameResult& frame = editor.shown();
  if (!editor.session().lightGizmos || preview.subject != Preview::Subject::Mesh || frame.comparison || !frame.texture) {
    held_.reset();
    return false;
  }
  // The picture's own size, so that lights stay on it while the panel is being resized.
  const glm::vec2 pixels = glm::max(glm::vec2(frame.layoutSize), glm::vec2(8));
  const HandleView view(preview.orbit.camera(1), pixels, theme::scale());
  const glm::vec2 pointer(ImGui::GetIO().MousePos.x - low.x, ImGui::GetIO().MousePos.y - low.y);

  if (held_ && !ImGui::IsMouseDown(0)) held_.reset();
  std::optional<Hit> hit = held_;
  if (!hit && hovered && (!ImGui::IsAnyMouseDown() || ImGui::IsMouseClicked(0))) hit = under(preview.lights, editor.selectedLight(), view, pointer);
  if (hit && !held_ && ImGui::IsMouseClicked(0) && !ImGui::GetIO().KeyCtrl) press(editor, preview.lights, *hit, pointer);
  else if (!hit && hovered && ImGui::IsMouseClicked(0)) pressedBeside_ = pointer;
  if (pressedBeside_ && ImGui::IsMouseReleased(0)) {
    if (glm::length(pointer - *pressedBeside_) < theme::px(kStill)) editor.selectLight(-1);
    pressedBeside_.reset();
  }
  const bool taken = held_.has_value();
  if (held_) drag(editor, view, pointer);
  else keys(editor, view, hovered);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
  Pen pen(list, view, low);
  const int selected = editor.selectedLight();
  const std::vector<Light>& lights = editor.document().preview().lights;
  const auto one = [&](size_t i) {
    const Light& light = lights[i];
    if (!isSound(light)) return;
    Look look{.selected = int(i) == selected, .hovered = hit && hit->light == i, .plain = lights.size() > kMostOutlined && int(i) != selected};
    if (look.hovered) look.grip = hit->grip;
    const Place place = placeOf(light, view);
    drawLight(pen, light, view, look);
    if (place.edge) drawEdge(pen, light, view, place.at, look);
    const std::string base = "light:" + std::to_string(i) + ":";
    const float half = theme::px(kReach);
    const auto mark = [&](const std::string& what, glm::vec2 p) { ui::markRect(base + what, on(low, p - half), on(low, p + half)); };
    if (place.edge) mark("edge", place.at);
    for (const LightHandle& handle : lightHandles(light, view))
      if (const auto p = view.project(handle.at); p && inside(view, *p) && (look.selected || handle.grip == LightGrip::Move || light.kind == LightKind::Directional)) mark(name(handle.grip), *p);
  };
  for (size_t i = 0; i < lights.size(); ++i)
    if (int(i) != selected) one(i);
  if (selected >= 0 && size_t(selected) < lights.size()) one(size_t(selected));
  if (hit && hit->light < lights.size()) {
    const Light& light = lights[hit->light];
    const Place place = placeOf(light, view);
    drawLabel(list, view, low, place.at, titleOf(light, hit->light),
              held_ && moved_ ? gripText(light, held_->grip) : lightIntensity(light) + (place.edge ? ", out of view: double-click to see it" : ""), int(hit->light) == selected);
  }
  list.PopClipRect();
  return taken || (hit && !ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(0));
}

}  // namespace glint
