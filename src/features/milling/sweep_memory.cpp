#include "features/milling/sweep_memory.hpp"

#include <algorithm>
#include <bit>

#include "features/milling/level.hpp"
#include "features/milling/long_sweep.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Region;
using contour::Vertex;

std::uint64_t mixed(std::uint64_t hash, double value) {
  hash ^= std::bit_cast<std::uint64_t>(value + 0.0);
  hash *= 0x9e3779b97f4a7c15U;
  return hash ^ (hash >> 29U);
}

std::uint64_t hash_of(const std::vector<Contour>& paths, double radius) {
  std::uint64_t hash = mixed(paths.size(), radius);
  for (const Contour& path : paths) {
    for (const Vertex& vertex : path.vertices)
      hash = mixed(mixed(mixed(hash, vertex.point.u), vertex.point.v), vertex.bulge);
  }
  return hash;
}

bool is_same(const Vertex& a, const Vertex& b) { return a.point == b.point && a.bulge == b.bulge; }

bool are_same_paths(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return std::equal(p.vertices.begin(), p.vertices.end(), q.vertices.begin(), q.vertices.end(),
                      is_same);
  });
}

/// Which row of the new paths has the part of a row of the old ones.
std::map<std::uint32_t, std::uint32_t> rows_for(const std::vector<Contour>& old,
                                                const std::vector<Contour>& paths) {
  std::map<std::uint32_t, std::uint32_t> rows;
  for (std::size_t i = 0; i < old.size(); ++i) {
    for (std::size_t k = 0; k < old[i].vertices.size(); ++k)
      rows.emplace_hint(rows.end(), old[i].vertices[k].owner, paths[i].vertices[k].owner);
  }
  return rows;
}

Region owned_by(Region region, const std::map<std::uint32_t, std::uint32_t>& rows) {
  for (Contour& loop : region.loops) {
    for (Vertex& vertex : loop.vertices) {
      const auto row = rows.find(vertex.owner);
      if (row != rows.end()) vertex.owner = row->second;
    }
  }
  return region;
}

}  // namespace

// What is wanted again is mostly what was made last, and all of many is too much.
void SweepMemory::make_room() {
  if (vertices_ < kMostVertices) return;
  known_.clear();
  vertices_ = 0;
}

std::optional<Region> SweepMemory::sweep_of(const Recording& recording,
                                            const std::vector<LevelRun>& runs, double radius) {
  std::vector<Contour> paths;
  for (const LevelRun& run : runs) paths.push_back(path_of(recording, run));
  make_room();
  Known& known = known_[hash_of(paths, radius)];
  if (known.radius == radius && are_same_paths(known.paths, paths))
    return owned_by(known.region, rows_for(known.paths, paths));
  for (const Contour& path : paths) vertices_ += path.vertices.size();
  auto region = swept_along(paths, radius, allowance_);
  if (!region) return std::nullopt;
  known.region = std::move(*region);
  known.paths = std::move(paths);
  known.radius = radius;
  return known.region;
}

}  // namespace kerf::features
