// What a health card says, in words and as JSON: for the terminal, the editor, pages and reports.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "materials/model.h"
#include "renderer/model_health.h"
#include "renderer/renderer.h"

namespace glint {

// "ok" for green, so that a list of laws reads as a list of tests; else "amber" or "red".
std::string verdictWord(Verdict);

// A badge's sign, so that it can be told without its colour: a check mark, "!" or a cross (UTF-8).
std::string verdictGlyph(Verdict);

// The text in the verdict's colour when stdout is a terminal.
std::string inColor(Verdict, const std::string& text);

// What was found of a law: its reason when it is broken, else what its number means, "D integrates to 1.0000".
std::string finding(const LawResult&);

// The card in one line: "green", or "amber: gains energy: .. (roughness 0.2, NoV 0.005)".
std::string oneLine(const ModelHealth&);

// "reciprocal, conserves energy", or "nothing".
std::string claimsText(const ShadingModel&);

// Of a cell in the white furnace: "mean 0.842, worst -39 %".
std::string furnaceText(const Renderer::FurnaceShare&);

// Of a cell in the error view: "3.2 % off (noise 1.0 %), light -1.1 %".
std::string errorText(const ReferenceError&);
// "blue -25 % to orange +25 %"
std::string errorScaleText(float scale);

nlohmann::ordered_json healthJson(const ModelHealth&);

}  // namespace glint
