#include "app/scene_options.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/value.h"

namespace glint {
namespace {

constexpr float kLargest = 1e9f;  // any length or amount of light: beyond it floats lose what is drawn

// "x/y/z"
Result<glm::vec3> parseVector(const std::string& text, const std::string& place) {
  const std::vector<std::string> parts = splitText(text, '/');
  glm::vec3 result{0};
  bool good = parts.size() == 3;
  for (int i = 0; good && i < 3; ++i) {
    const auto value = finiteNumber(parts[size_t(i)]);
    good = value && std::abs(*value) <= kLargest;
    if (good) result[i] = static_cast<float>(*value);
  }
  if (!good) return error(place, fmt::format("'{}' is not a vector", text), "write x/y/z, for example 1/2/0.5");
  return result;
}

Result<CameraChoice> parseCamera(const std::string& text) {
  const std::string place = "--camera";
  const auto keys = parseKeys(text, place, {"eye", "target", "fov", "ortho"});
  if (!keys) return keys.diagnostics();
  CameraChoice camera;
  Diagnostics problems;
  for (const auto& [key, value] : *keys) {
    if (key == "eye") keep(problems, parseVector(value, place), camera.eye);
    if (key == "target") keep(problems, parseVector(value, place), camera.target);
    float number = 0;
    if (key == "fov" && keep(problems, parseNumber(value, 1, 170, place), number)) camera.fovY = glm::radians(number);
    if (key == "ortho" && keep(problems, parseNumber(value, 1e-4f, kLargest, place), number)) camera.orthoHeight = number;
  }
  if (camera.fovY && camera.orthoHeight)
    problems.push_back(error(place, "fov and ortho exclude each other", "give one of them"));
  if (camera.eye && camera.eye == camera.target.value_or(glm::vec3(0)))
    problems.push_back(error(place, "eye and target are the same point", "move one of them"));
  if (!problems.empty()) return problems;
  return camera;
}

Result<Setting> parseAssignment(const std::string& text, const std::string& place) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    return error(place, fmt::format("'{}' is not NAME=VALUE", text), "for example roughness=0.3 or baseColor=0.8/0.1/0.1");
  return Setting{text.substr(0, equals), text.substr(equals + 1), place};
}

Result<Tonemap> parseTonemap(const std::string& text) {
  static const std::vector<std::string> names = {"none", "aces", "agx", "pbr-neutral"};
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) return error("--tonemap", fmt::format("unknown tone map '{}'", text), suggestion(text, names));
  return static_cast<Tonemap>(found - names.begin());
}

std::vector<std::string> viewNames() {
  std::vector<std::string> names;
  for (const ViewMode& mode : viewModes()) names.push_back(mode.id);
  return names;
}

Result<std::string> parseView(const std::string& text) {
  if (findViewMode(text)) return text;
  const std::string near = nearest(text, viewNames());
  return error("--view", fmt::format("unknown view '{}'", text),
               (near.empty() ? "" : fmt::format("did you mean '{}'? ", near)) + fmt::format("There are {}", fmt::join(viewNames(), ", ")));
}

}  // namespace

void CameraChoice::apply(Camera& camera) const {
  if (eye) camera.eye = *eye;
  if (target) camera.target = *target;
  if (fovY) camera.fovY = *fovY;
  if (orthoHeight) camera.orthoHeight = *orthoHeight;
  if (any()) {
    const float distance = glm::length(camera.target - camera.eye);
    camera.nearPlane = std::min(camera.nearPlane, distance * 0.01f);
    camera.farPlane = std::max(camera.farPlane, distance * 4);
  }
}

