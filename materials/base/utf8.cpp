#include "materials/base/utf8.h"

#include <fmt/format.h>

namespace glint {
namespace {
constexpr char32_t kReplacement = 0xfffd;
constexpr const char* kReplacementText = "\xef\xbf\xbd";
}  // namespace

char32_t nextCodePoint(std::string_view text, size_t& at) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at++);
  if (first < 0x80) return first;
  const size_t more = first >= 0xf0 && first < 0xf5 ? 3 : first >= 0xe0 && first < 0xf0 ? 2 : first >= 0xc2 && first < 0xe0 ? 1 : 0;
  if (more == 0) return kReplacement;
  char32_t code = first & (0x3fu >> more);
  for (size_t i = 0; i < more; ++i) {
    if (at + i >= text.size() || (byte(at + i) & 0xc0) != 0x80) return kReplacement;
    code = (code << 6) | (byte(at + i) & 0x3f);
  }
  // Longer than need be, half of a UTF-16 pair, or past the last.
  constexpr char32_t kFirst[] = {0, 0x80, 0x800, 0x10000};
  if (code < kFirst[more] || (code >= 0xd800 && code < 0xe000) || code > 0x10ffff) return kReplacement;
  at += more;
  return code;
}

std::string validUtf8(std::string_view text) {
  std::string valid;
  for (size_t at = 0; at < text.size();) {
    const size_t start = at;
    const char32_t code = nextCodePoint(text, at);
    if (code == 0 || (code == kReplacement && at == start + 1)) valid += kReplacementText;
    else valid += text.substr(start, at - start);
  }
  return valid;
}

std::string onOneLine(std::string_view name) {
  std::string line;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\\') line += "\\\\";
    else if (c == '\n') line += "\\n";
    else if (byte < 0x20 || byte == 0x7f) line += fmt::format("\\x{:02x}", byte);
    else line += c;
  }
  return validUtf8(line);
}

}  // namespace glint
