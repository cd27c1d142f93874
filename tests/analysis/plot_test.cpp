// Plots: their numbers against known ones, their axes, what is read from them, and their files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/analysis/plot_layout.h"
#include "app/analysis/plot_picture.h"
#include "app/analysis/plot_reading.h"
#include "app/analysis/plot_svg.h"
#include "materials/model_file.h"
#include "renderer/gl/context.h"
#include "renderer/image_io.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using std::numbers::pi;
using testing::HasSubstr;
using testing::UnorderedElementsAre;
using testing_support::scratch;

class Plots : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::Context::create({.backend = gl::Backend::OsMesa});
    ASSERT_TRUE(made) << made.diagnostics()[0].text();
    context_ = std::move(*made);
    computer_ = std::make_unique<PlotComputer>();
    registry_ = std::make_unique<ModelRegistry>();
  }
  static void TearDownTestSuite() {
    computer_.reset();
    context_.reset();
  }
  static PlotSubject subject(const std::string& id) {
    const ModelPtr model = *registry_->get(id);
    return {model, {}, model->title};
  }
  static PlotSettings settings(const std::string& text) {
    const auto parsed = parsePlot(text, "--plot");
    EXPECT_TRUE(parsed) << parsed.diagnostics()[0].text();
    return *parsed;
  }
  static PlotData compute(const std::string& plot, const std::vector<std::string>& models, double effort = 0.3) {
    std::vector<PlotSubject> subjects;
    for (const std::string& id : models) subjects.push_back(subject(id));
    return *computer_->compute(settings(plot), subjects, effort);
  }
  static PlotDrawing draw(const PlotData& data, PlotView view = {}) { return layOutPlot(data, view, pictureTextMeasure()); }

  static std::unique_ptr<gl::Context> context_;
  static std::unique_ptr<PlotComputer> computer_;
  static std::unique_ptr<ModelRegistry> registry_;
};
std::unique_ptr<gl::Context> Plots::context_;
std::unique_ptr<PlotComputer> Plots::computer_;
std::unique_ptr<ModelRegistry> Plots::registry_;

TEST_F(Plots, DistributionsHaveTheirPeak) {
  const PlotData data = compute("d:roughness=0.05/0.5", {"GGX*SmithGGX*Schlick", "Beckmann*SmithBeckmann*Schlick"});
  ASSERT_EQ(data.curves.size(), 4u);
  EXPECT_EQ(data.variants, (std::vector<std::string>{"roughness 0.05", "roughness 0.5"}));
  for (const PlotCurve& curve : data.curves) {
    const double alpha = curve.variant == 0 ? 0.0025 : 0.25;
    EXPECT_NEAR(valueAt(curve, 0) * pi * alpha * alpha, 1, 1e-4);
    EXPECT_NEAR(valueAt(curve, 20), valueAt(curve, -20), 1e-5 * std::abs(valueAt(curve, 20)));
  }
  // Half the height of GGX at roughness 0.05 is reached at tan^2 = (sqrt 2 - 1) alpha^2: the points stand close enough.
  const double half = std::atan(0.0025 * std::sqrt(std::sqrt(2.0) - 1)) * 180 / pi;
  EXPECT_NEAR(valueAt(data.curves[0], half) * pi * 0.0025 * 0.0025, 0.5, 0.01);
}

TEST_F(Plots, TermsAreThoseOfTheirFormulas) {
  const PlotCurve F = compute("f:F0=0.04", {"ggx"}).curves[0];
  for (const double angle : {0.0, 30.0, 60.0, 85.0})
    EXPECT_NEAR(valueAt(F, angle), 0.04 + 0.96 * std::pow(1 - std::cos(angle * pi / 180), 5), 2e-4) << angle;
  // Uncorrelated Smith: with the light on the normal, G is G1 of the view.
  const PlotCurve G = compute("g:roughness=0.5", {"GGX*SmithGGX*Schlick"}).curves[0];
  const double tan = std::tan(60 * pi / 180);
  EXPECT_NEAR(valueAt(G, 60), 2 / (1 + std::sqrt(1 + 0.0625 * tan * tan)), 1e-4);
  EXPECT_NEAR(valueAt(G, 90), 0, 1e-6);
  EXPECT_NEAR(valueAt(compute("v:roughness=0.5", {"GGX*Implicit*Schlick"}).curves[0], 45), 0.25, 1e-6);
}

