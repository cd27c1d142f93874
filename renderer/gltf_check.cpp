#include "renderer/gltf_check.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <set>
#include <vector>

#include "materials/base/files.h"
#include "materials/base/json.h"
#include "renderer/gltf_loader.h"

namespace glint {
namespace fs = std::filesystem;

namespace {

constexpr JsonLimits kJsonLimits{.bytes = size_t{512} << 20, .values = 2'000'000, .depth = 64};
constexpr size_t kMostDiagnostics = 12;
constexpr int kDeepestNode = 512;  // in the hierarchy

constexpr std::array<std::string_view, 5> kReadExtensions = {
    "KHR_texture_transform", "KHR_materials_emissive_strength", "KHR_mesh_quantization",
    // These say nothing about what a picture shows.
    "FB_ngon_encoding", "KHR_xmp_json_ld"};

uint64_t componentBytes(uint64_t type) {
  switch (type) {
    case 5120: case 5121: return 1;
    case 5122: case 5123: return 2;
    case 5125: case 5126: return 4;
    default: return 0;
  }
}

// Bytes of one element; columns of matrices start at multiples of four.
uint64_t elementBytes(std::string_view type, uint64_t component) {
  const uint64_t one = componentBytes(component);
  const auto matrix = [&](uint64_t n) { return n * ((n * one + 3) / 4 * 4); };
  if (type == "SCALAR") return one;
  if (type == "VEC2") return 2 * one;
  if (type == "VEC3") return 3 * one;
  if (type == "VEC4") return 4 * one;
  if (type == "MAT2") return matrix(2);
  if (type == "MAT3") return matrix(3);
  if (type == "MAT4") return matrix(4);
  return 0;
}

// The text that a URI's percent signs stand for; nothing when they are malformed.
std::optional<std::string> percentDecode(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string out;
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      out += uri[i];
      continue;
    }
    if (uri.size() - i < 3 || digit(uri[i + 1]) < 0 || digit(uri[i + 2]) < 0) return {};
    out += char(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
    i += 2;
  }
  return out;
}

// Bytes that a base64 text stands for; nothing when it is not base64.
std::optional<uint64_t> base64Bytes(std::string_view text) {
  size_t padding = 0;
  while (padding < 2 && text.ends_with('=')) {
    text.remove_suffix(1);
    ++padding;
  }
  for (const char c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '+' && c != '/') return {};
  if (text.size() % 4 == 1 || (padding && (text.size() + padding) % 4 != 0)) return {};
  return text.size() * 3 / 4;
}

class Checker {
 public:
  Checker(const Json& root, const fs::path& file, bool binary, uint64_t binBytes, CheckedGltf& out, Diagnostics& warnings)
      : root_(root), file_(file), binary_(binary), binBytes_(binBytes), out_(out), warnings_(warnings) {}

  Diagnostics run() {
    if (!root_.isObject()) {
      fault(root_, "the file", "is " + std::string(name(root_.kind)) + ", not an object", "name a glTF 2.0 file");
      return faults_;
    }
    checkAsset();
    checkExtensions();
    // What is wrong with required extensions explains all the rest.
    if (!faults_.empty()) return faults_;
    for (const char* key : {"buffers", "bufferViews", "accessors", "images", "samplers", "textures", "materials",
                            "meshes", "nodes", "scenes", "animations", "skins", "cameras"})
      checkIsListOfObjects(key);
    if (!faults_.empty()) return faults_;
    each("buffers", &Checker::checkBuffer);
    each("bufferViews", &Checker::checkBufferView);
    reportShortBuffers();
    each("accessors", &Checker::checkAccessor);
    each("images", &Checker::checkImage);
    each("samplers", &Checker::checkSampler);
    each("textures", &Checker::checkTexture);
    each("materials", &Checker::checkMaterial);
    each("meshes", &Checker::checkMesh);
    checkNodes();
    if (dropped_ > 0)
      faults_.push_back(error(file_.string(), fmt::format("has {} more faults", dropped_), "mend the first ones"));
    return faults_;
  }

