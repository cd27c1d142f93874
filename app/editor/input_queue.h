// What the mouse and the keyboard did, in order. The window's callbacks and the headless driver both push here.
#pragma once

#include <imgui.h>

#include <deque>
#include <string>

#include "app/editor/keys.h"

namespace glint {

struct InputEvent {
  enum class Kind { Move, Button, Wheel, Key, Text, Leave } kind = Kind::Move;
  ImVec2 position{};      // Move: in framebuffer pixels
  int button = 0;         // Button: 0 left, 1 right, 2 middle
  bool down = false;      // Button, Key
  float amount = 0;       // Wheel: positive away from the user
  Key key = Key::Space;   // Key
  Modifiers modifiers;    // held while it happened: Button, Wheel, Key
  std::string text;       // Text: UTF-8
};

class InputQueue {
 public:
  void push(InputEvent event) { events_.push_back(std::move(event)); }
  bool empty() const { return events_.empty(); }

  // Before NewFrame(): hands ImGui as many events as one frame can tell apart. A press and its release in one frame
  // would be lost (ImGui 1.86 sees states, not events), so what follows a press waits for the next frame.
  void feed();

 private:
  std::deque<InputEvent> events_;
};

}  // namespace glint
