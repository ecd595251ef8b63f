#include "machine/dialect/signals.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/refusal.hpp"

namespace kerf::machine {
namespace {

constexpr double kSecondsPerDay = 86400;

tl::unexpected<base::Failure> unusable(std::uint32_t variable, base::Refusal why) {
  return tl::unexpected(base::refuse(why, {std::to_string(variable)}));
}

}  // namespace

std::optional<base::Outcome<void>> Signals::set(std::uint32_t variable, double value) {
  if (variable >= 1000 && variable <= 1035) return set_input(variable, value);
  if (variable == 3011) return set_date(value);
  if (variable == 3012) return set_time(value);
  return std::nullopt;
}

// #1000 to #1015 are bits, #1032 is all of them, #1033 to #1035 are words of 32 bits.
base::Outcome<void> Signals::set_input(std::uint32_t variable, double value) {
  if (variable > 1015 && variable < 1032) return unusable(variable, base::Refusal::no_such_input);
  if (variable < 1016) {
    const std::uint32_t bit = 1U << (variable - 1000);
    inputs_[0] = value != 0 ? inputs_[0] | bit : inputs_[0] & ~bit;
    return {};
  }
  const double rounded = std::round(value);
  if (rounded < -2147483648.0 || rounded > 4294967295.0)
    return unusable(variable, base::Refusal::word_range);
  const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(rounded));
  inputs_[variable - 1032] = variable == 1032 ? bits & 0xffffU : bits;
  return {};
}

base::Outcome<void> Signals::set_date(double value) {
  constexpr double kMostDate = 99991231;
  const auto date = static_cast<int>(std::clamp(value, 0.0, kMostDate));
  const std::chrono::year_month_day day{std::chrono::year{date / 10000},
                                        std::chrono::month{static_cast<unsigned>(date / 100 % 100)},
                                        std::chrono::day{static_cast<unsigned>(date % 100)}};
  if (!day.ok() || date != value) return unusable(3011, base::Refusal::date_form);
  start_day_ = day;
  return {};
}

base::Outcome<void> Signals::set_time(double value) {
  constexpr double kMostTime = 235959;
  const auto time = static_cast<int>(std::clamp(value, 0.0, kMostTime));
  if (time != value || time / 100 % 100 > 59 || time % 100 > 59)
    return unusable(3012, base::Refusal::time_form);
  start_second_ = time / 10000 * 3600 + time / 100 % 100 * 60 + time % 100;
  return {};
}

double Signals::date(double seconds) const {
  const double total = start_second_ + seconds;
  const std::chrono::year_month_day day{
      start_day_ + std::chrono::days{static_cast<int>(total / kSecondsPerDay)}};
  return static_cast<int>(day.year()) * 10000.0 + static_cast<unsigned>(day.month()) * 100.0 +
         static_cast<unsigned>(day.day());
}

double Signals::time_of_day(double seconds) const {
  const double second = std::fmod(std::floor(start_second_ + seconds), kSecondsPerDay);
  return std::floor(second / 3600) * 10000 + std::floor(std::fmod(second, 3600) / 60) * 100 +
         std::fmod(second, 60);
}

}  // namespace kerf::machine
