// What is said of a plugin's file before any compiler sees it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "materials/glsl_loops.h"
#include "materials/glsl_scan.h"
#include "materials/model.h"
#include "materials/terms.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string faults(const std::string& text) {
  const auto model = parseModel("m.glsl", text);
  if (model) return "";
  std::string all;
  for (const Diagnostic& d : model.diagnostics()) {
    EXPECT_FALSE(d.place.empty());
    all += d.text() + "\n";
  }
  return all;
}

// A file with `extra` members in its head and `body` after it.
std::string plugin(const std::string& extra, const std::string& body = "") {
  return "/*glint\n{ \"id\": \"m\",\n  \"terms\": {\"D\": \"GGX\", \"V\": \"SmithGGX\", \"F\": \"Schlick\"}" +
         (extra.empty() ? "" : ",\n  " + extra) + " }\n*/\n" + body;
}

TEST(ModelHead, WholeExample) {
  const auto model = parseModel("folder/m.glsl", plugin(
      R"("title": "M", "doc": "d", "color": [0.1, 0.2, 0.3], "cite": ["A 1999"], "uses": ["roughness"],
         "claims": {"reciprocal": true},
         "parameters": [{"name": "sheen", "type": "color", "default": [1, 0.5, 0]},
                        {"name": "weight", "title": "Weight", "type": "float", "min": -1, "max": 2, "default": 1.5, "doc": "w"},
                        {"name": "twist", "type": "vec2", "default": 0.25}])",
      "vec3 diffuse(Shading s, Parameters p) { return p.sheen; }\n"));
  ASSERT_TRUE(model) << model.diagnostics()[0].text();
  EXPECT_EQ(model->title, "M");
  EXPECT_EQ(model->color[2], 0.3f);
  EXPECT_TRUE(model->claims.reciprocal);
  EXPECT_FALSE(model->claims.energyConserving);
  EXPECT_EQ(model->termV, "SmithGGX");
  EXPECT_TRUE(model->definesDiffuse);
  EXPECT_EQ(model->termDiffuse, "");
  ASSERT_EQ(model->parameters.size(), 3u);
  EXPECT_EQ(model->parameters[0].slot, 0);
  EXPECT_EQ(model->parameters[1].slot, 3);
  EXPECT_EQ(model->parameters[1].minimum, -1);
  EXPECT_EQ(model->parameters[2].slot, -1);
  EXPECT_EQ(model->standardSlots(), (std::array<float, 4>{1, 0.5f, 0, 1.5f}));
  EXPECT_EQ(std::count(model->source.begin(), model->source.end(), '\n'), 10) << "lines keep their numbers";
}

TEST(ModelHead, EveryFaultAtItsLine) {
  const std::string said = faults(R"(/*glint
{ "id": "has space",
  "titel": "T",
  "color": [0, 0, 2],
  "terms": {"D": "GXX", "F": 3},
  "parameters": [
    {"name": "roughness", "type": "float", "default": 0},
    {"name": "a", "type": "flaot", "default": 0},
    {"name": "b", "type": "float", "min": 1, "max": 1, "default": 1},
    {"name": "c", "type": "float", "default": 3},
    {"name": "c", "type": "float", "default": 0, "defualt": 1},
    {"name": "float", "type": "vec2", "default": [1, 2, 3]},
    {"type": "float", "default": 0}
  ],
  "claims": {"reciprocal": 1},
  "prepared": ["metallic", "e", "e"],
  "uses": ["rougness"]
}
*/
float V(float x) { return x; }
)");
  for (const char* expected : {
           "m.glsl:2: 'has space' is no id",
           "m.glsl:3: unknown key 'titel'; did you mean 'title'?",
           "m.glsl:4: 'color' is outside 0..1",
           "m.glsl:5: terms: unknown D term 'GXX'; did you mean 'GGX'?",
           "m.glsl:5: terms: 'F' must be a string, not a number",
           "m.glsl:7: parameter 'roughness': the name is the name of an attribute",
           "m.glsl:8: parameter 'a': unknown type 'flaot'; did you mean 'float'?",
           "m.glsl:9: parameter 'b': the range 1..1 is empty",
           "m.glsl:10: parameter 'c': the default 3 is outside 0..1",
           "m.glsl:11: a second parameter 'c'; the first is on line 10",
           "m.glsl:11: parameter 'c': unknown key 'defualt'; did you mean 'default'?",
           "m.glsl:12: parameter 'float': the name is a reserved word",
           "m.glsl:12: parameter 'float': 'default' is not a vec2",
           "m.glsl:13: parameter: 'name' is missing",
           "m.glsl:16: prepared 'metallic' is the name of an attribute",
           "m.glsl:16: prepared 'e' is there twice",
           "m.glsl:16: \"prepared\" is never filled",
           "m.glsl:15: claims: 'reciprocal' must be",
           "m.glsl:17: unknown attribute 'rougness'; did you mean 'roughness'?",
           "m.glsl:20: 'V' has other types than Glint calls it with; write float V(Shading s, Parameters p)",
       })
    EXPECT_THAT(said, HasSubstr(expected));
}

