#include "features/tree/key.hpp"

#include <cstdint>

#include "base/checksum.hpp"
#include "base/decimal.hpp"

namespace kerf::features {
namespace {

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
  const std::string key = base::hex_text(base::crc32(text));
  const int count = ++known_[key];
  return count == 1 ? key : key + "-" + std::to_string(count);
}

}  // namespace kerf::features
