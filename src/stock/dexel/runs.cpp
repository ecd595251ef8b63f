#include "stock/dexel/runs.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace kerf::stock::dexel {
namespace {

// Cuts of solids that a run may have: LateNormals has room for them.
constexpr std::size_t kMostCutsOfRun = 1U << 15;
// How far strokes may go along the dexels, as a share of the tool's radius: there each of them
// leaves something to the next one, and few pass over all that another one does.
constexpr double kFarthestAlong = 0.5;

/// What it removes is counted by other dexels than those along this axis.
bool is_for_run(const Task& task, int axis) {
  return axis != task.main_axis && task.cuts() &&
         !std::holds_alternative<TurningWay>(task.sweep->way);
}

/// How far strokes go along the dexels.
struct Along {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(const Task& task, int axis) {
    for (const Stroke& stroke : task.strokes) {
      const double from = on_axis(stroke.from, axis);
      const double to = from + on_axis(stroke.way, axis);
      low = std::min({low, from, to});
      high = std::max({high, from, to});
    }
  }
};

}  // namespace

std::size_t run_of(std::span<const Task> tasks, std::span<const std::uint32_t> numbers, int axis) {
  const Task& first = tasks[numbers.front()];
  if (!is_for_run(first, axis)) return 1;
  const std::size_t most = kMostCutsOfRun / first.posed->solids.size();
  const double farthest = kFarthestAlong * first.posed->tool->widest_edge;
  std::size_t strokes = 0;
  std::size_t count = 0;
  Along along;
  for (const std::uint32_t number : numbers) {
    const Task& next = tasks[number];
    strokes += next.strokes.size();
    along.add(next, axis);
    const bool is_alike = next.posed == first.posed && is_for_run(next, axis);
    const bool is_far = along.high - along.low > farthest;
    if (count > 0 && (!is_alike || is_far || strokes > most)) break;
    ++count;
  }
  return count;
}

std::vector<RunWork::Step> run_steps(std::span<const Task> tasks,
                                     std::span<const std::uint32_t> numbers) {
  std::vector<RunWork::Step> steps;
  for (const std::uint32_t number : numbers) {
    bool follows = tasks[number].follows;
    for (const Stroke& stroke : tasks[number].strokes) {
      steps.push_back({&stroke, tasks[number].sweep->motion, follows});
      follows = true;
    }
  }
  return steps;
}

}  // namespace kerf::stock::dexel
