// What a shading model sees of one surface point and one pair of directions.
struct Shading {
  // Unit vectors, all in one space: normal, to the viewer, to the light, half way, tangent, bitangent.
  vec3 N, V, L, H, T, B;
  // Cosines. NoL and NoV are in (0, 1], NoH and VoH in [0, 1], LoV in [-1, 1].
  float NoL, NoV, NoH, VoH, LoV;
  // |N x H|^2 = 1 - NoH^2 without the cancellation near the highlight (physics.md K17).
  float sinH2;
  float roughness;   // 0..1, what the artist drags
  float alpha;       // the distribution's width, alphaFromRoughness(roughness)
  float alpha2;      // its square
  vec3 F0;           // reflectance at normal incidence
  vec3 diffuseColor; // (1 - metallic) baseColor
  // The attributes as authored, for models with conventions of their own.
  vec3 baseColor;
  float metallic, specular;
  // True under a light with a direction, false under an environment: some models differ (Karis 2013, p. 3).
  bool analyticLight;
  // True where the material leaves metallic and specular unconnected: a nonmetal with F0 = 0.04 and nothing else.
  bool plainNonmetal;
};

const float kPi = 3.14159265358979323846;

// The one place where roughness becomes alpha. The floor keeps highlights of lights without a size, and what is
// interpolated between pixels, within single precision. With OWN_ALPHA it is left out: for numbers on request.
#ifdef OWN_ALPHA
float alphaFromRoughness(float roughness) { return roughness * roughness; }
#else
float alphaFromRoughness(float roughness) { return max(roughness * roughness, 5e-4); }
#endif

void setRoughness(inout Shading s, float roughness) {
  s.roughness = roughness;
  s.alpha = alphaFromRoughness(roughness);
  s.alpha2 = s.alpha * s.alpha;
}

// The two colours that models reflect with, from the attributes (product.md 2; Karis 2013, p. 4): specular 0.5 is
// F0 = 0.04.
void setColors(inout Shading s, vec3 baseColor, float metallic, float specular) {
  s.baseColor = baseColor;
  s.metallic = metallic;
  s.specular = specular;
  s.diffuseColor = baseColor * (1.0 - metallic);
  s.F0 = mix(vec3(0.08 * specular), baseColor, metallic);
}

// Into (0, 1]: a cosine of zero divides by zero, one above 1 makes a power of a negative number.
float safeCosine(float x) { return max(min(x, 1.0), 1e-4); }

// Fills what follows from the normal and the viewer, both unit vectors. Software renderers move nothing out of a
// loop: call it before one over lights.
void setView(inout Shading s, vec3 N, vec3 V) {
  s.N = N;
  s.V = V;
  s.NoV = safeCosine(dot(N, V));
}

// Fills what follows from the direction to the light, a unit vector; after setView.
void setLight(inout Shading s, vec3 L) {
  s.L = L;
  float NoL = dot(s.N, L);
  s.NoL = safeCosine(NoL);
  s.LoV = clamp(dot(L, s.V), -1.0, 1.0);
  // The half vector is (v + l) / |v + l|, of which no model here needs more than these. Along the normal, v + l is
  // n.v + n.l long, and `across` is the rest of it; neither |v + l| nor v.h = |v + l| / 2 cancels where it is small,
  // and all are the same to the last digit when v and l change places.
  vec3 sum = s.V + L;
  float along = NoL + dot(s.N, s.V);
  vec3 across = sum - along * s.N;
  float across2 = dot(across, across);
  float length2 = max(across2 + along * along, 1e-12);
  float length1 = sqrt(length2);
  s.sinH2 = across2 / length2;
  s.VoH = min(0.5 * length1, 1.0);
  s.NoH = clamp(along / length1, 0.0, 1.0);
  // Opposite directions have no half vector; any perpendicular one will do.
  s.H = length2 > 1e-12 ? sum / length1 : s.N;
}

// Turns the tangent frame about the normal, counter-clockwise seen against it.
void turnTangent(inout Shading s, float angle) {
  vec3 T = cos(angle) * s.T + sin(angle) * s.B;
  s.B = cos(angle) * s.B - sin(angle) * s.T;
  s.T = T;
}

void setDirections(inout Shading s, vec3 N, vec3 V, vec3 L) {
  setView(s, N, V);
  setLight(s, L);
}
