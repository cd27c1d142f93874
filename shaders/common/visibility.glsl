// What the passes of shadows and of occlusion left for each pixel (FrameTargets::visibility): in layer 0 how open it is to its
// surroundings, in the others how much of one light arrives.
#if defined(SHADOWS) || defined(SCREEN_OCCLUSION)
layout(binding = 16) uniform sampler2DArray gVisibility;
#endif
float withShadows = 1.0;   // 0: as if nothing stood in the way

// Of the light with this number of a shadow; 0 has none.
float lightVisibility(float number) {
#ifdef SHADOWS
  return number < 0.5 ? 1.0 : mix(1.0, texelFetch(gVisibility, ivec3(ivec2(gl_FragCoord.xy), int(number + 0.5)), 0).r, withShadows);
#else
  return 1.0;
#endif
}
float surroundingsVisibility() {
#ifdef SCREEN_OCCLUSION
  return mix(1.0, texelFetch(gVisibility, ivec3(ivec2(gl_FragCoord.xy), 0), 0).r, withShadows);
#else
  return 1.0;
#endif
}
