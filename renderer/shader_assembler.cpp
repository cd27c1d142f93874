#include "renderer/shader_assembler.h"

#include <set>
#include <string_view>

#include "materials/base/check.h"
#include "materials/model.h"
#include "shaders/shipped_files.h"

namespace glint {
namespace {

class Assembler {
 public:
  explicit Assembler(const ShaderText& text) : text_(text) {}

  std::string run() {
    append(text_.path);
    return out_;
  }

 private:
  // Source-string numbers count up in the order of inclusion and skip the one that marks a plugin's own lines.
  int nextSource() { return source_ == kModelSourceIndex ? (source_ += 2) - 1 : source_++; }

  void append(const std::string& path) {
    if (!seen_.insert(path).second) return;
    const auto file = shipped::read(path);
    GLINT_CHECK(file.has_value(), "{} is not among the shipped files", path);
    const int source = nextSource();
    std::string_view rest = *file;
    int line = 0;
    const auto lineDirective = [&] { out_ += fmt::format("#line {} {}\n", line + 1, source); };
    if (!out_.empty()) out_ += "#line 1 " + std::to_string(source) + "\n";
    while (!rest.empty()) {
      const size_t end = rest.find('\n');
      const std::string_view text = rest.substr(0, end);
      rest = end == rest.npos ? std::string_view() : rest.substr(end + 1);
      ++line;
      if (text.starts_with("#include \"")) {
        append(std::string(text.substr(10, text.find('"', 10) - 10)));
        lineDirective();
      } else if (text.starts_with("#pragma glint ")) {
        const auto insert = text_.inserts.find(std::string(text.substr(14)));
        GLINT_CHECK(insert != text_.inserts.end(), "{} wants {}", path, text);
        out_ += insert->second;
        out_ += '\n';
        lineDirective();
      } else {
        out_ += text;
        out_ += '\n';
        if (text.starts_with("#version")) {
          for (const std::string& define : text_.defines) out_ += "#define " + define + "\n";
          lineDirective();
        }
      }
    }
  }

  const ShaderText& text_;
  std::set<std::string> seen_;
  std::string out_;
  int source_ = 0;
};

}  // namespace

std::string assembleShader(const ShaderText& text) { return Assembler(text).run(); }

}  // namespace glint
