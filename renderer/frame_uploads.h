// Bytes gathered for one upload a frame: uniform blocks, light lists and tiles together.
#pragma once

#include <span>
#include <vector>

#include "renderer/gl/objects.h"

namespace glint {

class FrameUploads {
 public:
  // The offset at which the bytes will lie, aligned for any binding.
  size_t append(std::span<const std::byte> bytes);
  void upload();
  void clear() { bytes_.clear(); }
  void bind(GLenum target, GLuint binding, size_t offset, size_t size) const;
  GLuint id() const { return buffer_.id(); }

 private:
  static constexpr size_t kAlignment = 256;
  std::vector<std::byte> bytes_;
  gl::Buffer buffer_;
  size_t capacity_ = 0;
};

}  // namespace glint