 private:
  // ---- Words ----
  void fault(const Json& where, const std::string& path, const std::string& what, const std::string& hint = kExport) {
    if (faults_.size() >= kMostDiagnostics) {
      ++dropped_;
      return;
    }
    const std::string place =
        !binary_ && where.line > 0 ? fmt::format("{}:{}", file_.string(), where.line) : file_.string();
    faults_.push_back(error(place, path + " " + what, hint));
  }

  // ---- Members ----
  const Json* member(const Json& object, const std::string& path, const char* key, Json::Kind kind, bool required = false) {
    const Json* found = object.find(key);
    if (!found) {
      if (required) fault(object, path, fmt::format("has no '{}'", key));
      return nullptr;
    }
    if (found->kind == kind) return found;
    fault(*found, fmt::format("{}.{}", path, key), fmt::format("is {}, not {}", name(found->kind), name(kind)));
    return nullptr;
  }
  // A whole number 0..most, spelt as one (tinygltf takes no other).
  std::optional<uint64_t> whole(const Json& object, const std::string& path, const char* key, bool required = false,
                                uint64_t most = kLargestFile) {
    const Json* found = member(object, path, key, Json::Kind::Number, required);
    return found ? wholeOf(*found, fmt::format("{}.{}", path, key), most) : std::nullopt;
  }
  std::optional<uint64_t> wholeOf(const Json& value, const std::string& path, uint64_t most) {
    const bool spelt = value.isNumber() && !value.text.empty() && value.text.size() < 19 &&
                       std::all_of(value.text.begin(), value.text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (spelt && value.number <= double(most)) return uint64_t(value.number);
    fault(value, path, fmt::format("is {}, not a whole number from 0 to {}",
                                   value.isNumber() ? value.text.substr(0, 24) : std::string(name(value.kind)), most));
    return {};
  }
  uint64_t count(const char* list) const {
    const Json* found = root_.find(list);
    return found ? found->items.size() : 0;
  }
  std::optional<uint64_t> index(const Json& object, const std::string& path, const char* key, const char* list,
                                bool required = false) {
    const Json* found = member(object, path, key, Json::Kind::Number, required);
    return found ? indexOf(*found, fmt::format("{}.{}", path, key), list) : std::nullopt;
  }
  std::optional<uint64_t> indexOf(const Json& value, const std::string& path, const char* list) {
    const auto i = wholeOf(value, path, kLargestFile);
    if (!i || *i < count(list)) return i;
    if (count(list) == 0 && !missingLists_.insert(list).second) return {};  // reported where it was first missed
    fault(value, path, fmt::format("is {}, but there are {} {}", *i, count(list), list));
    return {};
  }
  void numbers(const Json& object, const std::string& path, const char* key, size_t expected) {
    const Json* found = member(object, path, key, Json::Kind::Array);
    if (!found) return;
    const bool all = std::all_of(found->items.begin(), found->items.end(), [](const Json& j) { return j.isNumber(); });
    if (!all || found->items.size() != expected)
      fault(*found, fmt::format("{}.{}", path, key), fmt::format("is not a list of {} numbers", expected));
  }
  void number(const Json& object, const std::string& path, const char* key) {
    member(object, path, key, Json::Kind::Number);
  }

  void checkIsListOfObjects(const char* key) {
    const Json* list = member(root_, "the file", key, Json::Kind::Array);
    if (!list) return;
    for (size_t i = 0; i < list->items.size(); ++i)
      if (!list->items[i].isObject())
        fault(list->items[i], fmt::format("{}[{}]", key, i), fmt::format("is {}, not an object", name(list->items[i].kind)));
  }
  void each(const char* key, void (Checker::*check)(const Json&, const std::string&, size_t)) {
    const Json* list = root_.find(key);
    for (size_t i = 0; list && i < list->items.size(); ++i)
      (this->*check)(list->items[i], fmt::format("{}[{}]", key, i), i);
  }

  // ---- The parts of a glTF, in the order of the specification ----
  void checkAsset() {
    const Json* asset = member(root_, "the file", "asset", Json::Kind::Object, true);
    const Json* version = asset ? member(*asset, "asset", "version", Json::Kind::String, true) : nullptr;
    if (version && !version->text.starts_with("2."))
      fault(*version, "asset.version", fmt::format("is '{}'", version->text.substr(0, 20)), "convert it to glTF 2.0");
  }

  void checkExtensions() {
    const auto known = [](const std::string& extension) {
      return std::find(kReadExtensions.begin(), kReadExtensions.end(), extension) != kReadExtensions.end();
    };
    std::string skipped;
    std::set<std::string> required;
    if (const Json* list = member(root_, "the file", "extensionsRequired", Json::Kind::Array))
      for (const Json& item : list->items) {
        required.insert(item.text);
        if (item.isString() && !known(item.text))
          fault(item, "the file", fmt::format("needs the extension '{}', which is not read", item.text.substr(0, 80)),
                item.text.find("draco") != std::string::npos || item.text.find("meshopt") != std::string::npos
                    ? "export it without mesh compression"
                    : "export it without that extension");
      }
    if (const Json* list = member(root_, "the file", "extensionsUsed", Json::Kind::Array))
      for (const Json& item : list->items)
        if (item.isString() && !known(item.text) && !required.count(item.text) && skipped.size() < 200)
          skipped += (skipped.empty() ? "" : ", ") + item.text.substr(0, 80);
    if (!skipped.empty())
      warnings_.push_back(warning(file_.string(), "uses extensions that are not read: " + skipped,
                                  "it is drawn without what they add"));
  }

  void checkBuffer(const Json& buffer, const std::string& path, size_t i) {
    buffers_.emplace_back();
    const size_t before = faults_.size() + dropped_;
    const auto length = whole(buffer, path, "byteLength", true);
    if (length) checkBufferBytes(buffer, path, i, *length);
    if (faults_.size() + dropped_ == before) buffers_.back().bytes = length;
  }
  void checkBufferBytes(const Json& buffer, const std::string& path, size_t i, uint64_t length) {
    if (length == 0) return fault(buffer, path + ".byteLength", "is 0");
    const Json* uri = member(buffer, path, "uri", Json::Kind::String);
    if (buffer.find("uri") && !uri) return;
    if (!uri) {
      if (!binary_ || i != 0)
        fault(buffer, path, "has no 'uri'");
      else if (binBytes_ < length)
        fault(buffer, path + ".byteLength", fmt::format("is {}, but the file's binary chunk holds {} bytes", length, binBytes_),
              "copy or export the file again");
      return;
    }
    if (uri->text.starts_with("data:")) {
      checkDataUri(*uri, path + ".uri", {"application/octet-stream", "application/gltf-buffer", "text/plain"}, length);
    } else if (const auto found = checkFile(*uri, path + ".uri")) {
      std::error_code code;
      const uint64_t size = fs::file_size(*found, code);
      if (!code && size != length)
        fault(buffer, path + ".byteLength", fmt::format("is {}, but '{}' holds {} bytes", length, uri->text.substr(0, 80), size),
              "copy or export the files again");
    }
  }

  void checkDataUri(const Json& uri, const std::string& path, std::vector<std::string_view> types,
                    std::optional<uint64_t> length) {
    const std::string_view text = uri.text;
    for (const std::string_view type : types) {
      const std::string head = fmt::format("data:{};base64,", type);
      if (!text.starts_with(head)) continue;
      const auto bytes = base64Bytes(text.substr(head.size()));
      if (!bytes || *bytes == 0)
        fault(uri, path, "is not valid base64");
      else if (length && *bytes != *length)
        fault(uri, path, fmt::format("holds {} bytes, but byteLength is {}", *bytes, *length));
      return;
    }
    fault(uri, path, fmt::format("is a data URI of a type that is not read: '{}'", text.substr(0, std::min<size_t>(text.find(','), 60))));
  }

  std::optional<fs::path> checkFile(const Json& uri, const std::string& path) {
    Result<fs::path> resolved = resolveGltfUri(uri.text, file_.parent_path(), path);
    if (!resolved) {
      for (const Diagnostic& d : resolved.diagnostics()) fault(uri, d.place, d.what, d.hint);
      return {};
    }
    // tinygltf asks for the name as it decodes it, and takes '+' for a space.
    std::string asked = *percentDecode(uri.text);
    out_.files.try_emplace(asked, *resolved);
    std::replace(asked.begin(), asked.end(), '+', ' ');
    out_.files.try_emplace(asked, *resolved);
    return *resolved;
  }

  struct View {
    uint64_t bytes = 0, stride = 0;
    bool good = false;
  };
  void checkBufferView(const Json& view, const std::string& path, size_t) {
    views_.emplace_back();
    const auto buffer = index(view, path, "buffer", "buffers", true);
    const auto length = whole(view, path, "byteLength", true);
    const auto offset = view.find("byteOffset") ? whole(view, path, "byteOffset") : 0;
    const auto stride = view.find("byteStride") ? whole(view, path, "byteStride") : 0;
    if (!buffer || !length || !offset || !stride) return;
    if (*length == 0) return fault(view, path + ".byteLength", "is 0");
    Buffer& held = buffers_[*buffer];
    if (held.bytes && *offset + *length > *held.bytes) {
      if (held.over++ == 0) held.first = {&view, path, *offset + *length};
      return;
    }
    if (*stride != 0 && (*stride < 4 || *stride > 252 || *stride % 4 != 0))
      return fault(view, path + ".byteStride", fmt::format("is {}, not a multiple of 4 from 4 to 252", *stride));
    views_.back() = {*length, *stride, true};
  }

  // A buffer that is too short is one fault, however many of its views go over its end.
  void reportShortBuffers() {
    for (size_t i = 0; i < buffers_.size(); ++i) {
      const Buffer& buffer = buffers_[i];
      if (buffer.over == 0) continue;
      const std::string others = buffer.over > 1 ? fmt::format("; {} more of its views go over the end", buffer.over - 1) : "";
      fault(*buffer.first.view, buffer.first.path,
            fmt::format("ends at byte {} of buffers[{}], which has {}{}", buffer.first.end, i, *buffer.bytes, others));
    }
  }

  struct Accessor {
    uint64_t component = 0, count = 0;
    std::string type;
    bool normalized = false, strided = false, good = false;
  };
  // Whether `count` elements lie within a view.
  bool fits(const Json& where, const std::string& path, uint64_t view, uint64_t offset, uint64_t count, uint64_t stride,
            uint64_t element) {
    if (!views_[view].good) return false;  // reported
    const uint64_t end = offset + stride * (count - 1) + element;
    if (end <= views_[view].bytes) return true;
    fault(where, path, fmt::format("ends at byte {} of bufferViews[{}], which has {}", end, view, views_[view].bytes));
    return false;
  }
  void checkAccessor(const Json& accessor, const std::string& path, size_t) {
    accessors_.emplace_back();
    const auto component = whole(accessor, path, "componentType", true);
    const auto count = whole(accessor, path, "count", true, kMostGltfIndices);
    const Json* type = member(accessor, path, "type", Json::Kind::String, true);
    const auto offset = accessor.find("byteOffset") ? whole(accessor, path, "byteOffset") : 0;
    const Json* normalized = member(accessor, path, "normalized", Json::Kind::Bool);
    if (!component || !count || !type || !offset) return;
    if (componentBytes(*component) == 0) return fault(accessor, path + ".componentType", fmt::format("is {}", *component));
    const uint64_t element = elementBytes(type->text, *component);
    if (element == 0) return fault(*type, path + ".type", fmt::format("is '{}'", type->text.substr(0, 20)));
    if (*count == 0) return fault(accessor, path + ".count", "is 0");
    bool strided = false;
    if (accessor.find("bufferView")) {
      const auto view = index(accessor, path, "bufferView", "bufferViews");
      if (!view) return;
      const uint64_t stride = views_[*view].stride ? views_[*view].stride : element;
      strided = views_[*view].stride != 0 && views_[*view].stride != element;
      if (stride < element) return fault(accessor, path, fmt::format("has elements of {} bytes every {} bytes", element, stride));
      if (!fits(accessor, path, *view, *offset, *count, stride, element)) return;
    }
    if (accessor.find("sparse") && !checkSparse(accessor, path + ".sparse", *count, element)) return;
    accessors_.back() = {*component, *count, type->text, normalized && normalized->boolean, strided, true};
  }
  bool checkSparse(const Json& accessor, const std::string& path, uint64_t elements, uint64_t element) {
    const Json* sparse = member(accessor, path, "sparse", Json::Kind::Object);
    if (!sparse) return false;
    const auto count = whole(*sparse, path, "count", true, elements);
    const Json* indices = member(*sparse, path, "indices", Json::Kind::Object, true);
    const Json* values = member(*sparse, path, "values", Json::Kind::Object, true);
    if (!count || !indices || !values) return false;
    if (*count == 0) {
      fault(*sparse, path + ".count", "is 0");
      return false;
    }
    const auto component = whole(*indices, path + ".indices", "componentType", true);
    const auto indexView = index(*indices, path + ".indices", "bufferView", "bufferViews", true);
    const auto valueView = index(*values, path + ".values", "bufferView", "bufferViews", true);
    const auto indexOffset = indices->find("byteOffset") ? whole(*indices, path + ".indices", "byteOffset") : 0;
    const auto valueOffset = values->find("byteOffset") ? whole(*values, path + ".values", "byteOffset") : 0;
    if (!component || !indexView || !valueView || !indexOffset || !valueOffset) return false;
    if (*component != 5121 && *component != 5123 && *component != 5125) {
      fault(*indices, path + ".indices.componentType", fmt::format("is {}, not an unsigned integer type", *component));
      return false;
    }
    const uint64_t one = componentBytes(*component);
    return fits(*indices, path + ".indices", *indexView, *indexOffset, *count, one, one) &&
           fits(*values, path + ".values", *valueView, *valueOffset, *count, element, element);
  }

  void checkImage(const Json& image, const std::string& path, size_t) {
    const Json* uri = image.find("uri");
    if (!uri) {
      index(image, path, "bufferView", "bufferViews", true);
      member(image, path, "mimeType", Json::Kind::String, true);
      return;
    }
    if (image.find("bufferView")) return fault(image, path, "has both 'uri' and 'bufferView'");
    if (!member(image, path, "uri", Json::Kind::String)) return;
    if (uri->text.starts_with("data:"))
      checkDataUri(*uri, path + ".uri", {"image/png", "image/jpeg"}, {});
    else
      checkFile(*uri, path + ".uri");
  }

  void checkSampler(const Json& sampler, const std::string& path, size_t) {
    const auto oneOf = [&](const char* key, std::vector<uint64_t> values) {
      const auto value = whole(sampler, path, key);
      if (value && std::find(values.begin(), values.end(), *value) == values.end())
        fault(sampler, fmt::format("{}.{}", path, key), fmt::format("is {}, which glTF does not define", *value));
    };
    oneOf("magFilter", {9728, 9729});
    oneOf("minFilter", {9728, 9729, 9984, 9985, 9986, 9987});
    oneOf("wrapS", {33071, 33648, 10497});
    oneOf("wrapT", {33071, 33648, 10497});
  }

  void checkTexture(const Json& texture, const std::string& path, size_t) {
    index(texture, path, "source", "images");
    index(texture, path, "sampler", "samplers");
  }

  void checkTextureInfo(const Json& owner, const std::string& path, const char* key) {
    const Json* info = member(owner, path, key, Json::Kind::Object);
    if (!info) return;
    const std::string here = fmt::format("{}.{}", path, key);
    index(*info, here, "index", "textures", true);
    whole(*info, here, "texCoord", false, 31);
    number(*info, here, "scale");
    number(*info, here, "strength");
    const Json* extensions = member(*info, here, "extensions", Json::Kind::Object);
    const Json* transform = extensions ? member(*extensions, here, "KHR_texture_transform", Json::Kind::Object) : nullptr;
    if (!transform) return;
    numbers(*transform, here + ".KHR_texture_transform", "offset", 2);
    numbers(*transform, here + ".KHR_texture_transform", "scale", 2);
    number(*transform, here + ".KHR_texture_transform", "rotation");
    whole(*transform, here + ".KHR_texture_transform", "texCoord", false, 31);
  }
  void checkMaterial(const Json& material, const std::string& path, size_t) {
    if (const Json* pbr = member(material, path, "pbrMetallicRoughness", Json::Kind::Object)) {
      const std::string here = path + ".pbrMetallicRoughness";
      numbers(*pbr, here, "baseColorFactor", 4);
      number(*pbr, here, "metallicFactor");
      number(*pbr, here, "roughnessFactor");
      checkTextureInfo(*pbr, here, "baseColorTexture");
      checkTextureInfo(*pbr, here, "metallicRoughnessTexture");
    }
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) checkTextureInfo(material, path, key);
    numbers(material, path, "emissiveFactor", 3);
    number(material, path, "alphaCutoff");
    member(material, path, "doubleSided", Json::Kind::Bool);
    const Json* mode = member(material, path, "alphaMode", Json::Kind::String);
    if (mode && mode->text != "OPAQUE" && mode->text != "MASK" && mode->text != "BLEND")
      fault(*mode, path + ".alphaMode", fmt::format("is '{}', not OPAQUE, MASK or BLEND", mode->text.substr(0, 20)));
    const Json* extensions = member(material, path, "extensions", Json::Kind::Object);
    const Json* strength = extensions ? member(*extensions, path, "KHR_materials_emissive_strength", Json::Kind::Object) : nullptr;
    if (strength) number(*strength, path + ".KHR_materials_emissive_strength", "emissiveStrength");
  }

