#include "machine/run/dotted_cut.hpp"

#include <fmt/format.h>

#include "base/program_name.hpp"

namespace kerf::machine {
namespace {

constexpr double kRounding = 1e-9;  // of a feed that was converted on the way

}  // namespace

void DottedCut::take(const motion::Motion& motion) {
  if (!laser_.fitted() || warning_) return;
  if (const auto* const power = std::get_if<motion::Power>(&motion.action)) {
    percent_ = power->beam_percent();
    frequency_hz_ = power->frequency_hz > 0 ? power->frequency_hz : laser_.pwm_frequency_hz;
  }
  if (!(percent_ > 0) || !(percent_ < 100)) return;
  std::visit(
      [&](const auto& action) {
        if constexpr (requires { action.feed.mode; }) look_at(motion, action.feed);
      },
      motion.action);
}

void DottedCut::look_at(const motion::Motion& motion, const motion::Feed& feed) {
  if (feed.mode != motion::FeedMode::per_minute) return;
  const double pitch_mm = feed.value / 60 / frequency_hz_;
  if (!(pitch_mm > laser_.spot_mm * (1 + kRounding))) return;
  warning_ = base::make_error(
      base::Code::dotted_cut, base::place_of(motion.block),
      fmt::format("{:.6g} Hz at {:.6g} mm/s: a pulse every {:.6g} mm, the spot has {:.6g} mm",
                  frequency_hz_, feed.value / 60, pitch_mm, laser_.spot_mm));
  warning_->program = base::program_name(static_cast<std::uint32_t>(motion.block.program));
  warning_->block = motion.block;
  warning_->severity = base::Severity::warning;
}

}  // namespace kerf::machine
