#include "machine/run/servo.hpp"

#include <algorithm>
#include <cmath>

#include "machine/run/internal/joint_linkage.hpp"
#include "machine/run/internal/pattern_source.hpp"
#include "machine/run/internal/planning_thread.hpp"
#include "planner/interpolator.hpp"
#include "planner/path_sampler.hpp"

namespace kerf::machine {
namespace {

std::unique_ptr<const planner::Linkage> make_linkage(const MachineDefinition& definition,
                                                     const kinematics::Kinematics& kinematics) {
  if (definition.kinematics.kind == kinematics::Kind::cartesian) return nullptr;
  return std::make_unique<JointLinkage>(kinematics, definition.start);
}

std::unique_ptr<planner::SetpointSource> make_source(const MachineDefinition& definition,
                                                     const planner::Linkage* linkage) {
  if (definition.interpolator.sampling == planner::Sampling::planned) {
    return std::make_unique<planner::Interpolator>(definition.axes, definition.joint_limits(),
                                                   definition.interpolator, linkage);
  }
  return std::make_unique<planner::PathSampler>(definition.axes, definition.interpolator);
}

// Set-points between two questions whether to break off: some milliseconds.
constexpr std::uint64_t kBetweenQuestions = 1 << 14;

}  // namespace

Servo::Servo(const MachineDefinition& definition, PatternQueue* records)
    : kinematics_(definition.make_kinematics()),
      linkage_(make_linkage(definition, *kinematics_)),
      joints_(definition.start),
      commanded_(definition.axes.start) {
  last_.tip = before_.tip = definition.axes.start;
  for (const motion::AxisConfig& axis : definition.axes.axes) is_rotary_.push_back(axis.rotary);
  if (records == nullptr) {
    source_ = make_source(definition, linkage_.get());
    return;
  }
  counting_ = std::make_unique<const PatternMachine>(*PatternMachine::of(definition));
  auto pulses = std::make_unique<PatternSource>(*counting_, *records);
  pulses_ = pulses.get();
  source_ = std::move(pulses);
}

Servo::~Servo() = default;

void Servo::take(const motion::Motion& motion) {
  if (paced_) return take_paced(motion);
  if (plans_beside()) {
    beside_->take(motion);
    return note_target(motion);
  }
  if (!source_->room()) drain();
  feed(motion);
}

// Records of a pattern are queued by the control at the same time.
bool Servo::plans_beside() {
  if (!beside_ && !on_one_thread_ && sinks_.empty() && pulses_ == nullptr)
    beside_ = std::make_unique<PlanningThread>(*source_);
  return beside_ != nullptr;
}

void Servo::settle() const {
  if (beside_) beside_->settle();
}

double Servo::time_s() const {
  if (broken_off_) return last_.time_s;
  settle();
  return source_->time_s();
}

void Servo::take_paced(const motion::Motion& motion) {
  is_finished_ = is_asked_to_finish_ = false;
  if (has_room()) {
    feed(motion);
  } else {
    waiting_.push_back(motion);
    if (const base::TipPoint* const to = motion::target_of(motion)) waiting_end_ = *to;
  }
}

void Servo::feed(const motion::Motion& motion) {
  source_->take(motion);
  note_target(motion);
}

void Servo::note_target(const motion::Motion& motion) {
  if (const base::TipPoint* const to = motion::target_of(motion)) commanded_ = *to;
}

void Servo::finish() {
  if (paced_) {
    is_asked_to_finish_ = true;
    return;
  }
  settle();
  if (!source_->room()) drain();
  source_->finish();
  drain();
}

void Servo::resume() {
  if (!broken_off_) return;
  broken_off_ = false;
  settle();
  start(commanded_);
}

// Whether the source, emptied, can be asked again: it has been filled, or nothing follows.
bool Servo::goes_on() {
  while (!waiting_.empty() && source_->room()) {
    feed(waiting_.front());
    waiting_.pop_front();
  }
  if (waiting_.empty()) waiting_end_.reset();
  if (!waiting_.empty() || !source_->room()) return true;
  if (!is_asked_to_finish_ || is_finished_) return false;
  source_->finish();
  is_finished_ = true;
  return true;
}

// The next point of the source. Who wants to rest and stands may need no more motions. False: there
// is none, and nothing to make one of.
bool Servo::fetch() {
  const bool may_rest = source_->wants_hold() && source_->standing();
  if (is_emptied_ && !may_rest && !goes_on()) return false;
  motion::Setpoint point;
  const bool made = source_->next(point);
  if (made) next_ = point;
  if (source_->held()) return made;
  is_emptied_ = !made && !goes_on();
  return !is_emptied_;
}

Servo::Pace Servo::make_until(double until_s, std::uint64_t most_points) {
  while (!broken_off_) {
    if (next_ && (next_->time_s > until_s || points_ >= most_points)) return Pace::reached;
    if (next_) {
      const motion::Setpoint point = *next_;
      next_.reset();
      ++points_;
      hand_out(point);
    } else if (source_->at_reset()) {
      return Pace::at_rest;
    } else if (!fetch()) {
      if (source_->held()) return Pace::reached;
      return is_finished_ ? Pace::at_rest : Pace::wants_motions;
    }
  }
  return Pace::at_rest;
}

void Servo::drop_waiting() {
  waiting_.clear();
  waiting_end_.reset();
  source_->resume();
  commanded_ = source_->tip();
  is_emptied_ = is_finished_ = true;
  is_asked_to_finish_ = false;
}

void Servo::lock(bool on) {
  if (on == locked()) return;
  if (on) {
    locked_ = motion::AxisPoint{last_, joints_, 0};
  } else {
    locked_.reset();
  }
}

double Servo::speed() const {
  const double dt_s = last_.time_s - before_.time_s;
  if (!(dt_s > 0)) return 0;
  double linear = 0;
  double rotary = 0;
  for (std::size_t i = 0; i < is_rotary_.size(); ++i) {
    const double way = last_.tip.values[i] - before_.tip.values[i];
    (is_rotary_[i] ? rotary : linear) += way * way;
  }
  return std::sqrt(linear > 0 ? linear : rotary) / dt_s;
}

void Servo::tell_sinks() {
  started_ = true;
  for (motion::AxisPointSink* const sink : sinks_) sink->start(stands_at());
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

// Of the last point of the source.
base::JointPoint Servo::joints_at(const base::TipPoint& tip) const {
  if (pulses_ != nullptr) return pulses_->joints();
  return linkage_ ? linkage_->joints(tip, joints_) : base::JointPoint(tip.numbers());
}

void Servo::start(const base::TipPoint& tip) {
  started_ = true;
  last_ = {source_->time_s(), tip, {}};
  joints_ = joints_at(tip);
  for (motion::AxisPointSink* const sink : sinks_) sink->start({last_, joints_, 0});
}

void Servo::hand_out(const motion::Setpoint& point) {
  if (!started_) start(last_.tip);
  joints_ = joints_at(point.tip);
  before_ = last_;
  last_ = point;
  motion::AxisPoint seen{point, joints_, power_percent()};
  if (locked_) seen = {{point.time_s, locked_->tip.tip, point.mark}, locked_->joints, 0};
  for (motion::AxisPointSink* const sink : sinks_) sink->take(seen);
}

// What rounding leaves of a constant speed is no change of the power. A dwell has no feed.
float Servo::power_percent() const {
  constexpr double kSteps = 100;  // of a percent
  const motion::Mark& mark = last_.mark;
  if (!mark.power_follows_speed && power_override_ == 1) return mark.power_percent;
  double factor = power_override_;
  if (mark.power_follows_speed) {
    if (mark.kind == motion::MoveKind::dwell) return 0;
    if (mark.speed > 0) factor *= speed() / static_cast<double>(mark.speed);
  }
  const double percent = std::min(100.0, static_cast<double>(mark.power_percent) * factor);
  return static_cast<float>(std::round(percent * kSteps) / kSteps);
}

}  // namespace kerf::machine
