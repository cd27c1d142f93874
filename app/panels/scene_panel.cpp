// The light that the material is seen in, and how the picture is made from it.
#include <algorithm>
#include <cmath>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/environment_browser.h"
#include "app/panels/light_properties.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

class ScenePanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    if (ui::section("Environment")) environment(editor);
    // A light that was taken in the viewport is brought into view.
    const bool reveal = editor.takeRevealedLight();
    if (reveal) ImGui::SetNextItemOpen(true);
    if (ui::section("Lights")) lights(editor, reveal);
    if (ui::section("Shadows and ground")) shadows(editor);
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

  void environment(Editor& editor) {
    const Preview standard;
    property("Map", "A generated environment or a .hdr or .exr file; drop one on the window", editor, [&](Preview& p, bool reset) {
      if (reset) p.environment = standard.environment;
      return browser_.draw(editor, p.environment);
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

  static void lights(Editor& editor, bool reveal) {
    Document& document = editor.document();
    Preview preview = document.preview();
    int remove = -1, copy = -1, index = 0;
    bool changed = false;
    for (Light& light : preview.lights) {
      ImGui::PushID(index);
      ui::pushScope("light" + std::to_string(index));
      ImGui::AlignTextToFramePadding();
      const bool selected = index == editor.selectedLight();
      ImGui::PushStyleColor(ImGuiCol_Text, selected ? theme::kAccent : theme::kTextDim);
      ImGui::TextUnformatted(fmt::format("{} {}", infoOf(light.kind).title, index + 1).c_str());
      ImGui::PopStyleColor();
      ui::mark("title");
      if (ImGui::IsItemClicked()) editor.selectLight(selected ? -1 : index);
      if (selected && reveal) ImGui::SetScrollHereY(0);
      ImGui::SameLine(ImGui::GetContentRegionAvail().x - theme::px(126));
      if (ui::button("Copy", false, theme::px(60))) copy = index;
      ImGui::SameLine();
      if (ui::button("Remove", false, theme::px(70))) remove = index;
      changed |= lightProperties(light);
      ImGui::Dummy({0, theme::px(3)});
      ui::popScope();
      ImGui::PopID();
      ++index;
    }
    if (preview.lights.empty()) ui::textDim("Only the environment lights the scene.");
    std::string label = "Change light";
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (ui::button("Add light", false, half)) ImGui::OpenPopup("add light");
    ImGui::SameLine();
    if (ui::button("Presets", false, half)) ImGui::OpenPopup("light presets");
    if (ImGui::BeginPopup("light presets")) {
      for (const LightPreset& preset : lightPresets()) {
        if (ImGui::MenuItem(preset.name)) {
          preview.lights = preset.make();
          changed = true;
          label = fmt::format("Lights: {}", preset.name);
        }
        ui::tooltip(preset.doc);
        ui::mark(fmt::format("Preset {}", preset.name));
      }
      ImGui::EndPopup();
    }
    if (ImGui::BeginPopup("add light")) {
      for (const LightKindInfo& info : lightKinds()) {
        if (ImGui::MenuItem(info.title)) {
          preview.lights.push_back(newLight(info.kind));
          changed = true;
          label = fmt::format("Add {} light", info.id);
        }
        ui::mark(fmt::format("Add {}", info.id));
      }
      ImGui::EndPopup();
    }
    if (copy >= 0) {
      preview.lights.push_back(preview.lights[size_t(copy)]);
      changed = true;
      label = "Copy light";
    }
    if (remove >= 0) {
      preview.lights.erase(preview.lights.begin() + remove);
      changed = true;
      label = "Remove light";
    }
    if (changed) document.setPreview(label, preview);
    const auto hasSurface = [](const Light& light) { return surfaceArea(light) > 0; };
    if (std::none_of(preview.lights.begin(), preview.lights.end(), hasSurface)) return;
    property("Area lights", "How lights with a surface are drawn", editor, [&](Preview& p, bool reset) {
      if (reset) p.areaLights = AreaLights::Cosines;
      std::vector<std::string> names, docs;
      int chosen = 0;
      for (const AreaLightsInfo& info : areaLightMethods()) {
        if (info.method == p.areaLights) chosen = int(names.size());
        names.push_back(info.title);
        docs.push_back(info.doc);
      }
      if (!ui::choice("Area lights", chosen, names, docs)) return false;
      p.areaLights = areaLightMethods()[size_t(chosen)].method;
      return true;
    });
  }

  template <class E>
  static void choose(const char* title, const char* doc, Editor& editor, std::span<const ChoiceInfo> choices, E Preview::*member) {
    const Preview standard;
    property(title, doc, editor, [&](Preview& p, bool reset) {
      if (reset) p.*member = standard.*member;
      std::vector<std::string> names, docs;
      for (const ChoiceInfo& choice : choices) {
        names.push_back(choice.title);
        docs.push_back(choice.doc);
      }
      int index = int(p.*member);
      if (!ui::choice(title, index, names, docs)) return false;
      p.*member = E(index);
      return true;
    });
  }
  static void toggle(const char* title, const char* doc, Editor& editor, bool Preview::*member) {
    const Preview standard;
    property(title, doc, editor, [&](Preview& p, bool reset) {
      if (reset) p.*member = standard.*member;
      return ui::checkbox(title, p.*member);
    });
  }

  static void shadows(Editor& editor) {
    if (editor.document().preview().subject == Preview::Subject::Comparison) ui::textDim("Of a mesh: spheres of a comparison have none.");
    choose("Shadows", "Of the lights that have theirs on", editor, shadowChoices(), &Preview::shadows);
    toggle("Material AO", "What the material\u2019s ambient occlusion keeps of the environment\u2019s light", editor, &Preview::materialOcclusion);
    toggle("Screen AO", "What stands near in the picture keeps of it", editor, &Preview::screenOcclusion);
    choose("Ground", "What the mesh stands on", editor, groundChoices(), &Preview::ground);
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
    toggle("Antialiasing", "Smooth edges: pictures of a view that rests are averaged, and one that moves takes over what it has shown", editor, &Preview::antialiasing);
    toggle("Specular AA", "Widens roughness by how much the normal varies within a pixel, so that highlights do not glitter. Of a mesh: comparisons, references and errors have the roughness as it is", editor, &Preview::specularAntialiasing);
    property("Reference", "Monte Carlo instead of approximations, as it converges: the truth, without shadows. The view Error shows the difference", editor, [&](Preview& p, bool reset) {
      if (reset) p.reference = false;
      return ui::checkbox("Reference", p.reference);
    });
    if (editor.document().preview().reference || editor.document().preview().view == kErrorView)
      property("Split sum", "The environment\u2019s reflections as two sums, at the true direction of view; what is drawn without a reference assumes n = v = r as well", editor, [&](Preview& p, bool reset) {
        if (reset) p.splitSum = false;
        return ui::checkbox("Split sum", p.splitSum);
      });
    if (editor.document().preview().view == kErrorView)
      property("Error scale", "The relative error that the strongest colours stand for", editor, [&](Preview& p, bool reset) {
        if (reset) p.errorScale = Preview{}.errorScale;
        float percent = 100 * p.errorScale;
        const bool changed = ui::slider("Error scale", percent, 1, 100, "\u00b1%.0f %%");
        if (changed) p.errorScale = percent / 100;
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

  EnvironmentBrowser browser_;
};

}  // namespace

std::unique_ptr<Panel> makeScenePanel() { return std::make_unique<ScenePanel>(); }

}  // namespace glint
