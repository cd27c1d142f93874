#version 450 core
#include "shaders/common/view.glsl"
layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec2 inUv0;
layout(location = 4) in vec2 inUv1;
layout(location = 5) in vec4 inColor;
uniform mat4 worldFromModel;
uniform mat4 normalFromModel;  // inverse transpose
#ifdef SHADOW_MAP
uniform mat4 mapFromWorld;     // clip space of a light's map
#endif
layout(location = 0) out vec3 outNormal;
layout(location = 1) out vec3 outPosition;
layout(location = 2) out vec4 outTangent;
layout(location = 3) out vec2 outUv0;
layout(location = 4) out vec2 outUv1;
layout(location = 5) out vec4 outColor;
layout(location = 6) out vec3 outLocalPosition;

void main() {
  vec4 position = worldFromModel * vec4(inPosition, 1.0);
#ifdef SHADOW_MAP
  gl_Position = mapFromWorld * position;
#else
  gl_Position = view.clipFromWorld * position;
#endif
  outPosition = position.xyz;
  outLocalPosition = inPosition;
  outNormal = mat3(normalFromModel) * inNormal;
  // A transform that mirrors turns the tangent frame over.
  outTangent = vec4(mat3(worldFromModel) * inTangent.xyz, inTangent.w * sign(determinant(mat3(worldFromModel))));
  outUv0 = inUv0;
  outUv1 = inUv1;
  outColor = inColor;
}
