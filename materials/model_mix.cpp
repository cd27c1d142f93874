#include "materials/model_mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "materials/base/check.h"
#include "materials/base/json.h"
#include "materials/terms.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

struct Part {
  TermKind kind;
  std::string_view key;  // in a head's "terms"
  std::string ModelMix::*name;
};
constexpr std::array<Part, 4> kParts = {{{TermKind::D, "D", &ModelMix::D},
                                         {TermKind::V, "V", &ModelMix::V},
                                         {TermKind::F, "F", &ModelMix::F},
                                         {TermKind::Diffuse, "diffuse", &ModelMix::diffuse}}};

constexpr const char* kForm = "write D*V*F or D*V*F*diffuse, for example GGX*SmithGGXCorrelated*Schlick";

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == '*') parts.emplace_back();
    else if (c != ' ') parts.back() += c;
  }
  return parts;
}

}  // namespace

std::string ModelMix::id() const { return D + "*" + V + "*" + F + (diffuse == "Lambert" ? "" : "*" + diffuse); }

bool isModelMix(std::string_view id) { return id.find('*') != id.npos; }

std::string namedMix(std::string_view name) {
  static const Json names = [] {
    constexpr const char* kFile = "shaders/terms/mixes.json";
    const auto parsed = parseJson(shipped::read(kFile).value_or("{}"), kFile);
    GLINT_CHECK(parsed.ok() && parsed->isObject(), "{}", kFile);
    return *parsed;
  }();
  const Json* mix = names.find(name);
  return mix ? mix->text : "";
}

Result<ModelMix> parseModelMix(std::string_view id) {
  const std::string place = fmt::format("model '{}'", id.substr(0, 200));
  const std::vector<std::string> names = split(id);
  if (names.size() < 3 || names.size() > 4)
    return error(place, fmt::format("mixes {} terms, not three or four", names.size()), kForm);
  ModelMix mix;
  Diagnostics problems;
  for (size_t i = 0; i < names.size(); ++i) {
    const Part& part = kParts[i];
    const std::vector<std::string> known = termNames(part.kind);
    if (std::find(known.begin(), known.end(), names[i]) == known.end())
      problems.push_back(error(place, fmt::format("unknown {} term '{}'", part.key, names[i].substr(0, 64)),
                               suggestion(names[i], known)));
    mix.*part.name = names[i];
  }
  if (!problems.empty()) return problems;
  return mix;
}

std::string pluginOfMix(const ModelMix& mix, const std::string& id, const std::map<std::string, float>& values) {
  Json terms = Json::object(), cite = Json::array(), parameters = Json::array();
  std::string title;
  for (const Part& part : kParts) {
    const std::string& name = mix.*part.name;
    terms.set(std::string(part.key), Json::of(name));
    title += (title.empty() ? "" : " x ") + name;
    const auto term = findTerm(part.kind, name);
    for (const TermParameter& p : term ? term->parameters : std::vector<TermParameter>{}) {
      const auto value = values.find(p.name);
      if (value == values.end() || value->second == p.standard) continue;
      Json& parameter = parameters.push(Json::object());
      parameter.set("name", Json::of(p.name));
      parameter.set("type", Json::of(std::string("float")));
      parameter.set("min", Json::of(p.minimum));
      parameter.set("max", Json::of(p.maximum));
      parameter.set("default", Json::of(value->second));
      parameter.set("doc", Json::of(p.doc));
    }
    if (term)
      cite.push(Json::of(fmt::format("{}: {}", part.key, term->doc.substr(0, term->doc.find('\n')))));
  }
  Json head = Json::object();
  head.set("id", Json::of(id));
  head.set("title", Json::of(title));
  head.set("doc", Json::of("A mix of terms. It claims nothing until it is told to: glint verify says which laws it keeps."));
  if (!parameters.items.empty()) head.set("parameters", std::move(parameters));
  head.set("terms", std::move(terms));
  head.set("claims", Json::object());
  head.set("cite", std::move(cite));
  return "/*glint\n" + writeJson(head) + "*/\n";
}

Result<ShadingModel> mixModel(std::string_view id) {
  const auto mix = parseModelMix(id);
  if (!mix) return mix.diagnostics();
  auto model = parseModel(mix->id(), pluginOfMix(*mix, "mix"));
  if (model) model->id = mix->id();
  return model;
}

}  // namespace glint
