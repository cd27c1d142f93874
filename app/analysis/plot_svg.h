// A plot as SVG: text stays text, curves stay curves.
#pragma once

#include <string>

#include "app/analysis/plot_drawing.h"
#include "renderer/image_io.h"

namespace glint {

// A whole file, with `title` and `desc` for screen readers, the notes (of what made it) in `metadata`, and no reference to
// anything outside it. Errors: a picture within that cannot be encoded.
Result<std::string> plotSvg(const PlotDrawing&, const ImageNotes&);

}  // namespace glint
