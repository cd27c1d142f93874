// glint compare: rows of spheres, one row for each model.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/analysis/plot_settings.h"
#include "app/command.h"
#include "app/commands/compare_plot.h"
#include "app/comparison_plots.h"
#include "app/comparison_report.h"
#include "app/comparison_sheet.h"
#include "app/health_text.h"
#include "app/picture_file.h"
#include "app/scene_loader.h"
#include "app/scene_options.h"
#include "app/standard_comparison.h"
#include "materials/base/files.h"
#include "materials/base/log.h"
#include "renderer/comparison.h"
#include "renderer/image_difference.h"
#include "renderer/model_health_cache.h"

namespace glint {
namespace {

constexpr int kMostCells = 1024;

void append(Diagnostics& to, const Diagnostics& from) {
  for (const Diagnostic& d : from)
    if (std::find(to.begin(), to.end(), d) == to.end()) to.push_back(d);
}

// What the options ask for, before anything is loaded.
struct Plan {
  SceneOptions scene;
  std::vector<ModelChoice> models;
  std::vector<std::string> materials;  // or
  std::vector<Sweep> sweeps;           // the first across, the second down
  std::optional<ModelChoice> against;
  int cell = 256;
  bool transpose = false;
  std::filesystem::path output, report;
  PictureKind kind = PictureKind::Display;
};

std::string describe(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& setting : settings) text += (text.empty() ? "" : ", ") + setting.name + " " + setting.text;
  return text;
}

bool same(const ModelChoice& a, const ModelChoice& b) { return a.id == b.id && describe(a.parameters) == describe(b.parameters); }

// Two equal rows compare nothing; with other parameters a model is another row, and labelled by them.
void mergeEqual(std::vector<ModelChoice>& models) {
  std::vector<ModelChoice> kept;
  for (ModelChoice& model : models) {
    if (std::any_of(kept.begin(), kept.end(), [&](const ModelChoice& k) { return same(k, model); }))
      log::report(warning("--models", fmt::format("'{}' is given twice", model.id + (model.parameters.empty() ? "" : ":" + describe(model.parameters))), "it has one row"));
    else
      kept.push_back(std::move(model));
  }
  models = std::move(kept);
}

Result<Plan> parsePlan(const Arguments& arguments) {
  Plan plan;
  Diagnostics problems;
  keep(problems, parseSceneOptions(arguments), plan.scene);
  bool sized = true;  // false once something that the sheet's size follows from is wrong
  const auto keepSize = [&](auto&& result, auto& to) {
    sized &= result.ok();
    keep(problems, std::move(result), to);
  };
  keepSize(parseModelList(arguments.get("models"), "--models"), plan.models);
  if (arguments.has("materials")) keepSize(parseNameList(arguments.get("materials"), "--materials"), plan.materials);
  for (const std::string& text : arguments.all("sweep")) {
    Sweep sweep;
    keepSize(parseSweep(text, "--sweep"), sweep);
    plan.sweeps.push_back(sweep);
  }
  if (arguments.has("materials") && arguments.has("sweep"))
    problems.push_back(error("--materials", "the columns are either materials or a sweep", "with --sweep, name one material by --material"));
  if (!arguments.has("materials") && !arguments.has("sweep")) plan.sweeps.push_back({"roughness", 0, 1, 5});
  if (arguments.has("materials") && arguments.has("material"))
    problems.push_back(error("--material", "--materials names them already", "give one of them"));
  if (plan.sweeps.size() > 2) problems.push_back(error("--sweep", fmt::format("{} sweeps", plan.sweeps.size()), "two make a grid"));
  if (plan.sweeps.size() == 2 && plan.sweeps[0].name == plan.sweeps[1].name)
    problems.push_back(error("--sweep", fmt::format("both change '{}'", plan.sweeps[0].name), "name two parameters"));
  if (arguments.has("against")) {
    std::vector<ModelChoice> one;
    keepSize(parseModelList(arguments.get("against"), "--against"), one);
    if (one.size() == 1) plan.against = one[0];
    else if (!one.empty()) problems.push_back(error("--against", fmt::format("{} models", one.size()), "name the one to compare with"));
  }
  if (arguments.has("size")) problems.push_back(error("--size", "is for a plot", "the size of a sheet follows from --cell"));
  if (arguments.has("cell")) keepSize(parseWhole(arguments.get("cell"), 16, 2048, "--cell"), plan.cell);
  plan.transpose = arguments.has("transpose");
  plan.output = arguments.get("output");
  keep(problems, checkOutput(plan.output, "--output"), plan.kind);
  if (arguments.has("report")) {
    plan.report = arguments.get("report");
    append(problems, checkOutput(plan.report, "--report", "page", {".html", ".htm"}));
  }
  if (plan.kind == PictureKind::Linear && (plan.against || !plan.report.empty()))
    problems.push_back(error("--output", "heat maps and reports are display-referred", "write a .png"));
  mergeEqual(plan.models);
  const size_t down = (plan.models.size() + (plan.against ? 1 : 0)) * (plan.sweeps.size() == 2 ? size_t(plan.sweeps[1].count) : 1);
  const size_t across = plan.sweeps.empty() ? plan.materials.size() : size_t(plan.sweeps[0].count);
  const size_t longest = std::max(down * (plan.against ? 2 : 1), across) * size_t(plan.cell);
  if (!sized) return problems;
  if (down * across > size_t(kMostCells))
    problems.push_back(error("--models", fmt::format("{} cells", down * across), fmt::format("a comparison has at most {}", kMostCells)));
  else if (longest > size_t(kLargestPictureSide))
    problems.push_back(error("--cell", fmt::format("the sheet would be {} pixels long", longest),
                             fmt::format("at most {}: choose a smaller cell or fewer of them", kLargestPictureSide)));
  if (!problems.empty()) return problems;
  return plan;
}

// The rows and columns, found and named.
struct Axes {
  std::vector<ComparisonRow> rows;
  std::vector<std::string> subtitles;   // of the rows
  std::vector<ComparisonColumn> columns;
  std::vector<int> reference;           // of each row, the row it is compared with; itself for the reference
};

Result<Axes> findAxes(const Plan& plan, const Libraries& libraries, Diagnostics& warnings) {
  Axes axes;
  Diagnostics problems;
  std::vector<ModelChoice> models = plan.models;
  size_t reference = models.size();
  if (plan.against) {
    const auto found = std::find_if(models.begin(), models.end(), [&](const ModelChoice& m) { return same(m, *plan.against); });
    reference = size_t(found - models.begin());
    if (found == models.end()) {
      models.insert(models.begin(), *plan.against);
      reference = 0;
    }
  }
  const int down = plan.sweeps.size() == 2 ? plan.sweeps[1].count : 1;
  for (size_t i = 0; i < models.size(); ++i) {
    const bool isAgainst = plan.against && same(models[i], *plan.against);
    ModelPtr model;
    keep(problems, libraries.namedModel(models[i].id, isAgainst && i == reference && plan.models.size() < models.size() ? "--against" : "--models"), model);
    if (!model) continue;
    for (int j = 0; j < down; ++j) {
      ComparisonRow row{model->title, model, models[i].parameters};
      std::string subtitle = describe(row.settings);
      if (down > 1) {
        const Sweep& sweep = plan.sweeps[1];
        row.settings.push_back({sweep.name, fmt::format("{}", sweep.value(j)), "--sweep"});
        subtitle += (subtitle.empty() ? "" : ", ") + fmt::format("{} {}", sweep.name, sweep.title(j));
      }
      axes.rows.push_back(std::move(row));
      axes.subtitles.push_back(std::move(subtitle));
      axes.reference.push_back(int(reference) * down + j);
    }
  }
  if (plan.sweeps.empty()) {
    for (const std::string& name : plan.materials) {
      MaterialPtr material;
      keep(problems, libraries.material(name, "--materials", warnings), material);
      if (material) axes.columns.push_back({material->name, material, plan.scene.settings});
    }
  } else {
    MaterialPtr material;
    if (plan.scene.material.empty()) material = std::make_shared<Material>(newMaterial("default"));
    else keep(problems, libraries.material(plan.scene.material, "--material", warnings), material);
    const Sweep& sweep = plan.sweeps[0];
    for (int i = 0; material && i < sweep.count; ++i) {
      std::vector<Setting> settings = plan.scene.settings;
      settings.push_back({sweep.name, fmt::format("{}", sweep.value(i)), "--sweep"});
      axes.columns.push_back({sweep.title(i), material, std::move(settings)});
    }
  }
  if (!problems.empty()) return problems;
  return axes;
}

// What the footer says of the light.
std::string footerOf(const Plan& plan) {
  std::string text = "environment " + std::filesystem::path(plan.scene.environment).filename().string();
  if (plan.scene.environment == "none") text = "no environment";
  if (const size_t lights = plan.scene.lights.size()) text += fmt::format(", {} light{}", lights, lights == 1 ? "" : "s");
  if (plan.scene.render.view == kFurnaceView) return "white furnace: how much of the light comes back, in the mean and farthest from 1";
  if (plan.scene.render.view == kErrorView) text += fmt::format(", against {} samples a pixel: the mean error, and how much light is too much", plan.scene.render.reference);
  else if (plan.scene.render.view != "lit") text += ", " + plan.scene.render.view;
  if (plan.scene.render.exposure != 0) text += fmt::format(", exposure {:g} EV", plan.scene.render.exposure);
  return text;
}

// A round number at or above the value: a scale to read heat maps by.
float roundUp(double value) {
  for (const double step : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75})
    if (value <= step) return float(step);
  return 1;
}

