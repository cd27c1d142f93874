#include "app/text_painter.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <cstring>

#include "materials/base/utf8.h"
#include "shaders/shipped_files.h"

namespace glint {

struct TextPainter::Faces {
  std::string bytes[2];  // FreeType reads from them for as long as a face lives
  FT_Library library = nullptr;
  FT_Face face[2] = {};

  FT_Face at(const TextStyle& style) {
    const FT_Face chosen = face[style.face == TextFace::SemiBold];
    const float size = std::clamp(style.size, 4.0f, 512.0f);
    FT_Set_Char_Size(chosen, 0, static_cast<FT_F26Dot6>(std::lround(size * 64)), 72, 72);
    return chosen;
  }
};

TextPainter::TextPainter() : faces_(std::make_unique<Faces>()) {
  GLINT_CHECK(FT_Init_FreeType(&faces_->library) == 0);
  const char* const names[2] = {"fonts/Inter-Regular.otf", "fonts/Inter-SemiBold.otf"};
  for (int i = 0; i < 2; ++i) {
    faces_->bytes[i] = shipped::read(names[i]).value_or("");
    GLINT_CHECK(FT_New_Memory_Face(faces_->library, reinterpret_cast<const FT_Byte*>(faces_->bytes[i].data()),
                                   static_cast<FT_Long>(faces_->bytes[i].size()), 0, &faces_->face[i]) == 0,
                "{}", names[i]);
  }
}

TextPainter::~TextPainter() {
  for (FT_Face face : faces_->face) FT_Done_Face(face);
  FT_Done_FreeType(faces_->library);
}

float TextPainter::width(const std::string& text, const TextStyle& style) {
  const FT_Face face = faces_->at(style);
  float sum = 0;
  for (size_t at = 0; at < text.size();) {
    if (FT_Load_Char(face, nextCodePoint(text, at), FT_LOAD_NO_HINTING)) continue;
    sum += static_cast<float>(face->glyph->linearHoriAdvance) / 65536.0f;
  }
  return sum;
}

float TextPainter::ascent(const TextStyle& style) {
  return static_cast<float>(faces_->at(style)->size->metrics.ascender) / 64.0f;
}

float TextPainter::lineHeight(const TextStyle& style) {
  return static_cast<float>(faces_->at(style)->size->metrics.height) / 64.0f;
}

std::string TextPainter::fitted(const std::string& text, const TextStyle& style, float available) {
  if (width(text, style) <= available) return text;
  const std::string ellipsis = "\u2026";
  std::string kept = text;
  while (!kept.empty()) {
    // One whole code point at a time: its continuation bytes, then its first.
    while (kept.size() > 1 && (static_cast<unsigned char>(kept.back()) & 0xc0) == 0x80) kept.pop_back();
    kept.pop_back();
    if (width(kept + ellipsis, style) <= available) break;
  }
  return kept + ellipsis;
}

std::vector<std::string> TextPainter::wrapped(const std::string& text, const TextStyle& style, float available,
                                              int mostLines) {
  std::vector<std::string> lines;
  size_t from = 0;
  while (from < text.size()) {
    if (static_cast<int>(lines.size()) + 1 == mostLines) {
      lines.push_back(fitted(text.substr(from), style, available));
      break;
    }
    // As far as fits; back to the last place where a reader would break, if there is one.
    size_t fits = from, nice = from;
    for (size_t at = from; at < text.size();) {
      nextCodePoint(text, at);
      if (width(text.substr(from, at - from), style) > available && fits > from && text[at - 1] != ' ') break;
      fits = at;
      if (at == text.size() || std::strchr(" *-_/", text[at - 1]) != nullptr) nice = at;
    }
    const size_t to = nice > from ? nice : fits;
    std::string line = text.substr(from, to - from);
    while (!line.empty() && line.back() == ' ') line.pop_back();
    if (!line.empty()) lines.push_back(std::move(line));
    from = to;
  }
  return lines;
}

void TextPainter::draw(Image8& picture, float x, float baseline, const std::string& text, const TextStyle& style,
                       TextAlign align) {
  GLINT_CHECK(picture.channels >= 3, "channels {}", picture.channels);
  if (align != TextAlign::Left) x -= width(text, style) * (align == TextAlign::Center ? 0.5f : 1.0f);
  const FT_Face face = faces_->at(style);
  const int row = static_cast<int>(std::lround(baseline));
  for (size_t at = 0; at < text.size();) {
    const char32_t code = nextCodePoint(text, at);
    // Light hinting snaps to the pixel grid vertically only, so that stems stay sharp and spacing true.
    if (FT_Load_Char(face, code, FT_LOAD_TARGET_LIGHT)) continue;
    const FT_GlyphSlot glyph = face->glyph;
    const float advance = static_cast<float>(glyph->linearHoriAdvance) / 65536.0f;
    const float left = std::floor(x);
    FT_Outline_Translate(&glyph->outline, static_cast<FT_Pos>(std::lround((x - left) * 64)), 0);
    x += advance;
    if (FT_Render_Glyph(glyph, FT_RENDER_MODE_NORMAL)) continue;
    for (int j = 0; j < static_cast<int>(glyph->bitmap.rows); ++j) {
      const int py = row - glyph->bitmap_top + j;
      if (py < 0 || py >= picture.height) continue;
      for (int i = 0; i < static_cast<int>(glyph->bitmap.width); ++i) {
        const int px = static_cast<int>(left) + glyph->bitmap_left + i;
        if (px < 0 || px >= picture.width) continue;
        const int cover = glyph->bitmap.buffer[j * glyph->bitmap.pitch + i];
        uint8_t* pixel = picture.at(px, py);
        for (int c = 0; c < 3; ++c)
          pixel[c] = static_cast<uint8_t>((pixel[c] * (255 - cover) + style.color[c] * cover + 127) / 255);
        if (picture.channels == 4) pixel[3] = static_cast<uint8_t>(std::max<int>(pixel[3], cover));
      }
    }
  }
}

}  // namespace glint
