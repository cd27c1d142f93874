// For a model whose specular part is all of it (MODEL_IS_WHOLE): the part of f that is the same for all lights, which an
// environment lights as it lights a diffuse surface, around the normal. What is above it is a lobe around the mirror's
// direction. The median over the hemisphere, weighted with the cosine: no lobe that fills less than half of it moves it.
// After the model's GLSL, setView(), and modelPrepare().
#ifdef MODEL_IS_WHOLE
// Such files often divide by zero in a single direction: that one does not count.
vec3 finiteLight(vec3 f) { return abs(f.r) + abs(f.g) + abs(f.b) < 1e30 ? max(f, 0.0) : vec3(0.0); }

vec3 modelFloor(Shading s, Parameters p) {
  const int kRings = 10, kAround = 12, kCount = kRings * kAround;
  vec3 values[kCount];
  vec3 low = vec3(0.0), high = vec3(0.0);
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kAround; ++j) {
      float sin2 = (float(i) + 0.5) / float(kRings), phi = (float(j) + 0.5) / float(kAround) * 2.0 * kPi;
      setLight(s, s.T * (sqrt(sin2) * cos(phi)) + s.B * (sqrt(sin2) * sin(phi)) + s.N * sqrt(1.0 - sin2));
      vec3 f = finiteLight(modelSpecular(s, p));
      values[i * kAround + j] = f;
      high = max(high, f);
    }
  // As many values lie above the middle as below.
  for (int k = 0; k < 20; ++k) {
    vec3 middle = 0.5 * (low + high), above = vec3(0.0);
    for (int i = 0; i < kCount; ++i) above += step(middle, values[i]);
    bvec3 more = greaterThanEqual(above, vec3(0.5 * float(kCount)));
    low = mix(low, middle, more);
    high = mix(middle, high, more);
  }
  return 0.5 * (low + high);
}
#endif
