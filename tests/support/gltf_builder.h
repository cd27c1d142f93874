// Small glTF files made in code.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace glint::test {

class GltfBuilder {
 public:
  nlohmann::ordered_json json = {{"asset", {{"version", "2.0"}}}};
  std::string bin;

  int view(const std::string& bytes, int stride = 0) {
    while (bin.size() % 4) bin += '\0';
    nlohmann::ordered_json v = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
    if (stride) v["byteStride"] = stride;
    bin += bytes;
    return push("bufferViews", v);
  }
  template <class T>
  static std::string bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
  }
  int accessor(int viewIndex, int component, const char* type, size_t count, bool normalized = false) {
    nlohmann::ordered_json a = {{"bufferView", viewIndex}, {"componentType", component}, {"count", count}, {"type", type}};
    if (normalized) a["normalized"] = true;
    return push("accessors", a);
  }
  int floats(const std::vector<float>& values, const char* type, int components) {
    return accessor(view(bytesOf(values)), 5126, type, values.size() / size_t(components));
  }
  int push(const char* list, nlohmann::ordered_json item) {
    json[list].push_back(std::move(item));
    return int(json[list].size()) - 1;
  }

  // A mesh with one primitive, a node that shows it and a scene with that node.
  void show(nlohmann::ordered_json primitive) {
    const int mesh = push("meshes", {{"primitives", nlohmann::ordered_json::array({std::move(primitive)})}});
    const int node = push("nodes", {{"mesh", mesh}});
    if (!json.contains("scenes")) push("scenes", {{"nodes", nlohmann::ordered_json::array()}});
    json["scenes"][0]["nodes"].push_back(node);
    json["scene"] = 0;
  }
  // Right angle at the origin, legs of 1 along x and y.
  void showTriangle(nlohmann::ordered_json more = nlohmann::ordered_json::object()) {
    nlohmann::ordered_json primitive = {
        {"attributes",
         {{"POSITION", floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3)}, {"NORMAL", floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3)},
          {"TEXCOORD_0", floats({0, 1, 1, 1, 0, 0}, "VEC2", 2)}}},
        {"indices", accessor(view(bytesOf<uint16_t>({0, 1, 2})), 5123, "SCALAR", 3)}};
    primitive.update(more);
    show(primitive);
  }
  // An embedded picture and a texture of it.
  int texture(const std::string& picture, const char* mime = "image/png") {
    const int image = push("images", {{"bufferView", view(picture)}, {"mimeType", mime}});
    return push("textures", {{"source", image}});
  }

  std::string glb() const {
    nlohmann::ordered_json out = json;
    std::string data = bin;
    while (data.size() % 4) data += '\0';
    if (!data.empty()) out["buffers"] = {{{"byteLength", data.size()}}};
    std::string text = out.dump();
    while (text.size() % 4) text += ' ';
    return container(text, data);
  }
  static std::string container(const std::string& text, const std::string& data) {
    std::string file = "glTF";
    const auto word = [&](size_t v) {
      for (int i = 0; i < 4; ++i) file += char(v >> (8 * i));
    };
    word(2);
    word(12 + 8 + text.size() + (data.empty() ? 0 : 8 + data.size()));
    word(text.size());
    file += "JSON" + text;
    if (!data.empty()) {
      word(data.size());
      file += std::string("BIN\0", 4) + data;
    }
    return file;
  }
  // With the buffer as a data URI.
  std::string gltf() const {
    nlohmann::ordered_json out = json;
    out["buffers"] = {{{"byteLength", bin.size()}, {"uri", "data:application/octet-stream;base64," + base64(bin)}}};
    return out.dump(1);
  }
  static std::string base64(const std::string& bytes) {
    static const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
      uint32_t group = 0;
      for (size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
      for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
    return out;
  }
};

}  // namespace glint::test
