#include "features/milling/cut_tiles.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "geometry/contour/boolean.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Region;
using contour::Vec2;

constexpr double kTile_mm = 50;
constexpr double kMostTiles = 4096;  // of one cut
constexpr std::size_t kMostPending = 8;

/// The tiles of a box: columns and rows, from the first to the last one.
struct Range {
  double low_u, high_u, low_v, high_v;

  explicit Range(const Box& box)
      : low_u(std::floor(box.low.u / kTile_mm)),
        high_u(std::floor(box.high.u / kTile_mm)),
        low_v(std::floor(box.low.v / kTile_mm)),
        high_v(std::floor(box.high.v / kTile_mm)) {}
  [[nodiscard]] bool is_wide() const {
    return !((high_u - low_u + 1) * (high_v - low_v + 1) <= kMostTiles) ||
           std::max(std::fabs(low_u), std::fabs(high_u)) > 1e9 ||
           std::max(std::fabs(low_v), std::fabs(high_v)) > 1e9;
  }
  template <typename Visit>
  void each(Visit&& visit) const {
    for (double u = low_u; u <= high_u; ++u) {
      for (double v = low_v; v <= high_v; ++v)
        visit(static_cast<std::int32_t>(u), static_cast<std::int32_t>(v));
    }
  }
};

Region square(std::int32_t u, std::int32_t v) {
  const Vec2 low{u * kTile_mm, v * kTile_mm};
  const Vec2 high{(u + 1) * kTile_mm, (v + 1) * kTile_mm};
  return {{{{{low}, {{high.u, low.v}}, {high}, {{low.u, high.v}}}, true}}};
}

std::int64_t step_of(double z) { return std::llround(z / kSameZ_mm); }

}  // namespace

void CutTiles::add(const Shared& region, double z) {
  const Box box = contour::extents(*region);
  if (box.is_empty()) return;
  const Range range(box);
  if (range.is_wide()) {
    Level& level = wide_[step_of(z)];
    level.z = z;
    level.pending.push_back({region, box});
    return;
  }
  range.each([&](std::int32_t u, std::int32_t v) { add_to({u, v}, {region, box}, z); });
}

void CutTiles::add_to(const Place& place, const Cut& cut, double z) {
  Level& level = tiles_[place][step_of(z)];
  level.z = z;
  level.pending.push_back(cut);
  if (level.pending.size() <= kMostPending) return;
  std::vector<Region> all;
  for (const Cut& one : level.pending) all.push_back(*one.region);
  const Region inside = contour::intersect(contour::unite(all), square(place.first, place.second));
  level.merged = contour::unite(level.merged, inside);
  level.merged_box = contour::extents(level.merged);
  level.pending.clear();
}

// Each region once, in the order of the tiles, which is the same everywhere.
void CutTiles::take(const Levels& levels, const Box& box, std::map<std::int64_t, Depth>& depths) {
  for (const auto& [step, level] : levels) {
    std::vector<const Region*> found;
    if (level.merged_box.meets(box)) found.push_back(&level.merged);
    for (const Cut& cut : level.pending) {
      if (cut.box.meets(box)) found.push_back(cut.region.get());
    }
    if (found.empty()) continue;
    Depth& depth = depths[step];
    depth.z = level.z;
    for (const Region* const region : found) {
      if (std::find(depth.regions.begin(), depth.regions.end(), region) == depth.regions.end())
        depth.regions.push_back(region);
    }
  }
}

std::vector<CutTiles::Depth> CutTiles::at(const Box& box) const {
  std::map<std::int64_t, Depth> depths;
  take(wide_, box, depths);
  const Range range(box);
  if (range.is_wide()) {
    for (const auto& [place, levels] : tiles_) take(levels, box, depths);
  } else {
    range.each([&](std::int32_t u, std::int32_t v) {
      const auto tile = tiles_.find({u, v});
      if (tile != tiles_.end()) take(tile->second, box, depths);
    });
  }
  std::vector<Depth> found;
  for (auto& [step, depth] : depths) found.push_back(std::move(depth));
  return found;
}

}  // namespace kerf::features
