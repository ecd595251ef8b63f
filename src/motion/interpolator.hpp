#pragma once

#include <cstdint>

#include "motion/cell_limits.hpp"
#include "motion/look_ahead.hpp"
#include "motion/path_builder.hpp"
#include "motion/profile.hpp"
#include "motion/setpoint.hpp"
#include "motion/settings.hpp"

namespace kerf::motion {

/// Drives along motions: plans the speed within the limits of all axes, and tells where the tool is
/// at every period of the servo.
///
///   while there are motions:   while (room()) take(motion);   while (next(point)) …
///   at the end:                finish();                      while (next(point)) …
///
/// Every point comes from the equation of its line or curve. Each standstill has a point exactly at
/// the programmed end; what follows begins with the period after it. Bounded look-ahead: at most
/// Path::kCells curves. No allocation after construction.
class Interpolator {
 public:
  /// `axes` must outlive the interpolator.
  Interpolator(const control::AxisSetup& axes, const AxisLimits& limits, const Settings& settings);

  [[nodiscard]] bool room() const { return builder_.room(); }
  /// Precondition: room().
  void take(const control::Motion& motion);
  /// The axes come to rest behind what was taken. Precondition: room().
  void finish();

  /// The point of the next period; false when more motions are needed, or all is done.
  [[nodiscard]] bool next(Setpoint& point);
  /// Passes over all that next() would give.
  void skip();

  /// Time at the last point, s. A multiple of the period.
  [[nodiscard]] double time_s() const { return static_cast<double>(tick_) * settings_.period_s; }

 private:
  bool load_section();
  void end_section();
  void end_phase(const Phase& phase);
  void stop_at(std::uint64_t tick);
  void advance_cell(double way);
  [[nodiscard]] std::uint64_t ticks_until(double time_s) const;
  void fill(Setpoint& point, double way);
  void pop_marks(double at);

  control::AxisSetup axes_;
  Settings settings_;
  CellLimits limits_;
  Path path_;
  PathBuilder builder_;
  LookAhead look_ahead_;
  bool ended_ = false;

  // The section under way.
  bool driving_ = false;
  Section section_;
  Profile profile_{0, 0, 0, {1, 1, 1}};
  std::size_t phase_ = 0;
  std::uint64_t phase_tick_ = 0;  // the last period before its begin,
  double phase_late_s_ = 0;       // and how long after that it begins: times stay small and exact
  double phase_way_ = 0;          // at its begin, from that of the section
  double cell_way_ = 0;           // at the begin of the cell, from that of the section
  std::uint64_t cells_left_ = 0;

  std::uint64_t tick_ = 0;
};

}  // namespace kerf::motion
