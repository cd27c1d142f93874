// OpenEXR, through the OpenEXR library.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
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
#include <optional>
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

// Times that a compression can shrink half or float pixels at the very most. A header that promises more than that
// is a fault that must not cost its memory.
uint64_t mostCompression(int compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION: return 1;
    case Imf::RLE_COMPRESSION: return 128;
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION: return 16;
    case Imf::PIZ_COMPRESSION: return 4096;
    case Imf::DWAA_COMPRESSION:
    case Imf::DWAB_COMPRESSION: return 65536;
    default: return 2 * 1032;  // deflate's limit, and PXR24's halving before it
  }
}

// Goes over the headers before the library does, which sizes its tables by them first and reads the file after.
// "OpenEXR File Layout": magic, version, then for each part attributes (name, type, size, value) up to an empty
// name; a file of several parts ends with an empty header.
class HeaderCheck {
 public:
  HeaderCheck(std::string_view bytes, const std::string& place) : bytes_(bytes), place_(place) {}

  Diagnostics run() {
    at_ = 4;
    const auto version = number(4);
    if (!version) return truncated();
    const bool severalParts = (*version & 0x1000) != 0;
    for (bool first = true;; first = false) {
      uint64_t width = 0, height = 0, bytesPerPixel = 0;
      int compression = 0;
      bool any = false;
      for (;;) {
        const auto attribute = word();
        if (!attribute) return truncated();
        if (attribute->empty()) break;
        any = true;
        const auto type = word();
        const auto size = type ? number(4) : std::nullopt;
        if (!size || *size > bytes_.size() - at_) return truncated();
        const size_t value = at_, end = at_ + *size;
        if (*attribute == "dataWindow" && *size == 16) {
          int64_t box[4];
          for (int64_t& side : box) side = int32_t(*number(4));
          width = uint64_t(std::max<int64_t>(box[2] - box[0] + 1, 0));
          height = uint64_t(std::max<int64_t>(box[3] - box[1] + 1, 0));
          Diagnostics bad = codec::checkImageSize(width, height, kMostImageFPixels, place_);
          if (!bad.empty()) return bad;
        } else if (*attribute == "compression" && *size == 1) {
          compression = int(*number(1));
        } else if (*attribute == "tiles" && *size == 9) {
          const uint64_t x = *number(4), y = *number(4);
          Diagnostics bad = codec::checkImageSize(x, y, kMostImageFPixels, place_);
          if (!bad.empty()) return bad;
        } else if (*attribute == "channels") {
          while (at_ < end && bytes_[at_] != 0) {
            const auto channel = word();
            const auto kind = channel ? number(4) : std::nullopt;
            if (!kind || !number(4) || !number(4) || !number(4)) return truncated();
            bytesPerPixel += *kind == Imf::HALF ? 2 : 4;
          }
        }
        at_ = std::max(value, end);
      }
      if (!any && !first) return {};
      // Subsampled channels are smaller, which is why this is generous: by four.
      if (width * height * bytesPerPixel / 4 / mostCompression(compression) > bytes_.size())
        return {error(place_, fmt::format("is a truncated .exr: {} bytes cannot hold {} x {} pixels", bytes_.size(), width, height),
                      "copy or export the file again")};
      if (!severalParts) return {};
    }
  }

 private:
  Diagnostics truncated() const {
    return {error(place_, fmt::format("is a truncated or corrupt .exr: its header breaks off at byte {}", at_),
                  "copy or export the file again")};
  }
  std::optional<uint64_t> number(size_t size) {
    if (bytes_.size() - at_ < size) return {};
    uint64_t value = 0;
    for (size_t i = 0; i < size; ++i) value |= uint64_t(static_cast<unsigned char>(bytes_[at_ + i])) << (8 * i);
    at_ += size;
    return value;
  }
  std::optional<std::string_view> word() {
    constexpr size_t kLongestName = 255;
    const size_t end = bytes_.substr(at_, kLongestName + 1).find('\0');
    if (end == std::string_view::npos) return {};
    const std::string_view found = bytes_.substr(at_, end);
    at_ += end + 1;
    return found;
  }

  std::string_view bytes_;
  const std::string& place_;
  size_t at_ = 0;
};

}  // namespace

bool isExr(std::string_view bytes) { return bytes.starts_with("\x76\x2f\x31\x01"); }

Result<ImageF> decodeExr(std::string_view bytes, const std::string& place) try {
  Diagnostics bad = HeaderCheck(bytes, place).run();
  if (!bad.empty()) return bad;
  MemoryReader stream(bytes);
  Imf::InputFile file(stream, 0);
  const Imf::Header& header = file.header();
  const Imath::Box2i window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;  // within the caps

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

  ImageF image(width, height, 3);
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
  Diagnostics bad = HeaderCheck(bytes, place).run();
  if (!bad.empty()) return bad;
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
  return error(place, fmt::format("cannot be written as .exr: {}", thrown.what()), "try another format");
}

}  // namespace glint::codec
