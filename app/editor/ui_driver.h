// The very same editor without a window: drawn into a framebuffer, its mouse and keys moved by a program. For tests, and
// for pictures of the editor.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/editor/editor.h"
#include "app/editor/input_queue.h"
#include "app/editor/ui.h"
#include "renderer/gl/objects.h"
#include "renderer/image.h"

namespace glint {

class UiDriver {
 public:
  UiDriver(gl::Context&, EditorOptions, glm::ivec2 size);
  ~UiDriver();

  Editor& editor() { return *editor_; }

  void frames(int count = 1);
  // Until the render thread has nothing left to do, at most `seconds`; false when it still works.
  bool settle(double seconds = 60);
  // Until every model's badge has its verdict, likewise.
  bool awaitHealth(double seconds = 60);

  // Input, one change a frame. Positions are framebuffer pixels.
  void move(ImVec2);
  void press(int button = 0, Modifiers = {});
  void release(int button = 0, Modifiers = {});
  void click(ImVec2, int button = 0, Modifiers = {});
  void doubleClick(ImVec2);
  void drag(ImVec2 from, ImVec2 to, int button = 0, Modifiers = {});
  void wheel(ImVec2, float amount, Modifiers = {});
  void key(Key, Modifiers = {});
  void type(const std::string& text);

  // Widgets by the names they have on screen ("Properties/Roughness"); asking for one that is not there stops the test
  // with what is.
  bool has(const std::string& widget);
  ImVec2 at(const std::string& widget);
  ui::Rect rect(const std::string& widget);
  void click(const std::string& widget, int button = 0, Modifiers held = {}) { click(at(widget), button, held); }

  Image8 screenshot();

 private:
  void step(InputEvent);
  gl::Context& context_;
  glm::ivec2 size_;
  gl::Texture color_;
  gl::Framebuffer framebuffer_;
  std::unique_ptr<Editor> editor_;
  InputQueue input_;
};

}  // namespace glint
