#include "app/panels/graph_panel.h"

#include <algorithm>
#include <cmath>

#include "app/editor/keys.h"
#include "app/editor/node_values.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "materials/graph_validate.h"
#include "materials/material_json.h"

namespace glint {
void GraphPanel::draw(Editor& editor) {
  toolbar(editor);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImVec2 size = ImGui::GetContentRegionAvail();
  size = {std::max(1.0f, size.x), std::max(1.0f, size.y)};
  const ImVec2 high = {low.x + size.x, low.y + size.y};
  canvas_.begin(low, high, editor.fonts());
  refresh(editor);
  if (frameWanted_ && size.x > 40 && size.y > 40) {
    if (std::exchange(first_, false)) frameOutput(editor.document().material());
    else frame();
    frameWanted_ = false;
  }
  if (size.x > 40 && size.y > 40)
    if (const NodeShape* shape = canvas_.shape(editor.takeRevealed()))
      canvas_.reveal(shape->position, {shape->position.x + shape->size.x, shape->position.y + shape->size.y});

  ImGui::InvisibleButton("canvas", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                                             ImGuiButtonFlags_MouseButtonMiddle);
  ui::mark("canvas");
  const bool hovered = ImGui::IsItemHovered();
  control(editor, hovered);
  if (hovered || ImGui::IsWindowFocused()) keys(editor);
  refresh(editor);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, high, true);
  canvas_.drawGrid();
  const Material& material = editor.document().material();
  for (const NodeId& id : canvas_.order())
    if (const NodeShape* shape = canvas_.shape(id); shape && shape->comment) drawComment(editor, id, *shape);
  drawWires(editor);
  for (const NodeId& id : canvas_.order()) {
    const NodeShape* shape = canvas_.shape(id);
    const Node* node = material.node(id);
    if (shape && node && !shape->comment) drawNode(editor, id, *node, *shape);
  }
  drawWiresBehindNodes(editor);
  drawWireBeingDragged(editor);
  if (mode_ == Mode::Box && moved_) {
    const ImVec2 a = pressed_, b = ImGui::GetIO().MousePos;
    list.AddRectFilled({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}, theme::grey(255, 14));
    list.AddRect({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}, theme::grey(255, 90));
  }
  if (mode_ == Mode::Knife)
    list.AddPolyline(knife_.data(), int(knife_.size()), theme::kError, 0, theme::px(1.5f));
  if (material.nodes.size() <= 1)
    canvas_.text({low.x + theme::px(16), high.y - theme::px(30)}, theme::kTextFaint, "Tab or right click adds a node");
  list.PopClipRect();

  if (const NodeKind* kind = menu_.draw(editor.nodes())) addChosen(editor, *kind);
  valuePopup(editor);
}

void GraphPanel::toolbar(Editor& editor) {
  const float height = theme::px(34);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height}, theme::kPanel);
  ImGui::SetCursorScreenPos({low.x + theme::px(8), low.y + (height - ImGui::GetFrameHeight()) / 2});
  if (ui::button("Add node")) {
    menuAt_ = canvas_.toSheet({(canvas_.low().x + canvas_.high().x) / 2, (canvas_.low().y + canvas_.high().y) / 2});
    menuWire_.reset();
    menu_.open();
  }
  ui::tooltip("Tab, or right click on the canvas");
  ImGui::SameLine();
  if (ui::button("Tidy up")) {
    const auto positions = tidyPositions(editor.document().material(), canvas_);
    editor.refused(editor.document().edit("Tidy up", [&](GraphEditor& graph) { return graph.move(positions); }));
    frameWanted_ = true;
  }
  ImGui::SameLine();
  if (ui::button("Frame all")) frameWanted_ = true;
  ui::tooltip("Home over the canvas; F frames what is selected");
  ImGui::SameLine(0, theme::px(14));
  const Material& material = editor.document().material();
  ImGui::AlignTextToFramePadding();
  ui::textDim(material.name + "  \u00b7  " + std::to_string(material.nodes.size()) + (material.nodes.size() == 1 ? " node" : " nodes"));
  ImGui::SetCursorScreenPos({low.x, low.y + height});
}

