#include "materials/glsl_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "materials/glsl_words.h"

namespace glint {
namespace {

// Compilers recurse over what these bound; hand-written models are far below.
constexpr size_t kMostStatementTokens = 4000, kMostElses = 500, kMostMacroTokens = 10'000;
constexpr int kDeepestBrackets = 100;
// What is computed for every pixel must be small: compilers keep arrays in registers, or try to.
constexpr long kLargestArray = 1024, kLargestArrayOfStructs = 32, kLongestLoop = 32768;

struct Token {
  std::string_view text;
  int line = 0;
  bool isName() const { return std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_'; }
};

bool isNameChar(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  GlslScan run() {
    while (at_ < text_.size()) step();
    if (!open_.empty())
      fault(open_.back().line, fmt::format("'{}' is never closed", open_.back().text), "close it, or take it out");
    for (const int line : conditions_) fault(line, "this condition has no #endif", "add #endif");
    checkMacros();
    return std::move(scan_);
  }

 private:
  void fault(int line, std::string what, std::string hint) {
    if (scan_.faults.size() < 50) scan_.faults.push_back({line, std::move(what), std::move(hint)});
  }

  void step() {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
      ++at_;
      lineHasToken_ = false;
    } else if (std::isspace(static_cast<unsigned char>(c))) {
      ++at_;
    } else if (c == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') {
      at_ += 2;
      ++line_;
    } else if (text_.substr(at_, 2) == "//") {
      lineComment();
    } else if (text_.substr(at_, 2) == "/*") {
      blockComment();
    } else if (c == '#' && !lineHasToken_) {
      directive();
    } else {
      token();
    }
  }

  void lineComment() {
    const size_t end = std::min(text_.find('\n', at_), text_.size());
    if (!lineHasToken_ && open_.empty() && statement_.empty()) {
      if (line_ != commentEnd_ + 1) comment_.clear();
      std::string_view words = text_.substr(at_ + 2, end - at_ - 2);
      if (words.starts_with(' ')) words.remove_prefix(1);
      comment_ += (comment_.empty() ? "" : "\n") + std::string(words);
      commentEnd_ = line_;
    }
    at_ = end;
    // A backslash carries the comment on to the next line.
    while (at_ < text_.size() && at_ > 0 && text_[at_ - 1] == '\\') {
      ++line_;
      at_ = std::min(text_.find('\n', at_ + 1), text_.size());
    }
  }

  void blockComment() {
    const size_t end = text_.find("*/", at_ + 2);
    if (end == text_.npos) {
      fault(line_, "the comment never ends", "close it with */");
      at_ = text_.size();
      return;
    }
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<long>(at_),
                                         text_.begin() + static_cast<long>(end), '\n'));
    at_ = end + 2;
  }

  // The whole logical line, with its comments taken out and continuations joined.
  std::string directiveText() {
    std::string words;
    while (at_ < text_.size() && text_[at_] != '\n') {
      if (text_.substr(at_, 2) == "//") {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        blockComment();
        words += ' ';
      } else if (text_[at_] == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') {
        at_ += 2;
        ++line_;
        words += ' ';
      } else {
        words += text_[at_++];
      }
    }
    return words;
  }

  static std::string takeName(const std::string& text, size_t& at) {
    while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
    const size_t begin = at;
    while (at < text.size() && isNameChar(text[at])) ++at;
    return text.substr(begin, at - begin);
  }

