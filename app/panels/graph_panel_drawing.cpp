#include <algorithm>
#include <cmath>

#include "app/editor/node_values.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/graph_panel.h"
#include "materials/graph_validate.h"
#include "renderer/image_io.h"

namespace glint {

ImU32 GraphPanel::pinColor(const PinRef& ref, const Pin& pin, bool output) const {
  if (output)
    if (const auto type = types_.find(ref); type != types_.end()) return theme::typeColor(type->second);
  if (pin.type.kind == PinType::Kind::Exact) return theme::typeColor(pin.type.type);
  return theme::grey(150);
}

bool GraphPanel::fieldRect(const NodeShape& shape, size_t input, ImVec2& low, ImVec2& high) const {
  if (canvas_.zoom() < 0.6f || shape.reroute || input >= shape.inputs.size()) return false;
  const ImVec2 c = shape.inputs[input];
  low = canvas_.toScreen({shape.position.x + shape.size.x - 66, c.y - 8});
  high = canvas_.toScreen({shape.position.x + shape.size.x - 8, c.y + 8});
  return true;
}

std::optional<PinRef> GraphPanel::fieldAt(Editor& editor, ImVec2 screen) const {
  const auto id = canvas_.nodeAt(screen);
  if (!id) return std::nullopt;
  const NodeShape* shape = canvas_.shape(*id);
  const Node* node = editor.document().material().node(*id);
  if (!shape || !node || !shape->pins || shape->comment) return std::nullopt;
  for (size_t i = 0; i < shape->pins->inputs.size(); ++i) {
    const Pin& pin = shape->pins->inputs[i];
    const auto input = node->inputs.find(pin.name);
    if (!editable(pin) || (input != node->inputs.end() && input->second.from)) continue;
    if (!pin.surface.empty() && (input == node->inputs.end() || !input->second.value)) continue;
    if (!passedThrough(*node, pin).empty()) continue;
    ImVec2 low, high;
    if (fieldRect(*shape, i, low, high) && screen.x >= low.x && screen.x < high.x && screen.y >= low.y && screen.y < high.y)
      return PinRef{*id, pin.name};
  }
  return std::nullopt;
}

void GraphPanel::drawField(const Node& node, const Pin& pin, ImVec2 low, ImVec2 high) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Value value = inputValue(node, pin);
  const float rounding = theme::px(3) * canvas_.zoom();
  const bool over = mode_ == Mode::None && ImGui::IsMouseHoveringRect(low, high);
  if (value.type == ValueType::Color) {
    ImVec4 c{0, 0, 0, 1};
    const float peak = std::max({1.0f, value.v[0], value.v[1], value.v[2]});
    c.x = srgbFromLinear(std::clamp(value.v[0] / peak, 0.0f, 1.0f));
    c.y = srgbFromLinear(std::clamp(value.v[1] / peak, 0.0f, 1.0f));
    c.z = srgbFromLinear(std::clamp(value.v[2] / peak, 0.0f, 1.0f));
    list.AddRectFilled(low, high, ImGui::ColorConvertFloat4ToU32(c), rounding);
    list.AddRect(low, high, over ? theme::grey(180) : theme::grey(24), rounding);
    return;
  }
  list.AddRectFilled(low, high, over ? theme::grey(40) : theme::grey(30), rounding);
  if (value.type == ValueType::Bool) {
    if (value.v[0] != 0) canvas_.text({low.x + (high.x - low.x) / 2 - canvas_.textWidth("on") / 2, low.y}, theme::kAccent, "on");
    else canvas_.text({low.x + (high.x - low.x) / 2 - canvas_.textWidth("off") / 2, low.y}, theme::kTextFaint, "off");
    return;
  }
  std::string text;
  const int count = std::max(1, componentCount(value.type));
  char number[32];
  for (int i = 0; i < count; ++i) {
    std::snprintf(number, sizeof number, count > 1 ? "%.2g" : value.type == ValueType::Int ? "%.0f" : "%.3g", double(value.v[size_t(i)]));
    text += (i ? " " : "") + std::string(number);
  }
  if (count == 1 && pin.maximum > pin.minimum && pin.maximum - pin.minimum < 1e4f) {
    const float fraction = std::clamp((value.v[0] - pin.minimum) / (pin.maximum - pin.minimum), 0.0f, 1.0f);
    list.PushClipRect(low, {low.x + (high.x - low.x) * fraction, high.y}, true);
    list.AddRectFilled(low, high, over ? theme::grey(88) : theme::grey(76), rounding);
    list.PopClipRect();
  }
  const float width = canvas_.textWidth(text), room = high.x - low.x - theme::px(6) * canvas_.zoom();
  canvas_.text({low.x + std::max(theme::px(3), (high.x - low.x - width) / 2), low.y + (high.y - low.y - canvas_.face()->FontSize) / 2},
               theme::grey(225), text, false, room);
}

