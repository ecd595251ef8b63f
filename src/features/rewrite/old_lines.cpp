#include "features/rewrite/old_lines.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/rewrite/wall_index.hpp"
#include "features/tree/normal_form.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr std::size_t kMostTried = 16;        // rows whose direction may be that of the passes
constexpr std::size_t kMostRoundRows = 4000;  // of one way round
constexpr double kParallel = 5e-3;            // sine between lines that are parallel
constexpr double kBesideWall_mm = 0.01;       // how far ends of passes may differ from each other
constexpr double kSameLine_mm = 5e-3;         // between passes of one line
constexpr double kFar_mm = 1e9;

tl::unexpected<std::string> cannot_tell(const char* why) {
  return tl::unexpected(std::string(why));
}

/// Reads a layer row by row.
class LineReader {
 public:
  LineReader(const Recording& recording, const Layer& layer, Span visit, const Clearing& clearing)
      : recording_(recording),
        layer_(layer),
        visit_(visit),
        clearing_(clearing),
        sharp_{.region = clearing.region,
               .is_outside = clearing.is_outside,
               .tool_radius = clearing.tool_radius,
               .has_sharp_corners = true},
        walls_(clearing.region.loops.begin(), clearing.region.loops.end()) {}

  [[nodiscard]] tl::expected<OldLines, std::string> read() {
    for (std::uint32_t row = visit_.first; row <= visit_.last; ++row) {
      if (is_level(row)) level_.push_back(row);
    }
    if (const char* const why = take_rounds()) return cannot_tell(why);
    if (const char* const why = take_passes()) return cannot_tell(why);
    if (const char* const why = look_between()) return cannot_tell(why);
    look_at_lines();
    return std::move(old_);
  }

 private:
  [[nodiscard]] bool is_level(std::uint32_t row) const {
    return cuts_across_at(recording_, row, layer_.z);
  }

  // Ways round that are parallel to a wall all along, before the lines or behind them.
  [[nodiscard]] const char* take_rounds() {
    std::size_t end = level_.size();
    while (end > 0) {
      const auto round = round_to(end);
      if (!round) break;
      end -= rows_in(round->rows);
      old_.rounds_behind.insert(old_.rounds_behind.begin(), *round);
    }
    std::size_t begin = 0;
    while (begin < end) {
      const auto round = round_from(begin, end);
      if (!round) break;
      begin += rows_in(round->rows);
      old_.rounds_before.push_back(*round);
    }
    lines_.assign(level_.begin() + static_cast<std::ptrdiff_t>(begin),
                  level_.begin() + static_cast<std::ptrdiff_t>(end));
    return lines_.empty() ? "IT HAS NO PASSES" : nullptr;
  }
  [[nodiscard]] static std::size_t rows_in(Span rows) { return rows.last - rows.first + 1; }

