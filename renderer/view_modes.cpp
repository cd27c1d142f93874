// The pictures that can be drawn of a scene. After those of light they are in the order of shaders/passes/buffer_view.frag.
#include "renderer/renderer.h"

namespace glint {

std::span<const ViewMode> viewModes() {
  static constexpr ViewMode kModes[] = {
      {"lit", "Lit", "The picture: light, environment and emission"},
      {kFurnaceView, "White furnace", "Every surface as white metal under white light from all sides: what keeps its energy cannot be seen, what loses some is darker, what gains some is orange"},
      {kErrorView, "Error", "How far the light is from the reference: blue where it is too dark, orange where it is too bright"},
      {"baseColor", "Base color", "Base colour"},
      {"normal", "Normal", "World-space normal: x, y, z as red, green, blue around a half"},
      {"metallic", "Metallic", "Metallic, black 0 to white 1"},
      {"specular", "Specular", "Specular, black 0 to white 1"},
      {"roughness", "Roughness", "Roughness, black 0 to white 1"},
      {"cavity", "Cavity", "Cavity, black 0 to white 1"},
      {"ambientOcclusion", "Ambient occlusion", "Ambient occlusion, black 0 to white 1"},
      {"emissive", "Emissive", "Emitted light, in nits"},
      {"modelId", "Shading model", "Each shading model in its own colour"},
      {"parameters", "Model parameters", "The shading model's first three per-pixel parameters"},
      {"depth", "Depth", "Distance along the view, near white to far dark"},
      {"lightCount", "Lights per tile", "Point lights that reach each tile: blue 1 to orange 64 and more"},
  };
  return kModes;
}

std::span<const AreaLightsInfo> areaLightMethods() {
  static constexpr AreaLightsInfo kMethods[] = {
      {AreaLights::Cosines, "cosines", "Transformed cosines", "The shape itself, through a cosine lobe that is turned into the model's (Heitz and others 2016), fitted by Glint"},
      {AreaLights::Notes, "notes", "Notes", "The nearest point of the light to the reflected ray, its lobe weaker by the notes' factor 3 (Karis 2013, eq. 10 and 14)"},
      {AreaLights::Unreal, "unreal", "Unreal", "The same with the factor 2 that Unreal ships, which is right for smooth surfaces"},
      {AreaLights::SpecularD, "specular-d", "Specular D", "The middle of the light, with the distribution alone made wider"},
      {AreaLights::Plain, "plain", "Not normalized", "The nearest point as it is: brighter with every size"}};
  return kMethods;
}

std::span<const ChoiceInfo> shadowChoices() {
  static constexpr ChoiceInfo kChoices[] = {
      {"off", "Off", "Light goes through everything"},
      {"on", "On", "Shadow maps, with edges as soft as their lights are large"},
      {"contact", "With contact", "And the short shadows where things touch, from the depth of the picture"}};
  return kChoices;
}

std::span<const ChoiceInfo> groundChoices() {
  static constexpr ChoiceInfo kChoices[] = {
      {"none", "None", "Nothing to stand on"},
      {"shadow", "Shadow", "The background, darker where light is kept away"},
      {"matte", "Matte", "A grey floor that fades into the background"}};
  return kChoices;
}

const ViewMode* findViewMode(const std::string& id) {
  for (const ViewMode& mode : viewModes())
    if (id == mode.id) return &mode;
  return nullptr;
}

int bufferViewIndex(const std::string& id) {
  constexpr int kOfLight = 3;
  const ViewMode* mode = findViewMode(id);
  GLINT_CHECK(mode != nullptr && mode - viewModes().data() >= kOfLight, "{} shows no buffer", id);
  return static_cast<int>(mode - viewModes().data()) - kOfLight;
}

}  // namespace glint
