// The picture: sphere rows or a mesh, and the camera in the user's hand.
#include <algorithm>
#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/keys.h"
#include "app/editor/model_row.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/health_text.h"
#include "app/panels/light_gizmos.h"
#include "app/panels/panel.h"
#include "app/panels/row_labels.h"
#include "materials/attributes.h"
#include "renderer/environment.h"
#include "renderer/image_io.h"
#include "renderer/mesh.h"

namespace glint {
namespace {

class ViewportPanel final : public Panel {
 public:
  void draw(Editor&) override;

 private:
  enum class Drag { None, Orbit, Pan, Environment };
  void toolbar(Editor&);
  void picture(Editor&, ImVec2 low, ImVec2 size);
  static void titles(const FrameResult&, ImVec2 low);
  static void numbers(const FrameResult&, ImVec2 low);
  static void reference(Editor&, ImVec2 low, ImVec2 high);
  static void states(const FrameResult&, ImVec2 low);
  void control(Editor&, ImVec2 low, ImVec2 size, bool hovered);
  static void magnify(const FrameResult&, Orbit&, ImVec2 mouse, float factor);
  Drag drag_ = Drag::None;
  RowLabels rows_;
  LightGizmos gizmos_;
};

void ViewportPanel::draw(Editor& editor) {
  toolbar(editor);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImVec2 size = ImGui::GetContentRegionAvail();
  size = {std::max(1.0f, std::floor(size.x)), std::max(1.0f, std::floor(size.y))};
  editor.setViewportSize({int(size.x), int(size.y)});
  picture(editor, low, size);
  ImGui::InvisibleButton("view", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                                           ImGuiButtonFlags_MouseButtonMiddle);
  ui::mark("view");
  const bool hovered = ImGui::IsItemHovered();
  const bool taken = rows_.control(editor, hovered && editor.shown().comparison);
  const bool light = gizmos_.draw(editor, low, size, hovered);
  control(editor, low, size, hovered && !taken && !light);
}

void ViewportPanel::toolbar(Editor& editor) {
  Document& document = editor.document();
  Preview preview = document.preview();
  const float height = theme::px(34);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + ImGui::GetContentRegionAvail().x, low.y + height}, theme::kPanel);
  ImGui::SetCursorScreenPos({low.x + theme::px(8), low.y + (height - ImGui::GetFrameHeight()) / 2});
  static const std::string subjects[] = {"Comparison", "Mesh"};
  int subject = preview.subject == Preview::Subject::Mesh;
  ImGui::PushItemWidth(theme::px(170));
  if (ui::segments("subject", subject, subjects)) {
    preview.subject = subject ? Preview::Subject::Mesh : Preview::Subject::Comparison;
    document.setPreview(subject ? "Show mesh" : "Show comparison", preview);
  }
  ImGui::PopItemWidth();
  ImGui::SameLine(0, theme::px(12));
  if (preview.subject == Preview::Subject::Comparison) {
    static const std::string columns[] = {"Materials", "Sweep"};
    int column = preview.columns == Preview::Columns::Sweep;
    ImGui::PushItemWidth(theme::px(150));
    if (ui::segments("columns", column, columns)) {
      preview.columns = column ? Preview::Columns::Sweep : Preview::Columns::Materials;
      document.setPreview(column ? "Sweep a parameter" : "Compare materials", preview);
    }
    ImGui::PopItemWidth();
    if (preview.columns == Preview::Columns::Sweep) {
      ImGui::SameLine(0, theme::px(8));
      ImGui::SetNextItemWidth(theme::px(120));
      if (ImGui::BeginCombo("##sweep", preview.sweepName.c_str())) {
        std::vector<std::string> names;
        for (const Attribute& attribute : attributes())
          if (attribute.standard.type == ValueType::Float) names.emplace_back(attribute.name);
        for (const std::string& row : preview.models)
          if (const ModelPtr model = editor.models().find(modelRow(row).id))
            for (const ModelParameter& parameter : model->parameters)
              if (std::find(names.begin(), names.end(), parameter.name) == names.end()) names.push_back(parameter.name);
        for (const std::string& name : names)
          if (ImGui::Selectable(name.c_str(), name == preview.sweepName)) {
            preview.sweepName = name;
            if (const Attribute* attribute = findAttribute(name)) {
              preview.sweepFrom = attribute->minimum;
              preview.sweepTo = attribute->maximum;
            }
            for (const std::string& row : preview.models)
              if (const ModelPtr model = editor.models().find(modelRow(row).id))
                if (const ModelParameter* parameter = model->parameter(name)) {
                  preview.sweepFrom = parameter->minimum;
                  preview.sweepTo = parameter->maximum;
                }
            document.setPreview("Sweep " + name, preview);
          }
        ImGui::EndCombo();
      }
      ui::mark("sweep");
    }
  } else {
    std::string shown = preview.mesh;
    if (const size_t slash = shown.find_last_of('/'); slash != std::string::npos) shown = shown.substr(slash + 1);
    ImGui::SetNextItemWidth(theme::px(170));
    if (ImGui::BeginCombo("##mesh", shown.c_str())) {
      for (const std::string& name : shapeNames())
        if (ImGui::Selectable(name.c_str(), name == preview.mesh)) {
          preview.mesh = name;
          document.setPreview("Show " + name, preview);
        }
      ImGui::Separator();
      if (ImGui::Selectable("Load a glTF file\u2026")) editor.browseMesh();
      ImGui::EndCombo();
    }
    ui::mark("mesh");
    if (!editor.shown().meshMaterials.empty()) {
      static const std::string whose[] = {"Its materials", "Edited"};
      int index = preview.ownMaterials ? 0 : 1;
      ImGui::SameLine(0, theme::px(8));
      ImGui::PushItemWidth(theme::px(190));
      if (ui::segments("whose", index, whose)) {
        preview.ownMaterials = index == 0;
        document.setPreview(index == 0 ? "Show the mesh\u2019s materials" : "Show the edited material", preview);
      }
      ImGui::PopItemWidth();
    }
  }

