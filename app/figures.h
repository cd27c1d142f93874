// The figures of Karis' notes (Real Shading in Unreal Engine 4, 2013) that show an approximation, as scenes that are
// drawn again beside what they approximate.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace glint {

// An option of `glint render`, as a user would write it. An empty value takes back what was said of it before.
struct FigureOption {
  const char* name;
  std::string value;
};
struct FigureStrip {
  std::string title;
  std::vector<FigureOption> options;
};

struct Figure {
  int number;
  const char* name;                      // of its file: "environment-metal"
  const char* title;
  const char* doc;                       // what it shows
  std::vector<FigureOption> scene;
  std::vector<FigureStrip> columns;
  FigureStrip truth;                     // the first row
  std::vector<FigureStrip> approximations;   // the others, each with its error
};

// But for figure 3, which is a table and no scene: see app/commands/figures.cpp.
std::span<const Figure> figures();

}  // namespace glint