void GraphPanel::refresh(Editor& editor) {
  Document& document = editor.document();
  const Material& material = document.material();
  const GraphContext context = editor.graphContext();
  const bool modelChanged = model_ != context.model || scale_ != theme::scale();
  if (typed_ != document.meaningRevision() || modelChanged) {
    types_ = outputTypes(material, context);
    typed_ = document.meaningRevision();
  }
  if (laidOut_ != document.graphRevision() || modelChanged) {
    const bool first = canvas_.shapes().empty();
    canvas_.layOut(material, context);
    const bool placed = std::all_of(material.nodes.begin(), material.nodes.end(),
                                    [&](const auto& item) { return material.layout.count(item.first); });
    if (!placed) {
      if (fallback_.empty() || first) fallback_ = tidyPositions(material, canvas_);
      std::map<NodeId, Position> missing;
      for (const auto& [id, position] : fallback_)
        if (!material.layout.count(id)) missing[id] = position;
      canvas_.place(missing);
    } else {
      fallback_.clear();
    }
    if (framed_ != document.identity()) {
      framed_ = document.identity();
      frameWanted_ = first_ = true;
    }
    laidOut_ = document.graphRevision();
    model_ = context.model;
    scale_ = theme::scale();
  }
  errors_.clear();
  for (const Diagnostic& d : editor.problems()) {
    const size_t at = d.place.find("node '");
    if (at == std::string::npos || d.severity != Severity::Error) continue;
    const size_t end = d.place.find('\'', at + 6);
    std::string& text = errors_[d.place.substr(at + 6, end - at - 6)];
    text += (text.empty() ? "" : "\n") + d.what + (d.hint.empty() ? "" : "; " + d.hint);
  }
}

void GraphPanel::frame(const std::set<NodeId>& only) {
  ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
  for (const auto& [id, shape] : canvas_.shapes()) {
    if (!only.empty() && !only.count(id)) continue;
    low = {std::min(low.x, shape.position.x), std::min(low.y, shape.position.y)};
    high = {std::max(high.x, shape.position.x + shape.size.x), std::max(high.y, shape.position.y + shape.size.y)};
  }
  if (low.x < high.x) canvas_.show(low, high);
}

void GraphPanel::frameOutput(const Material& material) {
  ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
  for (const auto& [id, shape] : canvas_.shapes()) {
    low = {std::min(low.x, shape.position.x), std::min(low.y, shape.position.y)};
    high = {std::max(high.x, shape.position.x + shape.size.x), std::max(high.y, shape.position.y + shape.size.y)};
  }
  if (low.x >= high.x) return;
  const NodeShape* output = canvas_.shape(material.outputNode());
  canvas_.showReadable(low, high, output ? ImVec2{output->position.x + output->size.x, output->position.y + output->size.y / 2}
                                         : ImVec2{high.x, (low.y + high.y) / 2});
}

