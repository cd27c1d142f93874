// Pictures in memory.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "materials/base/check.h"

namespace glint {

// Row 0 is the top row; pixels are interleaved; `channels` is 1..4.
template <class T>
struct Pixels {
  int width = 0, height = 0, channels = 0;
  std::vector<T> data;

  Pixels() = default;
  Pixels(int w, int h, int c) : width(w), height(h), channels(c), data(size_t(w) * size_t(h) * size_t(c)) {}
  bool empty() const { return data.empty(); }
  T* at(int x, int y) { return &data[(size_t(y) * size_t(width) + size_t(x)) * size_t(channels)]; }
  const T* at(int x, int y) const { return const_cast<Pixels*>(this)->at(x, y); }
  bool operator==(const Pixels&) const = default;
};

// 8 bits: display-referred sRGB for pictures, plain numbers for data textures.
using Image8 = Pixels<uint8_t>;
// Linear Rec.709, scene-referred.
using ImageF = Pixels<float>;
using Image8Ptr = std::shared_ptr<const Image8>;

}  // namespace glint
