#include "app/editor/session.h"

#include <algorithm>

#include "materials/base/files.h"

namespace glint {

void Session::addRecent(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::string name = std::filesystem::absolute(file, ignored).string();
  std::erase(recent, name);
  recent.insert(recent.begin(), name);
  if (recent.size() > 10) recent.resize(10);
}

Session Session::read(const std::filesystem::path& file) {
  Session session;
  const auto bytes = readFile(file, 1 << 20);
  if (!bytes) return session;
  const auto json = parseJson(bytes.value(), file.string());
  if (!json) return session;
  if (const Json* recent = json->find("recent"))
    for (const Json& item : recent->items)
      if (item.isString() && session.recent.size() < 10) session.recent.push_back(item.text);
  if (const Json* folder = json->find("folder")) session.folder = folder->text;
  if (const Json* folder = json->find("environmentFolder"); folder && folder->isString()) session.environmentFolder = folder->text;
  if (const Json* lights = json->find("lightGizmos"); lights && lights->isBool()) session.lightGizmos = lights->boolean;
  if (const Json* layout = json->find("layout")) session.layout = *layout;
  const Json *width = json->find("width"), *height = json->find("height");
  if (width && height && width->number >= 320 && width->number <= 16384 && height->number >= 240 && height->number <= 16384) {
    session.width = int(width->number);
    session.height = int(height->number);
  }
  return session;
}

Diagnostics Session::write(const std::filesystem::path& file) const {
  Json json = Json::object();
  Json& list = json.set("recent", Json::array());
  for (const std::string& one : recent) list.push(Json::of(one));
  json.set("folder", Json::of(folder));
  json.set("environmentFolder", Json::of(environmentFolder));
  json.set("lightGizmos", Json::of(lightGizmos));
  json.set("width", Json::of(width));
  json.set("height", Json::of(height));
  json.set("layout", layout);
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  return writeFileAtomic(file, writeJson(json));
}

}  // namespace glint
