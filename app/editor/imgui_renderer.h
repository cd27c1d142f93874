// Draws Dear ImGui's lists with OpenGL 4.5. Our own, because the packaged back end loads its functions through GLX
// and so cannot run on OSMesa. An ImTextureID is a GL texture name.
#pragma once

#include <imgui.h>

#include <memory>

namespace glint {

inline ImTextureID imguiTexture(unsigned name) {
  return (ImTextureID)(intptr_t)name;  // NOLINT: a pointer in some versions of ImGui, a number in others
}

// Belongs to the context that was current when it was made.
class ImGuiRenderer {
 public:
  ImGuiRenderer();
  ~ImGuiRenderer();
  ImGuiRenderer(const ImGuiRenderer&) = delete;

  // After Fonts::build() changed the atlas.
  void uploadFonts();

  // Draws into the framebuffer that is bound, whose size is DisplaySize * FramebufferScale. Sets all the state it
  // needs, and restores none: the editor's context draws nothing else.
  void draw(const ImDrawData&);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace glint
