// The list of environments as pictures: the generated ones, and the files of a folder.
#pragma once

#include <map>
#include <string>

#include "app/editor/environment_thumbnails.h"
#include "renderer/gl/objects.h"

namespace glint {

class Editor;

class EnvironmentBrowser {
 public:
  // A property's widget that opens it; true when another environment was chosen, which `environment` then is.
  bool draw(Editor&, std::string& environment);

 private:
  struct Shown {
    EnvironmentThumbnailPtr thumbnail;
    gl::Texture texture;
  };
  void opened(Editor&, const std::string& environment);
  bool cell(const std::string& name, const EnvironmentThumbnailPtr&, bool selected);
  unsigned textureOf(const std::string& name, const EnvironmentThumbnailPtr&);

  std::map<std::string, Shown> shown_;   // while it is open
  bool open_ = false;
};

}  // namespace glint