  void directive() {
    const int line = line_;
    ++at_;
    const std::string text = directiveText();
    if (text.find("##") != text.npos) fault(line, "## pastes words together", "GLSL has no such operator: write the whole word");
    size_t at = 0;
    const std::string word = takeName(text, at);
    if (word == "version" || word == "extension" || word == "include" || word == "line" || word == "pragma") {
      fault(line, fmt::format("#{} is not for a plugin", word), "Glint writes what comes around it");
    } else if (word == "if" || word == "ifdef" || word == "ifndef") {
      conditions_.push_back(line);
      if (word == "if" && takeName(text, at) == "0" && text.find_first_not_of(" \t\r", at) == text.npos) skipFalse();
    } else if (word == "endif") {
      if (conditions_.empty()) fault(line, "#endif without an #if", "remove one of them");
      else conditions_.pop_back();
    } else if (word == "undef") {
      const std::string macro = takeName(text, at);
      if (std::find(scan_.macros.begin(), scan_.macros.end(), macro) == scan_.macros.end())
        fault(line, fmt::format("'{}' is no macro of this file", macro), "#undef is for macros defined above");
    } else if (word == "define") {
      const std::string macro = takeName(text, at);
      if (at < text.size() && text[at] == '(') {
        fault(line, fmt::format("the macro '{}' has arguments", macro), "write a function");
        return;
      }
      if (isGlslWord(macro)) fault(line, fmt::format("'{}' is a word of GLSL", macro), "choose another name for the macro");
      // `#define N 8`
      const size_t begin = std::min(text.find_first_not_of(" \t", at), text.size());
      if (const auto value = wholeNumber(std::string_view(text).substr(begin, text.find_last_not_of(" \t\r") + 1 - begin))) constants_[macro] = *value;
      else constants_.erase(macro);
      scan_.macros.push_back(macro);
      scan_.names.push_back({macro, line});
      auto& uses = macroUses_[macro];
      while (at < text.size()) {
        const size_t before = at;
        std::string name = takeName(text, at);
        checkWord(name, line);
        if (!name.empty()) uses.push_back(std::move(name));
        else at = std::max(at, before) + 1;
      }
    }
  }

  // Past an `#if 0` up to its #else, #elif or #endif.
  void skipFalse() {
    int depth = 0;
    while (at_ < text_.size()) {
      at_ = std::min(text_.find('\n', at_), text_.size());
      if (at_ == text_.size()) return;
      ++at_;
      ++line_;
      size_t i = at_;
      while (i < text_.size() && (text_[i] == ' ' || text_[i] == '\t')) ++i;
      if (i >= text_.size() || text_[i] != '#') continue;
      const std::string words(text_.substr(i + 1, 40));
      size_t at = 0;
      const std::string word = takeName(words, at);
      if (word.starts_with("if")) ++depth;
      if (depth == 0 && (word == "else" || word == "elif" || word == "endif")) return;  // step() reads it
      if (word == "endif") --depth;
    }
  }

  void token() {
    lineHasToken_ = true;
    size_t end = at_ + 1;
    if (isNameChar(text_[at_]))
      while (end < text_.size() && isNameChar(text_[end])) ++end;
    const Token token{text_.substr(at_, end - at_), line_};
    at_ = end;
    countTokens(token);
    // After a dot it is a member's name.
    if (token.isName() && !(previous_ && previous_->text == ".")) checkWord(token.text, token.line);
    noteCalls(token);
    noteOperator(token);
    checkArray(token);
    checkLoop(token);
    checkDivision(token);
    beforePrevious_ = previous_;
    previous_ = token;
    const bool inBody = !open_.empty() && open_.front().text[0] == '{';
    const char c = token.text[0];
    if (c == '(' || c == '[' || c == '{') {
      if (c == '{' && open_.empty()) beginBody();
      if (open_.size() == kDeepestBrackets)
        fault(token.line, "brackets nest too deep", fmt::format("at most {}", kDeepestBrackets));
      open_.push_back(token);
      if (c != '{' && !inBody) statement_.push_back(token);
      return;
    }
    if (c == ')' || c == ']' || c == '}') {
      const char wanted = c == ')' ? '(' : c == ']' ? '[' : '{';
      if (open_.empty() || open_.back().text[0] != wanted) {
        fault(token.line, fmt::format("'{}' closes nothing", c), "remove it, or open what it closes");
        return;
      }
      open_.pop_back();
      if (c != '}' && !inBody) statement_.push_back(token);
      if (c == '}' && open_.empty()) {
        inFunction_ = false;
        if (!keepsStatement_) statement_.clear();
      }
      return;
    }
    if (inBody) return;
    if (c != ';') {
      statement_.push_back(token);
      return;
    }
    noteStatement();
    statement_.clear();
  }

