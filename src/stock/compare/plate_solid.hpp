#pragma once

#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/compare/line_rows.hpp"
#include "stock/compare/outline.hpp"

namespace kerf::stock::compare {

/// A plate: a region of the plane of X and Y, from one height to another. Distances are exact. Its
/// points are every 0.1 mm of its walls at several heights, and those of its faces where the lines
/// of a grid pass them, on which volumes are measured.
class PlateSolid final : public Part {
 public:
  static constexpr double kSample_mm = 0.1;

  /// Each edge has the motion that cut it for its owner. As high as the sheet, low < high, which
  /// the lines of the grid fill: there may be what the plate has not.
  PlateSolid(const contour::Region& region, const Bounds& sheet);

  [[nodiscard]] Near near(Vec3 place, Hint& hint) const override;
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::size_t rows() const override;
  void row(std::size_t number, Row& row) const override;
  void inside(int axis, double b, double c, std::vector<Stretch>& out) const override;
  [[nodiscard]] double cell_mm() const override { return lines_.cell_mm(); }

 private:
  void add_wall(const Outline::Sample& sample, std::vector<SurfacePoint>& out) const;
  [[nodiscard]] std::size_t wall_rows() const;

  Outline outline_;
  Bounds bounds_;
  std::vector<Outline::Sample> walls_;
  LineRows lines_;
};

}  // namespace kerf::stock::compare
