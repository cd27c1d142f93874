// JPEG, through libjpeg-turbo.
#include <cstdio>  // jpeglib.h needs it before

#include <jpeglib.h>
#include <jerror.h>

#include <csetjmp>

#include "renderer/image_codecs.h"

namespace glint::codec {
namespace {

// A progressive file may hold any number of scans, each of which costs a pass over the whole picture.
constexpr int kMostScans = 256;
// A block of 8 x 8 pixels takes at least one bit (its DC code) in a Huffman-coded file. Arithmetic coding could do
// better, for flat pictures that nobody ships.
constexpr uint64_t kMostPixelsPerByte = 512;

// Everything that libjpeg's longjmp could skip over lives here.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {
    jpeg_.err = jpeg_std_error(&errors_.base);
    errors_.base.error_exit = [](j_common_ptr info) { leave(info); };
    errors_.base.emit_message = [](j_common_ptr info, int level) {
      if (level < 0 && isDamage(info->err->msg_code)) leave(info);
    };
    errors_.base.output_message = [](j_common_ptr) {};
    jpeg_create_decompress(&jpeg_);
    monitor_.progress_monitor = [](j_common_ptr info) {
      if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > kMostScans) {
        info->err->msg_code = JERR_BAD_PROGRESSION;
        leave(info);
      }
    };
    jpeg_.progress = &monitor_;
  }
  ~Reader() { jpeg_destroy_decompress(&jpeg_); }
  Reader(const Reader&) = delete;

  bool readHead() {
    if (setjmp(errors_.jump)) return false;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
    jpeg_read_header(&jpeg_, TRUE);
    return true;
  }
  bool readRows(Image8& image) {
    if (setjmp(errors_.jump)) return false;
    jpeg_.out_color_space = image.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = image.at(0, int(jpeg_.output_scanline));
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

  Diagnostic fault(const std::string& place) const {
    const size_t left = jpeg_.src ? jpeg_.src->bytes_in_buffer : 0;
    const int code = errors_.base.msg_code;
    if (code == JWRN_JPEG_EOF || code == JERR_INPUT_EOF || code == JERR_INPUT_EMPTY)
      return error(place, fmt::format("is a truncated JPEG: it ends at byte {}", bytes_.size()),
                   "copy or export the file again");
    return error(place,
                 fmt::format("is a corrupt JPEG: {} (before byte {})", errors_.text,
                             bytes_.size() - std::min(left, bytes_.size())),
                 "copy or export the file again");
  }
  const jpeg_decompress_struct& jpeg() const { return jpeg_; }

 private:
  struct Errors {
    jpeg_error_mgr base{};  // first: libjpeg hands its address back
    std::jmp_buf jump;
    char text[JMSG_LENGTH_MAX] = {};
  };

  // The warnings after which libjpeg would make pixels up. The others (extraneous bytes, odd markers) are
  // harmless and common.
  static bool isDamage(int code) {
    return code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE ||
           code == JWRN_MUST_RESYNC || code == JWRN_BOGUS_PROGRESSION || code == JWRN_NOT_SEQUENTIAL;
  }
  [[noreturn]] static void leave(j_common_ptr info) {
    auto* errors = reinterpret_cast<Errors*>(info->err);
    errors->base.format_message(info, errors->text);
    std::longjmp(errors->jump, 1);
  }

  std::string_view bytes_;
  Errors errors_;
  jpeg_progress_mgr monitor_{};
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

bool isJpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

Result<ImageSize> jpegSize(std::string_view bytes, const std::string& place) {
  Reader reader(bytes);
  if (!reader.readHead()) return reader.fault(place);
  const auto& jpeg = reader.jpeg();
  Diagnostics tooLarge = checkImageSize(jpeg.image_width, jpeg.image_height, kMostImagePixels, place);
  if (!tooLarge.empty()) return tooLarge;
  return ImageSize{int(jpeg.image_width), int(jpeg.image_height)};
}

Result<Image8> decodeJpeg(std::string_view bytes, const std::string& place) {
  Reader reader(bytes);
  if (!reader.readHead()) return reader.fault(place);
  const auto& jpeg = reader.jpeg();
  const uint64_t width = jpeg.image_width, height = jpeg.image_height;
  Diagnostics tooLarge = checkImageSize(width, height, kMostImagePixels, place);
  if (!tooLarge.empty()) return tooLarge;
  if (jpeg.num_components != 1 && jpeg.num_components != 3)
    return error(place, fmt::format("is a JPEG of {} channels", jpeg.num_components),
                 "export it as RGB or grey; CMYK is not read");
  if (width * height / kMostPixelsPerByte > bytes.size())
    return error(place,
                 fmt::format("is a truncated JPEG: {} bytes cannot hold {} x {} pixels", bytes.size(), width,
                             height),
                 "copy or export the file again");
  Image8 image(int(width), int(height), jpeg.num_components);
  if (!reader.readRows(image)) return reader.fault(place);
  return image;
}

}  // namespace glint::codec
