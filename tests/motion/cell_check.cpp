#include "cell_check.hpp"

#include <cmath>
#include <cstdio>

#include "motion/cell_maker.hpp"
#include "motion/path_builder.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using motion::Cell;

constexpr int kPlaces = 37;
// Of derivatives beside the largest one, and what a derivative may hide of the value over a cell.
constexpr double kRounding = 1e-9;
constexpr double kHidden = 1e-10;

std::array<bool, base::kMaxAxes> linear_axes(const control::AxisSetup& axes) {
  std::array<bool, base::kMaxAxes> linear{};
  for (std::size_t m = 0; m < axes.count(); ++m) linear[m] = !axes.axes[m].rotary;
  return linear;
}

class CellCheck {
 public:
  CellCheck(const RandomPath& path, const motion::Linkage& linkage)
      : linkage_(linkage),
        limits_(path.limits, path.settings, linkage.size(), linear_axes(path.axes)),
        builder_(path.axes, limits_, path.settings, path_, &linkage),
        maker_(limits_, &linkage),
        joints_(linkage.start()) {}

  std::string run(const std::vector<control::Motion>& motions) {
    for (const control::Motion& motion : motions) {
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
      const base::PathJet tip = curve.jet(cell.begin + cell.length() * i / kPlaces);
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

  const motion::Linkage& linkage_;
  motion::CellLimits limits_;
  motion::Path path_;
  motion::PathBuilder builder_;
  motion::CellMaker maker_;
  motion::Ring<Cell> cells_{motion::CellMaker::kCells};
  AxisVector joints_;
  std::string problem_;
};

}  // namespace

std::string check_cells(const RandomPath& path, const motion::Linkage& linkage) {
  return CellCheck(path, linkage).run(path.motions);
}

}  // namespace kerf::test
