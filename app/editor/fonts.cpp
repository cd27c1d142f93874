#include "app/editor/fonts.h"

#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>

#include "materials/base/check.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

// Latin with its European letters, Greek (formulas), punctuation, arrows and signs that the texts use.
const ImWchar kGlyphs[] = {0x20, 0x17f, 0x391, 0x3c9, 0x2010, 0x2026, 0x2080, 0x2089, 0x2190, 0x2193,
                           0x2212, 0x2212, 0x221e, 0x221e, 0x2248, 0x2248, 0x25cf, 0x25cf, 0x2713, 0x2713, 0};
const ImWchar kCode[] = {0x20, 0x17f, 0};

std::string font(const char* name) {
  const auto bytes = shipped::read(name);
  GLINT_CHECK(bytes.has_value(), "{}", name);
  return *bytes;
}

}  // namespace

Fonts::Fonts()
    : inter_(font("fonts/Inter-Regular.otf")),
      interBold_(font("fonts/Inter-SemiBold.otf")),
      monoBytes_(font("fonts/JetBrainsMono-Regular.ttf")) {}

bool Fonts::build(float scale) {
  scale = std::clamp(scale, 0.5f, 8.0f);
  if (scale == scale_) return false;
  scale_ = scale;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  // Light hinting: rows snap to pixels, spacing stays the designer's.
  atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  const auto add = [&](std::string& bytes, float size, const ImWchar* glyphs) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = config.OversampleV = 1;
    // Whole pixels, so that the baseline lies on the grid.
    return atlas.AddFontFromMemoryTTF(bytes.data(), static_cast<int>(bytes.size()), std::round(size * scale),
                                      &config, glyphs);
  };
  regular_ = add(inter_, kTextSize, kGlyphs);
  bold_ = add(interBold_, kTextSize, kGlyphs);
  small_ = add(inter_, kSmallSize, kGlyphs);
  heading_ = add(interBold_, kHeadingSize, kGlyphs);
  mono_ = add(monoBytes_, kMonoSize, kCode);
  canvas_.clear();
  for (const float zoom : kCanvasZooms)
    canvas_.push_back({zoom, add(inter_, kCanvasSize * zoom, kGlyphs), add(interBold_, kCanvasSize * zoom, kGlyphs)});
  GLINT_CHECK(atlas.Build());
  return true;
}

}  // namespace glint
