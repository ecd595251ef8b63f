#include "features/milling/smooth_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <optional>
#include <vector>

#include "features/milling/wall_row.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kMostRise = 1 + 2e-3;  // of a bulge: half a circle of rounded words
constexpr double kLongestBump_mm = 2;

bool are_one_circle(const Edge& a, const Edge& b) {
  return a.bulge != 0 && b.bulge != 0 && (a.bulge > 0) == (b.bulge > 0) &&
         std::fabs(contour::radius(a) - contour::radius(b)) <= kBeside_mm &&
         geometry::length(contour::centre(a) - contour::centre(b)) <= kBeside_mm;
}

Vec2 onto_curve(const Edge& edge, Vec2 point) {
  if (edge.bulge == 0) {
    const Vec2 way = geometry::unit(edge.to - edge.from);
    return edge.from + geometry::dot(way, point - edge.from) * way;
  }
  const Vec2 centre = contour::centre(edge);
  return centre + contour::radius(edge) * geometry::unit(point - centre);
}

/// The same line or circle from one point to another; an arc at least as far round as it was.
Edge along_curve(const Edge& edge, Vec2 from, Vec2 to) {
  constexpr double kTurn_rad = 2 * std::numbers::pi;
  constexpr double kLess_rad = 0.1;
  Edge part{from, to, 0, edge.owner};
  if (edge.bulge == 0) return part;
  const double sign = edge.bulge > 0 ? 1 : -1;
  const Vec2 a = from - contour::centre(edge);
  const Vec2 b = to - contour::centre(edge);
  double sweep = sign * math::atan2(geometry::cross(a, b), geometry::dot(a, b));
  while (sweep < std::fabs(contour::sweep_rad(edge)) - kLess_rad) sweep += kTurn_rad;
  part.bulge = sign * math::tan(std::min(sweep / 4, std::numbers::pi / 2 - kLess_rad));
  return part;
}

/// An edge of the wall, and the row that has cut it where it goes beside that: not round its end.
struct Piece {
  Edge edge;
  std::optional<WallRow> row;

  [[nodiscard]] double reach() const { return row ? row->length : 0; }
};

class Smoother {
 public:
  Smoother(const Recording& recording, const Contour& wall) {
    for (std::size_t i = 0; i < contour::edge_count(wall); ++i) {
      Piece piece{contour::edge_of(wall, i), {}};
      piece.row = wall_row(recording, piece.edge.owner);
      if (piece.row && !is_side_of(*piece.row, piece.edge)) piece.row.reset();
      add(std::move(piece));
    }
    join_ends();
  }

  [[nodiscard]] Contour done() const {
    Contour wall;
    for (const Piece& piece : pieces_)
      wall.vertices.push_back({piece.edge.from, piece.edge.bulge, piece.edge.owner});
    return wall;
  }

 private:
  static bool takes(const Piece& wall, const Piece& other) {
    if (are_one_circle(wall.edge, other.edge))
      return contour::length(wall.edge) >= contour::length(other.edge);
    return wall.row && wall.row->length >= other.reach() && is_beside(*wall.row, other.edge);
  }

  // An arc of more than half a circle would be another edge.
  static bool is_short(const Edge& edge) { return std::fabs(edge.bulge) <= kMostRise; }

  bool take_behind(Piece& wall, const Piece& next) {
    if (!takes(wall, next)) return false;
    const Edge longer = along_curve(wall.edge, wall.edge.from, onto_curve(wall.edge, next.edge.to));
    if (!is_short(longer)) return false;
    wall.edge = longer;
    return true;
  }
  bool take_before(Piece& wall, const Piece& last) {
    if (!takes(wall, last)) return false;
    const Edge longer = along_curve(wall.edge, onto_curve(wall.edge, last.edge.from), wall.edge.to);
    if (!is_short(longer)) return false;
    wall.edge = longer;
    return true;
  }

  void add(Piece piece) {
    if (!pieces_.empty() && take_behind(pieces_.back(), piece)) return;
    while (!pieces_.empty() && take_before(piece, pieces_.back())) pieces_.pop_back();
    if (pieces_.size() > 1 && is_bump(pieces_[pieces_.size() - 2], pieces_.back(), piece)) {
      pieces_.pop_back();
      bridge(pieces_.back(), piece);
    } else if (!pieces_.empty()) {
      meet(pieces_.back(), piece);
    }
    pieces_.push_back(std::move(piece));
  }

  // The round end of a pass where two walls touch each other lies on the one, then on the other.
  static bool is_bump(const Piece& last, const Piece& bump, const Piece& next) {
    if (bump.row || contour::length(bump.edge) > kLongestBump_mm) return false;
    const std::array<Vec2, 3> points{bump.edge.from, contour::point_at(bump.edge, 0.5),
                                     bump.edge.to};
    return std::all_of(points.begin(), points.end(),
                       [&](Vec2 point) { return lies_on(last, point) || lies_on(next, point); });
  }
  static bool lies_on(const Piece& wall, Vec2 point) {
    if (wall.row) return is_beside(*wall.row, point);
    return wall.edge.bulge != 0 && std::fabs(geometry::length(point - contour::centre(wall.edge)) -
                                             contour::radius(wall.edge)) <= kBeside_mm;
  }
  // The one with a row goes on to where the other begins.
  static void bridge(Piece& last, Piece& next) {
    if (last.row) {
      const Vec2 at = onto_curve(last.edge, next.edge.from);
      last.edge = along_curve(last.edge, last.edge.from, at);
      next.edge = along_curve(next.edge, at, next.edge.to);
    } else {
      const Vec2 at = onto_curve(next.edge, last.edge.to);
      next.edge = along_curve(next.edge, at, next.edge.to);
      last.edge = along_curve(last.edge, last.edge.from, at);
    }
  }

  // They end where the next begins, which may have moved by the tolerance.
  static void meet(Piece& last, Piece& next) {
    if (last.row && !next.row) {
      next.edge.from = last.edge.to;
    } else {
      last.edge.to = next.edge.from;
    }
  }

  void join_ends() {
    while (pieces_.size() > 2) {
      if (take_behind(pieces_.back(), pieces_.front())) {
        pieces_.pop_front();
      } else if (take_before(pieces_.front(), pieces_.back())) {
        pieces_.pop_back();
      } else if (is_bump(pieces_[pieces_.size() - 2], pieces_.back(), pieces_.front())) {
        pieces_.pop_back();
        bridge(pieces_.back(), pieces_.front());
      } else if (is_bump(pieces_.back(), pieces_.front(), pieces_[1])) {
        pieces_.pop_front();
        bridge(pieces_.back(), pieces_.front());
      } else {
        break;
      }
    }
    if (pieces_.size() > 1) meet(pieces_.back(), pieces_.front());
  }

  std::deque<Piece> pieces_;
};

}  // namespace

Contour smooth_wall(const Recording& recording, const Contour& wall) {
  if (!wall.is_closed || wall.vertices.size() < 3) return wall;
  Contour smooth = Smoother(recording, wall).done();
  return smooth.vertices.size() < 2 ? wall : smooth;
}

}  // namespace kerf::features
