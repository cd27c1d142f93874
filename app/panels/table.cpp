// Every panel, in the order of the View menu.
#include <imgui.h>

#include "app/editor/theme.h"
#include "app/panels/panel.h"

namespace glint {

std::unique_ptr<Panel> makeViewportPanel();
std::unique_ptr<Panel> makeGraphPanel();
std::unique_ptr<Panel> makePropertiesPanel();
std::unique_ptr<Panel> makeLibraryPanel();
std::unique_ptr<Panel> makeScenePanel();
std::unique_ptr<Panel> makeViewsPanel();
std::unique_ptr<Panel> makeModelsPanel();
std::unique_ptr<Panel> makeHistoryPanel();
std::unique_ptr<Panel> makeProblemsPanel();
std::unique_ptr<Panel> makeCodePanel();
std::unique_ptr<Panel> makeAnalysisPanel();

std::span<const PanelInfo> panelTable() {
  static const PanelInfo table[] = {
      {"Viewport", makeViewportPanel}, {"Graph", makeGraphPanel},     {"Properties", makePropertiesPanel},
      {"Library", makeLibraryPanel},   {"Scene", makeScenePanel},     {"Views", makeViewsPanel},
      {"Models", makeModelsPanel},     {"History", makeHistoryPanel}, {"Problems", makeProblemsPanel},
      {"Shader code", makeCodePanel},  {"Analysis", makeAnalysisPanel},
  };
  return table;
}

PanelBody::PanelBody() {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme::px(10), theme::px(8)});
  ImGui::BeginChild("body", {0, 0}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
}

PanelBody::~PanelBody() { ImGui::EndChild(); }

}  // namespace glint
