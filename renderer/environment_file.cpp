#include "renderer/environment_file.h"

#include <algorithm>
#include <cmath>

#include "renderer/parallel.h"

namespace glint {
namespace {

constexpr float kLargestHalf = 65504;

// Pixels with one kind of fault.
class Faulty {
 public:
  void add(size_t pixel) {
    if (count_ == 0) first_ = pixel;
    if (count_ == 0 || last_ != pixel) ++count_;
    last_ = pixel;
  }
  // Says how many there are, where, and what became of them.
  void report(const ImageF& image, const std::string& place, const std::string& what, const std::string& hint, Diagnostics& warnings) const {
    if (count_ == 0) return;
    const std::string at = fmt::format("({}, {})", first_ % size_t(image.width), first_ / size_t(image.width));
    warnings.push_back(warning(place, count_ == 1 ? fmt::format("pixel {}, counted from the top left, is {}", at, what)
                                                  : fmt::format("{} pixels are {}; the first is {}, counted from the top left", count_, what, at), hint));
  }

 private:
  size_t count_ = 0, first_ = 0, last_ = 0;
};

void mend(ImageF& image, const std::string& place, Diagnostics& warnings) {
  float brightest = kLargestHalf;
  for (const float v : image.data)
    if (v > brightest && v <= kBrightestPixel) brightest = v;
  Faulty nan, negative, infinite, tooBright;
  for (size_t i = 0; i < image.data.size(); ++i) {
    float& v = image.data[i];
    if (v >= 0 && v <= kBrightestPixel) continue;
    if (std::isnan(v)) nan.add(i / 3);
    else if (v < 0) negative.add(i / 3);
    else if (std::isinf(v)) infinite.add(i / 3);
    else tooBright.add(i / 3);
    v = !(v > 0) ? 0 : std::isinf(v) ? brightest : kBrightestPixel;
  }
  nan.report(image, place, "NaN (not a number) and read as black", "paint over it and save the picture again", warnings);
  negative.report(image, place, "negative and read as black", "clamp the picture to 0 and save it again", warnings);
  infinite.report(image, place, fmt::format("infinite and read as {:g}", brightest), "save the picture with 32-bit floats: halfs end at 65504", warnings);
  tooBright.report(image, place, fmt::format("brighter than {0:g} nits and read as that", kBrightestPixel), "the sun has 2e9: scale the picture and save it again", warnings);
}

// For a picture of any shape: 2:1, with as many pixels along the side that keeps its own, though not many more in all.
ImageSize equirectangular(ImageSize size, int mostWidth) {
  constexpr double kMostGrowth = 4;  // a line of pixels must not become a large square
  const double side = std::sqrt(double(size.pixels()) / 2 * kMostGrowth);
  const int height = std::clamp(std::min(std::max((size.width + 1) / 2, size.height), int(std::ceil(side))), 1, std::max(1, mostWidth / 2));
  return {2 * height, height};
}

}  // namespace

ImageF resized(const ImageF& image, int width, int height) {
  GLINT_CHECK(!image.empty() && width > 0 && height > 0, "{} x {} to {} x {}", image.width, image.height, width, height);
  ImageF out(width, height, image.channels);
  // What pixel i of n covers of the other picture's `from` pixels.
  const auto spread = [](int i, int n, int from, auto&& each) {
    const double low = double(i) * from / n, high = double(i + 1) * from / n;
    for (int at = int(low); at < from && at < high; ++at) {
      const double part = std::min(high, at + 1.0) - std::max(low, double(at));
      if (part > 0) each(at, part / (high - low));
    }
  };
  const size_t channels = size_t(image.channels);
  parallelFor(size_t(height), [&](size_t y) {
    std::vector<double> sum(size_t(width) * channels);
    spread(int(y), height, image.height, [&](int row, double weight) {
      for (int x = 0; x < width; ++x)
        spread(x, width, image.width, [&](int column, double part) {
          const float* from = image.at(column, row);
          for (size_t c = 0; c < channels; ++c) sum[size_t(x) * channels + c] += weight * part * double(from[c]);
        });
    });
    std::transform(sum.begin(), sum.end(), out.at(0, int(y)), [](double v) { return float(v); });
  });
  return out;
}

Result<EnvironmentFile> readEnvironmentFile(const std::filesystem::path& path, int mostWidth) {
  EnvironmentFile file;
  Result<ImageF> image = readImageF(path, mostWidth, file.inFile);
  if (!image) return image.diagnostics();
  const std::string place = path.string();
  mend(*image, place, file.warnings);
  const auto [width, height] = file.inFile;
  ImageSize wanted{image->width, image->height};
  if (width != 2 * height) {
    wanted = equirectangular(wanted, mostWidth);
    file.warnings.push_back(warning(place, fmt::format("is {} x {} pixels, not twice as wide as high: it is stretched over the sphere", width, height),
                                    "an environment is one equirectangular picture of the whole sphere: convert a cube map, a light probe or a photograph first"));
  } else if (wanted.width > mostWidth || wanted.width != 2 * wanted.height) {
    wanted = equirectangular(wanted, mostWidth);  // read averaged, its rim may be a pixel short
  }
  if (width > kLargestEnvironmentWidth || height > kLargestEnvironmentWidth)
    file.warnings.push_back(warning(place, fmt::format("is {} x {} pixels and read as {} x {}", width, height, wanted.width, wanted.height),
                                    fmt::format("no environment is kept finer; save it {} pixels wide to load it faster", kLargestEnvironmentWidth)));
  file.pixels = wanted.width == image->width && wanted.height == image->height ? std::move(*image) : resized(*image, wanted.width, wanted.height);
  return file;
}

}  // namespace glint
