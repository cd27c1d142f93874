#include "app/editor/preview.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace glint {
namespace {

constexpr std::pair<Tonemap, std::string_view> kTonemaps[] = {
    {Tonemap::None, "none"}, {Tonemap::Aces, "aces"}, {Tonemap::AgX, "agx"}, {Tonemap::PbrNeutral, "pbr-neutral"}};
constexpr std::pair<Background, std::string_view> kBackgrounds[] = {{Background::Environment, "env"},
                                                                    {Background::Blur, "blur"},
                                                                    {Background::None, "none"},
                                                                    {Background::Color, "color"}};

Json vec(glm::vec3 v) {
  Json json = Json::array();
  for (int i = 0; i < 3; ++i) json.push(Json::of(v[i]));
  return json;
}

Json texts(const std::vector<std::string>& all) {
  Json json = Json::array();
  for (const std::string& text : all) json.push(Json::of(text));
  return json;
}

Json orbitJson(const Orbit& orbit) {
  Json json = Json::object();
  json.set("yaw", Json::of(orbit.yaw));
  json.set("pitch", Json::of(orbit.pitch));
  json.set("distance", Json::of(orbit.distance));
  json.set("target", vec(orbit.target));
  json.set("fov", Json::of(orbit.fov));
  return json;
}

// Reads the members of one object; what does not fit leaves the value alone and warns.
struct Reader {
  const Json& json;
  const std::string& place;
  Diagnostics& warnings;

  const Json* get(const char* key, bool (Json::*is)() const, const char* wanted) const {
    const Json* found = json.find(key);
    if (!found) return nullptr;
    if ((found->*is)()) return found;
    warnings.push_back(warning(place + ":" + std::to_string(found->line), "'" + std::string(key) + "' must be " + wanted,
                               "its default is used"));
    return nullptr;
  }
  void read(const char* key, float& value, float low, float high) const {
    if (const Json* found = get(key, &Json::isNumber, "a number")) value = std::clamp(float(found->number), low, high);
  }
  void read(const char* key, int& value, int low, int high) const {
    if (const Json* found = get(key, &Json::isNumber, "a number"))
      value = int(std::clamp(found->number, double(low), double(high)));
  }
  void read(const char* key, bool& value) const {
    if (const Json* found = get(key, &Json::isBool, "true or false")) value = found->boolean;
  }
  void read(const char* key, std::string& value) const {
    if (const Json* found = get(key, &Json::isString, "a string")) value = found->text;
  }
  void read(const char* key, glm::vec3& value) const {
    const Json* found = get(key, &Json::isArray, "three numbers");
    if (!found) return;
    if (found->items.size() != 3 || !std::all_of(found->items.begin(), found->items.end(), [](const Json& j) { return j.isNumber(); })) {
      warnings.push_back(warning(place + ":" + std::to_string(found->line), "'" + std::string(key) + "' must be three numbers", "its default is used"));
      return;
    }
    for (int i = 0; i < 3; ++i) value[i] = std::clamp(float(found->items[size_t(i)].number), -1e6f, 1e6f);
  }
  void read(const char* key, std::vector<std::string>& value) const {
    const Json* found = get(key, &Json::isArray, "a list of names");
    if (!found) return;
    value.clear();
    for (const Json& item : found->items)
      if (item.isString() && value.size() < 64) value.push_back(item.text);
  }
  template <class E, size_t N>
  void read(const char* key, E& value, const std::pair<E, std::string_view> (&names)[N]) const {
    std::vector<std::string> known;
    for (const auto& [e, text] : names) known.emplace_back(text);
    if (const auto index = readName(key, known)) value = names[*index].first;
  }
  // In the order of the enumeration.
  template <class E>
  void read(const char* key, E& value, std::span<const ChoiceInfo> choices) const {
    std::vector<std::string> known;
    for (const ChoiceInfo& choice : choices) known.emplace_back(choice.id);
    if (const auto index = readName(key, known)) value = static_cast<E>(*index);
  }
  std::optional<size_t> readName(const char* key, const std::vector<std::string>& known) const {
    const Json* found = get(key, &Json::isString, "a name");
    if (!found) return std::nullopt;
    for (size_t i = 0; i < known.size(); ++i)
      if (known[i] == found->text) return i;
    warnings.push_back(warning(place + ":" + std::to_string(found->line), "unknown " + std::string(key) + " '" + found->text + "'",
                               suggestion(found->text, known)));
    return std::nullopt;
  }
};

constexpr std::pair<Preview::Subject, std::string_view> kSubjects[] = {{Preview::Subject::Comparison, "comparison"},
                                                                       {Preview::Subject::Mesh, "mesh"}};
constexpr std::pair<Preview::Columns, std::string_view> kColumns[] = {{Preview::Columns::Materials, "materials"},
                                                                      {Preview::Columns::Sweep, "sweep"}};
template <class E, size_t N>
std::string_view nameIn(E value, const std::pair<E, std::string_view> (&names)[N]) {
  for (const auto& [e, text] : names)
    if (e == value) return text;
  return "?";
}

// Angles in degrees.
Json propertyJson(const Light& light, const LightProperty& property) {
  if (property.flag) return Json::of(light.*property.flag);
  if (property.vector) return vec(light.*property.vector);
  const float number = light.*property.number;
  return Json::of(property.unit == LightProperty::Unit::Degrees ? glm::degrees(number) : number);
}

std::optional<Light> readLight(const Json& json, const std::string& place, Diagnostics& warnings) {
  Light light;
  std::string kind = infoOf(light.kind).id;
  const Reader reader{json, place, warnings};
  reader.read("kind", kind);
  const LightKindInfo* info = findLightKind(kind);
  if (!info) {
    std::vector<std::string> known;
    for (const LightKindInfo& k : lightKinds()) known.push_back(k.id);
    warnings.push_back(warning(place + ":" + std::to_string(json.line), "unknown kind of light '" + kind + "'", suggestion(kind, known)));
    return std::nullopt;
  }
  light.kind = info->kind;
  for (const LightProperty& property : info->properties) {
    if (property.flag) {
      reader.read(property.key, light.*property.flag);
    } else if (property.unit == LightProperty::Unit::Degrees) {
      float degrees = glm::degrees(light.*property.number);
      reader.read(property.key, degrees, glm::degrees(property.least), glm::degrees(property.most));
      light.*property.number = std::clamp(glm::radians(degrees), property.least, property.most);
    } else if (property.number) {
      reader.read(property.key, light.*property.number, property.least, property.most);
    } else {
      glm::vec3& vector = light.*property.vector;
      const glm::vec3 before = vector;
      reader.read(property.key, vector);
      if (property.unit != LightProperty::Unit::Direction) continue;
      const float length = glm::length(vector);
      vector = length > 1e-6f ? vector / length : before;
    }
  }
  return light;
}

void readOrbit(const Json& json, const char* key, Orbit& orbit, const std::string& place, Diagnostics& warnings) {
  const Json* found = json.find(key);
  if (!found || !found->isObject()) return;
  const Reader reader{*found, place, warnings};
  reader.read("yaw", orbit.yaw, -36000, 36000);
  reader.read("pitch", orbit.pitch, -89, 89);
  reader.read("distance", orbit.distance, 1e-4f, 1e6f);
  reader.read("target", orbit.target);
  reader.read("fov", orbit.fov, 1, 150);
}

}  // namespace

