// Text and bytes inside HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace glint {

// Sound UTF-8 without what markup would take for its own or must not hold: usable between tags and in quoted attributes.
std::string escapedMarkup(std::string_view text);

std::string base64(std::string_view bytes);

}  // namespace glint