  // By a zero that is written out, in brackets or not. Compilers may make anything of it: software ones leave 0, which looks
  // sound and is infinite elsewhere.
  void checkDivision(const Token& slash) {
    if (slash.text != "/") return;
    size_t at = at_, brackets = 0;
    const auto skip = [&](char wanted) {
      while (at < text_.size() && std::isspace(static_cast<unsigned char>(text_[at]))) ++at;
      if (at >= text_.size() || text_[at] != wanted) return false;
      ++at;
      return true;
    };
    skip('=');
    while (skip('(')) ++brackets;
    size_t end = at;
    while (end < text_.size() && (isNameChar(text_[end]) || text_[end] == '.')) ++end;
    const std::string_view number = text_.substr(at, end - at);
    if (brackets == 1 && isItselfTakenAway(at)) return fault(slash.line, "divides by 0", "what is in the brackets is taken from itself");
    if (number.find('0') == number.npos || number.find_first_not_of("0.fFuUlL") != number.npos) return;
    at = end;
    while (brackets > 0 && skip(')')) --brackets;
    if (brackets == 0) fault(slash.line, "divides by 0", "what that gives is undefined: 0 here, infinity elsewhere");
  }

  // Whether brackets that end after `at` hold "x - x".
  bool isItselfTakenAway(size_t at) const {
    std::string sides[2];
    int depth = 0, side = 0;
    for (; at < text_.size() && sides[0].size() < 200; ++at) {
      const char c = text_[at];
      if (std::isspace(static_cast<unsigned char>(c))) continue;
      if (depth == 0 && c == ')') return side == 1 && !sides[0].empty() && sides[0] == sides[1];
      if (c == '(' || c == '[') ++depth;
      if (c == ')' || c == ']') --depth;
      if (depth == 0 && c == '-' && !sides[0].empty() && side == 0) {
        side = 1;
        continue;
      }
      // Other operators have other rules.
      if (depth == 0 && std::string_view("+-,;{}?:<>=&|").find(c) != std::string_view::npos) return false;
      sides[side] += c;
    }
    return false;
  }

  void checkWord(std::string_view word, int line) {
    if (auto found = faultOfWord(word)) fault(line, std::move(found->what), std::move(found->hint));
  }

  // Called before `token` opens or closes anything.
  void noteCalls(const Token& token) {
    if (!inFunction_) return;
    if (previous_ && previous_->text == "." && token.isName()) {
      auto& members = scan_.functions.back().members;
      if (std::find(members.begin(), members.end(), token.text) == members.end()) members.emplace_back(token.text);
    }
    const char c = token.text[0];
    auto& calls = scan_.functions.back().calls;
    if (!openCalls_.empty() && c != ')') {
      GlslCall& inner = calls[openCalls_.back().call];
      if (inner.arguments == 0) inner.arguments = 1;
      if (c == ',' && open_.size() == openCalls_.back().depth) ++inner.arguments;
    }
    if (c == '(' && previous_ && previous_->isName()) {
      openCalls_.push_back({calls.size(), open_.size() + 1});
      calls.push_back({std::string(previous_->text), 0, previous_->line});
    } else if (c == ')' && !openCalls_.empty() && openCalls_.back().depth == open_.size()) {
      openCalls_.pop_back();
    }
  }

  // The value of a whole number, or of a constant that was one; nothing for all else.
  std::optional<long> wholeNumber(std::string_view word) const {
    if (const auto known = constants_.find(std::string(word)); known != constants_.end()) return known->second;
    long value = 0;
    size_t digits = 0;
    for (; digits < word.size() && std::isdigit(static_cast<unsigned char>(word[digits])); ++digits)
      value = std::min(value * 10 + (word[digits] - '0'), 1'000'000'000'000L);
    return digits == 0 || digits + 1 < word.size() ? std::nullopt : std::optional(value);
  }