std::string_view name(Tonemap value) { return nameIn(value, kTonemaps); }
std::string_view name(Background value) { return nameIn(value, kBackgrounds); }

Camera Orbit::camera(float sceneRadius) const {
  Camera camera;
  const float y = glm::radians(yaw), p = glm::radians(pitch);
  camera.target = target;
  camera.eye = target + distance * glm::vec3(std::sin(y) * std::cos(p), std::sin(p), std::cos(y) * std::cos(p));
  camera.fovY = glm::radians(fov);
  camera.nearPlane = std::max(distance * 0.01f, distance - 4 * sceneRadius);
  camera.farPlane = distance + 8 * sceneRadius + glm::length(target) * 2;
  return camera;
}

bool Preview::sameSettings(const Preview& o) const {
  const auto key = [](const Preview& p) {
    return std::tie(p.subject, p.models, p.columns, p.materials, p.sweepName, p.sweepFrom, p.sweepTo, p.sweepCount,
                    p.mesh, p.ownMaterials, p.editedSlot, p.environment, p.environmentRotation, p.environmentIntensity, p.view,
                    p.exposure, p.tonemap, p.background, p.reference, p.splitSum, p.errorScale, p.compensate, p.areaLights, p.shadows, p.materialOcclusion, p.screenOcclusion, p.ground,
                    p.specularAntialiasing, p.antialiasing);
  };
  return key(*this) == key(o) && backgroundColor == o.backgroundColor && lights == o.lights;
}

