#include "app/analysis/plot_svg.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/markup.h"
#include "renderer/image_codecs.h"

namespace glint {
namespace {

// Hundredths of a pixel, without zeros at the end.
std::string number(float value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string hex(PlotColor c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

struct Writer {
  std::string svg;
  Diagnostics problems;

  void operator()(const PlotRect& r) {
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", number(r.low.x), number(r.low.y), number(r.high.x - r.low.x),
                       number(r.high.y - r.low.y), hex(r.color));
  }

  void operator()(const PlotLine& line) {
    if (line.points.size() < 2) return;
    std::string path;
    for (size_t i = 0; i < line.points.size(); ++i) path += fmt::format("{}{} {}", i ? " " : "M", number(line.points[i].x), number(line.points[i].y));
    std::string dash;
    for (const float length : line.dash) dash += (dash.empty() ? "" : " ") + number(length);
    svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", path, hex(line.color), number(line.width),
                       dash.empty() ? "" : " stroke-dasharray=\"" + dash + "\"");
  }

  void operator()(const PlotText& text) {
    const char* anchor = text.align == TextAlign::Right ? " text-anchor=\"end\"" : text.align == TextAlign::Center ? " text-anchor=\"middle\"" : "";
    std::string words;
    float down = 0;   // where the baseline is now
    for (const PlotTextRun& run : textRuns(text.text)) {
      const float wanted = run.level < 0 ? kLowered * text.size : run.level > 0 ? kRaised * text.size : 0;
      std::string attributes;
      if (wanted != down) attributes += fmt::format(" dy=\"{}\"", number(wanted - down));
      if (run.level) attributes += fmt::format(" font-size=\"{}\"", number(text.size * kRunSize));
      down = wanted;
      words += attributes.empty() ? escapedMarkup(run.text) : fmt::format("<tspan{}>{}</tspan>", attributes, escapedMarkup(run.text));
    }
    svg += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}{} fill=\"{}\">{}</text>\n", number(text.at.x), number(text.at.y), number(text.size),
                       text.bold ? " font-weight=\"600\"" : "", anchor, hex(text.color), words);
  }

  void operator()(const PlotBitmap& bitmap) {
    const auto png = codec::encodePng(bitmap.pixels, {}, "plot");
    if (!png) return void(problems.insert(problems.end(), png.diagnostics().begin(), png.diagnostics().end()));
    svg += fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,{}\"/>\n",
                       number(bitmap.low.x), number(bitmap.low.y), number(bitmap.high.x - bitmap.low.x), number(bitmap.high.y - bitmap.low.y), base64(*png));
  }
};

}  // namespace

Result<std::string> plotSvg(const PlotDrawing& drawing, const ImageNotes& notes) {
  Writer writer;
  writer.svg = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">\n"
                           "<title>{2}</title>\n<desc>{3}</desc>\n<metadata>\n",
                           drawing.size.x, drawing.size.y, escapedMarkup(drawing.title), escapedMarkup(drawing.description));
  for (const auto& [key, value] : notes) writer.svg += fmt::format("{}: {}\n", escapedMarkup(key), escapedMarkup(value));
  writer.svg += fmt::format("</metadata>\n<rect width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", drawing.size.x, drawing.size.y, hex(drawing.ground));
  writer.svg += "<g font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\">\n<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  // Lines share their group's style, so texts stand in between in groups of their own.
  bool lines = true;
  for (const PlotItem& item : drawing.items) {
    if (const bool line = std::holds_alternative<PlotLine>(item); line != lines) {
      writer.svg += line ? "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n" : "</g>\n";
      lines = line;
    }
    std::visit(writer, item);
  }
  writer.svg += lines ? "</g>\n</g>\n</svg>\n" : "</g>\n</svg>\n";
  if (!writer.problems.empty()) return writer.problems;
  return std::move(writer.svg);
}

}  // namespace glint