TEST_F(Plots, LobesAreDVFAndPeakAtTheMirror) {
  const PlotData data = compute("lobe:roughness=0.3,angle=30,F0=1", {"GGX*Implicit*None"});
  const PlotCurve& f = data.curves[0];
  // At the mirror h = n: D = 1 / (pi alpha^2), V = 1/4, F = 1.
  EXPECT_NEAR(valueAt(f, 30), 1 / (pi * 0.0081) / 4, 0.01);
  EXPECT_GT(valueAt(f, 30), valueAt(f, 33));
  EXPECT_GT(valueAt(f, 30), valueAt(f, 27));
  const PlotData cosine = compute("lobe:roughness=0.3,angle=30,F0=1,cosine=1", {"GGX*Implicit*None"});
  EXPECT_NEAR(valueAt(cosine.curves[0], 60), 0.5 * valueAt(f, 60), 1e-4);
  const PlotData diffuse = compute("lobe:part=diffuse/sum,baseColor=0.5/0.25/0.1,channel=g", {"ggx"});
  EXPECT_NEAR(valueAt(diffuse.curves[0], -20), 0.25 / pi, 1e-5);
  EXPECT_GT(valueAt(diffuse.curves[1], 45), 0.25 / pi);
}

TEST_F(Plots, AlbedosAreTheExactOnes) {
  // From tests/data/exact_values.json.
  const PlotCurve angle = compute("albedo:roughness=0.3", {"ggx"}, 1).curves[0];
  EXPECT_NEAR(valueAt(angle, std::acos(0.3) * 180 / pi), 0.819057, 2e-3);
  EXPECT_EQ(angle.y.size(), 60u);
  const PlotCurve roughness = compute("albedo:over=roughness,angle=78.46304096718451", {"ggx"}, 1).curves[0];
  EXPECT_NEAR(valueAt(roughness, 0.55), 0.701904, 2e-3);
  // With multiple scattering nothing is lost.
  const PlotCurve whole = compute("albedo:roughness=0.8,compensate=1", {"GGX*SmithGGXCorrelated*Schlick"}).curves[0];
  for (const double degrees : {0.0, 45.0, 80.0}) EXPECT_NEAR(valueAt(whole, degrees), 1, 5e-3) << degrees;
  // Of a dielectric: specular and diffuse add up.
  const PlotData parts = compute("albedo:part=specular/diffuse/sum,specular=0.5,baseColor=0.5", {"ggx"});
  ASSERT_EQ(parts.curves.size(), 3u);
  EXPECT_NEAR(parts.F0.g, 0.04, 1e-6);
  EXPECT_NEAR(valueAt(parts.curves[1], 30), 0.5, 1e-3);
  EXPECT_NEAR(valueAt(parts.curves[2], 30), valueAt(parts.curves[0], 30) + valueAt(parts.curves[1], 30), 1e-9);
  EXPECT_LT(valueAt(parts.curves[0], 0), 0.05);
}

