#include "machine/servo.hpp"

#include "machine/internal/joint_linkage.hpp"
#include "motion/interpolator.hpp"
#include "motion/path_sampler.hpp"

namespace kerf::machine {
namespace {

std::unique_ptr<const motion::Linkage> make_linkage(const MachineDefinition& definition,
                                                    const kinematics::Kinematics& kinematics) {
  if (definition.kinematics.kind == kinematics::Kind::cartesian) return nullptr;
  return std::make_unique<JointLinkage>(kinematics);
}

std::unique_ptr<motion::SetpointSource> make_source(const MachineDefinition& definition,
                                                    const motion::Linkage* linkage) {
  if (definition.interpolator.sampling == motion::Sampling::planned) {
    return std::make_unique<motion::Interpolator>(definition.axes, definition.joint_limits(),
                                                  definition.interpolator, linkage);
  }
  return std::make_unique<motion::PathSampler>(definition.axes, definition.interpolator);
}

// Set-points between two questions whether to break off: some milliseconds.
constexpr std::uint64_t kBetweenQuestions = 1 << 16;

}  // namespace

Servo::Servo(const MachineDefinition& definition)
    : kinematics_(definition.make_kinematics()),
      linkage_(make_linkage(definition, *kinematics_)),
      source_(make_source(definition, linkage_.get())) {}

Servo::~Servo() = default;

void Servo::take(const control::Motion& motion) {
  if (!source_->room()) drain();
  source_->take(motion);
}

void Servo::finish() {
  if (!source_->room()) drain();
  source_->finish();
  drain();
}

void Servo::drain() {
  if (sinks_.empty() || broken_off_) {
    source_->skip();
    return;
  }
  motion::Setpoint point;
  while (source_->next(point)) {
    hand_out(point);
    if (++points_ % kBetweenQuestions == 0 && broken_off_when_ && broken_off_when_()) {
      broken_off_ = true;
      source_->skip();
      return;
    }
  }
}

void Servo::hand_out(const motion::Setpoint& point) {
  joints_ = linkage_ ? linkage_->joints(point.tip, joints_) : point.tip;
  for (AxisPointSink* const sink : sinks_) sink->take({point, joints_});
}

}  // namespace kerf::machine
