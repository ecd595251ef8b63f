#include "planner/section_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::planner {
namespace {

// Ages would not fit into the counter of periods.
std::uint64_t whole_periods(double periods) {
  constexpr double kMost = 1e17;
  return static_cast<std::uint64_t>(std::min(periods, kMost));
}

// What std::floor() is of x >= 0, without a call.
double whole_part(double x) {
  constexpr double kAllWhole = 0x1p52;
  return x < kAllWhole ? static_cast<double>(static_cast<std::int64_t>(x)) : x;
}

// A standstill this little behind a period belongs to it: rounding of the sums of durations.
constexpr double kSameTick = 1e-9;
// What is left of a dwell is one, shorter than any period.
constexpr double kShortestDwell_s = 1e-12;

}  // namespace

SectionDrive::SectionDrive(WayAhead& ahead, double period_s)
    : ahead_(ahead), period_s_(period_s), tip_(ahead.axes.start) {}

void SectionDrive::begin(const Section& section) {
  if (section.dwell_s == 0)
    profile_ = Profile(section.length, section.entry, section.exit, section.limits);
  begin_phases(section);
}

void SectionDrive::begin(const Section& section, const Profile& profile) {
  profile_ = profile;
  begin_phases(section);
}

void SectionDrive::begin_phases(const Section& section) {
  section_ = section;
  phase_ = 0;
  phase_way_ = 0;
  cell_way_ = -offset_;
  cells_left_ = section_.cells;
  driving_ = true;
  waiting_ = false;
  if (!ahead_.path.spindle_changes.empty()) turn_spindle();
  if (section_.dwell_s == 0) {
    standing_ = false;
  } else if (ahead_.path.pieces.front().waits_for_spindle()) {
    begin_wait();
  }
  if (ends_.is_wanted()) tell_ends();
}

// A wait lasts as long as the spindle takes.
void SectionDrive::tell_ends() {
  Section lasting = section_;
  const double begin_s = static_cast<double>(phase_tick_) * period_s_ + phase_late_s_;
  if (waiting_)
    lasting.dwell_s = static_cast<double>(wait_tick_) * period_s_ + wait_late_s_ - begin_s;
  ends_.tell(ahead_, lasting, offset_, profile_, begin_s);
}

// The changes that come before the section.
void SectionDrive::turn_spindle() {
  Ring<SpindleChange>& changes = ahead_.path.spindle_changes;
  while (!changes.empty() && changes.front().piece <= ahead_.path.pieces.begin()) {
    const motion::SpindleTurn& turn = changes.front().turn;
    motion::SpindleAngle& spindle = spindles_[index(turn.spindle)];
    if (turn.acceleration > 0) {
      spindle.ramp_to(turn.rpm, time_s(), turn.acceleration);
    } else {
      spindle.set_speed(turn.rpm, time_s());
    }
    changes.pop();
  }
}

void SectionDrive::begin_wait() {
  const PathPiece& piece = ahead_.path.pieces.front();
  const motion::SpindleAngle& spindle = spindles_[index(piece.spindle)];
  const double wait_s = piece.until_speed
                            ? spindle.seconds_to_speed(time_s())
                            : spindle.seconds_until(piece.mark_deg, time_s(), piece.mark_rpm);
  const double whole = whole_part(wait_s / period_s_);
  waiting_ = true;
  wait_tick_ = tick_ + whole_periods(whole);
  wait_late_s_ = std::max(0.0, wait_s - whole * period_s_);
}

// What follows begins when the mark passes, which is rarely at a period.
void SectionDrive::end_wait() {
  rest_at(wait_tick_);
  phase_late_s_ = wait_late_s_;
  end();
}

void SectionDrive::end() {
  for (; cells_left_ > 0; --cells_left_) ahead_.leave_cell();
  offset_ = section_.tail;
  driving_ = false;
}

void SectionDrive::leave_at(double offset) {
  offset_ = offset;
  driving_ = false;
  rest_at(tick_);
}

void SectionDrive::break_dwell() {
  const double done_s = static_cast<double>(tick_ - phase_tick_) * period_s_;
  ahead_.cells.front().dwell_s = std::max(section_.dwell_s - done_s, kShortestDwell_s);
  driving_ = false;
  standing_ = true;
}

void SectionDrive::end_phase(const Phase& phase) {
  phase_way_ += phase.way(phase.duration_s);
  phase_late_s_ += phase.duration_s;
  const double whole = whole_part(phase_late_s_ / period_s_);
  phase_tick_ += whole_periods(whole);
  phase_late_s_ = std::max(0.0, phase_late_s_ - whole * period_s_);
  ++phase_;
}

std::uint64_t SectionDrive::ticks_until(double time_s) const {
  return whole_periods(std::ceil(time_s / period_s_ - kSameTick));
}

