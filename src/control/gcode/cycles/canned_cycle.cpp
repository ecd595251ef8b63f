#include "control/gcode/cycles/canned_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::Code;

constexpr std::int64_t kMostRepeats = 9999;

// NUM-8: dwell P counts milliseconds.
constexpr double kDwellUnits_per_s = 1000;

}  // namespace

void CannedCycle::cancel() {
  z_given_ = r_given_ = false;
  q_ = p_ = 0;
}

bool CannedCycle::begin(const Words& words, bool starts_mode, bool& moved) {
  if (!find_drilling_axis(starts_mode)) return false;
  const Axis z = drill_;
  if (state_.path.compensating()) {
    state_.assume(Assumed::cycle_in_compensation,
                  "cutter compensation is not applied in a canned cycle");
  }
  if (starts_mode) initial_ = state_.coordinates.program()[z];
  if (!read_data(words)) return false;
  std::int64_t repeats = 1;
  if (!read_counts(words, repeats)) return false;
  const bool makes_hole = words.has_any(targets_.letters() | Words::mask('R'));
  if (!makes_hole) return true;
  Target target;
  if (!check(words) || !targets_.read(words, target)) return false;
  moved = true;
  if (repeats == 0) return true;
  if (tapping()) state_.path.fix_override();
  target.program[z] = state_.coordinates.program()[z];
  moves_.apply_length(base::only(z));
  increment_ = state_.modal.incremental() ? target.program - state_.coordinates.program()
                                          : base::AxisVector{};
  hole_ = target.program;
  holes_left_ = repeats;
  first_ = true;
  stage_ = Stage::position;
  cycle_ = state_.modal[Group::cycle];
  to_initial_ = state_.modal[Group::cycle_return] == Meaning::return_to_initial ||
                cycle_ == Meaning::back_bore;
  return true;
}

// CYC-18: the normal of the plane of the block that starts the cycle, or always Z.
bool CannedCycle::find_drilling_axis(bool starts_mode) {
  std::optional<Axis> axis = state_.axes.find('Z');
  if (state_.parameters.drill_along_normal) {
    const auto plane = motion::plane_axes(state_.modal.plane(), state_.axes);
    axis = plane ? plane->normal : std::nullopt;
  }
  if (!axis) return state_.alarms.raise(Code::drilling_axis, "the machine lacks the drilling axis");
  if (!starts_mode && *axis != drill_) {
    return state_.alarms.raise(Code::drilling_axis, "the plane has changed since the cycle began");
  }
  drill_ = *axis;
  return true;
}

bool CannedCycle::read_data(const Words& words) {
  if (!read_depths(words)) return false;
  if (words.has('Q')) {
    if (!state_.values.length(words['Q'], q_)) return false;
    q_ = std::fabs(q_);
  }
  if (words.has('P')) {
    std::int64_t milliseconds = 0;
    if (!state_.values.integer(words['P'], 0, 99999999, milliseconds)) return false;
    p_ = static_cast<double>(milliseconds) / kDwellUnits_per_s;
  }
  return true;
}

// G90: levels as written; G91: R from the initial level, Z from R. Fixed when programmed.
bool CannedCycle::read_depths(const Words& words) {
  const bool incremental = state_.modal.incremental();
  double value = 0;
  if (words.has('R')) {
    if (!state_.values.length(words['R'], value)) return false;
    r_ = incremental ? base::tidy(initial_ + value) : value;
    r_given_ = true;
  }
  const char letter = state_.axes[drill_].letter;
  if (words.has(letter)) {
    if (!targets_.value(words[letter], drill_, value)) return false;
    if (!r_given_) r_ = initial_;
    z_ = incremental ? base::tidy(r_ + value) : value;
    z_given_ = true;
  }
  return true;
}

bool CannedCycle::read_counts(const Words& words, std::int64_t& repeats) {
  if (words.has('L') && !state_.values.integer(words['L'], 0, kMostRepeats, repeats)) return false;
  return !words.has('K') || state_.values.integer(words['K'], 0, kMostRepeats, repeats);
}

bool CannedCycle::check(const Words& words) {
  const Meaning cycle = state_.modal[Group::cycle];
  if ((cycle == Meaning::peck_chip_break || cycle == Meaning::peck) && q_ <= 0) {
    return words.has('Q') ? state_.alarms.raise(Code::peck_missing, words['Q'].text)
                          : state_.alarms.raise(Code::peck_missing);
  }
  if (tapping() && state_.rigid_tapping) {
    if (state_.words.speed <= 0) return state_.alarms.raise(Code::tap_speed);
    if (state_.words.feed <= 0) return state_.alarms.raise(Code::tap_feed);
    if (state_.moved_since_m29) return state_.alarms.raise(Code::tap_axis_move);
    state_.moved_since_m29 = false;
  }
  if (!r_given_) r_ = initial_;
  if (!z_given_) z_ = r_;
  feed_ = moves_.feed();
  return moves_.has_feed(words);
}

bool CannedCycle::step() {
  const Axis z = drill_;
  if (stage_ == Stage::position) {
    if (!first_) hole_ = state_.coordinates.program() + increment_;
    if (!first_) {
      for (double& value : hole_.values) value = base::tidy(value);
    }
    hole_[z] = state_.coordinates.program()[z];
    first_ = false;
    if (!position()) return false;
    depth_ = r_;
    stage_ = Stage::hole;
    return true;
  }
  switch (cycle_) {
    case Meaning::peck_chip_break:
    case Meaning::peck: return peck();
    case Meaning::tap_left:
    case Meaning::tap_right: return tap();
    case Meaning::back_bore: return back_bore();
    default: return bore();
  }
}

