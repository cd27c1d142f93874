// Image files: .png and .jpg (8 bits), .hdr, .exr and .pfm (linear floats). Everything read is untrusted.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "materials/base/diagnostic.h"
#include "renderer/image.h"

namespace glint {

// No picture is read that has a side over this, or more pixels than that (1 GiB of RGBA bytes).
inline constexpr int kLargestImageSide = 32768;
inline constexpr uint64_t kMostImagePixels = uint64_t{1} << 28;
// Linear pictures are 12 bytes a pixel: 2^27 is a 16384 x 8192 environment.
inline constexpr uint64_t kMostImageFPixels = uint64_t{1} << 27;

// What a file's header says, before anything is decoded.
struct ImageSize {
  int width = 0, height = 0;
  uint64_t pixels() const { return uint64_t(width) * uint64_t(height); }
};
// Of a PNG or JPEG. Errors: neither; no readable header; larger than the caps.
Result<ImageSize> imageSize8(std::string_view bytes, const std::string& place);

// PNG or JPEG, told apart by content. 16-bit and palette PNGs become 8 bits; channels 1..4 as in the file
// (JPEG 1 or 3; CMYK is an error). `place` names the source in diagnostics.
Result<Image8> decodeImage8(std::string_view bytes, const std::string& place);
Result<Image8> readImage8(const std::filesystem::path&);

// Radiance .hdr, OpenEXR or .pfm, told apart by content, as RGB. Values stay as they are in the file (so
// negative, infinite and NaN may occur). Grey files are spread over the three channels; alpha is dropped.
Result<ImageF> decodeImageF(std::string_view bytes, const std::string& place);
Result<ImageF> readImageF(const std::filesystem::path&);
// The same for whoever needs no more than `mostWidth` pixels a row: a wider .hdr is averaged over squares of pixels as
// it is read, so that it is never held whole. Other formats are given as they are: their pixels may be NaN or negative,
// and want mending first. `inFile` is the size before.
Result<ImageF> readImageF(const std::filesystem::path&, int mostWidth, ImageSize& inFile);

// What a picture says of how it was made: command line, versions, GL renderer, content hashes. Keys are fixed words of
// the program's, at most 79 printable ASCII characters; whatever comes from files or the user is text, of any bytes (what
// is not UTF-8 is written to PNG as U+FFFD).
using ImageNotes = std::map<std::string, std::string>;

// .png only; 1, 3 or 4 channels; the notes as PNG text. Written whole or not at all.
Diagnostics writeImage8(const std::filesystem::path&, const Image8&, const ImageNotes& = {});
// .exr (half floats, notes as attributes), .hdr or .pfm by extension; 3 channels (4 for .exr).
Diagnostics writeImageF(const std::filesystem::path&, const ImageF&, const ImageNotes& = {});
// The notes of a PNG or EXR; empty when it has none.
Result<ImageNotes> readImageNotes(const std::filesystem::path&);

// The sRGB transfer functions (IEC 61966-2-1), on one value in 0..1.
float srgbFromLinear(float);
float linearFromSrgb(float);

}  // namespace glint