  void checkMesh(const Json& mesh, const std::string& path, size_t) {
    const Json* primitives = member(mesh, path, "primitives", Json::Kind::Array, true);
    if (!primitives) return;
    if (primitives->items.empty()) fault(*primitives, path + ".primitives", "is empty");
    for (size_t i = 0; i < primitives->items.size(); ++i) {
      const std::string here = fmt::format("{}.primitives[{}]", path, i);
      if (primitives->items[i].isObject())
        checkPrimitive(primitives->items[i], here);
      else
        fault(primitives->items[i], here, fmt::format("is {}, not an object", name(primitives->items[i].kind)));
    }
  }
  void checkPrimitive(const Json& primitive, const std::string& path) {
    whole(primitive, path, "mode", false, 6);
    index(primitive, path, "material", "materials");
    const Json* attributes = member(primitive, path, "attributes", Json::Kind::Object, true);
    if (!attributes) return;
    std::optional<uint64_t> vertices;
    for (size_t i = 0; i < attributes->items.size(); ++i) {
      const std::string& key = attributes->keys[i];
      const std::string here = fmt::format("{}.attributes.{}", path, key.substr(0, 40));
      const auto at = indexOf(attributes->items[i], here, "accessors");
      if (!at || !accessors_[*at].good) continue;
      const Accessor& accessor = accessors_[*at];
      if (const char* wrong = attributeFault(key, accessor))
        fault(attributes->items[i], here, fmt::format("is of type {} with component type {}, {}", accessor.type, accessor.component, wrong));
      if (vertices && *vertices != accessor.count)
        fault(attributes->items[i], here, fmt::format("has {} elements, other attributes have {}", accessor.count, *vertices));
      if (!vertices) vertices = accessor.count;
    }
    if (!attributes->find("POSITION")) fault(*attributes, path, "has no POSITION");
    if (!primitive.find("indices")) return;
    const auto at = index(primitive, path, "indices", "accessors");
    if (!at || !accessors_[*at].good) return;
    const Accessor& accessor = accessors_[*at];
    const bool unsignedType = accessor.component == 5121 || accessor.component == 5123 || accessor.component == 5125;
    if (accessor.type != "SCALAR" || !unsignedType || accessor.normalized)
      fault(primitive, path + ".indices", fmt::format("is of type {} with component type {}, not unsigned integers", accessor.type, accessor.component));
    else if (accessor.strided)
      fault(primitive, path + ".indices", "has a byteStride");
  }
  // What is wrong with an accessor as that attribute (glTF 2.0, 3.7.2.1, and KHR_mesh_quantization), or null.
  static const char* attributeFault(const std::string& key, const Accessor& a) {
    const bool isFloat = a.component == 5126, small = a.component >= 5120 && a.component <= 5123;
    const bool unsignedSmall = a.component == 5121 || a.component == 5123, signedSmall = a.component == 5120 || a.component == 5122;
    if (key == "POSITION") return a.type == "VEC3" && (isFloat || small) ? nullptr : "not a vec3";
    if (key == "NORMAL") return a.type == "VEC3" && (isFloat || (signedSmall && a.normalized)) ? nullptr : "not a vec3 of floats or normalized signed integers";
    if (key == "TANGENT") return a.type == "VEC4" && (isFloat || (signedSmall && a.normalized)) ? nullptr : "not a vec4 of floats or normalized signed integers";
    if (key == "TEXCOORD_0" || key == "TEXCOORD_1") return a.type == "VEC2" && (isFloat || small) ? nullptr : "not a vec2";
    if (key == "COLOR_0")
      return (a.type == "VEC3" || a.type == "VEC4") && (isFloat || (unsignedSmall && a.normalized)) ? nullptr : "not a colour of floats or normalized unsigned integers";
    return nullptr;  // not read
  }

