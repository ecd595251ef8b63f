#include "stock/compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/each_by_threads.hpp"
#include "stock/compare/internal/line_differences.hpp"
#include "stock/compare/internal/region_finder.hpp"
#include "stock/dexel/lattice.hpp"

namespace kerf::stock::compare {
namespace {

using dexel::along_axis;
using dexel::on_axis;

/// What is no farther apart than this is in one place: numbers of files and of grids are coarser,
/// and borders of areas that were cut in another order are rounded by less.
constexpr double kSame_mm = 1e-7;
/// Material along a line that is no longer than this is none, as in dexels: beside a round wall
/// rounding makes so much of what is in one place.
constexpr double kSliver_mm = 1e-5;
/// Cells between points of the design; neighbours of them are in cells that touch, of a grid with
/// cells that are so much larger.
constexpr double kSpacing = 2;
constexpr double kTogether = 3;

double positive(Side side, double deviation) {
  return side == Side::gouge ? -deviation : deviation;
}
Side side_of(double deviation) { return deviation < 0 ? Side::gouge : Side::excess; }

/// Of a solid that has no surface everything is as far as can be.
double settled(double deviation, double farthest_mm) {
  if (std::fabs(deviation) < kSame_mm) return 0;
  return std::clamp(deviation, -farthest_mm, farthest_mm);
}

std::size_t bin_of(double deviation, double tolerance) {
  const double width = 4 * tolerance / Comparison::kBins;
  const double middle = (Comparison::kBins - 1) / 2.0;
  const double bin = width > 0 ? std::nearbyint(deviation / width + middle)
                               : middle * (1 + (deviation > 0) - (deviation < 0));
  return static_cast<std::size_t>(std::clamp(bin, 0.0, Comparison::kBins - 1.0));
}

/// What both surfaces say of a line, of one row.
struct Sums {
  std::array<double, kSides> max_mm{};
  std::array<std::array<double, 3>, kSides> all_mm3{};    // by the lines along each axis
  std::array<std::array<double, 3>, kSides> alongside{};  // of faces along them, by how far apart
  std::array<double, Comparison::kBins> histogram{};

  void see(double deviation) {
    double& most = max_mm[index(side_of(deviation))];
    most = std::max(most, std::fabs(deviation));
  }
  void add(const Sums& other) {
    for (std::size_t side = 0; side < kSides; ++side) {
      max_mm[side] = std::max(max_mm[side], other.max_mm[side]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        all_mm3[side][axis] += other.all_mm3[side][axis];
        alongside[side][axis] += other.alongside[side][axis];
      }
    }
    for (std::size_t bin = 0; bin < histogram.size(); ++bin) histogram[bin] += other.histogram[bin];
  }
  [[nodiscard]] double all(Side side) const {
    const auto& faces = alongside[index(side)];
    const std::size_t axis = faces[2] <= faces[0] && faces[2] <= faces[1] ? 2
                             : faces[0] <= faces[1]                       ? 0
                                                                          : 1;
    return all_mm3[index(side)][axis];
  }
};

struct RowResult {
  RowFound found;
  Sums sums;
};

/// By what deviations are measured, and the most that they can be.
struct Scale {
  Tolerance tolerance;
  double farthest_mm;
};

/// One row of the part against the design.
class PartRow {
 public:
  PartRow(const Part& part, const Solid& design, const Scale& scale, RowResult& result)
      : part_(part), design_(design), scale_(scale), result_(result) {
    for (Hint* const hint : {&design_hints_[0], &design_hints_[1], &line_hint_})
      hint->around_mm = part.around_mm();
  }

  void compare(std::size_t number) {
    part_.row(number, row_);
    for (const SurfacePoint& point : row_.points) look_at(point);
    std::vector<Stretch> there;
    for (const Part::Line& line : row_.lines) {
      there.clear();
      design_.inside_near(line.axis, line.b, line.c, line_hint_, there);
      const auto here = std::span(row_.stretches).subspan(line.first, line.end - line.first);
      each_difference(here, there, [&](const Difference& one) { add(line, one); });
    }
    result_.found.settle();
  }

 private:
  void look_at(const SurfacePoint& point) {
    const Near near = design_.near(point.at, hint_for(point.normal));
    const double deviation = settled(near.distance_mm, scale_.farthest_mm);
    deviations_.push_back(deviation);
    result_.sums.see(deviation);
    result_.sums.histogram[bin_of(deviation, scale_.tolerance.larger())] += point.area_mm2;
    auto& faces = result_.sums.alongside[index(side_of(deviation))];
    for (int axis = 0; axis < 3; ++axis) {
      faces[static_cast<std::size_t>(axis)] +=
          point.area_mm2 * std::fabs(deviation) * (1 - std::fabs(on_axis(point.normal, axis)));
    }
    const Side side = side_of(deviation);
    if (std::fabs(deviation) > scale_.tolerance.of(side))
      result_.found.add_point(side, point, std::fabs(deviation), false, near.motion);
  }

  /// Points at the lower and at the upper ends of lines take turns, and lie apart.
  [[nodiscard]] Hint& hint_for(Vec3 normal) {
    return design_hints_[normal.x + normal.y + normal.z > 0 ? 1 : 0];
  }

