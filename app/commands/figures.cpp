// glint figures: the figures of Karis' notes, each approximation beside its reference and with its error.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/comparison_sheet.h"
#include "app/figures.h"
#include "app/health_text.h"
#include "app/picture_file.h"
#include "app/scene_loader.h"
#include "app/scene_options.h"
#include "materials/base/files.h"
#include "materials/base/log.h"
#include "renderer/comparison.h"
#include "renderer/environment_lighting.h"
#include "renderer/model_integrals.h"

namespace glint {
namespace {

constexpr int kTableFigure = 3;
constexpr const char* kTableName = "environment-brdf";
constexpr float kGround = 0.0176f;   // linear, on which black and grey stand out

struct Plan {
  std::vector<int> numbers;
  std::filesystem::path folder;
  std::string model;
  int cell = 160, reference = 1024;
  float errorScale = 0.25f;
};

Result<Plan> parsePlan(const Arguments& arguments) {
  Plan plan;
  Diagnostics problems;
  std::vector<int> known = {kTableFigure};
  for (const Figure& figure : figures()) known.push_back(figure.number);
  for (const std::string& text : arguments.all("figures")) {
    const auto found = std::find_if(known.begin(), known.end(), [&](int number) { return text == std::to_string(number); });
    if (found != known.end()) plan.numbers.push_back(*found);
    else problems.push_back(error("figures", fmt::format("'{}' is not a figure that is drawn", text), fmt::format("there are {}", fmt::join(known, ", "))));
  }
  if (plan.numbers.empty()) plan.numbers = known;
  plan.folder = arguments.get("output");
  plan.model = arguments.get("model", "ggx");
  if (arguments.has("cell")) keep(problems, parseWhole(arguments.get("cell"), 32, 1024, "--cell"), plan.cell);
  if (arguments.has("reference")) keep(problems, parseWhole(arguments.get("reference"), 2, kMostReferenceSamples, "--reference"), plan.reference);
  float percent = 0;
  if (arguments.has("error-scale") && keep(problems, parseNumber(arguments.get("error-scale"), 0.01f, 1000, "--error-scale"), percent)) plan.errorScale = percent / 100;
  std::error_code code;
  std::filesystem::create_directories(plan.folder, code);
  if (code) problems.push_back(error("--output", fmt::format("'{}' cannot be made: {}", plan.folder.string(), code.message()), "name a folder"));
  if (!problems.empty()) return problems;
  return plan;
}

// What was measured of one cell.
struct Number {
  std::string row, column;
  ReferenceError error;
};

struct Drawn {
  std::vector<SheetRow> rows;
  SheetText text;
  std::vector<Number> numbers;
};

class Drawing {
 public:
  Drawing(const Plan& plan, Libraries& libraries, Renderer& renderer) : plan_(plan), libraries_(libraries), renderer_(renderer) {}

  Result<Drawn> scenes(const Figure&);
  Result<Drawn> table();

 private:
  struct Strip {
    std::vector<Scene> scenes;
    std::vector<View> views;
    RenderSettings settings;
    glm::ivec2 size{0};
  };
  Result<Strip> strip(const Figure&, const FigureStrip&);
  std::vector<Image8> cut(const Strip&, const Image8& picture) const;

