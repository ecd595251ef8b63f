#include "optimum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/path_builder.hpp"

namespace kerf::bench {
namespace {

using planner::PathPiece;

constexpr double kGrid_mm = 0.002;

/// A grid interval: derivatives in its middle, and the highest speed of all but the accelerations.
struct Interval {
  double length = 0;
  base::AxisVector first, second;
  double most_z = 0;
  bool stop = false;  // at its end
};

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

class Grid {
 public:
  Grid(const planner::AxisLimits& limits, std::size_t axes) : limits_(limits), axes_(axes) {}

  void add(const PathPiece& piece) {
    const double length = piece.end - piece.begin;
    const int count = std::max(4, static_cast<int>(std::ceil(length / kGrid_mm)));
    for (int i = 0; i < count; ++i) {
      const base::TipJet jet = piece.curve.jet(piece.begin + length * (i + 0.5) / count);
      Interval interval{length / count, jet.first, jet.second, 0, piece.stop && i + 1 == count};
      double speed = piece.speed.at(piece.curve, piece.begin + length * (i + 0.5) / count);
      for (std::size_t m = 0; m < axes_; ++m)
        speed = std::min(speed, limits_.velocity.values[m] / std::fabs(jet.first.values[m]));
      interval.most_z = speed * speed;
      intervals_.push_back(interval);
    }
  }

  [[nodiscard]] double time_s() {
    std::vector<double> most(intervals_.size() + 1, 0);  // z at the begin of each
    for (std::size_t n = intervals_.size(); n-- > 0;)
      most[n] = largest_before(intervals_[n], intervals_[n].stop ? 0 : most[n + 1]);
    double z = 0;
    double time_s = 0;
    for (std::size_t n = 0; n < intervals_.size(); ++n) {
      const Interval& interval = intervals_[n];
      const double next = largest_behind(interval, z, interval.stop ? 0 : most[n + 1]);
      time_s += 2 * interval.length / (std::sqrt(z) + std::sqrt(next));
      z = next;
    }
    return time_s;
  }

 private:
  // Of z at the end of the interval, from z at its begin.
  [[nodiscard]] Range range_of(const Interval& interval, double z) const {
    Range range;
    if (z > interval.most_z) return {1, 0};
    for (std::size_t m = 0; m < axes_; ++m) {
      const double a = limits_.acceleration.values[m];
      const double shape = interval.second.values[m] * z;
      const double first = interval.first.values[m];
      if (std::fabs(first) < 1e-12) {
        if (std::fabs(shape) > a) return {1, 0};
        continue;
      }
      const auto [low, high] = std::minmax({(-a - shape) / first, (a - shape) / first});
      range.low = std::max(range.low, z + 2 * interval.length * low);
      range.high = std::min(range.high, z + 2 * interval.length * high);
    }
    return range;
  }
  // Largest z at the begin from which some z in [0, most] is reached at the end.
  [[nodiscard]] double largest_before(const Interval& interval, double most) const {
    const auto reaches = [&](double z) {
      const Range range = range_of(interval, z);
      return range.low <= range.high && range.low <= most && range.high >= 0;
    };
    double low = 0;
    double high = interval.most_z;
    if (reaches(high)) return high;
    for (int i = 0; i < 80; ++i) {
      const double z = (low + high) / 2;
      (reaches(z) ? low : high) = z;
    }
    return low;
  }
  [[nodiscard]] double largest_behind(const Interval& interval, double z, double most) const {
    const Range range = range_of(interval, z);
    return std::max(0.0, std::min({most, range.high}));
  }

  const planner::AxisLimits& limits_;
  std::size_t axes_;
  std::vector<Interval> intervals_;
};

}  // namespace

double optimal_time_s(const motion::AxisSetup& axes, const planner::AxisLimits& limits,
                      const planner::Settings& settings,
                      const std::vector<motion::Motion>& motions) {
  std::array<bool, base::kMaxAxes> linear{};
  for (std::size_t m = 0; m < axes.count(); ++m) linear[m] = !axes.axes[m].rotary;
  const planner::CellLimits cell_limits(limits, settings, axes.count(), linear);
  planner::Path path;
  planner::PathBuilder builder(axes, cell_limits, settings, path);
  Grid grid(limits, axes.count());
  const auto drain = [&] {
    for (; !path.pieces.empty(); path.pieces.pop()) grid.add(path.pieces.front());
    path.marks.clear();
  };
  for (const motion::Motion& motion : motions) {
    if (!builder.room()) drain();
    builder.take(motion);
  }
  if (!builder.room()) drain();
  builder.stop();
  drain();
  return grid.time_s();
}

}  // namespace kerf::bench
