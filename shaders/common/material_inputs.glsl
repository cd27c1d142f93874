// What shaders/passes/gbuffer.vert passes on, as a material graph reads it. After material.glsl.
layout(location = 0) in vec3 inNormal;
layout(location = 1) in vec3 inPosition;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec2 inUv0;
layout(location = 4) in vec2 inUv1;
layout(location = 5) in vec4 inColor;
layout(location = 6) in vec3 inLocalPosition;

// All but the direction to the viewer.
MaterialInputs materialInputs() {
  MaterialInputs i;
  i.uv0 = inUv0;
  i.uv1 = inUv1;
  i.vertexColor = inColor;
  i.position = inPosition;
  i.localPosition = inLocalPosition;
  i.normal = normalize(gl_FrontFacing ? inNormal : -inNormal);
  i.tangent = normalize(inTangent.xyz - i.normal * dot(i.normal, inTangent.xyz));
  i.bitangent = cross(i.normal, i.tangent) * inTangent.w;
  i.view = i.normal;
  return i;
}
