// What is near a pixel on the screen. After view.glsl and gbuffer_read.glsl.
uniform ivec4 viewRectangle;   // x0, y0, x1, y1 of the view, pixels
uniform float sampleNumber;    // of the picture that is averaged: its noise is another each time

float linearDepth(float depthValue) {
  return (view.depthTerms.x + view.depthTerms.y * depthValue) / (view.depthTerms.z + view.depthTerms.w * depthValue);
}
vec3 worldAtDepth(vec2 pixel, float depth) {
  return view.rayOrigin.xyz + pixel.x * view.originX.xyz + pixel.y * view.originY.xyz + depth * viewRay(pixel);
}
// Metres across a pixel at this depth.
float pixelSize(float depth) { return length(view.originX.xyz) + length(view.rayX.xyz) * depth; }

bool inView(ivec2 pixel) { return all(greaterThanEqual(pixel, viewRectangle.xy)) && all(lessThan(pixel, viewRectangle.zw)); }

// Two numbers in 0 .. 1, others in every pixel near by (Jimenez 2014, "Next Generation Post Processing in Call of Duty") and in
// every sample (Roberts 2018, the sequence R2).
vec2 pixelNoise(vec2 pixel) {
  vec2 sums = vec2(dot(pixel, vec2(0.06711056, 0.00583715)), dot(pixel.yx + 17.0, vec2(0.06711056, 0.00583715)));
  return fract(52.9829189 * fract(sums) + sampleNumber * vec2(0.7548777, 0.5698403));
}

// The normal of the triangle under a pixel, from the depths around it: of each two neighbours the nearer in depth, which is
// on the same surface.
vec3 geometricNormal(ivec2 pixel, vec3 position, float depthValue) {
  ivec2 x = ivec2(pixel.x + 1 < viewRectangle.z ? 1 : -1, 0), y = ivec2(0, pixel.y + 1 < viewRectangle.w ? 1 : -1);
  float right = texelFetch(gDepth, pixel + x, 0).r, up = texelFetch(gDepth, pixel + y, 0).r;
  if (pixel.x > viewRectangle.x) {
    float left = texelFetch(gDepth, pixel - ivec2(1, 0), 0).r;
    if (abs(left - depthValue) < abs(right - depthValue)) { x = ivec2(-1, 0); right = left; }
  }
  if (pixel.y > viewRectangle.y) {
    float down = texelFetch(gDepth, pixel - ivec2(0, 1), 0).r;
    if (abs(down - depthValue) < abs(up - depthValue)) { y = ivec2(0, -1); up = down; }
  }
  vec2 at = vec2(pixel) + 0.5;
  vec3 N = cross(worldPosition(at + vec2(x), right) - position, worldPosition(at + vec2(y), up) - position) * float(x.x * y.y);
  float size = length(N);
  return size > 0.0 ? N / size : towardsViewer(at);
}
