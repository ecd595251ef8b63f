#include "stock/compare/internal/region_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "stock/dexel/lattice.hpp"

namespace kerf::stock::compare {
namespace {

constexpr unsigned kBits = 21;
constexpr double kLast = (1U << kBits) - 1;
constexpr Key kOneX = 1;
constexpr Key kOneY = Key{1} << kBits;
constexpr Key kOneZ = Key{1} << (2 * kBits);
constexpr Key kMask = kOneY - 1;

/// Deviations of this share of the largest are as large.
constexpr double kAsLarge = 0.999;

Key cell_along(double at, double low, double cell) {
  return static_cast<Key>(std::clamp(std::floor((at - low) / cell), 0.0, kLast));
}

CellFound found_at(Vec3 at) {
  CellFound found;
  found.at = at;
  found.extents = {at, at};
  return found;
}

Bounds both(const Bounds& a, const Bounds& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

/// Of equal keys one with the sum.
template <class Cells>
void sum_equal(Cells& cells) {
  std::stable_sort(cells.begin(), cells.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i].first == cells[last].first) {
      cells[last].second.add(cells[i].second);
    } else {
      cells[++last] = cells[i];
    }
  }
  if (!cells.empty()) cells.resize(last + 1);
}

/// Ties Z, X, Y, as stock.md §3 has it.
std::size_t best_axis(const std::array<double, 3>& alongside) {
  if (alongside[2] <= alongside[0] && alongside[2] <= alongside[1]) return 2;
  return alongside[0] <= alongside[1] ? 0 : 1;
}

Region region_of(Side side, const CellFound& all) {
  Region region;
  region.side = side;
  region.max_mm = all.max_mm;
  region.at = all.at;
  region.extents = all.extents;
  region.area_mm2 = all.area_mm2 > 0 ? all.area_mm2 : all.design_mm2;
  const Vec3 moment = all.area_mm2 > 0 ? all.moment : all.design_moment;
  region.centre = region.area_mm2 > 0 ? (1 / region.area_mm2) * moment : all.at;
  std::size_t axis = best_axis(all.alongside);
  // Where the best lines pass by a region that is thinner than a cell, others have seen it.
  for (const std::size_t other : {2U, 0U, 1U}) {
    if (all.mm3[axis] == 0) axis = other;
  }
  region.volume_mm3 = all.mm3[axis];
  return region;
}

}  // namespace

Key KeyGrid::key(Side side, Vec3 at) const {
  const Key x = cell_along(at.x, low.x, cell_mm);
  const Key y = cell_along(at.y, low.y, cell_mm);
  const Key z = cell_along(at.z, low.z, cell_mm);
  return ((Key{index(side)} << kBits | z) << kBits | y) << kBits | x;
}

void CellFound::add(const CellFound& other) {
  if (other.max_mm > max_mm) {
    max_mm = other.max_mm;
    at = other.at;
  }
  extents = both(extents, other.extents);
  moment = moment + other.moment;
  design_moment = design_moment + other.design_moment;
  area_mm2 += other.area_mm2;
  design_mm2 += other.design_mm2;
  for (std::size_t i = 0; i < 3; ++i) {
    mm3[i] += other.mm3[i];
    alongside[i] += other.alongside[i];
  }
}

void RowFound::add_cut(const Cut& cut) {
  if (cut.motion == 0) return;
  // Before the last one there is that of the other solid, of the same point or of its neighbour.
  for (std::size_t back = 1; back <= std::min<std::size_t>(2, cuts_.size()); ++back) {
    Cut& last = cuts_[cuts_.size() - back];
    if (last.key != cut.key || last.motion != cut.motion || last.is_design != cut.is_design ||
        last.is_there != cut.is_there)
      continue;
    last.mm2 += cut.mm2;
    return;
  }
  cuts_.push_back(cut);
}

