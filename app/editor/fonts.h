// The editor's typefaces, rasterised by FreeType for the display's scale so that text is always sharp.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

namespace glint {

// ImGui keeps pointers into an atlas, so there is one Fonts for one ImGui context, and it must outlive it.
class Fonts {
 public:
  Fonts();

  // (Re)builds the atlas for `scale` framebuffer pixels a UI unit, 0.5..8. True when it changed: the renderer must
  // then upload the atlas again. Never between NewFrame() and Render().
  bool build(float scale);
  float scale() const { return scale_; }

  ImFont* regular() const { return regular_; }
  ImFont* bold() const { return bold_; }
  ImFont* small() const { return small_; }
  ImFont* heading() const { return heading_; }
  ImFont* mono() const { return mono_; }

  // The faces of the node canvas at one of its zooms: rasterised at that very size, so zoomed text is sharp too.
  struct CanvasFaces {
    float zoom;
    ImFont* regular;
    ImFont* bold;
  };
  const std::vector<CanvasFaces>& canvas() const { return canvas_; }

 private:
  std::string inter_, interBold_, monoBytes_;
  float scale_ = 0;
  ImFont *regular_ = nullptr, *bold_ = nullptr, *small_ = nullptr, *heading_ = nullptr, *mono_ = nullptr;
  std::vector<CanvasFaces> canvas_;
};

// Sizes of the faces in UI units.
inline constexpr float kTextSize = 14, kSmallSize = 12, kHeadingSize = 19, kMonoSize = 13, kCanvasSize = 13;
// The zooms of the node canvas.
inline constexpr float kCanvasZooms[] = {0.35f, 0.5f, 0.65f, 0.8f, 1.0f, 1.25f, 1.6f, 2.0f};

}  // namespace glint
