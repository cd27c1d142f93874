#include "app/editor/model_picker.h"

#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/health_badge.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "materials/terms.h"

namespace glint {
namespace {

constexpr const char* kMixTitle = "Mix of terms\u2026";

// A selectable line of the list: sign, title. True when clicked.
bool line(Editor& editor, const std::string& label, const ModelPtr& model, bool selected) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeightWithSpacing(), radius = healthSignRadius();
  ImGui::PushID(model->id.c_str());
  const bool clicked = ImGui::Selectable("##model", selected, 0, {0, height});
  ImGui::PopID();
  ui::mark(label + ":" + model->title);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ModelHealthPtr card = editor.health().card(model);
  drawHealthSign(list, {at.x + radius + theme::px(2), at.y + height / 2}, radius, card.get());
  list.AddText({at.x + 2 * radius + theme::px(10), at.y + (height - ImGui::GetFontSize()) / 2}, theme::kText, model->title.c_str());
  if (ImGui::IsItemHovered()) {
    ImGui::SetNextWindowSize({theme::px(340), 0});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(model->doc.c_str());
    ImGui::PopTextWrapPos();
    if (card && card->verdict() != Verdict::Green) {
      ImGui::Dummy({0, theme::px(3)});
      ui::textDim(card->reason());
    }
    ImGui::EndTooltip();
  }
  return clicked;
}

struct Picker {
  const char* label;
  const char* doc;
  TermKind kind;
  std::string ModelMix::*name;
};
constexpr Picker kPickers[] = {
    {"Distribution", "D: how the microfacets\u2019 normals are spread", TermKind::D, &ModelMix::D},
    {"Visibility", "V, which is G / (4 NoL NoV): how much facets hide each other", TermKind::V, &ModelMix::V},
    {"Fresnel", "F: how reflection grows where light grazes", TermKind::F, &ModelMix::F},
    {"Diffuse", "What comes back out of the surface", TermKind::Diffuse, &ModelMix::diffuse},
};

}  // namespace

bool modelPicker(Editor& editor, const std::string& label, std::string& id) {
  const ModelPtr now = editor.models().find(id);
  const bool mixed = isModelMix(id);
  const std::string before = id;
  if (ImGui::BeginCombo(("##" + label).c_str(), (now ? now->title : id).c_str(), ImGuiComboFlags_HeightLargest)) {
    for (const ModelPtr& model : editor.models().all())
      if (line(editor, label, model, model->id == id)) id = model->id;
    ImGui::Separator();
    if (ImGui::Selectable(kMixTitle, mixed) && !mixed) id = mixLike(now.get()).id();
    ui::mark(label + ":" + kMixTitle);
    ui::tooltip("Any distribution with any visibility, Fresnel and diffuse term");
    ImGui::EndCombo();
  } else {
    ui::mark(label);
    if (now) ui::tooltip(now->doc);
  }
  return id != before;
}

bool mixPickers(Editor& editor, ModelMix& mix) {
  bool changed = false;
  for (const Picker& picker : kPickers) {
    std::vector<std::string> names, docs;
    for (const Term& term : editor.terms())
      if (term.kind == picker.kind) {
        names.push_back(term.name);
        docs.push_back(term.doc);
      }
    std::string& chosen = mix.*picker.name;
    int index = int(std::find(names.begin(), names.end(), chosen) - names.begin());
    ui::beginProperty(picker.label, picker.doc);
    if (ui::choice(picker.label, index, names, docs)) {
      chosen = names[size_t(index)];
      changed = true;
    } else if (size_t(index) < docs.size()) {
      ui::tooltip(docs[size_t(index)]);
    }
    ui::endProperty();
  }
  return changed;
}

ModelMix mixLike(const ShadingModel* model) {
  ModelMix mix{.D = "GGX", .V = "SmithGGXCorrelated", .F = "Schlick"};
  if (!model) return mix;
  const auto take = [](std::string& to, const std::string& term) {
    if (!term.empty()) to = term;
  };
  take(mix.D, model->termD);
  take(mix.V, model->termV.empty() ? model->termG : model->termV);
  take(mix.F, model->termF);
  take(mix.diffuse, model->termDiffuse);
  return mix;
}

void parameterSliders(const ShadingModel& model, const std::function<Value(const ModelParameter&)>& valueOf,
                      const std::function<void(const ModelParameter&, const Value&)>& set) {
  for (const ModelParameter& parameter : model.parameters) {
    Value value = valueOf(parameter);
    value.type = parameter.standard.type;
    const std::string title = parameter.title.empty() ? parameter.name : parameter.title;
    if (ui::valueProperty(title, parameter.doc, value, parameter.minimum, parameter.maximum, parameter.standard)) set(parameter, value);
  }
}

}  // namespace glint
