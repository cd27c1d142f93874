// A shading model as read from its one file (product.md 3): shaders/models/<id>.glsl.
//
// The file is GLSL with a JSON head in its first comment, which starts with the word `glint`:
//
//   /*glint
//   { "id": "ggx", "title": "GGX", "doc": "...", "color": [r, g, b],
//     "parameters": [{"name": "gamma", "type": "float", "min": 1, "max": 4, "default": 1.5, "doc": "..."}],
//     "terms": {"D": "GGX", "V": "SmithGGXCorrelated", "F": "Schlick", "diffuse": "Lambert"},
//     "claims": {"reciprocal": true, "energyConserving": true},
//     "compensate": true,                    what bounces among its facets more than once is given back: off when absent
//     "cite": ["Walter et al. 2007, eq. 33"] }
//   */
//
// After the head the file may define, in GLSL, any of these (shaders/common/shading.glsl has `Shading`;
// `Parameters` has one member for each declared parameter); what it does not define comes from "terms":
//
//   float D(Shading s, Parameters p)          distribution of normals, 1/sr, with its 1/pi
//   float V(Shading s, Parameters p)          visibility G / (4 NoL NoV)
//   vec3  F(Shading s, Parameters p)          Fresnel
//   vec3  diffuse(Shading s, Parameters p)    f of the diffuse part; Lambert when absent
//   vec3  specular(Shading s, Parameters p)   f of the specular part, instead of D, V and F
//   void  prepare(Shading s, inout Parameters p)   once a pixel, before any light: s has all but what depends on
//                                             the light; fills the float members that "prepared" of the head names
//   void  colors(inout Shading s, Parameters p)    sets F0 and diffuseColor where they do not follow from baseColor,
//                                             metallic and specular as usual
//   vec3  coat(Shading s, Parameters p)       f of a second lobe over the others, with a roughness of its own, which
//                                             is the one in s; "coat" of the head names the parameters that are its
//                                             roughness (a float) and its strength (or a color), by which Glint
//                                             multiplies
//   vec3  throughCoat(Shading s, Parameters p)     what the coat lets through of all below it; 1 when absent
//   vec3  environment(Shading s, Parameters p)     what the specular part reflects of an environment, from NoV, instead
//                                             of the table that Glint derives
//   vec3  scattered(Shading s, Parameters p)  light that comes out from within, also where it shines from behind:
//                                             radiance over the irradiance of a plane that faces the light; there is
//                                             no cosine, and s.NoL does not tell the sides apart, dot(s.N, s.L) does
//
// It may call D, V, F and diffuse whether it defines them or names them, in any order, and every function of
// shaders/terms/. Its macros end with it. A file may not declare uniforms, inputs, outputs or buffers, use `discard`,
// derivatives or names that start with `gl_`, nor define names that start with `glint` or are Glint's own (main,
// Shading, Parameters, modelD, ...), and its functions may not come back to themselves.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "materials/base/diagnostic.h"
#include "materials/value.h"

namespace glint {

// A parameter that a model declares: a slider, a pin, a member of `Parameters`, a sweepable name.
struct ModelParameter {
  std::string name;
  std::string title;
  std::string doc;
  Value standard;              // Bool, Int, Float, Vec2..4 or Color
  float minimum = 0, maximum = 1;
  // First component in the G-buffer's four per-pixel model parameters, or -1: then the parameter is
  // constant over a material (no pin), because the four are taken by those declared before it.
  int slot = -1;
  // What a .brdf file calls it, else empty. It differs from `name` where an attribute has that name: the model then
  // answers to it in the attribute's place, as it does not read the attribute.
  std::string fileName = {};
};

struct ShadingModel {
  std::string id, title, doc;
  std::array<float, 3> color{};          // of the shading-model view, display-referred 0..1
  std::vector<ModelParameter> parameters;
  // Names of shipped terms; empty where the file defines the function itself. `V` may come from "V" or
  // "G" of the head: a G is divided by 4 NoL NoV.
  std::string termD, termV, termG, termF, termDiffuse;
  bool definesD = false, definesV = false, definesF = false, definesDiffuse = false,
       definesSpecular = false, definesPrepare = false, definesColors = false, definesCoat = false,
       definesThroughCoat = false, definesEnvironment = false, definesScattered = false;
  // Parameters that are the coat's; empty without one.
  std::string coatRoughness, coatStrength;
  // The parameter by which the tangent turns about the normal, in degrees, before the model sees it; may be empty.
  std::string tangentRotation;
  bool usesTangent = false;              // reads s.T or s.B, itself or through a term
  bool usesPlainNonmetal = false;        // likewise s.plainNonmetal
  // Those of baseColor, metallic and specular that it reads as they were authored, not only as the colours made of them.
  std::vector<std::string> authored;
  std::vector<std::string> prepared;     // members of `Parameters` that its prepare() fills
  struct Claims {
    bool reciprocal = false;        // f(l, v) = f(v, l)
    // With F0 = 1 the specular part, and with a white diffuseColor the diffuse part, each sends out no more
    // than it receives, from every direction. (Their sum may: Lambert is not coupled to the specular part.)
    bool energyConserving = false;
  } claims;
  // Loses no light to bounces among its facets, also where that is not asked for (renderer/model_tables.h).
  bool compensate = false;
  bool smithOfOwnD = false;              // calls a term that is made for its own D, by name or in its text
  std::vector<std::string> cite;
  std::vector<std::string> uses;         // attributes it reads; all when empty
  std::filesystem::path file;            // as diagnostics name it
  int idLine = 1;                        // where `file` says its id
  std::string source;                    // the file's text, the head blanked so that lines keep their numbers
  std::filesystem::path sourceFile;      // whose lines `source` has, where that is another file; else empty
  std::string namePrefix;                // stands before every name of `source` that a .brdf file chose, else empty
  uint64_t hash = 0;                     // of the bytes of the file, and of `sourceFile`

