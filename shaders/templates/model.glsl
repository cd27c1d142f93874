/*glint
{
  "id": "@ID@",
  "title": "@TITLE@",
  "doc": "One sentence: what it looks like, and when to choose it.",
  "color": [0.40, 0.65, 0.60],
  "parameters": [
    {
      "name": "tail",
      "title": "Tail",
      "type": "float",
      "min": 1,
      "max": 4,
      "default": 2,
      "doc": "Becomes a slider, a pin and the member p.tail: 2 is GGX, less has a longer tail"
    }
  ],
  "terms": {"V": "SmithGGXCorrelated", "F": "Schlick", "diffuse": "Lambert"},
  "claims": {"reciprocal": true, "energyConserving": false},
  "cite": ["Author year, title, equation"]
}
*/

// A shading model is this one file. Save it, and Glint has it: `glint verify` says whether it keeps the
// laws that it claims, `glint compare --models ggx,@ID@ -o out.png` shows it.
//
// Define any of these; what is not defined comes from "terms" (`glint models` lists them). A model whose terms
// all ship needs no GLSL at all. All are f without the cosine, from `Shading` (directions, cosines, sinH2,
// roughness, alpha, F0, diffuseColor) and the parameters above:
//
//   float D(Shading s, Parameters p)          distribution of normals, with its 1/pi
//   float V(Shading s, Parameters p)          visibility, G / (4 NoL NoV)
//   vec3  F(Shading s, Parameters p)          Fresnel
//   vec3  diffuse(Shading s, Parameters p)    the diffuse part; Lambert when absent
//   vec3  specular(Shading s, Parameters p)   the specular part, instead of D V F
//   void  colors(inout Shading s, Parameters p)      F0 and diffuseColor, where they follow from other attributes
//   vec3  coat(Shading s, Parameters p)              a second lobe with a roughness of its own ("coat" in the head)
//   vec3  throughCoat(Shading s, Parameters p)       what a coat lets through
//   vec3  environment(Shading s, Parameters p)       reflectance under an environment, instead of the derived table
//   vec3  scattered(Shading s, Parameters p)         light that comes out from within, also from behind

float D(Shading s, Parameters p) { return D_GTR(s, p.tail); }