  void checkNodes() {
    const Json* nodes = root_.find("nodes");
    const size_t total = count("nodes");
    std::vector<std::optional<size_t>> parent(total);
    for (size_t i = 0; i < total; ++i) {
      const Json& node = nodes->items[i];
      const std::string path = fmt::format("nodes[{}]", i);
      index(node, path, "mesh", "meshes");
      index(node, path, "skin", "skins");
      index(node, path, "camera", "cameras");
      numbers(node, path, "matrix", 16);
      numbers(node, path, "translation", 3);
      numbers(node, path, "rotation", 4);
      numbers(node, path, "scale", 3);
      const Json* children = member(node, path, "children", Json::Kind::Array);
      for (size_t k = 0; children && k < children->items.size(); ++k) {
        const std::string here = fmt::format("{}.children[{}]", path, k);
        const auto child = indexOf(children->items[k], here, "nodes");
        if (!child) continue;
        if (parent[*child])
          fault(children->items[k], here, fmt::format("is node {}, which nodes[{}] already holds", *child, *parent[*child]), "the nodes of a glTF form a tree");
        else
          parent[*child] = i;
      }
    }
    // Depth above each node; a chain longer than there are nodes would be a cycle.
    std::vector<int> depth(total, -1);
    for (size_t i = 0; i < total; ++i) {
      std::vector<size_t> chain;
      size_t at = i;
      while (depth[at] < 0 && parent[at] && chain.size() <= total) {
        chain.push_back(at);
        at = *parent[at];
      }
      if (chain.size() > total) {
        fault(nodes->items[i], fmt::format("nodes[{}]", i), "is its own ancestor", "the nodes of a glTF form a tree");
        return;
      }
      if (depth[at] < 0) depth[at] = 0;
      for (auto k = chain.rbegin(); k != chain.rend(); ++k) depth[*k] = depth[*parent[*k]] + 1;
      if (depth[i] > kDeepestNode) {
        fault(nodes->items[i], fmt::format("nodes[{}]", i), fmt::format("lies {} nodes deep", depth[i]), fmt::format("at most {} are read", kDeepestNode));
        return;
      }
    }
    index(root_, "the file", "scene", "scenes");
    const Json* scenes = root_.find("scenes");
    for (size_t s = 0; scenes && s < scenes->items.size(); ++s) {
      const Json* roots = member(scenes->items[s], fmt::format("scenes[{}]", s), "nodes", Json::Kind::Array);
      std::set<uint64_t> seen;
      for (size_t k = 0; roots && k < roots->items.size(); ++k) {
        const std::string here = fmt::format("scenes[{}].nodes[{}]", s, k);
        const auto i = indexOf(roots->items[k], here, "nodes");
        if (i && parent[*i])
          fault(roots->items[k], here, fmt::format("is node {}, which nodes[{}] holds", *i, *parent[*i]), "a scene lists root nodes only");
        else if (i && !seen.insert(*i).second)
          fault(roots->items[k], here, fmt::format("is node {} a second time", *i));
      }
    }
  }

