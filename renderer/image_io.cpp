#include "renderer/image_io.h"

#include <cmath>

#include "materials/base/files.h"
#include "renderer/image_codecs.h"

namespace glint {
namespace fs = std::filesystem;

namespace {

std::string extensionOf(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

// Names what a file is when it is not what was asked for.
Diagnostic notRead(std::string_view bytes, const std::string& place, bool wantsFloats) {
  const char* kind = codec::isPng(bytes)    ? "a PNG"
                     : codec::isJpeg(bytes) ? "a JPEG"
                     : codec::isHdr(bytes)  ? "a Radiance .hdr"
                     : codec::isExr(bytes)  ? "an OpenEXR"
                     : codec::isPfm(bytes)  ? "a .pfm"
                                            : nullptr;
  const char* wanted = wantsFloats ? "a .hdr, .exr or .pfm" : "a .png or .jpg";
  if (kind) return error(place, fmt::format("is {}, not {}", kind, wanted), fmt::format("name {} file", wanted));
  if (bytes.empty()) return error(place, "is empty", fmt::format("name {} file", wanted));
  return error(place, fmt::format("is not {} (its first bytes are those of no picture that is read)", wanted),
               fmt::format("name {} file", wanted));
}

}  // namespace

Diagnostics codec::checkImageSize(uint64_t width, uint64_t height, uint64_t mostPixels, const std::string& place) {
  if (width == 0 || height == 0)
    return {error(place, fmt::format("is {} x {} pixels", width, height), "a picture has at least one pixel")};
  if (width > uint64_t(kLargestImageSide) || height > uint64_t(kLargestImageSide) || width * height > mostPixels)
    return {error(place, fmt::format("is {} x {} pixels", width, height),
                  fmt::format("at most {} a side and {} in all are read", kLargestImageSide, mostPixels))};
  return {};
}

Result<ImageSize> imageSize8(std::string_view bytes, const std::string& place) {
  if (codec::isPng(bytes)) return codec::pngSize(bytes, place);
  if (codec::isJpeg(bytes)) return codec::jpegSize(bytes, place);
  return notRead(bytes, place, false);
}

Result<Image8> decodeImage8(std::string_view bytes, const std::string& place) {
  if (codec::isPng(bytes)) return codec::decodePng(bytes, place);
  if (codec::isJpeg(bytes)) return codec::decodeJpeg(bytes, place);
  return notRead(bytes, place, false);
}

Result<ImageF> decodeImageF(std::string_view bytes, const std::string& place) {
  if (codec::isHdr(bytes)) return codec::decodeHdr(bytes, place);
  if (codec::isExr(bytes)) return codec::decodeExr(bytes, place);
  if (codec::isPfm(bytes)) return codec::decodePfm(bytes, place);
  return notRead(bytes, place, true);
}

Result<Image8> readImage8(const fs::path& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.diagnostics();
  return decodeImage8(*bytes, path.string());
}

Result<ImageF> readImageF(const fs::path& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.diagnostics();
  return decodeImageF(*bytes, path.string());
}

Result<ImageF> readImageF(const fs::path& path, int mostWidth, ImageSize& inFile) {
  GLINT_CHECK(mostWidth > 0, "{}", mostWidth);
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.diagnostics();
  if (codec::isHdr(*bytes)) return codec::decodeHdr(*bytes, path.string(), mostWidth, &inFile);
  Result<ImageF> image = decodeImageF(*bytes, path.string());
  if (image) inFile = {image->width, image->height};
  return image;
}

Result<ImageNotes> readImageNotes(const fs::path& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.diagnostics();
  if (codec::isPng(*bytes)) return codec::pngNotes(*bytes, path.string());
  if (codec::isExr(*bytes)) return codec::exrNotes(*bytes, path.string());
  return ImageNotes{};
}

Diagnostics writeImage8(const fs::path& path, const Image8& image, const ImageNotes& notes) {
  GLINT_CHECK(!image.empty() && image.channels != 2, "{} x {} x {}", image.width, image.height, image.channels);
  if (extensionOf(path) != ".png")
    return {error(path.string(), fmt::format("'{}' is not written from a display-referred picture", extensionOf(path)),
                  "name a .png file")};
  const Result<std::string> bytes = codec::encodePng(image, notes, path.string());
  if (!bytes) return bytes.diagnostics();
  return writeFileAtomic(path, *bytes);
}

Diagnostics writeImageF(const fs::path& path, const ImageF& image, const ImageNotes& notes) {
  const std::string extension = extensionOf(path);
  GLINT_CHECK(!image.empty() && (image.channels == 3 || (image.channels == 4 && extension == ".exr")),
              "{} x {} x {} as {}", image.width, image.height, image.channels, extension);
  if (extension == ".hdr") return writeFileAtomic(path, codec::encodeHdr(image, notes));
  if (extension == ".pfm") return writeFileAtomic(path, codec::encodePfm(image));
  if (extension != ".exr")
    return {error(path.string(), fmt::format("'{}' is not written from a linear picture", extension),
                  "name a .exr, .hdr or .pfm file")};
  const Result<std::string> bytes = codec::encodeExr(image, notes, path.string());
  if (!bytes) return bytes.diagnostics();
  return writeFileAtomic(path, *bytes);
}

float srgbFromLinear(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

float linearFromSrgb(float x) {
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

}  // namespace glint