  // `float a[3]`, `float[3](..)`, `Frame f[4]`: how many elements must be a plain number, and few.
  void checkArray(const Token& token) {
    if (array_) {
      if (token.text == "]") {
        const long size = array_->tokens == 1 ? wholeNumber(array_->last).value_or(-1) : -1;
        const long most = array_->ofStructs ? kLargestArrayOfStructs : kLargestArray;
        if (array_->tokens > 0 && size < 0)
          fault(token.line, "the size of an array is no plain number", "write it out, or as a const int of its own");
        else if (size > most)
          fault(token.line, fmt::format("an array of {}", size), fmt::format("at most {} are possible{}", most, array_->ofStructs ? " of a struct, or in one" : ""));
        array_.reset();
      } else {
        ++array_->tokens;
        array_->last = token.text;
      }
    } else if (token.text == "[" && previous_) {
      const bool ofType = isGlslWord(previous_->text);
      const bool declares = previous_->isName() && beforePrevious_ && (beforePrevious_->isName() || beforePrevious_->text == "]") &&
                            beforePrevious_->text != "return" && beforePrevious_->text != "else";
      const bool inStruct = !open_.empty() && keepsStatement_ && !inFunction_;
      if (ofType || declares) array_ = {0, {}, inStruct || (!ofType && beforePrevious_->isName() && !isGlslWord(beforePrevious_->text))};
    }
    // `const int N = 8;`
    if (previous_ && previous_->text == "=" && beforePrevious_ && beforePrevious_->isName())
      if (const auto value = wholeNumber(token.text)) constants_[std::string(beforePrevious_->text)] = *value;
  }

  void checkLoop(const Token& token) {
    if (token.text == "(" && previous_ && previous_->text == "for" && !loop_) loop_ = open_.size();
    else if (loop_ && token.text == ")" && open_.size() == *loop_ + 1) loop_.reset();
    else if (loop_)
      if (const auto value = wholeNumber(token.text); value && *value > kLongestLoop)
        fault(token.line, fmt::format("a loop of {}", *value), fmt::format("at most {} turns, for each pixel and light", kLongestLoop));
  }

  // Tokens are single characters: of `+=` and `<=` the second one counts for none.
  void noteOperator(const Token& token) {
    constexpr std::string_view kOperators = "+-*/%<>=&|^?!";
    const auto among = [](const Token& t, std::string_view set) { return set.find(t.text[0]) != set.npos; };
    if (!inFunction_ || !among(token, kOperators)) return;
    if (!(previous_ && among(*previous_, kOperators) && among(token, "=&|^<>"))) ++scan_.functions.back().operators;
  }

  void countTokens(const Token& token) {
    const char c = token.text[0];
    ++total_;
    if (token.text == "else" && ++elses_ == kMostElses + 1)
      fault(token.line, fmt::format("more than {} times else", kMostElses), "use a switch or a table");
    if (c == ';' || c == '{' || c == '}') run_ = 0;
    else if (++run_ == kMostStatementTokens + 1)
      fault(token.line, fmt::format("a statement of more than {} words", kMostStatementTokens), "split it");
    ++wordCounts_[std::string(token.text.substr(0, 64))];
  }

  // `type name ( ... )` at the end of the statement; gives the index of `name`, or npos.
  size_t functionName() const {
    if (statement_.size() < 4 || statement_.back().text != ")") return std::string::npos;
    for (size_t i = 2; i < statement_.size(); ++i)
      if (statement_[i].text == "(")
        return statement_[i - 1].isName() && statement_[i - 2].isName() ? i - 1 : std::string::npos;
    return std::string::npos;
  }