struct Cells {
  std::vector<std::vector<Image8>> pictures, heats;           // [row][column]; an empty heat for the reference
  std::vector<std::vector<ReportNumbers>> numbers;            // as heats
  std::vector<std::vector<Renderer::FurnaceShare>> furnace;   // as pictures, in the white furnace
  std::vector<std::vector<ReferenceError>> errors;            // as pictures, in the error view
  float heatWhite = 0;
};

std::string rowName(const Axes& axes, size_t row) {
  return axes.rows[row].title + (axes.subtitles[row].empty() ? "" : ", " + axes.subtitles[row]);
}

void judge(Cells& cells, const Axes& axes) {
  std::vector<std::vector<Pixels<float>>> maps(cells.pictures.size());
  double largest = 0;
  for (size_t row = 0; row < cells.pictures.size(); ++row) {
    const size_t reference = size_t(axes.reference[row]);
    maps[row].resize(cells.pictures[row].size());
    cells.numbers.emplace_back(cells.pictures[row].size());
    if (reference == row) continue;
    for (size_t column = 0; column < cells.pictures[row].size(); ++column) {
      const ImageF a = linearFromDisplay(cells.pictures[reference][column]), b = linearFromDisplay(cells.pictures[row][column]);
      Difference flipped = imageDifference(a, b, DifferenceMetric::Flip);
      ReportNumbers& numbers = cells.numbers[row][column];
      numbers = {rowName(axes, row), axes.columns[column].title, flipped.value};
      Image8 x = cells.pictures[reference][column], y = cells.pictures[row][column];
      double squares = 0;
      int most = 0;
      for (size_t i = 0; i < x.data.size(); ++i) {
        const int difference = std::abs(int(x.data[i]) - int(y.data[i]));
        squares += double(difference) * difference;
        most = std::max(most, difference);
      }
      numbers.rmse = std::sqrt(squares / double(x.data.size())) / 255;
      numbers.largest = most / 255.0;
      largest = std::max(largest, flipped.largest);
      maps[row][column] = std::move(flipped.map);
    }
  }
  cells.heatWhite = roundUp(largest);
  for (const auto& row : maps) {
    cells.heats.emplace_back();
    for (const auto& map : row) cells.heats.back().push_back(map.empty() ? Image8() : heatMap(map, cells.heatWhite));
  }
}

