#include "app/editor/keys.h"

namespace glint {
namespace {

#if IMGUI_VERSION_NUM >= 18700
ImGuiKey imguiKey(Key key) {
  const int code = static_cast<int>(key);
  if (key >= Key::A && key <= Key::Z) return static_cast<ImGuiKey>(ImGuiKey_A + (code - int(Key::A)));
  if (key >= Key::Digit0 && key <= Key::Digit9) return static_cast<ImGuiKey>(ImGuiKey_0 + (code - int(Key::Digit0)));
  if (key >= Key::F1 && key <= Key::F12) return static_cast<ImGuiKey>(ImGuiKey_F1 + (code - int(Key::F1)));
  switch (key) {
    case Key::Space: return ImGuiKey_Space;
    case Key::LeftBracket: return ImGuiKey_LeftBracket;
    case Key::RightBracket: return ImGuiKey_RightBracket;
    case Key::Escape: return ImGuiKey_Escape;
    case Key::Enter: return ImGuiKey_Enter;
    case Key::Tab: return ImGuiKey_Tab;
    case Key::Backspace: return ImGuiKey_Backspace;
    case Key::Insert: return ImGuiKey_Insert;
    case Key::Delete: return ImGuiKey_Delete;
    case Key::Right: return ImGuiKey_RightArrow;
    case Key::Left: return ImGuiKey_LeftArrow;
    case Key::Down: return ImGuiKey_DownArrow;
    case Key::Up: return ImGuiKey_UpArrow;
    case Key::PageUp: return ImGuiKey_PageUp;
    case Key::PageDown: return ImGuiKey_PageDown;
    case Key::Home: return ImGuiKey_Home;
    case Key::End: return ImGuiKey_End;
    default: return ImGuiKey_None;
  }
}
#endif

}  // namespace

bool keyPressed(Key key, bool repeat) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyPressed(imguiKey(key), repeat);
#else
  return ImGui::IsKeyPressed(static_cast<int>(key), repeat);
#endif
}

bool keyDown(Key key) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyDown(imguiKey(key));
#else
  return ImGui::IsKeyDown(static_cast<int>(key));
#endif
}

Modifiers modifiers() {
  const ImGuiIO& io = ImGui::GetIO();
  return {.control = io.KeyCtrl, .shift = io.KeyShift, .alt = io.KeyAlt};
}

bool shortcut(Modifiers wanted, Key key, bool repeat) {
  return !ImGui::GetIO().WantTextInput && modifiers() == wanted && keyPressed(key, repeat);
}

bool fileShortcut(Modifiers wanted, Key key) { return modifiers() == wanted && keyPressed(key, false); }

std::string shortcutText(Modifiers wanted, Key key) {
  std::string text;
  if (wanted.control) text += "Ctrl+";
  if (wanted.shift) text += "Shift+";
  if (wanted.alt) text += "Alt+";
  const int code = static_cast<int>(key);
  if (code > 32 && code < 127) return text + static_cast<char>(code);
  if (key >= Key::F1 && key <= Key::F12) return text + "F" + std::to_string(code - static_cast<int>(Key::F1) + 1);
  switch (key) {
    case Key::Space: return text + "Space";
    case Key::Delete: return text + "Del";
    case Key::Home: return text + "Home";
    case Key::Tab: return text + "Tab";
    case Key::Escape: return text + "Esc";
    default: return text + "?";
  }
}

void setUpKeyMap() {
#if IMGUI_VERSION_NUM < 18700
  const std::pair<ImGuiKey, Key> map[] = {
      {ImGuiKey_Tab, Key::Tab},       {ImGuiKey_LeftArrow, Key::Left},  {ImGuiKey_RightArrow, Key::Right},
      {ImGuiKey_UpArrow, Key::Up},    {ImGuiKey_DownArrow, Key::Down},  {ImGuiKey_PageUp, Key::PageUp},
      {ImGuiKey_PageDown, Key::PageDown}, {ImGuiKey_Home, Key::Home},   {ImGuiKey_End, Key::End},
      {ImGuiKey_Insert, Key::Insert}, {ImGuiKey_Delete, Key::Delete},   {ImGuiKey_Backspace, Key::Backspace},
      {ImGuiKey_Space, Key::Space},   {ImGuiKey_Enter, Key::Enter},     {ImGuiKey_Escape, Key::Escape},
      {ImGuiKey_A, Key::A},           {ImGuiKey_C, Key::C},             {ImGuiKey_V, Key::V},
      {ImGuiKey_X, Key::X},           {ImGuiKey_Y, Key::Y},             {ImGuiKey_Z, Key::Z}};
  for (const auto& [to, from] : map) ImGui::GetIO().KeyMap[to] = static_cast<int>(from);
#endif
}

void feedKey(Key key, bool down) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddKeyEvent(imguiKey(key), down);
#else
  ImGui::GetIO().KeysDown[static_cast<int>(key)] = down;
#endif
}

void feedModifiers(Modifiers held) {
  ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18900
  io.AddKeyEvent(ImGuiMod_Ctrl, held.control);
  io.AddKeyEvent(ImGuiMod_Shift, held.shift);
  io.AddKeyEvent(ImGuiMod_Alt, held.alt);
#elif IMGUI_VERSION_NUM >= 18700
  io.AddKeyEvent(ImGuiKey_ModCtrl, held.control);
  io.AddKeyEvent(ImGuiKey_ModShift, held.shift);
  io.AddKeyEvent(ImGuiKey_ModAlt, held.alt);
#else
  io.KeyCtrl = held.control;
  io.KeyShift = held.shift;
  io.KeyAlt = held.alt;
#endif
}

void feedMouse(ImVec2 position) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddMousePosEvent(position.x, position.y);
#else
  ImGui::GetIO().MousePos = position;
#endif
}

void feedButton(int button, bool down) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddMouseButtonEvent(button, down);
#else
  ImGui::GetIO().MouseDown[button] = down;
#endif
}

void feedWheel(float amount) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddMouseWheelEvent(0, amount);
#else
  ImGui::GetIO().MouseWheel += amount;
#endif
}

}  // namespace glint
