#include "engraver/internal/cut_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace kerf::engraver {
namespace {

using base::JointPoint;
using drive::ArmAxis;

// One less than a field holds: each end of a step is rounded.
constexpr double kMostPulses = drive::kMostTripletPulses - 1;
constexpr double kRoom = 0.97;  // what a step aims at, of what it may do
constexpr double kLeastTurn_deg = 1;

}  // namespace

CutSampler::CutSampler(const machine::PatternMachine& machine)
    : machine_(machine),
      linear_(motion::linear_axes(machine.definition().axes)),
      most_turn_rad_(geometry::radians(
          std::max(kLeastTurn_deg, machine.definition().pattern.tangent_jump_deg / 2))) {}

double CutSampler::curvature(const motion::Curve& curve, double s, double end) const {
  return curve.is_line() ? 0 : curve.curvature_bound(s, end, curve.bounds(s, end), linear_);
}

kinematics::Result<CutSample> CutSampler::look(const motion::Curve& curve, double s, double end,
                                               const JointPoint& joints) const {
  auto found = machine_.kinematics().inverse(curve.at(end), joints);
  if (!found) return base::unexpected(std::move(found.error()));
  const double ds = end - s;
  return CutSample{end, *found,
                   std::max(machine_.half_pulse_mm(joints), machine_.half_pulse_mm(*found)),
                   machine_.kinematics().deviation_bound_mm(joints, *found),
                   ds * ds * curvature(curve, s, end) / 8};
}

// How many times as much as it may a step does of something; errors grow with its square.
double CutSampler::excess(const motion::Curve& curve, double s, const CutSample& sample,
                          const JointPoint& joints) const {
  const double room_mm =
      std::max(kLeast_mm, machine_.definition().pattern.tolerance_mm - 2 * sample.half_pulse_mm);
  double most = std::sqrt((sample.joints_mm + sample.chord_mm) / room_mm);
  for (const ArmAxis arm : {ArmAxis::theta1, ArmAxis::theta2}) {
    const base::Axis axis = drive::axis_of(arm);
    const double pulses = (sample.joints[axis] - joints[axis]) / machine_.step(arm);
    most = std::max(most, std::fabs(pulses) / kMostPulses);
  }
  const double turn_rad = (sample.s - s) * curvature(curve, s, sample.s);
  return std::max(most, turn_rad / most_turn_rad_);
}

kinematics::Result<CutSample> CutSampler::next(const motion::Curve& curve, double s,
                                               const JointPoint& joints) {
  const double rest = curve.length() - s;
  double ds = step_mm_;
  if (ds < rest && rest < 2 * ds) ds = rest / 2;  // no short last step
  for (;;) {
    const bool last = ds >= rest;
    auto sample = look(curve, s, last ? curve.length() : s + ds, joints);
    if (!sample) return sample;
    ds = std::min(ds, rest);
    const double f = excess(curve, s, *sample, joints);
    if (f <= 1 || ds <= kShortest_mm) {
      if (!last || f > kRoom / 2) step_mm_ = std::max(kShortest_mm, ds * std::min(2.0, kRoom / f));
      return sample;
    }
    ds = std::max(kShortest_mm, ds * std::max(0.1, kRoom / f));
  }
}

}  // namespace kerf::engraver
