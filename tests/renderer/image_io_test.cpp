#include "renderer/image_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cstdio>
#include <jpeglib.h>
#include <png.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "materials/base/files.h"
#include "tests/support/mutate.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using testing::HasSubstr;

Image8 gradient(int width, int height, int channels) {
  Image8 image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) image.at(x, y)[c] = uint8_t(x * 7 + y * 13 + c * 50);
  return image;
}

ImageF linearGradient(int width, int height, int channels = 3) {
  ImageF image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) image.at(x, y)[c] = float(x + 2 * y + c) / 8.0f;
  return image;
}

std::string pngBytes(const Image8& image, const ImageNotes& notes = {}) {
  const test::TempFolder folder;
  EXPECT_TRUE(writeImage8(folder / "x.png", image, notes).empty());
  return *readFile(folder / "x.png");
}

std::string floatBytes(const char* name, const ImageF& image, const ImageNotes& notes = {}) {
  const test::TempFolder folder;
  EXPECT_TRUE(writeImageF(folder / name, image, notes).empty());
  return *readFile(folder / name);
}

// A PNG of any kind that libpng can write.
std::string rawPng(int width, int height, int depth, int type, const std::string& pixels, bool interlaced = false) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &out, [](png_structp p, png_bytep data, size_t n) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(data), n);
  }, nullptr);
  png_set_IHDR(png, info, png_uint_32(width), png_uint_32(height), depth, type,
               interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, 0, 0);
  const png_color palette[2] = {{10, 20, 30}, {200, 210, 220}};
  const png_byte alpha[2] = {255, 128};
  if (type == PNG_COLOR_TYPE_PALETTE) {
    png_set_PLTE(png, info, palette, 2);
    png_set_tRNS(png, info, alpha, 2, nullptr);
  }
  std::vector<png_bytep> rows;
  for (int y = 0; y < height; ++y)
    rows.push_back(reinterpret_cast<png_bytep>(const_cast<char*>(pixels.data())) + size_t(y) * (pixels.size() / size_t(height)));
  png_set_rows(png, info, rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return out;
}

std::string jpegBytes(const Image8& image, J_COLOR_SPACE space, bool progressive = false) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* out = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &out, &size);
  jpeg.image_width = JDIMENSION(image.width);
  jpeg.image_height = JDIMENSION(image.height);
  jpeg.input_components = image.channels;
  jpeg.in_color_space = space;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 95, TRUE);
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  for (int y = 0; y < image.height; ++y) {
    auto* row = const_cast<JSAMPROW>(image.at(0, y));
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string bytes(reinterpret_cast<char*>(out), size);
  jpeg_destroy_compress(&jpeg);
  std::free(out);
  return bytes;
}

// One diagnostic, with the place given and something said.
template <class T>
std::string onlyFault(const Result<T>& result) {
  if (result.ok()) {
    ADD_FAILURE() << "was read";
    return {};
  }
  EXPECT_EQ(result.diagnostics().size(), 1u);
  EXPECT_EQ(result.diagnostics()[0].place, "f");
  EXPECT_FALSE(result.diagnostics()[0].hint.empty());
  return result.diagnostics()[0].what;
}

TEST(Png, RoundTripsEveryChannelCount) {
  for (const int channels : {1, 3, 4}) {
    const Image8 image = gradient(13, 7, channels);
    EXPECT_EQ(*decodeImage8(pngBytes(image), "f"), image) << channels;
  }
}

TEST(Png, NotesComeBackAlsoWhenTheyAreNotLatin) {
  const test::TempFolder folder;
  const ImageNotes notes = {{"command", "glint render -o \"a b.png\""}, {"name", "Zürich 東京"}, {"empty", ""}};
  ASSERT_TRUE(writeImage8(folder / "x.png", gradient(4, 4, 3), notes).empty());
  EXPECT_EQ(*readImageNotes(folder / "x.png"), notes);
}

TEST(Png, SixteenBitsPalettesAndInterlacingBecomeBytes) {
  const std::string deep{'\xff', '\xff', '\x80', '\x80', '\0', '\0'};
  EXPECT_EQ(decodeImage8(rawPng(1, 1, 16, PNG_COLOR_TYPE_RGB, deep), "f")->data, (std::vector<uint8_t>{255, 128, 0}));
  // Two pixels of one bit each: entries 0 and 1, of which 1 is half transparent.
  const auto palette = decodeImage8(rawPng(2, 1, 1, PNG_COLOR_TYPE_PALETTE, "\x40"), "f");
  EXPECT_EQ(palette->data, (std::vector<uint8_t>{10, 20, 30, 255, 200, 210, 220, 128}));
  const Image8 image = gradient(9, 9, 3);
  const std::string pixels(image.data.begin(), image.data.end());
  EXPECT_EQ(*decodeImage8(rawPng(9, 9, 8, PNG_COLOR_TYPE_RGB, pixels, true), "f"), image);
}

