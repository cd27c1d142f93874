// glint render, compare and bench by the front door.
#include <gtest/gtest.h>

#include <fstream>
#include <glm/glm.hpp>

#include "app/command.h"
#include "materials/base/files.h"
#include "renderer/image_io.h"
#include "tests/support/program.h"

namespace glint {
namespace {

using testing_support::filesIn;
using testing_support::glint;
using testing_support::scratch;

TEST(Render, WritesAPictureThatSaysWhatMadeIt) {
  const auto ran = glint({"render", "--size", "48x32", "--samples", "1", "--env", "none", "--light", "directional:dir=0/0/1,lux=3.14159265",
                          "--set", "specular=0", "-o", "out.png", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  const auto document = ran.json();
  EXPECT_EQ(document.value("file", ""), "out.png");
  EXPECT_EQ(document.value("lights", 0), 1);
  EXPECT_EQ(document.value("invalidPixels", -1), 0);
  const auto image = readImage8(scratch() / "out.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 48);
  EXPECT_EQ(image->height, 32);
  const auto notes = readImageNotes(scratch() / "out.png");
  ASSERT_TRUE(notes);
  EXPECT_EQ(notes->at("Command").rfind("glint render --size 48x32", 0), 0u);
  EXPECT_EQ(notes->at("Software"), "Glint " GLINT_VERSION);
  EXPECT_FALSE(notes->at("OpenGL renderer").empty());
  EXPECT_NE(notes->at("Models").find(" ggx"), std::string::npos) << notes->at("Models");
  EXPECT_EQ(filesIn(scratch()), std::vector<std::string>{"out.png"});
}

// The truth beside the approximation: no samples at all away from it in the dark, and as many as may be asked for.
TEST(Render, Reference) {
  const auto picture = [](const std::string& samples, const std::string& file) {
    std::vector<std::string> arguments = {"render", "--size", "8x8", "--env", "none", "--light", "sphere:pos=1/1/2,size=0.5,cd=5", "-o", file};
    if (!samples.empty()) arguments.insert(arguments.end(), {"--reference", samples});
    const auto ran = glint(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    auto image = readImageF(scratch() / file);
    EXPECT_TRUE(image);
    double sum = 0;
    for (const float v : image->data) sum += double(v);
    return sum;
  };
  const double fast = picture("", "fast.exr"), truth = picture("65536", "truth.exr");
  EXPECT_GT(truth, 1);
  EXPECT_NEAR(fast, truth, 0.1 * truth);
  EXPECT_NEAR(picture("1", "one.exr"), truth, 0.3 * truth);
  const auto compared = glint({"compare", "--models", "ggx,burley", "--sweep", "roughness=0.2..0.8:2", "--cell", "32", "--reference", "4", "-o", "sheet.png"});
  EXPECT_EQ(compared.code, 0) << compared.err;
}

// Names are whatever a file says; none of them may stand where a format wants a word of its own.
TEST(Render, AnyNameOfAFileIsTakenDown) {
  std::ofstream(scratch() / "m.json") << R"({"glint": "material", "version": 1, "name": "Größe 日本\n\u0000 )" + std::string(300, 'x') +
                                             R"( ", "nodes": {"out": {"kind": "output"}}})";
  ImageF sky(8, 4, 3);
  for (float& v : sky.data) v = 0.5f;
  const std::string latin = "Gr\xf6\xdf" "e .hdr";
  ASSERT_TRUE(writeImageF(scratch() / latin, sky).empty());
  for (const std::string file : {"out.png", "out.exr", "out.hdr"}) {
    const auto ran = glint({"render", "m.json", "--env", latin, "--size", "8x8", "--samples", "1", "-o", file});
    EXPECT_EQ(ran.code, 0) << file << ran.err;
    if (file == "out.hdr") {
      EXPECT_TRUE(readImageF(scratch() / file));
      continue;
    }
    const auto notes = readImageNotes(scratch() / file);
    ASSERT_TRUE(notes) << notes.diagnostics()[0].text();
    const std::string& materials = notes->at("Materials");
    EXPECT_NE(materials.find("Größe 日本\\n\\x00 xxx"), std::string::npos) << materials;
    EXPECT_EQ(materials.find('\n'), std::string::npos);
    EXPECT_NE(notes->at("Environments").find("Gr\xef\xbf\xbd\xef\xbf\xbd" "e "), std::string::npos) << notes->at("Environments");
  }
}

// A white Lambert surface that faces pi lux shows 1: the unit of light, through the whole program.
TEST(Render, LinearPicturesAreInNits) {
  const auto ran = glint({"render", "--mesh", "plane", "--camera", "eye=0/0/3,target=0/0/0", "--size", "16x16", "--samples", "1", "--env", "none",
                          "--light", "directional:dir=0/0/1,lux=3.14159265", "--set", "specular=0", "--set", "baseColor=0.5/0.25/1", "-o", "out.exr"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto image = readImageF(scratch() / "out.exr");
  ASSERT_TRUE(image);
  // Schlick's Fresnel leaves something at grazing angles only; this is head on.
  EXPECT_NEAR(image->at(8, 8)[0], 0.5, 0.01);
  EXPECT_NEAR(image->at(8, 8)[1], 0.25, 0.01);
  EXPECT_NEAR(image->at(8, 8)[2], 1.0, 0.02);
}

// A plugin's own colours come through under an environment as they do under a light.
TEST(Render, ColoredModelsKeepTheirColorUnderAnEnvironment) {
  std::filesystem::create_directory(scratch() / "mine");
  std::ofstream(scratch() / "mine/tint.glsl") << R"(/*glint {"id": "tint", "terms": {"D": "GGX", "V": "SmithGGXCorrelated"}} */
vec3 F(Shading s, Parameters p) { return vec3(0.0, 1.0, 0.25) * F_Schlick(s); }
vec3 diffuse(Shading s, Parameters p) { return s.diffuseColor * vec3(0.5, 0.0, 1.0) / kPi; }
)";
  const auto center = [&](const char* metallic, const char* specular) {
    const auto ran = glint({"render", "--models-dir", "mine", "--model", "tint", "--mesh", "plane", "--camera", "eye=0/0/3,target=0/0/0", "--size",
                            "16x16", "--samples", "1", "--env", "furnace", "--set", "baseColor=1/1/1", "--set", "roughness=0.3", "--set",
                            std::string("metallic=") + metallic, "--set", std::string("specular=") + specular, "-o", "out.exr"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const auto image = readImageF(scratch() / "out.exr");
    return glm::vec3(image->at(8, 8)[0], image->at(8, 8)[1], image->at(8, 8)[2]);
  };
  const glm::vec3 metal = center("1", "0.5"), matt = center("0", "0");
  EXPECT_NEAR(metal.r, 0, 1e-3);
  EXPECT_NEAR(metal.g, 0.99, 0.01);
  EXPECT_NEAR(metal.b, 0.25, 0.01);
  EXPECT_NEAR(matt.r, 0.5, 0.01);
  EXPECT_NEAR(matt.b, 1.0, 0.01);
}

// Halfs end at 65504; a sun does not.
TEST(Render, SunsAreAsBrightAsTheyAre) {
  const auto brightest = [&](float sun) {
    ImageF image(64, 32, 3);
    for (float& v : image.data) v = 0.01f;
    for (int c = 0; c < 3; ++c) image.at(32, 10)[c] = sun;
    EXPECT_TRUE(writeImageF(scratch() / "sun.pfm", image).empty());
    const auto ran = glint({"render", "--env", "sun.pfm", "--set", "metallic=1", "--set", "roughness=0.5", "--size", "64x64", "--samples", "1", "-o", "out.exr"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const auto rendered = readImageF(scratch() / "out.exr");
    return *std::max_element(rendered->data.begin(), rendered->data.end());
  };
  const float dim = brightest(1e4f), bright = brightest(1e6f);
  EXPECT_NEAR(bright / dim, 100, 1);
}

TEST(Render, BadInputLeavesNothingBehind) {
  std::ofstream(scratch() / "broken.glb") << "glTF";
  std::ofstream(scratch() / "broken.json") << "{ \"glint\": \"material\", ";
  std::ofstream(scratch() / "text.hdr") << "no radiance";
  std::ofstream(scratch() / "notes.txt") << "";
  const auto before = filesIn(scratch());
  const std::string png = "out.png";
  EXPECT_BAD_INPUT(glint({"render"}), "--output", "is missing");
  EXPECT_BAD_INPUT(glint({"render", "none.glb", "-o", png}), "none.glb", "no such file");
  EXPECT_BAD_INPUT(glint({"render", "notes.txt", "-o", png}), "notes.txt", ".glb, .gltf or .json");
  EXPECT_BAD_INPUT(glint({"render", "--env", "text.hdr", "-o", png}), "text.hdr", "");
  EXPECT_BAD_INPUT(glint({"render", "--env", "stdio", "-o", png}), "stdio", "did you mean 'studio'?");
  EXPECT_BAD_INPUT(glint({"render", "--mesh", "spere", "-o", png}), "--mesh", "did you mean 'sphere'?");
  EXPECT_BAD_INPUT(glint({"render", "--material", "aluminum", "-o", png}), "--material", "did you mean 'aluminium'?");
  EXPECT_BAD_INPUT(glint({"render", "--model", "burly", "-o", png}), "--model", "did you mean 'burley'?");
  EXPECT_BAD_INPUT(glint({"render", "--model", "burley:gama=2", "-o", png}), "--model", "did you mean 'gamma'?");
  EXPECT_BAD_INPUT(glint({"render", "--set", "roughnes=0.2", "-o", png}), "--set", "did you mean 'roughness'?");
  EXPECT_BAD_INPUT(glint({"render", "--set", "roughness=shiny", "-o", png}), "--set", "");
  EXPECT_BAD_INPUT(glint({"render", "--size", "0x0", "-o", png}), "--size", "1 to 8192");
  EXPECT_BAD_INPUT(glint({"render", "--size", "100000x100000", "-o", png}), "--size", "1 to 8192");
  EXPECT_BAD_INPUT(glint({"render", "-o", "out.jpg"}), "--output", ".png");
  EXPECT_BAD_INPUT(glint({"render", "-o", "nowhere/out.png"}), "--output", "no folder 'nowhere'");
  for (const char* file : {"broken.glb", "broken.json"}) {
    const auto ran = glint({"render", file, "-o", png});
    EXPECT_EQ(ran.code, 2) << file;
    EXPECT_EQ(ran.err.rfind(std::string("glint: error: ") + file, 0), 0u) << ran.err;
  }
  EXPECT_EQ(filesIn(scratch()), before);
}

TEST(Render, ABrokenPluginIsNamedWithItsLine) {
  std::filesystem::create_directories(scratch() / "models");
  std::ofstream(scratch() / "models/broken.glsl") << "/*glint\n{ \"id\": \"broken\", \"title\": \"Broken\", \"doc\": \"d\", \"color\": [1, 0, 0],\n"
                                                     "  \"terms\": {\"V\": \"SmithGGX\", \"F\": \"Schlick\", \"diffuse\": \"Lambert\"} }\n*/\n"
                                                     "float D(Shading s, Parameters p) { return nonsense; }\n";
  const auto ran = glint({"render", "--models-dir", "models", "--model", "broken", "--size", "16x16", "--samples", "1", "-o", "out.png"});
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_NE(ran.err.find("broken.glsl:5"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(scratch() / "out.png"));
}

TEST(Compare, SheetReportAndNumbers) {
  const auto ran = glint({"compare", "--models", "ggx,burley:gamma=2", "--against", "ggx", "--sweep", "roughness=0.2..0.6:2", "--cell", "32", "--samples",
                          "1", "-o", "sheet.png", "--report", "page.html", "--json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto document = ran.json();
  ASSERT_EQ(document["differences"].size(), 2u);
  EXPECT_EQ(document["columns"], nlohmann::json({"0.2", "0.6"}));
  for (const auto& cell : document["differences"]) EXPECT_LT(cell["flip"].get<double>(), 0.2);
  EXPECT_EQ(filesIn(scratch()), (std::vector<std::string>{"page.html", "sheet.png"}));
  const std::string page = *readFile(scratch() / "page.html");
  for (const char* title : {"Distribution of normals D", "Visibility V", "Fresnel reflectance F", "Lobe in the plane of incidence", "Directional albedo"})
    EXPECT_NE(page.find(title), std::string::npos) << title;
  EXPECT_NE(page.find("Burley (GTR), gamma 2"), std::string::npos);
  EXPECT_EQ(page.find("<?xml"), std::string::npos);
}

// The cells of one picture are what each would be alone: a model against itself has no difference.
TEST(Compare, AModelDoesNotDifferFromItself) {
  const auto ran = glint({"compare", "--models", "ggx,ggx:", "--materials", "black", "-o", "sheet.png"});
  EXPECT_EQ(ran.code, 2);
  const auto same = glint({"compare", "--models", "burley:gamma=2,burley:gamma=2.0", "--against", "burley:gamma=2", "--sweep", "roughness=0.3..0.7:2", "--cell",
                           "24", "--samples", "1", "-o", "sheet.png", "--json"});
  ASSERT_EQ(same.code, 0) << same.err;
  const auto document = same.json();
  ASSERT_FALSE(document["differences"].empty());
  for (const auto& cell : document["differences"]) EXPECT_EQ(cell["max"].get<double>(), 0);
}

TEST(Compare, BadInput) {
  const std::string png = "out.png";
  EXPECT_BAD_INPUT(glint({"compare", "-o", png}), "--models", "is missing");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx,burly", "-o", png}), "--models", "did you mean 'burley'?");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--materials", "rubber,blck", "-o", png}), "--materials", "did you mean 'black'?");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--sweep", "roughnes=0..1:3", "-o", png}), "--sweep", "did you mean 'roughness'?");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--sweep", "roughness=0..1", "-o", png}), "--sweep", "NAME=FROM..TO:COUNT");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--sweep", "roughness=0..1:3", "--materials", "black", "-o", png}), "--materials", "either");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--cell", "0", "-o", png}), "--cell", "16 to 2048");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--cell", "2048", "-o", png}), "--cell", "at most 8192");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--against", "gx", "-o", png}), "--against", "did you mean 'ggx'?");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--against", "ggx", "-o", "out.exr"}), "--output", ".png");
  EXPECT_TRUE(filesIn(scratch()).empty());
}

