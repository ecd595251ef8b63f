#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "control/motion.hpp"
#include "kinematics/kinematics.hpp"
#include "machine/axis_point.hpp"
#include "machine/machine_definition.hpp"
#include "motion/interpolator.hpp"

namespace kerf::machine {

/// The servo side of a machine: plans the motions of a run in time and moves the driven axes.
///
/// Without sinks it only keeps the time, which is faster and the same.
class Servo : public control::MotionSink {
 public:
  explicit Servo(const MachineDefinition& definition);
  ~Servo() override;

  /// Precondition of the first motion: all sinks are there.
  void add_sink(AxisPointSink& sink) { sinks_.push_back(&sink); }
  /// Asked now and then while set-points are made; true: no more of them.
  void break_off_when(std::function<bool()> question) { broken_off_when_ = std::move(question); }

  void take(const control::Motion& motion) override;
  /// Makes everything that was taken; the axes are at rest then.
  void finish();

  [[nodiscard]] const kinematics::Kinematics& kinematics() const { return *kinematics_; }
  /// Since the start. The motions taken are made only after finish().
  [[nodiscard]] double time_s() const { return interpolator_.time_s(); }
  [[nodiscard]] bool broken_off() const { return broken_off_; }

 private:
  void drain();
  void hand_out(const motion::Setpoint& point);

  std::unique_ptr<const kinematics::Kinematics> kinematics_;
  std::unique_ptr<const motion::Linkage> linkage_;  // null: the driven axes are the program's
  control::AxisSetup axes_;
  motion::Interpolator interpolator_;
  std::vector<AxisPointSink*> sinks_;
  std::function<bool()> broken_off_when_;
  base::AxisVector joints_;
  std::uint64_t points_ = 0;
  bool broken_off_ = false;
};

}  // namespace kerf::machine
