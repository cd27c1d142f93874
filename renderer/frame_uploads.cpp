#include "renderer/frame_uploads.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace glint {

size_t FrameUploads::append(std::span<const std::byte> bytes) {
  const size_t offset = (bytes_.size() + kAlignment - 1) / kAlignment * kAlignment;
  bytes_.resize(offset + std::max<size_t>(bytes.size(), 16));
  if (!bytes.empty()) std::memcpy(bytes_.data() + offset, bytes.data(), bytes.size());
  return offset;
}

void FrameUploads::upload() {
  if (bytes_.size() > capacity_) {
    capacity_ = std::bit_ceil(bytes_.size());
    buffer_ = gl::createBuffer(std::vector<std::byte>(capacity_));
  }
  glNamedBufferSubData(buffer_.id(), 0, static_cast<GLsizeiptr>(bytes_.size()), bytes_.data());
}

void FrameUploads::bind(GLenum target, GLuint binding, size_t offset, size_t size) const {
  glBindBufferRange(target, binding, buffer_.id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(std::max<size_t>(size, 16)));
}

}  // namespace glint