void RowFound::add_point(Side side, const SurfacePoint& point, double deviation_mm, bool is_design,
                         std::uint32_t there) {
  const Key key = grid_.key(side, point.at);
  CellFound found = found_at(point.at);
  found.max_mm = deviation_mm;
  (is_design ? found.design_mm2 : found.area_mm2) = point.area_mm2;
  (is_design ? found.design_moment : found.moment) = point.area_mm2 * point.at;
  for (int axis = 0; axis < 3; ++axis) {
    found.alongside[static_cast<std::size_t>(axis)] =
        point.area_mm2 * (1 - std::fabs(dexel::on_axis(point.normal, axis)));
  }
  cells_.emplace_back(key, found);
  const auto mm2 = static_cast<float>(point.area_mm2);
  add_cut({key, point.motion, mm2, is_design, false});
  add_cut({key, there, mm2, is_design, true});
}

void RowFound::add_volume(Side side, Vec3 at, int axis, double mm3) {
  CellFound found = found_at(at);
  found.mm3[static_cast<std::size_t>(axis)] = mm3;
  cells_.emplace_back(grid_.key(side, at), found);
}

void RowFound::link(Side side, Vec3 one, Vec3 other) {
  const Key from = grid_.key(side, one);
  const Key to = grid_.key(side, other);
  if (from != to) links_.emplace_back(from, to);
}

void RowFound::settle() {
  sum_equal(cells_);
  cells_.shrink_to_fit();  // of the points of all rows together there may be a gigabyte
}

void RegionFinder::take(RowFound&& row) {
  cells_.insert(cells_.end(), row.cells_.begin(), row.cells_.end());
  cuts_.insert(cuts_.end(), row.cuts_.begin(), row.cuts_.end());
  links_.insert(links_.end(), row.links_.begin(), row.links_.end());
  row.cells_ = {};
  row.cuts_ = {};
  row.links_ = {};
}

std::size_t RegionFinder::place_of(Key key) const {
  const auto at =
      std::lower_bound(cells_.begin(), cells_.end(), key,
                       [](const RowFound::Cell& cell, Key wanted) { return cell.first < wanted; });
  const bool is_there = at != cells_.end() && at->first == key;
  return is_there ? static_cast<std::size_t>(at - cells_.begin()) : cells_.size();
}

std::size_t RegionFinder::root(std::size_t cell) {
  while (parents_[cell] != cell) cell = parents_[cell] = parents_[parents_[cell]];
  return cell;
}

// The lower one is the root: so it does not matter who came first.
void RegionFinder::unite(std::size_t one, std::size_t other) {
  const std::size_t a = root(one);
  const std::size_t b = root(other);
  parents_[std::max(a, b)] = std::min(a, b);
}

// Each cell with the 13 neighbours whose keys are smaller; those of one row in one search.
void RegionFinder::join_neighbours() {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Key key = cells_[i].first;
    const Key x = key & kMask;
    const Key y = key / kOneY & kMask;
    const Key z = key / kOneZ & kMask;
    for (int dz = -1; dz <= 0; ++dz) {
      for (int dy = -1; dy <= (dz < 0 ? 1 : 0); ++dy) {
        if ((dz < 0 && z == 0) || (dy < 0 && y == 0) || (dy > 0 && y == kMask)) continue;
        Key row = key - (dz < 0 ? kOneZ : 0);
        row = dy < 0 ? row - kOneY : dy > 0 ? row + kOneY : row;
        const Key first = x > 0 ? row - kOneX : row;
        const Key last = dz == 0 && dy == 0 ? key : x < kMask ? row + kOneX : row;
        auto at = std::lower_bound(
            cells_.begin(), cells_.end(), first,
            [](const RowFound::Cell& cell, Key wanted) { return cell.first < wanted; });
        for (; at != cells_.end() && at->first <= last; ++at)
          unite(i, static_cast<std::size_t>(at - cells_.begin()));
      }
    }
  }
}

