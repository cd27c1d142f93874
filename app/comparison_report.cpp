#include "app/comparison_report.h"

#include "app/health_text.h"
#include "app/markup.h"
#include "renderer/image_codecs.h"

namespace glint {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: dark; }
body { background: #1b1c1f; color: #ecedf0; font: 15px/1.5 Inter, system-ui, sans-serif; margin: 40px; }
h1 { font-size: 22px; font-weight: 600; } h2 { font-size: 16px; font-weight: 600; margin-top: 40px; }
.grid { display: grid; gap: 10px; align-items: center; width: max-content; }
.grid .column { text-align: center; font-weight: 600; } .grid .row { text-align: right; font-weight: 600; padding-right: 14px; }
.grid small, .axis, figcaption, dt { color: #9699a1; font-weight: 400; }
figure { margin: 0; position: relative; } img { display: block; border-radius: 2px; }
figure img + img { position: absolute; top: 0; opacity: 0; } figure:hover img + img { opacity: 1; }
figcaption { text-align: center; font-size: 13px; }
table { border-collapse: collapse; } td, th { padding: 3px 18px 3px 0; text-align: left; font-variant-numeric: tabular-nums; }
th { color: #9699a1; font-weight: 400; } dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 18px; } dd { margin: 0; overflow-wrap: anywhere; }
.badge { display: inline-block; width: 1.35em; height: 1.35em; border-radius: 50%; text-align: center; font: 700 12px/1.35em Inter, sans-serif; color: #16171a; margin-right: 8px; }
.green { background: #7eb668; } .amber { background: #e2b852; } .red { background: #e85c50; }
.plots { display: flex; flex-wrap: wrap; gap: 18px; }
details { margin: 6px 0; } summary { cursor: pointer; } details table { margin: 6px 0 14px 28px; font-size: 14px; } .where { color: #9699a1; }
)";

std::string badgeOf(Verdict verdict) {
  return fmt::format("<span class=\"badge {0}\" title=\"{0}\">{1}</span>", name(verdict), verdictGlyph(verdict));
}

std::string cardOf(const ModelHealth& card) {
  const std::string reason = card.reason();
  std::string html = fmt::format("<details><summary>{}<b>{}</b> {}</summary>\n<table>\n", badgeOf(card.verdict()), escapedMarkup(card.model),
                                 escapedMarkup(reason.empty() ? "keeps every law" : reason));
  for (const LawResult& law : card.laws)
    html += fmt::format("<tr><td>{}{}</td><td>{}{}</td><td class=\"where\">{}</td></tr>\n", badgeOf(law.verdict), name(law.law), escapedMarkup(finding(law)),
                        law.claimed && law.reason.empty() ? ", as it claims" : "", escapedMarkup(law.where));
  return html + "</table></details>\n";
}

}  // namespace

Result<std::string> comparisonReport(const std::string& title, std::span<const SheetRow> rows, const SheetText& text,
                                     const std::string& against, std::span<const ReportNumbers> numbers,
                                     std::span<const ModelHealth> health, std::span<const std::string> plots,
                                     const std::map<std::string, std::string>& notes) {
  Diagnostics problems;
  const auto image = [&](const Image8& pixels) -> std::string {
    const auto png = codec::encodePng(pixels, {}, "--report");
    if (!png) {
      problems.insert(problems.end(), png.diagnostics().begin(), png.diagnostics().end());
      return "";
    }
    return fmt::format("<img width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">", pixels.width, pixels.height, base64(*png));
  };
  std::string html = fmt::format("<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title>\n<style>{1}</style>\n<h1>{0}</h1>\n",
                                 escapedMarkup(title), kStyle);
  if (!text.axis.empty()) html += fmt::format("<p class=\"axis\">{}</p>\n", escapedMarkup(text.axis));
  html += fmt::format("<div class=\"grid\" style=\"grid-template-columns: auto repeat({}, max-content)\">\n<div></div>\n", text.columns.size());
  for (const std::string& column : text.columns) html += fmt::format("<div class=\"column\">{}</div>\n", escapedMarkup(column));
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].heat) continue;
    const SheetRow* heat = i + 1 < rows.size() && rows[i + 1].heat ? &rows[i + 1] : nullptr;
    html += fmt::format("<div class=\"row\">{}<br><small>{}</small></div>\n", escapedMarkup(rows[i].title), escapedMarkup(rows[i].subtitle));
    for (size_t column = 0; column < rows[i].cells.size(); ++column) {
      html += "<figure>" + image(rows[i].cells[column]);
      if (heat && !heat->cells[column].empty()) html += image(heat->cells[column]);
      if (column < rows[i].captions.size()) html += fmt::format("<figcaption>{}</figcaption>", escapedMarkup(rows[i].captions[column]));
      if (heat && column < heat->captions.size()) html += fmt::format("<figcaption>{}</figcaption>", escapedMarkup(heat->captions[column]));
      html += "</figure>\n";
    }
  }
  html += "</div>\n";
  if (!numbers.empty()) {
    html += fmt::format("<h2>Difference to {}</h2>\n<p class=\"axis\">Point at a cell to see where it differs.</p>\n<table><tr><th>row</th><th>column</th>"
                        "<th>FLIP</th><th>RMSE</th><th>largest</th></tr>\n", escapedMarkup(against));
    for (const ReportNumbers& n : numbers)
      html += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.4f}</td><td>{:.4f}</td><td>{:.4f}</td></tr>\n", escapedMarkup(n.row), escapedMarkup(n.column), n.flip, n.rmse, n.largest);
    html += "</table>\n";
  }
  if (!health.empty()) html += "<h2>Health of the models</h2>\n<p class=\"axis\">What physics asks of a model, measured on its own GLSL. Click for the whole card.</p>\n";
  for (const ModelHealth& card : health) html += cardOf(card);
  if (!plots.empty()) {
    html += "<h2>What the models are made of</h2>\n<div class=\"plots\">\n";
    for (const std::string& plot : plots) html += plot;
    html += "</div>\n";
  }
  html += "<h2>Made by</h2>\n<dl>\n";
  for (const auto& [key, value] : notes) html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escapedMarkup(key), escapedMarkup(value));
  html += "</dl>\n</html>\n";
  if (!problems.empty()) return problems;
  return html;
}

}  // namespace glint
