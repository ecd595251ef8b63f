#include "stock/compare/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/contour/tolerance.hpp"
#include "math/math.hpp"

namespace kerf::stock::compare {
namespace {

using contour::Edge;
using contour::Vec2;
using geometry::cross;
using geometry::dot;

double square_of(Vec2 v) { return dot(v, v); }

double held_between(double at, double one, double other) {
  return std::clamp(at, std::min(one, other), std::max(one, other));
}

/// Of a circle about 0: on the right or the left of it as `like` is.
double other_leg(double radius, double leg, double like) {
  const double size = std::sqrt(std::max(0.0, radius * radius - leg * leg));
  return like < 0 ? -size : size;
}

/// The ends of an arc and the places between them where its circle turns back, in their order.
std::vector<Vec2> quarters(const Edge& arc, Vec2 middle, double r) {
  const std::array<Vec2, 4> axes{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
  const bool is_left = arc.bulge > 0;
  const double sweep = std::fabs(contour::sweep_rad(arc));
  const Vec2 arm = arc.from - middle;
  std::vector<std::pair<double, Vec2>> inner;
  for (const Vec2 axis : axes) {
    const double turn = math::atan2(cross(arm, axis), dot(arm, axis));
    double ahead = is_left ? turn : -turn;
    if (ahead <= 0) ahead += 2 * std::numbers::pi;
    if (ahead < sweep) inner.emplace_back(ahead, middle + r * axis);
  }
  std::sort(inner.begin(), inner.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Vec2> points{arc.from};
  for (const auto& [ahead, point] : inner) points.push_back(point);
  points.push_back(arc.to);
  return points;
}

/// Of a border with the inside on its left.
Vec2 outwards(Vec2 way) {
  const double size = geometry::length(way);
  return size > 0 ? (-1 / size) * geometry::left_of(way) : Vec2{};
}

void pair_up(std::vector<double>& crossings, std::vector<Stretch>& out) {
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i] < crossings[i + 1]) out.push_back({crossings[i], crossings[i + 1]});
  }
}

}  // namespace

Outline::Outline(const contour::Region& region, OnAxis on_axis) : box_(contour::extents(region)) {
  for (const contour::Contour& loop : region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
      const Edge edge = contour::edge_of(loop, i);
      const bool is_inner = on_axis == OnAxis::is_none && edge.bulge == 0 &&
                            std::max(edge.from.v, edge.to.v) <= contour::kSame_mm;
      if (!is_inner) edges_.push_back(edge);
      add(edge, !is_inner);
    }
  }
  tree_ = NearTree(pieces_.size(), [this](std::size_t i) -> Bounds {
    const Piece& p = pieces_[i];
    return {{std::min(p.from.u, p.to.u), std::min(p.from.v, p.to.v), 0},
            {std::max(p.from.u, p.to.u), std::max(p.from.v, p.to.v), 0}};
  });
}

void Outline::add(const Edge& edge, bool is_surface) {
  Piece piece{edge.from, edge.to, {}, 0, edge.bulge > 0, is_surface, edge.owner};
  if (edge.bulge == 0) return pieces_.push_back(piece);
  piece.centre = contour::centre(edge);
  piece.radius = contour::radius(edge);
  const std::vector<Vec2> points = quarters(edge, piece.centre, piece.radius);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    piece.from = points[i];
    piece.to = points[i + 1];
    pieces_.push_back(piece);
  }
}

std::vector<Outline::Sample> Outline::samples(double spacing_mm) const {
  std::vector<Sample> samples;
  for (const Edge& edge : edges_) {
    const double length = contour::length(edge);
    const double count = std::max(1.0, std::ceil(length / spacing_mm));
    samples.push_back({edge.from, outwards(contour::tangent_at_start(edge)), 0, edge.owner});
    for (double i = 0.5; i < count; ++i) {
      const Vec2 way = contour::tangent_at_end(contour::part(edge, 0, i / count));
      samples.push_back(
          {contour::point_at(edge, i / count), outwards(way), length / count, edge.owner});
    }
  }
  return samples;
}

