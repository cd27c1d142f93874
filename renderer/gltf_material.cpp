#include "renderer/gltf_material.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "materials/base/json.h"

namespace glint {
namespace {

// One word of letters, digits and '-', as materials are named.
std::string materialName(const std::string& name) {
  std::string out;
  for (const char c : name.substr(0, 64)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain)
      out += char(std::tolower(static_cast<unsigned char>(c)));
    else if (!out.empty() && out.back() != '-')
      out += '-';
  }
  while (out.ends_with('-')) out.pop_back();
  return out.empty() ? "material" : out;
}

Json list(std::initializer_list<float> numbers) {
  Json json = Json::array();
  for (const float x : numbers) json.push(Json::of(x));
  return json;
}

const char* word(Wrap wrap) { return wrap == Wrap::Clamp ? "clamp" : wrap == Wrap::Mirror ? "mirror" : "repeat"; }

// Adds nodes in columns from left to right: coordinates, samples, factors, products, output.
class Builder {
 public:
  Builder(const GltfMaterial& in, const GltfFile& file) : in_(in), graph_(newMaterial(materialName(in.name))) {
    graph_.doc = fmt::format("Material '{}' of {}", in.name, file.path.filename().string());
    output_ = graph_.outputNode();
    graph_.layout[output_] = {0, 0};
  }

  Material build() {
    baseColor();
    metallicRoughness();
    if (in_.normal.present()) {
      const NodeId map = add("normal-map", "normal", kProducts);
      wire(map, "color", {sample(in_.normal, "normal-texture", ColorSpace::Linear), "color"});
      wire(map, "strength", number("normal-strength", "Normal strength", in_.normalScale, 0, 2));
      wire(output_, "normal", {map, "normal"});
    }
    if (in_.occlusion.present()) {
      // 1 + strength (occlusion - 1): glTF 2.0, 3.9.3.
      const NodeId mix = add("mix", "occlusion", kProducts);
      graph_.nodes[mix].inputs["a"].value = Value::scalar(1);
      wire(mix, "b", {sample(in_.occlusion, "occlusion-texture", ColorSpace::Linear), "r"});
      wire(mix, "t", number("occlusion-strength", "Occlusion strength", in_.occlusionStrength));
      wire(output_, "ambientOcclusion", {mix, "value"});
    }
    // A texture under a factor of zero is dark for good; nothing is written, which costs nothing.
    if (in_.emissiveFactor != glm::vec3(0)) {
      PinRef light = color("emissive", "Emissive", in_.emissiveFactor);
      if (in_.emissive.present())
        light = product("emissive-product", {sample(in_.emissive, "emissive-texture", ColorSpace::sRGB), "color"}, light);
      wire(output_, "emissive", light);
    }
    return std::move(graph_);
  }

 private:
  enum Column { kCoordinates, kSamples, kFactors, kProducts, kColumns };

  NodeId add(const char* kind, const char* wish, Column column) {
    constexpr float kX[kColumns] = {-1240, -980, -640, -320};
    constexpr float kRow[kColumns] = {150, 240, 150, 150};   // a sample has many pins
    const NodeId id = freeNodeId(graph_, wish);
    graph_.nodes[id].kind = kind;
    graph_.layout[id] = {kX[column], kRow[column] * float(rows_[column]++)};
    return id;
  }
  void set(const NodeId& id, const char* key, Json value) { graph_.nodes[id].settings[key] = std::move(value); }
  void wire(const NodeId& to, const char* pin, PinRef from) { graph_.nodes[to].inputs[pin].from = std::move(from); }

  PinRef parameter(const char* id, const std::string& title, const char* type, Json value, float low, float high,
                   Column column = kFactors) {
    const NodeId made = add("parameter", id, column);
    set(made, "name", Json::of(title));
    set(made, "type", Json::of(type));
    set(made, "value", std::move(value));
    if (low != 0) set(made, "min", Json::of(low));
    if (high != 1) set(made, "max", Json::of(high));
    return {made, "value"};
  }
  PinRef number(const char* id, const char* title, float value, float low = 0, float high = 1) {
    return parameter(id, title, "float", Json::of(value), low, std::max(high, value));
  }
  PinRef color(const char* id, const char* title, const glm::vec3& value) {
    return parameter(id, title, "color", list({value.r, value.g, value.b}), 0,
                     std::max({1.0f, value.r, value.g, value.b}));
  }
  PinRef product(const char* id, PinRef a, PinRef b) {
    const NodeId made = add("multiply", id, kProducts);
    wire(made, "a", std::move(a));
    wire(made, "b", std::move(b));
    return {made, "value"};
  }

  // The coordinate that a texture is sampled at, where that is not just uv0. Textures share what is the same.
  std::optional<PinRef> coordinate(const GltfTexture& texture) {
    const bool moved = texture.offset != glm::vec2(0) || texture.scale != glm::vec2(1) || texture.rotation != 0;
    if (!moved && texture.texCoord == 0) return {};
    const auto key = std::tuple(texture.texCoord, texture.offset.x, texture.offset.y, texture.scale.x, texture.scale.y, texture.rotation);
    const auto found = coordinates_.find(key);
    if (found != coordinates_.end()) return found->second;
    std::optional<PinRef> at;
    if (texture.texCoord == 1) {
      const NodeId uv = add("uv", "uv1", kCoordinates);
      set(uv, "set", Json::of("uv1"));
      at = PinRef{uv, "uv"};
    }
    if (moved) at = transformed(texture, at);
    coordinates_[key] = *at;
    return at;
  }