TEST_F(Plots, SlicesAreAsBrdfExplorersAre) {
  const PlotData data = compute("slice:roughness=0.5,F0=1", {"GGX*Implicit*None"});
  ASSERT_EQ(data.slices.size(), 1u);
  const ImageF& f = data.slices[0].f;
  // D depends on theta_h alone: columns are constant, and fall from the left.
  const auto D = [](double thetaH) {
    const double c = std::cos(thetaH), a2 = 0.0625, d = c * c * (a2 - 1) + 1;
    return a2 / (pi * d * d);
  };
  for (const int column : {0, f.width / 3, f.width / 2})
    for (const int row : {f.height / 4, f.height - 1})
      EXPECT_NEAR(f.at(column, row)[1] / (D(90.0 * (column + 0.5) / f.width * pi / 180) / 4), 1, 2e-3) << column << " " << row;
  // F depends on theta_d alone: rows, white at the top.
  const ImageF F = compute("slice:roughness=1,F0=0", {"GGX*Implicit*Schlick"}).slices[0].f;
  EXPECT_GT(F.at(3, 0)[0], 20 * F.at(3, F.height / 2)[0]);
}

TEST_F(Plots, ChannelsOfGreyAreOneCurve) {
  EXPECT_EQ(compute("f:channel=rgb,baseColor=1/0.8/0.3,metallic=1", {"ggx"}).curves.size(), 3u);
  const PlotData grey = compute("f:channel=rgb", {"ggx", "beckmann"});
  EXPECT_EQ(grey.curves.size(), 2u);
  EXPECT_EQ(grey.variants, std::vector<std::string>{""});
}

TEST_F(Plots, WhatAModelHasNotIsLeftOutAndSaid) {
  const auto model = parseModel("flat.glsl", "/*glint {\"id\": \"flat\", \"title\": \"Flat\"} */\nvec3 specular(Shading s, Parameters p) { return s.F0; }");
  ASSERT_TRUE(model) << model.diagnostics()[0].text();
  const auto flat = std::make_shared<const ShadingModel>(*model);
  for (const char* kind : {"d", "g", "v", "f"}) {
    const PlotData data = *computer_->compute(settings(kind), {{flat, {}, "Flat"}, subject("ggx")});
    EXPECT_EQ(data.curves.size(), 1u) << kind;
    ASSERT_EQ(data.notes.size(), 1u);
    EXPECT_THAT(data.notes[0], HasSubstr("Flat has no"));
  }
  const PlotData lobe = *computer_->compute(settings("lobe:F0=0.5"), {{flat, {}, "Flat"}});
  EXPECT_NEAR(valueAt(lobe.curves[0], 10), 0.5, 1e-6);
}

// Light from within has no cosine: it is there where plots are of light sent out, and left out of f, which is said.
TEST_F(Plots, ScatteredLightIsWithTheDiffuse) {
  const auto model = parseModel("wax.glsl", "/*glint {\"id\": \"wax\", \"title\": \"Wax\"} */\nvec3 specular(Shading s, Parameters p) { return vec3(0.0); }\n"
                                            "vec3 diffuse(Shading s, Parameters p) { return vec3(0.0); }\nvec3 scattered(Shading s, Parameters p) { return vec3(0.25); }\n");
  ASSERT_TRUE(model) << model.diagnostics()[0].text();
  const PlotSubject wax{std::make_shared<const ShadingModel>(*model), {}, "Wax"};
  const PlotData f = *computer_->compute(settings("lobe:part=diffuse"), {wax}), sent = *computer_->compute(settings("polar:part=sum,cosine=1"), {wax});
  EXPECT_NEAR(valueAt(f.curves[0], 20), 0, 1e-6);
  EXPECT_EQ(f.notes, std::vector<std::string>{"Wax: the light scattered within is left out; times the cosine it is there"});
  EXPECT_NEAR(valueAt(sent.curves[0], 20), 0.25, 1e-5);
  EXPECT_EQ(computer_->compute(settings("lobe"), {wax})->notes.size(), 0u) << "its specular part is whole";
  const PlotData albedo = *computer_->compute(settings("albedo:part=diffuse"), {wax});
  EXPECT_NEAR(valueAt(albedo.curves[0], 20), 0.25 * 4 * pi, 1e-3) << "over light from all around";
}

