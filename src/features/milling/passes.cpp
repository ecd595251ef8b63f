#include "features/milling/passes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

constexpr double kParallel_rad = std::numbers::pi / 180;
constexpr std::size_t kLeastRun = 3;  // passes that go on to one side, where there are loops

/// A straight row: its length, direction, and distance of its line from the origin.
struct Line {
  Vec2 direction;
  double length = 0;
  double offset = 0;
};

// Directions count by their lines: there and back are one.
double angle_of(Vec2 direction) {
  double angle = math::atan2(direction.v, direction.u);
  if (angle < 0) angle += std::numbers::pi;
  return angle >= std::numbers::pi - kParallel_rad / 2 ? 0 : angle;
}

std::vector<Line> lines_of(const Recording& recording, const std::vector<std::uint32_t>& rows) {
  std::vector<Line> lines;
  for (const std::uint32_t row : rows) {
    if (recording.moves[row].shape != Move::Shape::line) continue;
    const Vec2 way = recording.flat_to(row) - recording.flat_from(row);
    const double length = geometry::length(way);
    if (length > kSamePoint_mm) lines.push_back({(1 / length) * way, length, 0});
    if (length > kSamePoint_mm)
      lines.back().offset = geometry::cross(lines.back().direction, recording.flat_from(row));
  }
  return lines;
}

/// The direction that most of the length has.
Vec2 main_direction(const std::vector<Line>& lines) {
  std::map<std::int64_t, double> by_angle;
  for (const Line& line : lines)
    by_angle[std::llround(angle_of(line.direction) / kParallel_rad)] += line.length;
  const auto most = std::max_element(by_angle.begin(), by_angle.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  const double angle = static_cast<double>(most->first) * kParallel_rad;
  return {math::cos(angle), math::sin(angle)};
}

/// The passes along a direction: lines of one offset after each other are one.
struct Pass {
  double offset = 0;
  double length = 0;
  bool is_forwards = true;
};

std::vector<Pass> passes_along(const std::vector<Line>& lines, Vec2 direction) {
  std::vector<Pass> passes;
  for (const Line& line : lines) {
    if (std::fabs(geometry::cross(line.direction, direction)) > 1.5 * kParallel_rad) continue;
    const bool is_forwards = geometry::dot(line.direction, direction) > 0;
    const double offset = is_forwards ? line.offset : -line.offset;
    const bool goes_on = !passes.empty() && passes.back().is_forwards == is_forwards &&
                         std::fabs(passes.back().offset - offset) <= 10 * kSamePoint_mm;
    if (!goes_on) passes.push_back({offset, 0, is_forwards});
    passes.back().length += line.length;
  }
  return passes;
}

/// The first pass behind a run of passes from `begin` on that all go on to one side.
std::size_t end_of_run(const std::vector<Pass>& passes, std::size_t begin) {
  std::size_t end = begin + 1;
  const auto step = [&](std::size_t i) { return passes[i].offset - passes[i - 1].offset; };
  while (end < passes.size() && (end == begin + 1 || (step(end) > 0) == (step(begin + 1) > 0)))
    ++end;
  return end;
}

/// Length of the passes that go on to one side, at least so many in a row, and their steps.
double length_going_on(const std::vector<Pass>& passes, std::size_t least,
                       std::vector<double>& steps) {
  double sum = 0;
  for (std::size_t begin = 0; begin + 1 < passes.size();) {
    const std::size_t end = end_of_run(passes, begin);
    const bool counts = end - begin >= least;
    for (std::size_t i = begin; counts && i < end; ++i) {
      sum += passes[i].length;
      if (i > begin) steps.push_back(std::fabs(passes[i].offset - passes[i - 1].offset));
    }
    begin = counts ? end : end - 1;
  }
  return sum;
}

}  // namespace

LinePasses line_passes_of(const Recording& recording, const ShapedLevel& shaped) {
  LinePasses found;
  const std::vector<std::uint32_t> rows = shaped.level.rows(recording);
  found.is_one_way = shaped.level.runs.size() == 1;
  const std::vector<Line> lines = lines_of(recording, rows);
  if (lines.size() < 2) return found;
  double all = 0;
  for (const std::uint32_t row : rows) all += recording.length_of(row);
  const std::vector<Pass> passes = passes_along(lines, main_direction(lines));
  const std::size_t least = shaped.loops.loops.empty() ? 2 : kLeastRun;
  const double going_on = length_going_on(passes, least, found.steps);
  found.clears = going_on > all / 2;
  const auto forwards = std::count_if(passes.begin(), passes.end(),
                                      [](const Pass& pass) { return pass.is_forwards; });
  found.goes_both_ways = forwards > 0 && forwards < static_cast<std::ptrdiff_t>(passes.size());
  return found;
}

}  // namespace kerf::features
