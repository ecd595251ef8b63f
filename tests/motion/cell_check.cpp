#include "cell_check.hpp"

#include <cmath>
#include <cstdio>

#include "motion/axis_norms.hpp"
#include "planner/cell_maker.hpp"
#include "planner/path_builder.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using base::JointPoint;
using planner::Cell;

constexpr int kPlaces = 37;
// Of derivatives beside the largest one, and what a derivative may hide of the value over a cell.
constexpr double kRounding = 1e-9;
constexpr double kHidden = 1e-10;

class CellCheck {
 public:
  CellCheck(const RandomPath& path, const planner::Linkage& linkage)
      : linkage_(linkage),
        limits_(path.limits, path.settings, linkage.size(), motion::linear_axes(path.axes)),
        builder_(path.axes, limits_, path.settings, path_, &linkage),
        maker_(limits_, &linkage),
        joints_(linkage.start()) {}

  std::string run(const std::vector<motion::Motion>& motions) {
    for (const motion::Motion& motion : motions) {
      if (!builder_.room()) look();
      builder_.take(motion);
    }
    if (!builder_.room()) look();
    builder_.stop();
    look();
    return problem_;
  }

 private:
  void look() {
    while (maker_.next_piece() < path_.pieces.end()) {
      maker_.make(path_, {}, cells_);
      for (; !cells_.empty(); cells_.pop()) check(cells_.front());
    }
    path_.pieces.clear();
    path_.marks.clear();
  }

  void check(const Cell& cell) {
    if (cell.dwell_s > 0) return;
    const motion::Curve& curve = path_.pieces[cell.piece].curve;
    for (int i = 0; i <= kPlaces; ++i) {
      const base::TipJet tip = curve.jet(cell.begin + cell.length() * i / kPlaces);
      joints_ = linkage_.joints(tip.value, joints_);
      const auto rates = linkage_.along(tip, joints_);
      if (!rates) return tell("singular", cell, 0, 0, 0);
      hold("q'", 1, cell, rates->first, cell.bounds.driven.first);
      hold("q''", 2, cell, rates->second, cell.bounds.driven.second);
      hold("q'''", 3, cell, rates->third, cell.bounds.driven.third);
    }
  }

  void hold(const char* what, int order, const Cell& cell, const AxisVector& value,
            const AxisVector& bound) {
    const double hidden = kHidden / std::pow(cell.length(), order);
    double largest = 0;
    for (std::size_t m = 0; m < linkage_.size(); ++m) largest = std::max(largest, bound.values[m]);
    for (std::size_t m = 0; m < linkage_.size(); ++m) {
      if (std::fabs(value.values[m]) > bound.values[m] + kRounding * (1 + largest) + hidden)
        tell(what, cell, value.values[m], bound.values[m], m);
    }
  }

  void tell(const char* what, const Cell& cell, double value, double bound, std::size_t axis) {
    if (!problem_.empty()) return;
    char text[200];
    std::snprintf(text, sizeof text, "%s beyond the bound: %.9g, %.9g, axis %zu, cell %.9g to %.9g",
                  what, value, bound, axis, cell.begin, cell.end);
    problem_ = text;
  }

  const planner::Linkage& linkage_;
  planner::CellLimits limits_;
  planner::Path path_;
  planner::PathBuilder builder_;
  planner::CellMaker maker_;
  planner::Ring<Cell> cells_{planner::CellMaker::kCells};
  JointPoint joints_;
  std::string problem_;
};

}  // namespace

std::string check_cells(const RandomPath& path, const planner::Linkage& linkage) {
  return CellCheck(path, linkage).run(path.motions);
}

}  // namespace kerf::test
