#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "app/bench/cases.h"
#include "app/bench/temporary_folder.h"
#include "app/editor/ui_driver.h"
#include "materials/terms.h"
#include "renderer/evaluation.h"
#include "renderer/model_health.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

// A plugin that no cache has met: a constant of its own is compiled into it.
std::string neverSeen(const std::string& id) {
  static std::atomic<int> variant{int(Clock::now().time_since_epoch().count() % 100000)};
  return fmt::format("/*glint {{\"id\": \"{}\", \"terms\": {{\"D\": \"GGX\", \"V\": \"SmithGGXCorrelated\", \"diffuse\": \"Lambert\"}}}} */\n"
                     "vec3 F(Shading s, Parameters p) {{ return F_Schlick(s) * {:.9f}; }}\n", id, 1 - 1e-8 * (variant++ % 1000000));
}

Result<Measurement> verifyOne(BenchSetup& setup) {
  std::vector<double> times;
  std::string verdict;
  for (int i = 0; i < (setup.quick ? 1 : 5); ++i) {
    auto model = parseModel("bench.glsl", neverSeen("bench"));
    if (!model) return model.diagnostics();
    ModelHealth card;
    times.push_back(timed([&] { card = checkHealth(*model); }));
    verdict = name(card.verdict());
  }
  return summarize("verify.one", times, "never seen before: " + verdict);
}

Result<Measurement> verifyAll(BenchSetup& setup) {
  const std::vector<ModelPtr> all = ModelRegistry().all();
  std::vector<double> times;
  for (int i = 0; i < (setup.quick ? 1 : 3); ++i)
    times.push_back(timed([&] {
      for (const ModelPtr& model : all) (void)checkHealth(*model);
    }));
  return summarize("verify.all", times, fmt::format("{} models", all.size()));
}

Result<Measurement> evaluateTerms(BenchSetup& setup) {
  constexpr size_t kCount = 10000;
  std::vector<EvaluationRequest> requests;
  std::vector<Term> library = terms();
  std::erase_if(library, [](const Term& t) { return t.ofOwnD; });  // no values without a D
  for (size_t i = 0; i < kCount; ++i) {
    const Term& term = library[i % library.size()];
    const double t = double(i) / kCount;
    EvaluationRequest request{.what = term.function(), .numbers = {{"r", 0.05 + 0.95 * t}, {"NoL", 0.1 + 0.8 * t}, {"NoV", 0.9 - 0.5 * t},
                                                                   {"NoH", 0.99 - 0.3 * t}, {"VoH", 0.8 - 0.3 * t}, {"F0", 0.04}, {"albedo", 0.5}}};
    for (const TermParameter& p : term.parameters) request.numbers[p.name] = p.standard;
    requests.push_back(std::move(request));
  }
  size_t missing = kCount;
  Measurement result = measure("eval.terms", setup.effort, [&] {
    missing = 0;
    for (const EvaluationResult& one : evaluate(requests, setup.libraries.models)) missing += one.values.empty();
  });
  result.note = fmt::format("{} values of {} terms", kCount - missing, library.size());
  return result;
}

// A plugin is written into a folder that the editor watches while a comparison waits for it, until `done`.
Result<Measurement> drop(BenchSetup& setup, const std::string& name, const std::string& note, bool (*done)(Editor&, const std::string& id)) {
  const TemporaryFolder folder;
  UiDriver driver(setup.context, EditorOptions{.modelFolders = {folder.path()}, .modelFiles = {}, .configFolder = {}, .wake = {}}, {1280, 960});
  Editor& editor = driver.editor();
  std::vector<double> times;
  for (int i = 0; i < (setup.quick ? 1 : 5); ++i) {
    const std::string id = fmt::format("dropped-{}", i);
    Preview preview = editor.document().preview();
    preview.models = {"ggx", "burley", id};
    editor.document().setPreview("Compare", preview);
    if (!driver.settle()) return error(name, "the editor did not come to rest", "try again on an idle machine");
    const std::string text = neverSeen(id);
    const auto start = Clock::now();
    std::ofstream(folder.path() / (id + ".glsl")) << text;
    while (!done(editor, id)) {
      if (millisecondsSince(start) > 60000) return error(name, "no picture within a minute", "see what the model's file says");
      // As the window does: it looks four times a second, and draws when there is something new.
      if (editor.hasNews() || editor.render().hasFinished()) driver.frames();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    times.push_back(millisecondsSince(start));
  }
  setup.context.makeCurrent();
  return summarize(name, times, note);
}

bool drawn(Editor& editor, const std::string& id) {
  const FrameResult& shown = editor.shown();
  if (!shown.comparison || shown.layout.grid.columns == 0) return false;
  for (size_t row = 0; row < shown.rows.size(); ++row)
    if (shown.rows[row].text == id && shown.rows[row].model)
      return shown.states[row * size_t(shown.layout.grid.columns)].kind == PreviewScene::State::Drawn;
  return false;
}

bool examined(Editor& editor, const std::string& id) {
  return drawn(editor, id) && editor.render().settled() && editor.health().card(editor.models().find(id)) != nullptr;
}

}  // namespace

std::vector<BenchCase> modelCases() {
  return {{"verify.one", "the health card of a model never seen before", verifyOne},
          {"verify.all", "the health cards of all shipped models", verifyAll},
          {"eval.terms", "10,000 values of terms", evaluateTerms},
          {"model.drop", "a new plugin dropped into a watched folder, to its first picture",
           [](BenchSetup& setup) { return drop(setup, "model.drop", "by coarse tables of its environment, which fine ones follow", drawn); }},
          {"model.drop.card", "the same, to its finest picture and its health card",
           [](BenchSetup& setup) { return drop(setup, "model.drop.card", "everything that is derived from it", examined); }}};
}

}  // namespace glint