void GraphPanel::drawWires(Editor& editor) {
  const Material& material = editor.document().material();
  const auto& selection = editor.selection();
  for (const auto& [id, node] : material.nodes)
    for (const auto& [name, input] : node.inputs) {
      if (!input.from) continue;
      const PinRef end{id, name};
      if (mode_ == Mode::Wire && detached_ && *detached_ == end) continue;
      const auto from = canvas_.pinCenter(*input.from, true), to = canvas_.pinCenter(end, false);
      if (!from || !to) continue;
      const NodeShape *source = canvas_.shape(input.from->node), *target = canvas_.shape(id);
      const Pin* out = source->pins ? source->pins->output(input.from->pin) : nullptr;
      const Pin* in = target->pins ? target->pins->input(name) : nullptr;
      const ImU32 a = out ? pinColor(*input.from, *out, true) : theme::kError;
      ImU32 b = in && in->type.kind == PinType::Kind::Exact ? theme::typeColor(in->type.type) : in ? a : theme::kError;
      const bool strong = selection.count(id) || selection.count(input.from->node);
      canvas_.drawWire(canvas_.toScreen(*from), canvas_.toScreen(*to), a, b, strong);
    }
}

void GraphPanel::drawWiresBehindNodes(Editor& editor) {
  for (const auto& [id, node] : editor.document().material().nodes)
    for (const auto& [name, input] : node.inputs) {
      if (!input.from || (mode_ == Mode::Wire && detached_ && *detached_ == PinRef{id, name})) continue;
      const auto from = canvas_.pinCenter(*input.from, true), to = canvas_.pinCenter({id, name}, false);
      const NodeShape* source = canvas_.shape(input.from->node);
      const Pin* out = source && source->pins ? source->pins->output(input.from->pin) : nullptr;
      if (!from || !to || !out) continue;
      const ImU32 color = (pinColor(*input.from, *out, true) & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 120);
      canvas_.drawWireBehindNodes(canvas_.toScreen(*from), canvas_.toScreen(*to), color, input.from->node, id);
    }
}

// Whether the wire in the hand could end there; what it could not end at is dimmed.
bool GraphPanel::fitsDraggedWire(const PinRef& ref, const Pin& pin, bool output) const {
  if (mode_ != Mode::Wire || ref == wire_) return true;
  if (output == wireFromOutput_ || ref.node == wire_.node) return false;
  const NodeShape* shape = canvas_.shape(wire_.node);
  const Pin* start = shape && shape->pins ? (wireFromOutput_ ? shape->pins->output(wire_.pin) : shape->pins->input(wire_.pin)) : nullptr;
  if (!start) return true;
  const auto type = types_.find(wireFromOutput_ ? wire_ : ref);
  const Pin& input = wireFromOutput_ ? pin : *start;
  return type != types_.end() ? accepts(input, type->second) : gives(wireFromOutput_ ? *start : pin, input);
}

void GraphPanel::drawComment(Editor& editor, const NodeId& id, const NodeShape& shape) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low = canvas_.toScreen(shape.position);
  const ImVec2 high = canvas_.toScreen({shape.position.x + shape.size.x, shape.position.y + shape.size.y});
  const float rounding = theme::px(4) * canvas_.zoom(), bar = shape.header * canvas_.unit();
  list.AddRectFilled(low, high, theme::grey(255, 8), rounding);
  list.AddRectFilled(low, {high.x, low.y + bar}, theme::grey(255, 14), rounding, ImDrawFlags_RoundCornersTop);
  list.AddRect(low, high, editor.selection().count(id) ? theme::kAccent : theme::grey(255, 30), rounding);
  canvas_.text({low.x + 10 * canvas_.unit(), low.y + (bar - canvas_.face()->FontSize) / 2}, theme::grey(200), shape.title, true,
               high.x - low.x - 14 * canvas_.unit());
  const float corner = 10 * canvas_.unit();
  list.AddTriangleFilled({high.x - corner, high.y - 3}, {high.x - 3, high.y - corner}, {high.x - 3, high.y - 3}, theme::grey(255, 40));
  ui::markRect("node:" + id, low, high);
}