  // KHR_texture_transform: offset + R (scale uv), about the origin. The node scales and turns about the middle m of
  // the tile, R (uv - m) tile + m + offset, and scales after it turns; so what differs goes into the offset, and a
  // turn with an uneven scale takes two nodes.
  PinRef transformed(const GltfTexture& texture, const std::optional<PinRef>& from) {
    const glm::vec2 middle(0.5f);
    const float c = std::cos(texture.rotation), s = std::sin(texture.rotation);
    const auto turned = [&](const glm::vec2& p) { return glm::vec2(c * p.x + s * p.y, c * p.y - s * p.x); };
    if (texture.rotation == 0)
      return transform(from, texture.scale, texture.offset - middle + texture.scale * middle, 0);
    if (texture.scale.x == texture.scale.y)
      return transform(from, texture.scale, texture.offset - middle + texture.scale * turned(middle), texture.rotation);
    const PinRef scaled = transform(from, texture.scale, texture.scale * middle - middle, 0);
    return transform(scaled, glm::vec2(1), texture.offset - middle + turned(middle), texture.rotation);
  }
  PinRef transform(const std::optional<PinRef>& from, const glm::vec2& tile, const glm::vec2& offset, float rotation) {
    const NodeId made = add("transform-uv", "transform-uv", kCoordinates);
    if (from) wire(made, "uv", *from);
    // Numbered, as parameters of one name are one.
    const int n = ++transforms_;
    wire(made, "tile", parameter("uv-tile", fmt::format("UV {} tile", n), "vec2", list({tile.x, tile.y}), -10, 10, kCoordinates));
    wire(made, "offset", parameter("uv-offset", fmt::format("UV {} offset", n), "vec2", list({offset.x, offset.y}), -1, 1, kCoordinates));
    wire(made, "rotation", parameter("uv-rotation", fmt::format("UV {} rotation", n), "float", Json::of(glm::degrees(rotation)), -180, 180, kCoordinates));
    return {made, "value"};
  }

  NodeId sample(const GltfTexture& texture, const char* wish, ColorSpace space) {
    const std::optional<PinRef> at = coordinate(texture);
    const auto key = std::tuple(texture.name, space, texture.wrapS, texture.wrapT, texture.filter, at ? at->text() : "");
    const auto found = samples_.find(key);
    if (found != samples_.end()) return found->second;
    const NodeId made = add("texture-sample", wish, kSamples);
    set(made, "file", Json::of(texture.name));
    if (space == ColorSpace::Linear) set(made, "colorSpace", Json::of("linear"));
    if (texture.wrapS != Wrap::Repeat) set(made, "wrap", Json::of(word(texture.wrapS)));
    if (texture.wrapT != texture.wrapS) set(made, "wrapV", Json::of(word(texture.wrapT)));
    if (texture.filter == Filter::Nearest) set(made, "filter", Json::of("nearest"));
    if (at) wire(made, "uv", *at);
    samples_[key] = made;
    return made;
  }

  void baseColor() {
    const glm::vec4& factor = in_.baseColorFactor;
    PinRef rgb = color("base-color", "Base color", glm::vec3(factor));
    std::optional<NodeId> texture;
    if (in_.baseColor.present()) {
      texture = sample(in_.baseColor, "base-color-texture", ColorSpace::sRGB);
      rgb = product("base-color-product", {*texture, "color"}, rgb);
    }
    std::optional<NodeId> vertex;
    if (in_.vertexColors) {
      vertex = add("vertex-color", "vertex-color", kSamples);
      rgb = product("vertex-color-product", {*vertex, "color"}, rgb);
    }
    wire(output_, "baseColor", rgb);

    // Blending is drawn as a mask where a texture says what is solid, and else as opaque.
    const bool pictureAlpha = in_.baseColor.image && in_.baseColor.image->channels % 2 == 0;
    const bool masked = in_.alpha == GltfMaterial::Alpha::Mask || (in_.alpha == GltfMaterial::Alpha::Blend && pictureAlpha);
    if (!masked) return;
    PinRef alpha = number("opacity", "Opacity", factor.a);
    if (texture) alpha = product("opacity-product", {*texture, "a"}, alpha);
    if (vertex) alpha = product("vertex-opacity-product", {*vertex, "alpha"}, alpha);
    wire(output_, "opacityMask", alpha);
  }

  void metallicRoughness() {
    PinRef metallic = number("metallic", "Metallic", in_.metallicFactor);
    PinRef roughness = number("roughness", "Roughness", in_.roughnessFactor);
    if (in_.metallicRoughness.present()) {
      const NodeId texture = sample(in_.metallicRoughness, "metallic-roughness-texture", ColorSpace::Linear);
      metallic = product("metallic-product", {texture, "b"}, metallic);
      roughness = product("roughness-product", {texture, "g"}, roughness);
    }
    wire(output_, "metallic", metallic);
    wire(output_, "roughness", roughness);
  }

  const GltfMaterial& in_;
  Material graph_;
  NodeId output_;
  int rows_[kColumns] = {};
  int transforms_ = 0;
  std::map<std::tuple<int, float, float, float, float, float>, PinRef> coordinates_;
  std::map<std::tuple<std::string, ColorSpace, Wrap, Wrap, Filter, std::string>, NodeId> samples_;
};

}  // namespace

Material gltfMaterialGraph(const GltfMaterial& material, const GltfFile& file) { return Builder(material, file).build(); }

void putPictures(const GltfFile& file, TextureCache& cache) {
  for (const auto& [name, image] : file.images) cache.put(name, image);
}

void setSurfaceState(const GltfMaterial& material, SurfaceMaterial& surface) {
  surface.doubleSided = material.doubleSided;
  surface.opacityCutoff = material.alpha == GltfMaterial::Alpha::Mask ? material.alphaCutoff : 0.5f;
}

}  // namespace glint
