#pragma once

#include <array>
#include <cstdint>

#include "motion/setpoint.hpp"
#include "motion/spindle_angle.hpp"
#include "planner/internal/motion_ends.hpp"
#include "planner/path_state.hpp"
#include "planner/profile.hpp"
#include "planner/way_ahead.hpp"

namespace kerf::planner {

/// Drives over one section after the other: at every period of the servo the place on the path, by
/// the profile of the section, and the point from the equation of its curve. Cells and motions that
/// are driven are left behind. Each standstill has a point exactly at its end.
class SectionDrive {
 public:
  /// The axes stand at the start of `ahead`, which must outlive this. `period_s` > 0.
  SectionDrive(WayAhead& ahead, double period_s);

  /// Is told when motions end. Precondition: nothing has begun.
  void tell_ends(motion::MotionEndSink& sink) { ends_.set_sink(sink); }

  /// Sections begin where the one before ended, or was left. This one is driven as fast as it is
  /// planned, or is a dwell.
  void begin(const Section& section);
  /// This one by its own profile.
  void begin(const Section& section, const Profile& profile);
  /// The section is not driven any further: the next one begins at this period, `offset` behind the
  /// begin of the first cell.
  void leave_at(double offset);
  /// What remains of the dwell under way stays in its cell, for a section of its own.
  void break_dwell();

  enum class Step : std::uint8_t {
    point,    ///< the next point
    at_rest,  ///< likewise; there the axes come to rest, and the section is over
    over      ///< none: the section ended before the next period
  };
  /// Precondition: driving().
  [[nodiscard]] Step next(motion::Setpoint& point);
  /// The point of a period in which the axes stand still.
  void stand(motion::Setpoint& point);
  /// Passes over all points of the section. Precondition: driving().
  void skip();

  /// A section is under way.
  [[nodiscard]] bool driving() const { return driving_; }
  [[nodiscard]] bool dwelling() const { return driving_ && section_.dwell_s > 0; }
  /// At the last point the axes were at rest.
  [[nodiscard]] bool standing() const { return standing_; }
  /// How the tool moves at the last point.
  [[nodiscard]] PathState now() const;
  /// Where the next section begins: from the begin of the first cell.
  [[nodiscard]] double offset() const { return offset_; }

  /// A multiple of the period.
  [[nodiscard]] double time_s() const { return static_cast<double>(tick_) * period_s_; }
  /// At the last point.
  [[nodiscard]] const base::TipPoint& tip() const { return tip_; }
  [[nodiscard]] const motion::Mark& mark() const { return mark_; }
  /// Where the motion of the last point ends, as far as that is known: else the tip.
  [[nodiscard]] base::TipPoint motion_end() const;

 private:
  void begin_phases(const Section& section);
  void turn_spindle();
  void begin_wait();
  void tell_ends();
  void end();
  void end_phase(const Phase& phase);
  void rest_at(std::uint64_t tick);
  void advance_cell(double way);
  void fill(motion::Setpoint& point, double way);
  [[nodiscard]] std::uint64_t ticks_until(double time_s) const;
  [[nodiscard]] bool find_place(double& way);
  [[nodiscard]] Step next_of_dwell(motion::Setpoint& point);
  [[nodiscard]] Step next_of_wait(motion::Setpoint& point);
  void end_wait();
  void fill_at_rest(motion::Setpoint& point);

  WayAhead& ahead_;
  MotionEnds ends_;
  double period_s_;

  bool driving_ = false;
  bool standing_ = true;
  Section section_;
  Profile profile_;
  std::size_t phase_ = 0;
  std::uint64_t phase_tick_ = 0;  // the last period before its begin,
  double phase_late_s_ = 0;       // and how long after that it begins: times stay small and exact
  double phase_way_ = 0;          // at its begin, from that of the section
  double cell_way_ = 0;           // at the begin of the cell, from that of the section
  double offset_ = 0;
  std::uint64_t cells_left_ = 0;  // that end within the section
  std::array<motion::SpindleAngle, motion::kSpindles> spindles_;
  bool waiting_ = false;         // the section is one of PathPiece::mark_rpm or until_speed;
  std::uint64_t wait_tick_ = 0;  // the last period before its end,
  double wait_late_s_ = 0;       // and how long after that it ends

  std::uint64_t tick_ = 0;
  base::TipPoint tip_;
  motion::Mark mark_;
};

}  // namespace kerf::planner
