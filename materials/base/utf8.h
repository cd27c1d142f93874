// Text from files: it may be any bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace glint {

// The next code point of UTF-8 text, at < text.size(); a malformed byte reads as U+FFFD and is one byte long.
char32_t nextCodePoint(std::string_view text, size_t& at);

// The same text as sound UTF-8 without NUL: each byte that is none of it becomes U+FFFD.
std::string validUtf8(std::string_view text);

// A name as one line that can be read back: valid, with control characters and backslashes spelt as "\n", "\\", "\x1b".
std::string onOneLine(std::string_view name);

}  // namespace glint