// Each line of a view that stands alone has its words.
TEST_F(Plots, PolarPlotsNameTheirViews) {
  const PlotDrawing drawing = draw(compute("polar:angle=0/80", {"ggx"}));
  int views = 0, mirrors = 0;
  for (const PlotItem& item : drawing.items)
    if (const auto* text = std::get_if<PlotText>(&item)) {
      views += text->text == "view";
      mirrors += text->text == "mirror";
    }
  EXPECT_EQ(views, 1);
  EXPECT_EQ(mirrors, 1);
}

// At the horizon f has no bound: the other curves keep the axis.
TEST_F(Plots, OneCurveDoesNotFlattenTheOthers) {
  const PlotData data = compute("polar:angle=0/45/90", {"ggx", "burley"});
  ASSERT_TRUE(data.top);
  EXPECT_GT(*data.top, 0.05);
  EXPECT_LT(*data.top, 1);
  ASSERT_EQ(data.notes.size(), 1u);
  EXPECT_THAT(data.notes[0], testing::ContainsRegex("GGX .*90.* reaches .*: cut off"));
  EXPECT_FALSE(compute("polar:angle=0/45/90,log=1", {"ggx"}).top);
  EXPECT_FALSE(compute("polar:angle=0/45/90,max=1000", {"ggx"}).top);
  EXPECT_FALSE(compute("d:roughness=0.2/0.6", {"ggx"}).top);
}

TEST_F(Plots, AFaultOfAModelStopsNoOther) {
  const auto broken = parseModel("broken.glsl", "/*glint {\"id\": \"broken\", \"terms\": {\"D\": \"GGX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\nfloat x() { return y; }");
  ASSERT_TRUE(broken);
  const auto gaps = parseModel("gaps.glsl", "/*glint {\"id\": \"gaps\", \"terms\": {\"V\": \"SmithGGX\", \"F\": \"Schlick\"}} */\n"
                                            "float D(Shading s, Parameters p) { return s.NoH < 0.9 ? sqrt(s.NoH - 2.0) : 1.0; }");
  ASSERT_TRUE(gaps);
  const PlotData data = *computer_->compute(settings("d"), {{std::make_shared<const ShadingModel>(*broken), {}, "Broken"},
                                                            {std::make_shared<const ShadingModel>(*gaps), {}, "Gaps"}, subject("ggx")});
  EXPECT_EQ(data.curves.size(), 2u);
  ASSERT_FALSE(data.problems.empty());
  EXPECT_EQ(data.problems[0].place, "broken.glsl:2");
  EXPECT_THAT(data.notes, testing::Contains(HasSubstr("Gaps: not finite at")));
  const PlotDrawing drawing = draw(data);
  EXPECT_EQ(drawing.frames.size(), 1u);
}

TEST_F(Plots, TheWorkIsGivenUpWhenNobodyWaitsForIt) {
  int asked = 0;
  EXPECT_FALSE(computer_->compute(settings("d"), {subject("ggx"), subject("beckmann")}, 1, [&] { return ++asked == 2; }));
  EXPECT_EQ(asked, 2);
}

