#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "stock/compare/part.hpp"
#include "stock/compare/tolerance.hpp"

namespace kerf::stock::compare {

/// A motion's share of a region: of the area that it cut there, or where it cut none of the other
/// solid's that is nearest to what it cut.
struct MotionShare {
  std::uint32_t motion = 0;
  double share = 0;  ///< of all of the region, (0, 1]

  friend bool operator==(const MotionShare&, const MotionShare&) = default;
};

/// Places beyond tolerance that hang together: in cells that touch, if only in a corner, of a grid
/// three times as coarse as the part's.
struct Region {
  Side side = Side::gouge;
  double max_mm = 0;  ///< the largest deviation, > 0
  Vec3 at;            ///< of it; where several are as large to a thousandth, nearest to the centre
  Vec3 centre;        ///< of the area
  Bounds extents;
  double area_mm2 = 0;               ///< of the part; where it has none, of the design
  double volume_mm3 = 0;             ///< between the two surfaces
  std::vector<MotionShare> motions;  ///< of the part, rising, without what nothing has cut
  std::vector<MotionShare> there;    ///< of what it is compared with, where motions cut that
};

/// How a part lies to a design (stock.md §7). Deviations are distances from surface to surface,
/// positive where the part has more.
struct Comparison {
  static constexpr std::size_t kBins = 41;
  static constexpr std::size_t kMostRegions = 1000;

  struct Total {
    double max_mm = 0;          ///< within tolerance, too
    double volume_mm3 = 0;      ///< of what is beyond tolerance
    double all_mm3 = 0;         ///< all that the one has and the other has not
    std::uint64_t regions = 0;  ///< of all of them, kept or not
  };

  Tolerance tolerance;
  std::array<Total, kSides> totals{};
  /// The largest by volume first, of equals by area, then by place; kMostRegions of each side.
  std::vector<Region> regions;
  /// The part's area by deviation, mm²: bins of equal width over ±2 tolerances (the larger one),
  /// the middle one about 0; what is beyond is in the last ones.
  std::array<double, kBins> histogram{};

  [[nodiscard]] const Total& of(Side side) const { return totals[index(side)]; }
};

/// Compares in both directions: each of the part's points with the design, and points of the design
/// no farther apart than two cells with the part; and by volume along the lines of the part's grid,
/// of each region on those that have the least of its faces alongside (stock.md §3, Volumes).
/// `jobs` threads; their number changes no bit. Precondition: jobs > 0.
[[nodiscard]] Comparison compare(const Part& part, const Solid& design, const Tolerance& tolerance,
                                 unsigned jobs);

}  // namespace kerf::stock::compare
