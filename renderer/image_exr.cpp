// OpenEXR, through the OpenEXR library.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfVersion.h>
#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "renderer/image_codecs.h"

namespace glint::codec {
namespace {

// Our notes are string attributes with this in front of the key, so that none can be taken for one of the
// format's own attributes.
constexpr std::string_view kNotePrefix = "glint.";

class MemoryReader : public Imf::IStream {
 public:
  explicit MemoryReader(std::string_view bytes) : IStream("memory"), bytes_(bytes) {}
  bool read(char out[], int count) override {
    if (count < 0 || uint64_t(count) > bytes_.size() - position_)
      throw std::runtime_error(fmt::format("the data ends at byte {}", bytes_.size()));
    std::memcpy(out, bytes_.data() + position_, size_t(count));
    position_ += uint64_t(count);
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override {
    if (position > bytes_.size())
      throw std::runtime_error(fmt::format("the data ends at byte {}", bytes_.size()));
    position_ = position;
  }
  void clear() override {}

 private:
  std::string_view bytes_;
  uint64_t position_ = 0;
};

class MemoryWriter : public Imf::OStream {
 public:
  MemoryWriter() : OStream("memory") {}
  void write(const char data[], int count) override {
    const size_t end = position_ + size_t(count);
    if (end > bytes.size()) bytes.resize(end);
    std::memcpy(bytes.data() + position_, data, size_t(count));
    position_ = end;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = size_t(position); }

  std::string bytes;

 private:
  size_t position_ = 0;
};

Diagnostic fault(const std::string& place, const std::exception& thrown) {
  std::string what = thrown.what();
  // The library's messages are sentences that name our stream: "Cannot read image file "memory". ..."
  for (const std::string_view noise : {"Cannot read image file \"memory\". ", "Cannot open image file \"memory\". ",
                                       "Error reading pixel data from image file \"memory\". "})
    if (const size_t at = what.find(noise); at != std::string::npos) what.erase(at, noise.size());
  while (what.ends_with('.') || what.ends_with('\n')) what.pop_back();
  return error(place, "is a truncated or corrupt .exr: " + what, "copy or export the file again");
}

}  // namespace

bool isExr(std::string_view bytes) { return bytes.starts_with("\x76\x2f\x31\x01"); }

Result<ImageF> decodeExr(std::string_view bytes, const std::string& place) try {
  MemoryReader stream(bytes);
  Imf::InputFile file(stream, 0);
  const Imf::Header& header = file.header();
  const Imath::Box2i window = header.dataWindow();
  const int64_t width = int64_t(window.max.x) - window.min.x + 1, height = int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1) return error(place, "is a corrupt .exr: its data window is empty", "export it again");
  Diagnostics tooLarge = checkImageSize(uint64_t(width), uint64_t(height), kMostImageFPixels, place);
  if (!tooLarge.empty()) return tooLarge;

  const Imf::ChannelList& channels = header.channels();
  std::string names[3] = {"R", "G", "B"};
  const bool grey = !channels.findChannel("R") && channels.findChannel("Y");
  if (grey) names[0] = names[1] = names[2] = "Y";
  std::string found;
  for (auto i = channels.begin(); i != channels.end(); ++i) found += fmt::format("{}{}", found.empty() ? "" : ", ", i.name());
  for (const std::string& name : names) {
    const Imf::Channel* channel = channels.findChannel(name);
    if (!channel)
      return error(place, fmt::format("has no channel '{}', only: {}", name, found.substr(0, 200)),
                   "export it with the channels R, G and B");
    if (channel->xSampling != 1 || channel->ySampling != 1)
      return error(place, fmt::format("channel '{}' is subsampled", name), "export it as RGB");
  }
  if (!file.isComplete())
    return error(place, fmt::format("is a truncated .exr: scanlines are missing from its {} bytes", bytes.size()),
                 "copy or export the file again");

  ImageF image(int(width), int(height), 3);
  Imf::FrameBuffer target;
  const size_t pixel = 3 * sizeof(float), row = pixel * size_t(width);
  for (size_t c = 0; c < (grey ? 1u : 3u); ++c) {
    // The library addresses pixels from (0, 0) of its coordinates, wherever the window is.
    char* base = reinterpret_cast<char*>(image.data.data() + c) - ptrdiff_t(window.min.x) * ptrdiff_t(pixel) -
                 ptrdiff_t(window.min.y) * ptrdiff_t(row);
    target.insert(names[c], Imf::Slice(Imf::FLOAT, base, pixel, row));
  }
  file.setFrameBuffer(target);
  file.readPixels(window.min.y, window.max.y);
  if (grey)
    for (size_t i = 0; i < image.data.size(); i += 3) image.data[i + 1] = image.data[i + 2] = image.data[i];
  return image;
} catch (const std::exception& thrown) {
  return fault(place, thrown);
}

Result<ImageNotes> exrNotes(std::string_view bytes, const std::string& place) try {
  MemoryReader stream(bytes);
  Imf::InputFile file(stream, 0);
  ImageNotes notes;
  for (auto i = file.header().begin(); i != file.header().end(); ++i)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute())) {
      const std::string_view name = i.name();
      notes[std::string(name.starts_with(kNotePrefix) ? name.substr(kNotePrefix.size()) : name)] = text->value();
    }
  return notes;
} catch (const std::exception& thrown) {
  return fault(place, thrown);
}

Result<std::string> encodeExr(const ImageF& image, const ImageNotes& notes, const std::string& place) try {
  constexpr const char* kNames[] = {"R", "G", "B", "A"};
  // Halves end at 65504; brighter pixels are kept at that rather than made infinite.
  constexpr float kLargestHalf = 65504.0f;
  std::vector<Imath::half> halves(image.data.size());
  for (size_t i = 0; i < halves.size(); ++i) {
    const float v = image.data[i];
    halves[i] = std::isnan(v) ? v : std::clamp(v, -kLargestHalf, kLargestHalf);
  }
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, text] : notes) header.insert(std::string(kNotePrefix) + key, Imf::StringAttribute(text));
  Imf::FrameBuffer source;
  const size_t pixel = size_t(image.channels) * sizeof(Imath::half);
  for (size_t c = 0; c < size_t(image.channels); ++c) {
    header.channels().insert(kNames[c], Imf::Channel(Imf::HALF));
    source.insert(kNames[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data() + c), pixel,
                                        pixel * size_t(image.width)));
  }
  MemoryWriter stream;
  {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(source);
    file.writePixels(image.height);
  }
  return std::move(stream.bytes);
} catch (const std::exception& thrown) {
  return error(place, fmt::format("cannot be written as .exr: {}", thrown.what()));
}

}  // namespace glint::codec
