// The shading models there are: which are compared, what each claims and keeps, where its file lies and what is wrong
// with it; and the rows that are no files: mixes of terms, and models with other parameters.
#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/health_badge.h"
#include "app/editor/model_picker.h"
#include "app/editor/model_row.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/health_text.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

class ModelsPanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    Document& document = editor.document();
    ui::textDim("Ticked models are the rows of the comparison; the material\u2019s own always has one.");
    ImGui::Dummy({0, theme::px(2)});
    for (const ModelPtr& model : editor.models().all()) {
      ImGui::PushID(model->id.c_str());
      const auto& rows = document.preview().models;
      bool compared = std::find(rows.begin(), rows.end(), model->id) != rows.end();
      if (ui::checkbox(model->id, compared)) compared ? editor.addRow(model->id) : editor.removeRow(model->id);
      ImGui::SameLine();
      healthBadge(editor, model->id, model);
      ImGui::SameLine();
      const bool used = document.material().model == model->id;
      if (ui::row("row " + model->id, model->title, used ? "this material\u2019s" : model->id, used)) open_ = open_ == model->id ? "" : model->id;
      ui::tooltip(model->doc);
      if (open_ == model->id) details(editor, *model);
      ImGui::PopID();
    }
    drawOthers(editor);
    ImGui::Dummy({0, theme::px(2)});
    if (ui::button("Add a mix of terms")) addMix(editor);
    ui::tooltip("A row of its own from any distribution, visibility, Fresnel and diffuse term");
    const Diagnostics& problems = editor.models().problems();
    if (problems.empty()) return;
    ImGui::Dummy({0, theme::px(4)});
    for (const Diagnostic& d : problems) ui::diagnostic(d);
  }

 private:
  // Rows that are no files, and models whose file is gone, which can be left out.
  void drawOthers(Editor& editor) {
    const auto ids = editor.models().ids();
    for (const std::string& text : std::vector<std::string>(editor.document().preview().models)) {
      if (std::find(ids.begin(), ids.end(), text) != ids.end()) continue;
      const ModelRow row = modelRow(text);
      const ModelPtr model = editor.models().find(row.id);
      const bool open = open_ == text;
      // By its place, so that what is held stays held while the row changes under it.
      ImGui::PushID(open ? "open row" : text.c_str());
      bool compared = true;
      if (ui::checkbox(text, compared)) editor.removeRow(text);
      ImGui::SameLine();
      if (model) healthBadge(editor, text, model);
      else ImGui::Dummy({2 * healthSignRadius(), 0});
      ImGui::SameLine();
      if (!model) ImGui::PushStyleColor(ImGuiCol_Text, theme::kError);
      const std::string note = !model ? "missing" : !row.parameters.empty() ? row.note() : "a mix of terms";
      if (ui::row("row " + text, model ? model->title : text, note, false)) open_ = open ? "" : text;
      if (!model) ImGui::PopStyleColor();
      ui::tooltip(model ? model->doc : "No file has this model any more: untick it, or put its file back");
      if (open && model) rowDetails(editor, text, row, *model);
      ImGui::PopID();
    }
  }

  void rowDetails(Editor& editor, const std::string& text, ModelRow row, const ShadingModel& model) {
    ImGui::Indent();
    const auto change = [&](const ModelRow& to) {
      editor.changeRow(text, to.text());
      open_ = to.text();
    };
    auto mix = isModelMix(row.id) ? std::optional(parseModelMix(row.id)) : std::nullopt;
    if (mix && mix->ok() && mixPickers(editor, **mix)) {
      // Parameters that the other terms do not have are let go.
      ModelRow to{(*mix)->id(), {}};
      if (const ModelPtr other = editor.models().find(to.id))
        for (const Setting& p : row.parameters)
          if (other->parameter(p.name)) to.parameters.push_back(p);
      change(to);
    } else {
      parameterSliders(model, [&](const ModelParameter& p) { return row.value(p); },
                       [&](const ModelParameter& p, const Value& value) {
                         row.set(p, value);
                         change(row);
                       });
    }
    if (ui::button("Use for this material")) editor.useModel(row.id);
    if (mix && mix->ok()) {
      ImGui::SameLine();
      if (ui::button("Save as plugin\u2026")) editor.saveMix(**mix, text);
    }
    ImGui::Unindent();
  }

  // One that no row has yet.
  void addMix(Editor& editor) {
    const auto& rows = editor.document().preview().models;
    ModelMix mix = mixLike(nullptr);
    for (const Term& term : editor.terms()) {
      if (std::find(rows.begin(), rows.end(), mix.id()) == rows.end()) break;
      if (term.kind == TermKind::V) mix.V = term.name;
    }
    editor.addRow(mix.id());
    open_ = mix.id();
  }

  void details(Editor& editor, const ShadingModel& model) {
    ImGui::Indent();
    ui::textDim(model.doc);
    ui::textSmall("claims: " + claimsText(model));
    for (const std::string& cite : model.cite) ui::textSmall(cite);
    ui::textSmall(model.file.string());
    if (ui::button("Use for this material")) editor.useModel(model.id);
    if (!model.parameters.empty()) {
      ImGui::SameLine();
      if (ui::button("Add with other values")) {
        ModelRow row{model.id, {}};
        row.set(model.parameters[0], model.parameters[0].standard);
        editor.addRow(row.text());
        open_ = row.text();
      }
      ui::tooltip("One more row of this model, with sliders of its own");
    }
    ImGui::Unindent();
  }

  std::string open_;
};

}  // namespace

std::unique_ptr<Panel> makeModelsPanel() { return std::make_unique<ModelsPanel>(); }

}  // namespace glint