  [[nodiscard]] static Vec3 place(const Part::Line& line, const Border& border) {
    return along_axis(line.axis, border.at, line.b, line.c);
  }

  /// Whether it is beyond tolerance at this end.
  bool is_beyond(const Part::Line& line, const Difference& one, const Border& border) {
    const double tolerance = scale_.tolerance.of(one.side);
    if (border.point != Stretch::kNone)
      return positive(one.side, deviations_[border.point]) > tolerance;
    const bool has_part = one.low.point != Stretch::kNone || one.high.point != Stretch::kNone;
    if (has_part && one.length_mm() <= tolerance) return false;
    const Vec3 at = place(line, border);
    const Near near = part_.near(at, part_hint_);
    // On which side of the part it is, the line says: it may lie just beside an edge.
    const double far = settled(std::fabs(near.distance_mm), scale_.farthest_mm);
    result_.sums.see(one.side == Side::gouge ? -far : far);
    if (!(far > tolerance)) return false;
    const SurfacePoint point{at, along_axis(line.axis, 1, 0, 0), 0, near.motion};
    result_.found.add_point(one.side, point, far, true, 0);
    return true;
  }

  void add(const Part::Line& line, const Difference& one) {
    if (one.length_mm() <= kSliver_mm) return;
    const double mm3 = one.length_mm() * line.area_mm2;
    const auto axis = static_cast<std::size_t>(line.axis);
    result_.sums.all_mm3[index(one.side)][axis] += mm3;
    const bool low = is_beyond(line, one, one.low);
    const bool high = is_beyond(line, one, one.high);
    if (!low && !high) return;
    result_.found.add_volume(one.side, place(line, low ? one.low : one.high), line.axis, mm3);
    if (low && high) result_.found.link(one.side, place(line, one.low), place(line, one.high));
  }

  const Part& part_;
  const Solid& design_;
  const Scale& scale_;
  RowResult& result_;
  Part::Row row_;
  std::vector<double> deviations_;  // of the row's points
  std::array<Hint, 2> design_hints_;
  Hint line_hint_;  // of the design
  Hint part_hint_;
};

/// One row of the design against the part.
void compare_design_row(const Part& part, const Solid& design, std::size_t number,
                        double spacing_mm, const Scale& scale, RowResult& result) {
  std::vector<SurfacePoint> points;
  design.points(number, spacing_mm, points);
  Hint hint;
  for (SurfacePoint& point : points) {
    const Near near = part.near(point.at, hint);
    const double deviation = settled(-near.distance_mm, scale.farthest_mm);
    result.sums.see(deviation);
    const Side side = side_of(deviation);
    if (!(std::fabs(deviation) > scale.tolerance.of(side))) continue;
    const std::uint32_t there = std::exchange(point.motion, near.motion);
    result.found.add_point(side, point, std::fabs(deviation), true, there);
  }
  result.found.settle();
}

bool comes_first(const Region& one, const Region& other) {
  const auto key = [](const Region& r) {
    return std::array{-r.volume_mm3, -r.area_mm2, r.at.x, r.at.y, r.at.z};
  };
  return key(one) < key(other);
}

Bounds around_both(const Bounds& a, const Bounds& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

void take_regions(std::vector<Region> regions, Comparison& comparison) {
  std::stable_sort(regions.begin(), regions.end(), comes_first);
  for (Region& region : regions) {
    Comparison::Total& total = comparison.totals[index(region.side)];
    total.volume_mm3 += region.volume_mm3;
    if (++total.regions <= Comparison::kMostRegions)
      comparison.regions.push_back(std::move(region));
  }
}

}  // namespace

Comparison compare(const Part& part, const Solid& design, const Tolerance& tolerance,
                   unsigned jobs) {
  const double spacing = kSpacing * part.cell_mm();
  const Bounds both = around_both(part.bounds(), design.bounds());
  const Scale scale{tolerance, length(both.high - both.low)};
  const KeyGrid grid{both.low, kTogether * part.cell_mm()};
  const std::size_t own = part.rows();
  const std::size_t all = own + design.rows();
  std::vector<RowResult> results(all, RowResult{RowFound(grid), {}});
  base::each_by_threads(all, base::useful_threads(jobs), [&](std::size_t i) {
    if (i < own) {
      PartRow(part, design, scale, results[i]).compare(i);
    } else {
      compare_design_row(part, design, i - own, spacing, scale, results[i]);
    }
  });
  Sums sums;
  RegionFinder finder;
  for (RowResult& result : results) {
    sums.add(result.sums);
    finder.take(std::move(result.found));
  }
  Comparison comparison;
  comparison.tolerance = tolerance;
  comparison.histogram = sums.histogram;
  take_regions(finder.find(), comparison);
  for (const Side side : {Side::gouge, Side::excess}) {
    comparison.totals[index(side)].max_mm = sums.max_mm[index(side)];
    comparison.totals[index(side)].all_mm3 = sums.all(side);
  }
  return comparison;
}

}  // namespace kerf::stock::compare