TEST(ModelHead, WhatIsMissing) {
  EXPECT_THAT(faults(""), HasSubstr("m.glsl:1: has no head"));
  EXPECT_THAT(faults("/*glint {\"id\": \"m\"} */"), AllOf(HasSubstr("has no D"), HasSubstr("has no V"), HasSubstr("has no F")));
  EXPECT_EQ(faults("/*glint {\"id\": \"m\"} */ vec3 specular(Shading s, Parameters p) { return s.F0; }"), "");
  EXPECT_THAT(faults(plugin("", "float D(Shading s, Parameters p) { return 1.0; }")),
              HasSubstr("m.glsl:5: defines 'D', which \"terms\" of the head names too"));
  EXPECT_THAT(faults(std::string("/*glint {\"id\": \"m\"} */\n\0", 25)), HasSubstr("m.glsl:2: holds a zero byte"));
  EXPECT_THAT(faults(std::string(300000, ' ')), HasSubstr("300000 bytes"));
}

// What would break the text around a plugin is told here, at its line, not by the compiler somewhere else.
TEST(ModelHead, OptionalFunctionsAndTheirKeys) {
  const std::string parameters = R"("parameters": [{"name": "r", "type": "float", "default": 0.1}, {"name": "c", "type": "color", "default": [1, 1, 1]}], )";
  const std::string coat = "vec3 coat(Shading s, Parameters p) { return vec3(1.0); }\n";
  const auto coated = parseModel("m.glsl", plugin(parameters + R"("coat": {"roughness": "r", "strength": "r"}, "tangentRotation": "r")", coat));
  ASSERT_TRUE(coated) << coated.diagnostics()[0].text();
  EXPECT_TRUE(coated->definesCoat && !coated->definesThroughCoat && coated->coatRoughness == "r" && coated->tangentRotation == "r");
  EXPECT_THAT(faults(plugin("", coat)), AllOf(HasSubstr("m.glsl:2"), HasSubstr("the head does not tell of its coat")));
  EXPECT_THAT(faults(plugin(parameters + R"("coat": {"roughness": "r", "strength": "r"})")), AllOf(HasSubstr("m.glsl:4"), HasSubstr("has no function")));
  EXPECT_THAT(faults(plugin(parameters + R"("coat": {"roughness": "q", "strength": "z"})", coat)),
              AllOf(HasSubstr("'roughness' names no parameter of type float"), HasSubstr("'strength' names no parameter of type float or color")));
  EXPECT_THAT(faults(plugin(parameters + R"("tangentRotation": "c")")), HasSubstr("'tangentRotation' names no parameter"));
  EXPECT_THAT(faults(plugin("", "void colors(Shading s) {}\n")), HasSubstr("write void colors(inout Shading s, Parameters p)"));
}

// What costs an attachment of the G-buffer is only there for models that read it.
TEST(ModelHead, KnowsWhetherTheTangentIsRead) {
  const auto uses = [](const std::string& text) {
    const auto model = parseModel("m.glsl", text);
    EXPECT_TRUE(model) << text;
    return model && model->usesTangent;
  };
  const std::string own = R"(/*glint {"id": "m", "terms": {"V": "SmithGGX", "F": "Schlick"}} */
)";
  EXPECT_FALSE(uses(plugin("")));
  EXPECT_TRUE(uses(own + "float D(Shading s, Parameters p) { return dot(s.T, s.H); }"));
  EXPECT_TRUE(uses(own + "float mine(Shading a) { return a.B.x; }\nfloat D(Shading s, Parameters p) { return mine(s); }"));
  EXPECT_TRUE(uses(own + "float D(Shading s, Parameters p) { return D_GGXaniso(s, 0.5); }"));
  EXPECT_TRUE(uses(own + "#define ALONG dot(s.T, s.H)\nfloat D(Shading s, Parameters p) { return ALONG; }"));
  EXPECT_FALSE(uses(own + "// s.T is not read\nfloat D(Shading s, Parameters p) { return D_GGX(s); }"));
  EXPECT_TRUE(uses(R"(/*glint {"id": "m", "terms": {"D": "GGXaniso", "V": "SmithGGX", "F": "Schlick"}} */)"));
}

