#include "renderer/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "materials/base/hash.h"
#include "renderer/environment_file.h"

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

}  // namespace

Result<EnvironmentPtr> loadEnvironment(const std::string& nameOrFile, Diagnostics* warnings) {
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
  auto file = readEnvironmentFile(path, kLargestEnvironmentWidth);
  if (!file) return file.diagnostics();
  if (warnings) warnings->insert(warnings->end(), file->warnings.begin(), file->warnings.end());
  return made(path.filename().string(), std::move(file->pixels));
}

}  // namespace glint
