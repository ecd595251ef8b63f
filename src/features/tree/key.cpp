#include "features/tree/key.hpp"

#include <array>
#include <cstdint>

#include "base/decimal.hpp"

namespace kerf::features {
namespace {

std::uint32_t crc32(std::string_view text) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::string hex(std::uint32_t value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(8, '0');
  for (std::size_t i = 8; i-- > 0; value >>= 4U) text[i] = kDigits[value & 15U];
  return text;
}

// To 1e-6 mm first, so that noise does not decide; then half up.
std::int64_t micrometres(double mm) {
  const std::int64_t fine = base::round_away(mm * 1e6);
  const std::int64_t up = fine + 500;
  return up >= 0 ? up / 1000 : -((-up + 999) / 1000);
}

}  // namespace

std::string Keys::of(std::string_view zero, std::uint32_t tool, std::string_view kind,
                     geometry::Vec2 at, double bottom) {
  std::string text(zero);
  text += "|T";
  base::append_integer(text, tool);
  text += '|';
  text += kind;
  for (const double value : {at.u, at.v, bottom}) {
    text += '|';
    base::append_integer(text, micrometres(value));
  }
  const std::string key = hex(crc32(text));
  const int count = ++known_[key];
  return count == 1 ? key : key + "-" + std::to_string(count);
}

}  // namespace kerf::features