TEST(ModelHead, TextThatReachesOut) {
  EXPECT_THAT(faults(plugin("", "uniform float x;")), HasSubstr("m.glsl:5: 'uniform' is not for a plugin"));
  EXPECT_THAT(faults(plugin("", "\nlayout(binding = 0) buffer B { float x; };")), HasSubstr("m.glsl:6: 'layout'"));
  EXPECT_THAT(faults(plugin("", "#version 330\n#line 3\n#extension all : enable\n")),
              AllOf(HasSubstr("m.glsl:5: #version"), HasSubstr("m.glsl:6: #line"), HasSubstr("m.glsl:7: #extension")));
  EXPECT_THAT(faults(plugin("", "void main() {}\nstruct Parameters { int x; };\nfloat glintX = 1.0;")),
              AllOf(HasSubstr("m.glsl:5: defines 'main'"), HasSubstr("m.glsl:6: defines 'Parameters'"),
                    HasSubstr("m.glsl:7: defines 'glintX'")));
  EXPECT_THAT(faults(plugin("", "float schlickWeight(float x) { return x; }")), HasSubstr("m.glsl:5: defines 'schlickWeight' again"));
  EXPECT_EQ(faults(plugin("", "float schlickWeight(vec2 x) { return x.x; }")), "") << "an overload is another function";
  EXPECT_THAT(faults(plugin("", "float f() {\n")), HasSubstr("m.glsl:5: '{' is never closed"));
  EXPECT_THAT(faults(plugin("", "float f() { } }\n")), HasSubstr("m.glsl:5: '}' closes nothing"));
  EXPECT_THAT(faults(plugin("", "\n/* f")), HasSubstr("m.glsl:6: the comment never ends"));
  EXPECT_THAT(faults(plugin("", "#if 1\nfloat x = 1.0;")), HasSubstr("m.glsl:5: this condition has no #endif"));
}

// What a plugin cannot use, because it is evaluated for single pairs of directions in shaders of every kind.
TEST(ModelHead, WordsThatAreNotForPlugins) {
  EXPECT_EQ(faults(plugin("", "float f(float x) {\n  if (x < 0.0) discard;\n  return gl_FragCoord.x + gl_FragCoord.y;\n}")),
            "m.glsl:6: 'discard' is not for a plugin; a model has no pixel to drop: return vec3(0.0), or use the opacityMask of a material\n"
            "m.glsl:7: 'gl_FragCoord' is not for a plugin; a model is evaluated for one pair of directions: all it has is what it is called with\n");
  EXPECT_THAT(faults(plugin("", "float f(float x) { return dFdx(x); }")), HasSubstr("m.glsl:5: 'dFdx' is not for a plugin"));
  EXPECT_THAT(faults(plugin("", "\n#define HERE gl_FragCoord\n")), HasSubstr("m.glsl:6: 'gl_FragCoord' is not for a plugin"));
  EXPECT_THAT(faults(plugin("", "in vec3 a;")), HasSubstr("m.glsl:5: 'in' is not for a plugin"));
  EXPECT_THAT(faults(plugin("", "layout(location = 0) out vec4 c;")), HasSubstr("m.glsl:5: 'layout' is not for a plugin"));
  EXPECT_THAT(faults(plugin("", "float f() { float half = 0.5; return half; }")),
              HasSubstr("m.glsl:5: 'half' is a reserved word of GLSL; choose another name"));
  EXPECT_THAT(faults(plugin("", "float a__b = 1.0;")), HasSubstr("m.glsl:5: 'a__b' is reserved"));
  EXPECT_THAT(faults(plugin("", "#include \"../secret.glsl\"\n#pragma optimize(off)\n")),
              AllOf(HasSubstr("m.glsl:5: #include"), HasSubstr("m.glsl:6: #pragma")));
  EXPECT_THAT(faults(plugin("", "#define float double\n#undef LIGHTS\n")),
              AllOf(HasSubstr("m.glsl:5: 'float' is a word of GLSL"), HasSubstr("m.glsl:6: 'LIGHTS' is no macro of this file")));
  EXPECT_EQ(faults(plugin("", "struct S { float x; };\nfloat f(S s) { /* discard */ return s.x; } // gl_Position")), "");
}

