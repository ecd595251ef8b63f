#include "features/rewrite/wall_spiral.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "features/path/tolerance.hpp"
#include "features/rewrite/clearing.hpp"
#include "features/rewrite/visit_rows.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kSameOff_mm = 4e-3;
constexpr double kSameWay = 2e-3;  // sine between a row and its wall
constexpr double kShortestRow_mm = 0.02;
constexpr std::size_t kMostRows = 4000;
constexpr double kMoreRest_mm2 = 0.05;  // than the old way left, and no more

/// Beside which walls of a contour rows run, one behind the other, and how far from them; the one
/// before the first row and the one behind the last row bound these.
struct WallTurns {
  std::size_t first = 0;  ///< wall of the first row; each next row is beside the next wall
  double before = 0;      ///< how far the first row begins from the wall before
  std::vector<double> off{};
  double behind = 0;  ///< how far the last row ends from the next wall
  double growth = 0;  ///< from turn to turn
};

/// A contour's walls, endlessly one behind the other.
class Walls {
 public:
  explicit Walls(Contour contour) : contour_(std::move(contour)) {}

  [[nodiscard]] std::size_t count() const { return contour_.vertices.size(); }
  [[nodiscard]] Edge at(std::size_t i) const { return contour::edge_of(contour_, i % count()); }
  [[nodiscard]] Vec2 way(std::size_t i) const { return geometry::unit(at(i).to - at(i).from); }
  /// How far inside of it a point lies.
  [[nodiscard]] double off(std::size_t i, Vec2 point) const {
    return geometry::cross(way(i), point - at(i).from);
  }
  /// The point that is so far from a wall and from the next one.
  [[nodiscard]] Vec2 corner(std::size_t i, double off, double next_off) const {
    const Vec2 a = way(i);
    const Vec2 b = way(i + 1);
    const Vec2 from = at(i).from + off * Vec2{-a.v, a.u};
    const Vec2 on = at(i + 1).from + next_off * Vec2{-b.v, b.u};
    return from + (geometry::cross(on - from, b) / geometry::cross(a, b)) * a;
  }
  [[nodiscard]] bool are_straight() const {
    if (count() < 3) return false;
    for (std::size_t i = 0; i < count(); ++i) {
      if (at(i).bulge != 0 || std::fabs(geometry::cross(way(i), way(i + 1))) < kSameWay)
        return false;
    }
    return true;
  }

 private:
  Contour contour_;
};

/// The points of a way; it begins at the wall.
using Points = std::vector<Vec2>;

/// The walls that the outer turn of a way runs beside, if there are `count`, so far from it.
Contour walls_round(const Points& points, std::size_t count, double off) {
  Contour turn;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const Vec2 a = geometry::unit(points[i + 1] - points[i]);
    const Vec2 b = geometry::unit(points[next + 1] - points[next]);
    if (std::fabs(geometry::cross(a, b)) < kSameWay) return {};
    const Vec2 from = points[i] + off * Vec2{a.v, -a.u};
    const Vec2 on = points[next] + off * Vec2{b.v, -b.u};
    turn.vertices.push_back({from + (geometry::cross(on - from, b) / geometry::cross(a, b)) * a});
  }
  return normal_form(turn);
}

double turning_of(const Points& points) {
  double turn = 0;
  for (std::size_t i = 2; i < points.size(); ++i)
    turn += geometry::cross(points[i - 1] - points[i - 2], points[i] - points[i - 1]);
  return turn;
}

