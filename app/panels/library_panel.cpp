// The materials that Glint ships: to open, or to stand beside the edited one in the comparison.
#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"
#include "materials/material_library.h"

namespace glint {
namespace {

class LibraryPanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    Document& document = editor.document();
    if (entries_.empty())
      for (const std::string& name : libraryMaterialNames()) {
        const auto material = loadMaterial(name, editor.nodes());
        entries_.push_back({name, material ? material->doc : ""});
      }
    ui::textDim("Ticked materials are columns of the comparison. Click a name to edit a copy.");
    ImGui::Dummy({0, theme::px(2)});
    std::string open;
    for (const auto& [name, doc] : entries_) {
      ImGui::PushID(name.c_str());
      Preview preview = document.preview();
      auto& columns = preview.materials;
      bool compared = std::find(columns.begin(), columns.end(), name) != columns.end();
      if (ui::checkbox("compare " + name, compared)) {
        if (compared) columns.push_back(name);
        else std::erase(columns, name);
        document.setPreview((compared ? "Compare " : "Leave out ") + name, preview);
      }
      ImGui::SameLine();
      if (ui::row(name, name, "", false)) open = name;
      ui::tooltip(doc);
      ImGui::PopID();
    }
    // Columns that are files of the user's.
    Preview preview = document.preview();
    std::string remove;
    for (const std::string& column : preview.materials) {
      if (std::any_of(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.first == column; })) continue;
      ImGui::PushID(column.c_str());
      bool on = true;
      if (ui::checkbox("compare " + column, on)) remove = column;
      ImGui::SameLine();
      ui::row(column, std::filesystem::path(column).filename().string(), "file", false);
      ui::tooltip(column);
      ImGui::PopID();
    }
    if (!remove.empty()) {
      std::erase(preview.materials, remove);
      document.setPreview("Leave out " + std::filesystem::path(remove).filename().string(), preview);
    }
    const std::vector<MaterialPtr>& own = editor.shown().meshMaterials;
    int copied = -1;
    if (!own.empty() && ui::section("Of the mesh"))
      for (size_t i = 0; i < own.size(); ++i)
        if (ui::row("mesh" + std::to_string(i), own[i]->name, int(i) == editor.document().preview().editedSlot ? "being edited" : "edit", false)) copied = int(i);
    if (copied >= 0) editor.editMeshMaterial(copied);
    ImGui::Dummy({0, theme::px(4)});
    if (ui::button("Compare with a file\u2026"))
      editor.browse({.title = "Choose a material to compare with", .extensions = {".json"},
                     .chosen = [&editor](const std::filesystem::path& file) {
                       Preview changed = editor.document().preview();
                       changed.materials.push_back(file.string());
                       editor.document().setPreview("Compare " + file.filename().string(), changed);
                     }});
    if (!open.empty()) editor.openLibrary(open);
  }

 private:
  std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace

std::unique_ptr<Panel> makeLibraryPanel() { return std::make_unique<LibraryPanel>(); }

}  // namespace glint
