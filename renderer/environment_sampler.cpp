#include "renderer/environment_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace glint {
namespace {

// Sums from 0 to 1; even where all is black.
void cumulate(const std::vector<double>& parts, float* sums) {
  double total = 0;
  for (const double part : parts) total += part;
  double sum = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    sums[i] = static_cast<float>(total > 0 ? sum / total : static_cast<double>(i) / static_cast<double>(parts.size()));
    sum += parts[i];
  }
  sums[parts.size()] = 1;
}

gl::Texture texture(GLenum internalFormat, GLenum format, int width, int height, const float* data, GLenum filter) {
  gl::Texture made = gl::createTexture2D(internalFormat, width, height);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTextureSubImage2D(made.id(), 0, 0, 0, width, height, format, GL_FLOAT, data);
  glTextureParameteri(made.id(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
  glTextureParameteri(made.id(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  glTextureParameteri(made.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(made.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return made;
}

}  // namespace

EnvironmentSampler::Shares EnvironmentSampler::sharesOf(const ImageF& image) {
  const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
  std::vector<float> luminance(width * height);
  for (size_t i = 0; i < luminance.size(); ++i) {
    const float* p = &image.data[3 * i];
    luminance[i] = 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
  }
  Shares shares{image.width, image.height, std::vector<float>((width + 1) * height), std::vector<float>(height + 1)};
  std::vector<double> row(width), blended(width), rows(height);
  for (size_t y = 0; y < height; ++y) {
    // The mean of a linear blend over a texel: 1/8, 6/8, 1/8 of it and its neighbours.
    const float* above = &luminance[(y > 0 ? y - 1 : y) * width];
    const float* here = &luminance[y * width];
    const float* below = &luminance[(y + 1 < height ? y + 1 : y) * width];
    for (size_t x = 0; x < width; ++x) blended[x] = (double(above[x]) + 6.0 * double(here[x]) + double(below[x])) / 8;
    double sum = 0;
    for (size_t x = 0; x < width; ++x) {
      row[x] = (blended[x > 0 ? x - 1 : width - 1] + 6 * blended[x] + blended[x + 1 < width ? x + 1 : 0]) / 8;
      sum += row[x];
    }
    cumulate(row, &shares.columns[y * (width + 1)]);
    rows[y] = sum * std::sin((static_cast<double>(y) + 0.5) / static_cast<double>(height) * std::numbers::pi);
  }
  cumulate(rows, shares.rows.data());
  return shares;
}

EnvironmentSampler::EnvironmentSampler(const ImageF& image) {
  const Shares shares = sharesOf(image);
  radiance_ = texture(GL_RGB32F, GL_RGB, image.width, image.height, image.data.data(), GL_LINEAR);
  columns_ = texture(GL_R32F, GL_RED, shares.width + 1, shares.height, shares.columns.data(), GL_NEAREST);
  rows_ = texture(GL_R32F, GL_RED, shares.height + 1, 1, shares.rows.data(), GL_NEAREST);
}

void EnvironmentSampler::bind() const {
  glBindTextureUnit(6, radiance_.id());
  glBindTextureUnit(7, columns_.id());
  glBindTextureUnit(10, rows_.id());
}

}  // namespace glint
