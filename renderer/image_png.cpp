// PNG, through libpng.
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include "materials/base/utf8.h"
#include "renderer/image_codecs.h"

namespace glint::codec {
namespace {

constexpr size_t kSignatureBytes = 8;
// A note longer than this is not one of ours, and a compressed one could unfold without end.
constexpr png_alloc_size_t kLargestChunk = 8u << 20;

// What libpng's callbacks share. libpng leaves by longjmp, so nothing with a destructor lives between setjmp
// and the calls into it: all of it is here, outside.
struct Source {
  std::string_view bytes;
  size_t position = 0;
  char message[256] = {};
  bool truncated = false;
};

void fail(png_structp png, png_const_charp message) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  std::snprintf(source->message, sizeof source->message, "%s", message);
  std::longjmp(png_jmpbuf(png), 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

void readBytes(png_structp png, png_bytep out, size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (count > source->bytes.size() - source->position) {
    source->truncated = true;
    png_error(png, "the file ends early");
  }
  std::memcpy(out, source->bytes.data() + source->position, count);
  source->position += count;
}

Diagnostic fault(const Source& source, const std::string& place) {
  if (source.truncated)
    return error(place, fmt::format("is a truncated PNG: it ends at byte {}", source.bytes.size()),
                 "copy or export the file again");
  return error(place, fmt::format("is a corrupt PNG: {} (before byte {})", source.message, source.position),
               "copy or export the file again");
}

class Reader {
 public:
  Reader(std::string_view bytes) {
    source_.bytes = bytes;
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, fail, ignoreWarning);
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    GLINT_CHECK(info_, "libpng {}", PNG_LIBPNG_VER_STRING);
    png_set_read_fn(png_, &source_, readBytes);
    png_set_user_limits(png_, kLargestImageSide, kLargestImageSide);
    png_set_chunk_malloc_max(png_, kLargestChunk);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;

  // Up to the first pixel data, set to give 8-bit grey, grey-alpha, RGB or RGBA.
  bool readHead() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_info(png_, info_);
    png_set_expand(png_);
    png_set_scale_16(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }
  bool readRows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows);
    png_read_end(png_, info_);
    return true;
  }
  // Everything but the pixels, for the notes after them.
  bool readNotes() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
    png_read_info(png_, info_);
    return true;
  }

  png_structp png() { return png_; }
  png_infop info() { return info_; }
  const Source& source() const { return source_; }

 private:
  Source source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

void appendBytes(png_structp png, png_bytep data, size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), count);
}

struct Writer {
  Source source;  // for its message
  std::string bytes;
  std::vector<png_bytep> rows;
  std::vector<png_text> texts;
  png_structp png = nullptr;
  png_infop info = nullptr;

  Writer() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &source, fail, ignoreWarning);
    info = png ? png_create_info_struct(png) : nullptr;
    GLINT_CHECK(info, "libpng {}", PNG_LIBPNG_VER_STRING);
    png_set_write_fn(png, &bytes, appendBytes, nullptr);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;

  bool write(const Image8& image) {
    constexpr int kTypes[] = {0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                              PNG_COLOR_TYPE_RGB_ALPHA};
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, image.width, image.height, 8, kTypes[image.channels], PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(png, 5);
    if (!texts.empty()) png_set_text(png, info, texts.data(), int(texts.size()));
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
    return true;
  }
};

// PNG keywords are 1 to 79 bytes of printable Latin-1; ours are plain words of the program's own, so ASCII is enough.
bool isKeyword(const std::string& key) {
  return !key.empty() && key.size() <= 79 && key.front() != ' ' && key.back() != ' ' &&
         std::all_of(key.begin(), key.end(), [](unsigned char c) { return c >= 32 && c < 127; });
}

}  // namespace

bool isPng(std::string_view bytes) {
  return bytes.size() >= kSignatureBytes &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignatureBytes) == 0;
}

Result<ImageSize> pngSize(std::string_view bytes, const std::string& place) {
  // Signature, then the IHDR chunk: length, type, width, height, ...
  if (bytes.size() < 24 || bytes.substr(12, 4) != "IHDR")
    return error(place, fmt::format("is a truncated PNG: it ends at byte {}", bytes.size()),
                 "copy or export the file again");
  const auto* p = reinterpret_cast<png_const_bytep>(bytes.data());
  const uint64_t width = png_get_uint_32(p + 16), height = png_get_uint_32(p + 20);
  Diagnostics tooLarge = checkImageSize(width, height, kMostImagePixels, place);
  if (!tooLarge.empty()) return tooLarge;
  return ImageSize{int(width), int(height)};
}

Result<Image8> decodePng(std::string_view bytes, const std::string& place) {
  const Result<ImageSize> size = pngSize(bytes, place);
  if (!size) return size.diagnostics();
  Reader reader(bytes);
  if (!reader.readHead()) return fault(reader.source(), place);
  const int channels = png_get_channels(reader.png(), reader.info());
  const size_t rowBytes = png_get_rowbytes(reader.png(), reader.info());
  GLINT_CHECK(rowBytes == size_t(size->width) * size_t(channels), "row {} width {} channels {}", rowBytes,
              size->width, channels);
  // Deflate never shrinks data by more than 1032 to 1, and a packed row is at least width / 8 bytes: a header
  // that promises more than the file can hold is a fault that must not cost its memory.
  const uint64_t packed = (uint64_t(size->width) * png_get_bit_depth(reader.png(), reader.info()) + 7) / 8;
  if (packed * uint64_t(size->height) / 1032 > bytes.size())
    return error(place,
                 fmt::format("is a truncated PNG: {} bytes cannot hold {} x {} pixels", bytes.size(),
                             size->width, size->height),
                 "copy or export the file again");
  Image8 image(size->width, size->height, channels);
  std::vector<png_bytep> rows(size_t(image.height));
  for (int y = 0; y < image.height; ++y) rows[size_t(y)] = image.at(0, y);
  if (!reader.readRows(rows.data())) return fault(reader.source(), place);
  return image;
}

Result<ImageNotes> pngNotes(std::string_view bytes, const std::string& place) {
  Reader reader(bytes);
  if (!reader.readNotes()) return fault(reader.source(), place);
  ImageNotes notes;
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(reader.png(), reader.info(), &texts, &count);
  for (int i = 0; i < count; ++i)
    if (texts[i].key && texts[i].text) notes[texts[i].key] = texts[i].text;
  return notes;
}

Result<std::string> encodePng(const Image8& image, const ImageNotes& notes, const std::string& place) {
  Writer writer;
  for (int y = 0; y < image.height; ++y)
    writer.rows.push_back(const_cast<png_bytep>(image.at(0, y)));
  std::vector<std::string> texts;
  texts.reserve(notes.size());
  for (const auto& [key, given] : notes) {
    GLINT_CHECK(isKeyword(key), "PNG keyword '{}'", key);
    const std::string& text = texts.emplace_back(validUtf8(given));
    // tEXt holds Latin-1, of which ASCII is all that UTF-8 shares; iTXt holds UTF-8.
    const bool ascii = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128; });
    png_text entry{};
    entry.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(key.c_str());
    entry.text = const_cast<char*>(text.c_str());
    entry.text_length = text.size();
    entry.itxt_length = ascii ? 0 : text.size();
    writer.texts.push_back(entry);
  }
  if (!writer.write(image)) return error(place, fmt::format("cannot be written as PNG: {}", writer.source.message), "try another format");
  return std::move(writer.bytes);
}

}  // namespace glint::codec
