// Pictures that are read as environments. Files of all kinds are about: what can be used is mended and said so, the rest
// is refused.
#pragma once

#include <filesystem>

#include "materials/base/diagnostic.h"
#include "renderer/image_io.h"

namespace glint {

// Wider ones are averaged down: the cube that an environment is kept on has 1024 pixels a side, a quarter of 4096.
inline constexpr int kLargestEnvironmentWidth = 8192;
// No pixel is brighter, in nits: the sun has 2e9, and sums of a thousand times that stay finite.
inline constexpr float kBrightestPixel = 1e12f;

struct EnvironmentFile {
  ImageF pixels;         // 3 channels, 2:1, at most `mostWidth` wide, 0..kBrightestPixel
  ImageSize inFile;
  Diagnostics warnings;  // one for each kind of thing that was mended
};
// A .hdr, .exr or .pfm. NaN and negative pixels become black, infinite ones the brightest finite one (at least 65504,
// where half floats end), and what is brighter than kBrightestPixel that. One that is not 2:1 is stretched to it, as
// Blender and three.js do. Errors: unreadable, truncated, none of these formats, larger than image_io.h's caps.
Result<EnvironmentFile> readEnvironmentFile(const std::filesystem::path&, int mostWidth = kLargestEnvironmentWidth);

// A picture of another size: each pixel the mean of the area that it covers.
ImageF resized(const ImageF&, int width, int height);

}  // namespace glint