// No loop and no recursion, and yet no compiler comes back from it.
TEST(ModelHead, CallsThatDoubleAtEveryStep) {
  std::string body = "float a0(float x) { return sin(x) + 1.0; }\n";
  for (int i = 1; i <= 40; ++i) body += fmt::format("float a{0}(float x) {{ return a{1}(x) + a{1}(x + 0.1); }}\n", i, i - 1);
  EXPECT_THAT(faults(plugin("", body)), AllOf(HasSubstr("m.glsl:2"), HasSubstr("operations when each call is written out")));
}

TEST(ModelHead, RecursionAtTheCall) {
  EXPECT_EQ(faults(plugin("", "float g(float x);\nfloat f(float x) {\n  return x > 0.0 ? g(max(x, 1.0)) : 0.0;\n}\n"
                              "float g(float x) { return\n f(x); }")),
            "m.glsl:10: 'f' calls itself: f -> g -> f; GLSL has no recursion: write a loop\n");
  EXPECT_THAT(faults(plugin("", "float f() { return f(); }")), HasSubstr("m.glsl:5: 'f' calls itself: f -> f"));
  EXPECT_EQ(faults(plugin("", "float f(vec3 v) { return 1.0; }\nfloat f(float x, float y) { return f(vec3(x, y, 1.0)); }\n"
                              "float f(float x) { return f(vec3(x)); }")), "")
      << "overloads are other functions";
  EXPECT_EQ(faults(plugin("", "float f() { return 1.0; }\nfloat g() { return f() + f(); }\nfloat h() { return g() + f(); }")), "");
}

// Compilers recurse over expressions and expand macros of macros: both are bounded before they see them.
TEST(Body, ArraysAndLoopsAreSmall) {
  EXPECT_EQ(faults(plugin("", "const int N = 8;\nfloat f(int i) { float a[N], b[3] = float[3](1.0, 2.0, 3.0); vec2 c[] = vec2[](vec2(1.0)); return a[i + 1] + b[2 * i] + c[0].x; }")), "");
  EXPECT_EQ(faults(plugin("", "struct Knot { float at[16]; };\nfloat f(Knot k[4], int i) { return k[i].at[i * 2]; }")), "");
  EXPECT_THAT(faults(plugin("", "float f() {\n  float a[10000000];\n  return a[3];\n}")), HasSubstr("m.glsl:6: an array of 10000000; at most 1024 are possible"));
  EXPECT_THAT(faults(plugin("", "const int N = 100000;\nfloat f() { float a[N]; return a[3]; }")), HasSubstr("an array of 100000"));
  EXPECT_THAT(faults(plugin("", "float f() { float a[1000 * 1000]; return a[3]; }")), HasSubstr("the size of an array is no plain number"));
  EXPECT_THAT(faults(plugin("", "struct Big { float at[1000]; };\nfloat f(Big b) { return b.at[0]; }")), HasSubstr("at most 32 are possible of a struct, or in one"));
  EXPECT_THAT(faults(plugin("", "float f() {\n  float x = 0.0;\n  for (int i = 0; i < 1000000000; ++i) x += 1.0;\n  return x;\n}")), HasSubstr("m.glsl:7: a loop of 1000000000"));
}

TEST(ModelHead, TextThatNoCompilerSurvives) {
  EXPECT_THAT(faults(plugin("", "float x = " + std::string(100000, '(') + "1.0" + std::string(100000, ')') + ";")),
              HasSubstr("brackets nest too deep"));
  std::string sum = "float x = 1.0";
  for (int i = 0; i < 60000; ++i) sum += "+x";
  EXPECT_THAT(faults(plugin("", sum + ";")), HasSubstr("a statement of more than"));
  std::string laughs = "#define a0 x x x x x x x x x x\n";
  for (int i = 1; i < 10; ++i) {
    laughs += "#define a" + std::to_string(i);
    for (int j = 0; j < 10; ++j) laughs += " a" + std::to_string(i - 1);
    laughs += "\n";
  }
  EXPECT_THAT(faults(plugin("", laughs)), HasSubstr("grows without measure"));
  EXPECT_THAT(faults(plugin("", "#define F(x) x x\n")), HasSubstr("the macro 'F' has arguments"));
  EXPECT_THAT(faults(plugin("", "#define U uni ## form\nU float x;\n")), HasSubstr("## pastes words together"));
}

