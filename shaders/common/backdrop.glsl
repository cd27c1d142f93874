// What is seen where no surface is: the environment, sharp or blurred, or one colour. After view.glsl.
layout(binding = 17) uniform samplerCube backdrop;
uniform vec4 background;   // rgb; a: 1 for the colour, 0 for the environment
uniform float backgroundLevel;

vec3 backgroundRadiance(vec2 pixel) {
  vec3 radiance = textureLod(backdrop, environmentFromWorld(normalize(viewRay(pixel))), backgroundLevel).rgb * view.environmentIntensity;
  return mix(radiance, background.rgb, background.a);
}
