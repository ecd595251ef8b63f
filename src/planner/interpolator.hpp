#pragma once

#include <cstdint>
#include <optional>

#include "planner/cell_maker.hpp"
#include "planner/look_ahead.hpp"
#include "planner/path_builder.hpp"
#include "planner/profile.hpp"
#include "planner/setpoint_source.hpp"
#include "planner/settings.hpp"

namespace kerf::planner {

/// Drives along motions: plans the speed within the limits of all driven axes, and tells where the
/// tool is at every period of the servo (docs/motion.md).
///
/// Every point comes from the equation of its line or curve. Each standstill has a point exactly at
/// the programmed end. Bounded look-ahead. No allocation after the first motion.
class Interpolator final : public SetpointSource {
 public:
  /// `limits` are those of the driven axes. `linkage` is null when these are the program's axes,
  /// and must outlive the interpolator otherwise.
  Interpolator(const motion::AxisSetup& axes, const AxisLimits& limits, const Settings& settings,
               const Linkage* linkage = nullptr);

  [[nodiscard]] bool room() const override { return builder_.room(); }
  void take(const motion::Motion& motion) override;
  void finish() override;
  /// The point of the next period. While the feed is held the points stand still.
  [[nodiscard]] bool next(motion::Setpoint& point) override;
  void skip() override;

  void set_overrides(const Overrides& overrides) override;
  void set_spindle_override(double factor) override { builder_.set_spindle_override(factor); }
  void hold() override;
  void hold_behind_block() override;
  void resume() override;
  void reset() override;
  [[nodiscard]] bool wants_hold() const override { return wants_hold_; }
  [[nodiscard]] bool held() const override { return held_; }
  [[nodiscard]] bool at_reset() const override { return at_reset_; }
  [[nodiscard]] bool empty() const override {
    return path_.pieces.empty() && !builder_.keeps_back();
  }
  [[nodiscard]] bool standing() const override { return standing_; }

  /// A multiple of the period.
  [[nodiscard]] double time_s() const override {
    return static_cast<double>(tick_) * settings_.period_s;
  }
  [[nodiscard]] const base::TipPoint& tip() const override { return tip_; }
  [[nodiscard]] base::TipPoint motion_end() const override;

 private:
  /// Speed and acceleration along the path, and the place: an offset from the begin of a cell.
  struct Motion {
    std::uint64_t cell = 0;
    double offset = 0;
    double speed = 0;
    double acceleration = 0;
  };

  bool load_section();
  void begin_section();
  void end_section();
  void end_phase(const Phase& phase);
  void stop_at(std::uint64_t tick);
  void end_standstill();
  void advance_cell(double way);
  void pop_cell();
  void pop_marks(double at);
  void fill(motion::Setpoint& point, double way);
  [[nodiscard]] std::uint64_t ticks_until(double time_s) const;
  [[nodiscard]] bool dwelling(motion::Setpoint& point);

  // What the operator asked for.
  struct Leveling;
  [[nodiscard]] bool has_wish() const {
    if (wants_hold_ && stopping_) return false;
    return wants_hold_ != (stopping_ || held_) || wanted_ != overrides_;
  }
  void grant_wish();
  [[nodiscard]] Motion now() const;
  [[nodiscard]] bool level_off(const Motion& from, Leveling& leveling) const;
  [[nodiscard]] bool replan(const Motion& from);
  [[nodiscard]] bool replan_hold(const Motion& from);
  [[nodiscard]] bool replan_to_block_end(const Motion& from);
  [[nodiscard]] std::optional<double> way_to(const PathMark& mark, const Motion& from) const;
  [[nodiscard]] bool ends_in_standstill(const PathMark& mark) const;
  [[nodiscard]] bool block_is_over() const;
  void interrupt_dwell();
  [[nodiscard]] bool can_stop_within(const Motion& from, double way);
  [[nodiscard]] bool replan_overrides(const Motion& from);
  void try_overrides(std::uint64_t first);
  void put_back_overrides(std::uint64_t first);
  void set_overrides_of(std::uint64_t cell, const Overrides& overrides);
  void drop();

  motion::AxisSetup axes_;
  Settings settings_;
  CellLimits limits_;
  Path path_;
  PathBuilder builder_;
  CellMaker maker_;
  Ring<Cell> cells_{CellMaker::kCells};
  LookAhead look_ahead_;
  LookAhead trial_;  // a plan that takes the other's place when it is possible
  bool ended_ = false;

  Overrides overrides_;
  Overrides wanted_;
  bool wants_hold_ = false;
  bool wants_reset_ = false;
  bool wants_whole_block_ = false;   // the hold waits for the end of the block
  std::uint64_t behind_motion_ = 0;  // which is not that of this motion
  bool stopping_ = false;            // the plan ends in the hold
  bool held_ = false;
  bool at_reset_ = false;
  bool standing_ = true;

  // The section under way.
  bool driving_ = false;
  Section section_;
  Profile profile_;
  std::size_t phase_ = 0;
  std::uint64_t phase_tick_ = 0;  // the last period before its begin,
  double phase_late_s_ = 0;       // and how long after that it begins: times stay small and exact
  double phase_way_ = 0;          // at its begin, from that of the section
  double cell_way_ = 0;           // at the begin of the cell, from that of the section
  double offset_ = 0;             // of the next section in its first cell
  std::uint64_t cells_left_ = 0;  // that end within the section

  std::uint64_t tick_ = 0;
  base::TipPoint tip_;
  motion::Mark mark_;
};

}  // namespace kerf::planner
