#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "stock/compare/comparison.hpp"

namespace kerf::stock::compare {

/// A cell of the grid that says what hangs together: its side and its place. Numbers rise with
/// side, z, y, x.
using Key = std::uint64_t;

/// Where keys are: cells from a corner on, up to 2^21 of them along each axis; what is farther out
/// is in the last ones.
struct KeyGrid {
  Vec3 low;
  double cell_mm = 1;

  [[nodiscard]] Key key(Side side, Vec3 at) const;
};

/// All that was found beyond tolerance in one cell.
struct CellFound {
  double max_mm = 0;
  Vec3 at;
  Bounds extents;
  Vec3 moment;  // of the part's area
  Vec3 design_moment;
  double area_mm2 = 0;  // of the part
  double design_mm2 = 0;
  std::array<double, 3> mm3{};        // by the lines along each axis
  std::array<double, 3> alongside{};  // mm² of faces along them

  void add(const CellFound& other);
};

/// What a row of a surface has beyond tolerance, by cells.
class RowFound {
 public:
  explicit RowFound(const KeyGrid& grid) : grid_(grid) {}

  /// A point with its deviation, > 0. `is_design`: it is the design's. Its motion is the part's,
  /// `there` the design's; 0: none.
  void add_point(Side side, const SurfacePoint& point, double deviation_mm, bool is_design,
                 std::uint32_t there);
  /// What lies between two surfaces on a line along `axis`, at a point that was added.
  void add_volume(Side side, Vec3 at, int axis, double mm3);
  /// Two points that were added belong to one region.
  void link(Side side, Vec3 one, Vec3 other);
  /// Sums by cells. Before it is merged; nothing may be added behind it.
  void settle();

 private:
  friend class RegionFinder;
  struct Cut {
    Key key;
    std::uint32_t motion;
    float mm2;
    bool is_design;  // the point is
    bool is_there;   // the motion is the design's
  };
  using Cell = std::pair<Key, CellFound>;

  void add_cut(const Cut& cut);

  const KeyGrid& grid_;
  std::vector<Cell> cells_;
  std::vector<Cut> cuts_;
  std::vector<std::pair<Key, Key>> links_;
};

/// Joins what rows have found to regions: cells that touch, if only in a corner.
class RegionFinder {
 public:
  /// In the order of the rows, whoever made them when.
  void take(RowFound&& row);
  /// All of them, in no order but the same one always.
  [[nodiscard]] std::vector<Region> find();

 private:
  [[nodiscard]] std::size_t place_of(Key key) const;
  [[nodiscard]] std::size_t root(std::size_t cell);
  void unite(std::size_t one, std::size_t other);
  void join_neighbours();
  void place_extremes(std::vector<Region>& regions,
                      const std::vector<std::uint32_t>& region_of) const;
  void add_motions(std::vector<Region>& regions, const std::vector<std::uint32_t>& region_of,
                   const std::vector<CellFound>& of_regions) const;

  std::vector<RowFound::Cell> cells_;
  std::vector<RowFound::Cut> cuts_;
  std::vector<std::pair<Key, Key>> links_;
  std::vector<std::size_t> parents_;
};

}  // namespace kerf::stock::compare
