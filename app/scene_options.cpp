#include "app/scene_options.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

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

Result<AreaLights> parseAreaLights(const std::string& text) {
  std::vector<std::string> names;
  for (const AreaLightsInfo& info : areaLightMethods()) {
    if (text == info.id) return info.method;
    names.push_back(info.id);
  }
  return error("--area-lights", fmt::format("unknown method '{}'", text), suggestion(text, names));
}

// One of a list of choices, as its enumeration.
template <class E>
Result<E> parseChoice(const std::string& text, std::span<const ChoiceInfo> choices, const std::string& place) {
  std::vector<std::string> names;
  for (const ChoiceInfo& info : choices) {
    if (text == info.id) return static_cast<E>(names.size());
    names.push_back(info.id);
  }
  return error(place, fmt::format("unknown choice '{}'", text), suggestion(text, names));
}

// Which of the two occlusions count.
Result<std::pair<bool, bool>> parseOcclusion(const std::string& text) {
  if (text == "material") return std::pair(true, false);
  if (text == "screen") return std::pair(false, true);
  if (text == "both") return std::pair(true, true);
  if (text == "none") return std::pair(false, false);
  return error("--occlusion", fmt::format("unknown choice '{}'", text), suggestion(text, {"material", "screen", "both", "none"}));
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

namespace {

std::string lightHelp() {
  std::vector<std::string> kinds;
  for (const LightKindInfo& info : lightKinds()) kinds.push_back(fmt::format("{}:{}", info.id, info.example));
  return fmt::format("{} (repeatable). dir: towards a directional light, the way a spot or rectangle shines (or to=, the point it shines at); "
                     "cd=, lumens= or nits= for what has a surface; color=r/g/b; size: the radius of the source; radius=M (10): its falloff is "
                     "(1 - (d/radius)^4)^2 / (d^2 + constant), 0 from there on; constant=1", fmt::join(kinds, ", "));
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
      {"--model", "ID[:P=V,..]", "the shading model by id, as a mix or by its file, and values for its parameters"},
      {"--set", "NAME=VALUE", "an attribute, or a parameter of the material or model (repeatable)", true},
      {"--env", "FILE or NAME", "a .hdr or .exr file, studio (the default), sky, furnace or none"},
      {"--env-rotation", "DEG", "turns the environment about +Y"},
      {"--env-intensity", "X", "multiplies the environment"},
      {"--light", "KIND:K=V,..", lightHelp(), true},
      {"--area-lights", "NAME", "how lights with a surface are drawn: cosines (linearly transformed, the default), or by representative points: notes (factor 3), unreal (factor 2), specular-d or plain"},
      {"--shadows", "WHAT", "off (the default), on (soft shadow maps), or contact (and short shadows where things touch)"},
      {"--occlusion", "WHAT", "what keeps the environment's light away: material (its ambientOcclusion, the default), screen (what stands near in the picture), both or none"},
      {"--ground", "WHAT", "under the scene: none (the default), shadow (the background, darker in shadows) or matte (a grey floor that fades out)"},
      {"--camera", "K=V,..", "eye=x/y/z, target=x/y/z, fov=DEG or ortho=HEIGHT"},
      {"--background", "WHAT", "env, blur, none or a colour (r/g/b linear, #rrggbb)"},
      {"--size", "WxH", fmt::format("of the picture, up to {0}x{0}", kLargestPictureSide)},
      {"--view", "VIEW", fmt::format("what is shown: {} (lit)", fmt::join(viewNames(), ", "))},
      {"--exposure", "EV", "the picture is multiplied by 2^EV"},
      {"--tonemap", "NAME", "none (the default), aces, agx or pbr-neutral"},
      {"--samples", "N", fmt::format("antialiasing: pictures averaged, 1..{} (8)", kMostSamples)},
      {"--specular-aa", "", "widen roughness by how much the normal varies within a pixel, on bent surfaces and in normal maps, so that highlights do not glitter; never of a reference or an error"},
      {"--compensate", "", "give back what bounces among facets more than once (Kulla and Conty 2017); off unless the model says otherwise"},
      {"--reference", "SPP", fmt::format("ground truth instead of approximations: Monte Carlo with this many samples a pixel, 1..{}; without shadows", kMostReferenceSamples)},
      {"--split-sum", "", "with --reference or --view error: the environment's reflections by the split sum alone, at the true direction of view; otherwise n = v = r is assumed too"},
      {"--error-scale", "PERCENT", "of --view error, which compares with the reference (256 samples): the relative error of the strongest colours (25)"},
  };
}

namespace {

// What --light takes beside the properties of a kind (renderer/light.h).
std::vector<std::string> lightOptions(const LightKindInfo& info) {
  std::vector<std::string> known;
  for (const LightProperty& p : info.properties) known.push_back(p.option);
  if (info.kind != LightKind::Directional) known.push_back("lumens");
  if (info.kind == LightKind::Sphere || info.kind == LightKind::Tube || info.kind == LightKind::Rectangle) known.push_back("nits");
  if (info.kind == LightKind::Tube) known.push_back("from");
  if (info.kind != LightKind::Directional && info.kind != LightKind::Point && info.kind != LightKind::Sphere) known.push_back("to");
  return known;
}

void readLightProperty(const LightProperty& p, const std::string& value, const std::string& place, Light& light, Diagnostics& problems) {
  if (p.flag) {
    if (value == "on" || value == "off") light.*p.flag = value == "on";
    else problems.push_back(error(place, fmt::format("{} is '{}'", p.option, value), "write on or off"));
  } else if (p.unit == LightProperty::Unit::Color) {
    keep(problems, parseColor(value, place), light.*p.vector);
  } else if (p.vector) {
    glm::vec3& vector = light.*p.vector;
    if (!keep(problems, parseVector(value, place), vector) || p.unit != LightProperty::Unit::Direction) return;
    const float length = glm::length(vector);
    if (length < 1e-6f) problems.push_back(error(place, fmt::format("{} has no length", p.option), "give a direction, for example 1/1/1"));
    else vector /= length;
  } else if (p.unit == LightProperty::Unit::Degrees) {
    float degrees = 0;
    if (keep(problems, parseNumber(value, std::round(glm::degrees(p.least)), std::round(glm::degrees(p.most)), place), degrees))
      light.*p.number = glm::radians(degrees);
  } else {
    keep(problems, parseNumber(value, p.least, p.most, place), light.*p.number);
  }
}

}  // namespace

Result<Light> parseLight(const std::string& text) {
  const std::string place = "--light";
  const size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  const LightKindInfo* info = findLightKind(kind);
  if (!info) {
    std::vector<std::string> kinds;
    for (const LightKindInfo& k : lightKinds()) kinds.push_back(k.id);
    return error(place, fmt::format("unknown kind of light '{}'", kind), suggestion(kind, kinds));
  }
  const std::string example = fmt::format("for example {}:{}", kind, info->example);
  const char* placeKey = info->kind == LightKind::Directional ? "dir" : info->kind == LightKind::Tube ? "from and to, or its pos" : "pos";
  if (rest.empty()) return error(place, fmt::format("a {} light needs its {}", kind, placeKey), example);
  const auto keys = parseKeys(rest, place, lightOptions(*info));
  if (!keys) return keys.diagnostics();

  Light light;
  light.kind = info->kind;
  if (light.kind == LightKind::Tube) light.axis = {1, 0, 0};
  Diagnostics problems;
  std::vector<std::string> powers;
  std::optional<glm::vec3> from, to;
  bool placed = false, turned = false;
  float amount = 0;
  for (const auto& [key, value] : *keys) {
    if (key == "lumens" || key == "nits") keep(problems, parseNumber(value, 0, kLargest, place), amount);
    if (key == "lumens" || key == "nits" || key == "cd") powers.push_back(key);
    if (key == "from") keep(problems, parseVector(value, place), from.emplace());
    if (key == "to") keep(problems, parseVector(value, place), to.emplace());
    placed |= key == "pos" || (key == "dir" && light.kind == LightKind::Directional);
    turned |= key == "dir" || key == "length";
    for (const LightProperty& p : info->properties)
      if (key == p.option) readLightProperty(p, value, place, light, problems);
  }
  if (powers.size() > 1) problems.push_back(error(place, fmt::format("{} say the same thing", fmt::join(powers, " and ")), "give one of them"));
  if (light.kind == LightKind::Tube && (from || to)) {
    if (!from || !to || placed || turned) problems.push_back(error(place, "a tube goes from one end to the other", "give from and to alone, or pos, dir and length"));
    if (from && to) {
      light.position = 0.5f * (*from + *to);
      light.length = glm::length(*to - *from);
      if (light.length > 1e-6f) light.axis = (*to - *from) / light.length;
    }
    placed = true;
  } else if (to) {
    const float length = glm::length(*to - light.position);
    if (turned) problems.push_back(error(place, "dir and to say the same thing", "give one of them"));
    else if (length < 1e-6f) problems.push_back(error(place, "to is where the light is", "give the point that it shines at"));
    else light.axis = (*to - light.position) / length;
  }
  if (!placed) problems.push_back(error(place, fmt::format("a {} light needs its {}", kind, placeKey), example));
  if (light.kind == LightKind::Spot && light.innerAngle > light.outerAngle) {
    const bool given = std::any_of(keys->begin(), keys->end(), [](const KeyValue& k) { return k.key == "inner"; });
    if (given) problems.push_back(error(place, "inner is larger than outer", "the light is full up to inner and ends at outer"));
    light.innerAngle = std::min(light.innerAngle, light.outerAngle);
  }
  if (!powers.empty() && powers.back() == "lumens") light.candela = amount / std::max(lumensPerCandela(light), 1e-6f);
  if (!powers.empty() && powers.back() == "nits") {
    const float nits = nitsPerCandela(light);
    if (nits > 0) light.candela = amount / nits;
    else problems.push_back(error(place, "a light without a surface has no luminance", "give lumens or cd, or a size"));
  }
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
  if (given("area-lights")) keep(problems, parseAreaLights(arguments.get("area-lights")), options.render.areaLights);
  if (given("shadows")) keep(problems, parseChoice<Shadows>(arguments.get("shadows"), shadowChoices(), "--shadows"), options.render.shadows);
  if (given("occlusion")) {
    std::pair<bool, bool> both;
    if (keep(problems, parseOcclusion(arguments.get("occlusion")), both)) std::tie(options.render.materialOcclusion, options.render.screenOcclusion) = both;
  }
  if (given("ground")) keep(problems, parseChoice<Ground>(arguments.get("ground"), groundChoices(), "--ground"), options.ground);
  if (given("tonemap")) keep(problems, parseTonemap(arguments.get("tonemap")), options.render.tonemap);
  options.render.samples = 8;
  if (given("samples")) keep(problems, parseWhole(arguments.get("samples"), 1, kMostSamples, "--samples"), options.render.samples);
  options.render.specularAntialiasing = given("specular-aa");
  options.render.compensate = given("compensate");
  const bool error = options.render.view == kErrorView;
  if (error) options.render.reference = 256;
  if (given("reference")) keep(problems, parseWhole(arguments.get("reference"), error ? 2 : 1, kMostReferenceSamples, "--reference"), options.render.reference);
  options.render.splitSum = given("split-sum");
  if (options.render.splitSum && options.render.reference == 0) problems.push_back(glint::error("--split-sum", "is a part of the reference", "add --reference SPP"));
  if (given("error-scale")) {
    float percent = 0;
    if (keep(problems, parseNumber(arguments.get("error-scale"), 0.01f, 1000, "--error-scale"), percent)) options.render.errorScale = percent / 100;
    if (!error) problems.push_back(glint::error("--error-scale", "is for the error view alone", "add --view error"));
  }
  if (!problems.empty()) return problems;
  return options;
}

}  // namespace glint
