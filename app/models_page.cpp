#include "app/models_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/comparison_sheet.h"
#include "app/health_text.h"
#include "materials/base/log.h"
#include "renderer/comparison.h"
#include "renderer/environment.h"

namespace glint {
namespace {

constexpr int kCell = 60;
constexpr float kMetalRoughness[] = {0.1f, 0.3f, 0.5f, 0.7f, 0.9f};
constexpr float kPlasticRoughness[] = {0.5f};

std::vector<ComparisonColumn> columns() {
  const auto material = std::make_shared<Material>(newMaterial("page"));
  std::vector<ComparisonColumn> all;
  for (const float r : kMetalRoughness)
    all.push_back({fmt::format("{:.1f}", r), material, {{"metallic", "1"}, {"baseColor", "0.9/0.9/0.9"}, {"roughness", fmt::format("{}", r)}}});
  for (const float r : kPlasticRoughness)
    all.push_back({fmt::format("plastic {:.1f}", r), material, {{"metallic", "0"}, {"baseColor", "0.05/0.18/0.4"}, {"roughness", fmt::format("{}", r)}}});
  return all;
}

// Marks that a page shows in colour and a terminal as what they are.
std::string mark(Verdict verdict) {
  return verdict == Verdict::Green ? "\u2705" : verdict == Verdict::Amber ? "\u26a0\ufe0f" : "\u274c";
}

// Text in which nothing means anything to Markdown, in one line.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += ' ';
      continue;
    }
    if (std::string_view("\\`*_[]<>|").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

// That every value is finite and none negative goes without saying.
bool worthARow(const LawResult& law) {
  const bool taken = law.law == Law::Compiles || law.law == Law::Finite || law.law == Law::NonNegative;
  return !taken || law.verdict != Verdict::Green;
}

std::string section(const ShadingModel& model, const ModelHealth& card) {
  std::string text = fmt::format("## {}\n\n`{}` {} **{}**", plain(model.title), model.id, mark(card.verdict()), name(card.verdict()));
  if (const std::string reason = card.reason(); !reason.empty()) text += ": " + plain(reason);
  text += fmt::format("\n\n{}\n\n![{} on a row of roughness](pictures/{}.png)\n\n", plain(model.doc), plain(model.title), model.id);
  text += "| | law | measured | where |\n| --- | --- | --- | --- |\n";
  for (const LawResult& law : card.laws)
    if (worthARow(law))
      text += fmt::format("| {} | {} | {}{} | {} |\n", mark(law.verdict), name(law.law), plain(finding(law)),
                          law.claimed && law.reason.empty() ? ", as it claims" : "", plain(law.where));
  text += "\nClaims: " + claimsText(model) + ".";
  for (const ModelParameter& p : model.parameters)
    text += fmt::format("\nParameter `{}`, {} ({} to {}): {}.", p.name, plain(valueText(p.standard)), p.minimum, p.maximum, plain(p.doc));
  text += "\n";
  if (!model.cite.empty()) text += "\n";
  for (const std::string& cite : model.cite) text += "- " + plain(cite) + "\n";
  return text + "\n";
}

// Of one that cannot be drawn: what is wrong, all of it.
std::string section(const ModelHealth& card) {
  std::string text = fmt::format("## {}\n\n{} **{}**: cannot be used\n\n", plain(card.model), mark(card.verdict()), name(card.verdict()));
  for (const LawResult& law : card.laws)
    text += fmt::format("- {}: {}{}\n", plain(law.where), plain(law.reason), law.hint.empty() ? "" : "; " + plain(law.hint));
  return text + "\n";
}

}  // namespace

Result<ModelsPage> modelsPage(Renderer& renderer, Libraries& libraries, const std::vector<ModelPtr>& models,
                              const std::map<std::string, ModelHealth>& cards,
                              const std::vector<ModelHealth>& unusable, const std::string& command) {
  const auto studio = loadEnvironment("studio");
  if (!studio) return studio.diagnostics();
  Scene stage;
  stage.environment = *studio;
  std::vector<ComparisonRow> rows;
  for (const ModelPtr& model : models) rows.push_back({model->title, model, {}});
  Diagnostics warnings;
  const auto comparison = makeComparison(stage, rows, columns(), "page", libraries.sources(), warnings);
  if (!comparison) return comparison.diagnostics();
  RenderSettings settings;
  settings.samples = 8;
  settings.background = Background::Color;
  settings.backgroundColor = glm::vec3(0.0176f);
  const CellGrid grid{1, comparison->columns(), kCell, 4, 4};
  SheetText labels{.axis = "roughness", .columns = comparison->columnTitles, .footer = {}};

  ModelsPage page;
  page.text = fmt::format(
      "# The shading models\n\n"
      "Each on a row of roughness, in the studio: a white metal from 0.1 to 0.9, and a blue plastic. Beside it what\n"
      "Glint measured of the model's own GLSL against the laws that physics sets it. {} keeps every law that was\n"
      "checked, {} breaks one that it does not claim to keep, {} breaks what it claims, or what no model may break.\n\n"
      "`{}` writes this page.\n\n| | model | id | why |\n| --- | --- | --- | --- |\n",
      mark(Verdict::Green), mark(Verdict::Amber), mark(Verdict::Red), command);
  std::string sections;
  for (size_t i = 0; i < models.size(); ++i) {
    const ShadingModel& model = *models[i];
    const ModelHealth& card = cards.at(model.id);
    page.text += fmt::format("| {} | {} | `{}` | {} |\n", mark(card.verdict()), plain(model.title), model.id, plain(card.reason()));
    sections += section(model, card);
    std::vector<View> views;
    SheetRow row;
    for (int column = 0; column < comparison->columns(); ++column)
      views.push_back({&comparison->scene(int(i), column), comparison->camera, grid.rectangle(0, column)});
    const Image8 picture = renderer.picture(views, grid.size(), settings);
    if (hasErrors(renderer.problems())) return renderer.problems();
    for (const View& view : views) row.cells.push_back(cutCell(picture, view.rectangle));
    page.pictures.emplace(model.id, comparisonSheet(std::span(&row, 1), labels));
    log::progress("drawing " + model.id, double(i + 1) / double(models.size()));
  }
  for (const ModelHealth& card : unusable) {
    page.text += fmt::format("| {} | {} | | {} |\n", mark(card.verdict()), plain(card.model), plain(card.reason()));
    sections += section(card);
  }
  page.text += "\n" + sections;
  page.text.pop_back();
  return page;
}

}  // namespace glint