TEST(Png, EveryTruncationIsOneFault) {
  const std::string bytes = pngBytes(gradient(8, 8, 3));
  for (size_t n = 8; n < bytes.size(); ++n)
    ASSERT_THAT(onlyFault(decodeImage8(bytes.substr(0, n), "f")), HasSubstr("truncated")) << n;
}

TEST(Png, DamageIsToldWithItsPlace) {
  std::string bytes = pngBytes(gradient(8, 8, 3));
  bytes[bytes.find("IDAT") + 8] ^= 0x55;
  const std::string what = onlyFault(decodeImage8(bytes, "f"));
  EXPECT_THAT(what, HasSubstr("corrupt PNG"));
  EXPECT_THAT(what, HasSubstr("byte"));
}

TEST(Png, SizesOverTheCapsAreRefusedBeforeAnythingIsAllocated) {
  std::string bytes = pngBytes(gradient(8, 8, 3));
  const auto patch = [&](uint32_t width, uint32_t height) {
    std::string out = bytes;
    for (int i = 0; i < 4; ++i) {
      out[size_t(16 + i)] = char(width >> (24 - 8 * i));
      out[size_t(20 + i)] = char(height >> (24 - 8 * i));
    }
    // A right checksum, so that only the size is wrong.
    const auto crc = [](const std::string& data) {
      uint32_t c = 0xffffffff;
      for (const unsigned char b : data) {
        c ^= b;
        for (int k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >> 1) : c >> 1;
      }
      return ~c;
    };
    const uint32_t sum = crc(out.substr(12, 17));
    for (int i = 0; i < 4; ++i) out[size_t(29 + i)] = char(sum >> (24 - 8 * i));
    return out;
  };
  EXPECT_THAT(onlyFault(decodeImage8(patch(100000, 1), "f")), HasSubstr("100000 x 1"));
  EXPECT_THAT(onlyFault(decodeImage8(patch(32768, 32768), "f")), HasSubstr("32768 x 32768"));
  EXPECT_THAT(onlyFault(decodeImage8(patch(0, 5), "f")), HasSubstr("0 x 5"));
  // Within the caps, but more than so few bytes can hold.
  EXPECT_THAT(onlyFault(decodeImage8(patch(16384, 16384), "f")), HasSubstr("cannot hold"));
}

TEST(Jpeg, ColourGreyAndProgressiveAreRead) {
  Image8 flat(16, 16, 3);
  for (size_t i = 0; i < flat.data.size(); ++i) flat.data[i] = std::array<uint8_t, 3>{200, 100, 50}[i % 3];
  for (const bool progressive : {false, true}) {
    const auto read = decodeImage8(jpegBytes(flat, JCS_RGB, progressive), "f");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->channels, 3);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(read->at(8, 8)[c], flat.at(8, 8)[c], 3);
  }
  EXPECT_EQ(decodeImage8(jpegBytes(gradient(9, 5, 1), JCS_GRAYSCALE), "f")->channels, 1);
}

TEST(Jpeg, CmykIsRefused) {
  EXPECT_THAT(onlyFault(decodeImage8(jpegBytes(gradient(8, 8, 4), JCS_CMYK), "f")), HasSubstr("4 channels"));
}

TEST(Jpeg, EveryTruncationIsOneFault) {
  for (const bool progressive : {false, true}) {
    const std::string bytes = jpegBytes(gradient(24, 24, 3), JCS_RGB, progressive);
    for (size_t n = 3; n < bytes.size(); ++n) onlyFault(decodeImage8(bytes.substr(0, n), "f"));
    EXPECT_THAT(onlyFault(decodeImage8(bytes.substr(0, bytes.size() - 2), "f")), HasSubstr("truncated"));
  }
}

// A .hdr from a size line and scanlines.
std::string hdr(const std::string& size, const std::string& data) {
  return "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + data;
}

TEST(Hdr, RoundTripsAtItsPrecision) {
  for (const int width : {4, 16, 300}) {  // under 8 pixels a row is not coded
    ImageF image = linearGradient(width, 5);
    image.at(1, 1)[0] = 12345.0f;
    const auto read = decodeImageF(floatBytes("x.hdr", image, {{"command", "glint\nrender"}}), "f");
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read->width, width);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < width; ++x) {
        const float* a = image.at(x, y);
        // One part in 256 of the largest channel.
        const float step = std::max({a[0], a[1], a[2]}) / 128;
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(a[c], read->at(x, y)[c], step);
      }
  }
}

