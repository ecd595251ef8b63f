#include "engraver/pattern_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"
#include "math/math.hpp"
#include "output/writing/drive_alarm.hpp"

namespace kerf::engraver {
namespace {

using base::JointPoint;
using base::TipPoint;
using drive::ArmAxis;
using motion::Curve;

constexpr double kStands = 1e-9;       // mm, degrees: less is rounding
constexpr int kTravelSamples = 64;     // of each leg: joints keep their turn from one to the next
constexpr double kHalfTurn_deg = 180;  // after which the wheel is the same

motion::Mark mark_of(const motion::Motion& motion) {
  motion::Mark mark;
  mark.block = motion.block;
  return mark;
}

// In [-90, 90): the wheel is the same after half a turn.
double half_turned(double angle_deg) {
  const double turned = std::fmod(angle_deg + kHalfTurn_deg / 2, kHalfTurn_deg);
  return (turned < 0 ? turned + kHalfTurn_deg : turned) - kHalfTurn_deg / 2;
}

template <typename T>
constexpr bool is_cut =
    std::is_same_v<T, motion::Line> || std::is_same_v<T, motion::Arc> ||
    std::is_same_v<T, motion::SpaceArc> || std::is_same_v<T, motion::SurfaceMove>;

}  // namespace

PatternMaker::PatternMaker(machine::BatchRun& machine, const machine::PatternMachine& motors,
                           drive::PatternWriter& writer)
    : machine_(machine),
      motors_(motors),
      writer_(writer),
      curves_(machine.definition().axes),
      sampler_(motors),
      gauge_(motors, motors.counts_at(machine.definition().start)),
      drive_(machine.definition().drive.arm, gauge_),
      tip_(machine.definition().axes.start),
      joints_(machine.definition().start) {
  drive_.set_counters(motors.counts_at(joints_));
  machine_.set_judge(*this);
}

void PatternMaker::take(const motion::Motion& motion) {
  if (failed_) return;
  motion_ = &motion;
  std::visit(
      [&](const auto& action) {
        using T = std::decay_t<decltype(action)>;
        if constexpr (std::is_same_v<T, motion::Rapid>) {
          travel(motion);
        } else if constexpr (is_cut<T>) {
          cut(motion);
        } else if constexpr (std::is_same_v<T, motion::Probe>) {
          raise(base::make_error(base::Code::pattern_motion, {},
                                 "a probing move: nothing tells the arm that it has touched"));
        } else if constexpr (std::is_same_v<T, motion::Thread>) {
          raise(base::make_error(base::Code::pattern_motion, {},
                                 "a thread: the arm has no spindle to follow"));
        } else if constexpr (std::is_same_v<T, motion::Dwell>) {
          ++report_.dwells;
        }
      },
      motion.action);
  if (const TipPoint* const to = motion::target_of(motion)) tip_ = *to;
  motion_ = nullptr;
}

void PatternMaker::finish() {
  if (!failed_) lower();
}

// Whether the arms have to move for the tip to get there.
bool PatternMaker::moves_arms(const TipPoint& to) const {
  return std::fabs(to[motors_.x()] - tip_[motors_.x()]) > kStands ||
         std::fabs(to[motors_.y()] - tip_[motors_.y()]) > kStands;
}

std::int64_t PatternMaker::z_pulses(double z_mm) const {
  return base::round_away(z_mm / motors_.step(ArmAxis::z));
}

// Of two counts of the lift, that which is up.
std::int64_t PatternMaker::higher(std::int64_t a, std::int64_t b) const {
  return motors_.step(ArmAxis::z) > 0 ? std::max(a, b) : std::min(a, b);
}

bool PatternMaker::is_above(std::int64_t a, std::int64_t b) const {
  return a != b && higher(a, b) == a;
}

// Where the wheel is clear of the work: the height of travel. A cut that is as high shows that the
// work is up there; then it is as far above the cut as that height is from 0.
std::int64_t PatternMaker::clear_z() const {
  const double travel_z_mm = machine_.definition().pattern.travel_z_mm;
  const std::int64_t now = counts()[ArmAxis::z];
  const std::int64_t travel = z_pulses(travel_z_mm);
  return on_work_ && !is_above(travel, now) ? now + z_pulses(std::fabs(travel_z_mm)) : travel;
}

// Lift up, upper arm, forearm; the wheel turns and comes down when it is known where it will cut.
void PatternMaker::travel(const motion::Motion& motion) {
  const TipPoint& to = *motion::target_of(motion);
  const std::int64_t z = z_pulses(to[motors_.z()]);
  if (!moves_arms(to)) return lift_due(z, Due::travel);
  JointPoint joints = joints_;
  for (const Curve& curve : curves_.of(tip_, motion)) {
    for (int i = 1; i <= kTravelSamples; ++i) {
      auto found =
          motors_.kinematics().follow(curve.at(curve.length() * i / kTravelSamples), joints);
      if (!found) return raise(found.error());
      joints = *found;
    }
  }
  if (const auto fault = motors_.kinematics().beyond_limits(joints)) return raise(*fault);
  const drive::ArmCounts there = motors_.counts_at(joints);
  lift_for_travel(z);
  if (failed_) return;
  fast(ArmAxis::theta2, there[ArmAxis::theta2]);
  fast(ArmAxis::theta1, there[ArmAxis::theta1]);
  joints_ = joints;
  lift_due(z, Due::travel);
}

// To the height of travel, or where the program has been or goes above it.
void PatternMaker::lift_for_travel(std::int64_t programmed_z) {
  if (due_ == Due::cut) lower();
  std::int64_t up = higher(clear_z(), programmed_z);
  if (due_ == Due::travel) up = higher(up, z_due_);
  lift_to(up);
}

// Up, away from the work. The program has not asked for this height: it may be one that the lift
// does not reach.
void PatternMaker::lift_to(std::int64_t z) {
  const std::int64_t now = counts()[ArmAxis::z];
  if (on_work_ && !is_above(z, now)) {
    return raise(base::make_error(
        base::Code::pattern_motion, {},
        "pattern.travel_z of 0 says no height above this cut at which the wheel is clear",
        "set pattern.travel_z above the work"));
  }
  const std::int64_t up = higher(z, now);
  const base::Axis lift = drive::axis_of(ArmAxis::z);
  const double up_mm = base::tidy(static_cast<double>(up) * motors_.step(ArmAxis::z));
  const machine::DrivenAxis& axis = machine_.definition().driven[index(lift)];
  if (up != now && up_mm > axis.travel_high) {
    return raise(base::make_error(
        base::Code::joint_limit, {},
        fmt::format("{} would be lifted to {} to be clear of the work, beyond its travel to {}",
                    axis.name, base::number_text(up_mm), base::number_text(axis.travel_high)),
        "set the work lower, or pattern.travel_z"));
  }
  fast(ArmAxis::z, up);
  on_work_ = false;
}

// A cut of the lift alone is made before the lift goes anywhere else, but not before one that goes
// on down: in the work the wheel could not turn to where the path goes on.
void PatternMaker::lift_due(std::int64_t z, Due why) {
  const bool plunges = due_ == Due::cut && is_above(counts()[ArmAxis::z], z_due_);
  const bool goes_on_down = plunges && why == Due::cut && is_above(z_due_, z);
  if (due_ == Due::cut && !goes_on_down) lower();
  z_due_ = z;
  due_ = why;
}

void PatternMaker::lower() {
  if (due_ == Due::nothing) return;
  on_work_ = due_ == Due::cut && is_above(counts()[ArmAxis::z], z_due_);
  fast(ArmAxis::z, z_due_);
  due_ = Due::nothing;
}

bool PatternMaker::refused(const Curve& curve) {
  const base::Axis z = motors_.z();
  if (curve.bounds(0, curve.length()).first[z] * curve.length() <= kStands) return false;
  raise(base::make_error(base::Code::pattern_motion, {},
                         fmt::format("Z goes from {} to {} while the wheel cuts along X and Y",
                                     base::number_text(base::tidy(tip_[z])),
                                     base::number_text(base::tidy(curve.end()[z]))),
                         "cut to the depth where the wheel stands, then along the path"));
  return true;
}

void PatternMaker::cut(const motion::Motion& motion) {
  const auto curves = curves_.of(tip_, motion);
  const bool on_the_spot = std::holds_alternative<motion::Line>(motion.action) &&
                           !moves_arms(*motion::target_of(motion));
  if (on_the_spot) return turn_on_the_spot(*motion::target_of(motion));
  for (const Curve& curve : curves) {
    if (refused(curve)) return;
  }
  for (const Curve& curve : curves) {
    cut_along(curve);
    if (failed_) return;
  }
}

void PatternMaker::turn_on_the_spot(const TipPoint& to) {
  const base::Axis z = motors_.z();
  if (std::fabs(to[z] - tip_[z]) > kStands) lift_due(z_pulses(to[z]), Due::cut);
  const bool turns = std::fabs(to[motors_.c()] - tip_[motors_.c()]) > kStands;
  if (!turns || machine_.definition().pattern.heading != machine::PatternSettings::Heading::program)
    return;
  lower();
  base::TipJet at;
  at.value = to;
  slow({base::round_away(heading_error_deg(at) / motors_.step(ArmAxis::theta3)), 0, 0});
}

// How far the wheel has to turn at a place of the path.
double PatternMaker::heading_error_deg(const base::TipJet& at) const {
  const bool tangent =
      machine_.definition().pattern.heading == machine::PatternSettings::Heading::tangent;
  const double wanted =
      tangent ? geometry::degrees(math::atan2(at.first[motors_.y()], at.first[motors_.x()]))
              : at.value[motors_.c()];
  JointPoint joints = joints_;
  const base::Axis wheel = drive::axis_of(ArmAxis::theta3);
  joints[wheel] = motors_.joints_at(counts())[wheel];
  return half_turned(wanted - motors_.kinematics().forward(joints)[motors_.c()]);
}

// The wheel comes onto the work, or turns at a corner. What is left of the error is less than the
// jump, and turned along the way.
void PatternMaker::begin_cut(double error_deg) {
  const std::int64_t turned =
      counts()[ArmAxis::theta3] + base::round_away(error_deg / motors_.step(ArmAxis::theta3));
  const bool jumps = turned != counts()[ArmAxis::theta3] &&
                     std::fabs(error_deg) > machine_.definition().pattern.tangent_jump_deg;
  if (due_ == Due::nothing && !jumps) return;
  if (due_ == Due::nothing) {
    lift_due(counts()[ArmAxis::z], Due::travel);
    ++report_.lifts;
  }
  if (jumps) lift_to(clear_z());
  fast(ArmAxis::theta3, turned);
  lower();
}

void PatternMaker::cut_along(const Curve& curve) {
  const base::TipJet start = curve.jet(0);
  begin_cut(heading_error_deg(start));
  if (failed_) return;
  on_work_ = true;
  if (watcher_ != nullptr) {
    watcher_->set_down(start.value[motors_.x()], start.value[motors_.y()],
                       motors_.tip_at(counts())[motors_.c()]);
  }
  gauge_.follow(&curve, 0);
  for (double s = 0; s < curve.length() && !failed_;) {
    if (!step_along(curve, s)) break;
  }
  gauge_.follow(nullptr, 0);
}

// False: an alarm was raised.
bool PatternMaker::step_along(const Curve& curve, double& s) {
  const double error_deg = heading_error_deg(curve.jet(s));
  const double wheel_step = motors_.step(ArmAxis::theta3);
  const std::int64_t turn = base::round_away(error_deg / wheel_step);
  const auto sample = sampler_.next(curve, s, joints_);
  if (!sample) {
    raise(sample.error());
    return false;
  }
  const double left_deg = std::fabs(error_deg - static_cast<double>(turn) * wheel_step);
  report_.heading_deg = std::max(report_.heading_deg, left_deg);
  const drive::ArmCounts there = motors_.counts_at(sample->joints);
  const drive::SlowMove move{turn, there[ArmAxis::theta1] - counts()[ArmAxis::theta1],
                             there[ArmAxis::theta2] - counts()[ArmAxis::theta2]};
  slow(move);
  if (failed_) return false;
  const auto most = std::max(std::abs(move.theta1), std::abs(move.theta2));
  note(*sample, curve, most > drive::kMostTripletPulses);
  joints_ = sample->joints;
  s = sample->s;
  const PathGauge::Worst worst = gauge_.take_worst();
  if (worst.mm > report_.measured.mm)
    report_.measured = {worst.mm, motion_->block.line, worst.x, worst.y};
  if (watcher_ != nullptr) tell_watcher(curve, s, worst);
  return true;
}

void PatternMaker::tell_watcher(const Curve& curve, double s, const PathGauge::Worst& worst) {
  const TipPoint at = curve.at(s);
  watcher_->step({at[motors_.x()], at[motors_.y()], worst.x - worst.path_x, worst.y - worst.path_y,
                  worst.mm, motors_.tip_at(counts())[motors_.c()], gauge_.places()});
}

// Ends are half a pulse off, and while pulses come one by one so is the counter. Where a step had
// to be cut into more triplets, their ends are off by up to a pulse more.
void PatternMaker::note(const CutSample& sample, const Curve& curve, bool split) {
  const double pulses_mm = (split ? 4 : 2) * sample.half_pulse_mm;
  const double mm = pulses_mm + sample.joints_mm + sample.chord_mm;
  if (mm <= report_.bound.mm) return;
  const TipPoint at = curve.at(sample.s);
  report_.bound = {mm, motion_->block.line, at[motors_.x()], at[motors_.y()]};
  report_.bound_pulses_mm = pulses_mm;
}

void PatternMaker::fast(ArmAxis axis, std::int64_t to) {
  each_record(drive::FastMove{axis, to - counts()[axis]},
              [this](const drive::FastRecord& record) { write(record); });
}

void PatternMaker::slow(const drive::SlowMove& move) {
  std::uint64_t triplets = 0;
  each_record(move, [&](const drive::Triplet& triplet) {
    write(triplet);
    ++triplets;
  });
  if (triplets > 1) ++report_.splits;
}

// Into the file and onto the motors, which may not be able to make it.
void PatternMaker::write(const drive::PatternRecord& record) {
  if (failed_) return;
  if (const auto* const travel = std::get_if<drive::FastRecord>(&record)) {
    drive_.fast(travel->move());
    ++report_.fast;
  } else {
    const drive::SlowMove move = std::get<drive::Triplet>(record).move();
    auto made = drive_.slow(move, motors_.half_period_ticks(counts(), move));
    if (!made) return raise(std::move(made.error()));
    ++report_.triplets;
  }
  writer_.write(record);
}

void PatternMaker::raise(base::Diagnostic alarm) {
  failed_ = true;
  machine_.refuse(output::at_mark(std::move(alarm), mark_of(*motion_), machine_.sources()));
}

void PatternMaker::raise(const kinematics::Fault& fault) {
  raise(base::make_error(kinematics::code_of(fault.kind), {}, fault.message));
}

PatternReport PatternMaker::report() const {
  PatternReport report = report_;
  report.counters = counts();
  report.time_s =
      static_cast<double>(machine_.definition().drive.arm.clock.nanoseconds(drive_.now_ticks())) *
      1e-9;
  return report;
}

}  // namespace kerf::engraver
