#include "app/health_text.h"

#include <fmt/color.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/sampler_error.h"

namespace glint {
namespace {

// What a law's number means, in words.
std::string measured(const LawResult& law) {
  switch (law.law) {
    case Law::Compiles: return "compiles";
    case Law::Finite: return "finite everywhere it was asked";
    case Law::NonNegative: return "nowhere negative";
    case Law::Reciprocity: return fmt::format("swapping light and view changes f by at most {:.2g} %", 100 * law.value);
    case Law::Normalisation: return fmt::format("D integrates to {:.4f}", law.value);
    case Law::Energy: return fmt::format("reflects at most {:.4f} of what it receives", law.value);
    case Law::Furnace: return fmt::format("white, it keeps at least {:.4f} of uniform light", law.value);
    case Law::MirrorLimit: return fmt::format("a smooth white mirror reflects {:.4f}", law.value);
    case Law::Environment: return fmt::format("split sum is {:.1f} % off (RMS)", 100 * law.value);
    case Law::AreaLights: return fmt::format("cosine lobe is {:.1f} % off under soft lights", 100 * law.value);
    case Law::Sampler: return fmt::format("{} samples give the albedo to {:.2g} %", SamplerError::kSamples, 100 * law.value);
  }
  return {};
}

}  // namespace

std::string verdictWord(Verdict verdict) { return verdict == Verdict::Green ? "ok" : std::string(name(verdict)); }

std::string inColor(Verdict verdict, const std::string& text) {
  if (!isatty(STDOUT_FILENO)) return text;
  const fmt::terminal_color color = verdict == Verdict::Green ? fmt::terminal_color::green
                                    : verdict == Verdict::Amber ? fmt::terminal_color::yellow
                                                                : fmt::terminal_color::red;
  return fmt::format(fmt::fg(color), "{}", text);
}

std::string verdictGlyph(Verdict verdict) {
  return verdict == Verdict::Green ? "\u2713" : verdict == Verdict::Amber ? "!" : "\u00d7";
}

std::string furnaceText(const Renderer::FurnaceShare& share) {
  if (share.pixels == 0) return "nothing to see";
  const double percent = 100 * (share.extreme() - 1);
  const double size = std::abs(percent);
  // Spaces that do not break: in a narrow cell the line ends at the comma.
  return fmt::format("mean\u00a0{:.3f}, worst\u00a0{}{:.{}f}\u00a0%", share.mean, size < 0.05 ? "" : percent < 0 ? "\u2212" : "+", size, size < 10 ? 1 : 0);
}

namespace {

// "3.2", "0.1", "41": smaller ones are noise.
std::string percentText(double share) {
  const double percent = 100 * std::abs(share);
  return fmt::format("{:.{}f}", percent, percent < 9.95 ? 1 : 0);
}

}  // namespace

std::string errorText(const ReferenceError& error) {
  if (error.pixels == 0) return "nothing to see";
  // The noise is told where it matters.
  const std::string noise = error.noise > 0.25 * error.mean ? fmt::format("\u00a0(noise\u00a0{}\u00a0%)", percentText(error.noise)) : "";
  return fmt::format("{}\u00a0%\u00a0off{}, light\u00a0{}{}\u00a0%", percentText(error.mean), noise, error.light < 0 ? "\u2212" : "+", percentText(error.light));
}

std::string errorScaleText(float scale) {
  return fmt::format("blue \u2212{0}\u00a0% to orange +{0}\u00a0%", std::lround(100 * scale));
}

std::string finding(const LawResult& law) { return law.reason.empty() ? measured(law) : law.reason; }

std::string oneLine(const ModelHealth& card) {
  const std::string reason = card.reason();
  return std::string(name(card.verdict())) + (reason.empty() ? "" : ": " + reason);
}

std::string claimsText(const ShadingModel& model) {
  std::string text;
  if (model.claims.reciprocal) text += "reciprocal";
  if (model.claims.energyConserving) text += std::string(text.empty() ? "" : ", ") + "conserves energy";
  return text.empty() ? "nothing" : text;
}

nlohmann::ordered_json healthJson(const ModelHealth& card) {
  using nlohmann::ordered_json;
  ordered_json laws = ordered_json::array();
  for (const LawResult& law : card.laws) {
    ordered_json entry{{"law", name(law.law)}, {"verdict", name(law.verdict)}, {"claimed", law.claimed}};
    if (std::isfinite(law.value)) entry["value"] = law.value;
    if (!law.where.empty()) entry["where"] = law.where;
    if (!law.reason.empty()) entry["reason"] = law.reason;
    if (!law.hint.empty()) entry["hint"] = law.hint;
    laws.push_back(std::move(entry));
  }
  return {{"model", card.model},
          {"file", card.file},
          {"verdict", name(card.verdict())},
          {"reason", card.reason()},
          {"seconds", card.seconds},
          {"laws", laws}};
}

}  // namespace glint
