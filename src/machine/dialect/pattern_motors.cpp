#include "machine/dialect/pattern_motors.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "math/math.hpp"
#include "motion/feed.hpp"

namespace kerf::machine {
namespace {

using base::AxisVector;
using base::TipPoint;

constexpr double kNanoseconds = 1e9;

template <typename Frame>
base::Point<Frame> tidied(base::Point<Frame> v) {
  for (double& value : v.values) value = base::tidy(value);
  return v;
}

}  // namespace

PatternStand stand_after(const PatternMachine& machine,
                         const std::array<double, drive::kArmAxes>& counts) {
  const base::JointPoint joints = tidied(machine.joints_at(counts));
  return {joints, tidied(machine.kinematics().forward(joints))};
}

PatternMotors::PatternMotors(const PatternMachine& machine, drive::PulseSink& pulses,
                             const drive::ArmCounts& from)
    : machine_(&machine),
      drive_(machine.definition().drive.arm, pulses),
      tip_(tidied(machine.tip_at(from))) {
  drive_.set_counters(from);
}

std::int64_t PatternMotors::nanoseconds(std::int64_t ticks) const {
  return machine_->definition().drive.arm.clock.nanoseconds(ticks);
}

double PatternMotors::time_s() const { return static_cast<double>(time_ns()) / kNanoseconds; }

base::Result<void> PatternMotors::make(const drive::PatternRecord& record) {
  const std::int64_t begin = drive_.now_ticks();
  auto made = std::visit([this](const auto& r) { return make_moves(r); }, record);
  if (!made) return made;
  if (!std::holds_alternative<drive::FastRecord>(record)) {
    cut_since(begin);
  } else if (arrive()) {
    motion_->action = motion::Rapid{tip_, false};
  }
  return {};
}

base::Result<void> PatternMotors::make_linked(const drive::ArmCounts& counts) {
  const std::int64_t begin = drive_.now_ticks();
  auto made = drive_.linked(counts);
  if (made) cut_since(begin);
  return made;
}

// False: nothing has moved. Else there is a motion, and its action is the caller's to say.
bool PatternMotors::arrive() {
  const TipPoint to = tidied(machine_->tip_at(drive_.counters()));
  motion_.reset();
  if (to == tip_) return false;
  tip_ = to;
  motion_.emplace();
  return true;
}

void PatternMotors::cut_since(std::int64_t begin) {
  const TipPoint from = tip_;
  if (!arrive()) return;
  const AxisVector way = tip_ - from;
  const double flat = math::hypot(way[machine_->x()], way[machine_->y()]);
  const double rise = way[machine_->z()];
  const double mm = rise == 0 ? flat : math::hypot(flat, rise);
  const double ns = static_cast<double>(nanoseconds(drive_.now_ticks() - begin));
  const double minutes = ns / kNanoseconds / motion::kSecondsPerMinute;
  const double length = mm > 0 ? mm : std::fabs(way[machine_->c()]);
  motion_->action = motion::Line{tip_, {length / minutes, motion::FeedMode::per_minute}};
}

base::Result<void> PatternMotors::make_moves(const drive::FastRecord& record) {
  drive_.fast(record.move());
  return {};
}

base::Result<void> PatternMotors::make_moves(const drive::Triplet& triplet) {
  const drive::SlowMove move = triplet.move();
  return drive_.slow(move, machine_->half_period_ticks(drive_.counters(), move));
}

double PatternMotors::joint_at(std::size_t joint) const {
  return machine_->joints_at(drive_.counters()).values[joint];
}

bool PatternMotors::is_beyond_travel(std::size_t joint) const {
  const DrivenAxis& axis = machine_->definition().driven[joint];
  const double at = joint_at(joint);
  return at < axis.travel_low || at > axis.travel_high;
}

std::string PatternMotors::words_beyond_travel(std::size_t joint) const {
  const DrivenAxis& axis = machine_->definition().driven[joint];
  return axis.name + " goes to " + base::number_text(base::tidy(joint_at(joint))) +
         ", beyond its travel of " + base::number_text(axis.travel_low) + " to " +
         base::number_text(axis.travel_high);
}

}  // namespace kerf::machine