TEST_F(Plots, ReadingGivesTheValuesUnderThePointer) {
  const PlotData data = compute("f:F0=0.04", {"ggx", "GGX*SmithGGX*None"});
  const PlotDrawing drawing = draw(data);
  ASSERT_EQ(drawing.frames.size(), 1u);
  const PlotFrame& frame = drawing.frames[0];
  const glm::vec2 place = frame.place(60, 0.3);
  EXPECT_NEAR(frame.values(place).x, 60, 0.01);
  EXPECT_NEAR(frame.values(place).y, 0.3, 0.001);
  const auto reading = readPlot(data, drawing, place);
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->place, "\u03b8_{d} 60.0\u00b0");
  ASSERT_EQ(reading->lines.size(), 2u);
  EXPECT_EQ(reading->lines[0].subject, 0u) << "the larger value comes first";
  EXPECT_NEAR(reading->lines[0].value, 0.04 + 0.96 * std::pow(0.5, 5), 1e-3);
  EXPECT_NEAR(reading->lines[1].value, 0.04, 1e-6);
  EXPECT_NEAR(reading->lines[0].dot.y, frame.place(60, reading->lines[0].value).y, 1e-3);
  EXPECT_EQ(readPlot(data, drawing, place, {0})->lines.size(), 1u);
  EXPECT_FALSE(readPlot(data, drawing, {2, 2}));

  const PlotData polar = compute("polar", {"ggx"});
  const PlotDrawing half = draw(polar);
  const auto there = readPlot(polar, half, half.frames[0].place(45, 0.5 * half.frames[0].y.high));
  ASSERT_TRUE(there);
  EXPECT_NEAR(there->x, 45, 0.1);
  EXPECT_NEAR(there->lines[0].value, valueAt(polar.curves[0], 45), 0.01 * there->lines[0].value);
  EXPECT_FALSE(readPlot(polar, half, half.frames[0].low + 1.0f)) << "the corner beyond the disc";

  const PlotData slices = compute("slice", {"ggx", "beckmann"});
  const PlotDrawing two = draw(slices);
  ASSERT_EQ(two.frames.size(), 2u);
  const auto at = readPlot(slices, two, two.frames[1].place(10, 80));
  ASSERT_TRUE(at);
  EXPECT_EQ(at->lines.size(), 2u);
  EXPECT_NEAR(at->y, 80, 1);
}

TEST_F(Plots, CurvesStayInTheirFrame) {
  const PlotData data = compute("lobe:roughness=0.2,max=0.5,angle=60", {"ggx", "burley"});
  for (const bool zoomed : {false, true}) {
    PlotView view;
    if (zoomed) view.x = PlotAxis{55, 65, PlotScale::Degrees}, view.y = PlotAxis{0.1, 0.2, PlotScale::Linear};
    const PlotDrawing drawing = draw(data, view);
    const PlotFrame& frame = drawing.frames[0];
    for (const PlotItem& item : drawing.items)
      if (const auto* line = std::get_if<PlotLine>(&item); line && line->width > 1.8f && line->points[0].y > frame.low.y - 3)
        for (const glm::vec2& p : line->points) {
          EXPECT_GE(p.x, frame.low.x - 0.01f);
          EXPECT_LE(p.x, frame.high.x + 0.01f);
          EXPECT_GE(p.y, frame.low.y - 3);
          EXPECT_LE(p.y, frame.high.y + 3);
        }
  }
}

// A file whose parameter has the name of the attribute takes the plot's roughness for it.
TEST_F(Plots, RoughnessOfItsOwn) {
  Diagnostics warnings;
  auto model = readModelFile(GLINT_TESTS_DIR "/data/brdf/brushed.brdf", warnings);
  ASSERT_TRUE(model);
  const PlotSubject one{std::make_shared<const ShadingModel>(std::move(*model)), {}, "brushed"};
  for (const char* kind : {"lobe:roughness=0.1/0.4,angle=30,part=sum", "albedo:roughness=0.1/0.4,part=sum", "polar:roughness=0.1/0.4,part=sum"}) {
    const auto data = computer_->compute(settings(kind), {one}, 0.3);
    ASSERT_EQ(data->curves.size(), 2u) << kind;
    const auto highest = [&](size_t i) { return *std::max_element(data->curves[i].y.begin(), data->curves[i].y.end()); };
    EXPECT_GT(std::abs(highest(0) - highest(1)), 0.02 * highest(1)) << kind;
  }
}

