// A primitive of a loaded glTF as triangles.
#pragma once

#include <string>

#include "materials/base/diagnostic.h"
#include "renderer/mesh.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace glint {

// Whether a primitive draws triangles (and not points or lines).
bool hasTriangles(const tinygltf::Primitive&);

// Its vertices, with what the file does not say computed: flat normals (glTF 2.0, 3.7.2.1: then the file's
// tangents count for nothing), tangents along the uv set that the normal map uses. Nothing in the model is
// trusted: every index and range is checked as it is used. `place` names the primitive.
Result<Mesh> gltfMesh(const tinygltf::Model&, const tinygltf::Primitive&, int normalMapTexCoord,
                      const std::string& place);


}  // namespace glint
