// The same of an environment: directions drawn in proportion to its light, by renderer/environment_sampler.h. After
// reference.glsl, and environmentFromWorld() with its inverse.
layout(binding = 6) uniform sampler2D environmentRadiance;  // equirectangular, from the top
layout(binding = 7) uniform sampler2D environmentColumns;   // for each row the share of the cells before each, to 1
layout(binding = 10) uniform sampler2D environmentRows;     // and of the rows

vec2 referencePlace(vec3 d) { return vec2(0.5 + atan(d.z, d.x) / (2.0 * kPi), atan(length(d.xz), d.y) / kPi); }

// Where `u` stands in row `y` of a table of shares: the cell, the share of it that lies before u, and its whole share.
vec3 referenceCell(sampler2D table, int y, int cells, float u) {
  int low = 0, high = cells;
  while (high - low > 1) {
    int middle = (low + high) >> 1;
    if (texelFetch(table, ivec2(middle, y), 0).r <= u) low = middle;
    else high = middle;
  }
  float from = texelFetch(table, ivec2(low, y), 0).r, to = texelFetch(table, ivec2(low + 1, y), 0).r;
  return vec3(float(low), clamp((u - from) / max(to - from, 1e-12), 0.0, 1.0), to - from);
}

vec3 referenceToEnvironment(vec2 u) {
  ivec2 size = ivec2(textureSize(environmentColumns, 0).x - 1, textureSize(environmentRows, 0).x - 1);
  vec3 row = referenceCell(environmentRows, 0, size.y, u.y);
  vec3 column = referenceCell(environmentColumns, int(row.x), size.x, u.x);
  float theta = kPi * (row.x + row.y) / float(size.y), phi = 2.0 * kPi * ((column.x + column.y) / float(size.x) - 0.5);
  return vec3(sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi));
}
float referenceEnvironmentPdf(vec3 d) {
  ivec2 size = ivec2(textureSize(environmentColumns, 0).x - 1, textureSize(environmentRows, 0).x - 1);
  ivec2 cell = clamp(ivec2(referencePlace(d) * vec2(size)), ivec2(0), size - 1);
  float row = texelFetch(environmentRows, ivec2(cell.y + 1, 0), 0).r - texelFetch(environmentRows, ivec2(cell.y, 0), 0).r;
  float column = texelFetch(environmentColumns, ivec2(cell.x + 1, cell.y), 0).r - texelFetch(environmentColumns, cell, 0).r;
  return row * column * float(size.x) * float(size.y) / (2.0 * kPi * kPi * max(length(d.xz), 1e-7));
}

vec3 referenceEnvironment(Shading s, Parameters p, Proposal q, uint first, int count, uvec3 offset) {
  vec3 sum = vec3(0.0);
  uvec3 other = referenceHash(offset);
  for (int i = 0; i < count; ++i) {
    uint index = first + uint(i);
    vec3 part = vec3(0.0);
#ifdef FURNACE
    vec3 L = referenceDirection(q, referenceThree(index, other));
    part = referenceSentOn(s, p, L) / max(referenceDirectionPdf(q, L), 1e-20);
#else
    for (int kind = 0; kind < 2; ++kind) {
      vec3 L, d;
      if (kind == 0) {
        d = referenceToEnvironment(referenceTwo(index, offset));
        L = worldFromEnvironment(d);
      } else {
        L = referenceDirection(q, referenceThree(index, other));
        d = environmentFromWorld(L);
      }
      float pdf = referenceEnvironmentPdf(d) + referenceDirectionPdf(q, L);
      if (pdf > 0.0) part += referenceSentOn(s, p, L) * textureLod(environmentRadiance, referencePlace(d), 0.0).rgb / pdf;
    }
#endif
    sum += referenceFinite(part);
  }
  return sum / float(count);
}

#ifdef SPLIT_SUM
// Where a facet of a GGX as wide as the model's lobe reflects the viewer to; in the proposal's frame.
vec3 referenceReflected(Proposal q, vec2 u) {
  float phi = 2.0 * kPi * u.x, slope = sqrt(u.y / (1.0 - u.y));
  vec3 H = normalize(vec3(q.alpha * slope * vec2(cos(phi), sin(phi)), 1.0));
  return 2.0 * dot(q.view, H) * H - q.view;
}

// The specular part as two sums (Karis 2013, eq. 7): the mean of the light from above the surface, times what the model sends
// on of white light. The mean is a plain one: weights by the cosine help where n = v = r, and do harm here. Their samples are independent, so that the mean of the products is the product of the means.
vec3 referenceSplitSum(Shading s, Parameters p, Proposal q, uint first, int count, uvec3 offset) {
  const int kFacets = 64;
  float above = 0.0;
  for (int i = 0; i < kFacets; ++i) above += step(0.0, referenceReflected(q, referenceTwo(uint(i), offset)).z) / float(kFacets);
  vec3 sum = vec3(0.0);
  uvec3 other = referenceHash(offset), third = referenceHash(other);
  for (int i = 0; i < count; ++i) {
    uint index = first + uint(i);
    vec3 l = referenceReflected(q, referenceTwo(index, other));
    if (l.z <= 0.0) continue;
    vec3 light = textureLod(environmentRadiance, referencePlace(environmentFromWorld(q.frame * l)), 0.0).rgb / max(above, 1.0 / float(kFacets));
    vec3 L = referenceDirection(q, referenceThree(index, third));
    float cosine = dot(s.N, L), pdf = referenceDirectionPdf(q, L);
    if (cosine <= 0.0 || !(pdf > 0.0)) continue;
    setLight(s, L);
    sum += referenceFinite(light * modelSpecular(s, p) * (cosine / pdf));
  }
  return sum / float(count);
}
#endif
