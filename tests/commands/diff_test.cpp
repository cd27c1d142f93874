// glint diff, and the measures behind it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "app/picture_file.h"
#include "renderer/image_difference.h"
#include "renderer/image_io.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using testing_support::filesIn;
using testing_support::glint;
using testing_support::scratch;

// Smooth in two directions, with an edge.
Image8 pattern(int width, int height, int shift) {
  Image8 image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      uint8_t* pixel = image.at(x, y);
      pixel[0] = uint8_t((x * 7 + shift) & 255);
      pixel[1] = uint8_t(y * 5 & 255);
      pixel[2] = x + shift > width / 2 ? 200 : 40;
    }
  return image;
}

void write(const std::string& name, const Image8& image) {
  ASSERT_TRUE(writeImage8(scratch() / name, image).empty());
}

TEST(Diff, EqualPicturesDoNotDiffer) {
  write("a.png", pattern(40, 30, 0));
  for (const std::string metric : {"flip", "rmse", "max"}) {
    const auto ran = glint({"diff", "a.png", "a.png", "--metric", metric, "--fail-above", "0", "--json"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.json().value("value", -1.0), 0.0);
  }
}

TEST(Diff, VerdictHeatMapAndNotes) {
  write("a.png", pattern(40, 30, 0));
  write("b.png", pattern(40, 30, 3));
  const auto ran = glint({"diff", "a.png", "b.png", "--fail-above", "0.01", "-o", "heat.png", "--json"});
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_EQ(ran.json().value("verdict", ""), "fail");
  const auto heat = readImage8(scratch() / "heat.png");
  ASSERT_TRUE(heat);
  EXPECT_EQ(heat->width, 40);
  const auto notes = readImageNotes(scratch() / "heat.png");
  ASSERT_TRUE(notes);
  EXPECT_EQ(notes->at("Command"), "glint diff a.png b.png --fail-above 0.01 -o heat.png --json");
  EXPECT_EQ(glint({"diff", "a.png", "b.png", "--fail-above", "0.99"}).code, 0);
}

TEST(Diff, LargestAndRmseAreInTheUnitsOfTheFile) {
  Image8 a(4, 2, 3), b(4, 2, 3);
  b.at(2, 1)[1] = 51;
  write("a.png", a);
  write("b.png", b);
  const auto largest = glint({"diff", "a.png", "b.png", "--metric", "max", "--json"}).json();
  EXPECT_NEAR(largest["value"].get<double>(), 0.2, 1e-6);
  EXPECT_EQ(largest["at"], nlohmann::json({2, 1}));
  const auto rmse = glint({"diff", "a.png", "b.png", "--metric", "rmse", "--json"}).json();
  EXPECT_NEAR(rmse["value"].get<double>(), 0.2 / std::sqrt(24.0), 1e-6);
}

TEST(Diff, LinearPictures) {
  ImageF a(8, 8, 3), b(8, 8, 3);
  for (float& v : b.data) v = 2.5f;
  ASSERT_TRUE(writeImageF(scratch() / "a.exr", a).empty());
  ASSERT_TRUE(writeImageF(scratch() / "b.hdr", b).empty());
  const auto ran = glint({"diff", "a.exr", "b.hdr", "--metric", "max", "--json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_NEAR(ran.json()["value"].get<double>(), 2.5, 0.02);
}

TEST(Diff, BadInput) {
  write("a.png", pattern(40, 30, 0));
  write("small.png", pattern(20, 30, 0));
  ImageF nan(4, 4, 3);
  nan.at(1, 2)[0] = std::nanf("");
  ASSERT_TRUE(writeImageF(scratch() / "nan.pfm", nan).empty());
  ASSERT_TRUE(writeImageF(scratch() / "fine.pfm", ImageF(4, 4, 3)).empty());
  std::ofstream(scratch() / "text.png") << "no picture";
  const auto before = filesIn(scratch());
  EXPECT_BAD_INPUT(glint({"diff", "a.png"}), "PICTURE", "compares two");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "none.png"}), "none.png", "no such file");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "text.png"}), "text.png", "");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "small.png", "-o", "heat.png"}), "small.png", "20x30");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "fine.pfm"}), "fine.pfm", "");
  EXPECT_BAD_INPUT(glint({"diff", "nan.pfm", "fine.pfm"}), "nan.pfm", "NaN at 1,2");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "a.png", "--metric", "flop"}), "--metric", "did you mean 'flip'?");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "a.png", "--fail-above", "much"}), "--fail-above", "not a number");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "a.png", "-o", "heat.exr"}), "--output", ".png");
  EXPECT_BAD_INPUT(glint({"diff", "a.png", "a.png", "-o", "nowhere/heat.png"}), "--output", "no folder 'nowhere'");
  EXPECT_EQ(filesIn(scratch()), before);
}

