#include "app/editor/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "app/command.h"
#include "app/editor/input_queue.h"
#include "renderer/gl/gl.h"

namespace glint {
namespace {

// What the callbacks write to; GLFW hands it back through the window.
struct Window {
  GLFWwindow* handle = nullptr;
  InputQueue input;
  Editor* editor = nullptr;
  int framesWanted = 3;        // ImGui settles in three
  ImVec2 pixelsPerUnit{1, 1};  // framebuffer pixels a unit of the window system's
  GLFWcursor* cursors[ImGuiMouseCursor_COUNT] = {};
  ImGuiMouseCursor cursor = ImGuiMouseCursor_Arrow;
  std::string clipboard;

  void wanted() { framesWanted = 3; }
};

Window& of(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }

Modifiers modifiersOf(int mods) {
  return {.control = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0, .shift = (mods & GLFW_MOD_SHIFT) != 0,
          .alt = (mods & GLFW_MOD_ALT) != 0};
}

// The state now; a modifier's own key event says how it was before.
Modifiers heldNow(GLFWwindow* window) {
  const auto down = [&](int a, int b) { return glfwGetKey(window, a) == GLFW_PRESS || glfwGetKey(window, b) == GLFW_PRESS; };
  return {.control = down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) || down(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER),
          .shift = down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT), .alt = down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
}

void listen(GLFWwindow* handle) {
  glfwSetCursorPosCallback(handle, [](GLFWwindow* w, double x, double y) {
    const ImVec2 scale = of(w).pixelsPerUnit;
    of(w).input.push({.kind = InputEvent::Kind::Move, .position = {float(x) * scale.x, float(y) * scale.y}});
    of(w).wanted();
  });
  glfwSetCursorEnterCallback(handle, [](GLFWwindow* w, int entered) {
    if (!entered) of(w).input.push({.kind = InputEvent::Kind::Leave});
    of(w).wanted();
  });
  glfwSetMouseButtonCallback(handle, [](GLFWwindow* w, int button, int action, int mods) {
    if (button > 2) return;
    of(w).input.push({.kind = InputEvent::Kind::Button, .button = button, .down = action == GLFW_PRESS, .modifiers = modifiersOf(mods)});
    of(w).wanted();
  });
  glfwSetScrollCallback(handle, [](GLFWwindow* w, double, double y) {
    of(w).input.push({.kind = InputEvent::Kind::Wheel, .amount = float(y), .modifiers = heldNow(w)});
    of(w).wanted();
  });
  glfwSetKeyCallback(handle, [](GLFWwindow* w, int key, int, int action, int) {
    of(w).wanted();
    if (key < 0 || action == GLFW_REPEAT) return;
    // The keypad's Enter is Enter; other keys that Glint has no name for only tell of their modifiers.
    const int known = key == GLFW_KEY_KP_ENTER ? GLFW_KEY_ENTER : key;
    of(w).input.push({.kind = InputEvent::Kind::Key, .down = action == GLFW_PRESS, .key = static_cast<Key>(known), .modifiers = heldNow(w)});
  });
  glfwSetCharCallback(handle, [](GLFWwindow* w, unsigned code) {
    std::string text;
    if (code < 0x80) text += char(code);
    else if (code < 0x800) text += {char(0xc0 | code >> 6), char(0x80 | (code & 0x3f))};
    else if (code < 0x10000) text += {char(0xe0 | code >> 12), char(0x80 | (code >> 6 & 0x3f)), char(0x80 | (code & 0x3f))};
    else text += {char(0xf0 | code >> 18), char(0x80 | (code >> 12 & 0x3f)), char(0x80 | (code >> 6 & 0x3f)), char(0x80 | (code & 0x3f))};
    of(w).input.push({.kind = InputEvent::Kind::Text, .text = text});
    of(w).wanted();
  });
  glfwSetDropCallback(handle, [](GLFWwindow* w, int count, const char** paths) {
    of(w).editor->openFiles({paths, paths + count});
    of(w).wanted();
  });
  glfwSetWindowCloseCallback(handle, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);
    of(w).editor->requestQuit();
    of(w).wanted();
  });
  glfwSetWindowRefreshCallback(handle, [](GLFWwindow* w) { of(w).wanted(); });
  glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* w, int, int) { of(w).wanted(); });
  glfwSetWindowContentScaleCallback(handle, [](GLFWwindow* w, float x, float) {
    of(w).editor->setScale(x);
    of(w).wanted();
  });
}