void GraphPanel::drawNode(Editor& editor, const NodeId& id, const Node& node, const NodeShape& shape) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float unit = canvas_.unit(), rounding = 4 * unit;
  const ImVec2 low = canvas_.toScreen(shape.position);
  const ImVec2 high = canvas_.toScreen({shape.position.x + shape.size.x, shape.position.y + shape.size.y});
  ui::markRect("node:" + id, low, {high.x, shape.reroute ? high.y : low.y + shape.header * unit});
  const auto dimmed = [](ImU32 color, bool fits) { return fits ? color : (color & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 60); };
  const auto pinDot = [&](ImVec2 at, ImU32 full, bool wired, bool fits, const std::string& name) {
    const ImVec2 c = canvas_.toScreen(at);
    const ImU32 color = dimmed(full, fits);
    const float r = std::max(2.5f, 4.6f * unit);
    const bool over = std::hypot(ImGui::GetIO().MousePos.x - c.x, ImGui::GetIO().MousePos.y - c.y) < 10 * unit;
    list.AddCircleFilled(c, r + (over ? 2 * unit : 0) + 1.5f * unit, theme::grey(18));
    list.AddCircleFilled(c, r + (over ? 2 * unit : 0), color);
    if (!wired) list.AddCircleFilled(c, std::max(1.0f, r - 1.7f * unit), theme::grey(26));
    ui::markRect(name, {c.x - r, c.y - r}, {c.x + r, c.y + r});
  };
  const bool selected = editor.selection().count(id) != 0;
  const auto fault = errors_.find(id);
  if (high.x < canvas_.low().x || low.x > canvas_.high().x || high.y < canvas_.low().y || low.y > canvas_.high().y) return;

  if (shape.reroute) {
    const Pin* out = shape.pins->outputs.empty() ? nullptr : &shape.pins->outputs[0];
    const ImU32 color = out ? pinColor({id, out->name}, *out, true) : theme::grey(150);
    const ImVec2 c{(low.x + high.x) / 2, (low.y + high.y) / 2};
    list.AddLine({low.x, c.y}, {high.x, c.y}, color, 2 * unit);
    list.AddCircleFilled(c, 6 * unit, color);
    if (selected) list.AddCircle(c, 8 * unit, theme::kAccent, 0, theme::px(2));
    if (!shape.pins->inputs.empty()) ui::markRect("in:" + id + "." + shape.pins->inputs[0].name, {low.x - 4, c.y - 4}, {low.x + 4, c.y + 4});
    if (out) ui::markRect("out:" + id + "." + out->name, {high.x - 4, c.y - 4}, {high.x + 4, c.y + 4});
    return;
  }

  // Shadow, body, title strip, and a mark in the colour of what it gives.
  for (int i = 3; i >= 1; --i)
    list.AddRectFilled({low.x - float(i) * unit, low.y}, {high.x + float(i) * unit, high.y + (float(i) + 2) * unit}, theme::grey(0, 26), rounding + float(i) * unit);
  list.AddRectFilled(low, high, theme::kNode, rounding);
  const float header = std::round(shape.header * unit);
  list.AddRectFilled(low, {high.x, low.y + header}, shape.unknown ? IM_COL32(92, 44, 40, 255) : theme::kNodeHeader, rounding,
                     ImDrawFlags_RoundCornersTop);
  const Pin* gives = !shape.pins->outputs.empty() ? &shape.pins->outputs[0] : nullptr;
  const ImU32 mark = gives ? pinColor({id, gives->name}, *gives, true) : theme::kAccent;
  list.PushClipRect(low, {low.x + 3 * unit, low.y + header}, true);
  list.AddRectFilled(low, {high.x, low.y + header}, mark, rounding, ImDrawFlags_RoundCornersTopLeft);
  list.PopClipRect();
  list.AddRect(low, high, fault != errors_.end() ? theme::kError : selected ? theme::kAccent : theme::kNodeEdge, rounding, 0,
               selected || fault != errors_.end() ? theme::px(1.6f) : theme::px(1));
  canvas_.text({low.x + 11 * unit, low.y + (header - canvas_.face()->FontSize) / 2}, theme::kText, shape.title, true,
               high.x - low.x - (fault == errors_.end() ? 16 : 32) * unit);
  if (fault != errors_.end()) {
    const ImVec2 c{high.x - 13 * unit, low.y + header / 2};
    list.AddCircleFilled(c, 7 * unit, theme::kError);
    canvas_.text({c.x - canvas_.textWidth("!", true) / 2, c.y - canvas_.face()->FontSize / 2}, theme::grey(20), "!", true);
  }

  const float lift = canvas_.face()->FontSize / 2;
  for (size_t i = 0; i < shape.outputs.size(); ++i) {
    const Pin& pin = shape.pins->outputs[i];
    const ImVec2 c = canvas_.toScreen(shape.outputs[i]);
    const std::string title = pinTitle(pin);
    const bool fits = fitsDraggedWire({id, pin.name}, pin, true);
    canvas_.text({c.x - 11 * unit - canvas_.textWidth(title), c.y - lift}, dimmed(theme::grey(200), fits), title);
    pinDot(shape.outputs[i], pinColor({id, pin.name}, pin, true), !wiresFrom(editor.document().material(), id, pin.name).empty(),
           fits, "out:" + id + "." + pin.name);
  }
  for (size_t i = 0; i < shape.inputs.size(); ++i) {
    const Pin& pin = shape.pins->inputs[i];
    const ImVec2 c = canvas_.toScreen(shape.inputs[i]);
    const auto input = node.inputs.find(pin.name);
    const bool wired = input != node.inputs.end() && input->second.from;
    const bool fromSurface = !pin.surface.empty() && (input == node.inputs.end() || !input->second.value);
    const bool fits = fitsDraggedWire({id, pin.name}, pin, false);
    canvas_.text({c.x + 11 * unit, c.y - lift}, dimmed(wired ? theme::grey(220) : theme::grey(180), fits), pinTitle(pin), false,
                 high.x - c.x - (wired || !editable(pin) ? 14 : 78) * unit);
    ImVec2 fieldLow, fieldHigh;
    if (!wired && editable(pin) && passedThrough(node, pin).empty() && fieldRect(shape, i, fieldLow, fieldHigh)) {
      if (fromSurface) {
        const float width = canvas_.textWidth(pin.surface);
        canvas_.text({fieldHigh.x - width, c.y - lift}, theme::kTextFaint, pin.surface);
      } else {
        drawField(node, pin, fieldLow, fieldHigh);
        ui::markRect("value:" + id + "." + pin.name, fieldLow, fieldHigh);
      }
    }
    pinDot(shape.inputs[i], pinColor({id, pin.name}, pin, false), wired, fits, "in:" + id + "." + pin.name);
  }

  // What the pointer rests on says what it is.
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (mode_ != Mode::None || menu_.isOpen() || !ImGui::IsWindowHovered()) return;
  std::string tip;
  if (fault != errors_.end() && mouse.x >= low.x && mouse.x < high.x && mouse.y >= low.y && mouse.y < low.y + header) tip = fault->second;
  const auto over = [&](ImVec2 at) {
    const ImVec2 c = canvas_.toScreen(at);
    return std::hypot(mouse.x - c.x, mouse.y - c.y) < 9 * unit;
  };
  const auto describe = [&](const Pin& pin, bool output) {
    std::string text = pinTitle(pin) + " (" + std::string(name(pin.type)) + ")";
    if (output)
      if (const auto type = types_.find({id, pin.name}); type != types_.end() && pin.type.kind != PinType::Kind::Exact)
        text = pinTitle(pin) + " (" + std::string(name(type->second)) + ")";
    if (!pin.doc.empty()) text += "\n" + pin.doc;
    return text;
  };
  for (size_t i = 0; i < shape.outputs.size(); ++i)
    if (over(shape.outputs[i])) tip = describe(shape.pins->outputs[i], true);
  for (size_t i = 0; i < shape.inputs.size(); ++i)
    if (over(shape.inputs[i])) tip = describe(shape.pins->inputs[i], false);
  if (!tip.empty()) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme::px(340));
    ImGui::TextUnformatted(tip.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
}