  const ModelParameter* parameter(std::string_view name) const;  // also by its fileName
  bool reads(std::string_view attribute) const;                  // as `uses` has it
  // Whether there is a D, V or F to ask for: not for a model that is only `specular`.
  bool hasD() const { return definesD || !termD.empty(); }
  bool hasV() const { return definesV || !termV.empty() || !termG.empty(); }
  bool hasF() const { return definesF || !termF.empty(); }
  // Whether its specular part is all of it, the diffuse light included: a .brdf.
  bool isWhole() const { return !namePrefix.empty(); }
  // Where in the four per-pixel parameters the roughness of the coat is; -1 without a coat, or when it has no place there.
  int coatRoughnessSlot() const;
  // The four per-pixel parameters at their defaults.
  std::array<float, 4> standardSlots() const;
};

// Whether `id` can name a model: it travels in file names and on command lines. The rule is in words for hints.
bool isModelId(const std::string& id);
inline constexpr const char* kModelIdRule =
    "up to 64 letters, digits, '-', '_' and '.', a letter or digit first";

// A colour for a model that names none: one of its own for each id, neither dark nor pale.
std::array<float, 3> colorOfId(const std::string& id);

// Why bytes cannot be the text of a model in any format: too long, or a zero byte.
std::optional<Diagnostic> faultOfModelText(const std::filesystem::path& file, const std::string& text);

// What is wrong with a name for a member of `Parameters`, or nothing: "is a reserved word".
std::string faultOfParameterName(const std::string& name);
inline constexpr size_t kMostModelParameters = 32;

// Reads one plugin from its text. Every fault of the head is reported, each at its line of the file.
Result<ShadingModel> parseModel(const std::filesystem::path& file, const std::string& text);

// The GLSL of a model, for a program that has shaders/common/shading.glsl before it: the terms, struct
// Parameters, the plugin's own text under `#line`, and these functions, which are all that passes call:
//   Parameters modelParameters(vec4 slots)              per-pixel slots and the constants together
//   void modelColors(inout Shading, Parameters)         where the attributes are those of a surface, after setColors
//   void modelTurn(inout Shading, Parameters)           where T and B are those of a surface
//   void modelPrepare(Shading, inout Parameters)        once after setRoughness, setView and those, before the others
//   float modelD(Shading, Parameters)                   0 for a model without a D
//   float modelV(Shading, Parameters)                   0 for a model without a V
//   vec3 modelF(Shading, Parameters)                    0 for a model without an F
//   vec3 modelSpecular(Shading, Parameters)             f, without cosine
//   vec3 modelDiffuse(Shading, Parameters)
//   vec3 modelLobe(Shading, Parameters)                 the specular part without its coat or, with COAT defined, the
//                                                       coat of strength 1 for the roughness in Shading
//   vec3 modelDiffuseBelow(Shading, Parameters)         the diffuse part without what a coat takes away
//   vec3 modelThroughCoat(Shading, Parameters), float modelCoatRoughness(Parameters), vec3 modelCoatStrength(Parameters)
//   vec3 modelEnvironment(Shading, Parameters)          0 unless modelHasEnvironment
//   vec3 modelScattered(Shading, Parameters)            0 unless modelScatters
//   vec3 modelWhite(Shading, Parameters)                f of the specular part for facets that reflect all: D V, or for a
//                                                       model with a specular() or a coat that, when s.F0 is 1
//   vec3 modelLobeWhite(Shading, Parameters)            the same of the lobe without its coat
//   vec3 modelLit(Shading, Parameters)                  what a light makes visible: both parts
//   const bool modelHasD, modelHasEnvironment, modelScatters
//   const bool modelReadsRoughness                      of "uses"
// and the macros MODEL_COAT and MODEL_TANGENT when it has a coat or uses the tangent, MODEL_IS_WHOLE when its specular
// part is all of it, as a .brdf's is. Loops of the plugin's text end after kMostTurns turns in one evaluation, which is
// then not a number; `glintLongLoop` is then the line of the one that was broken off first. With COMPENSATE defined
// modelSpecular() has the lobe of all further bounces in it (shaders/common/model_tables.glsl).
// `uniform vec4 glintModelConstants[N]` holds the parameters without a slot, one vec4 each in
// declaration order (N >= 1). `sourceIndex` is the source-string number that GLSL errors in the plugin's
// own text will carry, and its lines count from kModelLineBase: Mesa honours the line of `#line` and drops the
// number, others keep both.
std::string modelGlsl(const ShadingModel&, int sourceIndex);
inline constexpr int kModelSourceIndex = 7;
inline constexpr int kMostTurns = 32768;
inline constexpr int kModelLineBase = 100000;  // the plugin's line 1 is reported as 100001

// Turns a driver's shader log into diagnostics at the plugin's own lines, one for each fault: what follows from it and
// lists of candidates are dropped. A line of the log that belongs to other source strings is placed at the function of
// the plugin that it names, else named "generated". Notes and warnings are dropped when there are errors.
Diagnostics modelErrors(const ShadingModel&, const std::string& driverLog);

}  // namespace glint