Json previewJson(const Preview& p) {
  Json json = Json::object();
  json.set("subject", Json::of(std::string(nameIn(p.subject, kSubjects))));
  json.set("models", texts(p.models));
  json.set("columns", Json::of(std::string(nameIn(p.columns, kColumns))));
  json.set("materials", texts(p.materials));
  Json& sweep = json.set("sweep", Json::object());
  sweep.set("name", Json::of(p.sweepName));
  sweep.set("from", Json::of(p.sweepFrom));
  sweep.set("to", Json::of(p.sweepTo));
  sweep.set("count", Json::of(p.sweepCount));
  json.set("mesh", Json::of(p.mesh));
  json.set("ownMaterials", Json::of(p.ownMaterials));
  json.set("editedSlot", Json::of(p.editedSlot));
  json.set("environment", Json::of(p.environment));
  json.set("environmentRotation", Json::of(p.environmentRotation));
  json.set("environmentIntensity", Json::of(p.environmentIntensity));
  Json& lights = json.set("lights", Json::array());
  for (const Light& light : p.lights) {
    Json& one = lights.push(Json::object());
    const LightKindInfo& info = infoOf(light.kind);
    one.set("kind", Json::of(std::string(info.id)));
    for (const LightProperty& property : info.properties) one.set(property.key, propertyJson(light, property));
  }
  json.set("view", Json::of(p.view));
  json.set("exposure", Json::of(p.exposure));
  json.set("tonemap", Json::of(std::string(name(p.tonemap))));
  json.set("background", Json::of(std::string(name(p.background))));
  json.set("backgroundColor", vec(p.backgroundColor));
  json.set("compensate", Json::of(p.compensate));
  json.set("reference", Json::of(p.reference));
  json.set("splitSum", Json::of(p.splitSum));
  json.set("errorScale", Json::of(p.errorScale));
  for (const AreaLightsInfo& info : areaLightMethods())
    if (info.method == p.areaLights) json.set("areaLights", Json::of(std::string(info.id)));
  json.set("shadows", Json::of(std::string(shadowChoices()[size_t(p.shadows)].id)));
  json.set("materialOcclusion", Json::of(p.materialOcclusion));
  json.set("screenOcclusion", Json::of(p.screenOcclusion));
  json.set("ground", Json::of(std::string(groundChoices()[size_t(p.ground)].id)));
  json.set("specularAntialiasing", Json::of(p.specularAntialiasing));
  json.set("antialiasing", Json::of(p.antialiasing));
  json.set("orbit", orbitJson(p.orbit));
  json.set("comparisonOrbit", orbitJson(p.comparisonOrbit));
  return json;
}

Preview previewFrom(const Json& json, const std::string& place, Diagnostics& warnings) {
  Preview p;
  const Reader reader{json, place, warnings};
  reader.read("subject", p.subject, kSubjects);
  reader.read("models", p.models);
  reader.read("columns", p.columns, kColumns);
  reader.read("materials", p.materials);
  if (const Json* sweep = json.find("sweep")) {
    const Reader inner{*sweep, place, warnings};
    inner.read("name", p.sweepName);
    inner.read("from", p.sweepFrom, -1e6f, 1e6f);
    inner.read("to", p.sweepTo, -1e6f, 1e6f);
    inner.read("count", p.sweepCount, 1, 16);
  }
  reader.read("mesh", p.mesh);
  reader.read("ownMaterials", p.ownMaterials);
  reader.read("editedSlot", p.editedSlot, -1, 1 << 16);
  reader.read("environment", p.environment);
  reader.read("environmentRotation", p.environmentRotation, -36000, 36000);
  reader.read("environmentIntensity", p.environmentIntensity, 0, 1e4f);
  if (const Json* lights = json.find("lights"))
    for (const Json& item : lights->items) {
      if (p.lights.size() >= 1024) break;
      if (auto light = readLight(item, place, warnings)) p.lights.push_back(*light);
    }
  reader.read("view", p.view);
  if (!findViewMode(p.view)) p.view = "lit";
  reader.read("exposure", p.exposure, -32, 32);
  reader.read("tonemap", p.tonemap, kTonemaps);
  reader.read("background", p.background, kBackgrounds);
  reader.read("backgroundColor", p.backgroundColor);
  reader.read("compensate", p.compensate);
  std::string method;
  reader.read("areaLights", method);
  reader.read("reference", p.reference);
  reader.read("splitSum", p.splitSum);
  reader.read("errorScale", p.errorScale, 1e-4f, 10);
  for (const AreaLightsInfo& info : areaLightMethods())
    if (info.id == method) p.areaLights = info.method;
  reader.read("shadows", p.shadows, shadowChoices());
  reader.read("materialOcclusion", p.materialOcclusion);
  reader.read("screenOcclusion", p.screenOcclusion);
  reader.read("ground", p.ground, groundChoices());
  reader.read("specularAntialiasing", p.specularAntialiasing);
  reader.read("antialiasing", p.antialiasing);
  readOrbit(json, "orbit", p.orbit, place, warnings);
  readOrbit(json, "comparisonOrbit", p.comparisonOrbit, place, warnings);
  return p;
}

}  // namespace glint
