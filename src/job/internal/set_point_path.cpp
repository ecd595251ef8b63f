#include "job/internal/set_point_path.hpp"

namespace kerf::job {

void SetPointPath::add(const motion::Motion& motion) {
  waiting_.push_back({motion, !is_placed_ || is_placed_()});
}

void SetPointPath::take(const motion::AxisPoint& point) {
  while (!waiting_.empty() && first_ < point.tip.mark.motion) cut_first();
  points_.push_back(point.tip.tip);
}

void SetPointPath::finish() {
  while (!waiting_.empty()) cut_first();
}

void SetPointPath::cut_first() {
  was_placed_ = waiting_.front().is_placed;
  cutter_.take_along(waiting_.front().motion, points_);
  waiting_.pop_front();
  ++first_;
  points_.clear();
}

}  // namespace kerf::job