  void beginBody() {
    // After a struct or an initialiser the statement goes on to its semicolon.
    keepsStatement_ = statement_.empty() || statement_.back().text != ")";
    if (keepsStatement_) return;
    noteStatement();
    const size_t at = functionName();
    if (at == std::string::npos) return;
    GlslFunction function{.returnType = std::string(statement_[at - 1].text),
                          .name = std::string(statement_[at].text),
                          .parameterTypes = {},
                          .parameterNames = {},
                          .line = statement_[at].line,
                          .calls = {},
                          .members = {},
                          .comment = commentEnd_ + 1 == statement_[0].line ? comment_ : std::string()};
    // Of each parameter the last word that is followed by a word, which is its type.
    for (size_t i = at + 2; i + 1 < statement_.size(); ++i) {
      const size_t begin = i;
      while (i + 1 < statement_.size() && statement_[i].text != ",") ++i;
      std::string type, name;
      for (size_t j = begin; j < i; ++j)
        if (statement_[j].isName() && (j + 1 == i ? j == begin : statement_[j + 1].isName())) {
          type = statement_[j].text;
          name = j + 1 < i ? statement_[j + 1].text : "";
        }
      if (type.empty() || type == "void") continue;
      function.parameterTypes.push_back(type);
      function.parameterNames.push_back(name);
    }
    scan_.functions.push_back(std::move(function));
    inFunction_ = true;
    openCalls_.clear();
  }

  void noteStatement() {
    int brackets = 0;
    for (size_t i = 0; i < statement_.size(); ++i) {
      const Token& token = statement_[i];
      if (token.text == "(" || token.text == "[") ++brackets;
      if (token.text == ")" || token.text == "]") --brackets;
      if (brackets || !token.isName()) continue;
      static constexpr std::string_view kForbidden[] = {"uniform", "buffer", "shared", "layout",    "in",
                                                        "out",     "attribute", "varying", "subroutine"};
      if (std::find(std::begin(kForbidden), std::end(kForbidden), token.text) != std::end(kForbidden)) {
        fault(token.line, fmt::format("'{}' is not for a plugin", token.text),
              "declare a parameter: the host gives it its value");
        return;
      }
      if (i > 0 && statement_[i - 1].isName() &&
          (statement_[i - 1].text == "struct" || i + 1 == statement_.size() || !statement_[i + 1].isName())) {
        scan_.names.push_back({std::string(token.text), token.line});
        return;
      }
    }
  }

  // A macro of macros of macros grows as a power; what the text would grow to is bounded here.
  size_t grownSize(const std::string& name, int depth = 0) {
    const auto known = grown_.find(name);
    if (known != grown_.end()) return known->second;
    const auto found = macroUses_.find(name);
    if (found == macroUses_.end() || depth > 60) return depth > 60 ? kMostMacroTokens : 1;
    grown_[name] = 1;  // a macro within itself is left alone
    size_t size = 1;
    for (const std::string& use : found->second)
      size = std::min(size + grownSize(use, depth + 1), kMostMacroTokens * 100);
    return grown_[name] = size;
  }

  void checkMacros() {
    size_t size = total_;
    for (const auto& [name, uses] : macroUses_) {
      const auto count = wordCounts_.find(name.substr(0, 64));
      size += grownSize(name) * (count == wordCounts_.end() ? 0 : count->second);
      if (grownSize(name) > kMostMacroTokens || size > kMostMacroTokens * 100) {
        fault(1, fmt::format("the macro '{}' grows without measure", name), "write a function");
        return;
      }
    }
  }

  std::string_view text_;
  size_t at_ = 0;
  int line_ = 1;
  bool lineHasToken_ = false, keepsStatement_ = false, inFunction_ = false;
  std::optional<Token> previous_, beforePrevious_;
  struct OpenArray {
    int tokens = 0;
    std::string_view last;
    bool ofStructs = false;
  };
  std::optional<OpenArray> array_;
  std::optional<size_t> loop_;               // how many brackets were open before the header of a `for`
  std::map<std::string, long> constants_;    // names that were given a whole number
  struct OpenCall {
    size_t call, depth;  // its index in the function's calls; how many brackets are open inside it
  };
  std::vector<OpenCall> openCalls_;
  size_t run_ = 0, elses_ = 0, total_ = 0;
  std::string comment_;
  int commentEnd_ = -1;
  std::vector<Token> statement_, open_;
  std::vector<int> conditions_;
  std::map<std::string, std::vector<std::string>> macroUses_;
  std::map<std::string, size_t> wordCounts_, grown_;
  GlslScan scan_;
};

}  // namespace

GlslScan scanGlsl(std::string_view text) { return Scanner(text).run(); }

}  // namespace glint
