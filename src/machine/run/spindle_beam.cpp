#include "machine/run/spindle_beam.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "base/program_name.hpp"

namespace kerf::machine {
namespace {

using namespace motion;

enum class Beam { off, on, stays };

// What becomes of the beam of a turning spindle with a motion.
Beam beam_in(const Motion& motion) {
  return std::visit(
      [](const auto& action) {
        using Action = std::decay_t<decltype(action)>;
        if constexpr (std::is_same_v<Action, Line> || std::is_same_v<Action, Arc> ||
                      std::is_same_v<Action, SpaceArc> || std::is_same_v<Action, SurfaceMove>) {
          return Beam::on;
        } else if constexpr (std::is_same_v<Action, Rapid> || std::is_same_v<Action, Probe> ||
                             std::is_same_v<Action, Stop> || std::is_same_v<Action, End>) {
          return Beam::off;
        } else {
          return Beam::stays;
        }
      },
      motion.action);
}

base::Diagnostic warning_at(base::Code code, const Motion& motion, const std::string& detail) {
  base::Diagnostic warning = base::make_error(code, base::place_of(motion.block), detail);
  warning.program = base::program_name(static_cast<std::uint32_t>(motion.block.program));
  warning.block = motion.block;
  warning.severity = base::Severity::warning;
  return warning;
}

}  // namespace

std::span<const Motion> SpindleBeam::translated(const Motion& motion) {
  if (!laser_.fitted()) return {&motion, 1};
  count_ = 0;
  if (const auto* const spindle = std::get_if<Spindle>(&motion.action)) {
    turn(motion, *spindle);
    return {motions_.data(), count_};
  }
  if (const auto* const power = std::get_if<Power>(&motion.action)) {
    put(motion, as_of_machine(*power));
    return {motions_.data(), count_};
  }
  const Beam beam = beam_in(motion);
  if (turns_ && beam != Beam::stays) light(motion, beam == Beam::on);
  if (turns_ && std::holds_alternative<Dwell>(motion.action)) rest(motion);
  turns_ = turns_ && !std::holds_alternative<End>(motion.action);
  put(motion, motion.action);
  return {motions_.data(), count_};
}

Power SpindleBeam::as_of_machine(Power power) const {
  if (power.frequency_hz == laser_.pwm_frequency_hz) power.frequency_hz = 0;
  return power;
}

void SpindleBeam::reset() { turns_ = lit_ = false; }

void SpindleBeam::turn(const Motion& motion, const Spindle& spindle) {
  turns_ = spindle.turns();
  if (spindle.cuts_standing) return light(motion, turns_);
  if (!turns_) return light(motion, false);
  power_ = {.percent = percent_of(motion, spindle.speed),
            .follows_speed = spindle.turning == Spindle::Turning::counterclockwise};
  if (lit_) put(motion, power_);
}

void SpindleBeam::light(const Motion& motion, bool on) {
  if (lit_ == on) return;
  lit_ = on;
  put(motion, on ? power_ : Power{0});
}

double SpindleBeam::percent_of(const Motion& motion, double s) {
  const double percent = base::tidy(s / laser_.s_of_full_power * 100);
  if (percent <= 100) return percent;
  if (!warning_) {
    warning_ = warning_at(base::Code::over_full_power, motion,
                          fmt::format("S{:.6g}, full power is S{:.6g}", s, laser_.s_of_full_power));
  }
  return 100;
}

// Of a beam that follows the speed nothing is left at rest.
void SpindleBeam::rest(const Motion& motion) {
  if (dwell_warning_ || !(power_.percent > 0) || (lit_ && !power_.follows_speed)) return;
  dwell_warning_ = warning_at(base::Code::beam_off_in_dwell, motion,
                              lit_ ? "the power of M04 follows the speed, and the tip rests"
                                   : "M03 is active, and the beam goes on with the first cut");
}

void SpindleBeam::put(const Motion& motion, const Motion::Action& action) {
  motions_[count_] = motion;
  motions_[count_++].action = action;
}

}  // namespace kerf::machine
