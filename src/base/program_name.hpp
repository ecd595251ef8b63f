#pragma once

#include <cstdint>
#include <string>

namespace kerf::base {

/// What every output calls a program that has neither an O number nor a name, whatever its
/// language.
inline constexpr const char* kUnnumberedProgram = "O0000";

/// "O0001"; of 0 kUnnumberedProgram.
[[nodiscard]] inline std::string program_name(std::uint32_t number) {
  const std::string digits = std::to_string(number);
  return "O" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

}  // namespace kerf::base