TEST(Hdr, ReadsPlainPixelsAndBothRunLengthCodings) {
  const std::string one{'\x80', '\x40', '\x20', '\x81'};  // 1, 0.5, 0.25
  const std::vector<float> pixel = {1, 0.5f, 0.25f};
  const auto expectAll = [&](const std::string& bytes, int width) {
    const auto read = decodeImageF(bytes, "f");
    ASSERT_TRUE(read.ok()) << read.diagnostics()[0].text();
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) EXPECT_EQ(read->at(x, 0)[c], pixel[size_t(c)]) << x;
  };
  expectAll(hdr("-Y 1 +X 2", one + one), 2);
  // Old: a pixel of (1, 1, 1, n) repeats, and a second one counts in 256s.
  expectAll(hdr("-Y 1 +X 10", one + std::string{1, 1, 1, 9}), 10);
  expectAll(hdr("-Y 1 +X 300", one + std::string{1, 1, 1, 43, 1, 1, 1, 1}), 300);
  // New: by channel.
  std::string coded{2, 2, 0, 10};
  for (const char c : one) coded += std::string{char(128 + 7), c, 3, c, c, c};
  expectAll(hdr("-Y 1 +X 10", coded), 10);
}

TEST(Hdr, OrientationsOfTheRows) {
  const std::string a{'\x80', '\x80', '\x80', '\x81'}, b{'\x80', '\x80', '\x80', '\x82'};  // 1 and 2
  EXPECT_EQ(decodeImageF(hdr("+Y 2 +X 1", a + b), "f")->at(0, 0)[0], 2);
  EXPECT_EQ(decodeImageF(hdr("-Y 1 -X 2", a + b), "f")->at(0, 0)[0], 2);
  EXPECT_THAT(onlyFault(decodeImageF(hdr("+X 1 -Y 2", a + b), "f")), HasSubstr("not a size"));
}

TEST(Hdr, FaultsNameTheirByte) {
  const std::string head = hdr("-Y 1 +X 10", "");
  // A run of 11 in a scanline of 10: the count is the fifth byte of the data.
  const std::string over = head + std::string{2, 2, 0, 10, char(128 + 11), 5};
  EXPECT_THAT(onlyFault(decodeImageF(over, "f")), HasSubstr(fmt::format("byte {}, scanline 0: a run goes over", head.size() + 4)));
  EXPECT_THAT(onlyFault(decodeImageF(head + std::string{2, 2, 0, 11}, "f")), HasSubstr("width differs"));
  EXPECT_THAT(onlyFault(decodeImageF(head + std::string{2, 2, 0, 10, 0}, "f")), HasSubstr("a run of no pixels"));
  EXPECT_THAT(onlyFault(decodeImageF(head + std::string{1, 1, 1, 4}, "f")), HasSubstr("before the first pixel"));
  EXPECT_THAT(onlyFault(decodeImageF(hdr("-Y 1 +X 100000", ""), "f")), HasSubstr("100000 x 1"));
  EXPECT_THAT(onlyFault(decodeImageF(hdr("-Y 512", ""), "f")), HasSubstr("not a size"));
  EXPECT_THAT(onlyFault(decodeImageF("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234", "f")), HasSubstr("32-bit_rle_xyze"));
}

TEST(Hdr, EveryTruncationIsOneFault) {
  const std::string bytes = floatBytes("x.hdr", linearGradient(16, 4));
  for (size_t n = 10; n < bytes.size(); ++n)
    ASSERT_THAT(onlyFault(decodeImageF(bytes.substr(0, n), "f")), testing::AnyOf(HasSubstr("truncated"), HasSubstr("not a size"))) << n;
  EXPECT_THAT(onlyFault(decodeImageF(bytes.substr(0, bytes.size() - 1), "f")), HasSubstr(fmt::format("byte {}, in scanline 3 of 4", bytes.size() - 1)));
}

TEST(Pfm, RoundTripsExactlyWithNotANumberAndInfinity) {
  ImageF image = linearGradient(5, 3);
  image.at(2, 1)[1] = std::numeric_limits<float>::infinity();
  image.at(3, 2)[0] = std::nanf("");
  const auto read = decodeImageF(floatBytes("x.pfm", image), "f");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(std::memcmp(read->data.data(), image.data.data(), image.data.size() * 4), 0);
}

TEST(Pfm, GreyAndBigEndian) {
  const auto read = decodeImageF(std::string("Pf\n1 2\n1.0\n") + std::string("\x3f\x80\0\0\x40\0\0\0", 8), "f");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->data, (std::vector<float>{2, 2, 2, 1, 1, 1}));  // from the bottom row up
}

TEST(Pfm, FaultsAreTold) {
  const std::string bytes = floatBytes("x.pfm", linearGradient(5, 3));
  for (size_t n = 3; n < bytes.size(); ++n) onlyFault(decodeImageF(bytes.substr(0, n), "f"));
  EXPECT_THAT(onlyFault(decodeImageF("PF\n5 x\n-1\n", "f")), HasSubstr("not a number"));
  EXPECT_THAT(onlyFault(decodeImageF("PF\n32768 4096\n-1\n", "f")), HasSubstr("truncated"));
  EXPECT_THAT(onlyFault(decodeImageF("PF\n99999 99999\n-1\n", "f")), HasSubstr("99999 x 99999"));
}

