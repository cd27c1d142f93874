// Damage for parsers: deterministic, so that a failure comes back.
#pragma once

#include <random>
#include <string>

namespace glint::test {

// A copy of `bytes` with one to four faults: flipped bits, extreme bytes, changed digits, a cut, a doubled or
// dropped stretch.
inline std::string mutate(const std::string& bytes, std::mt19937& random) {
  const auto below = [&](size_t n) { return n == 0 ? size_t{0} : size_t(random()) % n; };
  std::string out = bytes;
  for (size_t faults = 1 + below(4); faults > 0 && !out.empty(); --faults) {
    const size_t at = below(out.size());
    switch (below(8)) {
      case 0: out[at] = char(out[at] ^ (1 << below(8))); break;
      case 1: out[at] = char(0xff); break;
      case 2: out[at] = 0; break;
      case 3: out[at] = char(random()); break;
      case 4: {  // a digit, where there is one near: numbers in text are what sizes and indices are made of
        const size_t digit = out.find_first_of("0123456789", at);
        if (digit != std::string::npos) out[digit] = "0123456789-"[below(11)];
        break;
      }
      case 5: out.resize(at); break;
      case 6: out.insert(at, out.substr(at, 1 + below(16))); break;
      case 7: out.erase(at, 1 + below(16)); break;
    }
  }
  return out;
}

}  // namespace glint::test