  static constexpr const char* kExport = "export the file again";

  const Json& root_;
  const fs::path& file_;
  const bool binary_;
  const uint64_t binBytes_;
  CheckedGltf& out_;
  Diagnostics& warnings_;
  Diagnostics faults_;
  size_t dropped_ = 0;
  struct Buffer {
    std::optional<uint64_t> bytes;  // none where its own fault is reported: its views are not judged by it
    size_t over = 0;                // its views that go over its end, and the first of them
    struct {
      const Json* view = nullptr;
      std::string path;
      uint64_t end = 0;
    } first;
  };
  std::vector<Buffer> buffers_;
  std::set<std::string> missingLists_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
};

// The parts of a .glb: a 12-byte head, a JSON chunk, and then usually a binary one.
struct Chunks {
  std::string_view json;
  uint64_t binBytes = 0;
};

Result<Chunks> splitBinary(std::string_view bytes, const std::string& place) {
  const auto word = [&](uint64_t at) {
    uint32_t value;
    std::memcpy(&value, bytes.data() + at, 4);
    return uint64_t(value);
  };
  const auto cut = [&](uint64_t needed) {
    return error(place, fmt::format("is a truncated .glb: it ends at byte {} of {}", bytes.size(), needed), "copy or export the file again");
  };
  if (bytes.size() < 20) return cut(20);
  if (word(4) != 2) return error(place, fmt::format("is a .glb of version {}", word(4)), "convert it to glTF 2.0");
  const uint64_t length = word(8), jsonBytes = word(12);
  if (length > bytes.size()) return cut(length);
  constexpr uint64_t kJson = 0x4E4F534A, kBin = 0x004E4942;
  if (word(16) != kJson || 20 + jsonBytes > length)
    return error(place, "is a corrupt .glb: byte 12: there is no JSON chunk", "copy or export the file again");
  Chunks chunks{bytes.substr(20, jsonBytes)};
  const uint64_t at = 20 + jsonBytes;
  if (at + 8 <= length && word(at + 4) == kBin) {
    if (at + 8 + word(at) > length)
      return error(place, fmt::format("is a corrupt .glb: byte {}: the binary chunk of {} bytes goes over the end", at, word(at)), "copy or export the file again");
    chunks.binBytes = word(at);
  }
  return chunks;
}

}  // namespace

