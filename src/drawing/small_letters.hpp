#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace kerf::drawing {

/// Of the letters A to Z; any other byte stays, whatever the locale.
[[nodiscard]] inline char small_letter(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

[[nodiscard]] inline std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), small_letter);
  return small;
}

}  // namespace kerf::drawing