struct Sheet {
  std::vector<SheetRow> rows;
  SheetText text;
};

Sheet layOut(const Plan& plan, const Axes& axes, const Cells& cells) {
  Sheet sheet;
  sheet.text.footer = footerOf(plan);
  sheet.text.heatWhite = cells.heatWhite;
  if (!cells.errors.empty()) sheet.text.errorScale = plan.scene.render.errorScale;
  const bool across = plan.transpose;
  const size_t rows = across ? axes.columns.size() : axes.rows.size(), columns = across ? axes.rows.size() : axes.columns.size();
  const auto row = [&](size_t r, size_t c) { return across ? c : r; };
  const auto column = [&](size_t r, size_t c) { return across ? r : c; };
  if (!plan.sweeps.empty() && !across) sheet.text.axis = plan.sweeps[0].name;
  for (size_t c = 0; c < columns; ++c) {
    std::string title = across ? axes.rows[c].title : axes.columns[c].title;
    if (across && !axes.subtitles[c].empty()) title += ", " + axes.subtitles[c];
    sheet.text.columns.push_back(title);
  }
  for (size_t r = 0; r < rows; ++r) {
    SheetRow pictures, heats;
    pictures.title = across ? axes.columns[r].title : axes.rows[r].title;
    if (across && !plan.sweeps.empty()) pictures.title = plan.sweeps[0].name + " " + pictures.title;
    if (!across) pictures.subtitle = axes.subtitles[r];
    heats.heat = true;
    if (plan.against) heats.title = "against " + plan.against->id;
    bool any = false;
    for (size_t c = 0; c < columns; ++c) {
      pictures.cells.push_back(cells.pictures[row(r, c)][column(r, c)]);
      if (!cells.errors.empty()) pictures.captions.push_back(errorText(cells.errors[row(r, c)][column(r, c)]));
      if (!cells.furnace.empty()) pictures.captions.push_back(furnaceText(cells.furnace[row(r, c)][column(r, c)]));
      if (!plan.against) continue;
      const Image8& heat = cells.heats[row(r, c)][column(r, c)];
      const ReportNumbers& numbers = cells.numbers[row(r, c)][column(r, c)];
      any |= !heat.empty();
      heats.cells.push_back(heat);
      heats.captions.push_back(heat.empty() ? "" : numbers.largest == 0 ? "identical" : fmt::format("FLIP\u00a0{:.3f}   RMSE\u00a0{:.3f}", numbers.flip, numbers.rmse));
    }
    sheet.rows.push_back(std::move(pictures));
    if (any) sheet.rows.push_back(std::move(heats));
  }
  return sheet;
}