  // On the right: what is shown of it, and how bright; on a line of their own where the panel is too narrow for both.
  const ViewMode* mode = findViewMode(preview.view);
  const float edge = theme::px(8), right = low.x + ImGui::GetContentRegionMax().x - edge;
  ImGui::SameLine(0, theme::px(12));
  float left = ImGui::GetCursorScreenPos().x, top = low.y;
  if (right - left < theme::px(190)) {
    top += height;
    left = low.x + edge;
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, top}, {right + edge, top + height}, theme::kPanel);
  }
  const float width = std::clamp((right - left - theme::px(8)) / 2, theme::px(40), theme::px(150));
  ImGui::SetCursorScreenPos({right - 2 * width - theme::px(8), top + (height - ImGui::GetFrameHeight()) / 2});
  ImGui::SetNextItemWidth(width);
  char format[32];
  std::snprintf(format, sizeof format, width < theme::px(130) ? "%%+.2f EV" : "exposure %%+.2f EV");
  if (ImGui::DragFloat("##exposure", &preview.exposure, 0.02f, -16, 16, format)) document.setPreview("Exposure", preview);
  ui::mark("exposure");
  ui::tooltip("Exposure: drag; double-click or Ctrl+click to type");
  ImGui::SameLine(0, theme::px(8));
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo("##viewmode", mode ? mode->title : "Lit", ImGuiComboFlags_HeightLarge)) {
    for (const ViewMode& one : viewModes()) {
      if (ImGui::Selectable(one.title, preview.view == one.id)) {
        preview.view = one.id;
        document.setPreview(std::string("View ") + one.title, preview);
      }
      ui::tooltip(one.doc);
    }
    ImGui::EndCombo();
  }
  ui::mark("viewmode");
  ImGui::SetCursorScreenPos({low.x, top + height});
}

void ViewportPanel::picture(Editor& editor, ImVec2 low, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high = {low.x + size.x, low.y + size.y};
  list.AddRectFilled(low, high, theme::grey(12));
  const FrameResult& frame = editor.shown();
  if (frame.texture) {
    // While the panel is being resized the last picture keeps its size, so that nothing is squeezed.
    const ImVec2 end = {low.x + float(frame.layoutSize.x), low.y + float(frame.layoutSize.y)};
    list.PushClipRect(low, high, true);
    list.AddImage(imguiTexture(frame.texture), low, end, {0, 1}, {1, 0});
    states(frame, low);
    numbers(frame, low);
    if (frame.comparison) {
      titles(frame, low);
      rows_.draw(editor, frame, low);
    }
    list.PopClipRect();
  }
  if (frame.referenceInAll > 0) reference(editor, low, high);
  const auto progress = editor.render().progress();
  if (!frame.texture || (progress && editor.render().working() && progress->fraction > 0)) {
    const std::string what = progress ? progress->what : "Starting the renderer";
    const ImVec2 text = ImGui::CalcTextSize(what.c_str());
    const ImVec2 at = {low.x + theme::px(14), high.y - text.y - theme::px(20)};
    list.AddRectFilled({at.x - theme::px(8), at.y - theme::px(6)}, {at.x + text.x + theme::px(8), at.y + text.y + theme::px(10)},
                       theme::grey(20, 220), theme::px(4));
    list.AddText(at, theme::kText, what.c_str());
    const float y = at.y + text.y + theme::px(5);
    const float fraction = progress ? float(std::clamp(progress->fraction, 0.0, 1.0)) : 0;
    list.AddRectFilled({at.x, y}, {at.x + text.x, y + theme::px(2)}, theme::grey(60));
    list.AddRectFilled({at.x, y}, {at.x + text.x * fraction, y + theme::px(2)}, theme::kAccent);
  }
}