void GraphPanel::control(Editor& editor, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse = io.MousePos;
  if (hovered && io.MouseWheel != 0) canvas_.zoomAt(mouse, io.MouseWheel > 0 ? 1 : -1);
  if (mode_ == Mode::None && hovered) {
    const auto begin = [&](Mode mode) {
      mode_ = mode;
      pressed_ = last_ = mouse;
      moved_ = false;
    };
    if (ImGui::IsMouseClicked(0)) {
      begin(Mode::None);
      press(editor, mouse);
    } else if (ImGui::IsMouseClicked(2)) {
      begin(Mode::Pan);
      fromRight_ = false;
    } else if (ImGui::IsMouseClicked(1)) {
      if (io.KeyCtrl) {
        begin(Mode::Knife);
        knife_ = {mouse};
      } else if (const auto wire = io.KeyShift ? canvas_.wireAt(mouse, editor.document().material()) : std::nullopt) {
        insertReroute(editor, *wire, mouse);
      } else {
        begin(Mode::Pan);
        fromRight_ = true;
      }
    }
  }
  if (mode_ == Mode::None) return;
  if (std::hypot(mouse.x - pressed_.x, mouse.y - pressed_.y) > theme::px(3)) moved_ = true;
  const bool released = mode_ == Mode::Pan ? !(ImGui::IsMouseDown(2) || ImGui::IsMouseDown(1))
                        : mode_ == Mode::Knife ? !ImGui::IsMouseDown(1) : !ImGui::IsMouseDown(0);
  Document& document = editor.document();
  const ImVec2 delta = {mouse.x - last_.x, mouse.y - last_.y};
  switch (mode_) {
    case Mode::Pan:
      if (moved_) canvas_.pan(delta);
      break;
    case Mode::Move:
      if (moved_ && (delta.x != 0 || delta.y != 0) && !released) {
        std::map<NodeId, Position> positions;
        for (const auto& [id, start] : moveStart_) {
          Position p{start.x + (mouse.x - pressed_.x) / canvas_.unit(), start.y + (mouse.y - pressed_.y) / canvas_.unit()};
          const float snap = io.KeyCtrl ? 24.0f : 1.0f;
          positions[id] = {std::round(p.x / snap) * snap, std::round(p.y / snap) * snap};
        }
        document.edit(positions.size() == 1 ? "Move node" : "Move " + std::to_string(positions.size()) + " nodes",
                      [&](GraphEditor& graph) { return graph.move(positions); });
      }
      break;
    case Mode::Box:
      if (moved_) {
        const ImVec2 a = canvas_.toSheet(pressed_), b = canvas_.toSheet(mouse);
        std::set<NodeId> chosen = boxStart_;
        for (const auto& [id, shape] : canvas_.shapes()) {
          const bool apart = shape.position.x > std::max(a.x, b.x) || shape.position.x + shape.size.x < std::min(a.x, b.x) ||
                             shape.position.y > std::max(a.y, b.y) || shape.position.y + shape.size.y < std::min(a.y, b.y);
          if (!apart && !shape.comment) chosen.insert(id);
        }
        editor.selection() = chosen;
      }
      break;
    case Mode::Knife: knife_.push_back(mouse); break;
    case Mode::Value:
      if (moved_ && delta.x != 0) {
        const Node* node = document.material().node(value_.node);
        const NodeShape* shape = canvas_.shape(value_.node);
        const Pin* pin = shape && shape->pins ? shape->pins->input(value_.pin) : nullptr;
        if (!node || !pin) break;
        Value value = inputValue(*node, *pin);
        const float range = pin->maximum > pin->minimum && pin->maximum - pin->minimum < 1e4f ? pin->maximum - pin->minimum : 2;
        float x = value.v[0] + delta.x / theme::scale() * range / 220 * (io.KeyShift ? 0.1f : 1.0f);
        if (pin->maximum > pin->minimum) x = std::clamp(x, pin->minimum, pin->maximum);
        std::fill_n(value.v.begin(), std::max(1, componentCount(value.type)), x);
        editor.refused(document.edit("Set " + pinTitle(*pin), [&](GraphEditor& graph) { return graph.setValue(value_, value); }));
      }
      break;
    case Mode::Resize:
      if (moved_) {
        const float w = std::max(80.0f, resizeStart_.x + (mouse.x - pressed_.x) / canvas_.unit());
        const float h = std::max(50.0f, resizeStart_.y + (mouse.y - pressed_.y) / canvas_.unit());
        document.edit("Resize comment", [&](GraphEditor& graph) {
          graph.setSetting(resized_, "width", Json::of(std::round(w)));
          return graph.setSetting(resized_, "height", Json::of(std::round(h)));
        });
      }
      break;
    default: break;
  }
  last_ = mouse;
  if (released) release(editor, mouse);
}

