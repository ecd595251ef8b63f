#include "training/cut_grid.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::training {
namespace {

using geometry::Vec3;

constexpr double kSmallestCell_mm = 1;

double nearest_share(Vec3 from, Vec3 to, Vec3 at) {
  const Vec3 way = to - from;
  const double square = dot(way, way);
  return square > 0 ? std::clamp(dot(at - from, way) / square, 0.0, 1.0) : 0;
}

Vec3 flat(Vec3 v) { return {v.x, v.y, 0}; }

}  // namespace

CutGrid::CutGrid(const std::vector<Cut>& cuts, double reach_mm, Takes takes)
    : cuts_(cuts),
      reach_mm_(reach_mm),
      takes_(takes),
      cell_mm_(std::max(kSmallestCell_mm, 4 * reach_mm)) {
  for (std::size_t i = 0; i < cuts_.size(); ++i) add(i);
}

std::size_t CutGrid::Hash::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int64_t part : {cell.x, cell.y, cell.z}) {
    hash ^= static_cast<std::uint64_t>(part);
    hash *= 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

// What takes all above it lies in columns: their height does not count.
CutGrid::Cell CutGrid::cell_of(Vec3 at) const {
  const auto number = [this](double v) {
    return static_cast<std::int64_t>(std::floor(v / cell_mm_));
  };
  return {number(at.x), number(at.y), takes_ == Takes::line ? number(at.z) : 0};
}

void CutGrid::add(std::size_t number) {
  const Cut& cut = cuts_[number];
  const Vec3 margin{reach_mm_, reach_mm_, reach_mm_};
  const Vec3 low{std::min(cut.from.x, cut.to.x), std::min(cut.from.y, cut.to.y),
                 std::min(cut.from.z, cut.to.z)};
  const Vec3 high{std::max(cut.from.x, cut.to.x), std::max(cut.from.y, cut.to.y),
                  std::max(cut.from.z, cut.to.z)};
  const Cell first = cell_of(low - margin);
  const Cell last = cell_of(high + margin);
  for (Cell cell = first; cell.x <= last.x; ++cell.x)
    for (cell.y = first.y; cell.y <= last.y; ++cell.y)
      for (cell.z = first.z; cell.z <= last.z; ++cell.z)
        cells_[cell].push_back(static_cast<std::uint32_t>(number));
}

bool CutGrid::reaches(const Cut& cut, Vec3 at) const {
  if (takes_ == Takes::line) {
    const double share = nearest_share(cut.from, cut.to, at);
    return length(cut.from + share * (cut.to - cut.from) - at) <= reach_mm_;
  }
  // Upright, its lower end is what counts.
  const double share = flat(cut.from) == flat(cut.to)
                           ? (cut.to.z < cut.from.z ? 1 : 0)
                           : nearest_share(flat(cut.from), flat(cut.to), flat(at));
  const Vec3 nearest = cut.from + share * (cut.to - cut.from);
  return length(flat(nearest) - flat(at)) <= reach_mm_ && nearest.z <= at.z + reach_mm_;
}

bool CutGrid::takes_away(Vec3 at, const std::function<bool(std::size_t)>& agrees) const {
  const auto found = cells_.find(cell_of(at));
  if (found == cells_.end()) return false;
  return std::any_of(found->second.begin(), found->second.end(), [&](std::uint32_t number) {
    return reaches(cuts_[number], at) && agrees(number);
  });
}

}  // namespace kerf::training
