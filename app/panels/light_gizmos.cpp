#include "app/panels/light_gizmos.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/keys.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"

namespace glint {
namespace {

// UI units.
constexpr float kReach = 9, kLineReach = 5, kStill = 3, kEdge = 16, kInset = 6;
// Beyond so many, lights that are not selected are dots.
constexpr size_t kMostOutlined = 64;

// Where the sign of a light is: by its place in the picture, or on the edge.
struct Place {
  glm::vec2 at{0};
  bool edge = false;
};
Place placeOf(const Light& light, const HandleView& view) {
  const glm::vec3 anchor = lightHandles(light, view, 0).front().at;
  const auto seen = view.project(anchor);
  if (seen && view.inside(*seen, kInset)) return {*seen, false};
  return {view.edge(anchor, kEdge), true};
}

float distanceTo(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 d = b - a;
  const float length = glm::dot(d, d), t = length > 0 ? std::clamp(glm::dot(p - a, d) / length, 0.0f, 1.0f) : 0;
  return glm::length(p - (a + t * d));
}

std::string titleOf(const Light& light, size_t index) { return fmt::format("{} {}", infoOf(light.kind).title, index + 1); }
bool turns(const Light& light) { return light.kind != LightKind::Point && light.kind != LightKind::Sphere; }

}  // namespace

float LightGizmos::aimOf(const Light& light, size_t index, const HandleView& view) const { return int(index) == aimLight_ ? aim_ : aimDistance(light, view); }

std::optional<LightGizmos::Hit> LightGizmos::under(const std::vector<Light>& lights, int selected, const HandleView& view, glm::vec2 pointer) const {
  std::optional<Hit> found;
  float nearest = FLT_MAX;
  const auto take = [&](float distance, float reach, const Hit& hit) {
    if (distance > theme::px(reach) || distance >= nearest) return;
    nearest = distance;
    found = hit;
  };
  // Those of the selected light lie on top, and of them the small ones on its axes.
  if (selected >= 0 && size_t(selected) < lights.size() && isSound(lights[size_t(selected)])) {
    const Light& light = lights[size_t(selected)];
    const std::vector<LightHandle> handles = lightHandles(light, view, aimOf(light, size_t(selected), view));
    for (const bool axes : {false, true}) {
      for (const LightHandle& handle : handles) {
        const auto p = view.project(handle.at);
        if (!p || !view.inside(*p, kInset) || axes != (axisOf(handle.grip) >= 0 || planeOf(handle.grip) >= 0)) continue;
        take(glm::length(pointer - *p), kReach, {size_t(selected), handle.grip});
      }
      if (found) return found;
    }
    const auto middle = view.project(light.position);
    for (const LightHandle& handle : handles)
      if (const auto p = view.project(handle.at); p && middle && axisOf(handle.grip) >= 0)
        take(distanceTo(pointer, glm::mix(*middle, *p, 0.3f), *p), kLineReach, {size_t(selected), handle.grip});
    if (found) return found;
  }
  for (size_t i = 0; i < lights.size(); ++i) {
    if (!isSound(lights[i])) continue;
    const Place place = placeOf(lights[i], view);
    take(glm::length(pointer - place.at), kReach + (lights[i].kind == LightKind::Directional ? 4 : 0), {i, wholeGrip(lights[i]), place.edge});
  }
  if (found || lights.size() > kMostOutlined) return found;
  for (size_t i = 0; i < lights.size(); ++i) {
    if (!isSound(lights[i]) || placeOf(lights[i], view).edge) continue;
    for (const LightLine& line : lightOutline(lights[i], view, false))
      for (size_t k = 1; k < line.points.size(); ++k) {
        const auto a = view.project(line.points[k - 1]), b = view.project(line.points[k]);
        if (a && b) take(distanceTo(pointer, *a, *b), kLineReach, {i, wholeGrip(lights[i])});
      }
  }
  return found;
}

void LightGizmos::take(Editor& editor, const Hit& hit, const Pointer& pointer) {
  held_ = hit;
  start_ = editor.document().preview().lights[hit.light];
  from_ = pointer.at;
  startAim_ = aimOf(start_, hit.light, pointer.view);
  moved_ = false;
}

void LightGizmos::drag(Editor& editor, const Pointer& pointer) {
  if (loose_) editor.keepEditing();
  Preview preview = editor.document().preview();
  if (held_->light >= preview.lights.size()) return held_.reset();
  if (held_->edge) return;
  moved_ |= loose_ || glm::length(pointer.at - from_) > theme::px(kStill);
  if (!moved_) return;
  const ImGuiIO& io = ImGui::GetIO();
  LightDrag now{.grip = held_->grip, .from = from_, .to = pointer.at, .aim = startAim_, .straight = io.KeyShift && !loose_, .snap = io.KeyCtrl, .surface = {}};
  if (held_->grip == LightGrip::Aim && start_.kind != LightKind::Directional) {
    if (io.KeyShift && pointer.depth)
      if (const auto surface = pointer.depth->under(pointer.view, pointer.at)) now.surface = surface->at;
    aimLight_ = int(held_->light);
    aim_ = draggedAim(start_, pointer.view, now);
  }
  Light& light = preview.lights[held_->light];
  const Light before = light;
  light = dragged(start_, pointer.view, now);
  if (light != before) editor.document().setPreview(stepLabel(held_->grip), preview);
}

void LightGizmos::cancel(Editor& editor) {
  Preview preview = editor.document().preview();
  if (moved_ && held_->light < preview.lights.size()) {
    preview.lights[held_->light] = start_;
    editor.document().setPreview(stepLabel(held_->grip), preview);
    aim_ = startAim_;
  }
  held_.reset();
  swallow_ = true;
}

// While something is held: what it is bound to.
void LightGizmos::heldKeys(Editor& editor) {
  if (ImGui::IsMouseClicked(1) || keyPressed(Key::Escape)) return cancel(editor);
  if (!loose_) return;
  if (ImGui::IsMouseClicked(0) || keyPressed(Key::Enter)) {
    held_.reset();
    swallow_ = true;
    return;
  }
  if (held_->grip > LightGrip::PlaneZ) return;
  constexpr Key kKeys[] = {Key::X, Key::Y, Key::Z};
  for (int i = 0; i < 3; ++i) {
    if (!keyPressed(kKeys[i])) continue;
    const auto wanted = LightGrip(int(ImGui::GetIO().KeyShift ? LightGrip::PlaneX : LightGrip::AxisX) + i);
    held_->grip = held_->grip == wanted ? LightGrip::Move : wanted;
  }
}

void LightGizmos::keys(Editor& editor, const Pointer& pointer) {
  // The graph has the same keys: they are the viewport's when it was clicked last and the pointer is still over it.
  if (!pointer.hovered || !ImGui::IsWindowFocused() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
  const int selected = editor.selectedLight();
  Preview preview = editor.document().preview();
  if (selected < 0 || size_t(selected) >= preview.lights.size()) return;
  Light& light = preview.lights[size_t(selected)];
  const auto begin = [&](LightGrip grip) {
    take(editor, {size_t(selected), grip}, pointer);
    loose_ = true;
    editor.keepEditing();
  };
  if (shortcut(kNoModifiers, Key::Delete) || shortcut(kNoModifiers, Key::X) || shortcut(kNoModifiers, Key::Backspace)) {
    preview.lights.erase(preview.lights.begin() + selected);
    editor.document().setPreview("Remove light", preview);
    editor.selectLight(-1);
  } else if (shortcut(kControl, Key::D)) {
    preview.lights.push_back(placedBeside(light, pointer.view));
    editor.document().setPreview("Copy light", preview);
    editor.selectLight(int(preview.lights.size()) - 1, true);
  } else if (shortcut(kNoModifiers, Key::Escape)) {
    editor.selectLight(-1);
  } else if (!isSound(light)) {
    return;
  } else if (shortcut(kNoModifiers, Key::G)) {
    begin(wholeGrip(light));
  } else if (shortcut(kNoModifiers, Key::R)) {
    if (turns(light)) begin(light.kind == LightKind::Directional ? LightGrip::Aim : LightGrip::Turn);
    else editor.say("A " + std::string(infoOf(light.kind).id) + " light shines to all sides: there is nothing to turn");
  } else if (shortcut(kNoModifiers, Key::S)) {
    begin(LightGrip::Scale);
  } else if (const bool aims = shortcut(kNoModifiers, Key::T), shines = shortcut(kNoModifiers, Key::H); aims || shines) {
    const auto surface = pointer.depth ? pointer.depth->under(pointer.view, pointer.at) : std::nullopt;
    const bool points = light.kind == LightKind::Spot || light.kind == LightKind::Rectangle;
    if (!surface) return editor.say("Point at a surface");
    if (aims && !points) return editor.say("Only spots and rectangles are aimed at a place");
    light = aims ? aimedAt(light, surface->at) : highlighting(light, pointer.view, surface->at, surface->normal);
    editor.document().setPreview(aims ? "Aim light" : "Place highlight", preview);
    aimLight_ = selected;
    aim_ = glm::length(surface->at - light.position);
  }
}

void LightGizmos::input(Editor& editor, const Pointer& pointer, std::optional<Hit>& hit) {
  if (!ImGui::IsAnyMouseDown()) swallow_ = false;
  if (held_ && !loose_ && !ImGui::IsMouseDown(0)) held_.reset();
  if (held_) heldKeys(editor);
  if (!held_) loose_ = false;
  const std::vector<Light>& lights = editor.document().preview().lights;
  hit = held_;
  const bool clicked = ImGui::IsMouseClicked(0) && !swallow_;
  if (!hit && !swallow_ && pointer.hovered && (!ImGui::IsAnyMouseDown() || clicked)) hit = under(lights, editor.selectedLight(), pointer.view, pointer.at);
  if (hit && !held_ && clicked) {
    if (hit->edge && ImGui::IsMouseDoubleClicked(0)) editor.frameLights();
    if (editor.selectedLight() != int(hit->light)) aimLight_ = -1;
    editor.selectLight(int(hit->light), true);
    take(editor, *hit, pointer);
  } else if (!hit && pointer.hovered && clicked) {
    pressedBeside_ = pointer.at;
  }
  if (pressedBeside_ && ImGui::IsMouseReleased(0)) {
    if (glm::length(pointer.at - *pressedBeside_) < theme::px(kStill)) editor.selectLight(-1);
    pressedBeside_.reset();
  }
  if (editor.selectedLight() != aimLight_) aimLight_ = -1;
  if (held_) drag(editor, pointer);
  else if (!swallow_) keys(editor, pointer);
  if (held_) hit = held_;
}

std::string LightGizmos::detailOf(const Light& light, const Hit& hit) const {
  if (!held_) {
    if (hit.edge) return lightIntensity(light) + ", out of view: double-click to see it";
    return hit.grip == wholeGrip(light) ? lightIntensity(light) : gripText(light, hit.grip);
  }
  const std::string set = moved_ ? gripText(light, held_->grip) : lightIntensity(light);
  if (!loose_) return set;
  return set + (held_->grip <= LightGrip::PlaneZ ? "  \u00b7  X Y Z: along an axis, click: done, Esc: back" : "  \u00b7  click: done, Esc: back");
}

void LightGizmos::drawAll(Editor& editor, const LightCanvas& canvas, const std::optional<Hit>& hit) const {
  const HandleView& view = canvas.view;
  const std::vector<Light>& lights = editor.document().preview().lights;
  const int selected = editor.selectedLight();
  const auto one = [&](size_t i) {
    const Light& light = lights[i];
    if (!isSound(light)) return;
    LightLook look{.selected = int(i) == selected, .hovered = hit && hit->light == i, .plain = lights.size() > kMostOutlined && int(i) != selected, .grip = {}};
    if (look.hovered) look.grip = hit->grip;
    look.held = look.hovered && held_ && moved_;
    const Place place = placeOf(light, view);
    const float aim = aimOf(light, i, view);
    drawLight(canvas, light, aim, look);
    if (place.edge) drawLightEdge(canvas, light, place.at, look);
    const std::string base = "light:" + std::to_string(i) + ":";
    const float half = theme::px(kReach);
    const auto mark = [&](const std::string& what, glm::vec2 p) {
      const ImVec2 at{canvas.low.x + p.x, canvas.low.y + p.y};
      ui::markRect(base + what, {at.x - half, at.y - half}, {at.x + half, at.y + half});
    };
    if (place.edge) mark("edge", place.at);
    for (const LightHandle& handle : lightHandles(light, view, aim))
      if (const auto p = view.project(handle.at); p && view.inside(*p, kInset) && (look.selected || handle.grip == wholeGrip(light))) mark(name(handle.grip), *p);
  };
  for (size_t i = 0; i < lights.size(); ++i)
    if (int(i) != selected) one(i);
  if (selected >= 0 && size_t(selected) < lights.size()) one(size_t(selected));
  if (!hit || hit->light >= lights.size()) return;
  const Light& light = lights[hit->light];
  const glm::vec2 middle = placeOf(light, view).at;
  glm::vec2 at = middle;
  if (!hit->edge)
    for (const LightHandle& handle : lightHandles(light, view, aimOf(light, hit->light, view)))
      if (const auto p = view.project(handle.at); p && handle.grip == hit->grip) at = *p;
  drawLightLabel(canvas, at, at - middle, titleOf(light, hit->light), detailOf(light, *hit), int(hit->light) == selected);
}

bool LightGizmos::draw(Editor& editor, ImVec2 low, ImVec2 size, bool hovered) {
  const FrameResult& frame = editor.shown();
  if (!editor.session().lightGizmos || editor.document().preview().subject != Preview::Subject::Mesh || frame.comparison || !frame.texture) {
    held_.reset();
    return false;
  }
  // As the picture was taken, so that lights stay on it while the panel is being resized or the next is drawn.
  const HandleView view(frame.camera, glm::max(glm::vec2(frame.layoutSize), glm::vec2(8)), theme::scale());
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Pointer pointer{view, frame.depth.get(), {mouse.x - low.x, mouse.y - low.y}, hovered};
  std::optional<Hit> hit;
  input(editor, pointer, hit);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
  drawAll(editor, {list, view, frame.depth.get(), low}, hit);
  list.PopClipRect();
  return held_ || swallow_;
}

}  // namespace glint