// Software drivers make 0 of it, which would pass for sound.
TEST(ModelHead, ADivisionByZeroIsNamed) {
  const auto of = [](const std::string& value) { return faults(plugin("", "float f(float x, vec3 v) {\n  return " + value + ";\n}")); };
  for (const char* zero : {"x / 0.0", "x/0.", "x / .0", "x / (0.0)", "x / ( ( 0 ) )", "sqrt(x - 2.0) / 0.0 * x", "x / 00.0f", "x / 0", "x / (x - x)", "x/(v.x-v.x)",
                           "x / (dot(v, v) - dot( v,v ))"})
    EXPECT_THAT(of(zero), HasSubstr("m.glsl:6: divides by 0")) << zero;
  for (const char* sound : {"x / 0.5", "x / 10.0", "x / (0.0 + x)", "x / 0.01", "x / v.x", "x // 0.0\n", "x / (v.x * 0.0 + 1.0)", "x / 1e0", "x / 0.0001e4", "x / 0x1", "x / (x - v.x)", "x / (2.0 * x - x)", "x / (x)", "x / (x - x * 0.5)", "x / (x - x + 1.0)"})
    EXPECT_EQ(of(sound).find("divides"), std::string::npos) << sound;
  EXPECT_THAT(faults(plugin("", "float f(float x) {\n  x /= 0.0;\n  return x;\n}")), HasSubstr("m.glsl:6: divides by 0"));
}

TEST(GlslScan, SeesWhatIsDefinedAndNothingElse) {
  const GlslScan scan = scanGlsl(R"(// About f.
// More.
float f(const in vec3 a, float b[2], int) { if (a.x > 0.0) { return g(a); } return 1.0; }
/* float commented(int x) { return 1.0; } */
// float commentedToo(int x) { \
   return 1.0; }
#if 0
float never(int x) { return 1.0; }
# if 1
float nested() { return 1.0; }
# endif
#else
float always() { return 1.0; }
#endif
#define MACRO \
  float notThis() { }
float prototype(int x);
const float table[2] = float[2](1.0, 2.0);
struct S { float inner(); int y; } s;
Result own(Shading s, Parameters p)
{
  float local = f(vec3(0.0));
}
)");
  ASSERT_EQ(scan.functions.size(), 3u);
  EXPECT_EQ(scan.functions[0].name, "f");
  EXPECT_EQ(scan.functions[0].parameterTypes, (std::vector<std::string>{"vec3", "float", "int"}));
  EXPECT_EQ(scan.functions[0].comment, "About f.\nMore.");
  EXPECT_EQ(scan.functions[0].line, 3);
  EXPECT_EQ(scan.functions[1].name, "always");
  EXPECT_EQ(scan.functions[2].name, "own");
  EXPECT_EQ(scan.functions[2].returnType, "Result");
  EXPECT_EQ(scan.functions[2].line, 20);
  EXPECT_TRUE(scan.faults.empty());
  EXPECT_EQ(scan.macros, std::vector<std::string>{"MACRO"});
  std::vector<std::string> names;
  for (const GlslName& name : scan.names) names.push_back(name.name);
  EXPECT_THAT(names, testing::IsSupersetOf({"f", "prototype", "table", "S", "own"}));
}

TEST(Terms, AreThoseOfTheFiles) {
  EXPECT_THAT(termNames(TermKind::D), testing::IsSupersetOf({"GGX", "Beckmann", "Blinn", "GTR1"}));
  EXPECT_THAT(termNames(TermKind::V), testing::IsSupersetOf({"SmithGGXCorrelated", "SchlickGGXHot", "Implicit"}));
  EXPECT_THAT(termNames(TermKind::F), testing::IsSupersetOf({"Schlick", "None"}));
  EXPECT_THAT(termNames(TermKind::Diffuse), testing::IsSupersetOf({"Lambert", "Burley", "OrenNayar"}));
  for (const Term& term : terms()) EXPECT_NE(term.doc, "") << term.function() << " has no citation above it";
}

// Every line of a driver gets the same advice.
Diagnostic fault(const char* place, const char* what) {
  return error(place, what, "'glint new-model ID' writes a start that lists what a plugin can use");
}

