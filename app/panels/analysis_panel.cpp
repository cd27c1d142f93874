// What the compared models are made of, in curves: terms, lobes, albedos and slices, computed on the render thread.
#include <fmt/format.h>

#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/model_row.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"
#include "app/panels/plot_canvas.h"
#include "materials/attributes.h"
#include "materials/graph_compile.h"

namespace glint {
namespace {

class AnalysisPanel final : public Panel {
 public:
  AnalysisPanel() : settings_(standardPlot(PlotKind::Lobe)) { settings_.ground = PlotGround::Dark; }

  void draw(Editor& editor) override {
    const PanelBody body;
    const ImVec2 low = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const float wide = theme::px(236);
    const bool beside = room.x > 2.2f * wide;
    if (beside) ImGui::BeginChild("controls", {wide, 0});
    drawControls();
    sayWhose(editor);
    const float below = ImGui::GetCursorScreenPos().y;
    if (beside) ImGui::EndChild();
    post(editor);
    const auto& result = editor.render().plot();
    const ImVec2 at = beside ? ImVec2{low.x + wide + theme::px(14), low.y - theme::px(6)} : ImVec2{low.x, below + theme::px(4)};
    const ImVec2 size{low.x + room.x - at.x, beside ? room.y + theme::px(6) : std::max(low.y + room.y - at.y, theme::px(260))};
    if (subjects_.empty()) {
      ImGui::SetCursorScreenPos(at);
      ui::textDim("No model is compared: tick some under Models.");
      return;
    }
    // A result of the models before is of no use once they have changed; of other settings it stays until the next comes.
    if (!result || result->serial < firstOfModels_) {
      ImGui::SetCursorScreenPos(at);
      ui::textDim("Computing\u2026");
      return;
    }
    canvas_.draw({result, &result->data}, at, size, hidden_);
  }

 private:
  void drawControls() {
    std::vector<std::string> titles, docs;
    for (size_t i = 0; i < plotKindNames().size(); ++i) titles.emplace_back(title(static_cast<PlotKind>(i)));
    int kind = static_cast<int>(settings_.kind);
    if (property("Plot", [&] { return ui::choice("Plot", kind, titles); })) changeKind(static_cast<PlotKind>(kind));
    const auto can = [&](const char* key) { return takes(settings_.kind, key); };
    const bool albedo = settings_.kind == PlotKind::Albedo;
    if (can("over")) {
      const std::vector<std::string> axes{"angle", "roughness"};
      int over = settings_.overRoughness;
      if (property("Over", [&] { return ui::segments("Over", over, axes); })) settings_.overRoughness = over != 0;
    }
    if (can("roughness") && !(albedo && settings_.overRoughness))
      property("Roughness", [&] { return ui::slider("Roughness", settings_.roughness[0], 0, 1, "%.2f"); });
    if (can("angle") && !(albedo && !settings_.overRoughness))
      property(settings_.kind == PlotKind::G || settings_.kind == PlotKind::V ? "Light angle" : "View angle",
               [&] { return ui::slider("Angle", settings_.angles[0], 0, 90, "%.0f\u00b0"); });
    if (settings_.kind == PlotKind::Slice) property("\u03c6d", [&] { return ui::slider("Phi", settings_.phi, 0, 180, "%.0f\u00b0"); });
    if (can("out")) property("Out of plane", [&] { return ui::slider("Out of plane", settings_.out, -90, 90, "%.0f\u00b0"); });
    if (can("part")) partChoice();
    if (albedo) property("White furnace", [&] { return ui::checkbox("White furnace", settings_.white); });
    if (can("F0") && !settings_.white) {
      property("Base color", [&] { return ui::color("Base color", &settings_.baseColor.x); });
      property("Metallic", [&] { return ui::slider("Metallic", settings_.metallic, 0, 1, "%.2f"); });
      property("Specular", [&] { return ui::slider("Specular", settings_.specular, 0, 1, "%.2f"); });
    }
    if (can("channel")) {
      std::vector<std::string> names(plotChannelNames().begin(), plotChannelNames().end());
      int channel = static_cast<int>(settings_.channel);
      if (property("Channel", [&] { return ui::choice("Channel", channel, names); })) settings_.channel = static_cast<PlotChannel>(channel);
    }
    if (can("cosine")) property("Times cosine", [&] { return ui::checkbox("Times cosine", settings_.cosine); });
    if (can("compensate")) property("All bounces", [&] { return ui::checkbox("All bounces", settings_.compensate); });
    if (property("Log scale", [&] { return ui::checkbox("Log scale", settings_.log); })) canvas_.showAll();
  }

  template <class Widget>
  static bool property(const std::string& label, Widget widget) {
    ui::beginProperty(label);
    const bool changed = widget();
    ui::endProperty();
    return changed;
  }

