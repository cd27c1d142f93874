#include "renderer/environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "materials/base/hash.h"
#include "renderer/image_io.h"

namespace glint {

std::vector<std::string> environmentNames() { return {"studio", "sky", "furnace", "none"}; }

glm::vec3 environmentDirection(int x, int y, int width, int height) {
  const float around = glm::two_pi<float>() * ((float(x) + 0.5f) / float(width) - 0.5f);
  const float down = glm::pi<float>() * (float(y) + 0.5f) / float(height);
  return {std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
}

namespace {

EnvironmentPtr made(std::string name, ImageF pixels) {
  auto environment = std::make_shared<Environment>();
  environment->name = std::move(name);
  environment->hash = hashBytes(pixels.data.data(), pixels.data.size() * sizeof(float), uint64_t(pixels.width));
  environment->pixels = std::move(pixels);
  return environment;
}

ImageF furnacePixels() {
  ImageF image(64, 32, 3);
  std::fill(image.data.begin(), image.data.end(), 1.0f);
  return image;
}

// What keeps a picture from being an environment.
Diagnostics check(const ImageF& image, const std::string& place) {
  Diagnostics problems;
  if (image.width != 2 * image.height)
    problems.push_back(error(place, fmt::format("is {} x {} pixels, not twice as wide as high", image.width, image.height),
                             "an environment is one equirectangular picture of the whole sphere"));
  // The sun has 2e9 nits; sums of a thousand times that stay finite.
  constexpr float kBrightest = 1e12f;
  size_t bad = 0, first = 0;
  for (size_t i = 0; i < image.data.size(); ++i)
    if (!(image.data[i] >= 0 && image.data[i] <= kBrightest)) {
      if (bad++ == 0) first = i;
    }
  if (bad > 0) {
    const float v = image.data[first];
    const size_t pixel = first / 3;
    problems.push_back(error(
        place,
        fmt::format("pixel ({}, {}), counted from the top left, is {} in {}{}", pixel % size_t(image.width),
                    pixel / size_t(image.width), std::isnan(v) ? "NaN" : std::isinf(v) ? "infinite" : fmt::format("{:g}", v),
                    std::array{"red", "green", "blue"}[first % 3],
                    bad > 1 ? fmt::format(", and {} more values are NaN, negative or above 1e12", bad - 1) : ""),
        "light is from 0 to 1e12 nits: clamp the picture and save it again"));
  }
  return problems;
}

}  // namespace

Result<EnvironmentPtr> loadEnvironment(const std::string& nameOrFile) {
  if (nameOrFile == "none") return EnvironmentPtr{};
  if (nameOrFile == "studio") return made(nameOrFile, studioPixels());
  if (nameOrFile == "sky") return made(nameOrFile, skyPixels());
  if (nameOrFile == "furnace") return made(nameOrFile, furnacePixels());

  const std::filesystem::path path(nameOrFile);
  std::error_code code;
  if (!std::filesystem::exists(path, code)) {
    const std::string near = nearest(nameOrFile, environmentNames());
    return error(nameOrFile, "no such environment or file",
                 near.empty() ? "name a .hdr, .exr or .pfm file, studio, sky, furnace or none"
                              : fmt::format("did you mean '{}'?", near));
  }
  Result<ImageF> image = readImageF(path);
  if (!image) return image.diagnostics();
  Diagnostics problems = check(*image, nameOrFile);
  if (!problems.empty()) return problems;
  return made(path.filename().string(), std::move(*image));
}

}  // namespace glint
