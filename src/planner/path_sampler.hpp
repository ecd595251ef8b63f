#pragma once

#include <cstdint>

#include "planner/literal_line.hpp"
#include "planner/path_builder.hpp"
#include "planner/setpoint_source.hpp"
#include "planner/settings.hpp"

namespace kerf::planner {

/// Set-points at equal steps of the programmed path, without acceleration: every Sampling but
/// `planned` (docs/motion.md, "Sampling").
///
/// Each motion is driven by itself, at its feed, from end to end; rapids, and moves whose feed
/// cannot be told, as fast as the program's axes go. Every point comes from the equation of its
/// line or arc, none from the point before; the last one is exactly the programmed end. The limits
/// of the axes are not asked otherwise, and corners are not rounded. Feed hold is at the next
/// point, for without acceleration there is no way to rest; overrides change the motions that begin
/// behind them. No allocation after the first motion.
class PathSampler final : public SetpointSource {
 public:
  /// Precondition: the settings do not ask for Sampling::planned.
  PathSampler(const motion::AxisSetup& axes, const Settings& settings);

  [[nodiscard]] bool room() const override { return builder_.room(); }
  void take(const motion::Motion& motion) override { builder_.take(motion); }
  void finish() override { builder_.stop(); }
  [[nodiscard]] bool next(motion::Setpoint& point) override;
  void skip() override;
  void tell_ends(motion::MotionEndSink& sink) override { ends_ = &sink; }
  [[nodiscard]] double time_s() const override { return time_s_; }
  [[nodiscard]] const base::TipPoint& tip() const override { return tip_; }
  [[nodiscard]] base::TipPoint motion_end() const override;

  void set_overrides(const Overrides& overrides) override { overrides_ = overrides; }
  void set_spindle_override(double factor) override { builder_.set_spindle_override(factor); }
  void hold() override { hold_ = Hold::at_once; }
  void hold_behind_block() override {
    if (hold_ != Hold::none) return;
    hold_ = Hold::behind_block;
    behind_motion_ = under_way_ ? 0 : mark_.motion;
  }
  void resume() override;
  void reset() override;
  [[nodiscard]] bool wants_hold() const override { return hold_ != Hold::none; }
  [[nodiscard]] bool held() const override { return held_; }
  [[nodiscard]] bool at_reset() const override { return held_ && hold_ == Hold::reset; }
  [[nodiscard]] bool empty() const override {
    return !under_way_ && path_.pieces.empty() && !builder_.keeps_back();
  }
  /// Always: without acceleration it can stop anywhere.
  [[nodiscard]] bool standing() const override { return true; }

 private:
  enum class Hold : std::uint8_t { none, behind_block, at_once, reset };

  [[nodiscard]] bool holds_here() const;
  bool stand(motion::Setpoint& point);
  bool begin_motion();
  void end_motion();
  void begin_dwell(double seconds);
  void divide(double way, double speed);
  void divide_literally(double way, double speed);
  [[nodiscard]] double way_of(const motion::Curve& curve) const;
  [[nodiscard]] double speed_of(const PathPiece& piece) const;
  [[nodiscard]] bool turns_in_place(const motion::Curve& curve) const;
  [[nodiscard]] base::TipPoint tip_at(std::uint64_t step) const;
  [[nodiscard]] double time_at(std::uint64_t step) const;

  motion::AxisSetup axes_;
  Settings settings_;
  CellLimits limits_;
  Path path_;
  PathBuilder builder_;

  // The motion under way.
  bool under_way_ = false;
  motion::Mark mark_;
  std::uint64_t last_piece_ = 0;
  std::uint64_t count_ = 0;  // of its points
  std::uint64_t done_ = 0;
  double step_ = 0;      // from point to point, but for the last one
  double step_s_ = 0;    // likewise, where there is no period
  double length_s_ = 0;  // how long it lasts, where there is no period
  bool literally_ = false;
  LiteralLine literal_;

  Overrides overrides_;
  Hold hold_ = Hold::none;
  bool held_ = false;
  std::uint64_t behind_motion_ = 0;

  std::uint64_t tick_ = 0;  // periods before it
  double begin_s_ = 0;      // its begin, where there is no period
  double time_s_ = 0;
  motion::MotionEndSink* ends_ = nullptr;
  base::TipPoint tip_;
};

}  // namespace kerf::planner