Result<fs::path> resolveGltfUri(const std::string& uri, const fs::path& folder, const std::string& place) {
  const std::string shown = uri.substr(0, 120);
  const auto decoded = percentDecode(uri);
  if (!decoded || decoded->empty() || decoded->find('\0') != std::string::npos)
    return error(place, fmt::format("'{}' is not a URI", shown), "name a file beside the model");
  const fs::path relative(*decoded);
  const size_t colon = decoded->find(':');
  const bool scheme = colon != std::string::npos && decoded->find('/') > colon;
  if (scheme || relative.is_absolute() || decoded->find('\\') != std::string::npos)
    return error(place, fmt::format("'{}' is not a relative path", shown), "name a file beside the model");
  std::error_code code;
  const fs::path home = fs::canonical(folder.empty() ? "." : folder, code);
  if (code) return error(place, fmt::format("the model's folder cannot be read: {}", code.message()), "check the path and its permissions");
  const fs::path target = fs::weakly_canonical(home / relative, code);
  const fs::path inside = target.lexically_relative(home);
  if (code || inside.empty() || *inside.begin() == "..")
    return error(place, fmt::format("'{}' lies outside the model's folder", shown), "keep a model's files in its folder or below");
  if (!fs::is_regular_file(target, code))
    return error(place, fmt::format("'{}': no such file", shown), "put it beside the model, or export the model again");
  return target;
}

Result<CheckedGltf> checkGltf(std::string_view bytes, const fs::path& file, Diagnostics& warnings) {
  CheckedGltf checked;
  checked.binary = bytes.starts_with("glTF");
  const std::string place = file.string();
  Chunks chunks{bytes};
  if (checked.binary) {
    Result<Chunks> split = splitBinary(bytes, place);
    if (!split) return split.diagnostics();
    chunks = *split;
  } else {
    // JSON starts with a brace; anything else is another kind of file altogether.
    const size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || bytes[first] != '{')
      return error(place, bytes.empty() ? "is empty" : "is not a glTF (it starts with neither 'glTF' nor '{')", "name a .glb or .gltf file");
  }
  Result<Json> root = parseJson(chunks.json, place, 1, kJsonLimits);
  if (!root) {
    Diagnostics faults = root.diagnostics();
    for (Diagnostic& d : faults)
      if (d.hint.empty()) d.hint = "export the file again";
    return faults;
  }
  Diagnostics faults = Checker(*root, file, checked.binary, chunks.binBytes, checked, warnings).run();
  if (!faults.empty()) return faults;
  return checked;
}

}  // namespace glint
