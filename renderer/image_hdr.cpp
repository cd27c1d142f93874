// Radiance .hdr (RGBE). Read by our own code because the places of faults must be told and libraries hide them.
//
// G. Ward, "Real Pixels", Graphics Gems II (1991), and the "File Formats" page of the Radiance manual: a text
// header, a line with the size, then scanlines of 4-byte RGBE pixels in one of three codings.
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "renderer/image_codecs.h"
#include "renderer/parallel.h"

namespace glint::codec {
namespace {

constexpr size_t kLongestLine = 65536;     // of the header
constexpr int kNewCodingMin = 8, kNewCodingMax = 32767;  // widths that the run-length coding by channel may have

struct Head {
  int width = 0, height = 0;
  bool bottomUp = false, rightToLeft = false;
  size_t data = 0;  // where the scanlines start
};

const char kHint[] = "copy or export the file again";

Diagnostic truncated(const std::string& place, size_t bytes, int row, int height) {
  return error(place,
               fmt::format("is a truncated .hdr: it ends at byte {}, in scanline {} of {}", bytes, row, height),
               kHint);
}

Result<Head> readHead(std::string_view bytes, const std::string& place) {
  Head head;
  size_t at = 0;
  const auto line = [&]() -> std::optional<std::string_view> {
    const size_t end = bytes.substr(0, std::min(bytes.size(), at + kLongestLine)).find('\n', at);
    if (end == std::string_view::npos) return {};
    std::string_view text = bytes.substr(at, end - at);
    at = end + 1;
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  };
  const auto ends = [&] {
    return error(place, fmt::format("is a truncated .hdr: no end of the header after byte {}", at), kHint);
  };
  for (;;) {
    const size_t start = at;
    const auto text = line();
    if (!text) return ends();
    if (text->empty()) break;
    if (text->starts_with("FORMAT=") && *text != "FORMAT=32-bit_rle_rgbe")
      return error(place, fmt::format("byte {}: format '{}' is not read", start, text->substr(7, 40)),
                   "save it as 32-bit_rle_rgbe");
  }
  const size_t sizeAt = at;
  const auto size = line();
  if (!size) return ends();
  // "-Y 512 +X 1024"; either sign may differ. Rows that run along Y ("+X .. -Y ..") are not in use.
  const auto bad = [&] {
    return error(place,
                 fmt::format("byte {}: '{}' is not a size of the form '-Y HEIGHT +X WIDTH'", sizeAt,
                             size->substr(0, 60)),
                 "rotate the picture and save it again");
  };
  const char* p = size->data();
  const char* const end = p + size->size();
  const auto number = [&](char axis, bool& negative, uint64_t& out) {
    if (end - p < 3 || (p[0] != '+' && p[0] != '-') || p[1] != axis || p[2] != ' ') return false;
    negative = p[0] == '-';
    p += 3;
    const auto read = std::from_chars(p, end, out);
    if (read.ec != std::errc() || out == 0) return false;
    p = read.ptr;
    while (p < end && *p == ' ') ++p;
    return true;
  };
  uint64_t width = 0, height = 0;
  bool minusY = false, minusX = false;
  if (!number('Y', minusY, height) || !number('X', minusX, width) || p != end) return bad();
  Diagnostics tooLarge = checkImageSize(width, height, kMostImageFPixels, place);
  if (!tooLarge.empty()) return tooLarge;
  head.width = int(width);
  head.height = int(height);
  head.bottomUp = !minusY;
  head.rightToLeft = minusX;
  head.data = at;
  return head;
}

using Byte = unsigned char;

// Goes through one scanline from byte `at` and gives the byte after it. With `out` (width RGBE pixels) it
// also decodes. A fault is thrown as a short text with `at` on the byte that is wrong.
struct Fault {
  const char* what;  // null: the data ended
  size_t at;
};

class Scanline {
 public:
  Scanline(std::string_view bytes, int width)
      : p_(reinterpret_cast<const Byte*>(bytes.data())), size_(bytes.size()), width_(width) {}

