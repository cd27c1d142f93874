// What lights bring with them: Karis 2013, "Real Shading in Unreal Engine 4", course notes.
#ifndef GLINT_TERMS_LIGHT
#define GLINT_TERMS_LIGHT

// Eq. 9: inverse square, windowed to reach zero at the radius, and finite at the light by a constant (1 in the notes). In
// 1/m^2, from squared metres, 1 / radius^2 and m^2.
float windowedFalloff(float distance2, float inverseRadius2, float constant) {
  float ratio2 = distance2 * inverseRadius2;
  float window = clamp(1.0 - ratio2 * ratio2, 0.0, 1.0);
  return window * window / max(distance2 + constant, 1e-12);
}

// Eq. 10: the width of a lobe that a light of this size blurs. The notes' factor is 3; 2 has the right limit for smooth
// surfaces.
float widenedAlpha(float alpha, float size, float distance, float factor) {
  return clamp(alpha + size / (factor * distance), 0.0, 1.0);
}

// Eq. 14 and 20: what a representative point's lobe is scaled by, so that a light does not gain energy with its size:
// by the width over the widened one, once for each dimension that the light has.
float sphereNormalization(float alpha, float widened) { return (alpha / widened) * (alpha / widened); }
float lineNormalization(float alpha, float widened) { return alpha / widened; }

#endif
