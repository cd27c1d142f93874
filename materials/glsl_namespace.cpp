#include "materials/glsl_namespace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "materials/glsl_builtins.h"
#include "materials/glsl_scan.h"
#include "materials/glsl_words.h"

namespace glint {
namespace {

bool isNameChar(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Words since GLSL 4.20 and 4.30: names in what was written before.
bool isLaterWord(std::string_view word) {
  static const std::set<std::string_view> kLater = {"buffer", "shared", "coherent", "restrict", "readonly", "writeonly", "resource"};
  return kLater.count(word) != 0;
}

bool isSwizzle(std::string_view name) {
  if (name.size() > 4) return false;
  for (const std::string_view letters : {"xyzw", "rgba", "stpq"})
    if (name.find_first_not_of(letters) == name.npos) return true;
  return false;
}

struct Token {
  std::string_view text;
  size_t begin = 0;
  bool isName = false;
  bool renamed = false;
};

class Renamer {
 public:
  Renamer(std::string_view text, std::string_view prefix) : prefix_(prefix), plain_(withoutComments(text)) { split(); }

  GlslNamespace run(const std::vector<std::string>& variables) {
    own_.insert(variables.begin(), variables.end());
    noteGlobals();
    mark();
    GlslNamespace made;
    size_t at = 0;
    for (const Token& token : tokens_) {
      made.text.append(plain_, at, token.begin - at);
      made.text += written(token);
      at = token.begin + token.text.size();
    }
    made.text.append(plain_, at);
    made.overloads = overloads();
    made.initialisers = initialisers();
    return made;
  }

 private:
  // Every comment as one space, with the ends of its lines.
  static std::string withoutComments(std::string_view text) {
    std::string plain;
    for (size_t i = 0; i < text.size();) {
      if (text.substr(i, 2) == "//") {
        i = std::min(text.find('\n', i), text.size());
      } else if (text.substr(i, 2) == "/*") {
        const size_t end = std::min(text.find("*/", i + 2), text.size());
        plain += ' ';
        plain.append(static_cast<size_t>(std::count(text.begin() + static_cast<long>(i), text.begin() + static_cast<long>(end), '\n')), '\n');
        i = std::min(end + 2, text.size());
      } else {
        plain += text[i++];
      }
    }
    return plain;
  }

  void split() {
    const std::string_view text = plain_;
    for (size_t i = 0; i < text.size();) {
      const char c = text[i];
      if (std::isspace(static_cast<unsigned char>(c))) {
        ++i;
        continue;
      }
      size_t end = i + 1;
      const bool number = std::isdigit(static_cast<unsigned char>(c)) ||
                          (c == '.' && end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])));
      if (number)
        while (end < text.size() && (isNameChar(text[end]) || text[end] == '.')) ++end;
      else if (isNameChar(c))
        while (end < text.size() && isNameChar(text[end])) ++end;
      tokens_.push_back({text.substr(i, end - i), i, !number && isNameChar(c), false});
      i = end;
    }
  }

  // Names that the text declares outside of all brackets: `float a = 1.0, b;`, functions and structs.
  void noteGlobals() {
    int depth = 0;
    for (size_t i = 0; i < tokens_.size(); ++i) {
      const char c = tokens_[i].text[0];
      if (c == '(' || c == '{' || c == '[') ++depth;
      if (c == ')' || c == '}' || c == ']') --depth;
      if (depth != 0 || i == 0 || !tokens_[i].isName) continue;
      const Token& before = tokens_[i - 1];
      if (before.isName || before.text == "," || before.text == "]") own_.insert(std::string(tokens_[i].text));
    }
  }

  bool isForeign(std::string_view name) const {
    if (isGlslWord(name)) return !isLaterWord(name);
    return name.starts_with("gl_") || (isGlslFunction(name) && !own_.count(std::string(name)));
  }

