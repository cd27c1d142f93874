// The G-buffer. This table is the only place that knows what lies where; renderer/frame_targets.cpp makes the
// textures. Sixteen bits each: a measuring tool must not show its own quantisation as a difference.
//
//   attachment     format         r            g          b          a
//   0 baseColor    RGBA16F        baseColor.r  .g         .b         ambientOcclusion
//   1 normal       RGBA16_SNORM   normal.x     .y         .z         cavity
//   2 material     RGBA16         metallic     specular   roughness  light group / 255
//   3 emissive     R11F_G11F_B10F emissive.r   .g         .b             only when a material writes it
//   4 parameters   RGBA16F        the shading model's own four            only when a model has some
//   5 tangent      R16_SNORM        angle / pi    from anyTangent(), only when a model uses the tangent
//   depth          DEPTH24_STENCIL8: the stencil is the light group, one model with one set of constants
struct Surface {
  vec3 baseColor;
  float ambientOcclusion;
  vec3 normal;      // world space, unit
  float cavity;
  float metallic, specular, roughness;
  float group;
};

// A unit vector perpendicular to a unit vector, and where the angles of tangents count from.
vec3 anyTangent(vec3 N) { return normalize(abs(N.y) < 0.99 ? cross(vec3(0.0, 1.0, 0.0), N) : cross(N, vec3(1.0, 0.0, 0.0))); }