TEST_F(Plots, TextsAreInsideThePicture) {
  const TextMeasure measure = pictureTextMeasure();
  for (const char* plot : {"d:log=1", "lobe:angle=20/60,part=specular/diffuse", "polar:angle=50", "albedo", "slice:log=1", "f:channel=rgb,baseColor=1/0.5/0.1,metallic=1"})
    for (const glm::ivec2 size : {glm::ivec2(900, 600), glm::ivec2(400, 320)}) {
      const PlotData data = compute(plot, {"ggx", "cook-torrance", "GGX*SmithGGXCorrelated*Schlick*OrenNayar"});
      const PlotDrawing drawing = draw(data, {.size = size, .unit = plotUnit(size)});
      for (const PlotItem& item : drawing.items)
        if (const auto* text = std::get_if<PlotText>(&item)) {
          const float width = textWidth(text->text, text->size, text->bold, measure);
          const float left = text->at.x - width * (text->align == TextAlign::Right ? 1.0f : text->align == TextAlign::Center ? 0.5f : 0.0f);
          EXPECT_GE(left, 0) << plot << ": " << text->text;
          EXPECT_LE(left + width, static_cast<float>(size.x)) << plot << ": " << text->text;
          EXPECT_LE(text->at.y, static_cast<float>(size.y)) << plot << ": " << text->text;
        }
    }
}

TEST_F(Plots, SvgIsWellFormedAndSelfContained) {
  PlotData data = compute("slice", {"ggx"});
  data.titles[0] = "<A & \"B\">\x01";
  const auto svg = plotSvg(draw(data), {{"Command", "glint <compare> & more"}});
  ASSERT_TRUE(svg);
  EXPECT_THAT(*svg, HasSubstr("&lt;A &amp; &quot;B&quot;&gt;"));
  EXPECT_THAT(*svg, HasSubstr("Command: glint &lt;compare&gt; &amp; more"));
  EXPECT_THAT(*svg, HasSubstr("<title>Slice of the BRDF over \u03b8h and \u03b8d</title>"));
  EXPECT_EQ(svg->find('\x01'), std::string::npos);
  for (const std::string& text : {*svg, *plotSvg(draw(compute("lobe:angle=30/60,log=1", {"ggx", "beckmann"})), {})}) {
    // Every element that is opened is closed, in order.
    std::vector<std::string> open;
    for (size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
      const size_t end = text.find('>', at);
      ASSERT_NE(end, std::string::npos);
      const std::string tag = text.substr(at + 1, end - at - 1);
      if (tag[0] == '?') continue;
      if (tag[0] == '/') {
        ASSERT_FALSE(open.empty());
        EXPECT_EQ(open.back(), tag.substr(1));
        open.pop_back();
      } else if (tag.back() != '/') {
        open.push_back(tag.substr(0, tag.find(' ')));
      }
    }
    EXPECT_TRUE(open.empty());
    EXPECT_THAT(text, testing::Not(HasSubstr("nan")));
    EXPECT_EQ(text.find("href=\"http"), std::string::npos);
  }
}

TEST_F(Plots, PicturesShowTheCurvesInTheirColors) {
  const PlotData data = compute("f", {"ggx"});
  const PlotDrawing drawing = draw(data, {.size = {400, 300}});
  const Image8 picture = plotPicture(drawing);
  ASSERT_EQ(picture.width, 400);
  const glm::vec2 at = drawing.frames[0].place(45, valueAt(data.curves[0], 45));
  const uint8_t* pixel = picture.at(static_cast<int>(at.x), static_cast<int>(at.y));
  EXPECT_LT(std::abs(pixel[0] - drawing.colors[0].r) + std::abs(pixel[1] - drawing.colors[0].g) + std::abs(pixel[2] - drawing.colors[0].b), 90);
}