  std::optional<Fault> read(size_t& at, Byte* out) const {
    const bool marked = width_ >= kNewCodingMin && width_ <= kNewCodingMax && size_ - at >= 4 && p_[at] == 2 &&
                        p_[at + 1] == 2 && p_[at + 2] < 128;
    return marked ? byChannel(at, out) : byPixel(at, out);
  }

 private:
  // Each channel by itself, as runs (count > 128, then the value) and literals (count, then the values).
  std::optional<Fault> byChannel(size_t& at, Byte* out) const {
    if (p_[at + 2] * 256 + p_[at + 3] != width_) return Fault{"the scanline's width differs from the picture's", at + 2};
    at += 4;
    for (int channel = 0; channel < 4; ++channel) {
      Byte* to = out ? out + channel : nullptr;
      for (int x = 0; x < width_;) {
        if (at >= size_) return Fault{nullptr, at};
        int count = p_[at];
        const bool run = count > 128;
        if (run) count -= 128;
        if (count == 0) return Fault{"a run of no pixels", at};
        if (count > width_ - x) return Fault{"a run goes over the end of the scanline", at};
        const size_t values = run ? 1 : size_t(count);
        if (size_ - at - 1 < values) return Fault{nullptr, at};
        const Byte* from = p_ + at + 1;
        if (to) {
          if (run)
            for (int i = 0; i < count; ++i, to += 4) *to = *from;
          else
            for (int i = 0; i < count; ++i, to += 4) *to = from[i];
        }
        at += 1 + values;
        x += count;
      }
    }
    return {};
  }

  // Whole pixels; a pixel of (1, 1, 1, n) repeats the one before n times, and a second in a row n * 256 times.
  std::optional<Fault> byPixel(size_t& at, Byte* out) const {
    Byte last[4] = {};
    int shift = 0;
    for (int x = 0; x < width_;) {
      if (size_ - at < 4) return Fault{nullptr, at};
      const Byte* pixel = p_ + at;
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const uint64_t count = shift < 32 ? uint64_t(pixel[3]) << shift : 0;
        if (x == 0 && count > 0) return Fault{"a run before the first pixel", at};
        if (shift >= 32) return Fault{"a run of no pixels", at};
        if (count > uint64_t(width_ - x)) return Fault{"a run goes over the end of the scanline", at};
        if (out)
          for (uint64_t i = 0; i < count; ++i) std::memcpy(out + 4 * (size_t(x) + i), last, 4);
        x += int(count);
        shift += 8;
      } else {
        std::memcpy(last, pixel, 4);
        if (out) std::memcpy(out + 4 * size_t(x), last, 4);
        ++x;
        shift = 0;
      }
      at += 4;
    }
    return {};
  }

  const Byte* p_;
  size_t size_;
  int width_;
};

// 2^(e - 136) by exponent; 0 for e = 0, which means black. The value of a pixel is mantissa * 2^(e - 136), as
// OpenImageIO and stb read it (Radiance itself adds half a step to the mantissa).
const std::array<float, 256>& scales() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (int e = 1; e < 256; ++e) t[size_t(e)] = std::ldexp(1.0f, e - 136);
    return t;
  }();
  return table;
}

}  // namespace

bool isHdr(std::string_view bytes) { return bytes.starts_with("#?RADIANCE") || bytes.starts_with("#?RGBE"); }

