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
// Of the length where there are loops: the round that closes a small pocket may be longer than the
// passes, and loops alone do not go on to one side.
constexpr double kShareBesideRound = 1.0 / 3;

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

/// Passes that go on to one side, at least so many in a row, none farther from the last one than
/// the tool is wide: what is between them is cut.
class GoingOn {
 public:
  GoingOn(const std::vector<Pass>& passes, std::size_t least, double diameter)
      : passes_(passes), widest_(diameter + kSamePoint_mm) {
    for (std::size_t begin = 0; begin + 1 < passes_.size();) {
      const std::size_t end = end_of_run(begin);
      const bool counts = end - begin >= least;
      if (counts) count(begin, end);
      begin = counts || end == begin + 1 ? end : end - 1;
    }
  }

  [[nodiscard]] double length() const { return forwards_mm_ + backwards_mm_; }
  [[nodiscard]] bool goes_both_ways() const {
    return std::min(forwards_mm_, backwards_mm_) > kOtherWay * length();
  }
  [[nodiscard]] const std::vector<double>& steps() const { return steps_; }

 private:
  static constexpr double kOtherWay = 0.2;  // of the length: more than a closing round has

  [[nodiscard]] double step(std::size_t i) const {
    return passes_[i].offset - passes_[i - 1].offset;
  }
  // The first pass behind the run that begins there.
  [[nodiscard]] std::size_t end_of_run(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < passes_.size() && std::fabs(step(end)) <= widest_ &&
           (end == begin + 1 || (step(end) > 0) == (step(begin + 1) > 0)))
      ++end;
    return end;
  }
  void count(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      (passes_[i].is_forwards ? forwards_mm_ : backwards_mm_) += passes_[i].length;
      if (i > begin) steps_.push_back(std::fabs(step(i)));
    }
  }

  const std::vector<Pass>& passes_;
  double widest_;
  double forwards_mm_ = 0;
  double backwards_mm_ = 0;
  std::vector<double> steps_;
};

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
  const bool has_loops = !shaped.loops.loops.empty();
  const GoingOn going_on(passes, has_loops ? kLeastRun : 2, 2 * shaped.level.radius);
  found.clears = going_on.length() > all * (has_loops ? kShareBesideRound : 0.5);
  found.goes_both_ways = going_on.goes_both_ways();
  found.steps = going_on.steps();
  return found;
}

}  // namespace kerf::features