TEST(PlotAxes, TicksAreRound) {
  const auto labels = [](const PlotAxis& axis, int count) {
    std::vector<std::string> all;
    for (const PlotTick& tick : axis.ticks(count))
      if (!tick.label.empty()) all.push_back(tick.label);
    return all;
  };
  EXPECT_EQ(labels({0, 1, PlotScale::Linear}, 5), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels({-90, 90, PlotScale::Degrees}, 7), (std::vector<std::string>{"\u221290\u00b0", "\u221260\u00b0", "\u221230\u00b0", "0\u00b0", "30\u00b0", "60\u00b0", "90\u00b0"}));
  EXPECT_EQ(labels({1e-5, 10, PlotScale::Log}, 8), (std::vector<std::string>{"10^{\u22125}", "10^{\u22124}", "0.001", "0.01", "0.1", "1", "10"}));
  EXPECT_EQ(labels({0, 1.5e8, PlotScale::Linear}, 3), (std::vector<std::string>{"0", "5\u00b710^{7}", "1\u00b710^{8}", "1.5\u00b710^{8}"}));
  const PlotAxis axis = roundAxis(0, 39.3, PlotScale::Linear);
  EXPECT_EQ(axis.high, 40);
  EXPECT_NEAR(roundAxis(1e-9, 3, PlotScale::Log).low, 1e-5, 1e-15);
  const PlotAxis zoomed = PlotAxis{0, 90, PlotScale::Degrees}.zoomed(0.5, 2);
  EXPECT_NEAR(zoomed.low, 22.5, 1e-9);
  EXPECT_NEAR(zoomed.high, 67.5, 1e-9);
}

TEST(PlotColors, CloseOnesAreDrivenApart) {
  const std::vector<std::array<float, 3>> same(6, {0.45f, 0.72f, 0.48f});
  for (const bool dark : {false, true}) {
    const auto colors = distinctColors(same, dark);
    for (size_t i = 0; i < colors.size(); ++i)
      for (size_t k = 0; k < i; ++k) EXPECT_GT(colorDistance(colors[i], colors[k]), 0.07) << i << " " << k;
    for (const PlotColor& c : colors) EXPECT_GT(colorDistance(c, dark ? PlotColor{33, 33, 33} : PlotColor{255, 255, 255}), 0.3);
  }
}

std::string faults(const std::string& text) {
  const auto parsed = parsePlot(text, "--plot");
  std::string all;
  if (!parsed)
    for (const Diagnostic& d : parsed.diagnostics()) all += d.text() + "\n";
  return all;
}

TEST(PlotOptions, FaultsAreNamedAllAtOnce) {
  EXPECT_THAT(faults("lobes"), HasSubstr("unknown plot 'lobes'; did you mean 'lobe'?"));
  EXPECT_THAT(faults("lobe:anlge=3"), HasSubstr("unknown key 'anlge'; did you mean 'angle'?"));
  EXPECT_THAT(faults("d:channel=r"), HasSubstr("'channel' means nothing to the plot 'd'; it is for f, lobe, polar, albedo and slice"));
  EXPECT_THAT(faults("lobe:angle=30/100"), HasSubstr("--plot angle: 100 is out of range"));
  EXPECT_THAT(faults("lobe:roughness=-1,log=2,channel=red"), testing::AllOf(HasSubstr("--plot roughness"), HasSubstr("--plot log"), HasSubstr("unknown channel 'red'")));
  EXPECT_THAT(faults("lobe:log"), HasSubstr("'log' is not key=value"));
  EXPECT_THAT(faults("f:F0=2"), HasSubstr("F0 2 is out of range"));
  EXPECT_EQ(faults("LOBE:angle=0/45/90,log=1"), "");
  PlotSettings many = standardPlot(PlotKind::Lobe);
  for (int i = 0; i < 50; ++i) many.angles.push_back(static_cast<float>(i));
  EXPECT_THAT(checkPlot(many, 4, "--plot")[0].text(), HasSubstr("204 curves"));
}

