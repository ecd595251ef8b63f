#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "base/result.hpp"

namespace kerf::machine {

/// What reaches a control from around it besides its panel: input bits, and the calendar at
/// power-on. The calendar runs with the machine's simulated time: same input, same output.
class Signals {
 public:
  /// Sets an input bit (#1000 to #1035) or the calendar (#3011, #3012) by its variable. Failure
  /// (usage): there is no such input, or this is no date. Nothing: the variable is not one of
  /// these.
  [[nodiscard]] std::optional<base::Outcome<void>> set(std::uint32_t variable, double value);

  /// Bits #1000 to #1015 are word 0, #1033 to #1035 words 1 to 3.
  [[nodiscard]] std::uint32_t inputs(std::size_t word) const { return inputs_[word]; }
  [[nodiscard]] const std::array<std::uint32_t, 4>& inputs() const { return inputs_; }
  void set_inputs(const std::array<std::uint32_t, 4>& words) { inputs_ = words; }
  /// yyyymmdd and hhmmss, `seconds` after power-on.
  [[nodiscard]] double date(double seconds) const;
  [[nodiscard]] double time_of_day(double seconds) const;

 private:
  base::Outcome<void> set_input(std::uint32_t variable, double value);
  base::Outcome<void> set_date(double value);
  base::Outcome<void> set_time(double value);

  std::array<std::uint32_t, 4> inputs_{};
  std::chrono::sys_days start_day_ = std::chrono::year{2025} / 1 / 1;
  double start_second_ = 0;  // of the day
};

}  // namespace kerf::machine
