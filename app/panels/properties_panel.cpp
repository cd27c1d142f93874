// What is selected, as widgets: a node's inputs and settings, or the material's shading model and attributes.
#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/health_badge.h"
#include "app/editor/model_picker.h"
#include "app/editor/model_row.h"
#include "app/editor/node_values.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

class PropertiesPanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    const Material& material = editor.document().material();
    const auto& selection = editor.selection();
    if (selection.size() == 1) {
      const NodeId id = *selection.begin();
      if (const Node* node = material.node(id); node && node->kind != "output") return drawNode(editor, id, *node);
    }
    if (selection.size() > 1) {
      ui::heading(std::to_string(selection.size()) + " nodes");
      ui::textDim("Select one to see what it is given.");
      return;
    }
    drawMaterial(editor);
  }

 private:
  // A text that is edited in place and kept when its field is left.
  bool edited(const std::string& label, std::string& value) {
    std::string shown = typingIn_ == label ? typed_ : value;
    const bool finished = ui::text(label, shown);
    if (ImGui::IsItemActive()) {
      typingIn_ = label;
      typed_ = shown;
    } else if (typingIn_ == label) {
      typingIn_.clear();
    }
    if (!finished || shown == value) return false;
    value = shown;
    return true;
  }

  void drawMaterial(Editor& editor) {
    Document& document = editor.document();
    const Material& material = document.material();
    ui::heading(material.name);
    if (!material.doc.empty()) ui::textDim(material.doc);
    ImGui::Dummy({0, theme::px(4)});
    if (ui::section("Material")) {
      ui::beginProperty("Name", "One word; what files and comparisons call it");
      std::string name = material.name;
      if (edited("Name", name))
        editor.refused(document.edit("Rename material", [&](GraphEditor& graph) { return graph.setName(name); }));
      ui::endProperty();
      ui::beginProperty("Description");
      std::string doc = material.doc;
      if (edited("Description", doc))
        editor.refused(document.edit("Describe material", [&](GraphEditor& graph) { return graph.setDoc(doc); }));
      ui::endProperty();
    }
    if (ui::section("Shading model")) drawModel(editor);
    const NodeId output = material.outputNode();
    const Node* node = material.node(output);
    if (node && ui::section("Attributes")) {
      const NodePinsPtr pins = pinsOf(*node, editor.graphContext(), material.file.parent_path());
      for (const Pin& pin : pins->inputs) inputProperty(editor, output, *node, pin);
    }
    drawParameters(editor);
  }

  void drawModel(Editor& editor) {
    Document& document = editor.document();
    const Material& material = document.material();
    ui::beginProperty("Model", "How the surface answers light; the sign says whether it keeps the laws of light");
    const ModelPtr now = editor.models().find(material.model);
    const float badge = now ? 2 * healthSignRadius() + theme::px(2) + ImGui::GetStyle().ItemSpacing.x : 0;
    ImGui::PushItemWidth(ImGui::CalcItemWidth() - badge);
    std::string id = material.model;
    const bool chosen = modelPicker(editor, "Model", id);
    ImGui::PopItemWidth();
    if (now) {
      ImGui::SameLine();
      healthBadge(editor, "Model", now);
    } else {
      ImGui::PushStyleColor(ImGuiCol_Text, theme::kError);
      ImGui::TextUnformatted("no such model is registered");
      ImGui::PopStyleColor();
    }
    ui::endProperty();
    if (chosen) editor.useModel(id);
    const ModelPtr model = editor.models().find(document.material().model);
    if (!model) return;
    if (isModelMix(model->id)) drawMix(editor, model);
    parameterSliders(*model,
                     [&](const ModelParameter& parameter) {
                       const auto given = material.modelParameters.find(parameter.name);
                       return given == material.modelParameters.end() ? parameter.standard : given->second;
                     },
                     [&](const ModelParameter& parameter, const Value& value) {
                       editor.refused(document.edit("Set " + parameter.name, [&](GraphEditor& graph) {
                         return graph.setModelParameter(parameter.name, value == parameter.standard ? std::nullopt : std::optional(value));
                       }));
                     });
  }

  // The terms of a mix, and what to do with it.
  static void drawMix(Editor& editor, const ModelPtr& model) {
    auto mix = parseModelMix(model->id);
    if (!mix) return;
    if (mixPickers(editor, *mix)) editor.useModel(mix->id());
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (ui::button("Add as row", false, half)) {
      ModelRow row{model->id, {}};
      for (const auto& [name, value] : editor.document().material().modelParameters)
        if (const ModelParameter* parameter = model->parameter(name)) row.set(*parameter, value);
      editor.addRow(row.text());
    }
    ui::tooltip("Keeps this mix in the comparison while you try others");
    ImGui::SameLine();
    if (ui::button("Save as plugin\u2026", false, half)) editor.saveMix(*mix, std::nullopt);
    ui::tooltip("A short file, listed like any other model");
  }

  // The material's own parameters, wherever their nodes lie.
  void drawParameters(Editor& editor) {
    const Material& material = editor.document().material();
    std::vector<NodeId> ids;
    for (const auto& [id, node] : material.nodes)
      if (node.kind == "parameter") ids.push_back(id);
    if (ids.empty() || !ui::section("Parameters")) return;
    const NodeKind* kind = editor.nodes().find("parameter");
    const SettingInfo* value = kind ? kind->setting("value") : nullptr;
    if (!value) return;
    for (const NodeId& id : ids) {
      const Node* node = material.node(id);
      if (!node) continue;
      SettingInfo named = *value;
      named.title = settingText(*node, "name", id);
      ImGui::PushID(id.c_str());
      settingProperty(editor, id, *node, named);
      ImGui::PopID();
    }
  }

  void drawNode(Editor& editor, const NodeId& id, const Node& node) {
    Document& document = editor.document();
    const NodeKind* kind = editor.nodes().find(node.kind);
    ui::heading(kind ? kind->title : node.kind);
    if (kind && !kind->doc.empty()) ui::textDim(kind->doc);
    if (!kind) ui::textDim("This version knows no such node. It is kept as it is in the file.");
    ImGui::Dummy({0, theme::px(4)});
    ui::beginProperty("Id", "What wires, messages and the generated code call the node");
    std::string name = id;
    if (edited("Id", name)) {
      const Diagnostics refusal = document.edit("Rename node", [&](GraphEditor& graph) { return graph.rename(id, name); });
      editor.refused(refusal);
      if (refusal.empty()) editor.selection() = {name};
      ui::endProperty();
      return;
    }
    ui::endProperty();
    if (!kind) return;
    // Each edit may replace the node, so it is looked up anew.
    if (!kind->settings.empty() && ui::section("Settings"))
      for (const SettingInfo& setting : kind->settings)
        if (const Node* now = document.material().node(id)) settingProperty(editor, id, *now, setting);
    const NodePinsPtr pins = pinsOf(node, editor.graphContext(), document.material().file.parent_path());
    if (!pins->inputs.empty() && ui::section("Inputs"))
      for (const Pin& pin : pins->inputs)
        if (const Node* now = document.material().node(id)) inputProperty(editor, id, *now, pin);
  }

  std::string typingIn_, typed_;
};

}  // namespace

std::unique_ptr<Panel> makePropertiesPanel() { return std::make_unique<PropertiesPanel>(); }

}  // namespace glint