TEST(PlotCommand, WritesFilesAndNumbers) {
  const auto ran = testing_support::glint({"compare", "--models", "ggx,burley:gamma=1", "--plot", "D:roughness=0.4", "--size", "480x360", "-o", "d.svg", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto document = ran.json();
  ASSERT_EQ(document["curves"].size(), 2u);
  EXPECT_EQ(document["curves"][1]["title"], "Burley (GTR), gamma 1");
  EXPECT_EQ(document["curves"][0]["x"].size(), document["curves"][0]["y"].size());
  const auto png = testing_support::glint({"compare", "--models", "ggx", "--plot", "lobe", "--set", "roughness=0.3", "--size", "400x300", "-o", "lobe.png", "--quiet"});
  ASSERT_EQ(png.code, 0) << png.err;
  const auto notes = readImageNotes(scratch() / "lobe.png");
  ASSERT_TRUE(notes);
  EXPECT_THAT(notes->at("Command"), HasSubstr("--plot lobe"));
  EXPECT_THAT(notes->at("Models"), HasSubstr(" ggx"));
  EXPECT_EQ(readImage8(scratch() / "lobe.png")->width, 400);
}

// A parameter that is named as an attribute is given as where spheres are drawn.
TEST(PlotCommand, TakesParametersNamedAsAttributes) {
  std::filesystem::copy_file(GLINT_TESTS_DIR "/data/brdf/brushed.brdf", scratch() / "brushed.brdf");
  const auto atMirror = [](std::vector<std::string> more, const char* models, const char* plot = "lobe") {
    more.insert(more.begin(), {"--models-dir", ".", "compare", "--models", models, "--plot", plot, "--size", "300x200", "-o", "p.png", "--json"});
    const auto ran = testing_support::glint(more);
    EXPECT_EQ(ran.code, 0) << ran.err;
    if (ran.code != 0) return 0.0;
    const auto curve = ran.json()["curves"][0];
    return curve["y"][static_cast<size_t>(std::find(curve["x"].begin(), curve["x"].end(), 45.0) - curve["x"].begin())].get<double>();
  };
  const double standard = atMirror({}, "brushed"), rough = atMirror({}, "brushed:roughness=0.8"), dark = atMirror({}, "brushed:baseColor=0.1");
  EXPECT_LT(rough, 0.7 * standard);
  EXPECT_NEAR(atMirror({}, "brushed", "lobe:roughness=0.8"), rough, 1e-6 * rough);
  EXPECT_NEAR(atMirror({"--set", "roughness=0.8"}, "brushed"), rough, 1e-6 * rough);
  EXPECT_NEAR(atMirror({"--set", "baseColor=0.1"}, "brushed"), dark, 1e-6 * dark);
  EXPECT_LT(dark, 0.3 * standard);
  EXPECT_BAD_INPUT(testing_support::glint({"--models-dir", ".", "compare", "--models", "brushed:roughness=2", "--plot", "lobe", "-o", "p.png"}), "--models", "0.01 to 1 are allowed");
  EXPECT_BAD_INPUT(testing_support::glint({"compare", "--models", "ggx:roughness=0.8", "--plot", "lobe", "-o", "p.png"}), "--models", "--set roughness=0.8 gives it to all");
}

TEST(PlotCommand, RefusesWhatIsForSpheres) {
  const auto ran = testing_support::glint({"compare", "--models", "ggx,ggxx", "--plot", "lobe:angle=91", "--sweep", "roughness=0..1:3", "--cell", "64", "--size", "20x20", "-o", "x.exr", "--set", "cavity=1"});
  EXPECT_EQ(ran.code, 2);
  for (const char* words : {"--sweep: is for rows of spheres", "roughness=0.1/0.3/0.9", "--cell", "'ggxx'", "--plot angle: 91", "--size: 20x20 is too small", "name a .png or .svg file", "no plot depends on 'cavity'"})
    EXPECT_THAT(ran.err, HasSubstr(words));
  EXPECT_THAT(testing_support::filesIn(scratch()), UnorderedElementsAre());
  EXPECT_BAD_INPUT(testing_support::glint({"compare", "--models", "ggx", "--size", "640x480", "-o", "x.png"}), "--size", "--cell");
}

}  // namespace
}  // namespace glint