  void mark() {
    std::vector<bool> structs;  // of the open braces, which are those of a struct
    bool structNext = false;
    for (size_t i = 0; i < tokens_.size(); ++i) {
      Token& token = tokens_[i];
      if (token.text == "struct") structNext = true;
      if (token.text == "{") structs.push_back(std::exchange(structNext, false));
      if (token.text == "}" && !structs.empty()) structs.pop_back();
      if (token.text == ";") structNext = false;
      if (!token.isName || isForeign(token.text)) continue;
      const bool member = i > 0 && tokens_[i - 1].text == ".";
      const bool declaresMember = !structs.empty() && structs.back();
      if ((member || declaresMember) && isSwizzle(token.text)) continue;
      if (member && token.text == "length" && i + 1 < tokens_.size() && tokens_[i + 1].text == "(") continue;
      token.renamed = true;
    }
  }

  std::string written(const Token& token) const { return (token.renamed ? prefix_ : std::string()) + std::string(token.text); }

  std::string overloads() const {
    std::string made;
    const GlslScan scan = scanGlsl(plain_);
    std::set<std::string> done;
    for (const GlslFunction& function : scan.functions) {
      if (!isGlslFunction(function.name) || !done.insert(function.name).second) continue;
      for (const GlslSignature& form : glslSignatures(function.name)) {
        if (std::any_of(scan.functions.begin(), scan.functions.end(),
                        [&](const GlslFunction& f) { return f.name == function.name && f.takes(form.parameterTypes); }))
          continue;
        std::string parameters, arguments;
        for (size_t i = 0; i < form.parameterTypes.size(); ++i) {
          parameters += fmt::format("{}{} a{}", i ? ", " : "", form.parameterTypes[i], i);
          arguments += fmt::format("{}a{}", i ? ", " : "", i);
        }
        made += fmt::format("{} {}{}({}) {{ return {}({}); }} ", form.returnType, prefix_, function.name, parameters, function.name, arguments);
      }
    }
    return made;
  }

  // Of the statements outside of all braces those that start variables which may change.
  std::string initialisers() const {
    std::string made;
    size_t begin = 0;
    int depth = 0;
    for (size_t i = 0; i < tokens_.size(); ++i) {
      const char c = tokens_[i].text[0];
      if (c == '{') ++depth;
      if (c == '}') {
        --depth;
        if (depth == 0 && (i + 1 == tokens_.size() || tokens_[i + 1].text != ";")) begin = i + 1;
      }
      if (c != ';' || depth != 0) continue;
      addInitialisers(begin, i, made);
      begin = i + 1;
    }
    return made;
  }

  void addInitialisers(size_t begin, size_t end, std::string& made) const {
    for (size_t i = begin; i < end; ++i)
      if (tokens_[i].text == "const" || tokens_[i].text == "{") return;
    int depth = 0;
    std::string name;
    for (size_t i = begin; i < end; ++i) {
      const char c = tokens_[i].text[0];
      if (c == '(' || c == '[') ++depth;
      if (c == ')' || c == ']') --depth;
      if (depth != 0) continue;
      if (tokens_[i].isName) name = written(tokens_[i]);
      if (c != '=') continue;
      std::string value;
      int inner = 0;
      for (++i; i < end; ++i) {
        const char d = tokens_[i].text[0];
        if (d == '(' || d == '[') ++inner;
        if (d == ')' || d == ']') --inner;
        if (inner == 0 && d == ',') break;
        // Operators of two characters are two tokens: they stay together as they stand.
        const bool apart = !value.empty() && tokens_[i - 1].begin + tokens_[i - 1].text.size() != tokens_[i].begin;
        value += (apart ? " " : "") + written(tokens_[i]);
      }
      made += fmt::format("{} = {}; ", name, value);
    }
  }

  std::string prefix_, plain_;
  std::vector<Token> tokens_;
  std::set<std::string> own_;
};

}  // namespace

GlslNamespace inNamespace(std::string_view text, std::string_view prefix, const std::vector<std::string>& variables) {
  return Renamer(text, prefix).run(variables);
}

}  // namespace glint