Result<ImageF> decodeHdr(std::string_view bytes, const std::string& place, int mostWidth, ImageSize* inFile) {
  const Result<Head> head = readHead(bytes, place);
  if (!head) return head.diagnostics();
  const int width = head->width, height = head->height;
  const Scanline scanline(bytes, width);

  // First where each scanline starts, which finds every fault before the picture is allocated.
  std::vector<size_t> starts;
  size_t at = head->data;
  for (int y = 0; y < height; ++y) {
    starts.push_back(at);
    if (const auto fault = scanline.read(at, nullptr)) {
      if (!fault->what) return truncated(place, bytes.size(), y, height);
      return error(place, fmt::format("is a corrupt .hdr: byte {}, scanline {}: {}", fault->at, y, fault->what), kHint);
    }
  }

  if (inFile) *inFile = {width, height};
  const int side = (width + mostWidth - 1) / mostWidth;  // of a square that becomes one pixel
  ImageF image((width + side - 1) / side, (height + side - 1) / side, 3);
  constexpr int kRowsAtOnce = 16;
  parallelFor(size_t((image.height + kRowsAtOnce - 1) / kRowsAtOnce), [&](size_t band) {
    std::vector<Byte> rgbe(size_t(width) * 4);
    for (int row = int(band) * kRowsAtOnce; row < std::min(image.height, (int(band) + 1) * kRowsAtOnce); ++row) {
      const int top = row * side, rows = std::min(side, height - top);
      for (int y = top; y < top + rows; ++y) {
        size_t from = starts[size_t(head->bottomUp ? height - 1 - y : y)];
        scanline.read(from, rgbe.data());
        for (int x = 0; x < width; ++x) {
          const Byte* pixel = &rgbe[4 * size_t(head->rightToLeft ? width - 1 - x : x)];
          const int column = x / side, columns = std::min(side, width - column * side);
          const float scale = scales()[pixel[3]] / float(columns * rows);
          float* to = image.at(column, row);
          for (int c = 0; c < 3; ++c) to[c] += float(pixel[c]) * scale;
        }
      }
    }
  });
  return image;
}

namespace {

// G. Ward's float2rgbe: the largest component's exponent is shared, mantissas are rounded down.
void encodePixel(const float* rgb, Byte* rgbe) {
  float largest = 0;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, std::isfinite(rgb[c]) ? rgb[c] : 0.0f);
  std::memset(rgbe, 0, 4);
  if (largest < 1e-32f) return;
  int exponent;
  const float scale = std::frexp(std::min(largest, 1.7e38f), &exponent) * 256.0f / std::min(largest, 1.7e38f);
  for (int c = 0; c < 3; ++c) {
    const float v = std::isfinite(rgb[c]) ? std::max(rgb[c], 0.0f) : 0.0f;
    rgbe[c] = Byte(std::min(v * scale, 255.0f));
  }
  rgbe[3] = Byte(exponent + 128);
}

// One channel of a scanline: runs of four and more, literals between them.
void encodeChannel(const std::vector<Byte>& values, std::string& out) {
  constexpr size_t kShortestRun = 4, kLongestRun = 127, kLongestLiteral = 128;
  const auto runAt = [&](size_t i) {
    size_t n = 1;
    while (i + n < values.size() && n < kLongestRun && values[i + n] == values[i]) ++n;
    return n;
  };
  for (size_t i = 0; i < values.size();) {
    const size_t run = runAt(i);
    if (run >= kShortestRun) {
      out += char(128 + run);
      out += char(values[i]);
      i += run;
      continue;
    }
    size_t end = i + 1;
    while (end < values.size() && end - i < kLongestLiteral && runAt(end) < kShortestRun) ++end;
    out += char(end - i);
    out.append(reinterpret_cast<const char*>(&values[i]), end - i);
    i = end;
  }
}

}  // namespace

std::string encodeHdr(const ImageF& image, const ImageNotes& notes) {
  std::string out = "#?RADIANCE\n";
  // Comment lines, one each: the format has no place of its own for notes.
  for (const auto& [key, text] : notes) {
    std::string line = text;
    std::replace(line.begin(), line.end(), '\n', ' ');
    out += fmt::format("# {}: {}\n", key, line);
  }
  out += fmt::format("FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width);
  const bool coded = image.width >= kNewCodingMin && image.width <= kNewCodingMax;
  std::vector<Byte> pixels(size_t(image.width) * 4), channel(size_t(image.width));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) encodePixel(image.at(x, y), &pixels[4 * size_t(x)]);
    if (!coded) {
      out.append(reinterpret_cast<const char*>(pixels.data()), pixels.size());
      continue;
    }
    out += {2, 2, char(image.width >> 8), char(image.width & 255)};
    for (size_t c = 0; c < 4; ++c) {
      for (size_t x = 0; x < channel.size(); ++x) channel[x] = pixels[4 * x + c];
      encodeChannel(channel, out);
    }
  }
  return out;
}

}  // namespace glint::codec
