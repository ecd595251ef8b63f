#include "drive/tick_clock.hpp"

#include <cassert>
#include <numeric>

#include "base/decimal.hpp"

namespace kerf::drive {

TickClock::TickClock(std::int64_t crystal_hz) : crystal_hz_(crystal_hz) {
  constexpr std::int64_t kTwelveSeconds = 12'000'000'000;
  assert(crystal_hz >= 1 && crystal_hz <= 500'000'000);
  const std::int64_t common = std::gcd(kTwelveSeconds, crystal_hz);
  ns_ = kTwelveSeconds / common;
  per_ = crystal_hz / common;
}

std::int64_t TickClock::ticks(double seconds) const {
  return base::round_away(seconds * static_cast<double>(crystal_hz_) / 12.0);
}

}  // namespace kerf::drive