double Outline::square_from(const Piece& piece, Vec2 place) {
  if (piece.radius == 0) {
    const Vec2 way = piece.to - piece.from;
    const double whole = square_of(way);
    const double share = whole > 0 ? dot(place - piece.from, way) / whole : 0;
    return square_of(place - piece.from - std::clamp(share, 0.0, 1.0) * way);
  }
  const Vec2 arm = place - piece.centre;
  const Vec2 begin = piece.from - piece.centre;
  const Vec2 end = piece.to - piece.centre;
  const double side = piece.turns_left ? 1 : -1;
  if (side * cross(begin, arm) >= 0 && side * cross(arm, end) >= 0) {
    const double off = std::sqrt(square_of(arm)) - piece.radius;
    return off * off;
  }
  return std::min(square_of(place - piece.from), square_of(place - piece.to));
}

Near Outline::near(Vec2 place, Hint& hint) const {
  std::uint32_t nearest = Hint::kNone;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](std::uint32_t number, double& best) {
    if (!pieces_[number].is_surface) return;
    const double far = square_from(pieces_[number], place);
    if (far > best || (far == best && number >= nearest)) return;
    nearest = number;
    best = far;
  };
  if (hint.thing < pieces_.size()) look(hint.thing, least);
  tree_.search({place.u, place.v, 0}, least, look);
  if (nearest == Hint::kNone) return {};
  hint.thing = nearest;
  const double distance = std::sqrt(least);
  return {distance > 0 && holds(place) ? -distance : distance, pieces_[nearest].owner};
}

double Outline::u_at(const Piece& piece, double v) {
  const Vec2 way = piece.to - piece.from;
  if (piece.radius == 0)
    return held_between(piece.from.u + (v - piece.from.v) / way.v * way.u, piece.from.u,
                        piece.to.u);
  const double like = piece.from.u + piece.to.u - 2 * piece.centre.u;
  return held_between(piece.centre.u + other_leg(piece.radius, v - piece.centre.v, like),
                      piece.from.u, piece.to.u);
}

double Outline::v_at(const Piece& piece, double u) {
  const Vec2 way = piece.to - piece.from;
  if (piece.radius == 0)
    return held_between(piece.from.v + (u - piece.from.u) / way.u * way.v, piece.from.v,
                        piece.to.v);
  const double like = piece.from.v + piece.to.v - 2 * piece.centre.v;
  return held_between(piece.centre.v + other_leg(piece.radius, u - piece.centre.u, like),
                      piece.from.v, piece.to.v);
}

// An end on the line counts as before it, so that every loop crosses it an even number of times.
void Outline::along_u(double at, std::vector<Stretch>& out) const {
  std::vector<double> crossings;
  tree_.walk(
      [&](const NearTree::Box& box) {
        return double{box.low[1]} <= at && at <= double{box.high[1]};
      },
      [&](std::uint32_t number) {
        const Piece& piece = pieces_[number];
        if ((piece.from.v <= at) != (piece.to.v <= at)) crossings.push_back(u_at(piece, at));
      });
  pair_up(crossings, out);
}

void Outline::along_v(double at, std::vector<Stretch>& out) const {
  std::vector<double> crossings;
  tree_.walk(
      [&](const NearTree::Box& box) {
        return double{box.low[0]} <= at && at <= double{box.high[0]};
      },
      [&](std::uint32_t number) {
        const Piece& piece = pieces_[number];
        if ((piece.from.u <= at) != (piece.to.u <= at)) crossings.push_back(v_at(piece, at));
      });
  pair_up(crossings, out);
}

bool Outline::holds(Vec2 place) const {
  bool is_in = false;
  tree_.walk(
      [&](const NearTree::Box& box) {
        return double{box.low[1]} <= place.v && place.v <= double{box.high[1]} &&
               place.u <= double{box.high[0]};
      },
      [&](std::uint32_t number) {
        const Piece& piece = pieces_[number];
        const bool crosses = (piece.from.v <= place.v) != (piece.to.v <= place.v);
        if (crosses && u_at(piece, place.v) > place.u) is_in = !is_in;
      });
  return is_in;
}

}  // namespace kerf::stock::compare