std::optional<WallTurns> turns_beside(const Points& points, const Walls& walls, std::size_t first) {
  WallTurns turns{.first = first};
  const std::size_t count = walls.count();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 way = geometry::unit(points[i + 1] - points[i]);
    const double off = walls.off(first + i, points[i]);
    const bool is_beside = geometry::dot(way, walls.way(first + i)) > 0 &&
                           std::fabs(geometry::cross(way, walls.way(first + i))) <= kSameWay &&
                           std::fabs(walls.off(first + i, points[i + 1]) - off) <= kSameOff_mm;
    if (!is_beside) return std::nullopt;
    turns.off.push_back(off);
  }
  if (turns.off.size() <= count) return std::nullopt;
  turns.growth = turns.off[count] - turns.off[0];
  for (std::size_t i = count; i < turns.off.size(); ++i) {
    const double growth = turns.off[i] - turns.off[i - count];
    if (growth < kSameOff_mm || std::fabs(growth - turns.growth) > 2 * kSameOff_mm)
      return std::nullopt;
  }
  turns.before = walls.off(first + count - 1, points.front());
  turns.behind = walls.off(first + points.size() - 1, points.back());
  return turns;
}

/// The way of turns along other walls, in as many rows or as many as find room.
Points way_of(const WallTurns& turns, const Walls& walls, bool fills_room) {
  const std::size_t count = walls.count();
  std::vector<double> off = turns.off;
  const auto off_at = [&](std::size_t i) {
    while (off.size() <= i) off.push_back(off[off.size() - count] + turns.growth);
    return off[i];
  };
  Points points{walls.corner(turns.first + count - 1, turns.before, off_at(0))};
  const std::size_t most = fills_room ? kMostRows : turns.off.size();
  for (std::size_t i = 0; i < most; ++i) {
    const bool is_last = !fills_room && i + 1 == most;
    const double next = is_last ? turns.behind : off_at(i + 1);
    const Vec2 to = walls.corner(turns.first + i, off_at(i), next);
    if (geometry::dot(to - points.back(), walls.way(turns.first + i)) < kShortestRow_mm) break;
    points.push_back(to);
  }
  return points;
}

class WallSpiralWriter {
 public:
  WallSpiralWriter(const Recording& recording, const NewLayer& wanted, Span visit,
                   double tool_radius)
      : recording_(recording),
        wanted_(wanted),
        layer_(wanted.feature->layers[wanted.layer]),
        visit_(visit),
        tool_radius_(tool_radius),
        clearing_{.region = region_between(wanted.outer, wanted.islands),
                  .tool_radius = wanted.new_radius > 0 ? wanted.new_radius : tool_radius},
        shift_(clearing_.tool_radius - tool_radius) {}

  [[nodiscard]] tl::expected<NewRows, CannotCut> write() {
    if (!wanted_.islands.empty() || !layer_.nominal_islands.empty())
      return cannot_edit("A SPIRAL GOES ROUND NO ISLANDS");
    auto turns = read();
    if (!turns) return cannot_edit("THE TURNS OF THIS LAYER DO NOT ALL RUN BESIDE A WALL");
    const Walls now(is_clockwise_ ? mirrored(wanted_.outer) : wanted_.outer);
    if (!now.are_straight() || now.count() != count_)
      return cannot_edit("A SPIRAL ALONG STRAIGHT WALLS KEEPS THEIR NUMBER");
    for (double& off : turns->off) off += shift_;
    turns->before += shift_;
    turns->behind += shift_;
    NewRows made = rows_of(way_of(*turns, now, false));
    const bool is_short = rows_in(made) < turns->off.size();
    if (made.left || is_short) made = rows_of(way_of(*turns, now, true));
    if (leaves_walls_) return cannot_edit("THE SPIRAL WOULD FALL APART BETWEEN THESE WALLS");
    if (made.left && !wanted_.allows_rest) return tl::unexpected(*made.left);
    return made;
  }