// FLIP's filters written out in two dimensions, as its paper gives them, for one pixel at a time.
double flipAt(const Image8& a, const Image8& b, int px, int py) {
  const double ppd = 67.0206, pi = 3.14159265358979;
  const auto linear = [](int v) {
    const double s = v / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  struct V { double x, y, z; };
  const V white = {0.950428545, 1.0, 1.088900371};
  const auto xyz = [](V c) {
    return V{(10135552 * c.x + 8788810 * c.y + 4435075 * c.z) / 24577794, (2613072 * c.x + 8788810 * c.y + 887015 * c.z) / 12288897,
             (1425312 * c.x + 8788810 * c.y + 70074185 * c.z) / 73733382};
  };
  const auto lab = [&](V c) {
    const auto f = [](double t) { return t > std::pow(6.0 / 29, 3) ? std::cbrt(t) : t / (3 * 36.0 / 841) + 4.0 / 29; };
    const V w = xyz(c);
    const double x = f(w.x / white.x), y = f(w.y), z = f(w.z / white.z), L = 116 * y - 16;
    return V{L, 0.01 * L * 500 * (x - y), 0.01 * L * 200 * (y - z)};
  };
  const auto at = [&](const Image8& image, int x, int y) {
    const uint8_t* p = image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    const V w = xyz({linear(p[0]), linear(p[1]), linear(p[2])});
    return V{116 * w.y - 16, 500 * (w.x / white.x - w.y), 200 * (w.y - w.z / white.z)};
  };
  const auto seenAt = [&](const Image8& image) {
    const int r = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    double sum[3] = {}, weight[3] = {};
    const double q[3][4] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x) {
        const V v = at(image, px + x, py + y);
        const double d2 = (x * x + y * y) / (ppd * ppd), values[3] = {v.x, v.y, v.z};
        for (int k = 0; k < 3; ++k) {
          const double g = q[k][0] * std::sqrt(pi / q[k][1]) * std::exp(-pi * pi * d2 / q[k][1]) +
                           q[k][2] * std::sqrt(pi / q[k][3]) * std::exp(-pi * pi * d2 / q[k][3]);
          sum[k] += g * values[k];
          weight[k] += g;
        }
      }
    const double Y = (sum[0] / weight[0] + 16) / 116, cx = sum[1] / weight[1] / 500, cz = sum[2] / weight[2] / 200;
    const V w = {(Y + cx) * white.x, Y, (Y - cz) * white.z};
    const auto unit = [](double v) { return std::clamp(v, 0.0, 1.0); };
    return lab({unit(3.241003275 * w.x - 1.537398934 * w.y - 0.498615861 * w.z), unit(-0.969224334 * w.x + 1.875930071 * w.y + 0.041554224 * w.z),
                unit(0.055639423 * w.x - 0.204011202 * w.y + 1.057148933 * w.z)});
  };
  const auto featureAt = [&](const Image8& image, bool edge) {
    const double sd = 0.5 * 0.082 * ppd;
    const int r = int(std::ceil(3 * sd));
    double gx[2] = {}, gy[2] = {}, total[2] = {};  // of positive and negative weights
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x) {
        const double g = std::exp(-(x * x + y * y) / (2 * sd * sd));
        const double w = edge ? -x * g : (x * x / (sd * sd) - 1) * g;
        const int side = w > 0 ? 0 : 1;
        gx[side] += w * (at(image, px + x, py + y).x + 16) / 116;
        gy[side] += w * (at(image, px + y, py + x).x + 16) / 116;
        total[side] += std::abs(w);
      }
    return std::hypot(gx[0] / total[0] + gx[1] / total[1], gy[0] / total[0] + gy[1] / total[1]);
  };
  const auto hyab = [](V p, V q) { return std::abs(p.x - q.x) + std::hypot(p.y - q.y, p.z - q.z); };
  const double most = std::pow(hyab(lab({0, 1, 0}), lab({0, 0, 1})), 0.7), knee = 0.4 * most;
  const double distance = std::pow(hyab(seenAt(a), seenAt(b)), 0.7);
  const double color = distance < knee ? 0.95 / knee * distance : 0.95 + (distance - knee) / (most - knee) * 0.05;
  const double edges = std::abs(featureAt(a, true) - featureAt(b, true)), points = std::abs(featureAt(a, false) - featureAt(b, false));
  return std::pow(color, 1 - std::pow(std::max(edges, points) / std::sqrt(2.0), 0.5));
}

TEST(Flip, AgreesWithThePaperPixelByPixel) {
  const Image8 a = pattern(24, 20, 0), b = pattern(24, 20, 5);
  const Pixels<float> map = flip(linearFromDisplay(a), linearFromDisplay(b));
  for (const auto& [x, y] : std::vector<std::pair<int, int>>{{0, 0}, {12, 10}, {7, 3}, {23, 19}, {10, 0}})
    EXPECT_NEAR(*map.at(x, y), flipAt(a, b, x, y), 2e-4) << x << "," << y;
}

TEST(HeatMap, GrowsBrighter) {
  Pixels<float> ramp(256, 1, 1);
  for (int i = 0; i < 256; ++i) ramp.data[size_t(i)] = float(i) / 255;
  const Image8 heat = heatMap(ramp);
  double last = -1;
  for (int i = 0; i < 256; i += 5) {
    const uint8_t* c = heat.at(i, 0);
    const double lightness = 0.2126 * linearFromSrgb(c[0] / 255.f) + 0.7152 * linearFromSrgb(c[1] / 255.f) + 0.0722 * linearFromSrgb(c[2] / 255.f);
    EXPECT_GT(lightness, last - 1e-4) << i;
    last = lightness;
  }
}

}  // namespace
}  // namespace glint
