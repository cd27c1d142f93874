// What a shading model sees of the surface under a pixel. After the model's own text, view.glsl and gbuffer_read.glsl.
uniform vec4 standardParameters;  // where no material varies them
uniform bool plainNonmetal;

void shadePixel(ivec2 pixel, out Surface surface, out Shading s, out Parameters p) {
  surface = readSurface(pixel);
  vec3 N = surface.normal;
#ifdef FURNACE
  surface.baseColor = vec3(1.0);
  surface.metallic = surface.cavity = surface.ambientOcclusion = 1.0;
#endif
  setRoughness(s, surface.roughness);
  setView(s, N, towardsViewer(gl_FragCoord.xy));
  setColors(s, surface.baseColor, surface.metallic, surface.specular);
  s.analyticLight = true;
  s.plainNonmetal = plainNonmetal;
#ifdef MODEL_TANGENT
  s.T = readTangent(pixel, N);
#else
  s.T = anyTangent(N);
#endif
  s.B = cross(N, s.T);
#ifdef READS_PARAMETERS
  p = modelParameters(texelFetch(gParameters, pixel, 0));
#else
  p = modelParameters(standardParameters);
#endif
  modelColors(s, p);
#ifdef FURNACE
  // A white metal whatever colours the model makes: how much light it sends back is its lobe's alone.
  s.F0 = vec3(1.0);
  s.diffuseColor = vec3(0.0);
  s.plainNonmetal = false;
#endif
  modelTurn(s, p);
  modelPrepare(s, p);
}
