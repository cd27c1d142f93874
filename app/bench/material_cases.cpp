#include <atomic>

#include "app/bench/cases.h"
#include "app/bench/standard_scene.h"
#include "materials/graph_compile.h"
#include "materials/graph_edit.h"

namespace glint {
namespace {

// A graph of `count` nodes, each of which the surface depends on: a noise, then arithmetic on the two nodes before.
// `variant` is a constant in the text, so that each makes a program of its own.
Material chain(int count, int variant) {
  static constexpr const char* kKinds[] = {"multiply", "add", "sin", "fract"};
  Material material = newMaterial(fmt::format("chain-{}", count));
  std::string last = "n0.value", before = last;
  const auto wire = [](const std::string& source) {
    const size_t dot = source.find('.');
    return Input{PinRef{source.substr(0, dot), source.substr(dot + 1)}, {}};
  };
  for (int i = 0; i < count - 1; ++i) {
    Node node;
    node.kind = i == 0 ? "noise" : kKinds[i % 4];
    if (i == 0) {
      node.inputs["scale"] = {{}, Value::scalar(4 + 0.001f * float(variant))};
    } else if (i % 4 < 2) {
      node.inputs["a"] = wire(last);
      node.inputs["b"] = i % 8 < 4 ? wire(before) : Input{{}, Value::scalar(0.5f + 0.01f * float(i))};
    } else {
      node.inputs["x"] = wire(last);
    }
    const std::string id = fmt::format("n{}", i);
    material.nodes[id] = std::move(node);
    before = last;
    last = id + ".value";
  }
  material.nodes[material.outputNode()].inputs["roughness"] = wire(last);
  return material;
}

// Every call its own, whatever ran before.
int nextVariant() {
  static std::atomic<int> variant{1};
  return variant++;
}

Result<Measurement> compileCase(BenchSetup& setup, int nodes) {
  const auto model = plainModel(setup.libraries);
  if (!model) return model.diagnostics();
  const Material material = chain(nodes, 0);
  const auto once = compileMaterial(material, **model, setup.libraries.nodes, setup.libraries.functions);
  if (!once) return once.diagnostics();
  return measure(fmt::format("graph.compile.{}", nodes), setup.effort,
                 [&] { (void)compileMaterial(material, **model, setup.libraries.nodes, setup.libraries.functions); },
                 fmt::format("{} bytes of GLSL", once->glsl.size()));
}

// The standard scene with the top row in a material of its own.
struct Edited {
  Scene scene;
  ModelPtr model;
};

Result<Edited> editedScene(BenchSetup& setup) {
  const auto model = plainModel(setup.libraries);
  if (!model) return model.diagnostics();
  auto scene = standardScene({*model}, setup.libraries);
  if (!scene) return scene.diagnostics();
  scene->lights.push_back(standardSun());
  return Edited{std::move(*scene), *model};
}

void draw(BenchSetup& setup, const Scene& scene) {
  RenderSettings settings;
  settings.background = Background::None;
  const View view{&scene, standardCamera(), {0, 0, kStandardSize.x, kStandardSize.y}};
  setup.renderer().drawToTexture({&view, 1}, kStandardSize, settings);
}

Diagnostics putOn(BenchSetup& setup, Edited& edited, const Material& material) {
  Diagnostics problems;
  auto surface = surfaceWith(material, edited.model, {}, "bench", setup.libraries.sources(), problems);
  if (!surface) return surface.diagnostics();
  edited.scene.materials[0] = std::move(*surface);
  return {};
}

// From compiled GLSL to its first finished frame: the driver's share of a new material.
Result<Measurement> linkCase(BenchSetup& setup) {
  auto edited = editedScene(setup);
  if (!edited) return edited.diagnostics();
  draw(setup, edited->scene);
  std::vector<double> times;
  for (int i = 0; i < (setup.quick ? 1 : 5); ++i) {
    if (const Diagnostics problems = putOn(setup, *edited, chain(10, nextVariant())); !problems.empty()) return problems;
    times.push_back(timed([&] { draw(setup, edited->scene); }));
  }
  return summarize("graph.link", times, "a new program of 10 nodes, linked and drawn once");
}

Result<Measurement> parameterCase(BenchSetup& setup) {
  auto edited = editedScene(setup);
  if (!edited) return edited.diagnostics();
  draw(setup, edited->scene);
  SurfaceMaterial& surface = edited->scene.materials[0];
  auto compiled = std::make_shared<CompiledMaterial>(*surface.compiled);
  UniformField* roughness = compiled->uniform("roughness");
  GLINT_CHECK(roughness != nullptr);
  int step = 0;
  return measure("edit.parameter", setup.effort, [&] {
    roughness->value.v[0] = float(step++ % 100) / 100;
    surface.block = compiled->block();
    draw(setup, edited->scene);
  });
}

// A node is added and wired, as in the editor, and the frame drawn with what comes of it.
Result<Measurement> structureCase(BenchSetup& setup) {
  auto edited = editedScene(setup);
  if (!edited) return edited.diagnostics();
  Diagnostics problems = putOn(setup, *edited, chain(10, nextVariant()));
  draw(setup, edited->scene);
  std::vector<double> times;
  for (int i = 0; i < (setup.quick ? 1 : 5) && problems.empty(); ++i) {
    GraphEditor editor(chain(10, nextVariant()));
    times.push_back(timed([&] {
      NodeId made;
      problems = editor.addNode("one-minus", {}, &made);
      const std::string output = editor.material().outputNode();
      const auto from = editor.material().node(output)->inputs.at("roughness").from;
      if (problems.empty()) problems = editor.connect(*from, {made, "x"});
      if (problems.empty()) problems = editor.connect({made, "value"}, {output, "roughness"});
      if (problems.empty()) problems = putOn(setup, *edited, editor.material());
      draw(setup, edited->scene);
    }));
  }
  if (!problems.empty()) return problems;
  return summarize("edit.structure", times, "a node added to 10: compiled, linked, drawn");
}

}  // namespace

std::vector<BenchCase> materialCases() {
  std::vector<BenchCase> cases;
  for (const int nodes : {10, 100, 1000})
    cases.push_back({fmt::format("graph.compile.{}", nodes), fmt::format("a graph of {} nodes to GLSL", nodes),
                     [nodes](BenchSetup& setup) { return compileCase(setup, nodes); }});
  cases.push_back({"graph.link", "the GLSL of 10 new nodes to its first finished frame", linkCase});
  cases.push_back({"edit.parameter", "a slider moved to the finished frame at 1280x720", parameterCase});
  cases.push_back({"edit.structure", "a node added and wired to the finished frame at 1280x720", structureCase});
  return cases;
}

}  // namespace glint