 private:
  [[nodiscard]] std::optional<WallTurns> read() {
    Points points;
    for (std::uint32_t row = visit_.first; row <= visit_.last; ++row) {
      if (!cuts_across_at(recording_, row, layer_.z)) continue;
      if (recording_.moves[row].shape != Move::Shape::line) return std::nullopt;
      if (points.empty()) {
        first_ = row;
        points.push_back(recording_.flat_from(row));
      } else if (row != last_ + 1) {
        return std::nullopt;
      }
      last_ = row;
      points.push_back(recording_.flat_to(row));
    }
    if (points.size() < 3) return std::nullopt;
    is_inside_out_ = contour::distance(layer_.nominal, points.front()) >
                     contour::distance(layer_.nominal, points.back());
    if (is_inside_out_) std::reverse(points.begin(), points.end());
    is_clockwise_ = turning_of(points) < 0;
    for (Vec2& point : points) point = seen(point);
    for (count_ = 3; count_ + 2 < points.size(); ++count_) {
      if (auto turns = beside(points)) return turns;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<WallTurns> beside(const Points& points) {
    const Contour contour = walls_round(points, count_, tool_radius_);
    const Walls walls(contour);
    if (walls.count() != count_ || !walls.are_straight()) return std::nullopt;
    for (std::size_t first = 0; first < count_; ++first) {
      auto turns = turns_beside(points, walls, first);
      if (!turns) continue;
      rest_before_ = rest_of(contour, points);
      return turns;
    }
    return std::nullopt;
  }
  [[nodiscard]] double rest_of(const Contour& walls, const Points& points) const {
    Contour way{{}, false};
    for (const Vec2& point : points) way.vertices.push_back({point, 0, 0});
    const Clearing old{.region = contour::region_of(walls), .tool_radius = tool_radius_};
    return contour::area(rest_behind(old, {way}));
  }
  [[nodiscard]] static Contour mirrored(const Contour& contour) {
    Contour made = contour::reversed(contour);
    for (contour::Vertex& vertex : made.vertices) vertex.point.u = -vertex.point.u;
    return normal_form(made);
  }
  [[nodiscard]] Vec2 seen(Vec2 point) const {
    return is_clockwise_ ? Vec2{-point.u, point.v} : point;
  }

  [[nodiscard]] std::size_t rows_in(const NewRows& made) const {
    return static_cast<std::size_t>(std::count_if(
               made.stretch.becomes.begin(), made.stretch.becomes.end(),
               [&](const PlannedRow& row) {
                 return row.kind == Move::Kind::feed && std::fabs(row.to.z - layer_.z) <= kSameZ_mm;
               })) -
           1;  // the entry comes down to it
  }

  [[nodiscard]] NewRows rows_of(Points points) {
    for (Vec2& point : points) point = seen(point);
    if (is_inside_out_) std::reverse(points.begin(), points.end());
    VisitRows rows(recording_, visit_, layer_.z);
    rows.approach(first_, points.front());
    Contour way{{}, false};
    const std::uint32_t old_rows = last_ - first_ + 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
      way.vertices.push_back({points[i], 0, 0});
      const auto place = std::min<std::uint32_t>(static_cast<std::uint32_t>(i), old_rows);
      if (i > 0) rows.go_straight(points[i], first_ + place - 1);
    }
    rows.retract(last_);
    NewRows made;
    const contour::Region swept =
        contour::sweep_of_disc(way, clearing_.tool_radius - kSamePoint_mm);
    leaves_walls_ = contour::area(contour::subtract(swept, clearing_.region)) > kEmptyArea_mm2;
    const contour::Region rest = rest_behind(clearing_, {way});
    made.stays = rest;
    if (contour::area(rest) > rest_before_ + kMoreRest_mm2)
      made.left = left_uncut(contour::area(rest), contour::extents(rest).low);
    made.stretch = rows.done();
    return made;
  }

  const Recording& recording_;
  const NewLayer& wanted_;
  const Layer& layer_;
  Span visit_;
  double tool_radius_;
  Clearing clearing_;
  double shift_;            // by how much another tool is wider, in radii
  std::size_t count_ = 0;   // of walls
  double rest_before_ = 0;  // what the old way left between its first row and its wall
  bool is_inside_out_ = false;
  bool is_clockwise_ = false;
  bool leaves_walls_ = false;
  std::uint32_t first_ = 0;  // rows at the level
  std::uint32_t last_ = 0;
};

}  // namespace

tl::expected<NewRows, CannotCut> regenerated_along_walls(const Recording& recording,
                                                         const NewLayer& wanted, Span visit,
                                                         double tool_radius) {
  return WallSpiralWriter(recording, wanted, visit, tool_radius).write();
}

}  // namespace kerf::features
