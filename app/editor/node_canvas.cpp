#include "app/editor/node_canvas.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "app/editor/theme.h"
#include "materials/graph_validate.h"
#include "materials/node_registry.h"

namespace glint {
namespace {

constexpr float kHeader = 24, kRow = 21, kPad = 6, kField = 58;
constexpr float kPinReach = 10;  // sheet units around a pin's centre
constexpr float kMargin = 24;    // around what is framed
constexpr int kReadableZoom = 3; // of kCanvasZooms, the smallest at which pins can be read

struct Bezier {
  ImVec2 a, b, c, d;
  ImVec2 at(float t) const {
    const float u = 1 - t;
    const float w0 = u * u * u, w1 = 3 * u * u * t, w2 = 3 * u * t * t, w3 = t * t * t;
    return {w0 * a.x + w1 * b.x + w2 * c.x + w3 * d.x, w0 * a.y + w1 * b.y + w2 * c.y + w3 * d.y};
  }
};

Bezier curve(ImVec2 from, ImVec2 to, float unit) {
  const float reach = std::clamp(std::fabs(to.x - from.x) * 0.5f, 24 * unit, 160 * unit);
  return {from, {from.x + reach, from.y}, {to.x - reach, to.y}, to};
}

float distanceToSegment(ImVec2 p, ImVec2 a, ImVec2 b) {
  const float dx = b.x - a.x, dy = b.y - a.y, l = dx * dx + dy * dy;
  const float t = l > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / l, 0.0f, 1.0f) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

bool segmentsCross(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d) {
  const auto side = [](ImVec2 p, ImVec2 q, ImVec2 r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool hasField(const Pin& pin) {
  if (!pin.surface.empty()) return false;
  return pin.type.kind != PinType::Kind::Any &&
         !(pin.type.kind == PinType::Kind::Exact &&
           (pin.type.type == ValueType::Texture || pin.type.type == ValueType::Attributes));
}

}  // namespace

float NodeCanvas::zoom() const { return kCanvasZooms[zoomIndex_]; }
float NodeCanvas::unit() const { return zoom() * theme::scale(); }

ImVec2 NodeCanvas::toScreen(ImVec2 p) const {
  return {std::round((low_.x + high_.x) / 2 + (p.x - origin_.x) * unit()),
          std::round((low_.y + high_.y) / 2 + (p.y - origin_.y) * unit())};
}

ImVec2 NodeCanvas::toSheet(ImVec2 p) const {
  return {(p.x - (low_.x + high_.x) / 2) / unit() + origin_.x, (p.y - (low_.y + high_.y) / 2) / unit() + origin_.y};
}

void NodeCanvas::begin(ImVec2 low, ImVec2 high, Fonts& fonts) {
  low_ = low;
  high_ = high;
  fonts_ = &fonts;
  faces_ = fonts.canvas()[size_t(zoomIndex_)];
}

void NodeCanvas::pan(ImVec2 d) {
  origin_.x -= d.x / unit();
  origin_.y -= d.y / unit();
}

void NodeCanvas::zoomAt(ImVec2 screen, int steps) {
  const ImVec2 before = toSheet(screen);
  zoomIndex_ = std::clamp(zoomIndex_ + steps, 0, int(std::size(kCanvasZooms)) - 1);
  faces_ = fonts_->canvas()[size_t(zoomIndex_)];
  const ImVec2 after = toSheet(screen);
  origin_.x += before.x - after.x;
  origin_.y += before.y - after.y;
}

void NodeCanvas::show(ImVec2 low, ImVec2 high) {
  origin_ = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  placed_ = true;
  for (zoomIndex_ = 4; zoomIndex_ > 0; --zoomIndex_)
    if ((high.x - low.x + kMargin) * unit() <= high_.x - low_.x && (high.y - low.y + kMargin) * unit() <= high_.y - low_.y) break;
  faces_ = fonts_->canvas()[size_t(zoomIndex_)];
}

void NodeCanvas::showReadable(ImVec2 low, ImVec2 high, ImVec2 focus) {
  show(low, high);
  if (zoomIndex_ >= kReadableZoom) return;
  zoomIndex_ = kReadableZoom;
  faces_ = fonts_->canvas()[size_t(zoomIndex_)];
  // Along each axis: in the middle when it fits, else as near to the focus as leaves no empty edge.
  const auto place = [](float from, float to, float wanted, float room) {
    const float half = room / 2, least = from - kMargin / 2 + half, most = to + kMargin / 2 - half;
    return least > most ? (from + to) / 2 : std::clamp(wanted, least, most);
  };
  origin_ = {place(low.x, high.x, focus.x, (high_.x - low_.x) / unit()), place(low.y, high.y, focus.y, (high_.y - low_.y) / unit())};
}

void NodeCanvas::reveal(ImVec2 low, ImVec2 high) {
  constexpr float kEdge = 16;
  const auto along = [](float origin, float from, float to, float room) {
    const float least = to + kEdge - room / 2, most = from - kEdge + room / 2;  // of an origin that shows it
    return least > most ? (from + to) / 2 : std::clamp(origin, least, most);
  };
  origin_ = {along(origin_.x, low.x, high.x, (high_.x - low_.x) / unit()), along(origin_.y, low.y, high.y, (high_.y - low_.y) / unit())};
}

NodeShape NodeCanvas::measure(const NodeId& id, const Node& node, const Material& material, const GraphContext& context) const {
  NodeShape shape;
  const auto place = material.layout.find(id);
  if (place != material.layout.end()) shape.position = {place->second.x, place->second.y};
  const NodeKind* kind = context.nodes.find(node.kind);
  shape.unknown = !kind;
  shape.pins = pinsOf(node, context, material.file.parent_path());
  shape.title = kind ? kind->title : node.kind;
  shape.header = kHeader;
  shape.row = kRow;
  const Builtin builtin = kind ? kind->builtin : Builtin::None;
  if (builtin == Builtin::Comment) {
    shape.comment = true;
    shape.title = settingText(node, "text", "Comment");
    shape.size = {std::max(80.0f, settingNumber(node, "width", 300)), std::max(50.0f, settingNumber(node, "height", 180))};
    return shape;
  }
  if (builtin == Builtin::Reroute) {
    shape.reroute = true;
    shape.size = {20, 20};
    placePins(shape);
    return shape;
  }
  // What tells one from its like: a parameter's name, a function's, a picture's.
  if (builtin == Builtin::Parameter) shape.title = settingText(node, "name", id);
  else if (builtin == Builtin::Function || builtin == Builtin::Layer) {
    if (const std::string function = settingText(node, "function"); !function.empty()) shape.title = function;
  }
  const auto width = [&](const std::string& text, bool bold) {
    ImFont* font = bold ? fonts_->canvas()[4].bold : fonts_->canvas()[4].regular;
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x / theme::scale();
  };
  float widest = width(shape.title, true) + 40;
  for (const Pin& pin : shape.pins->inputs)
    widest = std::max(widest, 14 + width(pin.title.empty() ? pin.name : pin.title, false) + (hasField(pin) ? kField + 16 : 16));
  for (const Pin& pin : shape.pins->outputs) widest = std::max(widest, 32 + width(pin.title.empty() ? pin.name : pin.title, false));
  const auto rows = float(shape.pins->inputs.size() + shape.pins->outputs.size());
  shape.size = {std::ceil(std::clamp(widest, 112.0f, 320.0f)), kHeader + kPad + rows * kRow + kPad / 2};
  placePins(shape);
  return shape;
}

void NodeCanvas::placePins(NodeShape& shape) {
  shape.inputs.clear();
  shape.outputs.clear();
  if (!shape.pins) return;
  if (shape.reroute) {
    for (size_t i = 0; i < shape.pins->inputs.size(); ++i) shape.inputs.push_back({shape.position.x, shape.position.y + 10});
    for (size_t i = 0; i < shape.pins->outputs.size(); ++i) shape.outputs.push_back({shape.position.x + 20, shape.position.y + 10});
    return;
  }
  float y = shape.position.y + kHeader + kPad + kRow / 2;
  for (size_t i = 0; i < shape.pins->outputs.size(); ++i, y += kRow) shape.outputs.push_back({shape.position.x + shape.size.x, y});
  for (size_t i = 0; i < shape.pins->inputs.size(); ++i, y += kRow) shape.inputs.push_back({shape.position.x, y});
}

void NodeCanvas::layOut(const Material& material, const GraphContext& context) {
  shapes_.clear();
  for (const auto& [id, node] : material.nodes) shapes_[id] = measure(id, node, material, context);
  std::erase_if(order_, [&](const NodeId& id) { return !shapes_.count(id); });
  for (const auto& [id, shape] : shapes_)
    if (std::find(order_.begin(), order_.end(), id) == order_.end()) {
      // Comments lie under everything.
      if (shape.comment) order_.insert(order_.begin(), id);
      else order_.push_back(id);
    }
}

void NodeCanvas::place(const std::map<NodeId, Position>& positions) {
  for (const auto& [id, position] : positions) {
    const auto found = shapes_.find(id);
    if (found == shapes_.end()) continue;
    found->second.position = {position.x, position.y};
    placePins(found->second);
  }
}

const NodeShape* NodeCanvas::shape(const NodeId& id) const {
  const auto found = shapes_.find(id);
  return found == shapes_.end() ? nullptr : &found->second;
}

std::optional<ImVec2> NodeCanvas::pinCenter(const PinRef& ref, bool output) const {
  const NodeShape* s = shape(ref.node);
  if (!s || !s->pins) return std::nullopt;
  const auto& pins = output ? s->pins->outputs : s->pins->inputs;
  const auto& centers = output ? s->outputs : s->inputs;
  for (size_t i = 0; i < pins.size() && i < centers.size(); ++i)
    if (pins[i].name == ref.pin) return centers[i];
  // A pin that the node does not have now: its wire ends at the header.
  return ImVec2{output ? s->position.x + s->size.x : s->position.x, s->position.y + kHeader / 2};
}

std::optional<NodeId> NodeCanvas::nodeAt(ImVec2 screen) const {
  const ImVec2 p = toSheet(screen);
  for (auto it = order_.rbegin(); it != order_.rend(); ++it) {
    const NodeShape* s = shape(*it);
    if (!s) continue;
    const float height = s->comment ? kHeader : s->size.y;  // a comment is held by its title
    if (p.x >= s->position.x && p.x < s->position.x + s->size.x && p.y >= s->position.y && p.y < s->position.y + height)
      return *it;
  }
  return std::nullopt;
}

std::optional<PinRef> NodeCanvas::inputAt(ImVec2 screen) const {
  const ImVec2 p = toSheet(screen);
  for (auto it = order_.rbegin(); it != order_.rend(); ++it)
    if (const NodeShape* s = shape(*it); s && s->pins)
      for (size_t i = 0; i < s->inputs.size(); ++i)
        if (std::hypot(p.x - s->inputs[i].x, p.y - s->inputs[i].y) < kPinReach) return PinRef{*it, s->pins->inputs[i].name};
  return std::nullopt;
}

std::optional<PinRef> NodeCanvas::outputAt(ImVec2 screen) const {
  const ImVec2 p = toSheet(screen);
  for (auto it = order_.rbegin(); it != order_.rend(); ++it)
    if (const NodeShape* s = shape(*it); s && s->pins)
      for (size_t i = 0; i < s->outputs.size(); ++i)
        if (std::hypot(p.x - s->outputs[i].x, p.y - s->outputs[i].y) < kPinReach) return PinRef{*it, s->pins->outputs[i].name};
  return std::nullopt;
}

std::optional<PinRef> NodeCanvas::wireAt(ImVec2 screen, const Material& material) const {
  for (const auto& [id, node] : material.nodes)
    for (const auto& [pin, input] : node.inputs) {
      if (!input.from) continue;
      const auto from = pinCenter(*input.from, true), to = pinCenter({id, pin}, false);
      if (!from || !to) continue;
      const Bezier b = curve(toScreen(*from), toScreen(*to), unit());
      ImVec2 last = b.a;
      for (int i = 1; i <= 24; ++i) {
        const ImVec2 next = b.at(float(i) / 24);
        if (distanceToSegment(screen, last, next) < theme::px(5)) return PinRef{id, pin};
        last = next;
      }
    }
  return std::nullopt;
}

std::vector<PinRef> NodeCanvas::wiresCrossing(ImVec2 a, ImVec2 b, const Material& material) const {
  std::vector<PinRef> crossed;
  for (const auto& [id, node] : material.nodes)
    for (const auto& [pin, input] : node.inputs) {
      if (!input.from) continue;
      const auto from = pinCenter(*input.from, true), to = pinCenter({id, pin}, false);
      if (!from || !to) continue;
      const Bezier wire = curve(toScreen(*from), toScreen(*to), unit());
      ImVec2 last = wire.a;
      for (int i = 1; i <= 24; ++i) {
        const ImVec2 next = wire.at(float(i) / 24);
        if (segmentsCross(a, b, last, next)) {
          crossed.push_back({id, pin});
          break;
        }
        last = next;
      }
    }
  return crossed;
}

void NodeCanvas::raise(const NodeId& id) {
  const NodeShape* s = shape(id);
  if (!s || s->comment) return;
  std::erase(order_, id);
  order_.push_back(id);
}

void NodeCanvas::drawGrid() const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low_, high_, theme::kCanvas);
  const float step = 24 * unit() >= theme::px(10) ? 24 : 120;
  const ImVec2 first = toSheet(low_), last = toSheet(high_);
  for (float x = std::floor(first.x / step) * step; x < last.x; x += step) {
    const bool strong = std::fmod(std::fabs(x) + 0.5f, step * 5) < 1;
    const float sx = toScreen({x, 0}).x;
    list.AddLine({sx, low_.y}, {sx, high_.y}, strong ? theme::kGridStrong : theme::kGrid);
  }
  for (float y = std::floor(first.y / step) * step; y < last.y; y += step) {
    const bool strong = std::fmod(std::fabs(y) + 0.5f, step * 5) < 1;
    const float sy = toScreen({0, y}).y;
    list.AddLine({low_.x, sy}, {high_.x, sy}, strong ? theme::kGridStrong : theme::kGrid);
  }
}

void NodeCanvas::drawWire(ImVec2 from, ImVec2 to, ImU32 colorFrom, ImU32 colorTo, bool strong) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Bezier b = curve(from, to, unit());
  const float width = std::max(1.5f, (strong ? 3.2f : 2.2f) * std::sqrt(zoom()) * theme::scale());
  list.AddBezierCubic(b.a, b.b, b.c, b.d, theme::grey(10, 150), width + theme::px(2));
  if (colorFrom == colorTo) {
    list.AddBezierCubic(b.a, b.b, b.c, b.d, colorFrom, width);
    return;
  }
  // A promotion on the way: the colour goes over from one type to the other.
  constexpr int kParts = 12;
  const ImVec4 u = ImGui::ColorConvertU32ToFloat4(colorFrom), v = ImGui::ColorConvertU32ToFloat4(colorTo);
  ImVec2 last = b.a;
  for (int i = 1; i <= kParts * 2; ++i) {
    const float t = float(i) / (kParts * 2);
    const ImVec2 next = b.at(t);
    list.AddLine(last, next, ImGui::ColorConvertFloat4ToU32({u.x + (v.x - u.x) * t, u.y + (v.y - u.y) * t, u.z + (v.z - u.z) * t, 1}), width);
    last = next;
  }
}

