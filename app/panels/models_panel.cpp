// The shading models there are: which are compared, what each claims, where its file lies and what is wrong with it.
#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
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
      Preview preview = document.preview();
      auto& rows = preview.models;
      bool compared = std::find(rows.begin(), rows.end(), model->id) != rows.end();
      if (ui::checkbox(model->id, compared)) {
        if (compared) rows.push_back(model->id);
        else std::erase(rows, model->id);
        document.setPreview((compared ? "Compare " : "Leave out ") + model->title, preview);
      }
      ImGui::SameLine();
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float size = ImGui::GetFontSize();
      const auto& c = model->color;
      ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + theme::px(5)}, {at.x + size * 0.8f, at.y + theme::px(5) + size * 0.8f},
                                                ImGui::ColorConvertFloat4ToU32({c[0], c[1], c[2], 1}), theme::px(2));
      ImGui::Dummy({size * 0.9f, size});
      ImGui::SameLine();
      const bool used = document.material().model == model->id;
      if (ui::row("row " + model->id, model->title, used ? "this material\u2019s" : model->id, used)) open_ = open_ == model->id ? "" : model->id;
      ui::tooltip(model->doc);
      if (open_ == model->id) details(editor, *model);
      ImGui::PopID();
    }
    drawOthers(editor);
    const Diagnostics& problems = editor.models().problems();
    if (problems.empty()) return;
    ImGui::Dummy({0, theme::px(4)});
    for (const Diagnostic& d : problems) ui::diagnostic(d);
  }

 private:
  // Rows of the comparison that are no files: mixes of terms, and models whose file is gone, which can be left out.
  static void drawOthers(Editor& editor) {
    Document& document = editor.document();
    const auto ids = editor.models().ids();
    for (const std::string& id : std::vector<std::string>(document.preview().models)) {
      if (std::find(ids.begin(), ids.end(), id) != ids.end()) continue;
      const ModelPtr mix = editor.models().find(id);
      ImGui::PushID(id.c_str());
      bool compared = true;
      if (ui::checkbox(id, compared)) {
        Preview preview = document.preview();
        std::erase(preview.models, id);
        document.setPreview("Leave out " + id, preview);
      }
      ImGui::SameLine();
      if (!mix) ImGui::PushStyleColor(ImGuiCol_Text, theme::kError);
      ui::row("row " + id, mix ? mix->title : id, mix ? "a mix of terms" : "missing", false);
      if (!mix) ImGui::PopStyleColor();
      ui::tooltip(mix ? mix->doc : "No file has this model any more: untick it, or put its file back");
      ImGui::PopID();
    }
  }
  void details(Editor& editor, const ShadingModel& model) {
    ImGui::Indent();
    ui::textDim(model.doc);
    std::string claims;
    if (model.claims.reciprocal) claims += "reciprocal";
    if (model.claims.energyConserving) claims += std::string(claims.empty() ? "" : ", ") + "conserves energy";
    ui::textSmall("claims: " + (claims.empty() ? "nothing" : claims));
    for (const std::string& cite : model.cite) ui::textSmall(cite);
    ui::textSmall(model.file.string());
    if (ui::button("Use for this material"))
      editor.refused(editor.document().edit("Model " + model.id, [&](GraphEditor& graph) { return graph.setModel(model.id); }));
    ImGui::Unindent();
  }
  std::string open_;
};

}  // namespace

std::unique_ptr<Panel> makeModelsPanel() { return std::make_unique<ModelsPanel>(); }

}  // namespace glint
