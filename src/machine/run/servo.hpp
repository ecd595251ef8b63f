#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "kinematics/kinematics.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/pattern_queue.hpp"
#include "motion/axis_point.hpp"
#include "motion/motion.hpp"
#include "planner/linkage.hpp"
#include "planner/setpoint_source.hpp"

namespace kerf::machine {

class PatternMachine;
class PatternSource;
class PlanningThread;

/// The servo side of a machine: puts the motions of a run into time, as the machine's interpolator
/// samples them, and moves the driven axes.
///
/// Without sinks it only keeps the time, which is faster and the same. Broken off, it makes no more
/// set-points and takes motions without making them: time and tip stay where they were.
///
/// Everything is called on one thread, sinks too. But a batch run without sinks plans on a second
/// thread, beside whoever commands the motions: nobody looks on there and nothing can break off, so
/// both make the same. Whoever asks for the time or finishes waits for it.
///
/// It works in one of two ways, which make the same points. In a batch run it takes every motion
/// and makes points whenever its source has no room for more. Paced, points are made by
/// make_until() only, up to a time, and motions wait where there is no room: has_room() tells the
/// control not to execute more blocks. The source is asked and fed in the same order: filled, then
/// emptied.
class Servo : public motion::MotionSink {
 public:
  /// The definition must outlive the servo where `records` is given: then the motions are those of
  /// these records, and their pulses say where the axes are.
  explicit Servo(const MachineDefinition& definition, PatternQueue* records = nullptr);
  ~Servo() override;

  /// Precondition of the first motion: all sinks are there.
  void add_sink(motion::AxisPointSink& sink) { sinks_.push_back(&sink); }
  /// Is told when motions end, perhaps on the second thread. Precondition: nothing was taken yet.
  void tell_ends(motion::MotionEndSink& sink) { source_->tell_ends(sink); }
  /// Without a second thread. Precondition: nothing was taken yet.
  void stay_on_one_thread() { on_one_thread_ = true; }
  /// Asked every few milliseconds of computing while set-points are made; true: breaks off.
  void break_off_when(std::function<bool()> question) { broken_off_when_ = std::move(question); }

  void take(const motion::Motion& motion) override;
  /// Makes everything that was taken; the axes are at rest then.
  void finish();
  /// Also from inside a sink: the point under way is the last one.
  void break_off() { broken_off_ = true; }
  /// Goes on where the motions that were taken end. Precondition: finish() has been called.
  void resume();

  // Paced

  /// From now on. Precondition: nothing was taken yet.
  void pace() { paced_ = true; }
  /// Nothing waits, and the source has room.
  [[nodiscard]] bool has_room() const { return waiting_.empty() && source_->room(); }
  /// Everything that was taken is made, and the axes rest.
  [[nodiscard]] bool at_rest() const { return is_emptied_ && is_finished_ && !next_; }
  /// The next point is made, and later than was asked for.
  [[nodiscard]] bool has_point() const { return next_.has_value(); }
  /// The axes stand, in a dwell or between motions; the point that waits does not move them.
  [[nodiscard]] bool standing() const { return source_->standing() && !moves_on(); }
  /// The feed is held, and the axes have come to rest.
  [[nodiscard]] bool held() const { return source_->held() && !moves_on(); }
  enum class Pace : std::uint8_t {
    reached,        ///< the time, or the number of points
    wants_motions,  ///< it goes on with more of them, or with finish()
    at_rest
  };
  /// Hands out the points up to a time, in all at most `most_points`.
  Pace make_until(double until_s, std::uint64_t most_points);
  /// The tip, and what the operator can ask for.
  [[nodiscard]] planner::SetpointSource& source() { return *source_; }
  [[nodiscard]] const planner::SetpointSource& source() const { return *source_; }
  /// Forgets motions that wait. Precondition: the source is at_reset(). The feed goes on.
  void drop_waiting();
  /// The sinks see the axes stand still; time and tip go on as the control has them.
  void lock(bool on);
  /// The dial of a laser's power: a factor of what the program asks for; full power is the end.
  void set_power_override(double factor) { power_override_ = factor; }
  [[nodiscard]] bool locked() const { return locked_.has_value(); }
  /// Where the axes stand: the tip and the driven ones.
  [[nodiscard]] motion::AxisPoint stands_at() const {
    return locked_ ? *locked_ : motion::AxisPoint{last_, joints_, 0};
  }
  [[nodiscard]] const base::JointPoint& joints() const { return joints_; }
  /// Of the tip over the last period, mm/s; degrees/s where only rotary axes turned.
  [[nodiscard]] double speed() const;
  /// Where the last motion ends that was taken.
  [[nodiscard]] const base::TipPoint& commanded() const {
    return waiting_end_ ? *waiting_end_ : commanded_;
  }
  /// Handed out so far.
  [[nodiscard]] std::uint64_t points() const { return points_; }
  /// Tells the sinks where the axes stand.
  void tell_sinks();

  [[nodiscard]] const kinematics::Kinematics& kinematics() const { return *kinematics_; }
  /// Since the start. The motions taken are made only after finish().
  [[nodiscard]] double time_s() const;
  [[nodiscard]] bool broken_off() const { return broken_off_; }
  /// The last set-point that was handed out.
  [[nodiscard]] const motion::Setpoint& last() const { return last_; }

 private:
  [[nodiscard]] bool moves_on() const { return next_ && next_->tip != last_.tip; }
  void take_paced(const motion::Motion& motion);
  [[nodiscard]] bool plans_beside();
  void settle() const;
  void feed(const motion::Motion& motion);
  void note_target(const motion::Motion& motion);
  [[nodiscard]] bool goes_on();
  [[nodiscard]] bool fetch();
  void drain();
  void make_points();
  [[nodiscard]] base::JointPoint joints_at(const base::TipPoint& tip) const;
  void start(const base::TipPoint& tip);
  void hand_out(const motion::Setpoint& point);
  [[nodiscard]] float power_percent() const;

  std::unique_ptr<const kinematics::Kinematics> kinematics_;
  std::unique_ptr<const planner::Linkage> linkage_;  // null: the driven axes are the program's
  std::unique_ptr<const PatternMachine> counting_;   // null: no pulses are counted
  std::unique_ptr<planner::SetpointSource> source_;
  const PatternSource* pulses_ = nullptr;  // source_, where pulses are counted
  std::vector<motion::AxisPointSink*> sinks_;
  std::function<bool()> broken_off_when_;
  base::JointPoint joints_;
  base::TipPoint commanded_;  // where the last motion that was taken ends
  motion::Setpoint last_;
  motion::Setpoint before_;  // the point before that
  std::vector<bool> is_rotary_;
  std::uint64_t points_ = 0;
  double power_override_ = 1;
  bool started_ = false;  // the sinks know where the axes stood at first
  bool broken_off_ = false;
  bool on_one_thread_ = false;

  // Paced.
  bool paced_ = false;
  std::deque<motion::Motion> waiting_;
  std::optional<base::TipPoint> waiting_end_;  // where the last one of them ends
  std::optional<motion::Setpoint> next_;       // made, and later than was asked for
  bool is_emptied_ = true;                     // the source has made all that it can of what it has
  bool is_asked_to_finish_ = false;
  bool is_finished_ = true;
  std::optional<motion::AxisPoint> locked_;  // where the axes really stand

  std::unique_ptr<PlanningThread> beside_;  // null: the source is fed here; last: it sees source_
};

}  // namespace kerf::machine
