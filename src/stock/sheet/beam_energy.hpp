#pragma once

#include <functional>

#include "motion/axis_point.hpp"
#include "stock/cutting/work_frame.hpp"
#include "stock/sheet/sheet.hpp"

namespace kerf::stock::sheet {

/// Burns of the set-points of a run: in each period the beam has its power and goes straight, so
/// corners get what acceleration leaves them (docs/drives.md, Energy on the way).
class BeamEnergy final : public motion::AxisPointSink {
 public:
  using Take = std::function<void(const Burn&)>;

  /// The frame must outlive this. `full_power_w` > 0.
  BeamEnergy(const WorkFrame& frame, double full_power_w, Take take)
      : frame_(frame), full_power_w_(full_power_w), take_(std::move(take)) {}

  void start(const motion::AxisPoint& at) override;
  void take(const motion::AxisPoint& point) override;

  /// Of all periods, on the sheet or beside it.
  [[nodiscard]] double energy_j() const { return energy_j_; }
  /// Up to which the last burn goes, s of the run.
  [[nodiscard]] double time_s() const { return time_s_; }

 private:
  [[nodiscard]] Vec2 place_of(const motion::AxisPoint& point) const;

  const WorkFrame& frame_;
  double full_power_w_;
  Take take_;
  Vec2 at_;
  double time_s_ = 0;
  double energy_j_ = 0;
};

}  // namespace kerf::stock::sheet