// Over what is not what its title says: that it was not drawn, or is the last that could be, and why.
void ViewportPanel::states(const FrameResult& frame, ImVec2 low) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const CellGrid& grid = frame.layout.grid;
  ImFont *bold = ui::fonts().bold(), *small = ui::fonts().small();
  for (size_t i = 0; i < frame.states.size(); ++i) {
    const PreviewScene::State& state = frame.states[i];
    if (state.kind == PreviewScene::State::Drawn || (frame.comparison && grid.columns == 0)) continue;
    ImVec2 from = low, to = {low.x + float(frame.layoutSize.x), low.y + float(frame.layoutSize.y)};
    if (frame.comparison) {
      const glm::ivec4 cell = grid.rectangle(int(i) / grid.columns, int(i) % grid.columns);
      from = {low.x + float(cell.x), low.y + float(frame.layoutSize.y - cell.y - cell.w)};
      to = {from.x + float(cell.z), from.y + float(cell.w)};
    }
    const bool missing = state.kind == PreviewScene::State::NotDrawn;
    const std::string head = missing ? "Not drawn" : "Last good one";
    const float margin = theme::px(8), room = std::min(to.x - from.x - 2 * margin, theme::px(360));
    if (room < theme::px(8)) continue;
    const ImVec2 wrapped = small->CalcTextSizeA(small->FontSize, FLT_MAX, room, state.why.c_str());
    const float height = bold->FontSize + theme::px(4) + wrapped.y;
    list.PushClipRect(from, to, true);
    if (missing) list.AddRectFilled(from, to, theme::grey(24));
    const ImVec2 at = {from.x + (to.x - from.x - room) / 2, missing ? std::max(from.y + margin, (from.y + to.y - height) / 2) : std::max(from.y, to.y - height - 2 * margin) + margin};
    if (!missing) list.AddRectFilled({from.x, at.y - margin}, to, theme::grey(20, 215));
    list.AddText(bold, bold->FontSize, at, missing ? theme::kError : theme::kWarning, ui::elided(head, room, bold).c_str());
    list.AddText(small, small->FontSize, {at.x, at.y + bold->FontSize + theme::px(4)}, theme::kText, state.why.c_str(), nullptr, room);
    list.PopClipRect();
    if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(from, to) && height > to.y - from.y) ImGui::SetTooltip("%s: %s", head.c_str(), state.why.c_str());
    ui::markRect((missing ? "not drawn:" : "last good:") + std::to_string(i), from, to);
  }
}

