#pragma once

#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/compare/line_rows.hpp"
#include "stock/compare/outline.hpp"

namespace kerf::stock::compare {

/// What is left of a turned part: a region of the half plane (u = Z, v = ρ) that turns about Z.
/// Distances are exact. Its points are every 0.1 mm of its edges, each at kAngles angles, which
/// shift from one to the next; volumes are measured on lines of a grid.
class TurnedSolid final : public Part {
 public:
  static constexpr std::size_t kAngles = 24;
  static constexpr double kSample_mm = 0.1;

  /// Each edge has the motion that cut it for its owner. The lines of the grid fill `lines`, where
  /// there may be what the part has not; without it the box around the part.
  TurnedSolid(const contour::Region& region, const Bounds& lines);
  explicit TurnedSolid(const contour::Region& region);

  [[nodiscard]] Near near(Vec3 place, Hint& hint) const override;
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::size_t rows() const override;
  void row(std::size_t number, Row& row) const override;
  void inside(int axis, double b, double c, std::vector<Stretch>& out) const override;
  [[nodiscard]] double cell_mm() const override { return lines_.cell_mm(); }

 private:
  static void add_points(const Outline::Sample& sample, double shift,
                         std::vector<SurfacePoint>& out);
  [[nodiscard]] std::size_t sample_rows() const;

  Outline outline_;
  Bounds bounds_;
  std::vector<Outline::Sample> samples_;
  LineRows lines_;
};

}  // namespace kerf::stock::compare
