// Tables that Glint derives from a model itself, by cosine and roughness; renderer/model_tables.cpp fills them and has
// the same numbers. They are close together where either is small: lobes are as narrow as roughness squared.
#if defined(GLINT_SMITH_OF_OWN_D) || defined(COMPENSATE)
const vec2 kGlintAreaSize = vec2(97.0, 121.0), kGlintLossSize = vec2(97.0, 61.0);

float glintTableX(float cosine) { return log(1.0 + cosine * 1e4) * (1.0 / 9.210440366976517); }
// Up to 0.0223607, where the floor of alpha ends, a thirtieth of the table; then by the logarithm.
float glintTableY(float roughness) {
  return roughness < 0.022360680 ? roughness * (1.0 / (30.0 * 0.022360680))
                                 : 1.0 + log(min(roughness, 1.0)) * ((29.0 / 30.0) / 3.800451229771942);
}
vec2 glintTexel(float x, float y, vec2 size) { return (vec2(x, y) * (size - 1.0) + 0.5) / size; }
#endif

#ifdef GLINT_SMITH_OF_OWN_D
// Of the projected areas what goes beyond the cosine. A layer for each cos^2 of the azimuth, from 0 to 1; one alone for a
// D that is the same all around.
layout(binding = 13) uniform sampler2DArray glintAreas;

float glintProjectedArea(Shading s, vec3 direction, float cosine) {
  vec2 at = glintTexel(glintTableX(cosine), glintTableY(s.roughness), kGlintAreaSize);
  float last = float(textureSize(glintAreas, 0).z - 1);
  if (last == 0.0) return cosine + textureLod(glintAreas, vec3(at, 0.0), 0.0).r;
  vec2 around = vec2(dot(s.T, direction), dot(s.B, direction));
  float layer = last * around.x * around.x / max(dot(around, around), 1e-12);
  float below = min(floor(layer), last - 1.0);
  // Squares: at grazing angles GGX's are linear in cos^2.
  float a = textureLod(glintAreas, vec3(at, below), 0.0).r, b = textureLod(glintAreas, vec3(at, below + 1.0), 0.0).r;
  return cosine + sqrt(mix(a * a, b * b, layer - below));
}
ProjectedAreas glintProjectedAreas(Shading s) {
  return ProjectedAreas(glintProjectedArea(s, s.L, s.NoL), glintProjectedArea(s, s.V, s.NoV));
}
#endif

#ifdef COMPENSATE
// What a single bounce loses, 1 - E(cosine) for facets that reflect all. The first half of its layers is under lights, the
// other under an environment: one each, or, for a model that loses more from one side than from another, one for each glintAcross().
layout(binding = 14) uniform sampler2DArray glintLosses;
// Texels across: under lights the average reflectance of the facets as scale on F0 and bias, then both under an
// environment; w of the first is the mean of the loss, w of the second how much wider the lobe is along the bitangent.
layout(binding = 15) uniform sampler2D glintReflectances;

struct GlintBounces { vec3 scale, bias; float meanLoss, view, aspect; };

// From 0 along the tangent to 1 along the bitangent: half way from the azimuth itself to that on a circle stretched as the
// lobe is, so that neither the steep side of a long lobe nor the other is crowded.
float glintAcross(Shading s, vec3 direction, float aspect) {
  vec2 around = abs(vec2(dot(s.T, direction), sqrt(aspect) * dot(s.B, direction)));
  return around.x + around.y > 0.0 ? atan(around.y, around.x) * (2.0 / kPi) : 0.0;
}

float glintLoss(Shading s, vec3 direction, float cosine, float aspect) {
  vec2 at = glintTexel(glintTableX(cosine), glintTableY(s.roughness), kGlintLossSize);
#ifdef MODEL_TANGENT
  float layers = float(textureSize(glintLosses, 0).z / 2), first = s.analyticLight ? 0.0 : layers;
  if (layers == 1.0) return textureLod(glintLosses, vec3(at, first), 0.0).r;
  float layer = (layers - 1.0) * glintAcross(s, direction, aspect), below = min(floor(layer), layers - 2.0);
  return mix(textureLod(glintLosses, vec3(at, first + below), 0.0).r, textureLod(glintLosses, vec3(at, first + below + 1.0), 0.0).r, layer - below);
#else
  return textureLod(glintLosses, vec3(at, s.analyticLight ? 0.0 : 1.0), 0.0).r;
#endif
}

// All but what depends on the light.
GlintBounces glintBouncesTowards(Shading s) {
  float y = glintTexel(0.0, glintTableY(s.roughness), kGlintLossSize).y, x = s.analyticLight ? 0.125 : 0.625;
  vec4 scale = textureLod(glintReflectances, vec2(x, y), 0.0);
  vec4 bias = textureLod(glintReflectances, vec2(x + 0.25, y), 0.0);
  return GlintBounces(scale.rgb, bias.rgb, scale.w, glintLoss(s, s.V, s.NoV, bias.w), bias.w);
}

// What is left of light after two and more bounces off facets of that average reflectance: Kulla and Conty 2017.
vec3 glintBounceTint(Shading s, GlintBounces b) {
  float E = 1.0 - b.meanLoss;
  vec3 F = clamp(s.F0 * b.scale + b.bias, 0.0, 1.0);
  return F * F * E / max(1.0 - F * b.meanLoss, 1e-4);
}

// Kulla and Conty 2017: (1 - E(l)) (1 - E(v)) / (pi (1 - E_avg)), tinted; the same when light and view change places.
vec3 glintFurtherBounces(Shading s, GlintBounces b) {
  if (b.meanLoss < 1e-7) return vec3(0.0);
  return glintBounceTint(s, b) * (glintLoss(s, s.L, s.NoL, b.aspect) * b.view / (kPi * b.meanLoss));
}
#endif
