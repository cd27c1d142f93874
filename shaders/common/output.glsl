// From scene-referred radiance to what the target holds.
#include "shaders/common/tonemap.glsl"

// What a pass writes for radiance c. Alpha 1 marks a sound pixel: NaN and infinity become black with alpha 0, and
// are counted where the picture is read.
vec4 outputColor(vec3 c) {
  // Comparisons with NaN are false, so this is also true of no NaN.
  // One sum: compilers make a maximum of several comparisons, and a maximum forgets NaN.
  bool sound = abs(c.r) + abs(c.g) + abs(c.b) < 1e30;
#ifdef SCENE_REFERRED
  c *= view.exposureScale;
#else
  c = displayed(c * view.exposureScale);
#endif
  return sound ? vec4(c, 1.0) : vec4(0.0);
}