// The cells alone, with thin gaps, for linear files.
ImageF linearGrid(const std::vector<ImageF>& strips, int gap) {
  ImageF grid(strips[0].width, int(strips.size()) * (strips[0].height + gap) - gap, strips[0].channels);
  for (size_t i = 0; i < strips.size(); ++i)
    std::copy(strips[i].data.begin(), strips[i].data.end(), grid.at(0, int(i) * (strips[0].height + gap)));
  return grid;
}

nlohmann::ordered_json documentOf(const Plan& plan, const Axes& axes, const Cells& cells, glm::ivec2 size) {
  nlohmann::ordered_json document;
  document["file"] = plan.output.string();
  if (!plan.report.empty()) document["report"] = plan.report.string();
  document["width"] = size.x;
  document["height"] = size.y;
  for (const ComparisonRow& row : axes.rows) document["models"].push_back(row.model->id);
  for (const ComparisonColumn& column : axes.columns) document["columns"].push_back(column.title);
  for (size_t row = 0; row < cells.furnace.size(); ++row)
    for (size_t column = 0; column < cells.furnace[row].size(); ++column) {
      const Renderer::FurnaceShare& share = cells.furnace[row][column];
      document["furnace"].push_back({{"row", rowName(axes, row)}, {"column", axes.columns[column].title}, {"mean", share.mean},
                                     {"least", share.least}, {"most", share.most}});
    }
  for (size_t row = 0; row < cells.errors.size(); ++row)
    for (size_t column = 0; column < cells.errors[row].size(); ++column) {
      const ReferenceError& error = cells.errors[row][column];
      document["errors"].push_back({{"row", rowName(axes, row)}, {"column", axes.columns[column].title}, {"mean", error.mean}, {"noise", error.noise}, {"light", error.light}});
    }
  if (plan.against) {
    document["against"] = plan.against->id;
    document["differences"] = nlohmann::ordered_json::array();
    for (const auto& row : cells.numbers)
      for (const ReportNumbers& n : row)
        if (!n.column.empty())
          document["differences"].push_back({{"row", n.row}, {"column", n.column}, {"flip", n.flip}, {"rmse", n.rmse}, {"max", n.largest}});
  }
  return document;
}

