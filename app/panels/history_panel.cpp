// Every step since the document was opened; a click goes back or forth to it.
#include "app/editor/editor.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

class HistoryPanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    Document& document = editor.document();
    const auto& steps = document.steps();
    size_t wanted = document.position();
    if (ui::row("start", document.file().empty() ? "New document" : "Opened " + document.file().filename().string(), "",
                document.position() == 0))
      wanted = 0;
    for (size_t i = 0; i < steps.size(); ++i) {
      // What was undone can be had again until the next edit.
      ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * (i < document.position() ? 1.0f : 0.5f));
      if (ui::row("step" + std::to_string(i), steps[i].label, steps[i].ofGraph ? "material" : "scene", i + 1 == document.position()))
        wanted = i + 1;
      if (i + 1 == document.position() && steps.size() != count_) ImGui::SetScrollHereY();
      ImGui::PopStyleVar();
    }
    count_ = steps.size();
    if (wanted != document.position()) document.goTo(wanted);
  }

 private:
  size_t count_ = 0;
};

}  // namespace

std::unique_ptr<Panel> makeHistoryPanel() { return std::make_unique<HistoryPanel>(); }

}  // namespace glint