void GraphPanel::drawWireBeingDragged(Editor& editor) {
  if (mode_ != Mode::Wire) return;
  const auto start = canvas_.pinCenter(wire_, wireFromOutput_);
  if (!start) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos, from = canvas_.toScreen(*start);
  const auto target = wireFromOutput_ ? canvas_.inputAt(mouse) : canvas_.outputAt(mouse);
  const NodeShape* shape = canvas_.shape(wire_.node);
  const Pin* pin = shape && shape->pins ? (wireFromOutput_ ? shape->pins->output(wire_.pin) : shape->pins->input(wire_.pin)) : nullptr;
  ImU32 color = pin ? pinColor(wire_, *pin, wireFromOutput_) : theme::grey(180);
  ImVec2 end = mouse;
  std::string reason;
  if (target) {
    const PinRef a = wireFromOutput_ ? wire_ : *target, b = wireFromOutput_ ? *target : wire_;
    const Diagnostics problems = connectionProblems(editor.document().material(), editor.graphContext(), a, b);
    if (!problems.empty()) {
      reason = problems.front().what + (problems.front().hint.empty() ? "" : "\n" + problems.front().hint);
      color = theme::kError;
    } else if (const auto center = canvas_.pinCenter(*target, !wireFromOutput_)) {
      end = canvas_.toScreen(*center);
    }
  }
  canvas_.drawWire(wireFromOutput_ ? from : end, wireFromOutput_ ? end : from, color, color, true);
  if (!reason.empty()) {
    // Beside the pointer, where the eye is.
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImVec2 text = ImGui::CalcTextSize(reason.c_str(), nullptr, false, theme::px(300));
    const ImVec2 at{mouse.x + theme::px(16), mouse.y + theme::px(14)};
    list.AddRectFilled({at.x - theme::px(8), at.y - theme::px(5)}, {at.x + text.x + theme::px(8), at.y + text.y + theme::px(5)}, theme::grey(30), theme::px(4));
    list.AddRect({at.x - theme::px(8), at.y - theme::px(5)}, {at.x + text.x + theme::px(8), at.y + text.y + theme::px(5)}, theme::kError, theme::px(4));
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, theme::kText, reason.c_str(), nullptr, theme::px(300));
    ui::markRect("reject-reason", at, {at.x + text.x, at.y + text.y});
  }
}

