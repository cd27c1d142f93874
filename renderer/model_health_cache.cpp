#include "renderer/model_health_cache.h"

#include <cmath>
#include <limits>

#include "materials/base/hash.h"
#include "materials/base/json.h"
#include "materials/terms.h"
#include "renderer/disk_cache.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

constexpr const char* kKind = "health";

// Of the sources that measure (renderer/CMakeLists.txt hashes them), and of the shipped GLSL that is measured with.
uint64_t recipeHash() {
  uint64_t hash = hashText(GLINT_HEALTH_RECIPE);
  hash = hashText(termsGlsl(), hash);
  for (const char* file : {"shaders/common/shading.glsl", "shaders/passes/model_integrals.comp"})
    hash = hashText(shipped::read(file).value_or(""), hash);
  return hash;
}

// Places in the model's files, which a card of the same text elsewhere has elsewhere: a sign stands for each.
constexpr char kFile = '\1', kSourceFile = '\2';

std::string withoutPath(const std::string& where, const ShadingModel& model) {
  for (const auto& [sign, path] : {std::pair{kFile, model.file.string()}, {kSourceFile, model.sourceFile.string()}})
    if (!path.empty() && where.starts_with(path + ":")) return sign + where.substr(path.size());
  return where;
}

std::string withPath(const std::string& where, const ShadingModel& model) {
  if (where.starts_with(kFile)) return model.file.string() + where.substr(1);
  if (where.starts_with(kSourceFile)) return model.sourceFile.string() + where.substr(1);
  return where;
}

std::string textOf(const ModelHealth& card, const ShadingModel& model) {
  Json laws = Json::array();
  for (const LawResult& law : card.laws) {
    Json one = Json::object();
    one.set("law", Json::of(static_cast<int>(law.law)));
    one.set("verdict", Json::of(static_cast<int>(law.verdict)));
    one.set("claimed", Json::of(law.claimed));
    if (std::isfinite(law.value)) one.set("value", Json::of(law.value));
    one.set("where", Json::of(withoutPath(law.where, model)));
    one.set("reason", Json::of(law.reason));
    one.set("hint", Json::of(law.hint));
    laws.push(std::move(one));
  }
  Json json = Json::object();
  json.set("seconds", Json::of(card.seconds));
  json.set("laws", std::move(laws));
  return writeJson(json);
}

// Nothing when it is not what textOf() wrote.
std::optional<ModelHealth> cardFrom(const std::string& text, const ShadingModel& model) {
  const auto json = parseJson(text, kKind);
  if (!json) return std::nullopt;
  const Json *seconds = json->find("seconds"), *laws = json->find("laws");
  if (!seconds || !seconds->isNumber() || !laws || !laws->isArray()) return std::nullopt;
  ModelHealth card{.model = model.id, .file = model.file.string(), .laws = {}, .seconds = seconds->number};
  for (const Json& one : laws->items) {
    const Json *law = one.find("law"), *verdict = one.find("verdict"), *claimed = one.find("claimed"), *value = one.find("value");
    const Json *where = one.find("where"), *reason = one.find("reason"), *hint = one.find("hint");
    if (!law || !verdict || !claimed || !where || !reason || !hint) return std::nullopt;
    if (!(law->number >= 0 && law->number < kLawCount && verdict->number >= 0 && verdict->number <= 2)) return std::nullopt;
    card.laws.push_back({.law = static_cast<Law>(law->number), .verdict = static_cast<Verdict>(verdict->number), .claimed = claimed->boolean,
                         .value = value ? value->number : std::numeric_limits<double>::quiet_NaN(), .where = withPath(where->text, model),
                         .reason = reason->text, .hint = hint->text});
  }
  return card;
}

}  // namespace

uint64_t healthKey(const ShadingModel& model) { return hashText(model.id, model.hash ^ recipeHash()); }

std::optional<ModelHealth> keptHealth(const ShadingModel& model) {
  const auto stored = readCache(kKind, healthKey(model));
  return stored ? cardFrom(*stored, model) : std::nullopt;
}

ModelHealth healthOf(const ShadingModel& model) { return *healthOf(model, {}); }

std::optional<ModelHealth> healthOf(const ShadingModel& model, const std::function<bool()>& stopped) {
  if (auto kept = keptHealth(model)) return kept;
  ModelHealth card = checkHealth(model, false, stopped);
  if (stopped && stopped()) return std::nullopt;
  const LawResult* compiles = card.find(Law::Compiles);
  if (compiles && compiles->verdict == Verdict::Green) writeCache(kKind, healthKey(model), textOf(card, model));
  return card;
}

}  // namespace glint
