#pragma once

#include "control/gcode/cycles/thread_cut.hpp"
#include "control/gcode/cycles/turning_passes.hpp"

namespace kerf::control {

/// A thread that is cut in passes of equal chips, G76 (docs/dialect/turning.md, G76). mm, X as a
/// radius.
struct ThreadPlan {
  geometry::Vec2 home{};     ///< where the tool stands
  geometry::Vec2 end{};      ///< bottom of the thread at its end
  double taper = 0;          ///< radius at the start less that at the end
  double height = 0;         ///< of the thread, > 0
  double first_depth = 0;    ///< > 0
  double least_depth = 0;    ///< of a pass, >= 0, <= height
  double finish = 0;         ///< what the last passes take, >= 0
  int finish_passes = 1;     ///< >= 1
  double tip_angle_deg = 0;  ///< the tool goes in along the flank; 0: straight
  RunOut run_out{};
};

/// Depths of the passes one after the other: first · √n, but at least `least_depth` more than the
/// one before, down to the finishing allowance; then the finishing passes at full height.
class ThreadDepths {
 public:
  explicit ThreadDepths(const ThreadPlan& plan);
  /// False: all passes are made.
  [[nodiscard]] bool next(double& depth);

 private:
  double first_;
  double least_;
  double rough_;  // the last depth before the finishing passes
  double height_;
  int finish_left_;
  double count_ = 0;  // of roughing passes so far
  double depth_ = 0;
};

class ThreadPasses : public TurningPasses {
 public:
  explicit ThreadPasses(const ThreadPlan& plan);

 private:
  bool advance() override;

  ThreadPlan plan_;
  ThreadDepths depths_;
  double slope_;  // of the flank: way along Z for each of depth
};

}  // namespace kerf::control
