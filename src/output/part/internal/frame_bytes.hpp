#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "output/solid/bytes.hpp"

namespace kerf::output {

// How the parts of frames are written: little endian, each padded to four bytes.

inline void put_signed(std::string& out, int value) {
  append_little_endian(out, static_cast<std::uint32_t>(value));
}
inline void put_double(std::string& out, double value) {
  append_little_endian(out, std::bit_cast<std::uint64_t>(value));
}
inline void put_half(std::string& out, int value) {
  append_little_endian(out, static_cast<std::uint16_t>(value));
}
inline void pad(std::string& out) { out.resize((out.size() + 3) / 4 * 4); }

}  // namespace kerf::output
