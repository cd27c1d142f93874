// Everything that is wrong now, in one list.
#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

class ProblemsPanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    if (editor.problems().empty()) return ui::textDim("Nothing is wrong.");
    int index = 0;
    for (const Diagnostic& d : editor.problems()) {
      ImGui::PushID(index);
      ui::diagnostic(d);
      ui::mark("problem" + std::to_string(index++));
      // "node 'x'" leads to the node.
      const size_t at = d.place.find("node '");
      if (at != std::string::npos && ImGui::IsItemClicked()) {
        const size_t end = d.place.find('\'', at + 6);
        const std::string id = d.place.substr(at + 6, end - at - 6);
        if (editor.document().material().node(id)) editor.selection() = {id};
        editor.layout().show("Graph");
      }
      ImGui::Dummy({0, theme::px(4)});
      ImGui::PopID();
    }
    if (ui::button("Copy all")) {
      std::string text;
      for (const Diagnostic& d : editor.problems()) text += d.text() + "\n";
      ImGui::SetClipboardText(text.c_str());
    }
  }
};

}  // namespace

std::unique_ptr<Panel> makeProblemsPanel() { return std::make_unique<ProblemsPanel>(); }

}  // namespace glint