std::vector<Option> sceneOptionTable() {
  return {
      {"--mesh", "SHAPE or FILE", "sphere, plane, cube, shaderball, or a .glb or .gltf file"},
      {"--material", "M", "a material of the library by name, or a .json file"},
      {"--model", "ID[:P=V,..]", "the shading model, and values for its parameters"},
      {"--set", "NAME=VALUE", "an attribute, or a parameter of the material or model (repeatable)", true},
      {"--env", "FILE or NAME", "a .hdr or .exr file, studio (the default), sky, furnace or none"},
      {"--env-rotation", "DEG", "turns the environment about +Y"},
      {"--env-intensity", "X", "multiplies the environment"},
      {"--light", "KIND:K=V,..", "directional:dir=x/y/z,lux=X or point:pos=x/y/z,lumens=X,radius=M (10); cd=X, color=r/g/b (repeatable). A point light's falloff is (1 - (d/radius)^4)^2 / (d^2 + 1), 0 from its radius on", true},
      {"--camera", "K=V,..", "eye=x/y/z, target=x/y/z, fov=DEG or ortho=HEIGHT"},
      {"--background", "WHAT", "env, blur, none or a colour (r/g/b linear, #rrggbb)"},
      {"--size", "WxH", fmt::format("of the picture, up to {0}x{0}", kLargestPictureSide)},
      {"--view", "VIEW", fmt::format("what is shown: {} (lit)", fmt::join(viewNames(), ", "))},
      {"--exposure", "EV", "the picture is multiplied by 2^EV"},
      {"--tonemap", "NAME", "none (the default), aces, agx or pbr-neutral"},
      {"--samples", "N", fmt::format("antialiasing: pictures averaged, 1..{} (8)", kMostSamples)},
      {"--compensate", "", "give back what bounces among facets more than once (Kulla and Conty 2017); off unless the model says otherwise"},
      {"--reference", "SPP", "ground truth by Monte Carlo (not in this version)"},
  };
}

Result<Light> parseLight(const std::string& text) {
  const std::string place = "--light";
  const size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (kind == "spot" || kind == "sphere" || kind == "tube")
    return error(place, fmt::format("'{}' lights are not in this version", kind), "use directional or point");
  if (kind != "directional" && kind != "point")
    return error(place, fmt::format("unknown kind of light '{}'", kind), suggestion(kind, {"directional", "point"}));
  const bool point = kind == "point";
  const std::vector<std::string> known = point ? std::vector<std::string>{"pos", "lumens", "cd", "radius", "color"}
                                               : std::vector<std::string>{"dir", "lux", "color"};
  if (rest.empty())
    return error(place, fmt::format("a {} light needs its {}", kind, point ? "pos" : "dir"),
                 point ? "for example point:pos=0/2/2,lumens=800" : "for example directional:dir=1/1/1,lux=3.14");
  const auto keys = parseKeys(rest, place, known);
  if (!keys) return keys.diagnostics();
  Light light;
  light.kind = point ? LightKind::Point : LightKind::Directional;
  Diagnostics problems;
  bool placed = false, lumens = false, candela = false;
  for (const auto& [key, value] : *keys) {
    if (key == "dir") {
      placed = true;
      if (keep(problems, parseVector(value, place), light.direction)) {
        const float length = glm::length(light.direction);
        if (length < 1e-6f) problems.push_back(error(place, "dir has no length", "give the direction towards the light"));
        else light.direction /= length;
      }
    }
    if (key == "pos") {
      placed = true;
      keep(problems, parseVector(value, place), light.position);
    }
    if (key == "color") keep(problems, parseColor(value, place), light.color);
    if (key == "lux") keep(problems, parseNumber(value, 0, kLargest, place), light.lux);
    if (key == "radius") keep(problems, parseNumber(value, 1e-3f, kLargest, place), light.radius);
    if (key == "cd") {
      candela = true;
      keep(problems, parseNumber(value, 0, kLargest, place), light.candela);
    }
    if (key == "lumens") {
      lumens = true;
      float amount = 0;
      if (keep(problems, parseNumber(value, 0, kLargest, place), amount)) light.candela = amount / (4 * std::numbers::pi_v<float>);
    }
  }
  if (lumens && candela) problems.push_back(error(place, "lumens and cd say the same thing", "give one of them"));
  if (!placed)
    problems.push_back(error(place, fmt::format("a {} light needs its {}", kind, point ? "pos" : "dir"),
                             point ? "for example pos=0/2/2" : "for example dir=1/1/1"));
  if (!problems.empty()) return problems;
  return light;
}

