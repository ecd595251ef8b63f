#include "machine/servo.hpp"

#include "machine/internal/joint_linkage.hpp"
#include "motion/interpolator.hpp"
#include "motion/path_sampler.hpp"

namespace kerf::machine {
namespace {

std::unique_ptr<const motion::Linkage> make_linkage(const MachineDefinition& definition,
                                                    const kinematics::Kinematics& kinematics) {
  if (definition.kinematics.kind == kinematics::Kind::cartesian) return nullptr;
  return std::make_unique<JointLinkage>(kinematics, definition.start);
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
constexpr std::uint64_t kBetweenQuestions = 1 << 14;

}  // namespace

Servo::Servo(const MachineDefinition& definition)
    : kinematics_(definition.make_kinematics()),
      linkage_(make_linkage(definition, *kinematics_)),
      source_(make_source(definition, linkage_.get())),
      joints_(definition.start) {}

Servo::~Servo() = default;

void Servo::take(const control::Motion& motion) {
  if (!source_->room()) drain();
  source_->take(motion);
  if (const base::AxisVector* const to = control::target_of(motion)) commanded_ = *to;
}

void Servo::finish() {
  if (!source_->room()) drain();
  source_->finish();
  drain();
}

void Servo::resume() {
  if (!broken_off_) return;
  broken_off_ = false;
  start(commanded_);
}

void Servo::drain() {
  if (!sinks_.empty() && !broken_off_) make_points();
  if (sinks_.empty() || broken_off_) source_->skip();
}

void Servo::make_points() {
  if (!started_) start(source_->tip());
  motion::Setpoint point;
  while (!broken_off_ && source_->next(point)) {
    hand_out(point);
    if (++points_ % kBetweenQuestions == 0 && broken_off_when_ && broken_off_when_()) break_off();
  }
}

void Servo::start(const base::AxisVector& tip) {
  started_ = true;
  last_ = {source_->time_s(), tip, {}};
  joints_ = linkage_ ? linkage_->joints(last_.tip, joints_) : last_.tip;
  for (AxisPointSink* const sink : sinks_) sink->start({last_, joints_});
}

void Servo::hand_out(const motion::Setpoint& point) {
  joints_ = linkage_ ? linkage_->joints(point.tip, joints_) : point.tip;
  last_ = point;
  for (AxisPointSink* const sink : sinks_) sink->take({point, joints_});
}

}  // namespace kerf::machine
