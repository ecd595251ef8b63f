#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

namespace kerf::output {

/// Appends a number's bytes, the lowest first. Floats as IEEE 754.
template <class Number>
void append_little_endian(std::string& out, Number number) {
  static_assert(std::is_unsigned_v<Number> || std::is_same_v<Number, float>);
  if constexpr (std::is_same_v<Number, float>) {
    append_little_endian(out, std::bit_cast<std::uint32_t>(number));
  } else {
    const std::uint64_t bits = number;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      out += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i) & 0xffU));
  }
}

}  // namespace kerf::output
