#include "machine/servo.hpp"

#include "machine/internal/joint_linkage.hpp"

namespace kerf::machine {
namespace {

std::unique_ptr<const motion::Linkage> make_linkage(const MachineDefinition& definition,
                                                    const kinematics::Kinematics& kinematics) {
  if (definition.kinematics.kind == kinematics::Kind::cartesian) return nullptr;
  return std::make_unique<JointLinkage>(kinematics, definition.start);
}

// Set-points between two questions whether to break off: some milliseconds.
constexpr std::uint64_t kBetweenQuestions = 1 << 16;

}  // namespace

Servo::Servo(const MachineDefinition& definition)
    : kinematics_(definition.make_kinematics()),
      linkage_(make_linkage(definition, *kinematics_)),
      axes_(definition.axes),
      interpolator_(axes_, definition.joint_limits(), definition.interpolator, linkage_.get()),
      joints_(definition.start) {}

Servo::~Servo() = default;

void Servo::take(const control::Motion& motion) {
  if (!interpolator_.room()) drain();
  interpolator_.take(motion);
}

void Servo::finish() {
  if (!interpolator_.room()) drain();
  interpolator_.finish();
  drain();
}

void Servo::drain() {
  if (sinks_.empty() || broken_off_) {
    interpolator_.skip();
    return;
  }
  motion::Setpoint point;
  while (interpolator_.next(point)) {
    hand_out(point);
    if (++points_ % kBetweenQuestions == 0 && broken_off_when_ && broken_off_when_()) {
      broken_off_ = true;
      interpolator_.skip();
      return;
    }
  }
}

void Servo::hand_out(const motion::Setpoint& point) {
  joints_ = linkage_ ? linkage_->joints(point.tip, joints_) : point.tip;
  for (AxisPointSink* const sink : sinks_) sink->take({point, joints_});
}

}  // namespace kerf::machine
