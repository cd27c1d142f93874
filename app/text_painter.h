// Text drawn into pictures in memory, for the labels of comparison sheets. No OpenGL.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "renderer/image.h"

namespace glint {

enum class TextFace { Regular, SemiBold };
enum class TextAlign { Left, Center, Right };

struct TextStyle {
  float size = 16;                               // pixels of the em square, 4..512
  TextFace face = TextFace::Regular;
  std::array<uint8_t, 3> color{235, 235, 235};   // display-referred sRGB
};

// The shipped Inter faces. Not for several threads at once.
class TextPainter {
 public:
  TextPainter();
  ~TextPainter();
  TextPainter(const TextPainter&) = delete;

  // In pixels. UTF-8; what the face has no glyph for is drawn as a box.
  float width(const std::string& text, const TextStyle&);
  float ascent(const TextStyle&);       // above the baseline
  float lineHeight(const TextStyle&);   // from one baseline to the next

  // The text itself when it fits, else its beginning and an ellipsis.
  std::string fitted(const std::string& text, const TextStyle&, float width);

  // The text in lines of at most `width`, broken at spaces, after the marks that join names (*-_/+) and, where a
  // single piece is too long, anywhere. What `mostLines` cannot hold ends in an ellipsis. Empty text: no lines.
  std::vector<std::string> wrapped(const std::string& text, const TextStyle&, float width, int mostLines);

  // Blends one line over a picture of 3 or 4 channels; `x` is its left, centre or right, `baseline` counts from the
  // top row. What lies outside the picture is cut.
  void draw(Image8&, float x, float baseline, const std::string& text, const TextStyle&,
            TextAlign = TextAlign::Left);

 private:
  struct Faces;
  std::unique_ptr<Faces> faces_;
};

}  // namespace glint
