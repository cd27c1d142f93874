#include "materials/glsl_loops.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace glint {
namespace {

bool isNameChar(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Copies the text and puts `if (ends(LINE)) break; else` before the statement of each loop: after a word `do`, and after the
// brackets that follow `for` and `while`, but for the `while` that ends a `do`.
class Bounder {
 public:
  Bounder(std::string_view text, std::string_view ends) : text_(text), ends_(ends) {}

  std::optional<std::string> run() {
    while (at_ < text_.size()) step();
    if (!found_) return std::nullopt;
    return std::move(out_);
  }
  // Where in the text the deepest loop begins; after run().
  size_t deepest() const { return deepestAt_; }

 private:
  void copyTo(size_t end) {
    end = std::min(end, text_.size());
    out_.append(text_, at_, end - at_);
    for (; at_ < end; ++at_) line_ += text_[at_] == '\n';
  }

  void step() {
    const char c = text_[at_];
    if (text_.substr(at_, 2) == "//") return copyTo(text_.find('\n', at_));
    if (text_.substr(at_, 2) == "/*") {
      const size_t end = text_.find("*/", at_ + 2);
      return copyTo(end == text_.npos ? end : end + 2);
    }
    if (std::isspace(static_cast<unsigned char>(c))) return copyTo(at_ + 1);
    size_t end = at_ + 1;
    if (isNameChar(c))
      while (end < text_.size() && isNameChar(text_[end])) ++end;
    const std::string_view word = text_.substr(at_, end - at_);
    wordAt_ = at_;
    copyTo(end);
    take(word);
    previous_ = word;
  }

  void take(std::string_view word) {
    if (word == "{") ++depth_;
    if (word == "}") --depth_;
    if (word == "do") {
      does_.push_back(depth_);
      begins(depth_);
      stop(line_);
    } else if (word == "while" && !does_.empty() && does_.back() == depth_ && (previous_ == "}" || previous_ == ";")) {
      does_.pop_back();  // of this `do`
    } else if (word == "for" || word == "while") {
      headers_.push_back({brackets_, line_});
      begins(depth_);
    } else if (word == "(") {
      ++brackets_;
    } else if (word == ")") {
      --brackets_;
      if (!headers_.empty() && headers_.back().brackets == brackets_) {
        stop(headers_.back().line);
        headers_.pop_back();
      }
    }
  }

  void begins(int depth) {
    if (depth <= deepest_) return;
    deepest_ = depth;
    deepestAt_ = wordAt_;
  }

  void stop(int line) {
    out_ += " if (" + std::string(ends_) + "(" + std::to_string(line) + ")) break; else ";
    found_ = true;
  }

  struct Header {
    int brackets, line;
  };
  std::string_view text_, ends_, previous_;
  std::string out_;
  size_t at_ = 0, wordAt_ = 0, deepestAt_ = 0;
  int deepest_ = -1;                 // how many braces were open before the loop at deepestAt_
  int depth_ = 0, brackets_ = 0, line_ = 1;
  std::vector<int> does_;            // how many braces were open before each
  std::vector<Header> headers_;      // how many brackets were, and where it begins
  bool found_ = false;
};

}  // namespace

std::optional<std::string> withBoundedLoops(std::string_view text, std::string_view ends) { return Bounder(text, ends).run(); }

std::optional<int> lineOfDeepestLoop(std::string_view text) {
  Bounder bounder(text, "");
  if (!bounder.run()) return std::nullopt;
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bounder.deepest()), '\n'));
}

}  // namespace glint
