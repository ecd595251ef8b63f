#pragma once

#include <cstdint>

#include "motion/literal_line.hpp"
#include "motion/path_builder.hpp"
#include "motion/setpoint_source.hpp"
#include "motion/settings.hpp"

namespace kerf::motion {

/// Set-points at equal steps of the programmed path, without acceleration: every Sampling but
/// `planned` (docs/motion.md, "Sampling").
///
/// Each motion is driven by itself, at its feed, from end to end; rapids, and moves whose feed
/// cannot be told, as fast as the program's axes go. Every point comes from the equation of its
/// line or arc, none from the point before; the last one is exactly the programmed end. The limits
/// of the axes are not asked otherwise, corners are not rounded, and there is no feed hold or
/// override. No allocation after the first motion.
class PathSampler final : public SetpointSource {
 public:
  /// Precondition: the settings do not ask for Sampling::planned.
  PathSampler(const control::AxisSetup& axes, const Settings& settings);

  [[nodiscard]] bool room() const override { return builder_.room(); }
  void take(const control::Motion& motion) override { builder_.take(motion); }
  void finish() override { builder_.stop(); }
  [[nodiscard]] bool next(Setpoint& point) override;
  void skip() override;
  [[nodiscard]] double time_s() const override { return time_s_; }
  [[nodiscard]] const base::AxisVector& tip() const override { return tip_; }

 private:
  bool begin_motion();
  void end_motion();
  void begin_dwell(double seconds);
  void divide(double way, double speed);
  void divide_literally(double way, double speed);
  [[nodiscard]] double way_of(const Curve& curve) const;
  [[nodiscard]] double speed_of(const PathPiece& piece) const;
  [[nodiscard]] bool turns_in_place(const Curve& curve) const;
  [[nodiscard]] base::AxisVector tip_at(std::uint64_t step) const;
  [[nodiscard]] double time_at(std::uint64_t step) const;

  control::AxisSetup axes_;
  Settings settings_;
  CellLimits limits_;
  Path path_;
  PathBuilder builder_;

  // The motion under way.
  bool under_way_ = false;
  Mark mark_;
  std::uint64_t last_piece_ = 0;
  std::uint64_t count_ = 0;  // of its points
  std::uint64_t done_ = 0;
  double step_ = 0;      // from point to point, but for the last one
  double step_s_ = 0;    // likewise, where there is no period
  double length_s_ = 0;  // how long it lasts, where there is no period
  bool literally_ = false;
  LiteralLine literal_;

  std::uint64_t tick_ = 0;  // periods before it
  double begin_s_ = 0;      // its begin, where there is no period
  double time_s_ = 0;
  base::AxisVector tip_;
};

}  // namespace kerf::motion
