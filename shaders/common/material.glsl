// What a material graph reads, and what it fills in.

// The interpolated surface, in world space but for localPosition.
struct MaterialInputs {
  vec2 uv0, uv1;
  vec4 vertexColor;
  vec3 position;   // metres
  vec3 localPosition;  // metres, in the mesh's own space: patterns stay with the object
  vec3 normal;     // geometric, unit
  vec3 tangent;    // unit
  vec3 bitangent;  // unit
  vec3 view;       // to the camera, unit
};

// The attributes of materials/attributes.cpp, which has their meaning and defaults.
struct MaterialAttributes {
  vec3 baseColor;
  float metallic;
  float specular;
  float roughness;
  float cavity;
  float ambientOcclusion;
  vec3 normal;      // tangent space, +Y up
  float normalVariance;  // of the slopes that a normal map averages here, along one axis; only what is not 0 is written
  vec3 emissive;    // nits
  float opacityMask;
  vec4 model;       // the shading model's own per-pixel parameters, by slot
};