TEST(Exr, RoundTripsHalvesAndNotes) {
  const test::TempFolder folder;
  ImageF image = linearGradient(17, 6, 4);
  image.at(3, 3)[0] = 1e6f;                      // over what a half holds
  image.at(4, 3)[0] = -2;
  const ImageNotes notes = {{"command", "glint render"}, {"channels", "not the format's own"}};
  ASSERT_TRUE(writeImageF(folder / "x.exr", image, notes).empty());
  EXPECT_EQ(*readImageNotes(folder / "x.exr"), notes);
  const auto read = readImageF(folder / "x.exr");
  ASSERT_TRUE(read.ok()) << read.diagnostics()[0].text();
  EXPECT_EQ(read->at(3, 3)[0], 65504.0f);
  EXPECT_EQ(read->at(4, 3)[0], -2.0f);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(read->at(16, 5)[c], image.at(16, 5)[c]);
}

TEST(Exr, EveryTruncationIsOneFault) {
  const std::string bytes = floatBytes("x.exr", linearGradient(16, 40));
  for (size_t n = 4; n < bytes.size(); n += 3) onlyFault(decodeImageF(bytes.substr(0, n), "f"));
}

TEST(ImageIo, TheWrongKindOfFileIsNamed) {
  EXPECT_THAT(onlyFault(decodeImageF(pngBytes(gradient(2, 2, 3)), "f")), HasSubstr("is a PNG, not"));
  EXPECT_THAT(onlyFault(decodeImage8(floatBytes("x.hdr", linearGradient(2, 2)), "f")), HasSubstr("is a Radiance .hdr, not"));
  EXPECT_THAT(onlyFault(decodeImage8("GIF89a", "f")), HasSubstr("is not"));
  EXPECT_THAT(onlyFault(decodeImageF("", "f")), HasSubstr("empty"));
}

TEST(ImageIo, WritingTellsWhyItCannot) {
  EXPECT_EQ(writeImage8("x.gif", gradient(2, 2, 3))[0].place, "x.gif");
  EXPECT_FALSE(writeImageF("x.png", linearGradient(2, 2)).empty());
  const Diagnostics failed = writeImage8("/nowhere/at/all.png", gradient(2, 2, 3));
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_EQ(failed[0].place, "/nowhere/at/all.png");
}

TEST(ImageIo, SrgbFunctionsAreTheStandardOnes) {
  EXPECT_EQ(srgbFromLinear(0), 0);
  EXPECT_NEAR(srgbFromLinear(1), 1, 1e-6);
  EXPECT_NEAR(srgbFromLinear(0.5f), 0.735357f, 1e-6);
  EXPECT_NEAR(srgbFromLinear(0.002f), 0.02584f, 1e-6);
  for (int i = 0; i <= 255; ++i) EXPECT_EQ(int(srgbFromLinear(linearFromSrgb(float(i) / 255)) * 255 + 0.5f), i);
}

// Damaged files are read or refused with one fault; what is read is sane.
template <class Decode>
void fuzz(const std::string& bytes, int iterations, Decode&& decode) {
  std::mt19937 random(1);
  for (int i = 0; i < iterations; ++i) {
    const std::string bad = test::mutate(bytes, random);
    const auto result = decode(bad, "f");
    if (result.ok())
      ASSERT_EQ(result->data.size(), size_t(result->width) * size_t(result->height) * size_t(result->channels)) << i;
    else
      ASSERT_EQ(result.diagnostics().size(), 1u) << i;
  }
}

TEST(ImageFuzz, Png) { fuzz(pngBytes(gradient(16, 16, 3), {{"command", "x"}}), 3000, decodeImage8); }
TEST(ImageFuzz, Jpeg) { fuzz(jpegBytes(gradient(32, 32, 3), JCS_RGB), 3000, decodeImage8); }
TEST(ImageFuzz, ProgressiveJpeg) { fuzz(jpegBytes(gradient(32, 32, 3), JCS_RGB, true), 2000, decodeImage8); }
TEST(ImageFuzz, Hdr) { fuzz(floatBytes("x.hdr", linearGradient(16, 16)), 3000, decodeImageF); }
TEST(ImageFuzz, Pfm) { fuzz(floatBytes("x.pfm", linearGradient(6, 6)), 3000, decodeImageF); }
TEST(ImageFuzz, Exr) { fuzz(floatBytes("x.exr", linearGradient(16, 40), {{"command", "x"}}), 2000, decodeImageF); }

}  // namespace
}  // namespace glint