void setUpPlatform(Window& window) {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendPlatformName = "glint";
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
#if IMGUI_VERSION_NUM < 19110
  io.ClipboardUserData = &window;
  io.GetClipboardTextFn = [](void* user) { return glfwGetClipboardString(static_cast<Window*>(user)->handle); };
  io.SetClipboardTextFn = [](void* user, const char* text) { glfwSetClipboardString(static_cast<Window*>(user)->handle, text); };
#endif
  const std::pair<ImGuiMouseCursor, int> shapes[] = {
      {ImGuiMouseCursor_Arrow, GLFW_ARROW_CURSOR},        {ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR},
      {ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR},   {ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR},
      {ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR}};
  for (const auto& [cursor, shape] : shapes) window.cursors[cursor] = glfwCreateStandardCursor(shape);
}

void showCursor(Window& window) {
  const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
  if (wanted == window.cursor || wanted < 0) return;
  window.cursor = wanted;
  GLFWcursor* cursor = window.cursors[wanted];
  glfwSetCursor(window.handle, cursor ? cursor : window.cursors[ImGuiMouseCursor_Arrow]);
}

}  // namespace

int runWindow(gl::Context& context, EditorOptions options, const std::vector<std::filesystem::path>& files) {
  Window window{.handle = context.window()};
  glfwSetWindowUserPointer(window.handle, &window);
  float scale = 1, ignored = 1;
  glfwGetWindowContentScale(window.handle, &scale, &ignored);
  options.scale = scale;
  options.wake = [] { glfwPostEmptyEvent(); };
  Editor editor(context, std::move(options));
  window.editor = &editor;
  setUpPlatform(window);
  listen(window.handle);
  editor.openFiles(files);

  std::string title;
  double last = glfwGetTime();
  const auto draw = [&] {
    glm::ivec2 size{0}, units{0};
    glfwGetFramebufferSize(window.handle, &size.x, &size.y);
    glfwGetWindowSize(window.handle, &units.x, &units.y);
    if (size.x <= 0 || size.y <= 0) return false;
    window.pixelsPerUnit = {float(size.x) / float(std::max(1, units.x)), float(size.y) / float(std::max(1, units.y))};
    editor.session().width = units.x;
    editor.session().height = units.y;
    window.input.feed();
    const double now = glfwGetTime();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    editor.frame(size, float(std::min(now - last, 0.1)));
    last = now;
    showCursor(window);
    if (std::string wanted = editor.windowTitle(); wanted != title) glfwSetWindowTitle(window.handle, (title = wanted).c_str());
    glfwSwapBuffers(window.handle);
    return true;
  };
  while (!editor.quitting()) {
    const bool drew = window.framesWanted > 0 || !window.input.empty();
    if (drew) {
      window.framesWanted = std::max(0, window.framesWanted - 1);
      if (!draw()) window.framesWanted = 0;
    }
    if (window.framesWanted > 0 || !window.input.empty()) {
      glfwPollEvents();
      continue;
    }
    // Sleeps until something happens; looks at the plugins' files four times a second. A caret blinks meanwhile.
    glfwWaitEventsTimeout(0.25);
    if (editor.hasNews()) window.framesWanted = std::max(window.framesWanted, 2);
    else if (ImGui::GetIO().WantTextInput) window.framesWanted = std::max(window.framesWanted, 1);
  }
  for (GLFWcursor* cursor : window.cursors)
    if (cursor) glfwDestroyCursor(cursor);
  return kDone;
}

}  // namespace glint