// What follows begins at this period.
void SectionDrive::rest_at(std::uint64_t tick) {
  tick_ = phase_tick_ = tick;
  phase_late_s_ = 0;
}

void SectionDrive::advance_cell(double way) {
  while (cells_left_ > 0 && way > cell_way_ + ahead_.cells.front().length()) {
    if (cells_left_ == 1 && section_.tail == 0) return;  // the end belongs to the last one
    cell_way_ += ahead_.cells.front().length();
    ahead_.leave_cell();
    --cells_left_;
  }
}

void SectionDrive::fill(motion::Setpoint& point, double way) {
  advance_cell(way);
  const Cell& cell = ahead_.cells.front();
  const double at = std::min(cell.end, cell.begin + (way - cell_way_));
  tip_ = ahead_.path.pieces.front().curve.at(at);
  ahead_.leave_marks(at);
  if (!ahead_.path.marks.empty()) mark_ = ahead_.path.marks.front().mark;
  point = {time_s(), tip_, mark_};
}

void SectionDrive::fill_at_rest(motion::Setpoint& point) {
  ++tick_;
  ahead_.leave_marks(0);
  if (!ahead_.path.marks.empty()) mark_ = ahead_.path.marks.front().mark;
  point = {time_s(), tip_, mark_};
}

SectionDrive::Step SectionDrive::next_of_wait(motion::Setpoint& point) {
  if (tick_ < wait_tick_) {
    fill_at_rest(point);
    return Step::point;
  }
  end_wait();
  return Step::over;
}

SectionDrive::Step SectionDrive::next_of_dwell(motion::Setpoint& point) {
  if (waiting_) return next_of_wait(point);
  fill_at_rest(point);
  if (tick_ < phase_tick_ + ticks_until(section_.dwell_s)) return Step::point;
  rest_at(tick_);
  end();
  standing_ = true;
  return Step::at_rest;
}

// Where the tool is at the next period, from the begin of the section. False: not in it any more.
bool SectionDrive::find_place(double& way) {
  const auto phases = profile_.phases();
  for (; phase_ < phases.size(); end_phase(phases[phase_])) {
    const double t = static_cast<double>(tick_ + 1 - phase_tick_) * period_s_ - phase_late_s_;
    const bool last = section_.stop && phase_ + 1 == phases.size();
    const double slack_s = last ? kSameTick * period_s_ : 0;
    if (t >= phases[phase_].duration_s - slack_s) continue;
    way = phase_way_ + phases[phase_].way(t);
    return true;
  }
  return false;
}

SectionDrive::Step SectionDrive::next(motion::Setpoint& point) {
  if (section_.dwell_s > 0) return next_of_dwell(point);
  double way = 0;
  if (find_place(way)) {
    ++tick_;
    fill(point, way);
    return Step::point;
  }
  if (!section_.stop) {
    end();
    return Step::over;
  }
  rest_at(std::max(tick_ + 1, phase_tick_ + ticks_until(phase_late_s_)));
  constexpr double kToTheEnd = std::numeric_limits<double>::infinity();
  fill(point, section_.tail == 0 ? kToTheEnd : section_.length);
  end();
  standing_ = true;
  return Step::at_rest;
}

void SectionDrive::stand(motion::Setpoint& point) {
  rest_at(tick_ + 1);
  point = {time_s(), tip_, mark_};
}

void SectionDrive::skip() {
  if (waiting_) {
    end_wait();
    return ahead_.leave_marks(0);
  }
  if (section_.dwell_s > 0) {
    rest_at(phase_tick_ + ticks_until(section_.dwell_s));
  } else {
    while (phase_ < profile_.phases().size()) end_phase(profile_.phases()[phase_]);
    if (section_.stop) rest_at(phase_tick_ + ticks_until(phase_late_s_));
  }
  end();
  ahead_.leave_marks(0);
}

PathState SectionDrive::now() const {
  PathState state{ahead_.cells.begin(), offset_, 0, 0};
  if (!driving_ || phase_ >= profile_.phases().size()) return state;
  const Phase& phase = profile_.phases()[phase_];
  const double t = static_cast<double>(tick_ - phase_tick_) * period_s_ - phase_late_s_;
  state.offset = phase_way_ + phase.way(t) - cell_way_;
  state.speed = phase.velocity_at(t);
  state.acceleration = phase.acceleration_at(t);
  return state;
}

base::TipPoint SectionDrive::motion_end() const {
  const Path& path = ahead_.path;
  if (path.marks.empty()) return tip_;
  const PathMark& mark = path.marks[path.marks.begin()];
  const bool known = path.pieces.begin() <= mark.piece && mark.piece < path.pieces.end();
  return known ? path.pieces[mark.piece].curve.at(mark.way) : tip_;
}

}  // namespace kerf::planner
