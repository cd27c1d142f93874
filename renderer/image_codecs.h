// The formats behind image_io.h, one .cpp each. Decoders check every length against `bytes` before they use or
// allocate it; faults name the byte they were met at.
#pragma once

#include <string>
#include <string_view>

#include "renderer/image_io.h"

namespace glint::codec {

bool isPng(std::string_view bytes);
Result<ImageSize> pngSize(std::string_view bytes, const std::string& place);
Result<Image8> decodePng(std::string_view bytes, const std::string& place);
Result<ImageNotes> pngNotes(std::string_view bytes, const std::string& place);
Result<std::string> encodePng(const Image8&, const ImageNotes&, const std::string& place);

bool isJpeg(std::string_view bytes);
Result<ImageSize> jpegSize(std::string_view bytes, const std::string& place);
Result<Image8> decodeJpeg(std::string_view bytes, const std::string& place);

bool isHdr(std::string_view bytes);
// Wider ones than `mostWidth` are averaged over squares of pixels; those at the right and lower rim may be cut.
Result<ImageF> decodeHdr(std::string_view bytes, const std::string& place, int mostWidth = kLargestImageSide, ImageSize* inFile = nullptr);
std::string encodeHdr(const ImageF&, const ImageNotes&);

bool isPfm(std::string_view bytes);
Result<ImageF> decodePfm(std::string_view bytes, const std::string& place);
std::string encodePfm(const ImageF&);

bool isExr(std::string_view bytes);
Result<ImageF> decodeExr(std::string_view bytes, const std::string& place);
Result<ImageNotes> exrNotes(std::string_view bytes, const std::string& place);
Result<std::string> encodeExr(const ImageF&, const ImageNotes&, const std::string& place);

// The error for a picture over the caps of image_io.h; nothing when it is not.
Diagnostics checkImageSize(uint64_t width, uint64_t height, uint64_t mostPixels, const std::string& place);

}  // namespace glint::codec
