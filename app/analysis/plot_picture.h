// A plot as pixels.
#pragma once

#include "app/analysis/plot_drawing.h"

namespace glint {

Image8 plotPicture(const PlotDrawing&);

// Widths of texts in the faces that pictures are drawn with.
TextMeasure pictureTextMeasure();

}  // namespace glint
