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

// Of models that can be drawn, with a card for each id, and of files that cannot, as cards without a picture. `command` is
// what the page says it was written by. Errors: of the renderer.
Result<ModelsPage> modelsPage(Renderer&, Libraries&, const std::vector<ModelPtr>&, const std::map<std::string, ModelHealth>& cards,
                              const std::vector<ModelHealth>& unusable, const std::string& command);

}  // namespace glint
