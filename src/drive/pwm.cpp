#include "drive/pwm.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/decimal.hpp"

namespace kerf::drive {
namespace {

using base::number_text;

constexpr std::int64_t kMostCount = 65535;

bool is_divider(std::int64_t value) {
  return value == 2 || value == 4 || value == 8 || value == 16;
}

// The sentence that says what is wrong with the input.
std::optional<std::string> objection(const PwmTimer& timer, const PulseTrain& train) {
  if (!(timer.clock_hz > 0 && std::isfinite(timer.clock_hz))) {
    return "the clock runs at " + number_text(timer.clock_hz) + " Hz, it must be more than 0";
  }
  if (timer.prescaler < 0 || timer.prescaler > 255) {
    return "the prescaler is " + std::to_string(timer.prescaler) + ", it must be 0 to 255";
  }
  if (!is_divider(timer.divider)) {
    return "the divider is " + std::to_string(timer.divider) + ", it must be 2, 4, 8 or 16";
  }
  if (!(train.frequency_hz > 0 && std::isfinite(train.frequency_hz))) {
    return "the frequency is " + number_text(train.frequency_hz) + " Hz, it must be more than 0";
  }
  if (!(train.duty >= 0 && train.duty <= 1)) {
    return "the duty is " + number_text(train.duty) + ", it must be 0 to 1";
  }
  return std::nullopt;
}

base::unexpected<base::Diagnostic> out_of_range(const std::string& sentence) {
  return base::unexpected(base::make_error(base::Code::pwm_range, {}, sentence));
}

PwmRegisters::Beam beam_of(std::int64_t on, std::int64_t period) {
  if (on == 0) return PwmRegisters::Beam::off;
  return on == period ? PwmRegisters::Beam::on : PwmRegisters::Beam::pulsing;
}

}  // namespace

PulseTrain pulse_train(double on_s, double off_s) {
  return {1 / (on_s + off_s), on_s / (on_s + off_s)};
}

double pulse_pitch_mm(const PulseTrain& train, double feed_mm_s) {
  return feed_mm_s / train.frequency_hz;
}

double line_energy_j_mm(const PulseTrain& train, double power_w, double feed_mm_s) {
  return power_w * train.duty / feed_mm_s;
}

base::Result<PwmRegisters> pwm_registers(const PwmTimer& timer, const PulseTrain& train) {
  if (const auto wrong = objection(timer, train)) return out_of_range(*wrong);
  const std::int64_t hidden = timer.counting == PwmTimer::Counting::hidden_tick ? 1 : 0;
  const std::int64_t period = base::round_away(timer.tick_hz() / train.frequency_hz);
  if (period - hidden < 1 || period - hidden > kMostCount) {
    return out_of_range(number_text(train.frequency_hz) + " Hz from a timer of " +
                        number_text(timer.tick_hz()) + " Hz needs TCNTB " +
                        std::to_string(period - hidden) + ", it must be 1 to 65535");
  }
  const std::int64_t on = base::round_away(train.duty * static_cast<double>(period));
  const bool after = timer.output == PwmTimer::Output::active_after_match;
  const std::int64_t match = after ? on : period - on;
  return PwmRegisters{beam_of(on, period), period - hidden,
                      std::max<std::int64_t>(0, match - hidden),
                      timer.tick_hz() / static_cast<double>(period),
                      static_cast<double>(on) / static_cast<double>(period)};
}

}  // namespace kerf::drive
