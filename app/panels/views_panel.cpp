// One button for each view of the picture: the lit one and every buffer behind it.
#include "app/editor/editor.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

class ViewsPanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    const PanelBody body;
    Preview preview = editor.document().preview();
    for (const ViewMode& mode : viewModes()) {
      if (ui::row(mode.id, mode.title, "", preview.view == mode.id)) {
        preview.view = mode.id;
        editor.document().setPreview(std::string("View ") + mode.title, preview);
      }
      ui::tooltip(mode.doc);
    }
  }
};

}  // namespace

std::unique_ptr<Panel> makeViewsPanel() { return std::make_unique<ViewsPanel>(); }

}  // namespace glint
