#include "renderer/gltf_loader.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <set>

#include "materials/base/files.h"
#include "renderer/gltf_check.h"
#include "renderer/gltf_geometry.h"
#include "renderer/image_io.h"
#include "renderer/parallel.h"

namespace glint {
namespace fs = std::filesystem;

namespace {

constexpr const char* kHint = "export the file again";
constexpr size_t kMostInstances = size_t{1} << 20;

template <class T>
const T* at(const std::vector<T>& list, int index) {
  return index >= 0 && size_t(index) < list.size() ? &list[size_t(index)] : nullptr;
}

// ---- What tinygltf may read: the files that the check resolved, and nothing else ----

bool fileExists(const std::string& name, void* checked) {
  return static_cast<const CheckedGltf*>(checked)->files.count(name) != 0;
}
std::string keepPath(const std::string& name, void*) { return name; }
bool readWholeFile(std::vector<unsigned char>* out, std::string* problem, const std::string& name, void* checked) {
  const auto& files = static_cast<const CheckedGltf*>(checked)->files;
  const auto found = files.find(name);
  if (found == files.end()) return false;
  const Result<std::string> bytes = readFile(found->second);
  if (!bytes) {
    *problem = bytes.diagnostics().front().what;
    return false;
  }
  out->assign(bytes->begin(), bytes->end());
  return true;
}
bool writeNothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }
// Pictures stay encoded until a material wants them: then they are decoded by image_io.h, several at once.
bool keepEncoded(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
                 int size, void*) {
  if (size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

Result<tinygltf::Model> parse(std::string_view bytes, const fs::path& path, CheckedGltf& checked) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string problems, warnings;
  loader.SetFsCallbacks({fileExists, keepPath, readWholeFile, writeNothing, &checked});
  loader.SetImageLoader(keepEncoded, nullptr);
  const auto size = static_cast<unsigned>(bytes.size());
  const bool ok = checked.binary
                      ? loader.LoadBinaryFromMemory(&model, &problems, &warnings,
                                                    reinterpret_cast<const unsigned char*>(bytes.data()), size, "")
                      : loader.LoadASCIIFromString(&model, &problems, &warnings, bytes.data(), size, "");
  if (ok) return model;
  std::replace(problems.begin(), problems.end(), '\n', ' ');
  while (problems.ends_with(' ') || problems.ends_with('.')) problems.pop_back();
  return error(path.string(), "is not a valid glTF: " + (problems.empty() ? warnings : problems).substr(0, 300), kHint);
}

// ---- Materials ----

class Loader {
 public:
  Loader(const tinygltf::Model& model, std::string place, GltfFile& file, Diagnostics& warnings)
      : model_(model), place_(std::move(place)), file_(file), warnings_(warnings) {}
  Diagnostics problems;

  void readMaterials() {
    for (size_t i = 0; i < model_.materials.size(); ++i) file_.materials.push_back(material(model_.materials[i], i));
  }
  void readPictures();
  void readMeshes();
  void readNodes();

 private:
  void fault(const std::string& path, const std::string& what, const char* hint = kHint) {
    problems.push_back(error(place_, path + " " + what, hint));
  }
  // Each warning once, however many parts of the file give cause.
  void warnOnce(const std::string& what, const std::string& hint) {
    Diagnostic d = warning(place_, what, hint);
    if (std::find(warnings_.begin(), warnings_.end(), d) == warnings_.end()) warnings_.push_back(std::move(d));
  }

  template <class Info>
  GltfTexture texture(const Info& info, const std::string& path);
  GltfMaterial material(const tinygltf::Material&, size_t index);

  struct Primitive {
    MeshPtr mesh;
    int material = -1;
  };
  int materialOf(int index);
  void addNode(const tinygltf::Node&, const glm::mat4& worldFromModel);

  const tinygltf::Model& model_;
  const std::string place_;                            // the file, as diagnostics name it
  GltfFile& file_;
  Diagnostics& warnings_;
  std::map<std::string, int> pictures_;                // those in use, by name: index into model_.images
  std::vector<std::vector<Primitive>> meshes_;         // as model_.meshes
  int defaultMaterial_ = -1;
};

float numberIn(const tinygltf::Value& object, const char* key, float fallback) {
  if (!object.IsObject() || !object.Has(key) || !object.Get(key).IsNumber()) return fallback;
  const auto value = float(object.Get(key).GetNumberAsDouble());
  return std::isfinite(value) ? value : fallback;
}

glm::vec2 pairIn(const tinygltf::Value& object, const char* key, const glm::vec2& fallback) {
  if (!object.IsObject() || !object.Has(key)) return fallback;
  const tinygltf::Value& list = object.Get(key);
  if (!list.IsArray() || list.ArrayLen() != 2 || !list.Get(0).IsNumber() || !list.Get(1).IsNumber()) return fallback;
  const glm::vec2 value(list.Get(0).GetNumberAsDouble(), list.Get(1).GetNumberAsDouble());
  return std::isfinite(value.x) && std::isfinite(value.y) ? value : fallback;
}

Wrap wrapOf(int gl) {
  return gl == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE ? Wrap::Clamp
         : gl == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::Mirror
                                                       : Wrap::Repeat;
}

template <class Info>
GltfTexture Loader::texture(const Info& info, const std::string& path) {
  GltfTexture out;
  if (info.index < 0) return out;
  const auto* texture = at(model_.textures, info.index);
  if (!texture) {
    fault(path, "names no texture");
    return out;
  }
  const auto* image = at(model_.images, texture->source);
  if (!image) {
    warnOnce(fmt::format("textures[{}] has no picture that is read", info.index), "export it as PNG or JPEG");
    return out;
  }
  out.texCoord = info.texCoord;
  if (const auto* sampler = at(model_.samplers, texture->sampler)) {
    out.wrapS = wrapOf(sampler->wrapS);
    out.wrapT = wrapOf(sampler->wrapT);
    if (sampler->magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) out.filter = Filter::Nearest;
  }
  if (const auto found = info.extensions.find("KHR_texture_transform"); found != info.extensions.end()) {
    out.offset = pairIn(found->second, "offset", out.offset);
    out.scale = pairIn(found->second, "scale", out.scale);
    out.rotation = numberIn(found->second, "rotation", 0);
    out.texCoord = int(numberIn(found->second, "texCoord", float(out.texCoord)));
  }
  if (out.texCoord < 0 || out.texCoord > 1) {
    warnOnce(fmt::format("{} uses TEXCOORD_{}, which is not read", path, out.texCoord), "TEXCOORD_0 is used instead");
    out.texCoord = 0;
  }
  out.name = fmt::format("gltf:{}#{}", file_.path.string(), texture->source);
  pictures_.emplace(out.name, texture->source);
  return out;
}

float unit(double x) { return std::isfinite(x) ? float(std::clamp(x, 0.0, 1.0)) : 1.0f; }

GltfMaterial Loader::material(const tinygltf::Material& in, size_t index) {
  const std::string path = fmt::format("materials[{}]", index);
  GltfMaterial out;
  out.name = in.name.empty() ? fmt::format("material-{}", index) : in.name;
  const auto& pbr = in.pbrMetallicRoughness;
  for (int c = 0; c < 4 && pbr.baseColorFactor.size() == 4; ++c) out.baseColorFactor[c] = unit(pbr.baseColorFactor[size_t(c)]);
  out.metallicFactor = unit(pbr.metallicFactor);
  out.roughnessFactor = unit(pbr.roughnessFactor);
  out.normalScale = std::isfinite(in.normalTexture.scale) ? float(in.normalTexture.scale) : 1.0f;
  out.occlusionStrength = unit(in.occlusionTexture.strength);
  float strength = 1;
  if (const auto found = in.extensions.find("KHR_materials_emissive_strength"); found != in.extensions.end())
    strength = std::max(numberIn(found->second, "emissiveStrength", 1), 0.0f);
  for (int c = 0; c < 3 && in.emissiveFactor.size() == 3; ++c)
    out.emissiveFactor[c] = std::max(float(in.emissiveFactor[size_t(c)]), 0.0f) * strength;
  out.baseColor = texture(pbr.baseColorTexture, path + ".baseColorTexture");
  out.metallicRoughness = texture(pbr.metallicRoughnessTexture, path + ".metallicRoughnessTexture");
  out.normal = texture(in.normalTexture, path + ".normalTexture");
  out.occlusion = texture(in.occlusionTexture, path + ".occlusionTexture");
  out.emissive = texture(in.emissiveTexture, path + ".emissiveTexture");
  out.alpha = in.alphaMode == "MASK"    ? GltfMaterial::Alpha::Mask
              : in.alphaMode == "BLEND" ? GltfMaterial::Alpha::Blend
                                        : GltfMaterial::Alpha::Opaque;
  out.alphaCutoff = std::isfinite(in.alphaCutoff) ? float(in.alphaCutoff) : 0.5f;
  out.doubleSided = in.doubleSided;
  if (out.alpha == GltfMaterial::Alpha::Blend)
    warnOnce("has materials that are blended by alpha", "they are drawn with a hard edge at half opacity");
  return out;
}

void Loader::readPictures() {
  struct Job {
    const std::string* name;
    int index;
    Result<Image8> result = error("picture", "not decoded");
  };
  std::vector<Job> jobs;
  uint64_t pixels = 0;
  for (const auto& [name, index] : pictures_) {
    const auto& encoded = model_.images[size_t(index)].image;
    const std::string_view bytes(reinterpret_cast<const char*>(encoded.data()), encoded.size());
    const Result<ImageSize> size = imageSize8(bytes, place_);
    if (!size) {
      for (const Diagnostic& d : size.diagnostics()) fault(fmt::format("images[{}]", index), d.what, d.hint.c_str());
      continue;
    }
    pixels += size->pixels();
    jobs.push_back({&name, index});
  }
  if (pixels > kMostGltfPixels) {
    fault("the file", fmt::format("has pictures of {} pixels", pixels), "make them smaller; 2^28 in all are read");
    return;
  }
  parallelFor(jobs.size(), [&](size_t i) {
    const auto& encoded = model_.images[size_t(jobs[i].index)].image;
    jobs[i].result = decodeImage8({reinterpret_cast<const char*>(encoded.data()), encoded.size()}, place_);
  }, pixels > 100'000);
  for (Job& job : jobs) {
    if (!job.result) {
      for (const Diagnostic& d : job.result.diagnostics()) fault(fmt::format("images[{}]", job.index), d.what, d.hint.c_str());
      continue;
    }
    file_.images[*job.name] = std::make_shared<const Image8>(std::move(*job.result));
  }
  for (GltfMaterial& m : file_.materials)
    for (GltfTexture* t : {&m.baseColor, &m.metallicRoughness, &m.normal, &m.occlusion, &m.emissive})
      if (const auto found = file_.images.find(t->name); found != file_.images.end()) t->image = found->second;
}

int Loader::materialOf(int index) {
  if (at(model_.materials, index)) return index;
  if (defaultMaterial_ < 0) {
    defaultMaterial_ = int(file_.materials.size());
    GltfMaterial standard;
    standard.name = "default";
    file_.materials.push_back(std::move(standard));
  }
  return defaultMaterial_;
}

// ---- Meshes and nodes ----

void Loader::readMeshes() {
  struct Job {
    size_t mesh, primitive;
    Result<Mesh> result = error("primitive", "not read");
  };
  std::vector<Job> jobs;
  uint64_t vertices = 0, indices = 0;
  for (size_t m = 0; m < model_.meshes.size(); ++m) {
    meshes_.emplace_back(model_.meshes[m].primitives.size());
    for (size_t p = 0; p < model_.meshes[m].primitives.size(); ++p) {
      const auto& primitive = model_.meshes[m].primitives[p];
      if (!hasTriangles(primitive)) {
        warnOnce("has points or lines", "only triangles are drawn");
        continue;
      }
      if (!primitive.targets.empty()) warnOnce("has morph targets", "the meshes are drawn without them");
      const auto position = primitive.attributes.find("POSITION");
      const auto* positions = position == primitive.attributes.end() ? nullptr : at(model_.accessors, position->second);
      const auto* list = at(model_.accessors, primitive.indices);
      const uint64_t corners = list ? list->count : positions ? positions->count : 0;
      // Strips and fans become three indices for each, and flat triangles a vertex for each.
      indices += 3 * corners;
      vertices += (positions ? positions->count : 0) + (primitive.attributes.count("NORMAL") ? 0 : 3 * corners);
      jobs.push_back({m, p});
    }
  }
  if (vertices > 4 * kMostGltfVertices || indices > 3 * kMostGltfIndices) {
    fault("the file", fmt::format("has meshes of up to {} vertices and {} indices", vertices, indices), "make them smaller, or share them between nodes");
    return;
  }
  parallelFor(jobs.size(), [&](size_t i) {
    const auto& mesh = model_.meshes[jobs[i].mesh];
    const auto& primitive = mesh.primitives[jobs[i].primitive];
    const auto* material = at(file_.materials, primitive.material);
    jobs[i].result = gltfMesh(model_, primitive, material ? material->normal.texCoord : 0,
                              fmt::format("{}: meshes[{}].primitives[{}]", place_, jobs[i].mesh, jobs[i].primitive));
  }, vertices > 5'000);
  for (Job& job : jobs) {
    if (!job.result) {
      problems.insert(problems.end(), job.result.diagnostics().begin(), job.result.diagnostics().end());
      continue;
    }
    const auto& mesh = model_.meshes[job.mesh];
    Mesh& made = *job.result;
    if (made.indices.empty()) continue;
    made.name = mesh.name.empty() ? fmt::format("mesh-{}", job.mesh) : mesh.name;
    if (mesh.primitives.size() > 1) made.name += fmt::format("-{}", job.primitive);
    Primitive& out = meshes_[job.mesh][job.primitive];
    const auto& in = mesh.primitives[job.primitive];
    out.material = materialOf(in.material);
    if (in.attributes.count("COLOR_0")) file_.materials[size_t(out.material)].vertexColors = true;
    out.mesh = std::make_shared<const Mesh>(std::move(made));
  }
}

glm::mat4 localMatrix(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return glm::mat4(glm::make_mat4(node.matrix.data()));
  glm::dmat4 m(1);
  const auto& t = node.translation;
  const auto& r = node.rotation;
  const auto& s = node.scale;
  if (t.size() == 3) m[3] = glm::dvec4(t[0], t[1], t[2], 1);
  if (r.size() == 4) {
    const glm::dquat q(r[3], r[0], r[1], r[2]);
    const double length = glm::length(q);
    if (length > 1e-12 && std::isfinite(length)) m = m * glm::mat4_cast(q / length);
  }
  if (s.size() == 3)
    for (int c = 0; c < 3; ++c) m[c] *= s[size_t(c)];
  return glm::mat4(m);
}

bool isFinite(const glm::mat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

void Loader::addNode(const tinygltf::Node& node, const glm::mat4& worldFromModel) {
  if (!at(model_.meshes, node.mesh)) return;
  if (node.skin >= 0) warnOnce("has skinned meshes", "they are drawn as they are modelled, without their skeleton");
  // A skinned mesh lies where its skeleton puts it, whatever its node says.
  const glm::mat4 place = node.skin >= 0 ? glm::mat4(1) : worldFromModel;
  for (const Primitive& primitive : meshes_[size_t(node.mesh)])
    if (primitive.mesh)
      file_.nodes.push_back({node.name.empty() ? primitive.mesh->name : node.name, primitive.mesh, place, primitive.material});
}

void Loader::readNodes() {
  struct Visit {
    int node;
    glm::mat4 parent;
  };
  std::vector<Visit> stack;
  const auto* scene = at(model_.scenes, model_.defaultScene);
  if (!scene) scene = at(model_.scenes, 0);
  if (scene) {
    for (auto i = scene->nodes.rbegin(); i != scene->nodes.rend(); ++i) stack.push_back({*i, glm::mat4(1)});
  } else {
    std::set<int> children;
    for (const auto& node : model_.nodes) children.insert(node.children.begin(), node.children.end());
    for (int i = int(model_.nodes.size()) - 1; i >= 0; --i)
      if (!children.count(i)) stack.push_back({i, glm::mat4(1)});
  }
  size_t visited = 0;
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const auto* node = at(model_.nodes, visit.node);
    // The check made sure of a tree: a node met twice would be a fault of its own.
    if (!node || ++visited > model_.nodes.size()) return fault("nodes", "do not form a tree");
    const glm::mat4 world = visit.parent * localMatrix(*node);
    if (!isFinite(world)) return fault(fmt::format("nodes[{}]", visit.node), "has a transform that is not finite");
    addNode(*node, world);
    if (file_.nodes.size() > kMostInstances) return fault("the file", "draws more than a million instances", "merge meshes");
    for (auto i = node->children.rbegin(); i != node->children.rend(); ++i) stack.push_back({*i, world});
  }
  if (file_.nodes.empty() && problems.empty()) fault("the file", "draws no triangles", "name a model that has meshes in its scene");
}

}  // namespace

Result<GltfFile> loadGltf(const fs::path& path, Diagnostics& warnings) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.diagnostics();
  return parseGltf(*bytes, path, warnings);
}

Result<GltfFile> parseGltf(std::string_view bytes, const fs::path& path, Diagnostics& warnings) {
  Result<CheckedGltf> checked = checkGltf(bytes, path, warnings);
  if (!checked) return checked.diagnostics();
  Result<tinygltf::Model> model = parse(bytes, path, *checked);
  if (!model) return model.diagnostics();

  GltfFile file;
  file.path = path;
  std::error_code code;
  if (const fs::path absolute = fs::absolute(path, code); !code) file.path = absolute.lexically_normal();
  Loader loader(*model, path.string(), file, warnings);
  loader.readMaterials();
  loader.readPictures();
  loader.readMeshes();
  if (loader.problems.empty()) loader.readNodes();
  if (!loader.problems.empty()) return loader.problems;
  if (file.materials.empty()) file.materials.emplace_back();
  return file;
}

Result<std::vector<GltfPicture>> gltfPictures(const fs::path& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.diagnostics();
  Diagnostics warnings;
  Result<CheckedGltf> checked = checkGltf(*bytes, path, warnings);
  if (!checked) return checked.diagnostics();
  const Result<tinygltf::Model> model = parse(*bytes, path, *checked);
  if (!model) return model.diagnostics();
  std::vector<GltfPicture> pictures;
  for (const tinygltf::Image& image : model->images) {
    const bool named = !image.name.empty() || image.uri.starts_with("data:");
    pictures.push_back({named ? image.name : fs::path(image.uri).filename().string(), {image.image.begin(), image.image.end()}});
  }
  return pictures;
}

}  // namespace glint
