#pragma once

#include <string>
#include <vector>

#include "engraver/pattern_maker.hpp"

namespace kerf::engraver {

/// The picture of a pattern against its program: the programmed path, on it the wheel's path with
/// its deviations magnified so that they can be seen, the wheel's heading, travel between cuts, and
/// true to scale the place where the wheel is farthest off, pulse by pulse.
///
/// Memory is bounded: a path of more than kMostKnots steps is thinned, of two neighbours the one
/// farther off stays. The same steps give the same bytes.
class PatternPlot : public PatternWatcher {
 public:
  static constexpr std::size_t kMostKnots = 40'000;

  explicit PatternPlot(std::string title) : title_(std::move(title)) {}

  void set_down(double x, double y, double heading_deg) override;
  void step(const PatternStep& step) override;

  [[nodiscard]] std::string svg(const PatternReport& report) const;
  [[nodiscard]] std::string png(const PatternReport& report) const;

  struct Knot {
    double x = 0, y = 0;
    double off_x = 0, off_y = 0;
    double off_mm = 0;
    double heading_deg = 0;
    bool down = false;  ///< the wheel comes onto the work here
  };
  /// Around the worst place: the path and the wheel's places, in order.
  struct Detail {
    std::vector<PathGauge::Place> path, wheel;
  };

 private:
  void thin();
  void add_detail(const PatternStep& step);

  std::string title_;
  std::vector<Knot> knots_;
  double worst_mm_ = 0;
  Detail last_, detail_;      // of the step before; of the worst one and its neighbours
  bool detail_open_ = false;  // the next step belongs to it
};

}  // namespace kerf::engraver