Result<std::vector<ModelChoice>> parseModelList(const std::string& text, const std::string& place) {
  std::vector<ModelChoice> models;
  Diagnostics problems;
  for (const std::string& part : splitText(text, ',')) {
    const size_t colon = part.find(':'), equals = part.find('=');
    std::string parameter;
    if (equals != std::string::npos && (colon == std::string::npos || equals < colon)) {
      parameter = part;
    } else {
      models.push_back({part.substr(0, colon), {}});
      if (models.back().id.empty()) problems.push_back(error(place, fmt::format("'{}' has an empty model id", text), "write A,B or A:param=value,B"));
      if (colon == std::string::npos) continue;
      parameter = part.substr(colon + 1);
    }
    auto assignment = parseAssignment(parameter, place);
    if (!assignment)
      problems.push_back(assignment.diagnostics().front());
    else if (models.empty())
      problems.push_back(error(place, fmt::format("'{}' comes before any model", parameter), "write ID:param=value"));
    else
      models.back().parameters.push_back(std::move(*assignment));
  }
  if (!problems.empty()) return problems;
  return models;
}

Result<SceneOptions> parseSceneOptions(const Arguments& arguments) {
  SceneOptions options;
  Diagnostics problems;
  const auto given = [&](const char* name) { return arguments.has(name); };

  options.mesh = arguments.get("mesh");
  options.material = arguments.get("material");
  for (const char* name : {"mesh", "material", "env"})
    if (given(name) && arguments.get(name).empty())
      problems.push_back(error(fmt::format("--{}", name), "is empty", "give a name or a file"));
  options.environment = arguments.get("env", "studio");
  if (given("model")) {
    std::vector<ModelChoice> models;
    if (keep(problems, parseModelList(arguments.get("model"), "--model"), models)) {
      if (models.size() == 1) options.model = models[0];
      else problems.push_back(error("--model", fmt::format("{} models", models.size()), "render draws one; glint compare --models draws several"));
    }
  }
  for (const std::string& text : arguments.all("set")) {
    Setting setting;
    if (keep(problems, parseAssignment(text, "--set"), setting)) options.settings.push_back(setting);
  }
  float degrees = 0;
  if (given("env-rotation") && keep(problems, parseNumber(arguments.get("env-rotation"), -36000, 36000, "--env-rotation"), degrees))
    options.environmentRotation = glm::radians(degrees);
  if (given("env-intensity"))
    keep(problems, parseNumber(arguments.get("env-intensity"), 0, kLargest, "--env-intensity"), options.environmentIntensity);
  for (const std::string& text : arguments.all("light")) {
    Light light;
    if (keep(problems, parseLight(text), light)) options.lights.push_back(light);
  }
  if (given("camera")) keep(problems, parseCamera(arguments.get("camera")), options.camera);
  if (given("background")) {
    const std::string text = arguments.get("background");
    options.backgroundGiven = true;
    if (text == "env") options.render.background = Background::Environment;
    else if (text == "blur") options.render.background = Background::Blur;
    else if (text == "none") options.render.background = Background::None;
    else if (auto color = parseColor(text, "--background")) {
      options.render.background = Background::Color;
      options.render.backgroundColor = *color;
    } else {
      problems.push_back(error("--background", fmt::format("unknown background '{}'", text), "env, blur, none or a colour: r/g/b (linear) or #rrggbb (sRGB)"));
    }
  }
  if (given("size")) keep(problems, parseSize(arguments.get("size"), "--size"), options.size);
  if (given("view")) keep(problems, parseView(arguments.get("view")), options.render.view);
  if (given("exposure")) keep(problems, parseNumber(arguments.get("exposure"), -64, 64, "--exposure"), options.render.exposure);
  if (given("tonemap")) keep(problems, parseTonemap(arguments.get("tonemap")), options.render.tonemap);
  options.render.samples = 8;
  if (given("samples")) keep(problems, parseWhole(arguments.get("samples"), 1, kMostSamples, "--samples"), options.render.samples);
  options.render.compensate = given("compensate");
  if (given("reference")) problems.push_back(error("--reference", "the Monte Carlo reference is not in this version", "leave it out"));
  if (!problems.empty()) return problems;
  return options;
}

}  // namespace glint