void GraphPanel::valuePopup(Editor& editor) {
  if (!popupWanted_.empty()) {
    ImGui::OpenPopup(popupWanted_.c_str());
    popupWanted_.clear();
  }
  ImGui::SetNextWindowSize({theme::px(280), 0});
  if (!ImGui::BeginPopup("pin-value")) return;
  const Node* node = editor.document().material().node(popupPin_.node);
  const NodeShape* shape = canvas_.shape(popupPin_.node);
  const Pin* pin = shape && shape->pins ? shape->pins->input(popupPin_.pin) : nullptr;
  if (node && pin) {
    Value value = inputValue(*node, *pin);
    const std::string label = "Set " + pinTitle(*pin);
    if (value.type == ValueType::Color) {
      float shown[3];
      const float intensity = std::max({1.0f, value.v[0], value.v[1], value.v[2]});
      for (int i = 0; i < 3; ++i) shown[i] = srgbFromLinear(std::clamp(value.v[size_t(i)] / intensity, 0.0f, 1.0f));
      ImGui::SetNextItemWidth(-1);
      if (ImGui::ColorPicker3("##color", shown, ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_NoSidePreview |
                                                    ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoSmallPreview)) {
        for (int i = 0; i < 3; ++i) value.v[size_t(i)] = linearFromSrgb(shown[i]) * intensity;
        editor.refused(editor.document().edit(label, [&](GraphEditor& graph) { return graph.setValue(popupPin_, value); }));
      }
    } else {
      inputProperty(editor, popupPin_.node, *node, *pin);
    }
  }
  ImGui::EndPopup();
}

}  // namespace glint