// Over the hole, then down to R; G87 orients and shifts before it goes down beside the bore.
bool CannedCycle::position() {
  if (!moves_.position(hole_)) return false;
  if (cycle_ != Meaning::back_bore) return rapid_z(r_);
  spindle(motion::Spindle::Turning::oriented);
  return shift(-q_) && rapid_z(r_) && shift(q_);
}

bool CannedCycle::finish_hole() {
  if (state_.rigid_tapping) state_.moved_since_m29 = false;
  --holes_left_;
  stage_ = Stage::position;
  return true;
}

bool CannedCycle::rapid_z(double z) {
  base::ProgramPoint target = state_.coordinates.program();
  target[drill_] = z;
  return moves_.rapid_to(target);
}

bool CannedCycle::feed_z(double z) {
  base::ProgramPoint target = state_.coordinates.program();
  target[drill_] = z;
  return moves_.line_to(target, feed_);
}

// G76, G87: away from the wall, along the axis and direction of parameter 5148.
bool CannedCycle::shift(double distance) {
  const int direction = state_.parameters.shift_direction;
  const auto axis = state_.axes.find(direction == 2 || direction == -2 ? 'Y' : 'X');
  if (!axis)
    return state_.alarms.raise(Code::drilling_axis, "the machine lacks the axis of the shift");
  base::ProgramPoint target = state_.coordinates.program();
  distance /= state_.coordinates.transform().factor(*axis);  // scaling leaves it alone
  target[*axis] = base::tidy(target[*axis] + (direction < 0 ? -distance : distance));
  return moves_.rapid_to(target);
}

bool CannedCycle::tapping() const {
  const Meaning cycle = state_.modal[Group::cycle];
  return cycle == Meaning::tap_left || cycle == Meaning::tap_right;
}

void CannedCycle::dwell() {
  if (p_ > 0) state_.path.act(motion::Dwell{p_});
}

void CannedCycle::spindle(motion::Spindle::Turning turning) {
  state_.path.act(motion::Spindle{.turning = turning, .speed = state_.words.speed});
  state_.words.turning = turning;
}

// CYC-1, -2, -6, -7, -9, -10, -11: one feed to the bottom and a way out.
bool CannedCycle::bore() {
  if (!feed_z(z_)) return false;
  bool out = true;
  switch (cycle_) {
    case Meaning::counterbore:
      dwell();
      out = rapid_z(return_level());
      break;
    case Meaning::bore: out = feed_z(r_) && rapid_z(return_level()); break;
    case Meaning::bore_spindle_stop:
      spindle(motion::Spindle::Turning::stopped);
      out = rapid_z(return_level());
      spindle(motion::Spindle::Turning::clockwise);
      break;
    case Meaning::bore_by_hand:
      dwell();
      spindle(motion::Spindle::Turning::stopped);
      state_.path.act(motion::Stop{false});
      out = rapid_z(return_level());
      spindle(motion::Spindle::Turning::clockwise);
      break;
    case Meaning::bore_dwell:
      dwell();
      out = feed_z(r_) && rapid_z(return_level());
      break;
    case Meaning::fine_bore:
      dwell();
      spindle(motion::Spindle::Turning::oriented);
      out = shift(q_) && rapid_z(return_level()) && shift(-q_);
      spindle(motion::Spindle::Turning::clockwise);
      break;
    default: out = rapid_z(return_level()); break;
  }
  return out && finish_hole();
}

// CYC-3, CYC-4: one peck. The last one ends exactly at Z.
bool CannedCycle::peck() {
  const double sign = z_ < r_ ? -1 : 1;
  const bool chip_break = cycle_ == Meaning::peck_chip_break;
  // Scaling leaves the peck and its clearance alone, and only them.
  const double factor = state_.coordinates.transform().factor(drill_);
  const double clearance =
      (chip_break ? state_.parameters.d_g73 : state_.parameters.d_g83) / factor;
  if (depth_ != r_) {
    const double restart = base::tidy(depth_ - sign * clearance);
    if (!chip_break && !rapid_z(r_)) return false;
    if (!rapid_z(restart)) return false;
  }
  double next = base::tidy(depth_ + sign * q_ / factor);
  if (sign * (next - z_) >= 0) next = z_;
  if (!feed_z(next)) return false;
  depth_ = next;
  if (depth_ != z_) return true;
  return rapid_z(return_level()) && finish_hole();
}

// CYC-5: G84 in clockwise and out counterclockwise, G74 the other way.
bool CannedCycle::tap() {
  const bool right = cycle_ == Meaning::tap_right;
  const auto in =
      right ? motion::Spindle::Turning::clockwise : motion::Spindle::Turning::counterclockwise;
  const auto out =
      right ? motion::Spindle::Turning::counterclockwise : motion::Spindle::Turning::clockwise;
  if (!feed_z(z_)) return false;
  dwell();
  spindle(out);
  if (!feed_z(r_)) return false;
  dwell();
  spindle(in);
  return rapid_z(return_level()) && finish_hole();
}

// CYC-8: from below upwards.
bool CannedCycle::back_bore() {
  spindle(motion::Spindle::Turning::clockwise);
  if (!feed_z(z_)) return false;
  dwell();
  spindle(motion::Spindle::Turning::oriented);
  if (!shift(-q_) || !rapid_z(initial_) || !shift(q_)) return false;
  spindle(motion::Spindle::Turning::clockwise);
  return finish_hole();
}

}  // namespace kerf::control
