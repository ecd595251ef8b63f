#pragma once

#include "stock/compare/solid.hpp"

namespace kerf::stock::compare {

/// A solid with a grid of its own: columns, or dexels. Its points are the ends of these.
class Part : public Solid {
 public:
  /// A line of the grid; its stretches are those from `first` to before `end`.
  struct Line {
    int axis = 2;
    double b = 0;
    double c = 0;
    double area_mm2 = 0;  ///< of its cell
    std::uint32_t first = 0;
    std::uint32_t end = 0;
  };
  struct Row {
    std::vector<SurfacePoint> points;
    std::vector<Stretch> stretches;
    std::vector<Line> lines;

    void clear() { points.clear(), stretches.clear(), lines.clear(); }
  };

  /// Replaces what is in `row`.
  virtual void row(std::size_t number, Row& row) const = 0;
  /// So far from a place of a row the next ones are, or many of them; 0: they are in lines.
  [[nodiscard]] virtual double around_mm() const { return 0; }
  /// The largest cell.
  [[nodiscard]] virtual double cell_mm() const = 0;

  void points(std::size_t number, double, std::vector<SurfacePoint>& out) const final {
    Row one;
    row(number, one);
    out.insert(out.end(), one.points.begin(), one.points.end());
  }
};

}  // namespace kerf::stock::compare