// How far a reference has come, and in the error view what its colours stand for.
void ViewportPanel::reference(Editor& editor, ImVec2 low, ImVec2 high) {
  const FrameResult& frame = editor.shown();
  const Preview& preview = editor.document().preview();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* small = ui::fonts().small();
  std::string text = "Reference: " + std::to_string(frame.reference) + " of " + std::to_string(frame.referenceInAll) + " samples";
  std::string less, more;
  if (preview.view == kErrorView) {
    text = std::to_string(frame.reference) + " of " + std::to_string(frame.referenceInAll) + " samples";
    less = "\u2212" + std::to_string(int(std::lround(100 * preview.errorScale))) + " %";
    more = "+" + less.substr(3);
  }
  const float pad = theme::px(8), bar = less.empty() ? 0 : theme::px(90), line = small->FontSize;
  const auto width = [&](const std::string& t) { return t.empty() ? 0 : small->CalcTextSizeA(line, FLT_MAX, 0, t.c_str()).x + theme::px(6); };
  const float whole = width(less) + bar + width(more) + width(text) + (less.empty() ? 0 : theme::px(10));
  ImVec2 at = {high.x - theme::px(12) - pad - whole, high.y - theme::px(12) - theme::px(4) - line};
  if (at.x < low.x + pad) return;
  list.AddRectFilled({at.x - pad, at.y - theme::px(4)}, {at.x + whole + pad, at.y + line + theme::px(4)}, theme::grey(20, 215), theme::px(4));
  ui::markRect("reference", at, {at.x + whole, at.y + line});
  if (!less.empty()) {
    list.AddText(small, line, at, theme::kText, less.c_str());
    at.x += width(less);
    const auto color = [](glm::vec3 c) { return ImGui::ColorConvertFloat4ToU32({srgbFromLinear(c.x), srgbFromLinear(c.y), srgbFromLinear(c.z), 1}); };
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i)
      list.AddRectFilled({at.x + bar * float(i) / kSteps, at.y + theme::px(2)}, {at.x + bar * float(i + 1) / kSteps, at.y + line - theme::px(2)},
                         color(errorColor(2 * (float(i) + 0.5f) / kSteps - 1)));
    at.x += bar + theme::px(6);
    list.AddText(small, line, at, theme::kText, more.c_str());
    at.x += width(more) + theme::px(10);
  }
  list.AddText(small, line, at, theme::kTextDim, text.c_str());
}

// In the white furnace how much of the light each cell sends back, in the error view how far it is off.
void ViewportPanel::numbers(const FrameResult& frame, ImVec2 low) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* small = ui::fonts().small();
  const CellGrid& grid = frame.layout.grid;
  for (size_t i = 0; i < std::max(frame.furnace.size(), frame.errors.size()); ++i) {
    ImVec2 from = low, to = {low.x + float(frame.layoutSize.x), low.y + float(frame.layoutSize.y)};
    if (frame.comparison && grid.columns > 0) {
      const glm::ivec4 cell = grid.rectangle(int(i) / grid.columns, int(i) % grid.columns);
      from = {low.x + float(cell.x), low.y + float(frame.layoutSize.y - cell.y - cell.w)};
      to = {from.x + float(cell.z), from.y + float(cell.w)};
    }
    const std::string text = i < frame.errors.size() ? errorText(frame.errors[i]) : furnaceText(frame.furnace[i]);
    const float margin = theme::px(6), inset = theme::px(5);
    const ImVec2 size = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0, text.c_str());
    const float width = std::min(size.x, to.x - from.x - 2 * (margin + inset));
    if (width < theme::px(20) || to.y - from.y < 3 * size.y) continue;
    const ImVec2 at = {std::round((from.x + to.x - width) / 2), to.y - margin - inset - size.y};
    list.AddRectFilled({at.x - inset, at.y - theme::px(3)}, {at.x + width + inset, at.y + size.y + theme::px(3)}, theme::grey(20, 215), theme::px(4));
    ui::elidedText(at, width + 1, theme::kText, text, small);
    ui::markRect((i < frame.errors.size() ? "error:" : "furnace:") + std::to_string(i), at, {at.x + width, at.y + size.y});
  }
}

void ViewportPanel::titles(const FrameResult& frame, ImVec2 low) {
  const CellGrid& grid = frame.layout.grid;
  const float height = float(frame.layoutSize.y);
  ImFont* bold = ui::fonts().bold();
  const auto widthIn = [](ImFont* font, const std::string& text) { return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x; };
  for (int column = 0; column < grid.columns && column < int(frame.columnTitles.size()); ++column) {
    const glm::ivec4 cell = grid.rectangle(0, column);
    const std::string& title = frame.columnTitles[size_t(column)];
    // As far as the middle of the gaps on both sides.
    const float room = float(cell.z + grid.gapX) - theme::px(6), width = std::min(room, widthIn(bold, title));
    const ImVec2 at = {low.x + float(cell.x) + (float(cell.z) - width) / 2, low.y + height - float(cell.y + cell.w) - bold->FontSize - theme::px(7)};
    ui::elidedText(at, width + 1, theme::kText, title, bold);
    ui::markRect("column:" + title, at, {at.x + width, at.y + bold->FontSize});
  }
}

// Half the height that is seen at the target, in metres.
static float halfHeight(const Orbit& orbit) { return orbit.distance * std::tan(glm::radians(orbit.fov) / 2); }

