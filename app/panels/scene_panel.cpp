// The light that the material is seen in, and how the picture is made from it.
#include <algorithm>
#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"
#include "renderer/environment.h"

namespace glint {
namespace {

class ScenePanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    if (ui::section("Environment")) environment(editor);
    if (ui::section("Lights")) lights(editor);
    if (ui::section("Picture")) picture(editor);
    if (ui::section("Comparison", false)) comparison(editor);
  }

 private:
  // One property line of the preview; `reset` gives its default.
  template <class Draw>
  static void property(const std::string& label, const std::string& doc, Editor& editor, Draw draw) {
    Preview preview = editor.document().preview();
    const bool reset = ui::beginProperty(label, doc, true);
    bool changed = draw(preview, reset);
    ui::endProperty();
    if (changed || reset) editor.document().setPreview(label, preview);
  }

  static void environment(Editor& editor) {
    const Preview standard;
    property("Map", "A generated environment or a .hdr or .exr file; drop one on the window", editor, [&](Preview& p, bool reset) {
      if (reset) p.environment = standard.environment;
      std::vector<std::string> names = environmentNames();
      std::string shown = p.environment;
      if (std::find(names.begin(), names.end(), shown) == names.end()) shown = std::filesystem::path(shown).filename().string();
      bool changed = false;
      if (ImGui::BeginCombo("##map", shown.c_str())) {
        for (const std::string& name : names)
          if (ImGui::Selectable(name.c_str(), name == p.environment)) {
            p.environment = name;
            changed = true;
          }
        ImGui::Separator();
        if (ImGui::Selectable("Load a file\u2026")) editor.browseEnvironment();
        ImGui::EndCombo();
      }
      ui::mark("Map");
      return changed;
    });
    property("Rotation", "Degrees about the vertical axis; Shift and right button in the viewport", editor, [&](Preview& p, bool reset) {
      if (reset) p.environmentRotation = 0;
      return ui::slider("Rotation", p.environmentRotation, -180, 180, "%.0f\u00b0");
    });
    property("Intensity", "Factor on the environment\u2019s light", editor, [&](Preview& p, bool reset) {
      if (reset) p.environmentIntensity = 1;
      return ui::slider("Intensity", p.environmentIntensity, 0, 4, "%.2f");
    });
  }

  static void lights(Editor& editor) {
    Document& document = editor.document();
    Preview preview = document.preview();
    int remove = -1, index = 0;
    bool changed = false;
    for (Light& light : preview.lights) {
      ImGui::PushID(index);
      ui::pushScope("light" + std::to_string(index));
      const bool directional = light.kind == LightKind::Directional;
      ImGui::AlignTextToFramePadding();
      ui::textDim((directional ? "Directional " : "Point ") + std::to_string(index + 1));
      ImGui::SameLine(ImGui::GetContentRegionAvail().x - theme::px(60));
      if (ui::button("Remove", false, theme::px(70))) remove = index;
      ui::beginProperty("Colour");
      changed |= ui::color("Colour", &light.color.x, 1);
      ui::endProperty();
      if (directional) {
        // As an artist thinks of a sun: how high, and from which side.
        float height = glm::degrees(std::asin(std::clamp(light.direction.y, -1.0f, 1.0f)));
        float side = glm::degrees(std::atan2(light.direction.x, light.direction.z));
        ui::beginProperty("Height", "Degrees above the horizon");
        bool turned = ui::slider("Height", height, -89.9f, 89.9f, "%.0f\u00b0");
        ui::endProperty();
        ui::beginProperty("Side", "Degrees about the vertical axis, from the viewer\u2019s side");
        turned |= ui::slider("Side", side, -180, 180, "%.0f\u00b0");
        ui::endProperty();
        if (turned) {
          const float h = glm::radians(height), s = glm::radians(side);
          light.direction = {std::cos(h) * std::sin(s), std::sin(h), std::cos(h) * std::cos(s)};
          changed = true;
        }
        ui::beginProperty("Illuminance", "Lux: pi makes a white surface that faces it show 1");
        changed |= ui::drag("Illuminance", &light.lux, 1, 0.02f, 0, 1e6f, "%.2f lx");
        ui::endProperty();
      } else {
        ui::beginProperty("Position", "Metres");
        changed |= ui::drag("Position", &light.position.x, 3, 0.02f, -1e4f, 1e4f, "%.2f");
        ui::endProperty();
        float lumens = light.candela * 4 * 3.14159265f;
        ui::beginProperty("Power", "Lumens, sent out evenly");
        if (ui::drag("Power", &lumens, 1, 1, 0, 1e7f, "%.0f lm")) {
          light.candela = lumens / (4 * 3.14159265f);
          changed = true;
        }
        ui::endProperty();
        ui::beginProperty("Range", "Metres, beyond which it has no effect");
        changed |= ui::drag("Range", &light.radius, 1, 0.05f, 0.01f, 1e4f, "%.2f m");
        ui::endProperty();
      }
      ImGui::Dummy({0, theme::px(3)});
      ui::popScope();
      ImGui::PopID();
      ++index;
    }
    if (preview.lights.empty()) ui::textDim("Only the environment lights the scene.");
    std::string label = "Change light";
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (ui::button("Add directional", false, half)) {
      preview.lights.push_back({.kind = LightKind::Directional, .direction = glm::normalize(glm::vec3(1, 1.2f, 1))});
      changed = true;
      label = "Add directional light";
    }
    ImGui::SameLine();
    if (ui::button("Add point", false, half)) {
      preview.lights.push_back({.kind = LightKind::Point, .position = {1.5f, 2, 2.5f}, .candela = 15, .radius = 20});
      changed = true;
      label = "Add point light";
    }
    if (remove >= 0) {
      preview.lights.erase(preview.lights.begin() + remove);
      changed = true;
      label = "Remove light";
    }
    if (changed) document.setPreview(label, preview);
  }

