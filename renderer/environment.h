// Environments: read from .hdr and .exr files, or made by Glint.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "renderer/scene.h"

namespace glint {

// "studio": softboxes on a dark ground, the default; "sky": a clear sky with a sun; "furnace": 1 everywhere.
std::vector<std::string> environmentNames();  // also "none"
// One of the names, "none" (gives a null pointer), or a file, mended as environment_file.h says. Errors: unreadable; a
// side over kLargestImageSide.
Result<EnvironmentPtr> loadEnvironment(const std::string& nameOrFile, Diagnostics* warnings = nullptr);

// The generated ones, height = width / 2 pixels, the same at every call. Both light a white surface that faces
// their brightest side to about 1 nit per pi lux, so that exposure 0 suits them.
ImageF studioPixels(int width = 1024);
// `sunElevation` in degrees above the horizon, 5..85; the sun stands in front and to the right of an object
// that is seen from +Z.
ImageF skyPixels(int width = 1024, float sunElevation = 42);

// The direction that the centre of a pixel of an equirectangular picture stands for (product.md 1).
glm::vec3 environmentDirection(int x, int y, int width, int height);

}  // namespace glint
