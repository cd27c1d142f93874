// Loops that end, whatever their conditions: a plugin's `while (true)` would hold up the device, and on some never
// give it back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glint {

// The same lines with the function `ends` asked at the start of each turn of every loop, with the line from 1 where the loop
// begins; when true the loop is broken off. Nothing when the text has no loop. The function must stay true once it was.
std::optional<std::string> withBoundedLoops(std::string_view text, std::string_view ends);

// The line, from 1, of the loop that lies within the most others, or of the first of them; nothing without a loop.
std::optional<int> lineOfDeepestLoop(std::string_view text);

}  // namespace glint
