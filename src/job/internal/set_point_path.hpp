#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "motion/axis_point.hpp"
#include "motion/motion.hpp"
#include "stock/cutting/cutter.hpp"

namespace kerf::job {

/// Has a cutter cut where the axes go (`--path interpolated`): the motions of a run wait until
/// their set-points are there, and are cut along them, in their order. A motion that is passed
/// between two periods goes with the next one.
class SetPointPath final : public motion::AxisPointSink {
 public:
  /// `is_placed`: whether the axes have been commanded, asked as motions come. The cutter must
  /// outlive this.
  SetPointPath(stock::Cutter& cutter, std::function<bool()> is_placed)
      : cutter_(cutter), is_placed_(std::move(is_placed)) {}

  /// A motion, before its set-points.
  void add(const motion::Motion& motion);
  void take(const motion::AxisPoint& point) override;
  /// The run is over.
  void finish();
  /// What is_placed said when the motion that the cutter has now came.
  [[nodiscard]] bool was_placed() const { return was_placed_; }

 private:
  struct Waiting {
    motion::Motion motion;
    bool is_placed;
  };

  void cut_first();

  stock::Cutter& cutter_;
  std::function<bool()> is_placed_;
  std::deque<Waiting> waiting_;
  std::uint64_t first_ = 1;             // number of the first that waits
  std::vector<base::TipPoint> points_;  // of that
  bool was_placed_ = false;
};

}  // namespace kerf::job