  static void picture(Editor& editor) {
    property("Exposure", "Stops: the picture is multiplied by 2 to this power", editor, [&](Preview& p, bool reset) {
      if (reset) p.exposure = 0;
      return ui::slider("Exposure", p.exposure, -8, 8, "%+.2f EV");
    });
    static constexpr Tonemap kTonemaps[] = {Tonemap::None, Tonemap::Aces, Tonemap::AgX, Tonemap::PbrNeutral};
    property("Tone map", "How light becomes a picture; none shows the numbers", editor, [&](Preview& p, bool reset) {
      if (reset) p.tonemap = Tonemap::None;
      static const std::string names[] = {"None", "ACES", "AgX", "Khronos PBR Neutral"};
      int index = int(std::find(std::begin(kTonemaps), std::end(kTonemaps), p.tonemap) - std::begin(kTonemaps));
      const bool changed = ui::choice("Tone map", index, names);
      p.tonemap = kTonemaps[std::clamp(index, 0, 3)];
      return changed;
    });
    property("All bounces", "Gives back the light that bounces among a rough surface\u2019s facets more than once, for every model; a plugin can ask for it itself",
             editor, [&](Preview& p, bool reset) {
               if (reset) p.compensate = false;
               return ui::checkbox("All bounces", p.compensate);
             });
    static constexpr Background kBackgrounds[] = {Background::Environment, Background::Blur, Background::None, Background::Color};
    property("Background", "What is seen behind", editor, [&](Preview& p, bool reset) {
      if (reset) p.background = Preview{}.background;
      static const std::string names[] = {"Environment", "Blurred", "None", "Colour"};
      int index = int(std::find(std::begin(kBackgrounds), std::end(kBackgrounds), p.background) - std::begin(kBackgrounds));
      const bool changed = ui::choice("Background", index, names);
      p.background = kBackgrounds[std::clamp(index, 0, 3)];
      return changed;
    });
    if (editor.document().preview().background == Background::Color)
      property("Back colour", "", editor, [&](Preview& p, bool reset) {
        if (reset) p.backgroundColor = Preview{}.backgroundColor;
        return ui::color("Back colour", &p.backgroundColor.x, 1);
      });
  }

  static void comparison(Editor& editor) {
    property("Sweep from", "First value of the swept parameter", editor, [&](Preview& p, bool reset) {
      if (reset) p.sweepFrom = 0;
      return ui::drag("Sweep from", &p.sweepFrom, 1, 0.01f, -1e4f, 1e4f);
    });
    property("Sweep to", "Last value", editor, [&](Preview& p, bool reset) {
      if (reset) p.sweepTo = 1;
      return ui::drag("Sweep to", &p.sweepTo, 1, 0.01f, -1e4f, 1e4f);
    });
    property("Values", "How many, 1 to 16", editor, [&](Preview& p, bool reset) {
      if (reset) p.sweepCount = 5;
      float count = float(p.sweepCount);
      const bool changed = ui::slider("Values", count, 1, 12, "%.0f");
      p.sweepCount = int(std::round(count));
      return changed;
    });
  }
};

}  // namespace

std::unique_ptr<Panel> makeScenePanel() { return std::make_unique<ScenePanel>(); }

}  // namespace glint
