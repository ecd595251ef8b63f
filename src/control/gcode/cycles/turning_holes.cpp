#include "control/gcode/cycles/turning_holes.hpp"

#include <cmath>
#include <utility>

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisSet;
using base::Code;
using gcode::Word;
using gcode::WordFlag;
using Turning = motion::Spindle::Turning;

constexpr std::int64_t kMostHoles = 9999;
constexpr double kDwellUnits_per_s = 1000;  // NUM-8

bool is_in_side(Meaning cycle) {
  return cycle == Meaning::drill_side || cycle == Meaning::tap_side || cycle == Meaning::bore_side;
}

Turning opposite(Turning turning) {
  return turning == Turning::counterclockwise ? Turning::clockwise : Turning::counterclockwise;
}

}  // namespace

bool TurningHoles::is_one(Meaning cycle) {
  return is_in_side(cycle) || cycle == Meaning::drill_face || cycle == Meaning::tap_face ||
         cycle == Meaning::bore_face;
}

bool TurningHoles::is_tapping() const {
  return cycle_ == Meaning::tap_face || cycle_ == Meaning::tap_side;
}

// System A has no codes for it.
double TurningHoles::return_level() const {
  return state_.modal[Group::cycle_return] == Meaning::return_to_r ? level_r_ : initial_;
}

bool TurningHoles::begin(const Words& words, bool starts_mode, bool& moved) {
  cycle_ = state_.modal[Group::cycle];
  state_.choose_driven_tool();
  if (!find_axis(starts_mode) || !read_data(words)) return false;
  std::int64_t holes = 1;
  if (words.has('K') && !state_.values.integer(words['K'], 0, kMostHoles, holes)) return false;
  if (!words.has_any(targets_.letters() | Words::mask('R'))) return true;
  Target target;
  if (!check(words) || !targets_.read(words, target)) return false;
  moved = true;
  find_clamp(words);
  if (is_tapping()) state_.path.fix_override();
  const base::ProgramPoint& from = state_.coordinates.program();
  target.program[drill_] = from[drill_];
  moves_.apply_length(static_cast<AxisSet>(target.named | base::only(drill_)));
  const AxisSet ways = targets_.ways(words);
  increment_ = target.program - from;
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (!base::contains(ways, axis) && !state_.modal.incremental()) increment_[axis] = 0;
  }
  if (std::exchange(counted_, cycle_) != cycle_) state_.count_cycle(cycle_);
  hole_ = target.program;
  holes_left_ = holes;
  stage_ = Stage::position;
  return true;
}

// Data of holes in the face mean nothing in the side.
bool TurningHoles::find_axis(bool starts_mode) {
  const auto axis = state_.axes.find(is_in_side(cycle_) ? 'X' : 'Z');
  if (!axis) return state_.alarms.raise(Code::drilling_axis, "the machine lacks the drilling axis");
  if (starts_mode || *axis != drill_) {
    data_ = {};
    initial_ = state_.coordinates.program()[*axis];
  }
  drill_ = *axis;
  return true;
}

bool TurningHoles::read_data(const Words& words) {
  if (words.has('R') && !state_.values.length(words['R'], data_.r)) return false;
  if (const Word* const word = targets_.word_of(words, drill_)) {
    double value = 0;
    if (!targets_.value(*word, drill_, value)) return false;
    data_.bottom = value;
    data_.bottom_is_way = targets_.is_way(*word, drill_) || state_.modal.incremental();
  }
  if (words.has('Q') && !read_peck(words['Q'])) return false;
  if (!words.has('P')) return true;
  std::int64_t milliseconds = 0;
  if (!state_.values.integer(words['P'], 0, 99999999, milliseconds)) return false;
  data_.dwell_s = static_cast<double>(milliseconds) / kDwellUnits_per_s;
  return true;
}

// Least increments, whatever other words count without a point; mm or inch with one.
bool TurningHoles::read_peck(const Word& word) {
  const bool bare = word.has(WordFlag::literal) && !word.has(WordFlag::point);
  double value = 0;
  if (!bare) {
    if (!state_.values.length(word, value)) return false;
  } else {
    if (!state_.values.plain(word, value)) return false;
    value *= state_.modal.inch() ? 0.00254 : 0.001;
  }
  data_.peck = base::tidy(std::fabs(value));
  return true;
}

