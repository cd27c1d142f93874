// The approximations of Karis 2014, "Physically Based Shading on Mobile".
#ifndef GLINT_TERMS_MOBILE
#define GLINT_TERMS_MOBILE

// Scale on F0 and bias, instead of the table of an environment BRDF; fitted to GGX with k = alpha / 2. Off by up to
// 0.18 at F0 = 0.04 and 0.27 at F0 = 1, and its bias goes down to -0.0024.
vec2 envBrdfApprox(float roughness, float NoV) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a004 = min(r.x * r.x, exp2(-9.28 * NoV)) * r.x + r.y;
  return vec2(-1.04, 1.04) * a004 + r.zw;
}

// Nearly the same for F0 = 0.04, in fewer operations.
float envBrdfApproxNonmetal(float roughness, float NoV) {
  vec2 r = roughness * vec2(-1.0, -0.0275) + vec2(1.0, 0.0425);
  return min(r.x * r.x, exp2(-9.28 * NoV)) * r.x + r.y;
}

// A spherical Gaussian about the reflected view instead of D, with neither its 1/pi nor the 1/4 of the change from half
// vectors to light directions: over the light's directions it comes to 4 for smooth surfaces. RoL = r.l.
float approximateD(float alpha2, float RoL) {
  float inverse = 1.0 / alpha2;
  const float kLog2E = 1.44269504;
  return inverse * exp2((0.5 * inverse + 0.275) * kLog2E * (RoL - 1.0));
}

#endif
