// Portable float map: "PF" (RGB) or "Pf" (grey), width, height and scale as text, then floats from the bottom row
// up; a negative scale means little-endian.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "renderer/image_codecs.h"

namespace glint::codec {
namespace {

float loadFloat(const char* p, bool swap) {
  uint32_t bits;
  std::memcpy(&bits, p, 4);
  if (swap) bits = __builtin_bswap32(bits);
  return std::bit_cast<float>(bits);
}

}  // namespace

bool isPfm(std::string_view bytes) {
  return bytes.size() >= 3 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f') &&
         (bytes[2] == '\n' || bytes[2] == ' ' || bytes[2] == '\r');
}

Result<ImageF> decodePfm(std::string_view bytes, const std::string& place) {
  const int channels = bytes[1] == 'F' ? 3 : 1;
  size_t at = 2;
  const auto number = [&](auto& out) {
    while (at < bytes.size() && (bytes[at] == ' ' || bytes[at] == '\n' || bytes[at] == '\r' || bytes[at] == '\t')) ++at;
    const auto read = std::from_chars(bytes.data() + at, bytes.data() + bytes.size(), out);
    if (read.ec != std::errc()) return false;
    at = size_t(read.ptr - bytes.data());
    return true;
  };
  uint64_t width = 0, height = 0;
  float scale = 0;
  if (!number(width) || !number(height) || !number(scale) || scale == 0 || !std::isfinite(scale))
    return error(place, fmt::format("is a corrupt .pfm: byte {}: width, height or scale is not a number", at),
                 "copy or export the file again");
  if (bytes.substr(at).starts_with("\r\n")) ++at;
  ++at;  // one white space ends the header
  Diagnostics tooLarge = checkImageSize(width, height, kMostImageFPixels, place);
  if (!tooLarge.empty()) return tooLarge;
  const uint64_t needed = width * height * uint64_t(channels) * 4;
  if (at > bytes.size() || bytes.size() - at < needed)
    return error(place,
                 fmt::format("is a truncated .pfm: it ends at byte {}, {} x {} pixels need {}", bytes.size(),
                             width, height, at + needed),
                 "copy or export the file again");
  const bool swap = (scale < 0) != (std::endian::native == std::endian::little);
  ImageF image(int(width), int(height), 3);
  const char* p = bytes.data() + at;
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x, p += 4 * channels)
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = loadFloat(p + (channels == 3 ? 4 * c : 0), swap);
  return image;
}

std::string encodePfm(const ImageF& image) {
  std::string out = fmt::format("PF\n{} {}\n{}\n", image.width, image.height,
                                std::endian::native == std::endian::little ? "-1.0" : "1.0");
  for (int y = image.height - 1; y >= 0; --y)
    out.append(reinterpret_cast<const char*>(image.at(0, y)), size_t(image.width) * 12);
  return out;
}

}  // namespace glint::codec
