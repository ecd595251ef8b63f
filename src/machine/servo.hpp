#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "control/motion.hpp"
#include "kinematics/kinematics.hpp"
#include "machine/axis_point.hpp"
#include "machine/machine_definition.hpp"
#include "motion/linkage.hpp"
#include "motion/setpoint_source.hpp"

namespace kerf::machine {

/// The servo side of a machine: puts the motions of a run into time, as the machine's interpolator
/// samples them, and moves the driven axes.
///
/// Without sinks it only keeps the time, which is faster and the same. Broken off, it makes no more
/// set-points and takes motions without making them: time and tip stay where they were.
class Servo : public control::MotionSink {
 public:
  explicit Servo(const MachineDefinition& definition);
  ~Servo() override;

  /// Precondition of the first motion: all sinks are there.
  void add_sink(AxisPointSink& sink) { sinks_.push_back(&sink); }
  /// Asked every few milliseconds of computing while set-points are made; true: breaks off.
  void break_off_when(std::function<bool()> question) { broken_off_when_ = std::move(question); }

  void take(const control::Motion& motion) override;
  /// Makes everything that was taken; the axes are at rest then.
  void finish();
  /// Also from inside a sink: the point under way is the last one.
  void break_off() { broken_off_ = true; }
  /// Goes on where the motions that were taken end. Precondition: finish() has been called.
  void resume();

  [[nodiscard]] const kinematics::Kinematics& kinematics() const { return *kinematics_; }
  /// Since the start. The motions taken are made only after finish().
  [[nodiscard]] double time_s() const { return broken_off_ ? last_.time_s : source_->time_s(); }
  [[nodiscard]] bool broken_off() const { return broken_off_; }
  /// The last set-point that was handed out.
  [[nodiscard]] const motion::Setpoint& last() const { return last_; }

 private:
  void drain();
  void make_points();
  void start(const base::AxisVector& tip);
  void hand_out(const motion::Setpoint& point);

  std::unique_ptr<const kinematics::Kinematics> kinematics_;
  std::unique_ptr<const motion::Linkage> linkage_;  // null: the driven axes are the program's
  std::unique_ptr<motion::SetpointSource> source_;
  std::vector<AxisPointSink*> sinks_;
  std::function<bool()> broken_off_when_;
  base::AxisVector joints_;
  base::AxisVector commanded_;  // where the last motion that was taken ends
  motion::Setpoint last_;
  std::uint64_t points_ = 0;
  bool started_ = false;  // the sinks know where the axes stood at first
  bool broken_off_ = false;
};

}  // namespace kerf::machine