void NodeCanvas::drawWireBehindNodes(ImVec2 from, ImVec2 to, ImU32 color, const NodeId& source, const NodeId& target) const {
  const Bezier b = curve(from, to, unit());
  const ImVec2 low{std::min({b.a.x, b.b.x, b.c.x, b.d.x}), std::min(b.a.y, b.d.y)}, high{std::max({b.a.x, b.b.x, b.c.x, b.d.x}), std::max(b.a.y, b.d.y)};
  if (low.x > high_.x || high.x < low_.x || low.y > high_.y || high.y < low_.y) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float length = std::hypot(high.x - low.x, high.y - low.y);
  const int parts = std::clamp(int(length / theme::px(5)), 8, 400);
  for (const auto& [id, node] : shapes_) {
    if (node.comment || node.reroute || id == source || id == target) continue;
    const ImVec2 a = toScreen(node.position), c = toScreen({node.position.x + node.size.x, node.position.y + node.size.y});
    if (a.x > high.x || c.x < low.x || a.y > high.y || c.y < low.y) continue;
    list.PushClipRect(a, c, true);
    for (int i = 0; i < parts; i += 2)
      list.AddLine(b.at(float(i) / float(parts)), b.at(float(i + 1) / float(parts)), color, std::max(1.0f, 1.6f * unit()));
    list.PopClipRect();
  }
}

