#pragma once

#include "planner/operator_wishes.hpp"
#include "planner/section_drive.hpp"
#include "planner/setpoint_source.hpp"
#include "planner/settings.hpp"
#include "planner/way_ahead.hpp"

namespace kerf::planner {

/// Drives along motions: plans the speed within the limits of all driven axes, and tells where the
/// tool is at every period of the servo (docs/motion.md).
///
///   motions ──▶ WayAhead ──sections──▶ SectionDrive ──▶ set-points
///                   ▲                       ▲
///                   └──── OperatorWishes ───┘
///
/// Every point comes from the equation of its line or curve. Each standstill has a point exactly at
/// the programmed end. Bounded look-ahead. No allocation after the first motion.
class Interpolator final : public SetpointSource {
 public:
  /// `limits` are those of the driven axes. `linkage` is null when these are the program's axes,
  /// and must outlive the interpolator otherwise.
  Interpolator(const motion::AxisSetup& axes, const AxisLimits& limits, const Settings& settings,
               const Linkage* linkage = nullptr)
      : ahead_(axes, limits, settings, linkage),
        drive_(ahead_, settings.period_s),
        wishes_(ahead_, drive_) {}

  [[nodiscard]] bool room() const override { return ahead_.builder.room(); }
  void take(const motion::Motion& motion) override { ahead_.take(motion); }
  void finish() override { ahead_.finish(); }
  /// The point of the next period. While the feed is held the points stand still.
  [[nodiscard]] bool next(motion::Setpoint& point) override;
  void skip() override;
  void tell_ends(motion::MotionEndSink& sink) override { drive_.tell_ends(sink); }

  void set_overrides(const Overrides& overrides) override { wishes_.set_overrides(overrides); }
  void set_spindle_override(double factor) override { ahead_.builder.set_spindle_override(factor); }
  void hold() override { wishes_.hold(); }
  void hold_behind_block() override { wishes_.hold_behind_block(); }
  void resume() override { wishes_.resume(); }
  void reset() override { wishes_.reset(); }
  [[nodiscard]] bool wants_hold() const override { return wishes_.wants_hold(); }
  [[nodiscard]] bool held() const override { return wishes_.held(); }
  [[nodiscard]] bool at_reset() const override { return wishes_.at_reset(); }
  [[nodiscard]] bool empty() const override { return ahead_.empty(); }
  [[nodiscard]] bool standing() const override { return drive_.standing(); }

  /// A multiple of the period.
  [[nodiscard]] double time_s() const override { return drive_.time_s(); }
  [[nodiscard]] const base::TipPoint& tip() const override { return drive_.tip(); }
  [[nodiscard]] base::TipPoint motion_end() const override { return drive_.motion_end(); }

 private:
  [[nodiscard]] bool load_section();

  WayAhead ahead_;
  SectionDrive drive_;
  OperatorWishes wishes_;
};

}  // namespace kerf::planner
