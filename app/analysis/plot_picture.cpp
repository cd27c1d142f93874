#include "app/analysis/plot_picture.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

TextStyle styleOf(float size, bool bold, PlotColor color) {
  return {size, bold ? TextFace::SemiBold : TextFace::Regular, {color.r, color.g, color.b}};
}

// Covers each pixel by how near it is to the line, and blends once, so that joints are no darker than the rest.
class LinePainter {
 public:
  explicit LinePainter(Image8& picture) : picture_(picture), cover_(static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height)) {}

  void draw(const std::vector<glm::vec2>& points, float width, PlotColor color) {
    if (points.empty()) return;
    low_ = {picture_.width, picture_.height};
    high_ = {-1, -1};
    for (size_t i = 1; i < points.size(); ++i) segment(points[i - 1], points[i], 0.5f * width);
    if (points.size() == 1) segment(points[0], points[0], 0.5f * width);
    for (int y = low_.y; y <= high_.y; ++y)
      for (int x = low_.x; x <= high_.x; ++x) {
        float& cover = cover_[static_cast<size_t>(y) * static_cast<size_t>(picture_.width) + static_cast<size_t>(x)];
        if (cover <= 0) continue;
        uint8_t* pixel = picture_.at(x, y);
        const uint8_t channels[3] = {color.r, color.g, color.b};
        for (int k = 0; k < 3; ++k) pixel[k] = static_cast<uint8_t>(std::lround(pixel[k] + cover * (channels[k] - pixel[k])));
        cover = 0;
      }
  }

 private:
  void segment(glm::vec2 a, glm::vec2 b, float half) {
    const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(glm::min(a, b) - half - 1.0f)), glm::ivec2(0));
    const glm::ivec2 high = glm::min(glm::ivec2(glm::ceil(glm::max(a, b) + half + 1.0f)), glm::ivec2(picture_.width - 1, picture_.height - 1));
    const glm::vec2 along = b - a;
    const float length2 = glm::dot(along, along);
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const glm::vec2 p{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
        const float t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f) : 0.0f;
        const float cover = std::clamp(half + 0.5f - glm::distance(p, a + t * along), 0.0f, 1.0f);
        float& at = cover_[static_cast<size_t>(y) * static_cast<size_t>(picture_.width) + static_cast<size_t>(x)];
        at = std::max(at, cover);
      }
    low_ = glm::min(low_, low);
    high_ = glm::max(high_, high);
  }

  Image8& picture_;
  std::vector<float> cover_;
  glm::ivec2 low_{0}, high_{-1};
};

struct Painter {
  Image8& picture;
  LinePainter lines;
  TextPainter texts;

  void operator()(const PlotRect& r) {
    for (int y = std::max(0, static_cast<int>(r.low.y)); y < std::min(picture.height, static_cast<int>(r.high.y)); ++y)
      for (int x = std::max(0, static_cast<int>(r.low.x)); x < std::min(picture.width, static_cast<int>(r.high.x)); ++x) {
        uint8_t* pixel = picture.at(x, y);
        pixel[0] = r.color.r, pixel[1] = r.color.g, pixel[2] = r.color.b;
      }
  }

  void operator()(const PlotLine& line) {
    for (const auto& part : dashes(line)) lines.draw(part, line.width, line.color);
  }

  void operator()(const PlotText& text) {
    float x = text.at.x;
    if (text.align != TextAlign::Left) {
      const float width = textWidth(text.text, text.size, text.bold, [&](const std::string& t, float size, bool bold) { return texts.width(t, styleOf(size, bold, {})); });
      x -= width * (text.align == TextAlign::Center ? 0.5f : 1.0f);
    }
    for (const PlotTextRun& run : textRuns(text.text)) {
      const TextStyle style = styleOf(run.level ? text.size * kRunSize : text.size, text.bold, text.color);
      texts.draw(picture, x, text.at.y + (run.level < 0 ? kLowered : run.level > 0 ? kRaised : 0) * text.size, run.text, style);
      x += texts.width(run.text, style);
    }
  }

  // Enlarged by blending between pixels; made smaller by the mean of those it covers.
  void operator()(const PlotBitmap& bitmap) {
    const glm::ivec2 low{bitmap.low}, size = glm::ivec2(bitmap.high) - low;
    const Image8& from = bitmap.pixels;
    const auto sample = [&](float u, float v, int k) {
      const float x = std::clamp(u - 0.5f, 0.0f, static_cast<float>(from.width - 1)), y = std::clamp(v - 0.5f, 0.0f, static_cast<float>(from.height - 1));
      const int x0 = static_cast<int>(x), y0 = static_cast<int>(y), x1 = std::min(x0 + 1, from.width - 1), y1 = std::min(y0 + 1, from.height - 1);
      const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
      return (1 - fy) * ((1 - fx) * from.at(x0, y0)[k] + fx * from.at(x1, y0)[k]) + fy * ((1 - fx) * from.at(x0, y1)[k] + fx * from.at(x1, y1)[k]);
    };
    const float stepX = static_cast<float>(from.width) / static_cast<float>(size.x), stepY = static_cast<float>(from.height) / static_cast<float>(size.y);
    const int nx = std::max(1, static_cast<int>(std::ceil(stepX))), ny = std::max(1, static_cast<int>(std::ceil(stepY)));
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (low.x + x < 0 || low.y + y < 0 || low.x + x >= picture.width || low.y + y >= picture.height) continue;
        for (int k = 0; k < 3; ++k) {
          float sum = 0;
          for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
              sum += sample((static_cast<float>(x) + (static_cast<float>(i) + 0.5f) / static_cast<float>(nx)) * stepX,
                            (static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / static_cast<float>(ny)) * stepY, k);
          picture.at(low.x + x, low.y + y)[k] = static_cast<uint8_t>(std::lround(sum / static_cast<float>(nx * ny)));
        }
      }
  }
};

}  // namespace

Image8 plotPicture(const PlotDrawing& drawing) {
  Image8 picture(drawing.size.x, drawing.size.y, 3);
  for (size_t i = 0; i < picture.data.size(); i += 3) {
    picture.data[i] = drawing.ground.r;
    picture.data[i + 1] = drawing.ground.g;
    picture.data[i + 2] = drawing.ground.b;
  }
  Painter painter{picture, LinePainter(picture), {}};
  for (const PlotItem& item : drawing.items) std::visit(painter, item);
  return picture;
}

TextMeasure pictureTextMeasure() {
  return [painter = std::make_shared<TextPainter>()](const std::string& text, float size, bool bold) { return painter->width(text, styleOf(size, bold, {})); };
}

}  // namespace glint
