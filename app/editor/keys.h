// The keyboard by one name for each key, whatever ImGui's version: 1.86 indexes its state by the platform's codes
// (GLFW's, headless too), 1.87 and later by ImGuiKey.
#pragma once

#include <imgui.h>

#include <string>

namespace glint {

// The values are GLFW's.
enum class Key : int {
  Space = 32, LeftBracket = 91, RightBracket = 93,
  Digit0 = 48, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
  A = 65, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
  Escape = 256, Enter, Tab, Backspace, Insert, Delete, Right, Left, Down, Up, PageUp, PageDown, Home, End,
  F1 = 290, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
};

struct Modifiers {
  bool control = false, shift = false, alt = false;
  bool operator==(const Modifiers&) const = default;
};
inline constexpr Modifiers kNoModifiers{}, kControl{.control = true}, kShift{.shift = true}, kAlt{.alt = true},
    kControlShift{.control = true, .shift = true};

bool keyPressed(Key, bool repeat = false);
bool keyDown(Key);
Modifiers modifiers();

// The key went down with exactly these modifiers and no text is being typed.
bool shortcut(Modifiers, Key, bool repeat = false);
// The same for commands on whole files, which also hold while a text field has the keyboard.
bool fileShortcut(Modifiers, Key);
// "Ctrl+Shift+Z", for menus.
std::string shortcutText(Modifiers, Key);

// For synthetic input; before NewFrame(). `setUpKeyMap` once after CreateContext() (1.86 needs it).
void setUpKeyMap();
void feedKey(Key, bool down);
void feedModifiers(Modifiers);
void feedMouse(ImVec2 position);
void feedButton(int button, bool down);
void feedWheel(float amount);

}  // namespace glint
