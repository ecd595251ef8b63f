#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "drive/arm_drive.hpp"
#include "drive/pattern/record.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

/// The four motors that make a pattern, record by record. A value: a copy goes on by itself, into
/// the same sink.
class PatternMotors {
 public:
  /// Both must outlive the motors.
  PatternMotors(const PatternMachine& machine, drive::PulseSink& pulses,
                const drive::ArmCounts& from = {});

  /// Makes the next record. Error TIMER_OVERFLOW: nothing of it has moved.
  [[nodiscard]] base::Result<void> make(const drive::PatternRecord& record);
  /// All four together, for a machine with PatternSettings::Link::four. Error as make().
  [[nodiscard]] base::Result<void> make_linked(const drive::ArmCounts& counts);

  /// What the last record was of the tip: a line at the feed that it had for a triplet and a linked
  /// move, a rapid for a fast record, without program, line and file. Nothing: it has moved
  /// nothing.
  [[nodiscard]] const std::optional<motion::Motion>& motion() const { return motion_; }
  [[nodiscard]] const base::TipPoint& tip() const { return tip_; }
  [[nodiscard]] const drive::ArmCounts& counters() const { return drive_.counters(); }
  /// Since the first record, at the end of the last one.
  [[nodiscard]] std::int64_t time_ns() const { return nanoseconds(drive_.now_ticks()); }
  [[nodiscard]] double time_s() const;

  /// Whether a joint, in the order of the machine file, stands beyond its travel, and what there is
  /// to say of it then.
  [[nodiscard]] bool is_beyond_travel(std::size_t joint) const;
  [[nodiscard]] std::string words_beyond_travel(std::size_t joint) const;

 private:
  [[nodiscard]] double joint_at(std::size_t joint) const;
  base::Result<void> make_moves(const drive::FastRecord& record);
  base::Result<void> make_moves(const drive::Triplet& triplet);
  /// The tip has gone to where the counters are now, by a line that began at `begin` ticks.
  void cut_since(std::int64_t begin);
  [[nodiscard]] bool arrive();
  [[nodiscard]] std::int64_t nanoseconds(std::int64_t ticks) const;

  const PatternMachine* machine_;
  drive::ArmDrive drive_;
  base::TipPoint tip_;
  std::optional<motion::Motion> motion_;
};

/// For motors of which only the counters are wanted.
struct CountedOnly : drive::PulseSink {
  void take(const drive::Pulse& /*pulse*/) override {}
};

/// Where joints and tip stand, each coordinate as it is told.
struct PatternStand {
  base::JointPoint joints;
  base::TipPoint tip;
};
/// After counts, which may have a fraction of a pulse.
[[nodiscard]] PatternStand stand_after(const PatternMachine& machine,
                                       const std::array<double, drive::kArmAxes>& counts);

}  // namespace kerf::machine
