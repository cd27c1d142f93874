// The materials of a glTF as graphs, so that they can be edited, compiled and compared like any other.
#pragma once

#include "materials/graph.h"
#include "renderer/gltf_loader.h"
#include "renderer/surface_material.h"

namespace glint {

// The core metallic-roughness material: each texture's sample times its factor, factors as parameters (so two
// materials with the same textures in use share one program), metallic and roughness from B and G, occlusion from
// R, alpha as opacityMask where it counts. The textures are those of putPictures().
Material gltfMaterialGraph(const GltfMaterial&, const GltfFile&);

// Makes the file's pictures known, by the names that the graphs use.
void putPictures(const GltfFile&, TextureCache&);

// What a graph does not say: sides and the cut of a mask.
void setSurfaceState(const GltfMaterial&, SurfaceMaterial&);

}  // namespace glint
