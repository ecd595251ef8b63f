#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>

namespace kerf::drive {

inline void append_integer(std::string& out, std::int64_t value) {
  std::array<char, 24> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), end);
}

}  // namespace kerf::drive