int run(const Arguments& arguments) {
  if (arguments.has("plot")) {
    auto models = parseModelList(arguments.get("models"), "--models");
    if (models) mergeEqual(*models);
    return plotComparison(arguments, models);
  }
  auto plan = parsePlan(arguments);
  if (!plan) return badInput(plan.diagnostics());
  if (!plan->scene.backgroundGiven) {
    plan->scene.render.background = Background::Color;
    plan->scene.render.backgroundColor = glm::vec3(0.0176f);  // the sheet's own ground: a dark grey that black stands out from
  }
  Libraries libraries(arguments.modelFolders);
  log::report(libraries.models.warnings());
  log::report(tonemapWarning(arguments, plan->output, plan->kind));
  Diagnostics problems, warnings;
  Axes axes;
  Scene stage;
  keep(problems, findAxes(*plan, libraries, warnings), axes);
  keep(problems, loadStage(plan->scene, warnings), stage);
  if (!plan->scene.mesh.empty()) {
    LoadedMesh mesh;
    keep(problems, loadMesh(plan->scene.mesh, "--mesh", libraries.textures, warnings), mesh);
    stage.instances = std::move(mesh.instances);
  }
  if (!problems.empty()) return badInput(problems);
  auto comparison = makeComparison(stage, axes.rows, axes.columns, "--set", libraries.sources(), warnings);
  if (!comparison) return badInput(comparison.diagnostics());
  if (hasErrors(warnings)) return badInput(warnings);
  log::report(warnings);
  if (!plan->scene.mesh.empty() && plan->scene.mesh != "sphere") comparison->camera = frameScene(comparison->scene(0, 0), 1);
  plan->scene.camera.apply(comparison->camera);

  auto context = gl::Context::create({.backend = arguments.backend});
  if (!context) {
    log::report(context.diagnostics());
    return kNoContext;
  }
  Renderer renderer(**context);
  renderer.setProgress(log::progress);
  // A row at a time: the memory that a sheet takes does not grow with its rows.
  Cells cells;
  std::vector<ImageF> strips;
  Diagnostics drawn;
  int invalidPixels = 0;
  const int gap = 8;
  for (int row = 0; row < comparison->rows(); ++row) {
    CellGrid strip{1, comparison->columns(), plan->cell, gap, gap};
    std::vector<View> views;
    for (int column = 0; column < comparison->columns(); ++column)
      views.push_back({&comparison->scene(row, column), comparison->camera, strip.rectangle(0, column)});
    if (plan->kind == PictureKind::Linear) {
      strips.push_back(renderer.linear(views, strip.size(), plan->scene.render));
    } else {
      const Image8 picture = renderer.picture(views, strip.size(), plan->scene.render);
      cells.pictures.emplace_back();
      for (const View& view : views) cells.pictures.back().push_back(cutCell(picture, view.rectangle));
    }
    if (hasErrors(renderer.problems())) return badInput(renderer.problems());
    append(drawn, renderer.problems());
    invalidPixels += renderer.statistics().invalidPixels;
    if (plan->scene.render.view == kErrorView) cells.errors.push_back(renderer.referenceErrors(views, strip.size()));
    if (plan->scene.render.view == kFurnaceView) cells.furnace.push_back(renderer.furnaceShares(views, strip.size(), plan->scene.render.compensate));
    log::progress("comparing", double(row + 1) / comparison->rows());
  }

  log::report(drawn);
  if (invalidPixels > 0) log::report(invalidPixelsWarning(plan->output, invalidPixels));

  const ImageNotes notes = pictureNotes(arguments, **context, comparison->scenes);
  glm::ivec2 size{0};
  if (plan->kind == PictureKind::Linear) {
    const ImageF grid = linearGrid(strips, gap);
    size = {grid.width, grid.height};
    if (const Diagnostics faults = writeImageF(plan->output, grid, notes); !faults.empty()) return badInput(faults);
  } else {
    if (plan->against) judge(cells, axes);
    const Sheet sheet = layOut(*plan, axes, cells);
    const Image8 picture = comparisonSheet(sheet.rows, sheet.text);
    size = {picture.width, picture.height};
    if (!plan->report.empty()) {
      std::vector<ReportNumbers> numbers;
      for (const auto& row : cells.numbers)
        std::copy_if(row.begin(), row.end(), std::back_inserter(numbers), [](const ReportNumbers& n) { return !n.column.empty(); });
      std::vector<ModelHealth> health;
      for (const ComparisonRow& row : axes.rows)
        if (std::none_of(health.begin(), health.end(), [&](const ModelHealth& card) { return card.model == row.model->id && card.file == row.model->file.string(); }))
          health.push_back(healthOf(*row.model));
      const auto plots = comparisonPlots(axes.rows);
      if (!plots) return badInput(plots.diagnostics());
      const auto html = comparisonReport("Comparison of shading models", sheet.rows, sheet.text, plan->against ? plan->against->id : "", numbers, health, *plots, notes);
      if (!html) return badInput(html.diagnostics());
      if (const Diagnostics faults = writeFileAtomic(plan->report, *html); !faults.empty()) return badInput(faults);
    }
    if (const Diagnostics faults = writeImage8(plan->output, picture, notes); !faults.empty()) return badInput(faults);
  }
  if (arguments.json) {
    fmt::print("{}\n", documentOf(*plan, axes, cells, size).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!arguments.quiet) {
    fmt::print("{}\n", plan->output.string());
  }
  return kDone;
}

std::string plotHelp() {
  std::string keys;
  for (const PlotKey& key : plotKeys()) keys += fmt::format("; {}={}", key.name, key.doc);
  return fmt::format("curves instead of spheres, of {}{}", fmt::join(plotKindNames(), ", "), keys);
}

std::vector<Option> options() {
  std::vector<Option> all = {
      {"--models", "A,B,..", "a row for each shading model: ids, mixes or files; parameters as burley:gamma=2", false, true},
      {"-o,--output", "OUT", "the sheet (.png), the cells alone (.exr, .hdr, .pfm: linear), or a plot (.png, .svg)", false, true},
      {"--materials", "M1,M2,..", "a column for each material: library names or .json files"},
      {"--sweep", "NAME=FROM..TO:COUNT", "a column for each value of an attribute or parameter, a second sweep goes down (repeatable); roughness=0..1:5 where nothing says what the columns are", true},
      {"--against", "ID", "heat maps and numbers of the difference to this model"},
      {"--cell", "N", "pixels of a cell's side, 16..2048 (256)"},
      {"--transpose", "", "models across, as in the thesis' figure 5.2"},
      {"--report", "OUT.html", "also the comparison as one self-contained page"},
      {"--plot", "KIND[:K=V,..]", plotHelp()},
      {"--size", "WxH", "of a plot (900x600)"},
  };
  // What `render` has for one scene and a comparison says otherwise.
  for (Option& option : sceneOptionTable())
    if (option.name != "--model" && option.name != "--size" && option.name != "--ground") all.push_back(std::move(option));
  return all;
}

}  // namespace