void NodeCanvas::text(ImVec2 screen, ImU32 color, const std::string& text, bool bold, float room) const {
  ImFont* font = bold ? faces_.bold : faces_.regular;
  if (font->FontSize < theme::px(5)) return;
  const ImVec4 clip = {screen.x, screen.y - 4, screen.x + room, screen.y + font->FontSize + 6};
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {std::round(screen.x), std::round(screen.y)}, color, text.c_str(),
                                      nullptr, 0, room < 1e8f ? &clip : nullptr);
}

float NodeCanvas::textWidth(const std::string& text, bool bold) const {
  ImFont* font = bold ? faces_.bold : faces_.regular;
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

std::map<NodeId, Position> tidyPositions(const Material& material, const NodeCanvas& canvas) {
  // How many wires lie between a node and the end it leads to.
  std::map<NodeId, int> depth;
  std::vector<NodeId> order = topologicalOrder(material);
  for (auto it = order.rbegin(); it != order.rend(); ++it) {
    const int own = depth[*it];
    if (const Node* node = material.node(*it))
      for (const auto& [pin, input] : node->inputs)
        if (input.from) depth[input.from->node] = std::max(depth[input.from->node], own + 1);
  }
  std::map<int, std::vector<NodeId>> columns;
  for (const auto& [id, node] : material.nodes)
    if (const NodeShape* shape = canvas.shape(id); shape && !shape->comment) columns[depth[id]].push_back(id);
  std::map<NodeId, Position> positions;
  float x = 0;
  for (auto& [level, ids] : columns) {
    // In the order of the pins they feed, so that wires cross little.
    const auto rank = [&](const NodeId& id) {
      float best = FLT_MAX;
      for (const PinRef& end : wiresFrom(material, id)) {
        const auto placed = positions.find(end.node);
        if (placed == positions.end()) continue;
        const NodeShape* shape = canvas.shape(end.node);
        float offset = 0;
        for (size_t i = 0; shape && i < shape->pins->inputs.size(); ++i)
          if (shape->pins->inputs[i].name == end.pin) offset = float(i) * kRow;
        best = std::min(best, placed->second.y + offset);
      }
      return best;
    };
    std::map<NodeId, float> ranks;
    for (const NodeId& id : ids) ranks[id] = rank(id);
    std::stable_sort(ids.begin(), ids.end(), [&](const NodeId& a, const NodeId& b) { return ranks[a] < ranks[b]; });
    float widest = 0, height = 0;
    for (const NodeId& id : ids) {
      widest = std::max(widest, canvas.shape(id)->size.x);
      height += canvas.shape(id)->size.y + 24;
    }
    x -= widest + (level ? 70 : 0);
    float y = -height / 2;
    for (const NodeId& id : ids) {
      positions[id] = {std::round(x), std::round(y)};
      y += canvas.shape(id)->size.y + 24;
    }
  }
  return positions;
}

}  // namespace glint
