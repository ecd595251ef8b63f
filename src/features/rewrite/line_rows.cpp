#include "features/rewrite/line_rows.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/rewrite/line_cells.hpp"
#include "features/rewrite/old_lines.hpp"
#include "features/rewrite/visit_rows.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Region;

constexpr double kHair_mm = 5e-3;    // by which scallops may be deeper than the old ones
constexpr double kInside_mm = 5e-4;  // by which regions are taken larger, so that none vanishes

/// Writes one layer of parallel lines anew.
class LineWriter {
 public:
  LineWriter(const Recording& recording, const NewLayer& wanted, Span visit, double tool_radius,
             OldLines old)
      : recording_(recording),
        wanted_(wanted),
        layer_(wanted.feature->layers[wanted.layer]),
        visit_(visit),
        old_(std::move(old)),
        shift_(wanted.new_radius > 0 ? wanted.new_radius - tool_radius : 0),
        clearing_{.region = region_between(wanted.outer, wanted.islands),
                  .tool_radius = tool_radius + shift_,
                  .has_sharp_corners = old_.has_sharp_corners},
        distance_(old_.distance + shift_),
        room_(contour::offset(clearing_.region, -distance_)) {}

  [[nodiscard]] tl::expected<NewRows, CannotCut> write() {
    if (room_.is_empty()) return does_not_fit(wanted_.feature->tool);
    auto made = write_lines(Lines::as_before);
    if (is_left(made)) made = write_lines(Lines::to_the_end);
    if (is_left(made)) made = write_lines(Lines::along_borders);
    if (is_left(made) && !wanted_.allows_rest) return tl::unexpected(*made.left);
    return made;
  }

 private:
  /// What lines there are, if the ones before leave something.
  enum class Lines : std::uint8_t { as_before, to_the_end, along_borders };

  [[nodiscard]] static bool is_left(const NewRows& made) { return made.left.has_value(); }

  [[nodiscard]] NewRows write_lines(Lines which) {
    VisitRows rows(recording_, visit_, layer_.z);
    rows_ = &rows;
    has_begun_ = false;
    pass_ = 0;
    for (const OldLoop& round : old_.rounds_before) cut_rounds(round);
    for (const Cell& cell : cells(which)) cut(cell);
    for (const OldLoop& round : old_.rounds_behind) cut_rounds(round);
    rows.retract(last_old());
    NewRows made;
    look_for_rest(rows, made);
    made.stretch = rows.done();
    return made;
  }

  [[nodiscard]] std::vector<Cell> cells(Lines which) const {
    const Region before = contour::offset(old_region(), kInside_mm - old_.distance);
    std::vector<double> lines = new_lines(old_, before, room_, which != Lines::as_before);
    if (which == Lines::along_borders) lines = with_borders(std::move(lines), room_, old_.ruling);
    return cells_of(room_, old_.ruling, lines);
  }
  [[nodiscard]] Region old_region() const {
    return region_between(layer_.nominal, layer_.nominal_islands);
  }

  // The rows that the approach leads to, and behind which the tool goes up.
  [[nodiscard]] std::uint32_t first_old() const {
    const auto& rounds = old_.rounds_before;
    return rounds.empty() ? old_.passes.front().rows.first : rounds.front().rows.first;
  }
  [[nodiscard]] std::uint32_t last_old() const {
    const auto& rounds = old_.rounds_behind;
    return rounds.empty() ? old_.passes.back().rows.last : rounds.back().rows.last;
  }