std::vector<Region> RegionFinder::find() {
  sum_equal(cells_);
  parents_.resize(cells_.size());
  std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  join_neighbours();
  for (const auto& [one, other] : links_) {
    const std::size_t a = place_of(one);
    const std::size_t b = place_of(other);
    if (a < cells_.size() && b < cells_.size()) unite(a, b);
  }
  std::vector<std::uint32_t> region_of_cell(cells_.size());
  std::vector<CellFound> sums;
  std::vector<Side> sides;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const auto& [key, found] = cells_[i];
    const std::size_t of = root(i);
    if (of == i) {
      region_of_cell[i] = static_cast<std::uint32_t>(sums.size());
      sums.push_back(found);
      sides.push_back(key >> (3 * kBits) == 0 ? Side::gouge : Side::excess);
    } else {
      region_of_cell[i] = region_of_cell[of];
      sums[region_of_cell[of]].add(found);
    }
  }
  std::vector<Region> regions;
  for (std::size_t i = 0; i < sums.size(); ++i) regions.push_back(region_of(sides[i], sums[i]));
  place_extremes(regions, region_of_cell);
  add_motions(regions, region_of_cell, sums);
  return regions;
}

// A floor that is too deep is so everywhere: it is shown in its middle.
void RegionFinder::place_extremes(std::vector<Region>& regions,
                                  const std::vector<std::uint32_t>& region_of) const {
  const auto square_to_centre = [](Vec3 at, const Region& region) {
    const Vec3 away = at - region.centre;
    return dot(away, away);
  };
  std::vector<double> nearest(regions.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const CellFound& found = cells_[i].second;
    Region& region = regions[region_of[i]];
    if (found.max_mm < kAsLarge * region.max_mm) continue;
    const double square = square_to_centre(found.at, region);
    if (square >= nearest[region_of[i]]) continue;
    nearest[region_of[i]] = square;
    region.at = found.at;
  }
}

// By what the one solid shows of it; where it shows nothing that was cut, by what is nearest to the
// other.
void RegionFinder::add_motions(std::vector<Region>& regions,
                               const std::vector<std::uint32_t>& region_of,
                               const std::vector<CellFound>& of_regions) const {
  struct Sum {
    std::uint32_t region;
    bool is_there;
    bool is_other;  // the point is not of the solid that the motion cut
    std::uint32_t motion;
    double mm2;
    [[nodiscard]] auto key() const { return std::tuple(region, is_there, is_other, motion); }
  };
  std::vector<Sum> sums;
  sums.reserve(cuts_.size());
  for (const RowFound::Cut& cut : cuts_) {
    const bool is_other = cut.is_design != cut.is_there;
    sums.push_back(
        {region_of[place_of(cut.key)], cut.is_there, is_other, cut.motion, double{cut.mm2}});
  }
  std::stable_sort(sums.begin(), sums.end(),
                   [](const Sum& a, const Sum& b) { return a.key() < b.key(); });
  std::array<std::vector<bool>, 2> has_own{std::vector<bool>(regions.size()),
                                           std::vector<bool>(regions.size())};
  for (std::size_t i = 0; i < sums.size();) {
    Sum sum = sums[i];
    for (++i; i < sums.size() && sums[i].key() == sum.key(); ++i) sum.mm2 += sums[i].mm2;
    auto own = has_own[sum.is_there ? 1 : 0][sum.region];
    if ((sum.is_other && own) || !(sum.mm2 > 0)) continue;
    if (!sum.is_other) own = true;
    const CellFound& all = of_regions[sum.region];
    const bool is_design = sum.is_other != sum.is_there;
    Region& region = regions[sum.region];
    (sum.is_there ? region.there : region.motions)
        .push_back({sum.motion, sum.mm2 / (is_design ? all.design_mm2 : all.area_mm2)});
  }
}

}  // namespace kerf::stock::compare
