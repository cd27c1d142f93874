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
  vec3 F0;           // reflectance at normal incidence
  vec3 diffuseColor; // (1 - metallic) baseColor
  // The attributes as authored, for models with conventions of their own.
  vec3 baseColor;
  float metallic, specular;
  // True under a light with a direction, false under an environment: some models differ (Karis 2013, p. 3).
  bool analyticLight;
};

const float kPi = 3.14159265358979323846;

// The one place where roughness becomes alpha. The floor keeps D finite in single precision.
float alphaFromRoughness(float roughness) { return max(roughness * roughness, 1e-3); }

// Fills what follows from the directions. `N`, `V`, `L` are unit vectors; NoV and NoL are kept above 1e-4.
void setDirections(inout Shading s, vec3 N, vec3 V, vec3 L) {
  s.N = N;
  s.V = V;
  s.L = L;
  vec3 sum = V + L;
  float length2 = dot(sum, sum);
  float toHalf = inversesqrt(max(length2, 1e-12));
  // Opposite directions have no half vector; any perpendicular one will do.
  s.H = length2 > 1e-12 ? sum * toHalf : N;
  float NoL = dot(N, L), NoV = dot(N, V);
  s.NoL = clamp(NoL, 1e-4, 1.0);
  s.NoV = clamp(NoV, 1e-4, 1.0);
  // From the sum instead of H: fewer products, and the same to the last digit when V and L change places.
  // v.h = |v + l| / 2 does not cancel where v.h is small.
  s.NoH = clamp((NoL + NoV) * toHalf, 0.0, 1.0);
  s.VoH = min(0.5 * length2 * toHalf, 1.0);
  s.LoV = clamp(dot(L, V), -1.0, 1.0);
  vec3 across = cross(N, sum);
  s.sinH2 = min(dot(across, across) * (toHalf * toHalf), 1.0);
}
