// Material textures on the device.
#pragma once

#include <map>
#include <unordered_map>

#include "renderer/gl/objects.h"
#include "renderer/scene.h"

namespace glint {

// Uploads each image once for each colour space and use, with a full mip chain, always as four 8-bit channels: software GL
// compiles a shader anew for every texture format it meets.
class DeviceTextures {
 public:
  // Binds the slot's texture and sampler to a unit; a null image is white. `normalShare` is the part of a pixel that normals
  // are averaged over, where their variance is wanted: a slot of normals then has in its alpha what
  // renderer/normal_variance.h makes of it, and is read from as fine a level. 0: as any other.
  void bind(GLuint unit, const Image8Ptr&, const TextureSlot&, float normalShare = 0);
  void forgetUnused();

 private:
  struct Entry {
    std::weak_ptr<const Image8> source;
    gl::Texture texture;
  };
  GLuint texture(const Image8Ptr&, ColorSpace, bool variance);
  GLuint sampler(Filter, Wrap s, Wrap t, float bias);

  std::map<std::tuple<const Image8*, ColorSpace, bool>, Entry> textures_;
  std::map<std::tuple<Filter, Wrap, Wrap, float>, gl::Sampler> samplers_;
  gl::Texture white_;
};

}  // namespace glint
