#include "app/editor/input_queue.h"

#include <cfloat>

namespace glint {

void InputQueue::feed() {
  while (!events_.empty()) {
    const InputEvent event = std::move(events_.front());
    events_.pop_front();
    switch (event.kind) {
      case InputEvent::Kind::Move:
        feedMouse(event.position);
        break;
      case InputEvent::Kind::Leave:
        feedMouse({-FLT_MAX, -FLT_MAX});
        break;
      case InputEvent::Kind::Wheel:
        feedModifiers(event.modifiers);
        feedWheel(event.amount);
        break;
      case InputEvent::Kind::Text:
        ImGui::GetIO().AddInputCharactersUTF8(event.text.c_str());
        break;
      case InputEvent::Kind::Button:
        feedModifiers(event.modifiers);
        feedButton(event.button, event.down);
        return;
      case InputEvent::Kind::Key:
        feedModifiers(event.modifiers);
        feedKey(event.key, event.down);
        return;
    }
    // A click belongs where the pointer is now: let a frame see the position first.
    if (!events_.empty() && events_.front().kind == InputEvent::Kind::Button &&
        event.kind == InputEvent::Kind::Move)
      return;
  }
}

}  // namespace glint