void GraphPanel::press(Editor& editor, ImVec2 mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  Document& document = editor.document();
  const Material& material = document.material();
  pressed_ = last_ = mouse;
  const auto output = canvas_.outputAt(mouse);
  const auto input = output ? std::nullopt : canvas_.inputAt(mouse);
  if (io.KeyAlt) {
    // Cut: every wire of a pin, or the wire under the pointer.
    std::vector<PinRef> ends;
    if (output) ends = wiresFrom(material, output->node, output->pin);
    else if (input) ends = {*input};
    else if (const auto wire = canvas_.wireAt(mouse, material)) ends = {*wire};
    if (!ends.empty()) {
      editor.refused(document.edit("Cut wire", [&](GraphEditor& graph) {
        Diagnostics refusal;
        for (const PinRef& end : ends) refusal = graph.disconnect(end);
        return refusal;
      }));
      return;
    }
  }
  if (output) {
    wire_ = *output;
    wireFromOutput_ = true;
    detached_.reset();
    mode_ = Mode::Wire;
    return;
  }
  if (input) {
    const Node* node = material.node(input->node);
    const auto found = node->inputs.find(input->pin);
    if (found != node->inputs.end() && found->second.from) {
      wire_ = *found->second.from;
      wireFromOutput_ = true;
      detached_ = *input;
    } else {
      wire_ = *input;
      wireFromOutput_ = false;
      detached_.reset();
    }
    mode_ = Mode::Wire;
    return;
  }
  if (const auto field = fieldAt(editor, mouse)) {
    const NodeShape* shape = canvas_.shape(field->node);
    const Pin* pin = shape->pins->input(field->pin);
    const Node* node = material.node(field->node);
    Value value = inputValue(*node, *pin);
    editor.selection() = {field->node};
    if (value.type == ValueType::Bool) {
      value.v[0] = value.v[0] == 0;
      editor.refused(document.edit("Set " + pinTitle(*pin), [&](GraphEditor& graph) { return graph.setValue(*field, value); }));
    } else if (value.type == ValueType::Color || componentCount(value.type) > 1 || ImGui::IsMouseDoubleClicked(0)) {
      popupPin_ = *field;
      popupWanted_ = "pin-value";
    } else {
      value_ = *field;
      mode_ = Mode::Value;
    }
    return;
  }
  const auto id = canvas_.nodeAt(mouse);
  if (!id) {
    if (const auto wire = canvas_.wireAt(mouse, material)) {
      if (ImGui::IsMouseDoubleClicked(0)) return insertReroute(editor, *wire, mouse);
    }
    // The corner of a comment resizes it.
    const ImVec2 p = canvas_.toSheet(mouse);
    for (const auto& [comment, shape] : canvas_.shapes()) {
      if (!shape.comment || p.x < shape.position.x + shape.size.x - 14 || p.x > shape.position.x + shape.size.x ||
          p.y < shape.position.y + shape.size.y - 14 || p.y > shape.position.y + shape.size.y)
        continue;
      resized_ = comment;
      resizeStart_ = shape.size;
      editor.selection() = {comment};
      mode_ = Mode::Resize;
      return;
    }
    boxStart_ = io.KeyShift || io.KeyCtrl ? editor.selection() : std::set<NodeId>{};
    editor.selection() = boxStart_;
    mode_ = Mode::Box;
    return;
  }
  auto& selection = editor.selection();
  if (io.KeyShift || io.KeyCtrl) {
    if (!selection.erase(*id)) selection.insert(*id);
  } else if (!selection.count(*id)) {
    selection = {*id};
  }
  canvas_.raise(*id);
  moveStart_.clear();
  std::set<NodeId> moving = selection;
  // A comment takes along what lies on it.
  for (const NodeId& one : selection)
    if (const NodeShape* outer = canvas_.shape(one); outer && outer->comment)
      for (const auto& [other, inner] : canvas_.shapes())
        if (inner.position.x >= outer->position.x && inner.position.y >= outer->position.y &&
            inner.position.x + inner.size.x <= outer->position.x + outer->size.x &&
            inner.position.y + inner.size.y <= outer->position.y + outer->size.y)
          moving.insert(other);
  for (const NodeId& one : moving)
    if (const NodeShape* shape = canvas_.shape(one)) moveStart_[one] = {shape->position.x, shape->position.y};
  mode_ = Mode::Move;
}

