#include "app/figures.h"

#include <fmt/format.h>

namespace glint {
namespace {

std::vector<FigureStrip> roughnesses(std::initializer_list<double> values) {
  std::vector<FigureStrip> columns;
  for (const double value : values) columns.push_back({fmt::format("roughness {:g}", value), {{"set", fmt::format("roughness={:g}", value)}}});
  return columns;
}

// The falloff of eq. 9 with one constant, in a row of lamps that hang lower and lower over a floor.
std::vector<FigureOption> lamps(const std::string& falloff) {
  std::vector<FigureOption> options;
  int i = 0;
  for (const double height : {1.0, 0.5, 0.25, 0.12})
    options.push_back({"light", fmt::format("point:pos={:g}/{:g}/{:g},cd={:g},{}", -0.72 + 0.48 * i++, 0.0, height, 0.6 * height, falloff)});
  return options;
}

std::vector<FigureOption> lampsAnew(const std::string& falloff) {
  std::vector<FigureOption> options = lamps(falloff);
  options.insert(options.begin(), {"light", ""});
  return options;
}

const FigureStrip kMonteCarlo{"Reference", {}};

std::vector<Figure> made() {
  const std::vector<FigureOption> gold = {{"set", "metallic=1"}, {"set", "baseColor=1/0.77/0.34"}, {"env", "studio"}};
  const std::vector<FigureOption> dielectric = {{"set", "metallic=0"}, {"set", "baseColor=0/0/0"}, {"set", "specular=0.5"}, {"env", "studio"}};
  const auto steel = [](const std::string& light) {
    return std::vector<FigureOption>{{"set", "metallic=1"}, {"set", "baseColor=0.6/0.6/0.62"}, {"env", "none"}, {"light", light}};
  };
  const FigureStrip cosines{"Transformed cosines", {{"area-lights", "cosines"}}};
  const FigureStrip splitSum{"Split sum", {{"split-sum", "on"}}}, assumed{"Split sum, n\u00a0=\u00a0v\u00a0=\u00a0r", {}};
  return {
      {4, "environment-metal", "Environment light on a metal", "the split sum, and with n = v = r as all environments are drawn", gold,
       roughnesses({0.05, 0.2, 0.4, 0.6, 0.8, 1}), kMonteCarlo, {splitSum, assumed}},
      {5, "environment-dielectric", "Environment light on a dielectric", "the same where only the surface reflects", dielectric,
       roughnesses({0.05, 0.2, 0.4, 0.6, 0.8, 1}), kMonteCarlo, {splitSum, assumed}},
      {9, "falloff", "Inverse square falloff", "equation 9 against the light of four lamps over a floor without any window or constant",
       {{"env", "none"}, {"mesh", "plane"}, {"set", "metallic=0"}, {"set", "baseColor=0.5/0.5/0.5"}, {"set", "roughness=1"}, {"camera", "eye=0/0/3,target=0/0/0,ortho=2"}},
       {{"constant 1", lamps("radius=2,constant=1")}, {"constant 0.1", lamps("radius=2,constant=0.1")}, {"constant 0.01", lamps("radius=2,constant=0.01")},
        {"0, radius 10", lamps("radius=10,constant=0")}},
       {"1 / d\u00b2", lampsAnew("radius=1000000,constant=0")}, {{"Equation 9", {}}}},
      {10, "specular-d", "A sphere light by a wider distribution", "equation 10, which the notes found too rough where surfaces are smooth",
       steel("sphere:pos=1.2/1.2/2,cd=30,size=0.5"), roughnesses({0.1, 0.25, 0.4, 0.6, 0.8}), kMonteCarlo, {{"Specular D modification", {{"area-lights", "specular-d"}}}}},
      {12, "sphere-light", "A sphere light by its representative point", "equations 11 and 14 with the notes' factor, with the one that Unreal ships, and what Glint draws",
       steel("sphere:pos=1.2/1.2/2,cd=30,size=0.5"), roughnesses({0.1, 0.25, 0.4, 0.6, 0.8}), kMonteCarlo,
       {{"Representative point, factor 3", {{"area-lights", "notes"}}}, {"Representative point, factor 2", {{"area-lights", "unreal"}}}, cosines}},
      {13, "tube-light", "A tube light by its representative point", "equations 16, 19 and 20, and what Glint draws",
       steel("tube:from=-0.8/1.4/1.6,to=1.4/1.4/1.6,cd=30,size=0.06"), roughnesses({0.1, 0.25, 0.4, 0.6, 0.8}), kMonteCarlo,
       {{"Representative point, factor 3", {{"area-lights", "notes"}}}, cosines}},
  };
}

}  // namespace

std::span<const Figure> figures() {
  static const std::vector<Figure> all = made();
  return all;
}

}  // namespace glint