TEST(Render, ValuesOutOfRangeAreRefusedOnTheCommandLine) {
  EXPECT_BAD_INPUT(glint({"render", "--set", "roughness=5", "-o", "out.png"}), "--set", "roughness 5 is out of range; 0 to 1 are allowed");
  EXPECT_BAD_INPUT(glint({"render", "--set", "roughness=abc", "-o", "out.png"}), "--set", "'abc' is not a float for roughness; write a number");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "burley:gamma=99", "-o", "out.png"}), "--models", "gamma 99 is out of range of model 'burley'; 1 to 4 are allowed");
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "--sweep", "roughness=0..2:2", "-o", "out.png"}), "--sweep", "roughness 2 is out of range");
  EXPECT_BAD_INPUT(glint({"render", "--material", "painted-metal", "--set", "Rust=7", "-o", "out.png"}), "--set", "Rust 7 is out of range");
  EXPECT_TRUE(filesIn(scratch()).empty());
}

TEST(Render, FilesOfLaterVersionsAreDrawnAsFarAsTheyCan) {
  const std::string head = R"({"glint": "material", "version": 1, "model": "burley", "modelParameters": {"gamma": 99}, "nodes": {)";
  const std::string strange = R"("x": {"kind": "nois"}}})";
  std::ofstream(scratch() / "unused.json") << head << "\n\"output\": {\"kind\": \"output\", \"inputs\": {\"roughness\": 5}},\n" << strange;
  std::ofstream(scratch() / "used.json") << head << "\n\"output\": {\"kind\": \"output\", \"inputs\": {\"roughness\": \"x.value\"}},\n" << strange;
  const auto ran = glint({"render", "unused.json", "--size", "8x8", "--env", "none", "-o", "out.png"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err,
            "glint: warning: unused.json:3: node 'x': unknown kind 'nois'; nothing uses it, it is kept; did you mean 'noise'?\n"
            "glint: warning: unused.json:2: node 'output' pin 'roughness': 5 is outside 0 to 1; the nearest is used\n"
            "glint: warning: unused.json: model parameter 'gamma' is 99, outside 1 to 4; the nearest is used\n");
  const auto refused = glint({"render", "used.json", "--size", "8x8", "--env", "none", "-o", "out.png", "--quiet"});
  EXPECT_BAD_INPUT(refused, "used.json:3", "node 'x': unknown kind 'nois'; did you mean 'noise'?");
}

TEST(Render, OutputsAreWhatTheirNamesSay) {
  EXPECT_BAD_INPUT(glint({"compare", "--models", "ggx", "-o", "out.png", "--report", "report.png"}), "--report", "'report.png' is no page; name a .html or .htm file");
  EXPECT_BAD_INPUT(glint({"compile", "rubber", "-o", "out.png"}), "--output", "'out.png' is no shader; name a .glsl, .frag or .txt file");
  EXPECT_BAD_INPUT(glint({"compile", "rubber", "-o", "none/out.glsl"}), "--output", "there is no folder 'none'");
  EXPECT_BAD_INPUT(glint({"edit", "--screenshot", "out.jpg"}), "--screenshot", "'out.jpg' is no picture");
  EXPECT_TRUE(filesIn(scratch()).empty());
  const auto ran = glint({"render", "--size", "8x8", "--env", "none", "--tonemap", "aces", "-o", "out.exr"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err, "glint: warning: --tonemap: has no effect on 'out.exr', which is linear; write a .png for a tone map\n");
}

TEST(Compare, OneModelTwice) {
  const auto ran = glint({"compare", "--models", "ggx,burley,ggx,burley:gamma=2", "--sweep", "roughness=0..1:2", "--cell", "16", "--env", "none", "-o",
                          "out.png", "--json"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err, "glint: warning: --models: 'ggx' is given twice; it has one row\n");
  EXPECT_EQ(ran.json()["models"].size(), 3u);
}

TEST(Bench, EveryCaseRunsAndIsOneDocument) {
  const auto ran = glint({"bench", "--quick", "--json", "calibrate", "frame.p16", "models", "graph.compile.10", "edit.parameter", "startup.warm"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto document = ran.json();
  ASSERT_TRUE(document.is_object()) << ran.out;
  EXPECT_FALSE(document.value("renderer", "").empty());
  ASSERT_EQ(document["cases"].size(), 6u);
  for (const auto& c : document["cases"]) {
    EXPECT_GT(c["median"].get<double>(), 0) << c;
    EXPECT_LE(c["min"].get<double>(), c["median"].get<double>());
    EXPECT_GE(c["n"].get<int>(), 1);
  }
  EXPECT_BAD_INPUT(glint({"bench", "frame.p17"}), "frame.p17", "did you mean 'frame.p16'?");
}

}  // namespace
}  // namespace glint
