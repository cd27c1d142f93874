// The page that shows every shading model on a roughness row, with its badge and what was measured of it: Markdown
// beside a picture for each model. `glint models --page` writes it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/scene_loader.h"
#include "renderer/image.h"
#include "renderer/model_health.h"
#include "renderer/renderer.h"

namespace glint {

struct ModelsPage {
  std::string text;                            // README.md; refers to pictures/ID.png
  std::map<std::string, Image8> pictures;      // by the model's id
};

// `command` is what the page says it was written by. Errors: of the renderer.
Result<ModelsPage> modelsPage(Renderer&, Libraries&, const std::vector<ModelPtr>&, const std::map<std::string, ModelHealth>& cards,
                              const std::string& command);

}  // namespace glint
