#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "drive/arm_drive.hpp"
#include "drive/pattern/writer.hpp"
#include "engraver/internal/cut_sampler.hpp"
#include "engraver/internal/path_gauge.hpp"
#include "engraver/pattern_report.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/run/batch_run.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"

namespace kerf::engraver {

/// A place of a cut, for a picture.
struct PatternStep {
  double x = 0, y = 0;          ///< on the path, where the step ends
  double off_x = 0, off_y = 0;  ///< from the path to the wheel, at its worst place in the step
  double off_mm = 0;            ///< how far that is
  double heading_deg = 0;       ///< of the wheel
  std::span<const PathGauge::Place> wheel{};  ///< between the pulses of the step; of this call only
};

/// Receives what a picture shows of a pattern, in order.
class PatternWatcher {
 public:
  virtual ~PatternWatcher() = default;
  /// The wheel stands on the work here, after a travel or a turn in the air.
  virtual void set_down(double x, double y, double heading_deg) = 0;
  virtual void step(const PatternStep& step) = 0;
};

/// Turns the motions of a program into the pattern that cuts them (docs/pattern.md, "Programs").
///
/// Cuts become triplets, everything else fast records. It is the judge of its machine: what the
/// records cannot hold is refused with an alarm at its source line.
class PatternMaker : public motion::MotionSink {
 public:
  /// All must outlive the maker, which becomes the machine's judge. The motors stand where the
  /// machine is at power-on.
  PatternMaker(machine::BatchRun& machine, const machine::PatternMachine& motors,
               drive::PatternWriter& writer);

  void watch(PatternWatcher& watcher) { watcher_ = &watcher; }
  void take(const motion::Motion& motion) override;
  /// Behind the last motion: the lift goes where it is due.
  void finish();

  [[nodiscard]] PatternReport report() const;

 private:
  enum class Due : std::uint8_t { nothing, travel, cut };

  void travel(const motion::Motion& motion);
  void cut(const motion::Motion& motion);
  void cut_along(const motion::Curve& curve);
  bool step_along(const motion::Curve& curve, double& s);
  void turn_on_the_spot(const base::TipPoint& to);
  bool refused(const motion::Curve& curve);
  void lift_for_travel(std::int64_t programmed_z);
  void lift_to(std::int64_t z);
  void lift_due(std::int64_t z, Due why);
  void lower();
  void begin_cut(double error_deg);
  [[nodiscard]] bool moves_arms(const base::TipPoint& to) const;
  [[nodiscard]] double heading_error_deg(const base::TipJet& at) const;
  [[nodiscard]] std::int64_t z_pulses(double z_mm) const;
  [[nodiscard]] std::int64_t higher(std::int64_t a, std::int64_t b) const;
  [[nodiscard]] bool is_above(std::int64_t a, std::int64_t b) const;
  [[nodiscard]] std::int64_t clear_z() const;
  void note(const CutSample& sample, const motion::Curve& curve, bool split);
  void tell_watcher(const motion::Curve& curve, double s, const PathGauge::Worst& worst);

  void fast(drive::ArmAxis axis, std::int64_t to);
  void slow(const drive::SlowMove& move);
  void write(const drive::PatternRecord& record);
  void raise(base::Diagnostic alarm);
  void raise(const kinematics::Fault& fault);
  [[nodiscard]] const drive::ArmCounts& counts() const { return drive_.counters(); }

  machine::BatchRun& machine_;
  const machine::PatternMachine& motors_;
  drive::PatternWriter& writer_;
  PatternWatcher* watcher_ = nullptr;
  motion::MoveCurves curves_;
  CutSampler sampler_;
  PathGauge gauge_;
  drive::ArmDrive drive_;
  const motion::Motion* motion_ = nullptr;  // the present one
  base::TipPoint tip_;                      // where the programmed path is
  base::JointPoint joints_;  // of the path, not rounded; the wheel's is that of the counters
  Due due_ = Due::nothing;   // why the lift has still to go to z_due_
  std::int64_t z_due_ = 0;
  bool on_work_ = false;  // the lift stands where the wheel has cut
  bool failed_ = false;
  PatternReport report_;
};

}  // namespace kerf::engraver