  void cut(const Cell& cell) {
    bool is_forwards = true;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Vec2 low = old_.ruling.point(cell[i].part.from, cell[i].line);
      const Vec2 high = old_.ruling.point(cell[i].part.to, cell[i].line);
      begin(is_forwards ? low : high, i > 0);
      rows_->go_straight(is_forwards ? high : low, like_pass().rows.first);
      ++pass_;
      if (!old_.is_one_way()) is_forwards = !is_forwards;
    }
  }
  [[nodiscard]] const OldPass& like_pass() const {
    return old_.passes[std::min(pass_, old_.passes.size() - 1)];
  }

  // To where a pass begins: behind the last one as the old ones followed each other, or into
  // another cell.
  void begin(Vec2 start, bool follows) {
    if (!has_begun_) {
      rows_->approach(first_old(), start);
      has_begun_ = true;
      return;
    }
    if (!follows) {
      if (pass_ == 0 && !old_.rounds_before.empty())
        return change(start, old_.passes.front().rows.first);
      return rows_->go_over(start, first_old(), last_old());
    }
    const std::size_t gap = std::min(pass_ - 1, old_.passes.size() - 2);
    if (goes_up(old_.between(gap))) return go_as_between(gap, start);
    link(start, old_.between(gap));
  }

  [[nodiscard]] bool goes_up(const std::vector<std::uint32_t>& rows) const {
    return std::any_of(rows.begin(), rows.end(), [&](std::uint32_t row) {
      return recording_.moves[row].to.z > layer_.z + kSameZ_mm;
    });
  }

  void go_as_between(std::size_t gap, Vec2 start) {
    const std::vector<std::uint32_t> rows = old_.between(gap);
    rows_->go_like({rows.front(), rows.back()}, old_.passes[gap].to, old_.passes[gap + 1].from,
                   start);
  }

  void link(Vec2 start, const std::vector<std::uint32_t>& rows) {
    const std::uint32_t like = rows.empty() ? like_pass().rows.first : rows.front();
    if (geometry::length(start - rows_->at()) <= kSamePoint_mm) return;
    if (!old_.follows_walls && is_clear_between(rows_->at(), start))
      return rows_->go_straight(start, like);
    if (const auto way = along_wall(rows_->at(), start)) return rows_->go_along(*way, like);
    if (is_clear_between(rows_->at(), start)) return rows_->go_straight(start, like);
    rows_->go_over(start, first_old(), last_old());
  }

  // As far from the walls as the passes.
  [[nodiscard]] bool is_clear_between(Vec2 from, Vec2 to) const {
    const Clearing narrow{.region = clearing_.region, .tool_radius = distance_ - kSamePoint_mm};
    return is_clear(narrow, from, to);
  }

  // The shorter way along the border of where the centre may be.
  [[nodiscard]] std::optional<Contour> along_wall(Vec2 from, Vec2 to) const {
    std::optional<Contour> best;
    for (const Contour& loop : room_.loops) {
      if (contour::distance(loop, from) > kSamePoint_mm ||
          contour::distance(loop, to) > kSamePoint_mm)
        continue;
      for (const Contour& way : {loop, contour::reversed(loop)}) {
        Contour part = part_between(way, from, to);
        if (!best || contour::length(part) < contour::length(*best)) best = std::move(part);
      }
    }
    return best;
  }
  [[nodiscard]] static Contour part_between(const Contour& loop, Vec2 from, Vec2 to) {
    const Contour begun = begun_beside(loop, from);
    const contour::Place end = contour::nearest_place(begun, to);
    Contour part{{}, false};
    for (std::size_t i = 0; i < end.edge; ++i) part.vertices.push_back(begun.vertices[i]);
    const contour::Edge edge = contour::edge_of(begun, end.edge);
    if (end.share > 1e-9) {
      const contour::Edge last = contour::part(edge, 0, end.share);
      part.vertices.push_back({last.from, last.bulge, last.owner});
    }
    part.vertices.push_back({to, 0, edge.owner});
    return part;
  }

  // All rounds of one distance, the nearest one next.
  void cut_rounds(const OldLoop& old) {
    const double distance = old.distance + shift_;
    std::vector<Contour> loops = loops_at(clearing_, distance);
    const bool is_reversed = contour::is_counterclockwise(old.path) != runs_counterclockwise(old);
    if (!is_first_of_its_distance(old)) return;
    while (!loops.empty()) {
      const Vec2 near = has_begun_ ? rows_->at() : old.path.vertices.front().point;
      const auto next = std::min_element(loops.begin(), loops.end(), [&](auto& a, auto& b) {
        return contour::distance(a, near) < contour::distance(b, near);
      });
      const Contour loop = begun(is_reversed ? contour::reversed(*next) : *next, old);
      loops.erase(next);
      const Vec2 start = loop.vertices.front().point;
      has_begun_ ? change(start, old.rows.first) : rows_->approach(first_old(), start);
      has_begun_ = true;
      rows_->go_along(loop, old.rows.first);
    }
  }

  // Rounds about islands are of the same distance: they are cut with the first one.
  [[nodiscard]] bool is_first_of_its_distance(const OldLoop& old) const {
    for (const auto* const rounds : {&old_.rounds_before, &old_.rounds_behind}) {
      for (const OldLoop& other : *rounds) {
        if (&other == &old) return true;
        const bool is_here = &old >= rounds->data() && &old < rounds->data() + rounds->size();
        if (is_here && std::fabs(other.distance - old.distance) <= 2 * kSamePoint_mm) return false;
      }
    }
    return true;
  }

  // Where the last pass ended, if the old one began there.
  [[nodiscard]] Contour begun(const Contour& loop, const OldLoop& old) const {
    const Vec2 start = old.path.vertices.front().point;
    const bool goes_on = geometry::length(start - old_.passes.back().to) <= kSamePoint_mm;
    const bool is_there = has_begun_ && contour::distance(loop, rows_->at()) <= kSamePoint_mm;
    if (goes_on && is_there) return begun_beside(loop, rows_->at());
    return begun_like(loop, old);
  }

  // What a loop at the distance of an old one would do by itself.
  [[nodiscard]] bool runs_counterclockwise(const OldLoop& old) const {
    const Vec2 at = old.path.vertices.front().point;
    const double to_outer = contour::distance(layer_.nominal, at);
    return std::none_of(layer_.nominal_islands.begin(), layer_.nominal_islands.end(),
                        [&](const Contour& island) {
                          return contour::distance(island, at) < to_outer - kSamePoint_mm;
                        });
  }

  /// Rows that led from a part of the old layer to the next one.
  struct OldChange {
    std::vector<std::uint32_t> rows{};
    Vec2 from{};
    Vec2 to{};
  };
  [[nodiscard]] OldChange before(std::uint32_t first) const {
    OldChange change{.from = recording_.flat_from(first), .to = recording_.flat_from(first)};
    std::uint32_t row = first;
    while (row > first_old() && !is_of_part(row - 1))
      change.rows.insert(change.rows.begin(), --row);
    if (!change.rows.empty()) change.from = recording_.flat_from(change.rows.front());
    return change;
  }
  [[nodiscard]] bool is_of_part(std::uint32_t row) const {
    const auto has = [&](const auto& part) {
      return row >= part.rows.first && row <= part.rows.last;
    };
    return std::any_of(old_.passes.begin(), old_.passes.end(), has) ||
           std::any_of(old_.rounds_before.begin(), old_.rounds_before.end(), has) ||
           std::any_of(old_.rounds_behind.begin(), old_.rounds_behind.end(), has);
  }

  // From lines to rounds, from round to round, as the old way came to row `first`.
  void change(Vec2 start, std::uint32_t first) {
    const OldChange old = before(first);
    if (goes_up(old.rows))
      return rows_->go_like({old.rows.front(), old.rows.back()}, old.from, old.to, start);
    if (geometry::length(start - rows_->at()) <= kSamePoint_mm) return;
    const std::uint32_t like = old.rows.empty() ? first : old.rows.front();
    if (is_clear_between(rows_->at(), start)) return rows_->go_straight(start, like);
    rows_->go_over(start, first_old(), last_old());
  }

  void look_for_rest(const VisitRows& rows, NewRows& made) const {
    const Region rest = rest_behind(clearing_, ways_of(rows));
    if (rest.is_empty()) return;
    const Region deep =
        contour::intersect(rest, contour::offset(opened(clearing_.region, clearing_.tool_radius),
                                                 -(old_.scallop + kHair_mm)));
    const double area = contour::area(contour::offset(deep, -kSamePoint_mm));
    made.stays = rest;
    if (area <= kEmptyArea_mm2) return;
    made.left = left_uncut(area, contour::extents(deep).low);
  }

  // Of the centre at the level, in one piece as long as it stays there.
  [[nodiscard]] std::vector<Contour> ways_of(const VisitRows& rows) const {
    std::vector<Contour> ways;
    Vec3 from = recording_.from(visit_.first);
    for (const PlannedRow& row : rows.rows()) {
      const bool cuts = row.kind == Move::Kind::feed &&
                        std::fabs(row.to.z - layer_.z) <= kSameZ_mm &&
                        std::fabs(from.z - layer_.z) <= kSameZ_mm;
      if (cuts) add_way({from.x, from.y}, row, ways);
      from = row.to;
    }
    return ways;
  }
  static void add_way(Vec2 from, const PlannedRow& row, std::vector<Contour>& ways) {
    std::vector<contour::Edge> edges;
    const Vec2 to{row.to.x, row.to.y};
    if (row.arc) append_edges(from, to, *row.arc, 0, edges);
    if (!row.arc) edges.push_back({from, to, 0, 0});
    Contour way{{}, false};
    for (const contour::Edge& edge : edges) way.vertices.push_back({edge.from, edge.bulge, 0});
    way.vertices.push_back({to, 0, 0});
    if (geometry::length(to - from) > 0 || row.arc) ways.push_back(std::move(way));
  }

  const Recording& recording_;
  const NewLayer& wanted_;
  const Layer& layer_;
  Span visit_;
  OldLines old_;
  double shift_;  // by how much another tool is wider, in radii
  Clearing clearing_;
  double distance_;  // of the passes from the walls
  Region room_;      // for the centre of the tool, in passes
  VisitRows* rows_ = nullptr;
  bool has_begun_ = false;
  std::size_t pass_ = 0;  // how many are cut
};

}  // namespace

tl::expected<NewRows, CannotCut> regenerated_in_lines(const Recording& recording,
                                                      const NewLayer& wanted, Span visit,
                                                      double tool_radius) {
  const Layer& layer = wanted.feature->layers[wanted.layer];
  const Clearing before{.region = region_between(layer.nominal, layer.nominal_islands),
                        .tool_radius = tool_radius};
  auto old = old_lines(recording, layer, visit, before);
  if (!old) return cannot_edit(old.error() + ": IT CAN BE MOVED, DEEPENED OR DELETED");
  return LineWriter(recording, wanted, visit, tool_radius, std::move(*old)).write();
}

}  // namespace kerf::features
