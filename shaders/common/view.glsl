// One view of a frame, shared by every pass: renderer/frame_data.h fills it.
layout(std140, binding = 0) uniform ViewData {
  mat4 clipFromWorld;
  // A pixel at window position p (pixels) sees along rayDirection + p.x rayX + p.y rayY, per metre of depth,
  // from rayOrigin + p.x originX + p.y originY. One of the two gradients is zero: orthographic or perspective.
  vec4 rayOrigin, originX, originY;
  vec4 rayDirection, rayX, rayY;
  // Depth in metres along the ray from a depth-buffer value d: (x + y d) / (z + w d).
  vec4 depthTerms;
  // The environment's axes: rows that turn a world direction into the environment's frame.
  vec4 environmentX, environmentZ;
  float environmentIntensity;
  float exposureScale;      // 2^EV
  float environmentLevels;  // levels of the prefiltered cube minus one
  int directionalCount;
} view;

vec3 viewRay(vec2 pixel) { return view.rayDirection.xyz + pixel.x * view.rayX.xyz + pixel.y * view.rayY.xyz; }

// The unit vector from the surface under a pixel to the camera.
vec3 towardsViewer(vec2 pixel) { return -normalize(viewRay(pixel)); }

vec3 worldPosition(vec2 pixel, float depthValue) {
  float depth = (view.depthTerms.x + view.depthTerms.y * depthValue) / (view.depthTerms.z + view.depthTerms.w * depthValue);
  return view.rayOrigin.xyz + pixel.x * view.originX.xyz + pixel.y * view.originY.xyz + depth * viewRay(pixel);
}

vec3 environmentFromWorld(vec3 d) { return vec3(dot(view.environmentX.xyz, d), d.y, dot(view.environmentZ.xyz, d)); }
vec3 worldFromEnvironment(vec3 d) { return d.x * view.environmentX.xyz + vec3(0.0, d.y, 0.0) + d.z * view.environmentZ.xyz; }