bool TurningHoles::check(const Words& words) {
  if (is_tapping() && state_.rigid_tapping) {
    if (state_.words.speed <= 0) return state_.alarms.raise(Code::tap_speed);
    if (state_.words.feed <= 0) return state_.alarms.raise(Code::tap_feed);
  }
  level_r_ = base::tidy(initial_ + data_.r);
  bottom_ = level_r_;
  if (data_.bottom)
    bottom_ = data_.bottom_is_way ? base::tidy(level_r_ + *data_.bottom) : *data_.bottom;
  feed_ = moves_.feed();
  return moves_.has_feed(words);
}

void TurningHoles::find_clamp(const Words& words) {
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    const auto function = state_.parameters.machine_codes.function_of(code_of(*m->word));
    const bool clamps = function.value_or(BuilderFunction::clamp) == BuilderFunction::clamp;
    if (m->row == nullptr && clamps) clamp_ = static_cast<std::uint32_t>(code_of(*m->word));
  }
}

bool TurningHoles::step() {
  if (stage_ == Stage::position) return position();
  switch (cycle_) {
    case Meaning::drill_face:
    case Meaning::drill_side: return peck();
    case Meaning::tap_face:
    case Meaning::tap_side: return tap();
    default: return cut();
  }
}

bool TurningHoles::position() {
  hole_[drill_] = state_.coordinates.program()[drill_];
  if (!moves_.rapid_to(hole_)) return false;
  if (clamp_) state_.path.act(motion::AuxiliaryCode{*clamp_});
  depth_ = level_r_;
  stage_ = Stage::hole;
  return rapid_to(level_r_);
}

bool TurningHoles::finish_hole() {
  if (!rapid_to(return_level())) return false;
  if (clamp_) state_.path.act(motion::AuxiliaryCode{*clamp_ + 1});
  for (std::size_t i = 0; i < base::kMaxAxes; ++i)
    hole_.values[i] = base::tidy(hole_.values[i] + increment_.values[i]);
  state_.cycles.add(1);
  --holes_left_;
  stage_ = Stage::position;
  return true;
}

bool TurningHoles::rapid_to(double level) {
  base::ProgramPoint target = state_.coordinates.program();
  target[drill_] = level;
  return moves_.rapid_to(target);
}

bool TurningHoles::feed_to(double level) {
  base::ProgramPoint target = state_.coordinates.program();
  target[drill_] = level;
  return moves_.line_to(target, feed_);
}

void TurningHoles::dwell() {
  if (data_.dwell_s > 0) state_.path.act(motion::Dwell{data_.dwell_s});
}

void TurningHoles::spindle(Turning turning) {
  state_.words.turning = turning;
  state_.path.act(state_.spindle());
}

// G85, G89
bool TurningHoles::cut() {
  if (!feed_to(bottom_)) return false;
  dwell();
  return feed_to(level_r_) && finish_hole();
}

// G83, G87: one peck; without Q all of the hole. The last one ends exactly at the bottom.
bool TurningHoles::peck() {
  const double sign = bottom_ < level_r_ ? -1 : 1;
  if (depth_ != level_r_) {
    const double restart = base::tidy(depth_ - sign * state_.parameters.d_g73);
    if (state_.parameters.peck_to_r && !rapid_to(level_r_)) return false;
    if (!rapid_to(restart)) return false;
  }
  double next = base::tidy(depth_ + sign * data_.peck);
  if (data_.peck == 0 || sign * (next - bottom_) >= 0) next = bottom_;
  if (!feed_to(next)) return false;
  depth_ = next;
  if (depth_ != bottom_) return true;
  dwell();
  return finish_hole();
}

// G84, G88: out with the spindle reversed.
bool TurningHoles::tap() {
  const Turning in =
      motion::Spindle::turns(state_.words.turning) ? state_.words.turning : Turning::clockwise;
  if (!feed_to(bottom_)) return false;
  dwell();
  spindle(opposite(in));
  if (!feed_to(level_r_)) return false;
  spindle(in);
  return finish_hole();
}

}  // namespace kerf::control
