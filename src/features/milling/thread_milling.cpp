#include "features/milling/thread_milling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

constexpr double kLeastTurn = 0.9;  // half turns that make a helix a thread

bool is_rapid_row(const Recording& recording, std::uint32_t row) {
  return recording.moves[row].kind == Move::Kind::rapid;
}

bool is_sloping_arc(const Recording& recording, std::uint32_t row) {
  return recording.moves[row].shape == Move::Shape::arc &&
         std::fabs(recording.moves[row].to.z - recording.from(row).z) > kSameZ_mm;
}

/// Arcs about one centre, one after the other, that go on along Z.
struct Turns {
  Vec2 centre{};
  double radius = 0;
  double sweep = 0;
  double rise = 0;
  double low = 0;
  double high = 0;

  [[nodiscard]] bool goes_on(Vec2 about, double with_radius) const {
    return sweep > 0 && geometry::length(about - centre) <= kSamePoint_mm &&
           std::fabs(with_radius - radius) <= kSamePoint_mm;
  }
};

Turns turns_of(const Recording& recording, std::uint32_t row) {
  const ArcRow& arc = recording.arc_of(row);
  const double from = recording.from(row).z;
  const double to = recording.moves[row].to.z;
  return {.centre = arc.centre,
          .radius = geometry::length(recording.flat_from(row) - arc.centre),
          .sweep = std::fabs(arc.sweep_rad),
          .rise = std::fabs(to - from),
          .low = std::min(from, to),
          .high = std::max(from, to)};
}

// Leading in and out by arcs of their own goes along Z, too; the thread turns most.
Turns longest_helix(const Recording& recording, Span rows) {
  Turns longest;
  Turns now;
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (!is_sloping_arc(recording, row)) continue;
    const Turns more = turns_of(recording, row);
    if (now.goes_on(more.centre, more.radius)) {
      now.sweep += more.sweep;
      now.rise += more.rise;
      now.low = std::min(now.low, more.low);
      now.high = std::max(now.high, more.high);
    } else {
      now = more;
    }
    if (now.sweep > longest.sweep) longest = now;
  }
  return longest;
}

ThreadRun run_of(const Recording& recording, Span rows, Span visit) {
  const Turns turns = longest_helix(recording, rows);
  ThreadRun run{.helix = {.rows = rows, .visit = visit}};
  run.is_found = turns.sweep > kLeastTurn * std::numbers::pi && turns.rise > kSameZ_mm;
  if (!run.is_found) return run;
  run.helix.centre = turns.centre;
  run.helix.radius = turns.radius;
  run.helix.pitch = turns.rise * 2 * std::numbers::pi / turns.sweep;
  run.helix.top = turns.high;
  run.helix.bottom = turns.low;
  return run;
}

}  // namespace

std::vector<ThreadRun> thread_runs_of(const Recording& recording, const Operation& operation) {
  std::vector<ThreadRun> runs;
  const std::uint32_t end = operation.rows.last + 1;
  std::uint32_t approach = operation.rows.first;
  for (std::uint32_t row = operation.rows.first; row < end;) {
    if (is_rapid_row(recording, row)) {
      ++row;
      continue;
    }
    const std::uint32_t first = row;
    while (row < end && !is_rapid_row(recording, row)) ++row;
    const std::uint32_t last = std::min(row, end - 1);
    runs.push_back(run_of(recording, {first, row - 1}, {approach, last}));
    approach = last + 1;
    row = std::max(row, approach);
  }
  return runs;
}

}  // namespace kerf::features