extern const Command kCompareCommand;
const Command kCompareCommand = {
    .name = "compare",
    .summary = "Compare shading models on rows of spheres",
    .options = options(),
    .examples = {"glint compare --models blinn-phong,cook-torrance,burley,ggx --materials aluminium,rubber,black -o fig52.png",
                 "glint compare --models ggx,burley --sweep roughness=0..1:5 --set metallic=1 -o roughness.png",
                 "glint compare --models ggx --sweep roughness=0..1:5 --sweep metallic=0..1:5 -o grid.png",
                 "glint compare --models ggx,beckmann,'GGX*SmithGGX*Schlick' --plot lobe:roughness=0.3,angle=60,log=1 -o lobe.svg",
                 "glint compare --models ggx,burley:gamma=1 --plot albedo:roughness=0.1/0.5 -o albedo.png",
                 "glint compare --models burley:gamma=1,burley:gamma=2 --against ggx --sweep roughness=0.1..0.9:5 -o gamma.png --report gamma.html"},
    .run = run,
};

int renderStandardComparison(const Arguments& arguments, const std::filesystem::path& file) {
  Arguments standard = arguments;
  standard.backend = arguments.backend == gl::Backend::Glfw ? gl::Backend::Auto : arguments.backend;
  standard.values = {{"models", {"blinn-phong,cook-torrance,burley,ggx"}}, {"materials", {"aluminium,rubber,black"}}, {"output", {file.string()}}};
  standard.commandLine = fmt::format("glint compare --models {} --materials {} -o {}", standard.get("models"), standard.get("materials"), file.string());
  return run(standard);
}

}  // namespace glint