  const Plan& plan_;
  Libraries& libraries_;
  Renderer& renderer_;
};

// What a user would give to draw one cell.
Arguments argumentsOf(std::initializer_list<const std::vector<FigureOption>*> layers, const Plan& plan) {
  Arguments arguments;
  for (const auto* layer : layers)
    for (const FigureOption& option : *layer) {
      auto& values = arguments.values[option.name];
      if (option.value.empty()) values.clear();
      else values.push_back(option.value);
    }
  arguments.values["model"] = {plan.model};
  if (arguments.has("split-sum")) arguments.values["reference"] = {std::to_string(plan.reference)};
  arguments.values["background"] = {fmt::format("{0}/{0}/{0}", kGround)};
  return arguments;
}

Result<Drawing::Strip> Drawing::strip(const Figure& figure, const FigureStrip& row) {
  Strip made;
  Diagnostics problems, warnings;
  const int columns = static_cast<int>(figure.columns.size());
  const CellGrid grid{1, columns, plan_.cell, 8, 8};
  made.size = grid.size();
  std::vector<Camera> cameras;
  for (const FigureStrip& column : figure.columns) {
    const auto options = parseSceneOptions(argumentsOf({&figure.scene, &column.options, &row.options}, plan_));
    if (!options) return options.diagnostics();
    auto scene = loadScene(*options, libraries_, warnings);
    if (!scene) return scene.diagnostics();
    made.settings = options->render;
    Camera camera = options->mesh.empty() ? comparisonCamera() : frameScene(*scene, 1);
    options->camera.apply(camera);
    cameras.push_back(camera);
    made.scenes.push_back(std::move(*scene));
  }
  made.settings.errorScale = plan_.errorScale;
  for (int i = 0; i < columns; ++i) made.views.push_back({nullptr, cameras[size_t(i)], grid.rectangle(0, i)});
  return made;
}

std::vector<Image8> Drawing::cut(const Strip& strip, const Image8& picture) const {
  std::vector<Image8> cells;
  for (const View& view : strip.views) cells.push_back(cutCell(picture, view.rectangle));
  return cells;
}

Image8 errorPicture(const ImageF& about, const ImageF& truth, float scale) {
  Image8 picture(about.width, about.height, 3);
  for (int y = 0; y < about.height; ++y)
    for (int x = 0; x < about.width; ++x) {
      const double a = luminanceOf(about.at(x, y)), r = luminanceOf(truth.at(x, y));
      const glm::vec3 color = errorColor(static_cast<float>((a - r) / std::max(r, double(kErrorFloor)) / scale));
      for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = static_cast<uint8_t>(std::lround(255 * srgbFromLinear(color[c])));
    }
  return picture;
}

Result<Drawn> Drawing::scenes(const Figure& figure) {
  Drawn drawn;
  drawn.text.footer = fmt::format("Figure {} of the notes (Karis 2013): {}", figure.number, figure.doc);
  drawn.text.errorScale = plan_.errorScale;
  for (const FigureStrip& column : figure.columns) drawn.text.columns.push_back(column.title);
  const auto look = [](Strip& strip) {
    for (size_t i = 0; i < strip.views.size(); ++i) strip.views[i].scene = &strip.scenes[i];
  };
  const auto failed = [&] { return hasErrors(renderer_.problems()); };
  // Light without a reference of its own is one that nothing approximates: it is exact as it is drawn.
  const bool monteCarlo = figure.truth.options.empty();
  auto truth = strip(figure, figure.truth);
  if (!truth) return truth.diagnostics();
  look(*truth);
  if (monteCarlo) truth->settings.reference = plan_.reference;
  drawn.rows.push_back({figure.truth.title, monteCarlo ? fmt::format("{} samples a pixel", plan_.reference) : "", cut(*truth, renderer_.picture(truth->views, truth->size, truth->settings)), {}, false});
  if (failed()) return renderer_.problems();
  ImageF exact;
  if (!monteCarlo) exact = renderer_.linear(truth->views, truth->size, truth->settings);
  for (const FigureStrip& row : figure.approximations) {
    auto about = strip(figure, row);
    if (!about) return about.diagnostics();
    look(*about);
    drawn.rows.push_back({row.title, "", cut(*about, renderer_.picture(about->views, about->size, about->settings)), {}, false});
    Image8 picture;
    std::vector<ReferenceError> errors;
    if (monteCarlo) {
      about->settings.view = kErrorView;
      about->settings.reference = plan_.reference;
      picture = renderer_.picture(about->views, about->size, about->settings);
      errors = renderer_.referenceErrors(about->views, about->size);
    } else {
      const ImageF light = renderer_.linear(about->views, about->size, about->settings);
      picture = errorPicture(light, exact, plan_.errorScale);
      for (const View& view : about->views) {
        ReferenceErrorSum sum;
        const glm::ivec4 r = view.rectangle;
        for (int y = r.y; y < r.y + r.w; ++y)
          for (int x = r.x; x < r.x + r.z; ++x) {
            const double truthHere = luminanceOf(exact.at(x, about->size.y - 1 - y));
            sum.add(luminanceOf(light.at(x, about->size.y - 1 - y)), truthHere, truthHere);
          }
        errors.push_back(sum.error());
      }
    }
    if (failed()) return renderer_.problems();
    SheetRow error{"error", "", cut(*about, picture), {}, true};
    for (size_t i = 0; i < errors.size(); ++i) {
      error.captions.push_back(errorText(errors[i]));
      drawn.numbers.push_back({row.title, figure.columns[i].title, errors[i]});
    }
    drawn.rows.push_back(std::move(error));
  }
  return drawn;
}

// The environment BRDF of the model: its scale A in red, its bias B in green, over NoV to the right and roughness upwards.
Result<Drawn> Drawing::table() {
  const auto model = libraries_.namedModel(plan_.model, "--model");
  if (!model) return model.diagnostics();
  const auto made = renderer_.environmentLighting().brdf(modelSetting(**model));
  if (!made) return made.diagnostics();
  if (made->colored) return error("--model", fmt::format("figure 3 of '{}' has a colour of its own", plan_.model), "choose a model whose table is grey, or other figures");
  constexpr int n = EnvironmentLighting::kBrdfSize;
  std::vector<glm::vec4> texels(size_t{n} * n);
  glGetTextureImage(made->texture, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
  auto integrals = ModelIntegrals::of(**model);
  if (!integrals) return integrals.diagnostics();
  const int cell = plan_.cell;
  std::vector<IntegralQuery> queries;
  const auto coordinate = [&](int i) { return (static_cast<float>(i) + 0.5f) / static_cast<float>(cell); };
  for (int y = 0; y < cell; ++y)
    for (int x = 0; x < cell; ++x) queries.push_back({.roughness = 1 - coordinate(y), .NoV = coordinate(x), .analyticLight = false});
  const auto exact = integrals->evaluate(queries);
  Image8 table(cell, cell, 3), truth(cell, cell, 3), off(cell, cell, 3);
  ReferenceErrorSum sum;
  double largest = 0;
  size_t i = 0;
  const auto byte = [](double linear) { return static_cast<uint8_t>(std::lround(255 * std::clamp(linear, 0.0, 1.0))); };
  for (int y = 0; y < cell; ++y)
    for (int x = 0; x < cell; ++x, ++i) {
      const float u = queries[i].NoV * (n - 1), v = queries[i].roughness * (n - 1);
      const int a = std::min(static_cast<int>(u), n - 2), b = std::min(static_cast<int>(v), n - 2);
      const auto texel = [&](int p, int q) { return texels[size_t(q) * n + size_t(p)]; };
      const glm::vec4 found = glm::mix(glm::mix(texel(a, b), texel(a + 1, b), u - float(a)), glm::mix(texel(a, b + 1), texel(a + 1, b + 1), u - float(a)), v - float(b));
      const double bias = exact[i].specularBlack.g, scale = exact[i].specular.g - bias;
      for (const auto& [image, red, green] : {std::tuple(&table, double(found.x), double(found.y)), std::tuple(&truth, scale, bias)}) {
        image->at(x, y)[0] = byte(red);
        image->at(x, y)[1] = byte(green);
        image->at(x, y)[2] = 0;
      }
      const double error = double(found.x) + double(found.y) - exact[i].specular.g;
      largest = std::max(largest, std::abs(error));
      sum.add(double(found.x) + double(found.y), exact[i].specular.g, exact[i].specular.g);
      const glm::vec3 color = errorColor(static_cast<float>(error / exact[i].specular.g / plan_.errorScale));
      for (int c = 0; c < 3; ++c) off.at(x, y)[c] = static_cast<uint8_t>(std::lround(255 * srgbFromLinear(color[c])));
    }
  Drawn drawn;
  drawn.text.columns = {"Exact", "Glint's table", "error"};
  drawn.text.errorScale = plan_.errorScale;
  drawn.text.footer = "Figure 3 of the notes (Karis 2013): scale (red) and bias (green) of F0 in an environment, over n \u00b7 v and roughness";
  const ReferenceError error = sum.error();
  drawn.rows.push_back({(*model)->title, "", {truth, table, off}, {"", fmt::format("{0} x {0} texels", n), fmt::format("{}; at most {:.2g}", errorText(error), largest)}, false});
  drawn.numbers.push_back({"table", (*model)->id, error});
  return drawn;
}

int run(const Arguments& arguments) {
  const auto plan = parsePlan(arguments);
  if (!plan) return badInput(plan.diagnostics());
  Libraries libraries(arguments.modelFolders);
  log::report(libraries.models.warnings());
  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  Renderer renderer(**context);
  renderer.setProgress(log::progress);
  Drawing drawing(*plan, libraries, renderer);
  const auto ground = static_cast<uint8_t>(std::lround(255 * srgbFromLinear(kGround)));
  auto document = nlohmann::ordered_json::array();
  std::vector<std::string> files;
  for (const int number : plan->numbers) {
    const auto figure = std::find_if(figures().begin(), figures().end(), [&](const Figure& f) { return f.number == number; });
    auto drawn = number == kTableFigure ? drawing.table() : drawing.scenes(*figure);
    if (!drawn) return badInput(drawn.diagnostics());
    drawn->text.ground = {ground, ground, ground};
    const auto file = plan->folder / fmt::format("figure-{:02}-{}.png", number, number == kTableFigure ? kTableName : figure->name);
    if (const Diagnostics faults = writeImage8(file, comparisonSheet(drawn->rows, drawn->text), pictureNotes(arguments, **context, {})); !faults.empty()) return badInput(faults);
    nlohmann::ordered_json one = {{"figure", number}, {"file", file.string()}, {"errors", nlohmann::ordered_json::array()}};
    for (const Number& n : drawn->numbers)
      one["errors"].push_back({{"row", n.row}, {"column", n.column}, {"mean", n.error.mean}, {"noise", n.error.noise}, {"light", n.error.light}});
    document.push_back(std::move(one));
    files.push_back(file.string());
  }
  if (arguments.json) fmt::print("{}\n", document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  else if (!arguments.quiet)
    for (const std::string& file : files) fmt::print("{}\n", file);
  return kDone;
}

}  // namespace

extern const Command kFiguresCommand;
const Command kFiguresCommand = {
    .name = "figures",
    .summary = "Draw the notes' figures 3, 4, 5, 9, 10, 12 and 13, each approximation beside its reference",
    .options = {{"figures", "NUMBERS", "which of them; all otherwise", true, false},
                {"-o,--output", "FOLDER", "for the pictures, figure-NN-NAME.png", false, true},
                {"--model", "ID", "the shading model (ggx)"},
                {"--reference", "SPP", "samples a pixel of the reference (1024)"},
                {"--error-scale", "PERCENT", "the relative error of the strongest colours (25)"},
                {"--cell", "N", "pixels along a side of a sphere's square (160)"}},
    .examples = {"glint figures -o figures", "glint figures 12 13 --reference 4096 -o figures"},
    .run = run,
};

}  // namespace glint