TEST(ModelErrors, DriversFormats) {
  const auto model = parseModel("m.glsl", plugin("", "float f() { return 1.0; }\n"));
  ASSERT_TRUE(model);
  const auto first = [&](const std::string& log) { return modelErrors(*model, log)[0]; };
  EXPECT_EQ(first("0:100005(12): error: `x' undeclared\n"), fault("m.glsl:5", "`x' undeclared"));
  EXPECT_EQ(first("7(100005) : error C1008: undefined variable \"x\"\n"), fault("m.glsl:5", "undefined variable \"x\""));
  EXPECT_EQ(first("ERROR: 7:100005: 'x' : undeclared identifier\n"), fault("m.glsl:5", "'x' : undeclared identifier"));
  EXPECT_EQ(first("0:12(3): error: no function 'D'"), fault("m.glsl (generated, line 12)", "no function 'D'"));
  EXPECT_EQ(first("0:100001(1): warning: w\n0:100005(2): error: e\n"), fault("m.glsl:5", "e"));
  EXPECT_EQ(first("error: linking failed"), fault("m.glsl (generated)", "linking failed"));
  EXPECT_EQ(first("0:199999(1): error: after the end").place, "m.glsl:6") << "the last line there is";
  EXPECT_THAT(first("").what, HasSubstr("did not say why"));
  // Recursion between overloads and functions without a body are found when a program is linked.
  EXPECT_EQ(first("error: function `float f(float)' has static recursion"),
            error("m.glsl:5", "function `float f(float)' has static recursion", "GLSL has no recursion: write a loop"));
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "0:100005(1): error: e\n";
  EXPECT_LE(modelErrors(*model, many).size(), 20u);
}

TEST(ModelErrors, OneForEachFault) {
  const auto model = parseModel("m.glsl", plugin("", "\n\n\n\n\n"));
  ASSERT_TRUE(model);
  EXPECT_EQ(modelErrors(*model,
                        "0:100006(3): error: no matching function for call to `max(vec3, Shading)'; candidates are:\n"
                        "0:100006(3): error: float max(float, float)\n"
                        "0:100006(3): error: type mismatch\n"
                        "0:100007(3): error: `x' undeclared\n"
                        "0:100008(3): error: `x' undeclared\n"
                        "0:100009(3): error: no matching function for call to `f(error)'; candidates are:\n"),
            (Diagnostics{fault("m.glsl:6", "no matching function for call to `max(vec3, Shading)'"), fault("m.glsl:7", "`x' undeclared")}));
}

// Whatever the bytes, an answer comes: a model, or faults with places.
TEST(ModelHead, FuzzedFilesAreAnswered) {
  std::mt19937 random(7);
  std::vector<std::string> seeds = {plugin("\"parameters\": [{\"name\": \"a\", \"type\": \"vec3\", \"default\": [0, 1, 0.5]}]",
                                           "#if 0\n#endif\n#define K 3\nfloat f(int x) { return 1.0; }\n")};
  for (const std::string& path : shipped::list("shaders/models", ".glsl")) seeds.push_back(*shipped::read(path));
  const std::string marks = "{}[]()\"/*\\#,:;\n\0\xff" "19eE.-";
  for (int round = 0; round < 4000; ++round) {
    std::string text = seeds[random() % seeds.size()];
    for (int edits = 1 + static_cast<int>(random() % 6); edits > 0; --edits) {
      const size_t at = random() % text.size();
      switch (random() % 5) {
        case 0: text[at] = static_cast<char>(random()); break;
        case 1: text[at] = marks[random() % marks.size()]; break;
        case 2: text.erase(at, 1 + random() % 20); break;
        case 3: text.insert(at, text.substr(random() % text.size(), random() % 40)); break;
        case 4: text.insert(at, 1, marks[random() % marks.size()]); break;
      }
      if (text.empty()) text = " ";
    }
    if (random() % 10 == 0) text.resize(random() % text.size());
    const auto model = parseModel("m.glsl", text);
    if (model) {
      EXPECT_TRUE(isModelId(model->id));
      EXPECT_FALSE(modelGlsl(*model, kModelSourceIndex).empty());
    } else {
      for (const Diagnostic& d : model.diagnostics()) EXPECT_EQ(d.place.substr(0, 6), "m.glsl") << d.text();
    }
  }
}

// Where a model that takes too long has most of its work: the loop within the most others, not the `while` of a `do`.
TEST(Loops, TheDeepestIsFound) {
  EXPECT_EQ(lineOfDeepestLoop("float f() { return 1.0; }"), std::nullopt);
  EXPECT_EQ(lineOfDeepestLoop("// for (;;)\nfloat f() {\n  while (x < 3.0) x += 1.0;\n  return x;\n}\n"), 3);
  EXPECT_EQ(lineOfDeepestLoop("void f() {\n  do { x++; } while (x < 3);\n  for (;;) {\n    for (;;) {\n      while (y) y--;\n    }\n  }\n}\n"), 5);
}

}  // namespace
}  // namespace glint
