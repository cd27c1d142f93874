#version 450 core
// Light on the G-buffer, for one shading model: the stencil lets only its pixels through.
#include "shaders/common/view.glsl"
#include "shaders/common/gbuffer_read.glsl"
#include "shaders/common/shading.glsl"
#include "shaders/common/output.glsl"
#pragma glint model

layout(location = 0) flat in ivec2 inLights;
layout(location = 0) out vec4 outColor;
uniform vec4 standardParameters;  // where no material varies them

struct DirectionalLight {
  vec4 direction;  // towards the light
  vec4 radiance;   // lux: E = radiance NoL
};
layout(std140, binding = 2) uniform DirectionalLights { DirectionalLight directional[16]; };

#ifdef POINT_LIGHTS
// Two texels a light, in the order of the tiles' lists: position in metres with 1 / radius^2, intensity in candela.
// A texture, because software GL reads those eight pixels at a time and storage buffers one by one.
layout(binding = 8) uniform samplerBuffer tileLights;
#endif

#ifdef ENVIRONMENT
layout(binding = 6) uniform samplerCube prefilteredEnvironment;
layout(binding = 7) uniform sampler2D environmentBrdf;  // x: NoV, y: roughness
layout(std140, binding = 3) uniform EnvironmentData { vec4 irradiance[9]; };  // spherical harmonics of E / pi

// Ramamoorthi and Hanrahan 2001; the constants of the basis are folded into the coefficients.
vec3 diffuseIrradiance(vec3 n) {
  vec3 e = irradiance[0].rgb + irradiance[1].rgb * n.y + irradiance[2].rgb * n.z + irradiance[3].rgb * n.x +
           irradiance[4].rgb * (n.x * n.y) + irradiance[5].rgb * (n.y * n.z) +
           irradiance[6].rgb * (3.0 * n.z * n.z - 1.0) + irradiance[7].rgb * (n.x * n.z) +
           irradiance[8].rgb * (n.x * n.x - n.y * n.y);
  return max(e, 0.0);
}

// Scale on F0 and bias of the specular part, albedo of the diffuse part over Lambert's. Models without colours of their
// own have the three in one texel; COLORED_BRDF has a table for each, one above the other.
struct EnvironmentBrdf { vec3 scale, bias, diffuse; };
EnvironmentBrdf environmentBrdfAt(float NoV, float roughness) {
  const float kSize = 64.0;  // EnvironmentLighting::kBrdfSize: the outermost texels stand on 0 and 1
  vec2 texel = vec2(NoV, roughness) * (kSize - 1.0) + 0.5;
#ifdef COLORED_BRDF
  vec2 size = vec2(kSize, 3.0 * kSize);
  return EnvironmentBrdf(textureLod(environmentBrdf, texel / size, 0.0).rgb,
                         textureLod(environmentBrdf, (texel + vec2(0.0, kSize)) / size, 0.0).rgb,
                         textureLod(environmentBrdf, (texel + vec2(0.0, 2.0 * kSize)) / size, 0.0).rgb);
#else
  vec3 table = textureLod(environmentBrdf, texel / kSize, 0.0).rgb;
  return EnvironmentBrdf(vec3(table.x), vec3(table.y), vec3(table.z));
#endif
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  Surface surface = readSurface(pixel);
  vec3 N = surface.normal;
  vec3 V = towardsViewer(gl_FragCoord.xy);

  Shading s;
  setRoughness(s, surface.roughness);
  setView(s, N, V);
  setColors(s, surface.baseColor, surface.metallic, surface.specular);
  s.analyticLight = true;
  // Any frame around the normal: no attribute turns it.
  s.T = normalize(abs(N.y) < 0.99 ? cross(vec3(0.0, 1.0, 0.0), N) : cross(N, vec3(1.0, 0.0, 0.0)));
  s.B = cross(N, s.T);
#ifdef READS_PARAMETERS
  Parameters p = modelParameters(texelFetch(gParameters, pixel, 0));
#else
  Parameters p = modelParameters(standardParameters);
#endif
  modelPrepare(s, p);

  vec3 radiance = vec3(0.0);
  for (int i = 0; i < view.directionalCount; ++i) {
    vec3 L = directional[i].direction.xyz;
    setLight(s, L);
    radiance += (modelDiffuse(s, p) + modelSpecular(s, p)) * directional[i].radiance.rgb * max(dot(N, L), 0.0);
  }
#ifdef POINT_LIGHTS
  vec3 position = worldPosition(gl_FragCoord.xy, texelFetch(gDepth, pixel, 0).r);
  for (int i = 0; i < inLights.y; ++i) {
    vec4 lightPosition = texelFetch(tileLights, 2 * (inLights.x + i));
    vec3 intensity = texelFetch(tileLights, 2 * (inLights.x + i) + 1).rgb;
    vec3 toLight = lightPosition.xyz - position;
    float distance2 = dot(toLight, toLight);
    vec3 L = toLight * inversesqrt(max(distance2, 1e-12));
    float weight = windowedFalloff(distance2, lightPosition.w) * max(dot(N, L), 0.0);
    setLight(s, L);
    radiance += (modelDiffuse(s, p) + modelSpecular(s, p)) * (intensity * weight);
  }
#endif
#ifdef ENVIRONMENT
  // Split sum (Karis 2013, eq. 7 and 8) with the model's own lobe and tables.
  EnvironmentBrdf brdf = environmentBrdfAt(clamp(dot(N, V), 0.0, 1.0), surface.roughness);
  vec3 R = 2.0 * dot(N, V) * N - V;
  float level = view.environmentLevels * surface.roughness * (1.7 - 0.7 * surface.roughness);
  vec3 specularLight = textureLod(prefilteredEnvironment, environmentFromWorld(R), level).rgb;
  vec3 diffuseLight = diffuseIrradiance(environmentFromWorld(N));
  radiance += (specularLight * max(s.F0 * brdf.scale + brdf.bias, 0.0) + diffuseLight * s.diffuseColor * brdf.diffuse) *
              (surface.ambientOcclusion * view.environmentIntensity);
#endif
  radiance *= surface.cavity;
#ifdef EMISSIVE
  radiance += texelFetch(gEmissive, pixel, 0).rgb;
#endif
  outColor = outputColor(radiance);
}
