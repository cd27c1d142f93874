// The GLSL that the graph compiles to, to be read and copied.
#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/theme.h"
#include "app/editor/ui.h"
#include "app/panels/panel.h"

namespace glint {
namespace {

class CodePanel final : public Panel {
 public:
  void draw(Editor& editor) override {
    editor.wantCode();
    const FrameResult& frame = editor.shown();
    if (frame.code != code_) {
      code_ = frame.code;
      lines_.clear();
      for (size_t at = 0; at < code_.size();) {
        const size_t end = std::min(code_.find('\n', at), code_.size());
        lines_.push_back({at, end});
        at = end + 1;
      }
    }
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({low.x + theme::px(10), low.y + theme::px(5)});
    if (ui::button("Copy")) ImGui::SetClipboardText(code_.c_str());
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (code_.empty()) ui::textDim("Not compiled yet: see Problems.");
    else
      ui::textDim(std::to_string(frame.stats.nodes) + " nodes, " + std::to_string(frame.stats.statements) + " statements, " +
                  std::to_string(lines_.size()) + " lines");
    ImGui::SetCursorScreenPos({low.x, low.y + ImGui::GetFrameHeight() + theme::px(10)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kField);
    ImGui::BeginChild("code", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::PushFont(editor.fonts().mono());
    const float gutter = ImGui::CalcTextSize("00000").x;
    ImGuiListClipper clipper;
    clipper.Begin(int(lines_.size()));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) line(i, gutter);
    ImGui::PopFont();
    ImGui::EndChild();
    ImGui::PopStyleColor();
  }

 private:
  void line(int index, float gutter) {
    const char* begin = code_.c_str() + lines_[size_t(index)].first;
    const char* end = code_.c_str() + lines_[size_t(index)].second;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string number = std::to_string(index + 1);
    list.AddText({at.x + gutter - theme::px(10) - ImGui::CalcTextSize(number.c_str()).x, at.y}, theme::kTextFaint, number.c_str());
    // Comments, numbers, types and preprocessor lines each have a grey or a tint; enough to find one's way.
    float x = at.x + gutter;
    for (const char* p = begin; p < end;) {
      const char* q = p;
      ImU32 color = theme::grey(205);
      const auto word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
      if (p[0] == '/' && p + 1 < end && p[1] == '/') {
        q = end;
        color = IM_COL32(128, 150, 118, 255);
      } else if (*p == '#') {
        q = end;
        color = IM_COL32(196, 150, 190, 255);
      } else if (std::isdigit(static_cast<unsigned char>(*p))) {
        while (q < end && (word(*q) || *q == '.')) ++q;
        color = IM_COL32(206, 178, 120, 255);
      } else if (word(*p)) {
        while (q < end && word(*q)) ++q;
        const std::string_view name(p, size_t(q - p));
        static constexpr std::string_view kTypes[] = {"void",  "bool", "int",    "float",  "vec2",   "vec3",    "vec4",  "mat3",
                                                      "mat4",  "in",   "inout",  "out",    "const",  "uniform", "layout", "sampler2D",
                                                      "return", "if",  "else",   "for",    "struct", "MaterialAttributes", "MaterialInputs"};
        if (std::find(std::begin(kTypes), std::end(kTypes), name) != std::end(kTypes)) color = IM_COL32(132, 172, 190, 255);
      } else {
        while (q < end && !word(*q) && *q != '/' && *q != '#') ++q;
        if (q == p) ++q;
      }
      list.AddText({x, at.y}, color, p, q);
      x += ImGui::CalcTextSize(p, q).x;
      p = q;
    }
    ImGui::Dummy({x - at.x + theme::px(10), ImGui::GetFontSize()});
  }

  std::string code_;
  std::vector<std::pair<size_t, size_t>> lines_;
};

}  // namespace

std::unique_ptr<Panel> makeCodePanel() { return std::make_unique<CodePanel>(); }

}  // namespace glint