  void partChoice() {
    const bool slice = settings_.kind == PlotKind::Slice;
    std::vector<std::string> names{"specular", "diffuse", "sum"};
    if (!slice) names.insert(names.end(), {"specular and diffuse", "all three"});
    const std::vector<std::vector<PlotPart>> parts{{PlotPart::Specular}, {PlotPart::Diffuse}, {PlotPart::Sum}, {PlotPart::Specular, PlotPart::Diffuse},
                                                   {PlotPart::Specular, PlotPart::Diffuse, PlotPart::Sum}};
    int index = static_cast<int>(std::find(parts.begin(), parts.end(), settings_.parts) - parts.begin());
    if (property("Part", [&] { return ui::choice("Part", index, names); })) settings_.parts = parts[size_t(index)];
  }

  // What both kinds know stays; the rest is as the kind has it.
  void changeKind(PlotKind kind) {
    PlotSettings next = standardPlot(kind);
    next.ground = PlotGround::Dark;
    next.roughness = settings_.roughness;
    next.baseColor = settings_.baseColor;
    next.metallic = settings_.metallic;
    next.specular = settings_.specular;
    next.channel = settings_.channel;
    if (kind != PlotKind::Slice && settings_.kind != PlotKind::Slice) next.log = settings_.log;
    if (takes(kind, "angle") && takes(settings_.kind, "angle")) next.angles = settings_.angles;
    if (takes(kind, "cosine")) next.cosine = settings_.cosine;
    settings_ = next;
    canvas_.showAll();
  }

  void post(Editor& editor) {
    std::vector<PlotSubject> subjects;
    // The rows of the comparison, and the model that is being worked on.
    std::vector<std::string> ids;
    for (const std::string& row : editor.document().preview().models) ids.push_back(modelRow(row).id);
    ids.push_back(editor.document().material().model);
    for (auto id = ids.begin(); id != ids.end(); ++id)
      if (ModelPtr model = std::find(ids.begin(), id, *id) == id ? editor.models().find(*id) : nullptr) subjects.push_back(subjectOf(editor, std::move(model)));
    const auto same = [](const PlotSubject& a, const PlotSubject& b) { return a.model == b.model; };
    const bool models = std::equal(subjects.begin(), subjects.end(), subjects_.begin(), subjects_.end(), same);
    const bool values = models && std::equal(subjects.begin(), subjects.end(), subjects_.begin(),
                                             [](const PlotSubject& a, const PlotSubject& b) { return a.parameters == b.parameters; });
    const bool dragging = ImGui::IsMouseDown(0) && ImGui::IsAnyItemActive();
    if (values && posted_ == settings_ && !(coarse_ && !dragging)) return;
    if (!models) {
      hidden_.clear();
      firstOfModels_ = serial_ + 1;
    }
    subjects_ = subjects;
    posted_ = settings_;
    coarse_ = dragging;
    if (!subjects.empty()) editor.render().postPlot({++serial_, settings_, std::move(subjects), dragging});
  }

  // The material's own model has the values that the material gives its parameters, others their defaults.
  PlotSubject subjectOf(Editor& editor, ModelPtr model) {
    PlotSubject subject{model, {}, model->title};
    const Material& material = editor.document().material();
    if (model->id != material.model || model->parameters.empty()) return subject;
    if (compiledRevision_ != editor.document().graphRevision() || compiledFor_ != model) {
      compiledRevision_ = editor.document().graphRevision();
      compiledFor_ = model;
      values_.clear();
      if (const auto compiled = compileMaterial(material, *model, editor.nodes(), editor.functions())) {
        values_ = compiled->modelParameters;
        const std::vector<Value> now = compiled->modelParameterValues();
        for (size_t i = 0; i < values_.size(); ++i) values_[i].value = now[i];
      }
    }
    for (const ModelParameterSource& source : values_) {
      const ModelParameter* parameter = model->parameter(source.name);
      if (!parameter || source.varies || source.value == parameter->standard) continue;
      subject.parameters.emplace_back(source.name, source.value);
      subject.title += fmt::format(", {} {}", parameter->title.empty() ? source.name : parameter->title, valueText(source.value));
    }
    return subject;
  }
  // Says whose values the parameters have.
  void sayWhose(Editor& editor) {
    const Material& material = editor.document().material();
    for (const PlotSubject& subject : subjects_)
      if (subject.model->id == material.model && !subject.model->parameters.empty())
        ui::textDim(fmt::format("{} has this material's parameters, other models their own.", subject.model->title).c_str());
  }

  std::optional<uint64_t> compiledRevision_;
  ModelPtr compiledFor_;
  std::vector<ModelParameterSource> values_;
  PlotSettings settings_;
  std::optional<PlotSettings> posted_;
  std::vector<PlotSubject> subjects_;
  bool coarse_ = false;               // the last request was made while something was dragged
  uint64_t serial_ = 0, firstOfModels_ = 1;
  std::set<size_t> hidden_;
  PlotCanvas canvas_;
};

}  // namespace

std::unique_ptr<Panel> makeAnalysisPanel() { return std::make_unique<AnalysisPanel>(); }

}  // namespace glint
