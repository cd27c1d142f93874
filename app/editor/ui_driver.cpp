#include "app/editor/ui_driver.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace glint {

UiDriver::UiDriver(gl::Context& context, EditorOptions options, glm::ivec2 size) : context_(context), size_(size) {
  context_.makeCurrent();
  color_ = gl::createTexture2D(GL_RGBA8, size.x, size.y);
  const GLuint name = color_.id();
  framebuffer_ = gl::createFramebuffer({&name, 1});
  editor_ = std::make_unique<Editor>(context_, std::move(options));
  frames(3);
}

UiDriver::~UiDriver() { editor_.reset(); }

void UiDriver::frames(int count) {
  for (int i = 0; i < count; ++i) {
    input_.feed();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    editor_->frame(size_, 1 / 60.0f);
  }
}

bool UiDriver::settle(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    frames(2);
    if (editor_->render().settled()) {
      frames(3);
      if (editor_->render().settled()) return true;
    }
    // Only looks, and does not draw: on software GL the window's own frames would take most of the time from the
    // picture that is waited for.
    while (!editor_->render().hasFinished() && !editor_->render().settled()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
}

bool UiDriver::awaitHealth(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!editor_->health().settled()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  frames(3);
  return true;
}

void UiDriver::step(InputEvent event) {
  input_.push(std::move(event));
  do frames();
  while (!input_.empty());
}

void UiDriver::move(ImVec2 to) {
  step({.kind = InputEvent::Kind::Move, .position = to});
  frames();
}

void UiDriver::press(int button, Modifiers held) {
  step({.kind = InputEvent::Kind::Button, .button = button, .down = true, .modifiers = held});
}

void UiDriver::release(int button, Modifiers held) {
  step({.kind = InputEvent::Kind::Button, .button = button, .down = false, .modifiers = held});
  feedModifiers({});
  frames(2);
}

void UiDriver::click(ImVec2 where, int button, Modifiers held) {
  move(where);
  press(button, held);
  release(button, held);
}

void UiDriver::doubleClick(ImVec2 where) {
  move(where);
  for (int i = 0; i < 2; ++i) {
    press();
    step({.kind = InputEvent::Kind::Button, .button = 0, .down = false});
  }
  frames(2);
}

void UiDriver::drag(ImVec2 from, ImVec2 to, int button, Modifiers held) {
  move(from);
  press(button, held);
  constexpr int kSteps = 6;
  for (int i = 1; i <= kSteps; ++i) {
    const float t = float(i) / kSteps;
    step({.kind = InputEvent::Kind::Move, .position = {from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t}});
  }
  frames();
  release(button, held);
}

void UiDriver::wheel(ImVec2 where, float amount, Modifiers held) {
  move(where);
  step({.kind = InputEvent::Kind::Wheel, .amount = amount, .modifiers = held});
  feedModifiers({});
  frames(2);
}

void UiDriver::key(Key key, Modifiers held) {
  step({.kind = InputEvent::Kind::Key, .down = true, .key = key, .modifiers = held});
  step({.kind = InputEvent::Kind::Key, .down = false, .key = key, .modifiers = held});
  feedModifiers({});
  frames(2);
}

void UiDriver::type(const std::string& text) {
  step({.kind = InputEvent::Kind::Text, .text = text});
  frames(2);
}

bool UiDriver::has(const std::string& widget) { return ui::find(widget) != nullptr; }

ui::Rect UiDriver::rect(const std::string& widget) {
  const ui::Rect* found = ui::find(widget);
  std::string all;
  if (!found)
    for (const std::string& name : ui::names()) all += "\n  " + name;
  GLINT_CHECK(found, "no widget '{}' on screen; there are:{}", widget, all);
  return *found;
}

ImVec2 UiDriver::at(const std::string& widget) { return rect(widget).center(); }

Image8 UiDriver::screenshot() {
  frames(3);
  Image8 picture(size_.x, size_.y, 3);
  std::vector<uint8_t> rows(size_t(size_.x) * size_t(size_.y) * 4);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x)
      std::copy_n(&rows[(size_t(size_.y - 1 - y) * size_t(size_.x) + size_t(x)) * 4], 3, picture.at(x, y));
  return picture;
}

}  // namespace glint
