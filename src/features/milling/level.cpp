#include "features/milling/level.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "features/milling/sweep_memory.hpp"
#include "features/path/tolerance.hpp"
#include "geometry/contour/box_tree.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Contour;
using contour::Edge;

/// Which of many are connected.
class Groups {
 public:
  explicit Groups(std::size_t count) : head_(count) { std::iota(head_.begin(), head_.end(), 0U); }
  std::size_t head_of(std::size_t one) {
    while (head_[one] != one) one = head_[one] = head_[head_[one]];
    return one;
  }
  // The lower number stays the head.
  void join(std::size_t a, std::size_t b) {
    a = head_of(a);
    b = head_of(b);
    head_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> head_;
};

/// The numbers of all that are connected, lowest first.
std::vector<std::vector<std::size_t>> members_of(Groups& groups, std::size_t count) {
  std::map<std::size_t, std::vector<std::size_t>> by_head;
  for (std::size_t i = 0; i < count; ++i) by_head[groups.head_of(i)].push_back(i);
  std::vector<std::vector<std::size_t>> members;
  for (auto& [head, list] : by_head) members.push_back(std::move(list));
  return members;
}

// Groups of runs whose boxes meet, each as places in `runs`.
std::vector<std::vector<std::size_t>> near_runs(const Recording& recording,
                                                const std::vector<LevelRun>& runs, double radius) {
  if (runs.size() == 1) return {{0}};
  std::vector<Box> boxes;
  for (const LevelRun& run : runs)
    boxes.push_back(contour::extents(path_of(recording, run)).grown(radius));
  const contour::BoxTree tree(boxes);
  Groups groups(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i)
    tree.search(boxes[i], [&](std::uint32_t other) { groups.join(i, other); });
  return members_of(groups, runs.size());
}

/// The outer loops of a region, each with the holes in it.
std::vector<Region> connected_parts(const Region& region) {
  const auto parents = contour::parents(region);
  std::vector<Region> parts;
  std::map<std::size_t, std::size_t> part_of;
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    if (contour::is_counterclockwise(region.loops[i])) {
      part_of[i] = parts.size();
      parts.push_back({{region.loops[i]}});
    }
  }
  for (std::size_t i = 0; i < region.loops.size(); ++i) {
    if (parents[i] && !part_of.contains(i) && part_of.contains(*parents[i]))
      parts[part_of[*parents[i]]].loops.push_back(region.loops[i]);
  }
  return parts;
}

/// The level whose sweep a point lies in; as many as there are: none.
std::size_t level_with(const std::vector<Level>& levels, contour::Vec2 point) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (contour::side_of(levels[i].sweep, point, 0) == contour::Side::inside) return i;
  }
  return levels.size();
}

// The runs of one group as levels: as many as their sweep has connected parts. False: the allowance
// is over.
bool add_levels(const Recording& recording, std::vector<LevelRun> runs, const Level& like,
                SweepMemory& memory, std::vector<Level>& levels) {
  const auto sweep = memory.sweep_of(recording, runs, like.radius);
  if (!sweep) return false;
  std::vector<Region> parts = connected_parts(*sweep);
  std::vector<Level> found(parts.size(), like);
  for (std::size_t i = 0; i < parts.size(); ++i) found[i].sweep = std::move(parts[i]);
  // A run whose tool has no width there sweeps nothing, and is a level of its own.
  for (LevelRun& run : runs) {
    std::size_t part =
        found.size() == 1 ? 0 : level_with(found, recording.flat_from(run.rows.first));
    if (part >= found.size()) {
      part = found.size();
      found.push_back(like);
    }
    found[part].runs.push_back(std::move(run));
  }
  for (Level& level : found) {
    if (level.runs.empty()) continue;
    level.first_row = level.runs.front().visit.first;
    levels.push_back(std::move(level));
  }
  return true;
}

}  // namespace

std::vector<std::uint32_t> Level::rows(const Recording& recording) const {
  std::vector<std::uint32_t> list;
  for (const LevelRun& run : runs) {
    for (std::uint32_t row = run.rows.first; row <= run.rows.last; ++row) {
      if (recording.goes_across(row)) list.push_back(row);
    }
  }
  return list;
}

Contour path_of(const Recording& recording, const LevelRun& run) {
  std::vector<Edge> edges;
  for (std::uint32_t row = run.rows.first; row <= run.rows.last; ++row)
    recording.append_edges(row, edges);
  Contour path{{}, false};
  path.vertices.reserve(edges.size() + 1);
  for (const Edge& edge : edges) path.vertices.push_back({edge.from, edge.bulge, edge.owner});
  if (!edges.empty()) path.vertices.push_back({edges.back().to, 0, edges.back().owner});
  return path;
}

std::optional<std::vector<Level>> levels_of(const Recording& recording, std::size_t operation,
                                            const Operation& rows, const ToolReach& reach,
                                            const std::vector<LevelRun>& runs, double top,
                                            Allowance& allowance) {
  std::map<std::int64_t, std::vector<LevelRun>> by_z;
  for (const LevelRun& run : runs)
    by_z[static_cast<std::int64_t>(std::llround(run.z / kSameZ_mm))].push_back(run);
  SweepMemory memory(allowance);
  std::vector<Level> levels;
  for (auto level = by_z.rbegin(); level != by_z.rend(); ++level) {
    const std::vector<LevelRun>& at_z = level->second;
    Level like{.operation = operation, .tool = rows.tool, .setup = rows.setup};
    like.z = at_z.front().z;
    like.radius = reach.at_depth(top - like.z);
    for (const auto& group : near_runs(recording, at_z, like.radius)) {
      std::vector<LevelRun> members;
      for (const std::size_t place : group) members.push_back(at_z[place]);
      if (!add_levels(recording, std::move(members), like, memory, levels)) return std::nullopt;
    }
  }
  std::stable_sort(levels.begin(), levels.end(),
                   [](const Level& a, const Level& b) { return a.first_row < b.first_row; });
  return levels;
}

}  // namespace kerf::features
