#version 450 core
// One face of a cube map from an equirectangular environment (product.md 1 has the orientation).
#include "shaders/common/cube.glsl"
layout(location = 0) flat in ivec4 inLights;
layout(location = 0) out vec4 outColor;
layout(binding = 0) uniform sampler2D equirect;
uniform int face;
uniform float size;
uniform float scale;       // EnvironmentMaps::scale
uniform int perSide;       // samples along a side of a texel

void main() {
  vec3 sum = vec3(0.0);
  for (int y = 0; y < perSide; ++y)
    for (int x = 0; x < perSide; ++x) {
      vec2 p = (floor(gl_FragCoord.xy) + (vec2(x, y) + 0.5) / float(perSide)) / size;
      vec3 d = normalize(cubeDirection(face, p));
      vec2 uv = vec2(0.5 + atan(d.z, d.x) / 6.283185307179586, acos(clamp(d.y, -1.0, 1.0)) / 3.141592653589793);
      sum += textureLod(equirect, uv, 0.0).rgb;
    }
  outColor = vec4(min(sum * (scale / float(perSide * perSide)), 65504.0), 1.0);
}