  [[nodiscard]] std::optional<OldLoop> round_from(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, begin + kMostRoundRows); ++i) {
      if (level_[i] != level_[begin] + (i - begin)) break;
      if (auto round = round_of({level_[begin], level_[i]})) return round;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<OldLoop> round_to(std::size_t end) {
    for (std::size_t i = end; i-- > 0 && end - i < kMostRoundRows;) {
      if (level_[i] + (end - 1 - i) != level_[end - 1]) break;
      if (auto round = round_of({level_[i], level_[end - 1]})) return round;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<OldLoop> round_of(Span rows) {
    const Vec2 gap = recording_.flat_to(rows.last) - recording_.flat_from(rows.first);
    if (geometry::length(gap) > kSamePoint_mm) return std::nullopt;
    auto loops = old_loops(recording_, {rows}, clearing_.region.loops);
    return is_along_wall(loops.front()) ? std::optional(loops.front()) : std::nullopt;
  }

  [[nodiscard]] bool is_along_wall(const OldLoop& loop) {
    if (contour::edge_count(loop.path) < 2 || loop.distance < kSamePoint_mm) return false;
    const Contour path = normal_form(loop.path);
    if (has_loop(clearing_, loop.distance, path)) return true;
    if (!has_loop(sharp_, loop.distance, path)) return false;
    old_.has_sharp_corners = true;
    return true;
  }
  [[nodiscard]] static bool has_loop(const Clearing& clearing, double distance,
                                     const Contour& path) {
    const std::vector<Contour>& all = loops_at(clearing, distance);
    return std::any_of(all.begin(), all.end(), [&](const Contour& one) {
      return are_equal(normal_form(one), path, 4 * kSamePoint_mm);
    });
  }

  [[nodiscard]] const char* take_passes() {
    const auto along = main_direction();
    if (!along) return "IT HAS NO PASSES";
    old_.ruling.along = *along;
    for (const std::uint32_t row : lines_) add(row);
    if (old_.passes.size() < 2) return "IT HAS ONE PASS ALONE";
    if (!old_.passes.front().is_forwards) turn_round();
    old_.ruling.across = {-old_.ruling.along.v, old_.ruling.along.u};
    if (geometry::dot(old_.passes[1].from - old_.passes[0].from, old_.ruling.across) < 0)
      old_.ruling.across = {old_.ruling.along.v, -old_.ruling.along.u};
    for (OldPass& pass : old_.passes) pass.line = geometry::dot(pass.from, old_.ruling.across);
    return nullptr;
  }
  // Of the longest rows the one that most of all is parallel to.
  [[nodiscard]] std::optional<Vec2> main_direction() const {
    std::vector<std::uint32_t> rows;
    for (const std::uint32_t row : lines_) {
      if (is_line(row)) rows.push_back(row);
    }
    const auto end = rows.begin() + static_cast<std::ptrdiff_t>(std::min(rows.size(), kMostTried));
    std::partial_sort(rows.begin(), end, rows.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(-length(a), a) < std::pair(-length(b), b);
    });
    std::optional<Vec2> best;
    double most = 0;
    for (auto row = rows.begin(); row != end; ++row) {
      const Vec2 way = direction(*row);
      double sum = 0;
      for (const std::uint32_t other : rows)
        sum += std::fabs(geometry::cross(way, direction(other))) <= kParallel ? length(other) : 0;
      if (sum <= most + kSamePoint_mm) continue;
      best = way;
      most = sum;
    }
    return best;
  }

  void turn_round() {
    old_.ruling.along = Vec2{} - old_.ruling.along;
    for (OldPass& pass : old_.passes) pass.is_forwards = !pass.is_forwards;
  }

  [[nodiscard]] bool is_line(std::uint32_t row) const {
    return recording_.moves[row].shape == Move::Shape::line;
  }
  [[nodiscard]] double length(std::uint32_t row) const {
    return geometry::length(recording_.flat_to(row) - recording_.flat_from(row));
  }
  [[nodiscard]] Vec2 direction(std::uint32_t row) const {
    return geometry::unit(recording_.flat_to(row) - recording_.flat_from(row));
  }

  // Rows of one line and one sense, one behind the other, are one pass.
  void add(std::uint32_t row) {
    if (!is_line(row) || std::fabs(geometry::cross(old_.ruling.along, direction(row))) > kParallel)
      return;
    const bool is_forwards = geometry::dot(old_.ruling.along, direction(row)) > 0;
    const Vec2 from = recording_.flat_from(row);
    OldPass* const last = old_.passes.empty() ? nullptr : &old_.passes.back();
    const bool goes_on = last != nullptr && last->rows.last + 1 == row &&
                         last->is_forwards == is_forwards &&
                         geometry::length(last->to - from) <= kSamePoint_mm;
    if (!goes_on)
      return old_.passes.push_back({{row, row}, from, recording_.flat_to(row), 0, is_forwards});
    last->rows.last = row;
    last->to = recording_.flat_to(row);
  }

  [[nodiscard]] double off_walls(Vec2 point) const {
    double least = kFar_mm;
    for (const WallIndex& wall : walls_) least = wall.distance(point, least);
    return least;
  }

  [[nodiscard]] const char* look_between() {
    old_.distance = kFar_mm;
    for (const OldPass& pass : old_.passes)
      old_.distance = std::min({old_.distance, off_walls(pass.from), off_walls(pass.to)});
    for (const OldPass& pass : old_.passes) {
      const double most = std::max(off_walls(pass.from), off_walls(pass.to));
      if (most > old_.distance + kBesideWall_mm) return "ITS PASSES DO NOT ALL END BESIDE A WALL";
    }
    for (std::size_t i = 0; i + 1 < old_.passes.size(); ++i) {
      for (const std::uint32_t row : old_.between(i)) {
        if (!is_level(row)) continue;
        std::vector<Edge> edges;
        recording_.append_edges(row, edges);
        for (const Edge& edge : edges) {
          const double off = off_walls(contour::point_at(edge, 0.5));
          const bool is_along = std::fabs(off - old_.distance) <= kBesideWall_mm;
          if (!is_along && edge.bulge != 0) return "ITS PASSES ARE LINKED ON WAYS OF THEIR OWN";
          const bool is_alone = old_.between(i).size() == 1;
          old_.follows_walls = old_.follows_walls || (is_along && (edge.bulge != 0 || !is_alone));
        }
      }
    }
    return nullptr;
  }

  void look_at_lines() {
    for (const OldPass& pass : old_.passes) old_.lines.push_back(pass.line);
    std::sort(old_.lines.begin(), old_.lines.end());
    const auto same = [](double a, double b) { return std::fabs(a - b) <= kSameLine_mm; };
    old_.lines.erase(std::unique(old_.lines.begin(), old_.lines.end(), same), old_.lines.end());
    std::vector<double> steps;
    for (std::size_t i = 1; i < old_.lines.size(); ++i)
      steps.push_back(old_.lines[i] - old_.lines[i - 1]);
    if (steps.empty()) steps.push_back(clearing_.tool_radius);
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    old_.step = *middle;
    if (old_.rounds_before.empty() && old_.rounds_behind.empty()) measure_scallops();
  }

  // Between the ends of neighbours that nothing links.
  void measure_scallops() {
    const double radius = clearing_.tool_radius;
    for (std::size_t i = 0; i + 1 < old_.passes.size(); ++i) {
      const OldPass& pass = old_.passes[i];
      const OldPass& next = old_.passes[i + 1];
      const bool is_turned = pass.is_forwards != next.is_forwards;
      const double gap = geometry::length(pass.from - (is_turned ? next.to : next.from));
      const double half = std::min(gap / 2, radius);
      const double rest = radius - std::sqrt(radius * radius - half * half);
      if (std::fabs(next.line - pass.line) <= 2 * radius)
        old_.scallop = std::max(old_.scallop, rest);
    }
  }

  const Recording& recording_;
  const Layer& layer_;
  Span visit_;
  const Clearing& clearing_;
  Clearing sharp_;  // likewise, round corners of islands without arcs
  std::vector<WallIndex> walls_;
  std::vector<std::uint32_t> level_{};  // rows that cut at it
  std::vector<std::uint32_t> lines_{};  // but for the rounds
  OldLines old_{};
};

}  // namespace

bool OldLines::is_one_way() const {
  return std::all_of(passes.begin(), passes.end(),
                     [](const OldPass& pass) { return pass.is_forwards; });
}

std::vector<std::uint32_t> OldLines::between(std::size_t pass) const {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = passes[pass].rows.last + 1; row < passes[pass + 1].rows.first; ++row)
    rows.push_back(row);
  return rows;
}

tl::expected<OldLines, std::string> old_lines(const Recording& recording, const Layer& layer,
                                              Span visit, const Clearing& clearing) {
  return LineReader(recording, layer, visit, clearing).read();
}

}  // namespace kerf::features