// Closer in every cell at once, about the point under the pointer (pixels from the picture's top left); on the way back
// the whole sphere returns to the middle.
void ViewportPanel::magnify(const FrameResult& frame, Orbit& orbit, ImVec2 mouse, float factor) {
  const CellGrid& grid = frame.layout.grid;
  glm::vec2 about(0);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const glm::vec4 cell = grid.rectangle(row, column);
      const glm::vec2 in = (glm::vec2(mouse.x, float(frame.layoutSize.y) - mouse.y) - glm::vec2(cell)) / cell.z * 2.0f - 1.0f;
      if (glm::all(glm::lessThan(glm::abs(in), glm::vec2(1)))) about = in;
    }
  const float whole = halfHeight(Preview{}.comparisonOrbit), before = halfHeight(orbit);
  const float after = std::clamp(before * factor, whole / 40, whole);
  orbit.fov = glm::degrees(2 * std::atan(after / orbit.distance));
  const Camera camera = orbit.camera(1);
  const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
  const glm::vec3 side = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(side, forward);
  if (after < before) orbit.target += (side * about.x + up * about.y) * (before - after);
  else if (before < whole) orbit.target *= (whole - after) / (whole - before);
}

void ViewportPanel::control(Editor& editor, ImVec2 low, ImVec2 size, bool hovered) {
  Document& document = editor.document();
  const ImGuiIO& io = ImGui::GetIO();
  const Preview& preview = document.preview();
  Orbit orbit = preview.subject == Preview::Subject::Mesh ? preview.orbit : preview.comparisonOrbit;
  if (hovered && drag_ == Drag::None) {
    const bool left = ImGui::IsMouseClicked(0), right = ImGui::IsMouseClicked(1), middle = ImGui::IsMouseClicked(2);
    if ((right && io.KeyShift) || (left && io.KeyCtrl)) drag_ = Drag::Environment;
    else if (right || (middle && io.KeyShift) || (left && io.KeyShift)) drag_ = Drag::Pan;
    else if (left || middle) drag_ = Drag::Orbit;
  }
  if (!ImGui::IsAnyMouseDown()) drag_ = Drag::None;
  const ImVec2 moved = io.MouseDelta;
  if (drag_ != Drag::None && (moved.x != 0 || moved.y != 0)) {
    if (drag_ == Drag::Orbit) {
      orbit.yaw -= moved.x * 0.4f / theme::scale();
      orbit.pitch = std::clamp(orbit.pitch + moved.y * 0.4f / theme::scale(), -89.0f, 89.0f);
      document.setOrbit(orbit);
    } else if (drag_ == Drag::Pan) {
      const Camera camera = orbit.camera(1);
      const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
      const glm::vec3 side = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(side, forward);
      const bool cells = editor.shown().comparison && preview.subject == Preview::Subject::Comparison;
      const float metres = 2 * halfHeight(orbit) / (cells ? float(editor.shown().layout.grid.cell) : std::max(1.0f, size.y));
      orbit.target += (side * -moved.x + up * moved.y) * metres;
      document.setOrbit(orbit);
    } else {
      Preview turned = preview;
      turned.environmentRotation = std::remainder(turned.environmentRotation + moved.x * 0.5f / theme::scale(), 360.0f);
      document.setPreview("Turn environment", turned);
    }
  }
  if (hovered && io.MouseWheel != 0) {
    if (io.KeyCtrl) {
      // The subject keeps its size while the perspective changes.
      const float before = std::tan(glm::radians(orbit.fov) / 2);
      orbit.fov = std::clamp(orbit.fov * std::pow(0.92f, io.MouseWheel), 4.0f, 120.0f);
      orbit.distance *= before / std::tan(glm::radians(orbit.fov) / 2);
    } else if (preview.subject == Preview::Subject::Comparison) {
      magnify(editor.shown(), orbit, {io.MousePos.x - low.x, io.MousePos.y - low.y}, std::pow(0.9f, io.MouseWheel));
    } else {
      orbit.distance = std::clamp(orbit.distance * std::pow(0.9f, io.MouseWheel), 1e-3f, 1e5f);
    }
    document.setOrbit(orbit);
  }
  if (hovered && shortcut(kNoModifiers, Key::F)) editor.frameSubject();
  if (hovered && shortcut(kShift, Key::F)) editor.frameLights();
  if (hovered && shortcut(kNoModifiers, Key::L)) editor.showLights(!editor.session().lightGizmos);
}

}  // namespace

std::unique_ptr<Panel> makeViewportPanel() { return std::make_unique<ViewportPanel>(); }

}  // namespace glint
