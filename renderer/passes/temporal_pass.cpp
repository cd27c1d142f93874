#include "renderer/passes/temporal_pass.h"

#include <algorithm>

namespace glint {
namespace {

// The share of the newest picture never falls below this, so that what changes on its own is shown soon.
constexpr float kLeastShare = 0.1f;

}  // namespace

void TemporalPass::resize(glm::ivec2 size) {
  if (size == size_) return;
  size_ = size;
  age_ = 0;
  for (History& h : history_) {
    h.texture = gl::createTexture2D(GL_RGBA16F, size.x, size.y);
    glTextureParameteri(h.texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(h.texture.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(h.texture.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(h.texture.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    const GLuint color = h.texture.id();
    h.framebuffer = gl::createFramebuffer(std::span(&color, 1));
  }
}

std::vector<TemporalPass::Past> TemporalPass::pastOf(const Frame& frame) const {
  std::vector<Past> past;
  for (const ReadyView& r : frame.views) {
    const glm::ivec4 rectangle = r.view.rectangle;
    glm::mat4 straight(1);   // undoes the offset, of which prepareView() has the other sign
    straight[3][0] = 2 * frame.jitter.x / static_cast<float>(rectangle.z);
    straight[3][1] = 2 * frame.jitter.y / static_cast<float>(rectangle.w);
    past.push_back({straight * r.view.block.clipFromWorld, r.view.block.depthTerms, rectangle});
  }
  return past;
}

const gl::Program& TemporalPass::begin(const Frame& frame, bool remember, GLuint framebuffer, GLuint current, GLuint before) {
  const gl::Program& program = programs_.shipped(
      Rectangles::vertexShader(), {"shaders/passes/temporal.frag", remember ? std::vector<std::string>{"REMEMBER"} : std::vector<std::string>{}, {}});
  frame.targets.bindGbuffer();
  for (const auto& [unit, texture] : {std::pair{16u, current}, {17u, before}}) {
    glBindTextureUnit(unit, texture);
    glBindSampler(unit, 0);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size_.x, size_.y);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  glEnable(GL_FRAMEBUFFER_SRGB);   // which the history has none of
  program.set2("jitter", frame.jitter.x, frame.jitter.y);
  return program;
}

void TemporalPass::remember(const Frame& frame, GLuint sum, int count) {
  resize(frame.size());
  newest_ = 1 - newest_;
  const gl::Program& program = begin(frame, true, history_[newest_].framebuffer.id(), sum, history_[1 - newest_].texture.id());
  program.set("share", 1.0f / static_cast<float>(count));
  for (const ReadyView& r : frame.views) {
    frame.uploads.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
    frame.setScreen(program, r);
    frame.drawSurfaces(program, r);
  }
  past_ = pastOf(frame);
  age_ = count;
}

void TemporalPass::draw(const Frame& frame, GLuint current, FrameTargets::Picture& picture) {
  resize(frame.size());
  const std::vector<Past> now = pastOf(frame);
  const auto sameRectangle = [](const Past& a, const Past& b) { return a.rectangle == b.rectangle; };
  if (!std::equal(now.begin(), now.end(), past_.begin(), past_.end(), sameRectangle)) {
    past_ = now;
    age_ = 0;
  }
  newest_ = 1 - newest_;
  const GLuint colors[] = {picture.texture.id(), history_[newest_].texture.id()};
  const gl::Framebuffer both = gl::createFramebuffer(colors);
  const gl::Program& program = begin(frame, false, both.id(), current, history_[1 - newest_].texture.id());
  program.set("share", std::max(1 / static_cast<float>(age_ + 1), kLeastShare));
  for (size_t i = 0; i < frame.views.size(); ++i) {
    const ReadyView& r = frame.views[i];
    frame.uploads.bind(GL_UNIFORM_BUFFER, 0, r.viewBlock, sizeof(ViewBlock));
    frame.setScreen(program, r);
    program.setMatrix4("pastClipFromWorld", &past_[i].clipFromWorld[0][0]);
    program.set4("pastDepthTerms", &past_[i].depthTerms.x);
    frame.drawSurfaces(program, r);
  }
  past_ = now;
  ++age_;
}

}  // namespace glint
