#include "control/gcode/macro/print_format.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::control {
namespace {

double power_of_ten(unsigned exponent) {
  double result = 1;
  for (; exponent > 0; --exponent) result *= 10;
  return result;
}

}  // namespace

void append_printed(std::string& out, double value, unsigned integers, unsigned decimals,
                    bool blanks) {
  const double scaled = std::round(std::fabs(value) * power_of_ten(decimals) + 1e-6);
  const double kept = std::fmod(scaled, power_of_ten(integers + decimals));
  std::string digits;
  auto rest = static_cast<std::uint64_t>(kept);
  for (unsigned i = 0; i < integers + decimals; ++i, rest /= 10)
    digits += static_cast<char>('0' + rest % 10);
  std::reverse(digits.begin(), digits.end());
  std::string whole = digits.substr(0, integers);
  const std::size_t leading =
      whole.empty() ? 0 : std::min(whole.find_first_not_of('0'), whole.size() - 1);
  const bool negative = value < 0 && scaled != 0;
  if (blanks) {
    std::fill_n(whole.begin(), leading, ' ');
    out += negative ? '-' : ' ';
  } else {
    whole.erase(0, leading);
    if (negative) out += '-';
  }
  out += whole;
  if (decimals > 0) out += '.' + digits.substr(integers);
}

void append_binary(std::string& out, double value, unsigned decimals) {
  const double scaled =
      std::clamp(std::round(value * power_of_ten(decimals)), -2147483648.0, 2147483647.0);
  const auto bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled));
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(bits >> shift & 0xffU);
}

}  // namespace kerf::control
