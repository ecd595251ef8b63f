#include "drawing/font/internal/utf8.hpp"

#include <array>
#include <cstdint>

namespace kerf::drawing {
namespace {

/// Of a first byte: how many follow, and what it says itself.
struct FirstByte {
  std::size_t following = 0;
  std::uint32_t bits = 0;
};

FirstByte first_byte(unsigned char byte) {
  if (byte < 0x80) return {0, byte};
  if (byte >= 0xC2 && byte < 0xE0) return {1, byte & 0x1FU};
  if (byte >= 0xE0 && byte < 0xF0) return {2, byte & 0x0FU};
  if (byte >= 0xF0 && byte < 0xF5) return {3, byte & 0x07U};
  return {0, kNoCharacter};
}

}  // namespace

char32_t take_character(std::string_view text, std::size_t& at) {
  constexpr std::array<std::uint32_t, 4> kLeast{0, 0x80, 0x800, 0x10000};
  auto [following, bits] = first_byte(static_cast<unsigned char>(text[at++]));
  std::size_t next = at;
  for (std::size_t i = 0; i < following; ++i, ++next) {
    const unsigned char byte = next < text.size() ? static_cast<unsigned char>(text[next]) : 0;
    if ((byte & 0xC0U) != 0x80) return kNoCharacter;
    bits = bits << 6U | (byte & 0x3FU);
  }
  const bool is_surrogate = bits >= 0xD800 && bits < 0xE000;
  if (bits < kLeast[following] || bits > 0x10FFFF || is_surrogate) return kNoCharacter;
  at = next;
  return bits;
}

std::string as_utf8(char32_t code) {
  const auto bits = static_cast<std::uint32_t>(code);
  const auto tail = [&](unsigned shift) {
    return static_cast<char>(0x80U | (bits >> shift & 0x3FU));
  };
  if (bits < 0x80) return {static_cast<char>(bits)};
  if (bits < 0x800) return {static_cast<char>(0xC0U | bits >> 6U), tail(0)};
  if (bits < 0x10000) return {static_cast<char>(0xE0U | bits >> 12U), tail(6), tail(0)};
  return {static_cast<char>(0xF0U | bits >> 18U), tail(12), tail(6), tail(0)};
}

}  // namespace kerf::drawing
