#include "features/rewrite/line_cells.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Region;

constexpr double kOnEnd_mm = 3e-3;      // a line that goes along the end of a region
constexpr double kShortestStep = 0.02;  // of a step: what is left behind the last line
constexpr std::size_t kMostLines = 20'000;

/// Parts of all lines, and which of them belong to a cell already.
class CellFinder {
 public:
  CellFinder(const Region& region, const Ruling& ruling, const std::vector<double>& lines) {
    for (const double line : lines) {
      parts_.emplace_back();
      for (const Interval& part : parts_of_line(region, ruling, line)) {
        if (part.to - part.from > kSamePoint_mm) parts_.back().push_back({{line, part}, false});
      }
    }
  }

  [[nodiscard]] std::vector<Cell> find() {
    std::vector<Cell> cells;
    for (std::size_t line = 0; line < parts_.size(); ++line) {
      for (std::size_t place = 0; place < parts_[line].size(); ++place) {
        if (!parts_[line][place].is_taken) cells.push_back(follow(line, place));
      }
    }
    return cells;
  }

 private:
  struct Part {
    NewPass pass{};
    bool is_taken = false;
  };

  [[nodiscard]] Cell follow(std::size_t line, std::size_t place) {
    Cell cell;
    for (;;) {
      parts_[line][place].is_taken = true;
      cell.push_back(parts_[line][place].pass);
      if (line + 1 == parts_.size()) return cell;
      const auto next = only_beside(line + 1, cell.back());
      if (!next || parts_[line + 1][*next].is_taken ||
          !only_beside(line, parts_[line + 1][*next].pass))
        return cell;
      ++line;
      place = *next;
    }
  }

  // The part of a line that lies beside a pass, if it is one alone.
  [[nodiscard]] std::optional<std::size_t> only_beside(std::size_t line,
                                                       const NewPass& pass) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < parts_[line].size(); ++i) {
      const Interval& part = parts_[line][i].pass.part;
      if (std::min(part.to, pass.part.to) < std::max(part.from, pass.part.from)) continue;
      if (found) return std::nullopt;
      found = i;
    }
    return found;
  }

  std::vector<std::vector<Part>> parts_{};
};

double snapped(double gap) { return gap < kOnEnd_mm ? 0 : gap; }

}  // namespace

std::vector<double> new_lines(const OldLines& old, const Region& before, const Region& now,
                              bool reaches_end) {
  const Interval was = before.is_empty() ? Interval{old.lines.front(), old.lines.back()}
                                         : lines_across(before, old.ruling);
  const Interval is = lines_across(now, old.ruling);
  const double first = is.from + snapped(old.lines.front() - was.from);
  const double gap = snapped(was.to - old.lines.back());
  const bool ends_short = old.lines.size() > 2 &&
                          old.lines.back() - old.lines[old.lines.size() - 2] < old.step - kOnEnd_mm;
  std::vector<double> steps;
  for (std::size_t i = 0; i + (ends_short ? 1 : 0) < old.lines.size(); ++i)
    steps.push_back(old.lines[i] - old.lines.front());
  std::vector<double> lines;
  for (std::size_t i = 0; lines.size() < kMostLines; ++i) {
    const double at = first + (i < steps.size() ? steps[i] : (lines.back() - first) + old.step);
    if (at > is.to + kOnEnd_mm / 2) break;
    lines.push_back(at);
  }
  const bool has_end = reaches_end || gap == 0;
  const double end = is.to - (reaches_end ? 0 : gap);
  if (has_end && (lines.empty() || end - lines.back() > kShortestStep * old.step))
    lines.push_back(end);
  if (has_end && end - lines.back() > 0) lines.back() = end;
  return lines;
}

std::vector<double> with_borders(std::vector<double> lines, const Region& region,
                                 const Ruling& ruling) {
  for (const contour::Contour& loop : region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
      const contour::Edge edge = contour::edge_of(loop, i);
      const double from = geometry::dot(edge.from, ruling.across);
      const bool is_along =
          edge.bulge == 0 && std::fabs(geometry::dot(edge.to, ruling.across) - from) < kOnEnd_mm;
      if (is_along) lines.push_back(from);
    }
  }
  std::sort(lines.begin(), lines.end());
  const auto same = [](double a, double b) { return b - a < kOnEnd_mm; };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  return lines;
}

std::vector<Cell> cells_of(const Region& region, const Ruling& ruling,
                           const std::vector<double>& lines) {
  return CellFinder(region, ruling, lines).find();
}

}  // namespace kerf::features
