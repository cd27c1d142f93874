// glint diff: how far two pictures are apart, as a number, a verdict and a heat map.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/option_values.h"
#include "app/picture_file.h"
#include "materials/base/log.h"
#include "renderer/image_difference.h"

namespace glint {
namespace {

void append(Diagnostics& to, const Diagnostics& from) { to.insert(to.end(), from.begin(), from.end()); }

// Three channels and four compare by an alpha of one.
void giveAlpha(ImageF& image) {
  ImageF result(image.width, image.height, 4);
  for (size_t i = 0; i < result.data.size(); ++i) result.data[i] = i % 4 == 3 ? 1.0f : image.data[i / 4 * 3 + i % 4];
  image = std::move(result);
}

int run(const Arguments& arguments) {
  Diagnostics problems;
  const std::vector<std::string> files = arguments.all("pictures");
  if (files.size() != 2)
    problems.push_back(error("PICTURE", fmt::format("{} given", files.size()), "diff compares two: glint diff A.png B.png"));
  const std::string metricName = arguments.get("metric", "flip");
  const auto metric = differenceMetric(metricName);
  if (!metric)
    problems.push_back(error("--metric", fmt::format("unknown metric '{}'", metricName), suggestion(metricName, differenceMetricNames())));
  std::optional<float> limit;
  if (arguments.has("fail-above")) {
    if (const auto value = parseNumber(arguments.get("fail-above"), 0, 1e30f, "--fail-above")) limit = *value;
    else append(problems, value.diagnostics());
  }
  if (arguments.has("output")) {
    const auto kind = checkOutput(arguments.get("output"), "--output");
    if (!kind) append(problems, kind.diagnostics());
    else if (*kind != PictureKind::Display) problems.push_back(error("--output", "a heat map is display-referred", "name a .png file"));
  }
  if (!problems.empty()) return badInput(problems);

  std::vector<ReadPicture> pictures;
  for (const std::string& file : files) {
    auto picture = readPicture(file);
    if (picture) pictures.push_back(std::move(*picture));
    else append(problems, picture.diagnostics());
  }
  if (!problems.empty()) return badInput(problems);
  ImageF &a = pictures[0].pixels, &b = pictures[1].pixels;
  if (a.width != b.width || a.height != b.height)
    return badInput({error(files[1], fmt::format("is {}x{} where '{}' is {}x{}", b.width, b.height, files[0], a.width, a.height),
                           "pictures to compare have one size")});
  if (pictures[0].kind != pictures[1].kind)
    return badInput({error(files[1], "one picture is display-referred and the other linear", "compare .png with .png, .exr with .exr or .hdr")});
  if (a.channels != b.channels) giveAlpha(a.channels == 3 ? a : b);
  if (*metric == DifferenceMetric::Flip && pictures[0].kind == PictureKind::Display) {
    a = linearFromDisplay(a);
    b = linearFromDisplay(b);
  }
  const Difference difference = imageDifference(a, b, *metric);

  const bool failed = limit && difference.value > *limit;
  std::string file;
  if (arguments.has("output")) {
    file = arguments.get("output");
    // FLIP's scale is fixed; the others' is the largest difference, which the note tells.
    const float white = *metric == DifferenceMetric::Flip || difference.largest <= 0 ? 1 : float(difference.largest);
    const ImageNotes notes = {{"Software", "Glint " GLINT_VERSION},
                              {"Command", arguments.commandLine},
                              {"Metric", fmt::format("{} {:.6g}", metricName, difference.value)},
                              {"White", fmt::format("{:.6g}", white)}};
    if (const Diagnostics faults = writeImage8(file, heatMap(difference.map, white), notes); !faults.empty())
      return badInput(faults);
  }
  if (arguments.json) {
    nlohmann::ordered_json document;
    document["metric"] = metricName;
    document["value"] = difference.value;
    document["largest"] = difference.largest;
    document["at"] = {difference.x, difference.y};
    document["width"] = a.width;
    document["height"] = a.height;
    if (limit) document["limit"] = *limit;
    document["verdict"] = failed ? "fail" : "pass";
    if (!file.empty()) document["file"] = file;
    fmt::print("{}\n", document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    fmt::print("{} {:.6g}, largest {:.6g} at {},{}\n", metricName, difference.value, difference.largest, difference.x, difference.y);
    if (failed) log::info(fmt::format("{} {:.6g} is above {:g}", metricName, difference.value, *limit));
  }
  return failed ? kVerdictNo : kDone;
}

}  // namespace

extern const Command kDiffCommand;
const Command kDiffCommand = {
    .name = "diff",
    .summary = "Compare two pictures: a number, a verdict and a heat map",
    .options =
        {
            {"pictures", "PICTURE", "two .png, .jpg, .exr, .hdr or .pfm files of one size", true, true},
            {"--metric", "NAME",
             "flip: what an eye sees, 0..1 (the default; linear pictures clamped to 0..1); rmse; or max"},
            {"-o,--output", "HEAT.png", "write the difference in colours, black none to pale yellow most"},
            {"--fail-above", "X", "exit with 1 when the number is above X"},
        },
    .examples = {"glint diff before.png after.png", "glint diff a.exr b.exr --metric rmse --json",
                 "glint diff golden.png now.png --fail-above 0.01 -o heat.png"},
    .run = run,
};

}  // namespace glint