void GraphPanel::release(Editor& editor, ImVec2 mouse) {
  const Mode mode = std::exchange(mode_, Mode::None);
  if (mode == Mode::Wire) dropWire(editor, mouse);
  if (mode == Mode::Pan && fromRight_ && !moved_) openMenu(editor, mouse);
  if (mode == Mode::Move && moved_ && moveStart_.size() == 1) insertOnWire(editor, moveStart_.begin()->first);
  if (mode == Mode::Move && !moved_ && !ImGui::GetIO().KeyShift && !ImGui::GetIO().KeyCtrl)
    if (const auto id = canvas_.nodeAt(mouse)) editor.selection() = {*id};
  if (mode == Mode::Knife) {
    std::set<PinRef> cut;
    for (size_t i = 1; i < knife_.size(); ++i)
      for (const PinRef& end : canvas_.wiresCrossing(knife_[i - 1], knife_[i], editor.document().material())) cut.insert(end);
    if (!cut.empty())
      editor.refused(editor.document().edit("Cut wires", [&](GraphEditor& graph) {
        Diagnostics refusal;
        graph.beginGesture("Cut wires");
        for (const PinRef& end : cut) refusal = graph.disconnect(end);
        graph.endGesture();
        return refusal;
      }));
    knife_.clear();
  }
}

void GraphPanel::keys(Editor& editor) {
  if (menu_.isOpen() || mode_ != Mode::None || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
  const Material& material = editor.document().material();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool over = mouse.x >= canvas_.low().x && mouse.x < canvas_.high().x && mouse.y >= canvas_.low().y && mouse.y < canvas_.high().y;
  const ImVec2 at = over ? mouse : ImVec2{(canvas_.low().x + canvas_.high().x) / 2, (canvas_.low().y + canvas_.high().y) / 2};
  if (shortcut(kNoModifiers, Key::Tab) || (over && shortcut(kNoModifiers, Key::Space))) openMenu(editor, at);
  if (shortcut(kNoModifiers, Key::Delete) || shortcut(kNoModifiers, Key::X) || shortcut(kNoModifiers, Key::Backspace)) remove(editor);
  if (shortcut(kControl, Key::A)) {
    editor.selection().clear();
    for (const auto& [id, node] : material.nodes) editor.selection().insert(id);
  }
  if (shortcut(kControl, Key::C)) copy(editor);
  if (shortcut(kControl, Key::X)) {
    copy(editor);
    remove(editor);
  }
  if (shortcut(kControl, Key::V)) {
    const char* text = ImGui::GetClipboardText();
    auto clip = parseClip(text ? text : "", editor.nodes());
    if (clip) paste(editor, *clip, canvas_.toSheet(at));
    else editor.say("The clipboard holds no nodes", true);
  }
  if (shortcut(kControl, Key::D) && !editor.selection().empty()) {
    const Clip clip = copyNodes(material, editor.selection());
    ImVec2 low{1e9f, 1e9f};
    for (const NodeId& id : editor.selection())
      if (const NodeShape* shape = canvas_.shape(id)) low = {std::min(low.x, shape->position.x), std::min(low.y, shape->position.y)};
    paste(editor, clip, {low.x + 30, low.y + 30});
  }
  if (over && shortcut(kNoModifiers, Key::F)) frame(editor.selection());
  if (over && (shortcut(kNoModifiers, Key::Home) || shortcut(kNoModifiers, Key::A))) frame();
  if (over && shortcut(kNoModifiers, Key::C)) comment(editor);
}

std::unique_ptr<Panel> makeGraphPanel() { return std::make_unique<GraphPanel>(); }

}  // namespace glint
